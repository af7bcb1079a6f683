#include "report/orbits/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/parallel.hpp"
#include "numeric/families/family.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/latex.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/plot.hpp"
#include "report/tools/prose.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace tools;
using namespace numeric;
using namespace numeric::motion;

Json cells(const std::vector<Row>& rows, const std::vector<std::string>& names) {
  return list_of(rows, [&](const Row& row) {
    Json data;
    for (std::size_t k = 0; k < names.size(); ++k) {
      data[names[k]] = row[k].text;
    }
    return data;
  });
}

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

namespace {

// cairo dates every PDF, and no setting of it leaves that out; spaces in its place keep all offsets.
std::string undated(std::string pdf) {
  const std::string key = "/CreationDate (";
  for (std::size_t start = pdf.find(key); start != std::string::npos; start = pdf.find(key, start)) {
    const std::size_t end = pdf.find(')', start) + 1;
    pdf.replace(start, end - start, end - start, ' ');
  }
  return pdf;
}

constexpr int short_digits = 15;
constexpr int multiplier_digits = 8;

std::string latex_of(const Range& range) {
  std::string text = notation(range);
  const std::size_t sign = text.find("+-");
  return sign == std::string::npos ? text : text.replace(sign, 2, "\\pm ");
}

Json value(const NamedBall& named, int digits) {
  const BallText text = to_text(named.value, known_digits(named.value, digits));
  return {{"latex", latex_of_value(named.name)},
          {"mid", text.mid},
          {"rad", text.rad},
          {"unit", unit_of(named.name)},
          {"short", to_string(named.value, known_digits(named.value, std::min(digits, short_digits)))}};
}

Json condition(const Condition& c) {
  return {{"id", c.id},
          {"statement", c.statement},
          {"verdict", to_string(c.verdict.truth)},
          {"verdict_words", spaced(to_string(c.verdict.truth))},
          {"margin", shown(c.margin)},
          {"at", shown(c.at)},
          {"reason_if_open", c.verdict.is_decided() ? Json(nullptr) : Json(c.verdict.reason)}};
}

void add_stability(Json& json, const std::optional<Stability>& stability) {
  json["stability"] = nullptr;
  json["multipliers"] = Json::array();
  if (stability) {
    json["stability"] = {{"kind", to_string(stability->kind)}, {"reason", stability->reason}};
    json["multipliers"] = list_of(stability->multipliers,
                                  [](const ComplexBall& mu) { return complex_text(mu, multiplier_digits); });
  }
}

// Of a word also how long its first phases last, t1, t2, ...
std::vector<NamedBall> values_of(const Listed& listed, const Orbit& o) {
  constexpr std::size_t most_phases = 16;
  std::vector<NamedBall> values;
  for (std::size_t k = 0; listed.word && k < std::min(o.motion.phases.size(), most_phases); ++k) {
    values.push_back({fmt::format("t{}", k + 1), o.motion.phases[k].duration});
  }
  values.insert(values.end(), o.values.begin(), o.values.end());
  return values;
}

Json orbit(const Listed& listed, std::size_t i) {
  const OrbitList& list = listed.list;
  const Orbit& o = list.orbits[i];
  Json json = {
      {"number", i + 1},
      {"total", list.orbits.size()},
      {"verdict", to_string(o.admissible.truth)},
      {"tell", verdict_on(o)},
      {"split", o.split.empty() ? Json(nullptr) : Json(o.split)},
      {"split_latex", latex_of_value(o.split)},
      {"values", list_of(values_of(listed, o),
                         [&](const NamedBall& named) { return value(named, list.question.digits); })},
      {"conditions", list_of(o.conditions, condition)},
      {"recovers", nullptr}};
  if (o.neighbourhood) {
    const auto ur = ur_of_neighbourhood(list.question, o);
    json["recovers"] = neighbourhood_in_words(*o.neighbourhood, coordinates_in(Units())) +
                       (ur ? "; " + ur_in_words(*ur) : "");
  }
  add_stability(json, o.stability);
  return json;
}

Json unresolved(const Unresolved& part) {
  const auto value = [](const NamedBall& named) -> Json {
    return {{"latex", latex_of_value(named.name)}, {"value", to_string(named.value, 8)}};
  };
  return {{"where", list_of(part.where, value)}, {"reason", part.reason}};
}

// For screens alone.
std::vector<File> screen_pictures(const ScriptOf& script, const std::string& stem) {
  const std::string wide = script(PlotFormat::svg, PlotShape::wide);
  if (wide.empty()) {
    return {};
  }
  return {{stem + ".svg", gnuplot(wide)},
          {stem + "-narrow.svg", gnuplot(script(PlotFormat::svg, PlotShape::narrow))}};
}

}  // namespace

std::vector<File> pictures(const ScriptOf& script, const std::string& stem) {
  std::vector<File> files = screen_pictures(script, stem);
  if (!files.empty()) {
    files.push_back({stem + ".pdf", undated(gnuplot(script(PlotFormat::pdf, PlotShape::wide)))});
  }
  return files;
}

std::vector<File> pictures(const OrbitList& list, const std::string& stem, std::optional<std::size_t> only) {
  return pictures([&](PlotFormat format, PlotShape shape) { return plot_script(list, format, shape, only); },
                  stem);
}

void require_page_tools() {
  require_katex();
  require_gnuplot();
}

Json drawn_by() {
  return {{{"name", "gnuplot"}, {"version", gnuplot_version()}}};
}

Json orbit_data(const Listed& listed) {
  const OrbitList& list = listed.list;
  const auto parameter = [](const auto& one) -> Json {
    return {{"latex", latex_of_value(one.first)}, {"value_latex", latex_of(one.second)}};
  };
  Json json = {
      {"title", listed.title + (listed.word ? "; $t1$, $t2$, ... is how long each phase lasts" : "")},
      {"searched", listed.searched},
      {"result", listed.result},
      {"command", listed.command},
      {"parameters", list_of(named_parameters(list.question), parameter)},
      {"remarks", list_of(list.remarks, describe)},
      {"unresolved", list_of(list.unresolved, unresolved)},
      {"orbits", Json::array()}};
  if (const std::string on_ur = remark_on_ur(list); !on_ur.empty()) {
    json["remarks"].push_back(on_ur);
  }
  for (std::size_t i = 0; i < list.orbits.size(); ++i) {
    json["orbits"].push_back(orbit(listed, i));
  }
  return json;
}

Json page_on_motions(const PageFrame& frame, const std::string& title, const std::string& command, int digits,
                     const std::string& of_period, const std::string& pictures) {
  Json data = page_data(
      frame, title, command,
      fmt::format(
          "motions are followed in floating point; periodic ones are then proved in balls, their values "
          "enclosed to {} significant digits, and computed with more bits wherever a verdict needs them",
          digits));
  data["attractors"] = Json::array();
  data["of_period"] = of_period;
  data["pictures"] = pictures;
  data["along"] = nullptr;
  data["basins"] = nullptr;
  data["data_file"] = "";
  return data;
}

void add_motions(Json& data, std::vector<File>& files, std::size_t count,
                 const std::function<MotionOnPage(std::size_t)>& of) {
  struct Drawn {
    Json data;
    std::vector<File> pictures;
  };
  for (Drawn& one : parallel_map(count, [&](std::size_t i) {
         const MotionOnPage motion = of(i);
         Drawn result{{{"number", i + 1},
                       {"name", motion.name},
                       {"tone", motion.tone},
                       {"tell", motion.tell},
                       {"rows", rows_data(motion.rows)},
                       {"picture", nullptr},
                       {"picture_in_words", ""}},
                      {}};
         if (motion.portrait) {
           const std::string stem = fmt::format("portrait-{}", i + 1);
           result.data["picture"] = stem;
           result.data["picture_in_words"] = picture_in_words(*motion.portrait, motion.labels);
           result.pictures = screen_pictures(
               [&](PlotFormat format, PlotShape shape) {
                 return plot_script(*motion.portrait, format, shape, motion.labels);
               },
               stem);
         }
         return result;
       })) {
    data["attractors"].push_back(std::move(one.data));
    std::ranges::move(one.pictures, std::back_inserter(files));
  }
}

Row row_of_starts(const numeric::attractors::Ending& a) {
  return {{"starts"},
          {fmt::format("{}: {:.1f} %, within {:.1f} and {:.1f} %", a.count, 100 * a.share, 100 * a.least,
                       100 * a.most)}};
}

}  // namespace stickslip::report::orbits
