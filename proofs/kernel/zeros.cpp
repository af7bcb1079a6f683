#include <algorithm>

#include "numeric/zeros/krawczyk.hpp"
#include "proofs/kernel/balls.hpp"

namespace stickslip::proofs::kernel {

using namespace numeric::zeros;

namespace {

// f as a function of the column X, for Krawczyk's test.
struct System {
  Variable X;
  Term f;

  template <class T>
  Eigen::VectorX<T> operator()(const Eigen::VectorX<T>& x) const {
    const std::vector<T> values = evaluated<T>(f, {{X, std::vector<T>(x.begin(), x.end())}});
    return Eigen::Map<const Eigen::VectorX<T>>(values.data(), x.size());
  }
};

bool lies_in(const Ball& ball, const Interval& side) {
  return ball.is_finite() && (ball - Ball(side.first)).is_positive() &&
         (Ball(side.second) - ball).is_positive();
}

bool has_one_zero(const Variable& X, const Term& f, const Box& box) {
  numeric::zeros::Box<Eigen::Dynamic> balls(static_cast<Eigen::Index>(box.size()));
  std::transform(box.begin(), box.end(), balls.begin(),
                 [](const Interval& side) { return Ball::from_interval(side.first, side.second); });
  const auto proof = krawczyk_test<Eigen::Dynamic>(System{X, f}, balls);
  return proof.verdict.truth == Truth::proved &&
         std::equal(box.begin(), box.end(), proof.box.begin(),
                    [](const Interval& side, const Ball& ball) { return lies_in(ball, side); });
}

void check_system(const Variable& X, const Term& f, const Box& box) {
  check(box, X);
  require(f.is_closed() && f.type().is_numeric() && f.type().rows == X.type.rows && f.type().columns == 1,
          "a system has as many equations as unknowns");
  require(std::all_of(f.variables().begin(), f.variables().end(), [&](const Variable& v) { return v == X; }),
          "a system has no variable but its unknown");
}

}  // namespace

Theorem Theorem::one_zero(const Variable& X, const Term& f, const Box& box, long bits) {
  check_system(X, f, box);
  require(bits >= 2 && bits <= 100000, "the precision is 2 to 100000 bits");
  const WorkingPrecision scope(bits);
  require(has_one_zero(X, f, box), "Krawczyk's test does not prove that the box holds exactly one zero");
  Step step{.rule = "one_zero", .data = {X, f, bits}};
  const std::vector<Term> ends = flattened(box);
  step.data.insert(step.data.end(), ends.begin(), ends.end());
  return {step, {}, exactly_one(X, box, equal(f, zero(X.type)))};
}

}  // namespace stickslip::proofs::kernel
