#include "numeric/branches/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "model/named_data.hpp"
#include "numeric/families/family.hpp"
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

Given<Rational> exact(const OrbitQuestion& q) {
  const model::Parameters<Range>& a = q.parameters;
  const auto of = [](const std::optional<Range>& range) {
    return range ? std::optional(range->middle) : std::nullopt;
  };
  return {
      {a.chi.middle, a.eta.middle, a.us.middle, a.V.middle, a.omega.middle, a.p.middle}, of(q.phi), of(q.ur)};
}

OrbitQuestion at_one_value(const OrbitQuestion& q, const Given<Rational>& given) {
  const ExactParameters& a = given.data;
  const auto range = [](const std::optional<Rational>& value) {
    return value ? std::optional(Range{*value}) : std::nullopt;
  };
  return {q.family,
          {Range{a.chi}, Range{a.eta}, Range{a.us}, Range{a.V}, Range{a.omega}, Range{a.p}},
          range(given.phi),
          range(given.ur),
          q.digits};
}

}  // namespace

Given<Rational> data_at(const BranchQuestion& question, const Rational& value) {
  if (question.machine) {
    const DataTaken taken = question.machine->taken(value);
    return {taken.data, question.machine->phi, taken.ur};
  }
  return exact(with(question, {value}));
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
  const Given<Rational> given = data_at(question, question.from);
  Given<Ball> balls{parameters_as<Ball>(given.data), {}, {}};
  balls.phi = given.phi ? std::optional(Ball(*given.phi)) : std::nullopt;
  balls.ur = given.ur ? std::optional(Ball(*given.ur)) : std::nullopt;
  Curve curve{equations, equations.parameters(balls), 0, question.from, question.to};
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

}  // namespace stickslip::numeric::branches
