#include "report/tools/katex.hpp"

#include "core/error.hpp"
#include "report/tools/json.hpp"
#include "report/tools/process.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::tools {

namespace {

const Tool& typesetter() {
  static const Tool tool{"node", "nodejs", "set formulas"};
  return tool;
}

Json set(const Json& pages) {
  const std::string answer =
      run(typesetter(), {"-e", templates().at("katex.js")}, Json{{"pages", pages}}.dump(), "/");
  if (!Json::accept(answer)) {
    throw InputOutputError("cannot set formulas: the answer of node is not whole");
  }
  return Json::parse(answer);
}

}  // namespace

void require_katex() {
  require(typesetter());
  (void)set(Json::array());
}

std::vector<File> with_formulas(const std::vector<File>& pages) {
  Json sent = Json::array();
  for (const File& page : pages) {
    sent.push_back({{"name", page.name}, {"content", page.content}});
  }
  const Json answer = set(sent);
  std::vector<File> result;
  for (const Json& page : answer.at("pages")) {
    result.push_back({page.at("name"), page.at("content")});
  }
  result.push_back({"katex.css", answer.at("css")});
  return result;
}

}  // namespace stickslip::report::tools
