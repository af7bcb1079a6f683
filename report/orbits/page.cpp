#include "report/orbits/page.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "report/orbits/pictures.hpp"
#include "report/tools/katex.hpp"
#include "report/tools/prose.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace tools;

Json rows_data(const std::vector<Row>& rows) {
  return list_of(rows, [](const Row& row) {
    const bool data = row[0].text == "parameters";
    return Json{{"label", row[0].text}, {"text", data ? in_greek(row[1].text) : row[1].text}};
  });
}

Json table(const char * anchor, const char * heading, const std::vector<Row>& rows) {
  return {{"anchor", anchor}, {"heading", heading}, {"rows", rows_data(rows)}};
}

Json page_data(const PageFrame& frame, const std::string& title, const std::string& command,
               const std::string& precision) {
  Json data = provenance(command);
  data["page_title"] = title;
  data["drawn_by"] = drawn_by();
  data["precision"] = precision;
  data["tables"] = Json::array();
  if (frame.machine) {
    data["tables"].push_back(table("machine", "Machine", machine_rows(*frame.machine)));
  }
  return data;
}

File json_file(const std::string& name, Json json, const PageFrame& frame) {
  if (frame.machine) {
    json["machine"] = to_json(*frame.machine);
  }
  return {name, to_text(json)};
}

std::vector<File> with_page(const std::string& page, const Json& data, std::vector<File> files) {
  std::vector<File> all = with_formulas({{"index.html", render_file(page, data, html_format)}});
  all.push_back({"style.css", templates().at("style.css")});
  std::ranges::move(files, std::back_inserter(all));
  return all;
}

}  // namespace stickslip::report::orbits
