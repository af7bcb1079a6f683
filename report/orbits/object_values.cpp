#include "report/orbits/object_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "model/flows.hpp"
#include "model/named_data.hpp"
#include "numeric/families/family.hpp"
#include "numeric/motion/domain.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/prose.hpp"
#include "symbolic/algebra/symbols.hpp"
#include "symbolic/typeset/latex.hpp"

namespace stickslip::report::orbits {

using namespace symbolic::algebra;
using symbolic::objects::Line;
using symbolic::objects::Object;
using symbolic::objects::Unknowns;
using symbolic::typeset::latex;
using tools::latex_factor;
using tools::latex_term;
using namespace numeric;
using namespace numeric::motion;
using namespace tools;

namespace {

using GiNaC::ex;
using Names = std::vector<std::string>;

// What follows from the data, and from which.
struct Derived {
  std::string name;
  Names from;
};

const std::vector<Derived>& derived() {
  static const std::vector<Derived> all{
      {"omega1", {"chi", "eta"}},
      {"omega2", {"chi", "eta"}},
      {"lambda1", {"chi", "eta"}},
      {"lambda2", {"chi", "eta"}},
      {"Theta", {"omega"}},
      {"d01", {"chi", "us"}},
      {"d02", {"chi", "us"}},
      {"q1", {"chi", "eta", "omega", "p"}},
      {"q2", {"chi", "eta", "omega", "p"}},
  };
  return all;
}

bool has(const Names& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

Names names_in(const std::vector<Line>& lines) {
  Names names;
  for (const Line& line : lines) {
    for (const ex& entry : line.entries) {
      for (const ex& symbol : symbols_of(entry)) {
        names.push_back(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
      }
    }
  }
  return names;
}

// Those that have no value here stand for valid ones: nothing asks for them.
numeric::motion::ExactParameters exact_data(const GivenParameters& given) {
  return model::data_by_name([&given](const std::string& name) {
    const auto found = given.find(name);
    return found != given.end() ? found->second : Rational(1, name == "chi" || name == "us" ? 2 : 1);
  });
}

void require_domain(const GivenParameters& given) {
  numeric::motion::require_model_domain(exact_data(given));
  const auto ur = given.find("ur");
  if (ur != given.end() && given.contains("us") && ur->second <= given.at("us")) {
    throw DomainError("ur", to_string(ur->second), "ur > us");
  }
}

// The balls of what is given and of those of the names that follow.
BallValues known_values(const GivenParameters& given, const Names& names) {
  const auto data = numeric::motion::parameters_as<Ball>(exact_data(given));
  const model::Modes<Ball> m = model::modes<Ball>(data.chi, data.eta);
  const model::Vector2<Ball> d0 = model::d0<Ball>(data.chi, data.us);
  const model::Vector2<Ball> Q = model::Q<Ball>(data, m);
  const std::array values{m.omega1, m.omega2, m.lambda1, m.lambda2, Ball(2) * Ball::pi() / data.omega,
                          d0(0),    d0(1),    Q(0),      Q(1)};
  BallValues known;
  for (const auto& [name, value] : given) {
    known[symbol(name)] = Ball(value);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (has(names, derived()[i].name)) {
      known[symbol(derived()[i].name)] = values[i];
    }
  }
  return known;
}

bool is_known(const ex& expression, const BallValues& known) {
  return std::ranges::all_of(symbols_of(expression), [&](const ex& s) { return known.contains(s); });
}

// Values of the coefficients of what is free, for all entries: free -> coefficients, by the text of what is
// free.
struct Part {
  ex free;
  std::vector<ex> coefficients;
};

std::map<std::string, Part> parts_of(const Line& line, const BallValues& known) {
  std::map<std::string, Part> parts;
  for (std::size_t i = 0; i < line.entries.size(); ++i) {
    const ex expanded = line.entries[i].expand();
    const GiNaC::lst alone{expanded};
    for (const ex& term : GiNaC::is_a<GiNaC::add>(expanded) ? expanded : ex(alone)) {
      ex coefficient = 1;
      ex free = 1;
      const GiNaC::lst single{term};
      for (const ex& factor : GiNaC::is_a<GiNaC::mul>(term) ? term : ex(single)) {
        (is_known(factor, known) ? coefficient : free) *= factor;
      }
      // What is 1 comes first.
      Part& part = parts[free.is_equal(1) ? "" : symbolic::typeset::text(free)];
      part.free = free;
      part.coefficients.resize(line.entries.size(), 0);
      part.coefficients[i] += coefficient;
    }
  }
  return parts;
}

// What the values of an expression are printed from.
struct Place {
  const Object& object;
  const GivenParameters& given;
  BallValues known;
  int digits;
};

Ball value_of(const ex& coefficient, const Place& place) {
  const Ball value = evaluate(coefficient, place.known);
  if (!value.is_finite()) {
    numeric::motion::require_response(exact_data(place.given));
    throw UsageError(fmt::format(
        "{} has no value at these parameters: something that it is divided by is zero there, or cannot be "
        "distinguished from zero",
        place.object.name));
  }
  // What vanishes for all parameters is 0, not a small ball.
  return value.contains_zero() && in_frequencies(coefficient).normal().is_zero() ? Ball(0) : value;
}

std::string number_matrix(const std::vector<Ball>& values, std::size_t columns, int digits) {
  std::string text = "\\begin{pmatrix}\n";
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += is_zero(values[i]) ? "0" : latex_factor(values[i], digits);
    text += (i + 1) % columns != 0 ? " & " : i + 1 < values.size() ? " \\\\\n" : "\n";
  }
  return text + "\\end{pmatrix}";
}

// "+ 0.5\cos\omega_1 t", or the same with a matrix in place of the number.
std::string term(const Part& part, const Line& line, const Place& place) {
  std::vector<Ball> values;
  for (const ex& coefficient : part.coefficients) {
    values.push_back(value_of(coefficient, place));
  }
  if (std::ranges::all_of(values, [](const Ball& value) { return is_zero(value); })) {
    return "";
  }
  std::string free = part.free.is_equal(1) ? "" : latex(part.free);
  if (free.starts_with("-")) {  // of sin(tau - Theta) the printer may turn the sign
    free.erase(0, 1);
    std::ranges::transform(values, values.begin(), std::negate<>());
  }
  if (values.size() > 1) {
    return " + " + number_matrix(values, line.columns, place.digits) + free;
  }
  if (!free.empty() && values[0].is_exact() && abs(values[0]).overlaps(Ball(1))) {
    return (values[0].is_positive() ? " + " : " - ") + free;
  }
  return latex_term(values[0], (free.starts_with("\\frac") ? "\\," : "") + free, place.digits);
}

Line in_numbers(const Line& line, const Place& place) {
  std::vector<std::string> terms;
  for (const auto& [text, part] : parts_of(line, place.known)) {
    const std::string next = term(part, line, place);
    if (!next.empty()) {
      terms.push_back(!terms.empty() ? next : (next.starts_with(" - ") ? "-" : "") + next.substr(3));
    }
  }
  return terms.empty() ? Line{line.left, "0"} : symbolic::objects::broken(line.left, terms);
}

std::string data_sentence(const GivenParameters& given, const BallValues& known, const Names& names,
                          int digits) {
  Names parts;
  for (const char * name : {"chi", "eta", "us", "V", "omega", "p", "phi", "ur"}) {
    if (given.contains(name)) {
      parts.push_back(latex_of_value(name, to_string(given.at(name))));
    }
  }
  for (const Derived& value : derived()) {
    if (has(names, value.name)) {
      parts.push_back(latex_of_value(value.name, latex_factor(known.at(symbol(value.name)), digits)));
    }
  }
  return fmt::format("{{\\raggedright At {}:\\par}}\n", fmt::join(parts, ", "));
}

}  // namespace

Names parameters_of(const std::vector<const Object *>& objects) {
  Names found;
  for (const Object * object : objects) {
    const Names names = names_in(object->lines(Unknowns::chi));
    found.insert(found.end(), names.begin(), names.end());
  }
  for (const Derived& value : derived()) {
    if (has(found, value.name)) {
      found.insert(found.end(), value.from.begin(), value.from.end());
    }
  }
  Names result;
  for (const auto& [name, member] : model::named_data<Rational>) {
    if (has(found, name)) {
      result.emplace_back(name);
    }
  }
  return result;
}

std::string values_latex(const Object& object, const GivenParameters& given, int digits) {
  constexpr long guard = 64;
  const WorkingPrecision precision(static_cast<long>(4 * digits) + guard);
  const std::vector<Line> lines = object.lines(Unknowns::chi);
  const Names names = names_in(lines);
  const Names needed = parameters_of({&object});
  GivenParameters used = given;
  std::erase_if(used, [&](const auto& parameter) {
    return !has(needed, parameter.first) && !has(names, parameter.first);
  });
  if (used.empty()) {
    return fmt::format("% {} is the same at all parameters.\n", object.name);
  }
  require_domain(given);
  const BallValues data = known_values(used, names);
  Place place{object, given, data, digits};
  for (const Line& line : lines) {
    for (const std::string& name : names) {
      if (line.entries.size() == 1 && line.left == latex_of_value(name) && !data.contains(symbol(name)) &&
          is_known(line.entries[0], data)) {
        place.known[symbol(name)] = value_of(line.entries[0], place);
      }
    }
  }
  std::vector<Line> values;
  for (const Line& line : lines) {
    if (!line.entries.empty()) {
      values.push_back(in_numbers(line, place));
    }
  }
  return data_sentence(used, data, names, digits) + symbolic::objects::displayed(values);
}

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
  const auto name = [](const std::string& duration) { return latex_of_value(duration); };
  return k == 0                      ? "0"
         : k == family.phases.size() ? latex_of_value("Theta")
                                     : enumerated(std::span(family.durations).first(k), name, " + ");
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
  return enumerated(named_parameters(question), [](const auto& one) {
    return latex_of_value(one.first, stickslip::to_string(one.second.middle));
  });
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
