#include "report/tools/graphviz.hpp"

#include "report/tools/process.hpp"

namespace stickslip::report::tools {
namespace {

const Tool& drawer() {
  static const Tool tool{"dot", "graphviz", "draw the graph of claims"};
  return tool;
}

}  // namespace

void require_graphviz() {
  require(drawer());
}

std::string graphviz_version() {
  const std::string text = run(drawer(), {"-Tsvg"}, "graph {}");
  const std::string key = "graphviz version ";  // in a comment of every picture
  const std::size_t start = text.find(key);
  return start == std::string::npos ? "" : version_in(text.substr(start));
}

std::string graphviz_svg(const std::string& script) {
  const std::string document = run(drawer(), {"-Tsvg"}, script);
  return document.substr(document.find("<svg"));
}

}  // namespace stickslip::report::tools
