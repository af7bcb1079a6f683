#include "report/orbits/orbit_latex.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "core/decimal.hpp"
#include "numeric/families/family.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/tools/number_latex.hpp"
#include "report/tools/prose.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::motion;
using namespace tools;

namespace {

// The frequencies of the harmonics that a phase is made of, in the order of model/waves.hpp.
std::vector<std::string> frequencies(PhaseKind kind) {
  return kind == PhaseKind::stick ? std::vector<std::string>{""}
                                  : std::vector<std::string>{"\\omega_1 ", "\\omega_2 ", "\\omega "};
}

// "x_1 ={}& 0.1 + 0.2s \\ &{} + 0.3\cos\omega_1 s ...", a line for each harmonic; d0 turns z into x.
std::string equation(const std::string& left, const model::Wave<Ball>& z, const Ball& d0, PhaseKind kind,
                     int digits) {
  std::string text = fmt::format("{} ={{}}& {}", left, latex_factor(z.constant + d0, digits));
  if (!is_zero(z.slope)) {
    text += latex_term(z.slope, "s", digits);
  }
  const std::vector<std::string> names = frequencies(kind);
  for (std::size_t k = 0; k < static_cast<std::size_t>(z.count); ++k) {
    const model::Harmonic<Ball>& h = z.harmonics[k];
    std::string line;
    if (!is_zero(h.a)) {
      line += latex_term(h.a, fmt::format("\\cos {}s", names[k]), digits);
    }
    if (!is_zero(h.b)) {
      line += latex_term(h.b, fmt::format("\\sin {}s", names[k]), digits);
    }
    text += line.empty() ? "" : " \\\\\n&{}" + line;
  }
  return text;
}

// "\tau + \tau_1": when phase k begins; the last one ends at \Theta.
std::string begin_of(const Family& family, std::size_t k) {
  std::vector<std::string> sum;
  for (std::size_t i = 0; i < k; ++i) {
    sum.push_back(latex_of_value(family.durations[i]));
  }
  return k == 0                      ? "0"
         : k == family.phases.size() ? latex_of_value("Theta")
                                     : fmt::format("{}", fmt::join(sum, " + "));
}

std::string phase(const Orbit& orbit, const Family& family, std::size_t k, int digits) {
  const Motion& motion = orbit.motion;
  const PhaseKind kind = motion.phases[k].kind;
  const model::PhaseWaves<Ball> wave = waves(motion, k);
  const model::Vector2<Ball>& d0 = motion.oscillator.d0;
  const std::string begin = begin_of(family, k);
  const std::string since = k == 0 ? "s = t" : k == 1 ? "s = t - " + begin : "s = t - (" + begin + ")";
  return fmt::format(
      "\\paragraph{{{}, ${} \\le t \\le {}$.}} With ${}$,\n\\begin{{align*}}\n{} \\\\\n{}\n\\end{{align*}}\n",
      capitalised(to_string(kind)), begin, begin_of(family, k + 1), since,
      equation("x_1", wave.z1, d0(0), kind, digits), equation("x_2", wave.z2, d0(1), kind, digits));
}

std::string data(const OrbitQuestion& question) {
  std::vector<std::string> parts;
  for (const auto& [name, range] : named_parameters(question)) {
    parts.push_back(latex_of_value(name, stickslip::to_string(range.middle)));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string values(const Orbit& orbit, const OrbitQuestion& question, int digits) {
  const model::Modes<Ball>& m = orbit.motion.oscillator.modes;
  std::vector<std::string> parts{latex_of_value("omega1", latex_factor(m.omega1, digits)),
                                 latex_of_value("omega2", latex_factor(m.omega2, digits))};
  for (const NamedBall& value : orbit.values) {
    const bool given = (value.name == "phi" && question.phi) || (value.name == "ur" && question.ur);
    if (!given) {
      parts.push_back(latex_of_value(value.name, latex_factor(value.value, digits)));
    }
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string what_is_proved(const Orbit& orbit) {
  const std::string stability =
      orbit.stability ? fmt::format("; stability: {}", to_string(orbit.stability->kind)) : "";
  return prose_tex(fmt::format("Proved to exist, and {}{}.", verdict_on(orbit), stability));
}

}  // namespace

std::string orbit_latex(const OrbitList& list, std::size_t index, int digits) {
  const Orbit& orbit = list.orbits[index];
  const Family& family = *list.question.family;
  std::string text = fmt::format(
      "% {}\n% Orbit {} of {}. Each number is right to one unit of its last digit.\n"
      "{{\\raggedright\n\\paragraph{{Data.}} {}.\n\\paragraph{{Orbit.}} {}\n{}.\\par}}\n",
      command_of(list.question), index + 1, list.orbits.size(), data(list.question), what_is_proved(orbit),
      values(orbit, list.question, digits));
  for (std::size_t k = 0; k < orbit.motion.phases.size(); ++k) {
    text += phase(orbit, family, k, digits);
  }
  return text;
}

}  // namespace stickslip::report::orbits
