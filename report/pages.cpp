#include "report/pages.hpp"

#include <fmt/format.h>

#include "report/graph.hpp"
#include "report/json.hpp"
#include "report/katex.hpp"
#include "report/latex.hpp"
#include "report/orbit_data.hpp"
#include "report/orbit_words.hpp"
#include "report/orbits.hpp"
#include "report/page_data.hpp"
#include "report/pictures.hpp"
#include "report/templates.hpp"

namespace stickslip::report {
namespace {

void append(std::vector<File>& files, std::vector<File> more) {
  for (File& file : more) {
    files.push_back(std::move(file));
  }
}

void add_provenance(Json& data, bool with_graph) {
  data["drawn_by"] = Json::array();
  for (const Component& component : drawn_by(with_graph)) {
    data["drawn_by"].push_back({{"name", component.name}, {"version", component.version}});
  }
}

// What the partial orbit_list sees.
Json list_data(const OrbitList& list, const std::string& anchor, const std::string& heading,
               const std::string& stem, bool drawn) {
  Json data = orbit_data(list);
  data["anchor"] = anchor;
  data["heading"] = heading;
  data["picture"] = drawn ? Json(stem) : Json(nullptr);
  return data;
}

// NAME.tex, and NAME.pdf where there is TeX.
void add_paper(Report& report, const std::string& name, const std::string& tex_template, Json& data) {
  report.files.push_back({name + ".tex", render_file(tex_template, data, tex_format)});
  Compiled compiled = compile(report.files, name);
  data["pdf"] = !compiled.pdf.empty();
  append(report.files, std::move(compiled.pdf));
  if (!compiled.problem.empty()) {
    report.note = fmt::format("{}.pdf is not made: {}.", name, compiled.problem);
  }
}

void add_style(std::vector<File>& files) {
  files.push_back({"style.css", read_file(template_directory() / "style.css")});
}

std::string digits_in_words(int digits) {
  return fmt::format(
      "identities exactly, in rational arithmetic; values of orbits enclosed to {} significant digits, "
      "rounded "
      "outwards, and computed with more bits wherever a verdict needs them",
      digits);
}

// The list of an example, its picture, and the orbit of the figure with a picture of its own.
Json example_data(const ExampleOrbits& e, std::vector<File>& files) {
  const std::string stem = "orbits-" + e.example.name;
  std::vector<File> all = pictures(e.list, stem);
  Json data = list_data(e.list, e.example.name, e.example.figure, stem, !all.empty());
  append(files, std::move(all));
  data["figure"] = nullptr;
  if (const std::optional<std::size_t> shown = printed_orbit(e)) {
    const std::string figure = "figure-" + e.example.name;
    data["figure"] = {{"picture", figure}, {"orbit", data.at("orbits").at(*shown)}};
    append(files, pictures(e.list, figure, shown));
  }
  return data;
}

}  // namespace

Report pages(const proofs::Audit& audit, const std::vector<ExampleOrbits>& examples) {
  const Json json = to_json(audit, "stickslip audit", examples);
  Report report{{{"audit.json", to_text(json)}}, {}};
  Json data = page_data(audit, json);
  add_provenance(data, true);
  data["precision"] = digits_in_words(OrbitQuestion{}.digits);
  data["meaning_of_margin"] = meaning_of_margin();
  data["examples"] = Json::array();
  for (const ExampleOrbits& e : examples) {
    data["examples"].push_back(example_data(e, report.files));
  }
  add_paper(report, "audit", "audit.tex", data);
  data["graph"] = graph_svg(audit);
  data["page_title"] = "The orbits of the paper’s figures";
  data["lists"] = data.at("examples");
  append(report.files, with_formulas({{"index.html", render_file("index.html", data, html_format)},
                                      {"statements.html", render_file("statements.html", data, html_format)},
                                      {"orbits.html", render_file("orbits.html", data, html_format)}}));
  add_style(report.files);
  return report;
}

std::string errata(const proofs::Audit& audit) {
  Json data = page_data(audit, to_json(audit, "stickslip latex --errata", {}));
  return render_file("errata.tex", data, tex_format);
}

Report pages(const OrbitList& list) {
  const Json json = to_json(list);
  Report report{{{"orbits.json", to_text(json)}}, {}};
  Json data = provenance(command_of(list.question));
  add_provenance(data, false);
  data["precision"] = digits_in_words(list.question.digits);
  std::vector<File> drawn = pictures(list, "figure");
  data["lists"] = Json::array();
  data["lists"].push_back(list_data(list, "orbits", "Orbits", "figure", !drawn.empty()));
  append(report.files, std::move(drawn));
  data["page_title"] = fmt::format("Orbits: {}", name_of(list.question.family));
  data["paper"] = nullptr;
  data["meaning_of_margin"] = meaning_of_margin();
  add_paper(report, "orbits", "orbits.tex", data);
  append(report.files, with_formulas({{"index.html", render_file("orbits.html", data, html_format)}}));
  add_style(report.files);
  return report;
}

}  // namespace stickslip::report
