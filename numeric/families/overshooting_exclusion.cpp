#include "numeric/families/overshooting_exclusion.hpp"

#include "numeric/families/end_rows.hpp"

namespace stickslip::numeric::families {

using namespace zeros;

// The odd rows are left C + right = 0: their determinant alone excludes most of the triangle.
std::optional<Box<2>> contract_by_odd_rows(const OddRows<OvershootingAtPhase>& o, const Box<2>& m,
                                           const Box<2>& X) {
  const BoxJet jet = det2<BoxJet>(o.over(0, 1), o.over(0, 3), o.over(1, 1), o.over(1, 3));
  if (jet.value.is_nonzero()) {
    return std::nullopt;
  }
  const Ball at_m = det2<Ball>(o.at_m(0, 1), o.at_m(0, 3), o.at_m(1, 1), o.at_m(1, 3));
  return contract_by<2>(at_m, Eigen::Matrix<Ball, 1, 2>(jet.partials[0], jet.partials[1]), m, X);
}

// omega = 1/k: the left sides vanish like (tau + tau1)³ and the right sides do not. Divided out.
bool excluded_at_origin(const OvershootingAtPhase& f, const Box<2>& X) {
  const Times<Ball> t = times<Ball>(f.data.Theta, X);
  const model::Modes<Ball>& m = f.data.m;
  const EndRows end{m, f.data.omega, t.tau + t.tau1};
  const auto odd = f.odd<Ball>(f.data, t);
  return end.applies() && odd(0, 3).is_nonzero() &&
         (end.left(m.omega1, m.lambda2) * odd(1, 3) - end.left(m.omega2, m.lambda1) * odd(0, 3)).is_nonzero();
}

// |sin psi| > 1 all over the box: sin psi ∓ 1, times the determinant of the odd rows in (C, sin psi), have
// the same sign.
std::optional<Box<2>> contract_by_odd_rows(const OddRows<OvershootingAtFriction>& o, const Box<2>& m,
                                           const Box<2>& X) {
  const auto range = [&](int sign) {
    const auto of = [sign](const auto& x) {
      using T = std::decay_t<decltype(x(0, 0))>;
      return T(det2<T>(x(0, 5), x(0, 1), x(1, 5), x(1, 1)) +
               T(sign) * det2<T>(x(0, 1), x(0, 4), x(1, 1), x(1, 4)));
    };
    const BoxJet jet = of(o.over);
    const Ball form = of(o.at_m) + jet.partials[0] * (X(0) - m(0)) + jet.partials[1] * (X(1) - m(1));
    return intersection(form, jet.value).value_or(form);
  };
  const Ball below = range(-1);
  const Ball above = range(1);
  if ((below.is_positive() && above.is_positive()) || (below.is_negative() && above.is_negative())) {
    return std::nullopt;
  }
  return X;
}

// omega = 1/k: the coefficients of C and sin psi vanish like t³, t = tau + tau1, and the rest does not.
bool excluded_at_origin(const OvershootingAtFriction& f, const Box<2>& X) {
  const Times<Ball> t = times<Ball>(f.data.Theta, X);
  const model::Modes<Ball>& m = f.data.m;
  const Ball total = t.tau + t.tau1;
  const EndRows end{m, f.data.omega, total};
  const auto odd = f.odd<Ball>(f.data, t);
  const Ball left1 = end.left(m.omega1, m.lambda2);
  const Ball left2 = end.left(m.omega2, m.lambda1);
  const Ball load1 = f.data.p * end.transfer(m.omega1, f.data.omega);
  const Ball load2 = f.data.p * end.transfer(m.omega2, f.data.omega);
  const Ball sine = abs(det2<Ball>(odd(0, 5), left1, odd(1, 5), left2));
  const Ball over = abs(det2<Ball>(left1, load1, left2, load2)) * total * total * total;
  return end.applies() && (sine - over).is_positive();
}

// Once a, C and D are eliminated each of the last three rows must hold for some |cos psi|, |sin psi| <= 1.
bool is_possible(const RowsOf<BoxJet, OvershootingAtFriction>& eliminated) {
  const Ball unit = Ball::hull(Ball(-1), Ball(1));
  for (int i = 3; i < 6; ++i) {
    const Ball sum = eliminated(i, 3).value * unit + eliminated(i, 4).value * unit + eliminated(i, 5).value;
    if (!sum.contains_zero()) {
      return false;
    }
  }
  return true;
}

}  // namespace stickslip::numeric::families
