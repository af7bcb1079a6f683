#include <algorithm>

#include "numeric/zeros/search.hpp"
#include "proofs/kernel/balls.hpp"

namespace stickslip::proofs::kernel {

using namespace numeric::zeros;

namespace {

// f as a function of the column X, for Krawczyk's test and the search.
template <int N>
struct System {
  Variable X;
  Term f;
  bool strict;

  template <class T>
  Eigen::Matrix<T, N, 1> operator()(const Eigen::Matrix<T, N, 1>& x) const {
    const std::vector<T> values = evaluated<T>(f, {{X, std::vector<T>(x.begin(), x.end())}}, strict);
    Eigen::Matrix<T, N, 1> result;
    result.resize(x.size());
    std::copy(values.begin(), values.end(), result.begin());
    return result;
  }
};

bool lies_in(const Ball& ball, const Interval& side) {
  return ball.is_finite() && (ball - Ball(side.first)).is_positive() &&
         (Ball(side.second) - ball).is_positive();
}

template <int N>
bool lies_in(const numeric::zeros::Box<N>& balls, const Box& box) {
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!lies_in(balls(static_cast<Eigen::Index>(i)), box[i])) {
      return false;
    }
  }
  return true;
}

bool has_one_zero(const Variable& X, const Term& f, const Box& box) {
  constexpr int any_number = Eigen::Dynamic;
  numeric::zeros::Box<any_number> balls(static_cast<Eigen::Index>(box.size()));
  std::transform(box.begin(), box.end(), balls.begin(),
                 [](const Interval& side) { return Ball::from_interval(side.first, side.second); });
  const auto proof = krawczyk_test<any_number>(System<any_number>{X, f, true}, balls);
  return proof.verdict.truth == Truth::proved && lies_in<any_number>(proof.box, box);
}

// The domain in doubles, a little larger.
template <int N>
Cell<N> cell(const Box& box) {
  Cell<N> result;
  for (std::size_t i = 0; i < N; ++i) {
    const Ball side = Ball::from_interval(box[i].first, box[i].second);
    result.lower[i] = arf_get_d(arb_midref(side.lower().raw()), ARF_RND_FLOOR);
    result.upper[i] = arf_get_d(arb_midref(side.upper().raw()), ARF_RND_CEIL);
  }
  return result;
}

template <int N>
bool holds_all_zeros(const Variable& X, const Term& f, const Box& box, const std::vector<Box>& boxes) {
  using F = System<N>;
  const F system{X, f, false};
  const SearchResult<N> found =
      search<N>(cell<N>(box), KrawczykContractor<N, F>{system}, KrawczykDecider<N, F>{system});
  return found.complete() &&
         std::all_of(found.zeros.begin(), found.zeros.end(), [&](const FoundZero<N>& zero) {
           const numeric::zeros::Box<N> narrow = refine<N>([&] { return system; }, zero.zero, 60);
           return std::any_of(boxes.begin(), boxes.end(),
                              [&](const Box& one) { return lies_in<N>(narrow, one); });
         });
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

Theorem Theorem::every_zero(const Variable& X, const Term& f, const Box& box, const std::vector<Box>& boxes) {
  check_system(X, f, box);
  require(box.size() <= 4, "a search has at most 4 unknowns");
  std::vector<Formula> cases;
  Step step{.rule = "every_zero", .data = {X, f}};
  std::vector<Term> ends = flattened(box);
  for (const Box& one : boxes) {
    check(one, X);
    cases.push_back(inside(X, one));
    const std::vector<Term> more = flattened(one);
    ends.insert(ends.end(), more.begin(), more.end());
  }
  step.data.insert(step.data.end(), ends.begin(), ends.end());
  const std::size_t n = box.size();
  require(n == 1   ? holds_all_zeros<1>(X, f, box, boxes)
          : n == 2 ? holds_all_zeros<2>(X, f, box, boxes)
          : n == 3 ? holds_all_zeros<3>(X, f, box, boxes)
                   : holds_all_zeros<4>(X, f, box, boxes),
          "the search does not prove that the boxes hold every zero");
  return {step, {}, for_all(X, implies(all({inside(X, box), equal(f, zero(X.type))}), any(cases)))};
}

}  // namespace stickslip::proofs::kernel
