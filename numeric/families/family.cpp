#include "numeric/families/family.hpp"

#include <algorithm>
#include <cctype>

#include "core/error.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/symmetric.hpp"

namespace stickslip::numeric::families {

using namespace motion;

bool asks_for_box(const OrbitQuestion& q) {
  const model::Parameters<Range>& a = q.parameters;
  const std::array all{
      a.chi, a.eta, a.us, a.V, a.omega, a.p, q.phi.value_or(Range{}), q.ur.value_or(Range{})};
  return std::any_of(all.begin(), all.end(), [](const Range& range) { return range.radius != 0; });
}

const Ball& Orbit::value(const std::string& name) const {
  const auto found =
      std::find_if(values.begin(), values.end(), [&](const NamedBall& value) { return value.name == name; });
  if (found == values.end()) {
    throw InternalError("the orbit has no value " + name);
  }
  return found->value;
}

bool is_admissible(const Orbit& orbit) {
  return orbit.admissible.truth == Truth::proved;
}

bool all_decided(const Orbit& orbit) {
  return std::ranges::all_of(orbit.conditions, [](const Condition& c) { return c.verdict.is_decided(); });
}

bool is_stable(const Orbit& orbit) {
  return orbit.stability && orbit.stability->kind == StabilityKind::stable;
}

const std::vector<const Family *>& all_families() {
  static const std::vector<const Family *> table{&symmetric(), &overshooting(), &nonsticking()};
  return table;
}

namespace {

std::string names_of(const std::vector<const Family *>& all) {
  std::string names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    names += (i == 0 ? "" : i + 1 == all.size() ? " or " : ", ") + all[i]->name;
  }
  return names;
}

}  // namespace

std::string names_of_families() {
  return names_of(all_families());
}

std::string names_of_judged_families() {
  std::vector<const Family *> judged = all_families();
  std::erase_if(judged, [](const Family * family) { return family->judges == nullptr; });
  return names_of(judged);
}

const Family& family_named(const std::string& name) {
  for (const Family * family : all_families()) {
    if (family->name == name) {
      return *family;
    }
  }
  std::string capitals = name;
  std::ranges::transform(capitals, capitals.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const bool is_word = !name.empty() && capitals.find_first_not_of("SOT") == std::string::npos;
  throw UsageError("there is no family '" + name + "' of orbits: " + names_of_families() +
                   (is_word ? "; a word of phases is written in capitals: " + capitals : ""));
}

bool has_stick(const Family& family) {
  return std::find(family.phases.begin(), family.phases.end(), PhaseKind::stick) != family.phases.end();
}

std::vector<NamedBall> start_values(const Motion& motion) {
  const Phase& first = motion.phases.front();
  const model::Vector2<Ball>& d0 = motion.oscillator.d0;
  const Ball two_pi = Ball(2) * Ball::pi();
  return {{"Theta", two_pi / motion.oscillator.data.omega},
          {"phi", (first.load + Ball::pi()).is_negative() ? first.load + two_pi : first.load},
          {"z10", first.Z(0)},
          {"z20", first.Z(1)},
          {"zdot10", first.Z(2)},
          {"x10", first.Z(0) + d0(0)},
          {"x20", first.Z(1) + d0(1)},
          {"xdot10", first.Z(2)}};
}

Requirements requirements(const Family& family, bool ur_given) {
  Requirements list = family.requirements;
  if (!ur_given) {
    std::erase_if(list, [](const Requirement& requirement) { return needs_ur(requirement.quantity); });
  }
  return list;
}

Ball friction_of(const Family& family, const ClosedMotion& motion) {
  Ball least = motion.friction.front();
  if (!has_stick(family)) {
    for (const Ball& ahead : motion.friction) {
      arb_min(least.raw(), least.raw(), ahead.raw(), WorkingPrecision::bits());
    }
  }
  return least;
}

std::vector<Condition> conditions(const Family& family, const ClosedMotion& motion,
                                  const std::optional<Ball>& ur) {
  std::vector<Condition> result =
      decide_all(family.phases, requirements(family, ur.has_value()), motion.motion, motion.waves, ur);
  if (family.further != nullptr) {
    for (Condition& condition : family.further(motion.motion, friction_of(family, motion), ur)) {
      result.push_back(std::move(condition));
    }
  }
  return result;
}

}  // namespace stickslip::numeric::families
