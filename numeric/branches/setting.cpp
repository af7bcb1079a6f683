#include "numeric/branches/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "numeric/branches/word_branches.hpp"
#include "numeric/families/family.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/symmetric.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::branches {

using namespace families;
using namespace motion;

namespace {

constexpr std::array parameters{"chi", "eta", "us", "V", "omega", "p", "phi", "ur"};

// The datum of that name in a question; nothing where it is not one of the family's.
Range * datum(OrbitQuestion& q, const std::string& name) {
  model::Parameters<Range>& a = q.parameters;
  const std::array<Range *, 6> all{&a.chi, &a.eta, &a.us, &a.V, &a.omega, &a.p};
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (name == parameters[k]) {
      return all[k];
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
  for (const Range& range :
       {question.orbits.parameters.chi, question.orbits.parameters.eta, question.orbits.parameters.us,
        question.orbits.parameters.V, question.orbits.parameters.omega, question.orbits.parameters.p,
        question.orbits.phi.value_or(Range{}), question.orbits.ur.value_or(Range{})}) {
    if (range.radius != 0) {
      throw UsageError("a branch is along one interval A..B: all other parameters are exact");
    }
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

namespace {

Law law_of_word(const BranchQuestion& question) {
  Law law;
  law.ur_is_free = question.parameter == "ur";
  if (!law.ur_is_free) {
    law.ur = question.orbits.ur->middle;
  }
  law.machine = question.machine;
  law.requirements = question.orbits.family->requirements;
  law.conditions = [family = question.word->family](const ClosedMotion& closed,
                                                    const std::optional<Ball>& ur) {
    return decide_all(family->phases, family->requirements, closed.motion, closed.waves, ur);
  };
  return law;
}

}  // namespace

Law law_of(const BranchQuestion& question) {
  if (question.word) {
    return law_of_word(question);
  }
  const Family& family = *question.orbits.family;
  const OrbitQuestion& q = question.orbits;
  Law law;
  law.machine = question.machine;
  law.ur_is_result = has_stick(family);
  law.phi_is_given = q.phi.has_value() || question.parameter == "phi";
  law.ur_is_free = !law.ur_is_result && question.parameter == "ur";
  if (!law.ur_is_result && !law.ur_is_free && q.ur) {
    law.ur = q.ur->middle;
  }
  law.is_symmetric = &family == &symmetric();
  law.requirements = requirements(family, law.ur_is_result || law.ur_is_free || law.ur);
  if (!law.ur_is_result && !law.ur_is_free && !law.ur) {
    for (Requirement requirement : family.requirements) {
      if (needs_ur(requirement.quantity) && requirement.quantity != Quantity::friction_step) {
        requirement.id = "ur_max";
        law.at_us.push_back(requirement);
      }
    }
  }
  // (36) is (25) of an orbit whose slip lasts half a period at V = 0: there x(0) = Q cos(phi), for the motion
  // that the friction excites alone is odd about t = 0.
  const auto at_rest = [&](const Rational& value) { return data_at(question, value).data.V == 0; };
  if (&family == &nonsticking() && at_rest(question.from) && at_rest(question.to)) {
    law.requirements.push_back({"36", "", Quantity::beyond_ur, 0});
  }
  law.conditions = [&family](const ClosedMotion& closed, const std::optional<Ball>& ur) {
    return families::conditions(family, closed, ur);
  };
  return law;
}

std::vector<Growth> overshooting_growths() {
  // a, C, D: the odd rows, which come first, are free of a and D, the even ones of C.
  return {{{2, 4}, {3}, {0, 1}}, {{3}, {2, 4}, {2, 3}}, {{2, 3, 4}, {}, {}}};
}

namespace {

std::vector<Growth> growths_of(const BranchQuestion& question) {
  const Family& family = *question.orbits.family;
  if (question.word) {
    return word_growths(*question.word);
  }
  if (&family == &symmetric()) {
    return {{{1}, {}, {}}};  // C
  }
  if (&family == &overshooting()) {
    return overshooting_growths();
  }
  return {};
}

}  // namespace

Curve curve_of(const BranchQuestion& question, const Closing& equations) {
  const Given<Rational> given = data_at(question, question.from);
  Given<Ball> balls{parameters_as<Ball>(given.data), {}, {}};
  balls.phi = given.phi ? std::optional(Ball(*given.phi)) : std::nullopt;
  balls.ur = given.ur ? std::optional(Ball(*given.ur)) : std::nullopt;
  Curve curve{equations, equations.parameters(balls), 0, question.from, question.to};
  curve.machine = question.machine;
  curve.growths = growths_of(question);
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
