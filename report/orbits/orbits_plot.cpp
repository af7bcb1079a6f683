#include "report/orbits/orbits_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "report/orbits/orbit_words.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::families;
using namespace numeric::motion;
using namespace tools;

namespace {

constexpr int samples = 240;  // per phase
constexpr double pixels_per_inch = 96;

// In pixels of the SVG: the width of the picture, the height of a panel, and the rows of an orbit's panels.
struct Page {
  int width;
  int panel_height;
  int rows;
};
constexpr Page wide_page{1000, 380, 2};
constexpr Page narrow_page{480, 340, 4};

// As in the paper's pictures: the overshoot heaviest, the stick thin.
constexpr std::array<double, 3> line_widths{2.5, 5, 1};

// Lines "t q1 q2 q1' q2'", q = z or x.
std::string table(const MotionOf<double>& motion, const PhaseOf<double>& phase,
                  const model::Vector2<double>& d) {
  std::string text;
  for (int i = 0; i <= samples; ++i) {
    const double t = phase.duration * i / samples;
    const model::Vector4<double> Z = flow<double>(motion.oscillator, phase.kind, phase.load, phase.Z, t);
    text += fmt::format("{:.8g} {:.8g} {:.8g} {:.8g} {:.8g}\n", phase.start + t, Z(0) + d(0), Z(1) + d(1),
                        Z(2), Z(3));
  }
  return text;
}

Json phases_of(const MotionOf<double>& motion, const Family& family, std::size_t orbit) {
  const bool absolute = !has_stick(family);
  const model::Vector2<double> shift = absolute ? motion.oscillator.d0 : model::Vector2<double>(0, 0);
  Json phases = Json::array();
  for (std::size_t k = 0; k < motion.phases.size(); ++k) {
    const PhaseOf<double>& phase = motion.phases[k];
    phases.push_back({{"block", fmt::format("$orbit{}phase{}", orbit, k)},
                      {"kind", to_string(phase.kind)},
                      {"width", fmt::format("{}", line_widths.at(static_cast<std::size_t>(phase.kind)))},
                      {"colour", colour_of(phase.kind)},
                      {"start", fmt::format("{:.8g}", phase.start)},
                      {"middle", fmt::format("{:.8g}", phase.start + phase.duration / 2)},
                      {"first", k == 0},
                      {"table", table(motion, phase, shift)}});
  }
  return phases;
}

std::string parameter_text(const OrbitQuestion& question) {
  std::string text;
  for (const NamedRange& parameter : named_parameters(question)) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", parameter.name, notation(parameter.range));
  }
  return text;
}

std::string tell(const Orbit& orbit) {
  return orbit.admissible.truth == Truth::proved    ? "admissible"
         : orbit.admissible.truth == Truth::refuted ? "not admissible"
                                                    : "undecided";
}

Json orbit_data(const OrbitList& list, std::size_t i) {
  const Orbit& orbit = list.orbits[i];
  const MotionOf<double> motion = in_double(orbit.motion);
  const PhaseOf<double>& last = motion.phases.back();
  return {{"title", fmt::format("{} orbit {} of {}, {}", list.question.family->name, i + 1,
                                list.orbits.size(), tell(orbit))},
          {"q", has_stick(*list.question.family) ? "z" : "x"},
          {"period", fmt::format("{:.8g}", last.start + last.duration)},
          {"V", fmt::format("{:.8g}", motion.oscillator.data.V)},
          {"phases", phases_of(motion, *list.question.family, i + 1)}};
}

}  // namespace

std::string plot_script(const OrbitList& list, PlotFormat format, PlotShape shape,
                        std::optional<std::size_t> only) {
  const bool any_admissible = std::any_of(list.orbits.begin(), list.orbits.end(), [](const Orbit& orbit) {
    return orbit.admissible.truth == Truth::proved;
  });
  Json orbits = Json::array();
  for (std::size_t i = 0; i < list.orbits.size(); ++i) {
    const bool wanted = !any_admissible || list.orbits[i].admissible.truth == Truth::proved;
    if (only ? i == *only : wanted) {
      orbits.push_back(orbit_data(list, i));
    }
  }
  if (orbits.empty()) {
    return "";
  }
  const Page page = shape == PlotShape::wide ? wide_page : narrow_page;
  const std::size_t rows = orbits.size() * static_cast<std::size_t>(page.rows);
  const int height = page.panel_height * static_cast<int>(rows);
  const Json data = {{"svg", format == PlotFormat::svg},
                     {"pdf", format == PlotFormat::pdf},
                     {"width", std::to_string(page.width)},
                     {"height", std::to_string(height)},
                     {"inches_wide", fmt::format("{:.2f}", page.width / pixels_per_inch)},
                     {"inches", fmt::format("{:.2f}", height / pixels_per_inch)},
                     {"rows", std::to_string(rows)},
                     {"columns", std::to_string(4 / page.rows)},
                     {"narrow", shape == PlotShape::narrow},
                     {"parameters", parameter_text(list.question)},
                     {"orbits", orbits}};
  return render_file("orbits.gp", data, plain_format);
}

}  // namespace stickslip::report::orbits
