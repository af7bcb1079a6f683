#include "numeric/branches/law.hpp"

#include <algorithm>
#include <cmath>

#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/branches/resonance.hpp"

namespace stickslip::numeric::branches {

using namespace motion;
using namespace zeros;

namespace {

// At parts of one cell: where something stays undecided all along, they would never end.
constexpr int most_looks = 1000;
// Where only the stability is open: so many looks, the first ones apart, halve the length on which it is if
// it changes at a few places, and not if multipliers stay near 1 in size all along.
constexpr double looks_to_halve = 32;
constexpr double free_looks = 160;

// Where it is given, in the motion's units.
template <class T>
std::optional<T> given_friction(const Law& law, const T& value, const T& unit) {
  return law.ur_is_free          ? std::optional(T(value * unit))
         : law.ur && law.machine ? std::optional(T(*law.machine->at<T, Ball>(value).ur * unit))
         : law.ur                ? std::optional(T(T(Ball(*law.ur)) * unit))
                                 : std::nullopt;
}

// Where the parameter lies as to its interval: the state that this alone decides.
std::optional<State> by_value(const Curve& curve, const Cell& cell, const Ball& value) {
  if (cell.driver == by_parameter) {
    return std::nullopt;
  }
  const Ball over = value - Ball(curve.to);
  const Ball under = Ball(curve.from) - value;
  if (over.is_positive() || under.is_positive()) {
    return State::outside;
  }
  return over.is_negative() && under.is_negative() ? std::nullopt : std::optional(State::undecided);
}

// The motions over a part, by their jets and in the middle.
struct Motions {
  const ParametricProof& proof;
  MotionOf<ParameterJet> jets;
  Motion middle;
  Ball unit, us;  // us in its own unit
};

void decide_state(Part& part, const Law& law, const Motions& motions) {
  const ClosedMotion closed = closed_over(motions.proof, motions.jets, motions.middle);
  bool lasts = true;
  for (const Phase& phase : closed.motion.phases) {
    lasts = lasts && phase.duration.is_positive();
    if (phase.duration.is_negative()) {
      part.state = State::absent;
    }
  }
  if (part.state == State::absent) {
    for (const Requirement& q : law.requirements) {
      if (q.quantity == Quantity::duration) {
        part.conditions.push_back(decide(closed.motion, {}, q));
      }
    }
    return;
  }
  part.conditions =
      law.conditions(closed, law.ur_is_result ? std::optional(closed.friction.front())
                                              : given_friction<Ball>(law, part.value, motions.unit));
  // In other units us is not told from zero where the motion is infinite.
  for (const Requirement& q : law.requirements) {
    if (part.in_units && q.quantity == Quantity::slipping_friction) {
      Motion own = closed.motion;
      own.oscillator.data.us = motions.us;
      std::ranges::replace_if(
          part.conditions, [&](const Condition& c) { return c.id == q.id; }, decide(own, {}, q));
    }
  }
  if (!lasts) {
    part.reason = "a phase may last no time at all";
    return;
  }
  if (law.is_symmetric && is_near_resonance(motions.middle)) {
    decide_without_response(motions.proof, motions.jets, motions.middle, law.requirements, part.conditions);
  }
  const Verdict admissible = motion::admissible(part.conditions);
  if (admissible.truth == Truth::refuted) {
    part.state = State::inadmissible;
    return;
  }
  if (admissible.truth != Truth::proved) {
    part.reason = admissible.reason;
    return;
  }
  part.admissible = true;
  const auto kind = stability_over(motions.proof, motions.jets, motions.middle, law.is_symmetric);
  const Stability stability = kind ? Stability{*kind, {}, {}} : decide_stability(closed.motion);
  part.reason = stability.reason;
  part.state = stability.kind == StabilityKind::stable     ? State::stable
               : stability.kind == StabilityKind::unstable ? State::unstable
               : stability.kind == StabilityKind::marginal ? State::marginal
                                                           : State::undecided;
}

bool is_unsettled(const Part& part) {
  return part.admissible && part.state == State::undecided;
}

double length(const Part& part) {
  return std::abs(Rational(part.last - part.first).get_d());
}

// Of the parts between the first and the last whose stability is open, that is all that is said.
void leave_unsettled(std::vector<Part>& parts) {
  const auto first = std::find_if(parts.begin(), parts.end(), is_unsettled);
  const auto last = std::find_if(parts.rbegin(), parts.rend(), is_unsettled).base();
  if (first < last && std::all_of(first, last, [](const Part& part) { return part.admissible; })) {
    std::for_each(first, last, [](Part& part) { part.state = State::admissible; });
  }
}

// Halves the longest undecided part again and again.
std::vector<Part> divided(const Curve& curve, const Law& law, const std::vector<Cell>& cells, std::size_t k,
                          double shortest) {
  const auto shorter = [](const Part& a, const Part& b) {
    return (a.value.radius() - b.value.radius()).is_negative();
  };
  std::vector<Part> open{look(curve, law, cells, k, cells[k].first, cells[k].last)};
  std::vector<Part> parts;
  const double whole = length(open.front());
  bool hopeless = false;
  for (int looks = 1; !open.empty(); looks += 2) {
    double unsettled = 0;
    for (const Part& part : open) {
      unsettled += is_unsettled(part) ? length(part) : 0;
    }
    hopeless = hopeless || unsettled > whole * std::exp2((free_looks - looks) / looks_to_halve);
    std::pop_heap(open.begin(), open.end(), shorter);
    Part part = std::move(open.back());
    open.pop_back();
    const bool short_enough = !(Ball(2) * part.value.radius() - Ball(shortest)).is_positive();
    if (part.decided() || short_enough || looks >= most_looks || (hopeless && is_unsettled(part)) ||
        interrupted()) {
      parts.push_back(std::move(part));
      continue;
    }
    const Rational middle = (part.first + part.last) / 2;
    for (const auto& [from, to] : {std::pair(part.first, middle), std::pair(middle, part.last)}) {
      open.push_back(look(curve, law, cells, k, from, to));
      std::push_heap(open.begin(), open.end(), shorter);
    }
  }
  const bool rises = cells[k].first < cells[k].last;
  std::sort(parts.begin(), parts.end(),
            [&](const Part& a, const Part& b) { return rises ? a.first < b.first : a.first > b.first; });
  if (hopeless) {
    leave_unsettled(parts);
  }
  return parts;
}

}  // namespace

bool Part::refutes(const std::string& id) const {
  return std::any_of(conditions.begin(), conditions.end(),
                     [&](const Condition& c) { return c.id == id && c.verdict.truth == Truth::refuted; });
}

ParametricProof proof_on(const Curve& curve, const Cell& cell, const Rational& first, const Rational& last) {
  if (first == cell.first && last == cell.last) {
    return cell.proof;
  }
  const Driven f{&cell.on(curve), cell.driver};
  ParametricProof proof = prove_over_parameters(f, Vector::Constant(1, between(first, last)),
                                                motion_near(cell.proof, (first + last) / 2));
  if (proof.verdict.truth != Truth::proved) {
    return proof;
  }
  if (!contains(cell.proof.unique, proof.at_middle)) {
    proof.verdict = Verdict::undecided("the motion on a part of a cell may be another one");
    return proof;
  }
  for (int i = 0; i < proof.box.size(); ++i) {
    // Both enclose the same motions.
    proof.box(i) = intersection(proof.box(i), cell.proof.box(i)).value_or(proof.box(i));
  }
  return proof;
}

Part look(const Curve& curve, const Law& law, const std::vector<Cell>& cells, std::size_t k,
          const Rational& first, const Rational& last) {
  const Cell& cell = cells[k];
  const Driven f{&cell.on(curve), cell.driver};
  Part part{k, first, last, {}, 0, State::undecided, {}, {}, {}, 0, false, cell.in_units != nullptr};
  const ParametricProof proof = proof_on(curve, cell, first, last);
  if (proof.verdict.truth != Truth::proved) {
    part.value = cell.driver == by_parameter ? between(first, last) : cell.proof.box(cell.driver);
    part.reason = proof.verdict.reason;
    return part;
  }
  const ParameterJet value = f.value<ParameterJet>(proof.x, proof.p);
  part.value = proof.over_box(value, f.value<Ball>(proof.at_middle, proof.p0));
  part.rises = scalars::sign_of(value.partial(0)) * (first < last ? 1 : -1);
  const Motion middle = f.motion<Ball>(proof.at_middle, proof.p0);
  part.sample = in_double(middle);
  part.sample_value = f.value<Ball>(proof.at_middle, proof.p0).approximate();
  if (const std::optional<State> state = by_value(curve, cell, part.value)) {
    part.state = *state;
    part.reason = "the parameter may lie outside its interval";
    return part;
  }
  const Ball unit =
      proof.over_box(f.unit<ParameterJet>(proof.x, proof.p), f.unit<Ball>(proof.at_middle, proof.p0));
  decide_state(part, law,
               {proof, f.motion<ParameterJet>(proof.x, proof.p), middle, unit,
                f.split<Ball>(proof.box, Vector::Constant(1, between(first, last))).p(2)});
  if (part.rises == 0 && part.reason.empty()) {
    part.reason = "the branch may turn here";
  }
  return part;
}

std::optional<ParameterJet> friction_jet(const Law& law, const MotionOf<ParameterJet>& motion,
                                         const ParameterJet& value, const ParameterJet& unit) {
  if (law.ur_is_result) {
    return friction_ahead<ParameterJet>(motion, 0);
  }
  return given_friction(law, value, unit);
}

std::vector<Part> parts_of(const Curve& curve, const Law& law, const std::vector<Cell>& cells,
                           double shortest) {
  std::vector<Part> parts;
  for (std::vector<Part>& of_cell :
       parallel_map(cells.size(), [&](std::size_t k) { return divided(curve, law, cells, k, shortest); })) {
    std::ranges::move(of_cell, std::back_inserter(parts));
  }
  return parts;
}

namespace {

constexpr double shortest_time = 0x1p-24;
constexpr long most_times = 20000;

Trend trend(const ParameterJet& g) {
  return g.value.is_positive() ? Trend::above : by_slope(g);
}

// g at the times from a to b, by its slope in time; the derivative by the driver at a fixed time.
ParameterJet over(const model::Wave<ParameterJet>& g, const model::Wave<ParameterJet>& slope, double a,
                  double b) {
  const Ball times = Ball::hull(Ball(a), Ball(b));
  const Ball middle = times.midpoint();
  ParameterJet value = model::value<ParameterJet>(g, ParameterJet(times));
  const ParameterJet form =
      model::value<ParameterJet>(g, ParameterJet(middle)) +
      model::value<ParameterJet>(slope, ParameterJet(times)) * ParameterJet(Ball(times - middle));
  value.value = zeros::intersection(value.value, form.value).value_or(form.value);
  return value;
}

// The infimum over 0 < t <= last of g, or of g/t at a touched start: there g(t)/t is a mean of g'.
Trend from_start(const model::Wave<ParameterJet>& g, double last, bool touched) {
  const model::Wave<ParameterJet> slope = model::derivative(g);
  const model::Wave<ParameterJet> curvature = model::derivative(slope);
  Trend all = Trend::above;
  std::vector<std::pair<double, double>> open{{0, last}};
  for (long count = 0; !open.empty(); ++count) {
    const auto [a, b] = open.back();
    open.pop_back();
    const Trend here = trend(a == 0 && touched ? over(slope, curvature, a, b) : over(g, slope, a, b));
    if (const Trend both = joined(all, here); both != Trend::unknown) {
      all = both;
      continue;
    }
    if (b - a < shortest_time || count > most_times) {
      return Trend::unknown;
    }
    const double middle = a + (b - a) / 2;
    open.emplace_back(middle, b);
    open.emplace_back(a, middle);
  }
  return all;
}

}  // namespace

Trend by_slope(const ParameterJet& g) {
  const Ball slope = g.partial(0);
  return slope.is_positive() ? Trend::rising : slope.is_negative() ? Trend::falling : Trend::unknown;
}

Trend joined(Trend a, Trend b) {
  return a == Trend::above ? b : b == Trend::above || a == b ? a : Trend::unknown;
}

Trend trend_of(const Requirement& q, const MotionOf<ParameterJet>& motion,
               const std::optional<ParameterJet>& ur) {
  const model::Parameters<ParameterJet>& a = motion.oscillator.data;
  const ParameterJet friction = ur.value_or(ParameterJet(0));
  if (q.quantity == Quantity::duration) {
    return trend(motion.phases.at(q.phase).duration);
  }
  if (q.quantity == Quantity::slipping_friction) {
    return trend(a.us);
  }
  if (q.quantity == Quantity::friction_step) {
    return trend(ParameterJet(friction - a.us));
  }
  const PhaseOf<ParameterJet>& phase = motion.phases.at(q.phase);
  const Affine<ParameterJet> form = affine_form<ParameterJet>(a, friction, q.quantity);
  if (!q.along) {
    return trend(
        ParameterJet(form.factor * model::friction_at<ParameterJet>(a, phase.Z, phase.load) + form.offset));
  }
  const model::PhaseWaves<ParameterJet> waves = waves_of<ParameterJet>(motion.oscillator, phase);
  const model::Wave<ParameterJet> g =
      model::affine<ParameterJet>(form.factor, form.of_speed ? waves.zdot2 : waves.r, form.offset);
  const double half = scalars::ends(phase.duration.value).second / 2;
  return joined(from_start(g, half, q.touches.start),
                from_start(model::reversed<ParameterJet>(g, phase.duration), half, q.touches.end));
}

}  // namespace stickslip::numeric::branches
