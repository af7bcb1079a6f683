#include "numeric/branches/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "model/named_data.hpp"
#include "numeric/families/family.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::branches {

using namespace families;
using namespace motion;

namespace {

constexpr std::array parameters{"chi", "eta", "us", "V", "omega", "p", "phi", "ur"};

// The datum of that name in a question; nothing where it is not one of the family's.
Range * datum(OrbitQuestion& q, const std::string& name) {
  for (const auto& [known, member] : model::named_data<Range>) {
    if (name == known) {
      return &(q.parameters.*member);
    }
  }
  std::optional<Range>& other = name == "phi" ? q.phi : q.ur;
  if (!other) {
    other = Range{};
  }
  return &*other;
}

// The question with the free parameter in this range.
OrbitQuestion with(const BranchQuestion& question, const Range& range) {
  OrbitQuestion q = question.orbits;
  *datum(q, question.parameter) = range;
  return q;
}

Range at_value(const Rational& value) {
  return {value};
}

OrbitQuestion at_one_value(const OrbitQuestion& q, const Given<Rational>& given) {
  const Given<Range> ranges = mapped<Range>(given, at_value);
  return {q.family, ranges.data, ranges.phi, ranges.ur, q.digits};
}

}  // namespace

Given<Rational> data_at(const BranchQuestion& question, const Rational& value) {
  if (question.machine) {
    const DataTaken taken = question.machine->taken(value);
    return {taken.data, question.machine->phi, taken.ur};
  }
  const OrbitQuestion q = with(question, at_value(value));
  return mapped<Rational>(Given<Range>{q.parameters, q.phi, q.ur},
                          [](const Range& range) { return range.middle; });
}

StripQuestion strip_question(const BranchQuestion& question) {
  if (question.machine) {
    return {data_at(question, question.to), parameters.size(), question.from, question.to, question.machine};
  }
  const auto place = std::find(parameters.begin(), parameters.end(), question.parameter) - parameters.begin();
  return {data_at(question, question.from), static_cast<std::size_t>(place), question.from, question.to};
}

void require_question(const BranchQuestion& question) {
  if (question.word && (question.parameter == "phi" || !question.at)) {
    throw UsageError(
        "a branch of a word is along chi, eta, us, V, omega, p or ur, from its orbits at a value");
  }
  if (!question.machine &&
      std::find(parameters.begin(), parameters.end(), question.parameter) == parameters.end()) {
    throw UsageError(
        fmt::format("along: '{}' is none of chi, eta, us, V, omega, p, phi and ur", question.parameter));
  }
  if (question.from >= question.to) {
    throw UsageError(fmt::format("{}: {}..{} does not rise: A..B needs A < B", question.parameter,
                                 stickslip::to_string(question.from), stickslip::to_string(question.to)));
  }
  if (question.at && (*question.at < question.from || *question.at > question.to)) {
    throw UsageError(fmt::format("at: {} = {} is not in the interval {}..{}", question.parameter,
                                 stickslip::to_string(*question.at), stickslip::to_string(question.from),
                                 stickslip::to_string(question.to)));
  }
  if (asks_for_box(question.orbits)) {
    throw UsageError("a branch is along one interval A..B: all other parameters are exact");
  }
  if (question.word) {
    for (const Rational& end : {question.from, question.to}) {
      const Given<Rational> given = data_at(question, end);
      words::require_word_domain({given.data, *given.ur});
    }
    return;
  }
  if (question.machine) {
    for (const Rational& end : {question.from, question.to}) {
      require_answerable(at_one_value(question.orbits, data_at(question, end)));
    }
    return;
  }
  require_answerable(with(question, {(question.from + question.to) / 2, (question.to - question.from) / 2}));
}

Law law_of(const BranchQuestion& question) {
  const Family& family = *question.orbits.family;
  const OrbitQuestion& q = question.orbits;
  Law law;
  law.machine = question.machine;
  law.ur_is_result = has_stick(family) && !question.word;
  law.phi_is_given = q.phi.has_value() || question.parameter == "phi";
  law.ur_is_free = !law.ur_is_result && question.parameter == "ur";
  if (!law.ur_is_result && !law.ur_is_free && q.ur) {
    law.ur = q.ur->middle;
  }
  law.is_symmetric = family.is_symmetric;
  law.requirements = requirements(family, law.ur_is_result || law.ur_is_free || law.ur);
  if (!law.ur_is_result && !law.ur_is_free && !law.ur) {
    for (Requirement requirement : family.requirements) {
      if (needs_ur(requirement.quantity) && requirement.quantity != Quantity::friction_step) {
        requirement.id = "ur_max";
        law.at_us.push_back(requirement);
      }
    }
  }
  const auto at_rest = [&](const Rational& value) { return data_at(question, value).data.V == 0; };
  if (at_rest(question.from) && at_rest(question.to)) {
    std::ranges::copy(family.at_rest, std::back_inserter(law.requirements));
  }
  law.conditions = [&family, kept = question.word ? question.word->family : nullptr](
                       const ClosedMotion& closed, const std::optional<Ball>& ur) {
    return families::conditions(family, closed, ur);
  };
  return law;
}

Curve curve_of(const BranchQuestion& question, const Closing& equations) {
  Curve curve{equations, equations.parameters(rounded(data_at(question, question.from))), 0, question.from,
              question.to};
  curve.machine = question.machine;
  curve.growths = question.orbits.family->growths;
  if (question.machine) {
    return curve;
  }
  const std::vector<std::string> names = equations.parameter_names();
  const auto found = std::find(names.begin(), names.end(), question.parameter);
  curve.place = static_cast<int>(found - names.begin());
  if (found == names.end()) {
    // The equations do not depend on it.
    curve.data.conservativeResize(curve.data.size() + 1);
    curve.data(curve.place) = Ball(question.from);
  }
  return curve;
}

std::string resonance_near(const Ball& value, const BranchQuestion& question) {
  const auto a = parameters_as<double>(
      data_at(question, std::clamp(Rational(value.approximate()), question.from, question.to)).data);
  const model::Modes<double> m = model::modes<double>(a.chi, a.eta);
  for (const auto& [frequency, name] :
       {std::pair(m.omega1, "omega1"), std::pair(1.0, "1"), std::pair(m.omega2, "omega2")}) {
    const double k = std::round(frequency / a.omega);
    if (k >= 1 && std::abs(k * a.omega - frequency) < 1e-6 * frequency) {
      return fmt::format(", next to the resonance {}omega = {}", k == 1 ? "" : fmt::format("{:.0f} ", k),
                         name);
    }
  }
  return "";
}

namespace {

using motion::PhaseKind;

// A system whose motions begin with phase `first` of the word's.
template <class F>
struct Turned {
  F equations;
  std::size_t first;
  bool takes_phi = false;
  bool takes_ur = true;

  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    return equations.template closing<T>(x, p);
  }
  template <class T>
  [[nodiscard]] motion::MotionOf<T> motion(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    motion::MotionOf<T> motion = equations.template motion<T>(x, p);
    turn(motion.phases, motion.phases.size() - first);
    T start(0);
    for (motion::PhaseOf<T>& phase : motion.phases) {
      phase.start = start;
      start += phase.duration;
    }
    return motion;
  }
  [[nodiscard]] zeros::Vector unknowns(motion::Motion motion) const {
    turn(motion.phases, first);
    return equations.unknowns(motion);
  }

  // So that phase `by` is the first.
  template <class Phases>
  static void turn(Phases& phases, std::size_t by) {
    std::rotate(phases.begin(), phases.begin() + static_cast<std::ptrdiff_t>(by % phases.size()),
                phases.end());
  }
};

// Where the phases are to be begun with, for these phases to come in that order; nothing where they do not.
std::optional<std::size_t> first_of(const std::vector<PhaseKind>& phases, const std::vector<PhaseKind>& as) {
  for (std::size_t k = 0; k < phases.size(); ++k) {
    std::vector<PhaseKind> turned = phases;
    Turned<Shooting>::turn(turned, k);
    if (turned == as) {
      return k;
    }
  }
  return std::nullopt;
}

struct Equations {
  motion::Closing closing;
  int phi;  // its place among the unknowns
  std::vector<families::Growth> growths;
};

// Of a slip, an overshoot and a stick in one period those of the family, reduced by hand: their cells are
// some twenty times as long. Else from the end of a stick on, if there is one: its duration, often the
// longest, is what the others leave.
Equations equations_of(std::vector<PhaseKind> phases, int periods) {
  const families::Family& family = families::overshooting();
  const auto whole = first_of(phases, family.phases);
  if (whole && periods == 1) {
    return {Turned<families::OvershootingClosing>{{false, true}, *whole}, 5, family.growths};
  }
  const auto stick = std::find(phases.rbegin(), phases.rend(), PhaseKind::stick).base() - phases.begin();
  const std::size_t first = static_cast<std::size_t>(stick) % phases.size();
  Turned<Shooting>::turn(phases, first);
  const int legs = static_cast<int>(phases.size()) - 1;
  return {Turned<Shooting>{{phases, periods}, first},
          legs + 3,
          {{{legs, legs + 1, legs + 2}, {}, {}}}};  // z1, z2, z1'
}

}  // namespace

BranchQuestion word_question(const words::WordQuestion& machine, const words::Word& word, int periods,
                             const std::vector<words::WordOrbit>& known) {
  families::Family record;
  record.name = word.letters();
  record.title = fmt::format("Orbits of the word {} over {} period{} of the load", word.letters(), periods,
                             periods == 1 ? "" : "s");
  record.phases = word.phases();
  for (std::size_t k = 0; k < word.size(); ++k) {
    record.durations.push_back(fmt::format("t{}", k + 1));
  }
  record.requirements = words::requirements_of(record.phases);
  record.growths = equations_of(record.phases, periods).growths;
  WordOrbits orbits{std::make_shared<const families::Family>(std::move(record)), {}, periods};
  for (const words::WordOrbit& one : known) {
    if (one.existence.truth == Truth::proved && one.word == word && one.periods == periods) {
      orbits.motions.push_back(one.orbit.motion);
    }
  }
  BranchQuestion question;
  question.orbits = {orbits.family.get(),
                     model::mapped<Range>(machine.data, at_value),
                     {},
                     at_value(machine.ur),
                     machine.digits};
  question.word = std::move(orbits);
  return question;
}

std::vector<families::Candidate> word_candidates(const WordOrbits& word) {
  const Equations equations = equations_of(word.family->phases, word.periods);
  std::vector<families::Candidate> all;
  for (const motion::Motion& motion : word.motions) {
    all.push_back(
        {{motion, {}, [](const motion::Motion&) { return true; }}, equations.closing, 0, equations.phi});
  }
  return all;
}

}  // namespace stickslip::numeric::branches
