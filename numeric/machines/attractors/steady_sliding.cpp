#include "numeric/machines/attractors/steady_sliding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "numeric/machines/orbits/chain_proof.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using motion::ComplexBall;
using motion::PhaseKind;
using motion::StabilityKind;

namespace {

constexpr std::size_t values = 65;  // at first, of a datum
constexpr double resolution = 0x1p-30;

// The friction at a relative velocity, and how it changes there: not at an end of two pieces of the law.
struct Friction {
  int piece = 0;
  Ball force;
  std::optional<Ball> slope;
};
Friction friction_at(const model::FrictionLaw<Rational>& exact, const model::FrictionLaw<Ball>& law,
                     const Rational& velocity) {
  if (law.smooth) {
    return {0, law.smooth->force(Ball(velocity)), law.smooth->slope(Ball(velocity))};
  }
  std::size_t k = law.sliding.size() - 1;
  while (k > 0 && exact.sliding[k].from > velocity) {
    --k;
  }
  const model::SlidingPiece<Ball>& piece = law.sliding[k];
  return {static_cast<int>(k), piece.force + piece.slope * (Ball(velocity) - piece.from),
          velocity == exact.sliding[k].from ? std::nullopt : std::optional(piece.slope)};
}

// Whether the forces on some mass vary: where nothing but the belt moves they could not be balanced.
bool forces_vary(const model::FrictionOscillator<Rational>& o) {
  std::map<std::pair<std::size_t, int>, std::pair<Rational, Rational>> sums;
  for (const model::HarmonicForce<Rational>& load : o.loads) {
    auto& [cosine, sine] = sums[{load.mass, load.k}];
    cosine += load.cosine;
    sine += load.k == 0 ? Rational(0) : load.sine;
  }
  return std::ranges::any_of(sums, [](const auto& one) {
    return one.first.second != 0 && (one.second.first != 0 || one.second.second != 0);
  });
}

void decide(SteadySliding& state, const Matrix& A) {
  const auto found = motion::eigenvalues(A);
  if (!found) {
    state.reason = "the eigenvalues could not be enclosed";
    return;
  }
  state.eigenvalues = *found;
  std::ranges::stable_sort(state.eigenvalues, std::greater<>(),
                           [](const ComplexBall& mu) { return mu.re.approximate(); });
  const auto negative = [](const ComplexBall& mu) { return mu.re.is_negative(); };
  const auto positive = [](const ComplexBall& mu) { return mu.re.is_positive(); };
  if (std::ranges::all_of(state.eigenvalues, negative)) {
    state.stability = StabilityKind::stable;
  } else if (std::ranges::any_of(state.eigenvalues, positive)) {
    state.stability = StabilityKind::unstable;
  } else {
    state.reason = "an eigenvalue may lie on the imaginary axis";
  }
}

}  // namespace

SteadySliding steady_sliding(const Machine& machine, int digits) {
  require_machine(machine);
  const model::FrictionOscillator<Rational>& exact = machine.oscillator;
  SteadySliding state;
  if (forces_vary(exact)) {
    state.existence = Verdict::refuted("a load varies");
    return state;
  }
  if (exact.V == 0) {
    state.existence = Verdict::refuted("the belt stands still");
    return state;
  }
  const WorkingPrecision scope(scalars::bits_for(digits) + 64);
  const auto o = oscillator_as<Ball>(machine);
  const auto n = static_cast<Eigen::Index>(o.size());
  const auto j = static_cast<Eigen::Index>(o.rubbing);
  const int side = exact.V > 0 ? 1 : -1;
  const Rational velocity = abs(exact.V);
  const Friction friction = friction_at(exact.law(side), o.law(side), velocity);
  state.piece = Piece::sliding(side, friction.piece);
  state.friction = friction.force;
  Vector forces = Vector::Constant(n, Ball(0));
  for (const model::HarmonicForce<Ball>& load : o.loads) {
    forces(static_cast<Eigen::Index>(load.mass)) += load.k == 0 ? load.cosine : Ball(0);
  }
  forces(j) += Ball(side) * state.friction;
  const auto near = zeros::row_combinations(o.stiffness);
  const auto inverse = near ? enclosed_inverse(o.stiffness, *near) : std::nullopt;
  if (!inverse) {
    state.existence = Verdict::undecided("K may be singular: the machine is free to move");
    return state;
  }
  state.x = zeros::product(*inverse, forces);
  state.existence = Verdict::proved();
  if (!friction.slope) {
    state.reason = fmt::format("the relative velocity {} is where two pieces of the friction law meet",
                               to_string(velocity));
    return state;
  }
  Matrix A = LinearPhases(o).drift(state.piece).topLeftCorner(2 * n, 2 * n);
  if (o.law(side).smooth) {
    A(n + j, n + j) -= *friction.slope / o.masses[o.rubbing];
  }
  decide(state, A);
  return state;
}

SteadyAlong steady_sliding_along(const std::function<Machine(const Rational&)>& at, const Rational& from,
                                 const Rational& to, int digits) {
  if (from >= to) {
    throw UsageError(fmt::format("{}..{} does not rise: A..B needs A < B", to_string(from), to_string(to)));
  }
  using Sample = SteadyAlong::Sample;
  const auto sample = [&](const Rational& value) { return Sample{value, steady_sliding(at(value), digits)}; };
  const auto kind = [](const Sample& s) { return s.state.stability; };
  const auto is_known = [&](const Sample& s) {
    return kind(s) == StabilityKind::stable || kind(s) == StabilityKind::unstable;
  };
  SteadyAlong result;
  result.samples = parallel_map(values, [&](std::size_t k) {
    return sample(from + (to - from) * Rational(static_cast<long>(k)) / static_cast<long>(values - 1));
  });
  // Between neighbours that differ, as close as they get; where nothing is known, beside it.
  std::vector<Sample> more;
  const Sample * last = nullptr;
  for (const Sample& next : result.samples) {
    if (!is_known(next)) {
      continue;
    }
    std::optional<Sample> a = last != nullptr ? std::optional(*last) : std::nullopt;
    Sample b = next;
    while (a && kind(*a) != kind(b) && b.value - a->value > (to - from) * Rational(resolution)) {
      std::optional<Sample> m;
      for (const int sixteenths : {8, 7, 9}) {
        m = sample(a->value + (b.value - a->value) * sixteenths / 16);
        if (is_known(*m)) {
          break;
        }
      }
      if (!is_known(*m)) {
        break;
      }
      more.push_back(*m);
      (kind(*m) == kind(*a) ? *a : b) = *m;
    }
    if (a && kind(*a) != kind(b)) {
      const bool lost = kind(b) == StabilityKind::unstable;
      const std::vector<ComplexBall>& mu = (lost ? b : *a).state.eigenvalues;
      result.changes.push_back({a->value, b.value, lost, a->state.piece != b.state.piece, std::nullopt});
      if (!mu.front().im.contains_zero()) {
        result.changes.back().frequency = abs(mu.front().im);
      }
    }
    last = &next;
  }
  result.samples.insert(result.samples.end(), more.begin(), more.end());
  std::ranges::sort(result.samples, {}, &Sample::value);
  return result;
}

}  // namespace stickslip::numeric::machines
