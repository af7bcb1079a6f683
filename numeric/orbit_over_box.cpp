#include "numeric/orbit_over_box.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/families/symmetric.hpp"
#include "numeric/motion/exits.hpp"
#include "numeric/motion/motion.hpp"
#include "numeric/orbits.hpp"

namespace stickslip::numeric {

using namespace families;
using namespace motion;
using namespace zeros;

namespace {

// How often a part is halved at most: where something changes within the box, it would never end.
constexpr int deepest = 12;

// A part of the box, and where it was halved its halves, by their places in a list.
struct Part {
  Vector members;  // of the parameters that the closing conditions take
  ParametricProof proof;
  int depth = 0;
  Orbit orbit = {};  // if the proof is one
  std::optional<std::array<std::size_t, 2>> halves = {};

  [[nodiscard]] bool is_proved() const { return proof.verdict.truth == Truth::proved; }
};

bool contains(const Vector& outer, const Vector& inner) {
  return outer.size() == inner.size() &&
         std::equal(outer.begin(), outer.end(), inner.begin(),
                    [](const Ball& a, const Ball& b) { return a.contains(b); });
}

// What is known of an orbit, nothing where it is open: the truth of each condition, and the kind of the
// stability, which is not asked for unless all hold.
std::vector<std::optional<int>> facts(const Orbit& orbit) {
  std::vector<std::optional<int>> all;
  for (const Condition& c : orbit.conditions) {
    all.push_back(c.verdict.is_decided() ? std::optional(static_cast<int>(c.verdict.truth)) : std::nullopt);
  }
  if (orbit.stability) {
    const StabilityKind kind = orbit.stability->kind;
    all.push_back(kind == StabilityKind::undecided ? std::nullopt : std::optional(static_cast<int>(kind)));
  }
  return all;
}

// What orbits have in common, as far as they are looked at.
class Common {
 public:
  void add(const Orbit& orbit) {
    const auto more = facts(orbit);
    known_.resize(orbit.conditions.size() + 1);
    given_up_.resize(orbit.conditions.size() + 1);
    for (std::size_t k = 0; k < more.size(); ++k) {
      if (more[k]) {
        given_up_[k] = given_up_[k] || (known_[k] && known_[k] != more[k]);
        known_[k] = more[k];
      }
    }
  }
  // What is open of that orbit will stay so.
  void give_up(const Orbit& orbit) {
    const auto all = facts(orbit);
    given_up_.resize(orbit.conditions.size() + 1);
    for (std::size_t k = 0; k < all.size(); ++k) {
      given_up_[k] = given_up_[k] || !all[k];
    }
  }
  // Whether something is open that may be the same for all: a condition, or, later, the stability.
  [[nodiscard]] bool is_open(const Orbit& orbit, bool with_stability) const {
    const auto all = facts(orbit);
    for (std::size_t k = 0; k < (with_stability ? all.size() : orbit.conditions.size()); ++k) {
      if (!all[k] && !(k < given_up_.size() && given_up_[k])) {
        return true;
      }
    }
    return false;
  }

 private:
  std::vector<std::optional<int>> known_;
  std::vector<bool> given_up_;  // for they differ, or will stay open
};

// "Holds for all": of both, which are on the same condition.
Condition together(const Condition& a, const Condition& b) {
  Condition c{a.id, a.statement, a.verdict, {}, {}, {}};
  if (a.verdict.truth == Truth::proved || b.verdict.truth == Truth::undecided) {
    c.verdict = b.verdict;
  }
  const bool differ = a.verdict.truth != b.verdict.truth;
  if (differ && a.verdict.truth != Truth::undecided && b.verdict.truth != Truth::undecided) {
    c.verdict = Verdict::undecided("it holds for some of the parameters, not for others");
  }
  const auto hull = [](const std::optional<Ball>& x, const std::optional<Ball>& y) {
    return x && y ? std::optional(Ball::hull(*x, *y)) : std::nullopt;
  };
  c.margin = hull(a.margin, b.margin);
  c.at = hull(a.at, b.at);
  return c;
}

// As many multipliers lie in each enclosure as before, whichever are put together.
Stability together(const Stability& a, const Stability& b) {
  Stability s = a;
  if (a.kind != b.kind) {
    s.kind = StabilityKind::undecided;
    s.reason = a.kind == StabilityKind::undecided   ? a.reason
               : b.kind == StabilityKind::undecided ? b.reason
                                                    : "it is another one for others of the parameters";
  }
  if (a.multipliers.size() != b.multipliers.size()) {
    s.multipliers.clear();
  }
  for (std::size_t k = 0; k < s.multipliers.size(); ++k) {
    ComplexBall& mu = s.multipliers[k];
    mu = {Ball::hull(mu.re, b.multipliers[k].re), Ball::hull(mu.im, b.multipliers[k].im)};
  }
  return s;
}

void join(Orbit& all, const Orbit& part) {
  for (std::size_t k = 0; k < all.values.size(); ++k) {
    all.values[k].value = Ball::hull(all.values[k].value, part.values[k].value);
  }
  const auto hull = [](const Ball& a, const Ball& b) { return Ball::hull(a, b); };
  all.motion = Zip<decltype(hull)>{hull}(all.motion, part.motion);
  for (std::size_t k = 0; k < all.conditions.size(); ++k) {
    all.conditions[k] = together(all.conditions[k], part.conditions[k]);
  }
  if (all.stability && part.stability) {
    all.stability = together(*all.stability, *part.stability);
  } else {
    all.stability.reset();
  }
}

class Division {
 public:
  Division(const Family& family, const Candidate& candidate, const Given<Ball>& box)
      : family_(family), f_(candidate.equations), ur_(box.ur) {
    parts_.push_back(look(f_.parameters(box), f_.unknowns(candidate.guess), 0));
  }

  // Halves what is open, of the existence and the conditions, and then of the stability, too; not at all
  // where that is not likely to come to an end.
  void run(std::size_t most_parts) {
    for (const bool with_stability : {false, true}) {
      std::vector<std::size_t> open;
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (!parts_[i].halves && is_open(parts_[i], with_stability)) {
          open.push_back(i);
        }
      }
      if (!open.empty() && is_promising(most_parts, with_stability)) {
        halve(std::move(open), most_parts, with_stability);
      }
    }
  }

  [[nodiscard]] OrbitOverBox result() const {
    std::vector<const Part *> all;
    for (const Part& part : parts_) {
      if (!part.halves) {
        all.push_back(&part);
      }
    }
    const auto name = [&](const Part& part) {
      return f_.parameter_names()[static_cast<std::size_t>(part.proof.widest)];
    };
    OrbitOverBox result{Verdict::proved(), name(parts_[0]), {}, all.size()};
    const auto unproved =
        std::find_if(all.begin(), all.end(), [](const Part * part) { return !part->is_proved(); });
    if (unproved != all.end()) {
      result.existence = (*unproved)->proof.verdict;
      result.split = name(**unproved);
      return result;
    }
    if (!fits_together()) {
      result.existence = Verdict::undecided("the motions over two parts of the box may be different ones");
      return result;
    }
    result.orbit = all.front()->orbit;
    std::for_each(all.begin() + 1, all.end(), [&](const Part * part) { join(result.orbit, part->orbit); });
    result.orbit.admissible = admissible(result.orbit.conditions);
    if (!std::ranges::all_of(result.orbit.motion.phases,
                             [](const Phase& phase) { return phase.duration.is_positive(); })) {
      result.existence = Verdict::undecided("one of its phases may last no time for some of them");
    }
    return result;
  }

 private:
  [[nodiscard]] Part look(const Vector& members, const Vector& guess, int depth) const {
    Part part{members, prove_over_parameters(f_, members, guess), depth};
    if (part.is_proved()) {
      const ParametricProof& proof = part.proof;
      const MotionOf<ParameterJet> jets = f_.motion<ParameterJet>(proof.x, proof.p);
      const Motion middle = f_.motion<Ball>(proof.at_middle, proof.p0);
      part.orbit = decided_orbit(family_, closed_over(proof, jets, middle), ur_);
      std::optional<Stability>& stability = part.orbit.stability;
      if (stability && stability->kind == StabilityKind::undecided) {
        const auto kind = stability_over(proof, jets, middle, family_.is_symmetric);
        stability = kind ? Stability{*kind, {}, stability->multipliers} : *stability;
      }
    }
    return part;
  }

  // The half at the lower or the upper end, by the parameter that the motion varies most with.
  [[nodiscard]] Part half(const Part& part, int end) const {
    const ParametricProof& proof = part.proof;
    const int k = proof.widest;
    Vector members = part.members;
    const Ball& side = part.members(k);
    members(k) = Ball::hull(end == 0 ? side.lower() : side.upper(), proof.p0(k));
    return look(members, proof.at_middle, part.depth + 1);
  }

  // Until nothing is open, or there are too many parts.
  void halve(std::vector<std::size_t> open, std::size_t most_parts, bool with_stability) {
    while (!open.empty() && (parts_.size() + 1) / 2 + open.size() <= most_parts && !interrupted()) {
      const std::vector<Part> halves = parallel_map(
          2 * open.size(), [&](std::size_t i) { return half(parts_[open[i / 2]], static_cast<int>(i % 2)); });
      const std::size_t first = parts_.size();
      for (std::size_t i = 0; i < halves.size(); ++i) {
        if (i % 2 == 0) {
          parts_[open[i / 2]].halves = {first + i, first + i + 1};
        }
        parts_.push_back(halves[i]);
        if (halves[i].is_proved()) {
          common_.add(halves[i].orbit);
        }
      }
      open.clear();
      for (std::size_t i = first; i < parts_.size(); ++i) {
        const Part& part = parts_[i];
        if (part.depth < deepest) {
          open.push_back(i);
        } else if (!part.is_proved()) {
          return;
        } else {
          common_.give_up(part.orbit);
        }
      }
      std::erase_if(open, [&](std::size_t i) { return !is_open(parts_[i], with_stability); });
    }
  }

  [[nodiscard]] bool is_open(const Part& part, bool with_stability) const {
    const bool has_middle = part.proof.at_middle.size() > 0 && part.proof.spread.size() > 0;
    return has_middle && (!part.is_proved() || common_.is_open(part.orbit, with_stability));
  }

  // Whether the parts next to the middle come to an end.
  [[nodiscard]] bool is_promising(std::size_t most_parts, bool with_stability) const {
    Part part = undivided_at(parts_[0], parts_[0].proof.p0);
    for (std::size_t parts = 1; parts < most_parts && part.depth < deepest && is_open(part, with_stability);
         parts *= 2) {
      part = half(part, 1);
    }
    return part.is_proved() && !is_open(part, with_stability);
  }

  // One that was not halved, of those that the part consists of, and that has the member.
  [[nodiscard]] const Part& undivided_at(const Part& part, const Vector& member) const {
    const Part * found = &part;
    while (found->halves) {
      const Part& first = parts_[(*found->halves)[0]];
      found = contains(first.members, member) ? &first : &parts_[(*found->halves)[1]];
    }
    return *found;
  }

  // The middle of a part is in both of its halves. Where one motion there is that of both, so it is all over
  // the side that they share: each changes with the parameters without a jump, and is the only one near it.
  [[nodiscard]] bool fits_together() const {
    return std::all_of(parts_.begin(), parts_.end(), [&](const Part& part) {
      return !part.halves || std::all_of(part.halves->begin(), part.halves->end(), [&](std::size_t half) {
        const Part& there = undivided_at(parts_[half], part.proof.p0);
        return contains(there.members, part.proof.p0) && contains(there.proof.unique, part.proof.at_middle);
      });
    });
  }

  const Family& family_;
  const Closing& f_;
  std::optional<Ball> ur_;
  std::vector<Part> parts_;  // each before its halves; the first is the box
  Common common_;
};

}  // namespace

OrbitOverBox prove_over_box(const Family& family, const Candidate& candidate, const Given<Ball>& box,
                            std::size_t most_parts) {
  Division division(family, candidate, box);
  division.run(most_parts);
  return division.result();
}

}  // namespace stickslip::numeric
