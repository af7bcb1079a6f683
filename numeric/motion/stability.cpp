#include "numeric/motion/stability.hpp"

#include <algorithm>

#include "core/names.hpp"
#include "numeric/motion/multipliers.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::motion {
namespace {

constexpr std::size_t states = 4;
constexpr const char * not_enclosed = "the multipliers could not be enclosed";

// With a stick, the map seen where the stick begins: there z2' = V, so z1, z2, z1' are all that can deviate.
SquareMatrix reduced_monodromy(const Motion& motion) {
  const std::vector<std::size_t> sticks = sticks_of(motion);
  if (sticks.empty()) {
    return monodromy<Ball>(motion);
  }
  const model::Matrix4<Ball> M = monodromy<Ball>(motion, sticks.front());
  return M.topLeftCorner<3, 3>();
}

// The integer is a multiplier: make the one enclosure that can hold it exact. False when several can.
bool set_exact(std::vector<ComplexBall>& multipliers, int value) {
  const auto may_be_it = [value](const ComplexBall& mu) {
    return mu.re.overlaps(Ball(value)) && mu.im.contains_zero();
  };
  if (std::count_if(multipliers.begin(), multipliers.end(), may_be_it) != 1) {
    return false;
  }
  *std::find_if(multipliers.begin(), multipliers.end(), may_be_it) = {Ball(value), Ball(0)};
  return true;
}

bool is_exactly_one(const ComplexBall& mu) {
  return (mu.re - Ball(1)).is_exact() && (mu.re - Ball(1)).contains_zero() && mu.im.is_exact() &&
         mu.im.contains_zero();
}

// Also for enclosures of no order.
void classify(Stability& s, bool neutral) {
  const auto outside = [](const ComplexBall& mu) { return (mu.squared_modulus() - Ball(1)).is_positive(); };
  const auto inside = [&](const ComplexBall& mu) {
    return (mu.squared_modulus() - Ball(1)).is_negative() || (neutral && is_exactly_one(mu));
  };
  if (std::any_of(s.multipliers.begin(), s.multipliers.end(), outside)) {
    s.kind = StabilityKind::unstable;
  } else if (!std::all_of(s.multipliers.begin(), s.multipliers.end(), inside)) {
    s.reason = "the enclosure of a multiplier meets the unit circle";
  } else if (neutral) {
    s.kind = StabilityKind::marginal;
    s.reason = "without load each shift in time of the orbit is an orbit, so 1 is a multiplier";
  } else {
    s.kind = StabilityKind::stable;
  }
}

// For each symmetric member: with the inverse Y of a Cholesky factor, exact numbers, |Y S Yᵀ - I| < 1.
bool is_positive_definite(const SquareMatrix& S) {
  const auto factor = zeros::cholesky(zeros::in_double(S));
  if (!factor) {
    return false;
  }
  const SquareMatrix Y = zeros::inverse(*factor).unaryExpr([](double x) { return Ball(x); });
  const SquareMatrix E = SquareMatrix(zeros::product(zeros::product(Y, S), SquareMatrix(Y.transpose()))) -
                         SquareMatrix(SquareMatrix::Identity(S.rows(), S.cols()));
  return (Ball(1) - zeros::norm(E)).is_positive();
}

// Whether P and P - Mᵀ P M are positive definite for a P (Stein): then all multipliers are inside the unit
// circle, however many of them are too near to each other to be told apart. P = I + Mᵀ M + (M²)ᵀ M² + …, in
// double, twice as many terms each time.
bool are_inside_unit_circle(const SquareMatrix& map) {
  constexpr int most_doublings = 40;
  Eigen::MatrixXd power = zeros::in_double(map);
  const Eigen::Index n = power.rows();
  Eigen::MatrixXd P = Eigen::MatrixXd::Identity(n, n);
  for (int k = 0; k < most_doublings && P.allFinite() && power.norm() > 1e-20; ++k) {
    P += Eigen::MatrixXd(power.transpose().lazyProduct(P)).lazyProduct(power).eval();
    power = Eigen::MatrixXd(power.lazyProduct(power));
  }
  if (!P.allFinite() || !(power.norm() <= 1e-20)) {
    return false;
  }
  const SquareMatrix exact =
      Eigen::MatrixXd((P + P.transpose()) / 2).unaryExpr([](double x) { return Ball(x); });
  return is_positive_definite(exact) &&
         is_positive_definite(exact - SquareMatrix(zeros::product(SquareMatrix(map.transpose()),
                                                                  SquareMatrix(zeros::product(exact, map)))));
}

}  // namespace

std::string to_string(StabilityKind kind) {
  return name_of<StabilityKind::undecided>(kind, "stable", "unstable", "marginal", "undecided");
}

Stability stability_of(const SquareMatrix& return_map, bool collapses) {
  Stability s;
  s.reason = not_enclosed;
  if (const auto found = eigenvalues(return_map)) {
    s.reason.clear();
    s.multipliers = *found;
    if (collapses) {
      set_exact(s.multipliers, 0);
    }
    classify(s, false);
  }
  if (s.kind == StabilityKind::undecided && are_inside_unit_circle(return_map)) {
    return {StabilityKind::stable, {}, {}};
  }
  return s;
}

Stability decide_stability(const Motion& motion) {
  Stability s;
  const SquareMatrix M = reduced_monodromy(motion);
  if (!std::all_of(M.data(), M.data() + M.size(), [](const Ball& entry) { return entry.is_finite(); })) {
    s.reason = "an event may not be transversal: the derivative of the map is unbounded";
    return s;
  }
  const auto found = eigenvalues(M);
  if (!found) {
    s.reason = not_enclosed;
    return s;
  }
  s.multipliers = *found;
  const Ball& p = motion.oscillator.data.p;
  const bool without_load = p.is_exact() && p.contains_zero();
  const bool neutral = without_load && set_exact(s.multipliers, 1);
  s.multipliers.resize(states, {Ball(0), Ball(0)});
  classify(s, neutral);
  return s;
}

std::optional<Contact> contact_of(const std::vector<Condition>& conditions) {
  std::optional<Contact> nearest;
  for (const Condition& c : conditions) {
    if (c.verdict.truth != Truth::proved) {
      return std::nullopt;
    }
    if (!c.at || !c.margin) {
      continue;
    }
    if (!nearest) {
      nearest = {c.id, *c.margin, *c.at};
      continue;
    }
    if (c.margin->approximate() < nearest->margin.approximate()) {
      nearest->condition = c.id;
      nearest->at = *c.at;
    }
    arb_min(nearest->margin.raw(), nearest->margin.raw(), c.margin->raw(), WorkingPrecision::bits());
  }
  return nearest;
}

}  // namespace stickslip::numeric::motion
