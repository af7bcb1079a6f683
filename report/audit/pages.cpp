#include "report/audit/pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <regex>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "numeric/families/family.hpp"
#include "report/audit/json.hpp"
#include "report/audit/page_data.hpp"
#include "report/audit/write_report.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/page.hpp"
#include "report/tools/latex.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::audit {

using namespace numeric;
using namespace proofs::methods;
using namespace orbits;
using namespace tools;

namespace {

void append(std::vector<File>& files, std::vector<File> more) {
  std::ranges::move(more, std::back_inserter(files));
}

// What the partial orbit_list sees.
Json list_data(const Listed& listed, const std::string& anchor, const std::string& heading,
               const std::string& stem, bool drawn) {
  Json data = orbit_data(listed);
  data["anchor"] = anchor;
  data["heading"] = heading;
  data["picture"] = drawn ? Json(stem) : Json(nullptr);
  data["picture_in_words"] = drawn ? picture_in_words(listed.list) : "";
  return data;
}

// NAME.tex, NAME.pdf where there is TeX, and what `pages` makes of the data with their style sheet; the data
// then say whether there is NAME.pdf: made at the same time, and once more should the compilation fail.
template <class Pages>
void add_paper_and_pages(Report& report, const std::string& name, Json data, const Pages& pages) {
  report.files.push_back({name + ".tex", render_file(name + ".tex", data, tex_format)});
  data["pdf"] = can_compile();
  Compiled compiled;
  std::vector<File> made;
  (void)parallel_map(2, [&](std::size_t i) {
    if (i == 0) {
      compiled = compile(report.files, name);
    } else {
      made = pages(data);
    }
    return i;
  });
  if (data.at("pdf") != !compiled.pdf.empty()) {
    data["pdf"] = !compiled.pdf.empty();
    made = pages(data);
  }
  append(report.files, std::move(compiled.pdf));
  append(report.files, std::move(made));
  report.files.push_back({"style.css", templates().at("style.css")});
  if (!compiled.problem.empty()) {
    report.note = fmt::format("{}.pdf is not made: {}.", name, compiled.problem);
  }
}

// How exact numbers are and what they mean, and with what pictures are drawn.
void add_meanings(Json& data, int digits) {
  data["drawn_by"] = drawn_by();
  data["precision"] = fmt::format(
      "identities exactly, in rational arithmetic; values of orbits enclosed to {} significant digits, "
      "rounded outwards, and computed with more bits wherever a verdict needs them",
      digits);
  data["meaning_of_margin"] = meaning_of_margin();
  data["meaning_of_units"] = meaning_of_units();
  data["meaning_of_picture"] = meaning_of_picture();
}

std::string picture_of_list(const ExampleOrbits& e) {
  return "orbits-" + e.example.name;
}
std::string picture_of_figure(const ExampleOrbits& e) {
  return "figure-" + e.example.name;
}

// The list of an example, and the orbit of the figure, with the pictures of both.
Json example_data(const ExampleOrbits& e) {
  Json data = list_data(e.list, e.example.name, e.example.figure, picture_of_list(e), !e.list.orbits.empty());
  data["figure"] = nullptr;
  if (const std::optional<std::size_t> shown = printed_orbit(e)) {
    data["figure"] = {{"picture", picture_of_figure(e)},
                      {"picture_in_words", picture_in_words(e.list, shown)},
                      {"orbit", data.at("orbits").at(*shown)}};
  }
  return data;
}

}  // namespace

Figures figures_of(const Paper& paper, bool with_pictures) {
  Figures figures;
  for (const Example& example : paper.examples) {
    figures.examples.push_back(orbits_of(example));
  }
  const std::size_t drawings = with_pictures ? 2 * figures.examples.size() : 0;
  for (std::vector<File>& some : parallel_map(drawings, [&](std::size_t i) {
         const ExampleOrbits& e = figures.examples[i / 2];
         const std::optional<std::size_t> shown = printed_orbit(e);
         return i % 2 == 0 ? pictures(e.list, picture_of_list(e))
                : shown    ? pictures(e.list, picture_of_figure(e), shown)
                           : std::vector<File>{};
       })) {
    append(figures.pictures, std::move(some));
  }
  return figures;
}

Report pages(const Audited& all, const Figures& figures, const std::optional<proofs::checks::Gate>& gate,
             const Certification& certificates, const std::string& command) {
  const Json json = to_json(all,
                            !command.empty() ? command
                            : gate           ? "stickslip audit --mutants"
                                             : "stickslip audit",
                            figures.examples, gate, certificates);
  Report report{{{"audit.json", to_text(json)}}, {}};
  Json data = page_data(all, json);
  add_meanings(data, OrbitQuestion{}.digits);
  data["examples"] = Json::array();
  for (const ExampleOrbits& e : figures.examples) {
    data["examples"].push_back(example_data(e));
  }
  append(report.files, figures.pictures);
  data["uses"] = uses_of_places(all);
  data["page_title"] = "The orbits of the paper’s figures";
  data["lists"] = data.at("examples");
  add_paper_and_pages(report, "audit", std::move(data), [&](const Json& complete) {
    std::vector<File> made;
    for (const char * name :
         {"index.html", "paper.html", "statements.html", "assumptions.html", "orbits.html"}) {
      if (name != std::string("orbits.html") || !figures.examples.empty()) {
        made.push_back({name, render_file(name, complete, html_format)});
      }
    }
    return with_formulas(made);
  });
  report.files.push_back({"filter.js", templates().at("filter.js")});
  return report;
}

std::string write_report(const Paper& paper, const proofs::methods::Audit& audit,
                         const std::filesystem::path& directory, const std::string& command) {
  require_writable(directory);
  require_page_tools();
  const Report made = pages({paper, audit}, figures_of(paper, true), {}, {}, command);
  write_files(directory, made.files);
  return made.note;
}

std::string errata(const Audited& all) {
  Json data = page_data(all, to_json(all, "stickslip latex --errata", {}));
  data["text_read"] = all.paper.bibliography.text;
  return render_file("errata.tex", data, tex_format);
}

std::string theorem(const Audited& all, const std::string& id) {
  const Json data = page_data(all, to_json(all, "stickslip latex --theorem " + id));
  for (Json one : data.at("results")) {
    if (one.at("id") == id) {
      // The paper's primes, not the dots of other pages, as in the sentence.
      static const std::regex rate(R"(\\dot ([a-z]_(?:\{[^}]*\}|.)))");
      one["displays"] = Json::array();
      for (const Json& formula : one.at("formulas")) {
        one["displays"].push_back(
            displayed(std::regex_replace(formula.at("latex").get<std::string>(), rate, "$1'")));
      }
      one["paper"] = data.at("paper");
      return render_file("theorem.tex", one, tex_format);
    }
  }
  throw InternalError("the claims of the result " + id + " are not all decided");
}

Report pages(const Listed& listed) {
  const OrbitList& list = listed.list;
  const Json json = listed.word ? orbits::to_json(*listed.word) : orbits::to_json(list);
  Report report{{{"orbits.json", to_text(json)}}, {}};
  Json data = provenance(listed.command);
  add_meanings(data, list.question.digits);
  std::vector<File> drawn = pictures(list, "figure");
  data["lists"] = Json::array();
  data["lists"].push_back(list_data(listed, "orbits", "Orbits", "figure", !drawn.empty()));
  append(report.files, std::move(drawn));
  data["page_title"] = fmt::format("Orbits: {}", list.question.family->name);
  data["paper"] = nullptr;
  add_paper_and_pages(report, "orbits", std::move(data), [](const Json& complete) {
    return with_formulas({{"index.html", render_file("orbits.html", complete, html_format)}});
  });
  return report;
}

}  // namespace stickslip::report::audit
