#include "numeric/motion/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "core/error.hpp"

namespace stickslip::numeric::motion {

using model::Wave;

namespace {

constexpr int shown_digits = 10;

void refute(Condition& condition, const char * premise, const Ball& excess) {
  condition.verdict =
      Verdict::refuted(fmt::format("{} is not met: off by {}", premise, to_string(excess, shown_digits)));
}

void decide_along(Condition& condition, const Motion& motion, const model::PhaseWaves<Ball>& w,
                  const Ball& ur, const Requirement& q) {
  const Phase& phase = motion.phases[q.phase];
  const Affine<Ball> form = affine_form<Ball>(motion.oscillator.data, ur, q.quantity);
  const Wave<Ball> g = model::affine<Ball>(form.factor, form.of_speed ? w.zdot2 : w.r, form.offset);
  const WaveCourse course(g);
  judge_along(
      condition,
      {course, WaveCourse(reversed(g, phase.duration)), course.bounds(), phase.start, phase.duration,
       q.touches, form.of_speed ? "$z2' = V$ at an end of the phase" : "$r = ur$ at the end of the stick",
       q.strict});
}

void decide_at_start(Condition& condition, const Motion& motion, const Ball& ur, const Requirement& q) {
  const Phase& phase = motion.phases[q.phase];
  const Affine<Ball> form = affine_form<Ball>(motion.oscillator.data, ur, q.quantity);
  const Ball excess = phase.Z(3) - motion.oscillator.data.V;
  const Ball r = model::friction_at<Ball>(motion.oscillator.data, phase.Z, phase.load);
  if (!excess.contains_zero()) {
    return refute(condition, "$z2' = V$", excess);
  }
  if (q.quantity == Quantity::falls_behind && !(r - ur).contains_zero()) {
    return refute(condition, "$r = ur$", r - ur);
  }
  judge(condition, form.factor * r + form.offset, q.strict, "the distance");
  condition.at = phase.start;
  if (condition.verdict.truth == Truth::refuted) {
    condition.violation = Violation{phase.start, *condition.margin};
  }
}

// As decide; `known` holds the waves of all phases or is empty.
Condition decide_with(const Motion& motion, const std::vector<model::PhaseWaves<Ball>>& known,
                      const std::optional<Ball>& ur, const Requirement& q) {
  Condition condition{q.id, q.statement, {}, {}, {}, {}};
  if (q.phase >= motion.phases.size()) {
    throw InternalError("condition " + q.id + " speaks of a phase that the motion does not have");
  }
  if (!ur && needs_ur(q.quantity)) {
    throw InternalError("condition " + q.id + " needs u_r");
  }
  const Ball friction = ur.value_or(Ball(0));
  const Ball& us = motion.oscillator.data.us;
  if (q.quantity == Quantity::duration) {
    judge(condition, motion.phases[q.phase].duration, q.strict, "the duration");
  } else if (q.quantity == Quantity::slipping_friction) {
    judge(condition, us, q.strict, "$us$");
  } else if (q.quantity == Quantity::friction_step) {
    judge(condition, friction - us, q.strict, "$ur - us$");
  } else if (q.along) {
    decide_along(condition, motion, known.empty() ? waves(motion, q.phase) : known[q.phase], friction, q);
  } else {
    decide_at_start(condition, motion, friction, q);
  }
  return condition;
}

// The verdict of closes, from the waves of all phases.
Verdict closes_with(const std::vector<PhaseKind>& kinds, const Motion& motion,
                    const std::vector<model::PhaseWaves<Ball>>& known) {
  if (!std::ranges::equal(kinds, motion.phases, {}, {}, &Phase::kind)) {
    return Verdict::refuted("the phases are not those of the family");
  }
  static constexpr std::array<const char *, 4> names{"z1", "z2", "z1'", "z2'"};
  const std::vector<model::Vector4<Ball>> jumps = gaps(motion, known);
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    for (int i = 0; i < 4; ++i) {
      if (jumps[k](i).is_nonzero()) {
        return Verdict::refuted(fmt::format("the motion does not close: {} jumps by {} after phase {} of {}",
                                            names[static_cast<std::size_t>(i)],
                                            to_string(jumps[k](i), shown_digits), k + 1, jumps.size()));
      }
    }
  }
  return Verdict::undecided("no gap is separated from zero; only an existence proof closes a motion");
}

}  // namespace

void judge(Condition& condition, const Ball& value, bool strict, const char * what) {
  condition.margin = value;
  if (value.is_positive() || (!strict && arb_is_nonnegative(value.raw()) != 0)) {
    condition.verdict = Verdict::proved();
  } else if (value.is_negative() || (strict && arb_is_zero(value.raw()) != 0)) {
    condition.verdict = Verdict::refuted(fmt::format("{} is {}", what, to_string(value, shown_digits)));
  } else {
    condition.verdict = Verdict::undecided(
        fmt::format("{} is {}, not separated from zero", what, to_string(value, shown_digits)));
  }
}

void judge_along(Condition& condition, const Along& along) {
  const Infimum infimum =
      weighted_infimum(along.g, along.reversed, along.bounds, along.duration, along.touches);
  if (along.touches.start && !infimum.start.contains_zero()) {
    return refute(condition, along.premise, infimum.start);
  }
  if (along.touches.end && !infimum.end.contains_zero()) {
    return refute(condition, along.premise, infimum.end);
  }
  if (!along.duration.is_positive()) {
    condition.verdict = Verdict::undecided("the duration of the phase is not proved positive: " +
                                           to_string(along.duration, shown_digits));
    return;
  }
  judge(condition, infimum.value, along.strict, "the smallest distance");
  condition.at = along.start + infimum.time;
  if (condition.verdict.truth == Truth::refuted) {
    condition.violation = violation(along.g, along.duration, infimum.time);
    if (condition.violation) {
      condition.violation->time += along.start;
    }
  }
}

Condition decide(const Motion& motion, const std::optional<Ball>& ur, const Requirement& q) {
  return decide_with(motion, {}, ur, q);
}

Verdict closes(const std::vector<PhaseKind>& kinds, const Motion& motion) {
  return closes_with(kinds, motion, all_waves(motion));
}

std::vector<Condition> decide_all(const std::vector<PhaseKind>& kinds, const Requirements& requirements,
                                  const Motion& motion, const std::vector<model::PhaseWaves<Ball>>& waves,
                                  const std::optional<Ball>& ur) {
  std::vector<Condition> result;
  const Verdict closing = closes_with(kinds, motion, waves);
  for (const Requirement& requirement : requirements) {
    result.push_back(closing.truth == Truth::refuted
                         ? Condition{requirement.id, requirement.statement, closing, {}, {}, {}}
                         : decide_with(motion, waves, ur, requirement));
  }
  return result;
}

Verdict admissible(const std::vector<Condition>& conditions) {
  std::vector<Verdict> verdicts;
  std::ranges::transform(conditions, std::back_inserter(verdicts), &Condition::verdict);
  return all_of(verdicts);
}

}  // namespace stickslip::numeric::motion
