#include "report/orbits/orbits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "numeric/families/family.hpp"
#include "report/orbits/attractors/portraits.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/prose.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::families;
using namespace numeric::motion;
using namespace tools;

namespace {

constexpr int samples = 240;         // per phase
constexpr double arrow_pixels = 15;  // the length of a head: wider than the heaviest line

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

// z + shift; z' at the time since the phase began.
model::Vector4<double> state(const MotionOf<double>& motion, const PhaseOf<double>& phase,
                             const model::Vector2<double>& shift, double t) {
  model::Vector4<double> Z = flow<double>(motion.oscillator, phase.kind, phase.load, phase.Z, t);
  Z.head<2>() += shift;
  return Z;
}

// Lines "t q1 q2 q1' q2'", q = z or x.
std::string table(const MotionOf<double>& motion, const PhaseOf<double>& phase,
                  const model::Vector2<double>& shift) {
  std::string text;
  for (int i = 0; i <= samples; ++i) {
    const double t = phase.duration * i / samples;
    const model::Vector4<double> X = state(motion, phase, shift, t);
    text += fmt::format("{:.8g} {:.8g} {:.8g} {:.8g} {:.8g}\n", phase.start + t, X(0), X(1), X(2), X(3));
  }
  return text;
}

// An arrow along the portrait of each mass, in the middle of the phase.
Json arrows(const MotionOf<double>& motion, const PhaseOf<double>& phase,
            const model::Vector2<double>& shift) {
  const model::Vector4<double> from = state(motion, phase, shift, 0.5 * phase.duration);
  const model::Vector4<double> to = state(motion, phase, shift, 0.51 * phase.duration);
  Json both;
  for (int mass = 0; mass < 2; ++mass) {
    both[fmt::format("arrow{}", mass + 1)] = fmt::format("from first {:.8g},{:.8g} to first {:.8g},{:.8g}",
                                                         from(mass), from(mass + 2), to(mass), to(mass + 2));
  }
  return both;
}

model::Vector2<double> shift_of(const Family& family, const MotionOf<double>& motion) {
  return has_stick(family) ? model::Vector2<double>(0, 0) : motion.oscillator.d0;
}

Json phases_of(const MotionOf<double>& motion, const Family& family, std::size_t orbit) {
  const model::Vector2<double> shift = shift_of(family, motion);
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
    phases.back().update(arrows(motion, phase, shift));
  }
  return phases;
}

std::string parameter_text(const OrbitQuestion& question) {
  return in_greek(enumerated(named_parameters(question), [](const auto& one) {
    return fmt::format("{} = {}", one.first, notation(one.second));
  }));
}

std::string tell(const Orbit& orbit) {
  return is_admissible(orbit)                       ? "admissible"
         : orbit.admissible.truth == Truth::refuted ? "not admissible"
                                                    : "undecided";
}

// "symmetric orbit 2 of 4, admissible", and its ur where that is a result, another for each orbit.
std::string title(const OrbitList& list, std::size_t i) {
  const Orbit& orbit = list.orbits[i];
  std::string text = fmt::format("{} orbit {} of {}, {}", list.question.family->name, i + 1,
                                 list.orbits.size(), tell(orbit));
  for (const NamedBall& value : orbit.values) {
    if (value.name == "ur" && !list.question.ur) {
      text += fmt::format(", ur = {}", rounded(value.value, 4));
    }
  }
  return text;
}

// The orbits to draw: the admissible ones, or all if none is, or the one named.
std::vector<std::size_t> drawn(const OrbitList& list, std::optional<std::size_t> only) {
  const bool any = std::ranges::any_of(list.orbits, families::is_admissible);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < list.orbits.size(); ++i) {
    if (only ? i == *only : !any || is_admissible(list.orbits[i])) {
      found.push_back(i);
    }
  }
  return found;
}

// Over the period, at the points that are drawn.
std::vector<model::Vector4<double>> states_drawn(const MotionOf<double>& motion,
                                                 const model::Vector2<double>& shift) {
  std::vector<model::Vector4<double>> all;
  for (const PhaseOf<double>& phase : motion.phases) {
    for (int i = 0; i <= samples; ++i) {
      all.push_back(state(motion, phase, shift, phase.duration * i / samples));
    }
  }
  return all;
}

// What a reader sees of the orbit, for one who does not.
std::string described(const OrbitList& list, std::size_t i) {
  const MotionOf<double> motion = in_double(list.orbits[i].motion);
  const model::Vector2<double> shift = shift_of(*list.question.family, motion);
  const char q = has_stick(*list.question.family) ? 'z' : 'x';
  std::string text = title(list, i) + ":";
  for (const PhaseOf<double>& phase : motion.phases) {
    text += fmt::format(" {} from t = {:.4g} to {:.4g},", to_string(phase.kind), phase.start,
                        phase.start + phase.duration);
  }
  const std::vector<model::Vector4<double>> all = states_drawn(motion, shift);
  const auto extent = [&](int component) {
    return extremes(all, [&](const model::Vector4<double>& X) { return X(component); });
  };
  for (int mass = 0; mass < 2; ++mass) {
    const simulation::Extremes place = extent(mass), velocity = extent(mass + 2);
    text += fmt::format(" {}{} goes from {:.3g} to {:.3g}, its velocity from {:.3g} to {:.3g}{}", q, mass + 1,
                        place.least, place.greatest, velocity.least, velocity.greatest, mass == 0 ? "," : "");
  }
  return text + fmt::format("; the belt's is {:.3g}.", motion.oscillator.data.V);
}

Json orbit_data(const OrbitList& list, std::size_t i) {
  const MotionOf<double> motion = in_double(list.orbits[i].motion);
  const PhaseOf<double>& last = motion.phases.back();
  return {{"title", title(list, i)},
          {"q", has_stick(*list.question.family) ? "z" : "x"},
          {"period", fmt::format("{:.8g}", last.start + last.duration)},
          {"V", fmt::format("{:.8g}", motion.oscillator.data.V)},
          {"phases", phases_of(motion, *list.question.family, i + 1)}};
}

}  // namespace

std::string picture_in_words(const OrbitList& list, std::optional<std::size_t> only) {
  std::string text =
      "Closed curves of velocity over displacement for each mass, and both over one period of time.";
  for (const std::size_t i : drawn(list, only)) {
    std::string orbit = described(list, i);
    orbit.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(orbit.front())));
    text += " " + orbit;
  }
  return text;
}

std::string meaning_of_picture() {
  return "an arrow shows the direction of motion, a dot where a phase begins; the line is thick in an "
         "overshoot, medium in a slip, thin in a stick; displacements are lengths, $t$ is dimensionless";
}

std::string plot_script(const OrbitList& list, PlotFormat format, PlotShape shape,
                        std::optional<std::size_t> only, const Units& units) {
  Json orbits = Json::array();
  for (const std::size_t i : drawn(list, only)) {
    orbits.push_back(orbit_data(list, i));
  }
  if (orbits.empty()) {
    return "";
  }
  const Page page = shape == PlotShape::wide ? wide_page : narrow_page;
  const std::size_t rows = orbits.size() * static_cast<std::size_t>(page.rows);
  const int height = page.panel_height * static_cast<int>(rows);
  const Json data = {{"terminal", terminal(format, page.width, height)},
                     {"rows", std::to_string(rows)},
                     {"columns", std::to_string(4 / page.rows)},
                     {"narrow", shape == PlotShape::narrow},
                     {"arrow_size", fmt::format("{:.3f}", arrow_pixels / page.width)},
                     {"parameters", units.machine_or(parameter_text(list.question))},
                     {"orbits", orbits}};
  return render_file("orbits.gp", data, plain_format);
}

}  // namespace stickslip::report::orbits
