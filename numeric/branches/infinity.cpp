#include "numeric/branches/infinity.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip::numeric::branches {

using namespace zeros;

namespace {

// How often the way to infinity is halved at most.
constexpr int most_steps = 20;

// The closing conditions in the scaled lengths, e in the place of the length that is `sign`.
struct Scaled {
  motion::Closing equations;
  Growth growth;
  std::vector<int> of_data;  // the lengths among these
  int place;
  int sign;
  static constexpr bool takes_phi = false, takes_ur = false;  // the data are laid out as the equations'

  template <class T>
  [[nodiscard]] std::pair<VectorOf<T>, VectorOf<T>> scaled(const VectorOf<T>& x, const VectorOf<T>& p) const {
    std::pair<VectorOf<T>, VectorOf<T>> s{x, p};
    s.first(place) = T(sign);
    for (const int k : growth.bounded) {
      s.first(k) = x(place) * x(k);
    }
    for (const int k : of_data) {
      s.second(k) = x(place) * p(k);
    }
    return s;
  }
  template <class T>
  [[nodiscard]] VectorOf<T> closing(const VectorOf<T>& x, const VectorOf<T>& p) const {
    const auto [y, q] = scaled<T>(x, p);
    VectorOf<T> f = equations.closing<T>(y, q);
    if (!growth.free_rows.empty()) {
      const VectorOf<T> g = equations.closing<T>(x, p);  // whatever stands for the growing unknowns
      for (const int row : growth.free_rows) {
        f(row) = g(row);
      }
    }
    return f;
  }
  template <class T>
  [[nodiscard]] motion::MotionOf<T> motion(const VectorOf<T>& x, const VectorOf<T>& p) const {
    const auto [y, q] = scaled<T>(x, p);
    return equations.motion<T>(y, q);
  }
  [[nodiscard]] Vector unknowns(const motion::Motion& motion) const { return equations.unknowns(motion); }
};

// The cell over 0 <= e <= last or a part of that.
Cell cell_over(const Driven& f, const Rational& first, const Rational& last, const Vector& guess) {
  const Ball range = between(first, last);
  return {f.driver, first, last, range, prove_over_parameters(f, Vector::Constant(1, range), guess)};
}

bool all_last(const Driven& f, const Cell& cell) {
  const motion::Motion motion = f.motion<Ball>(cell.proof.box, Vector::Constant(1, cell.range));
  return std::all_of(motion.phases.begin(), motion.phases.end(),
                     [](const motion::Phase& phase) { return phase.duration.is_positive(); });
}

// Whether the parameter moves one way all along the cell; not whether the same way as along others.
bool moves(const Driven& f, const Cell& cell) {
  return f.value<ParameterJet>(cell.proof.x, cell.proof.p).partial(0).is_nonzero();
}

std::optional<Limit> limit(const Curve& curve, const Growth& growth, const Point& large) {
  const auto size = [&](int k) { return std::abs(large.x(k).approximate()); };
  const auto most = std::max_element(growth.growing.begin(), growth.growing.end(),
                                     [&](int a, int b) { return size(a) < size(b); });
  if (!large.x(*most).is_nonzero()) {
    return std::nullopt;
  }
  const int place = *most;
  std::vector<int> of_data;
  const std::vector<std::string> names = curve.equations.parameter_names();
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == "us" || names[k] == "V" || names[k] == "p" || names[k] == "ur") {
      of_data.push_back(static_cast<int>(k));
    }
  }
  const int sign = large.x(place).is_positive() ? 1 : -1;
  Curve scaled = curve;
  scaled.equations = Scaled{curve.equations, growth, of_data, place, sign};
  // The motion in these coordinates.
  Point here = large;
  const Ball e = Ball(sign) / large.x(place);
  for (const int k : growth.growing) {
    here.x(k) = large.x(k) * e;
  }
  here.x(place) = e;
  const Driven f{&scaled, place};
  Rational last(std::nextafter(e.upper().approximate(), HUGE_VAL));
  bool may_turn = false;
  for (int step = 0; step < most_steps; ++step) {
    Vector guess = here.x;
    guess(place) = here.value;
    const Cell whole = cell_over(f, 0, last, guess);
    if (whole.proof.verdict.truth == Truth::proved && is_on(whole, here) && all_last(f, whole)) {
      const Vector q = Vector::Constant(1, Ball(0));
      const ZeroProof<Eigen::Dynamic> end = prove_zero_at(f, q, motion_near(whole.proof, 0));
      const Point there = point_of(f, end.box, q);
      if (end.verdict.truth != Truth::proved || !is_on(whole, there)) {
        return std::nullopt;
      }
      return Limit{there.value, may_turn || !moves(f, whole)};
    }
    const Rational middle = last / 2;
    const Cell half = cell_over(f, middle, last, guess);
    if (half.proof.verdict.truth != Truth::proved || !is_on(half, here) || !all_last(f, half)) {
      return std::nullopt;
    }
    const Vector q = Vector::Constant(1, Ball(middle));
    const ZeroProof<Eigen::Dynamic> end = prove_zero_at(f, q, motion_near(half.proof, middle));
    here = point_of(f, end.box, q);
    if (end.verdict.truth != Truth::proved || !is_on(half, here)) {
      return std::nullopt;
    }
    may_turn = may_turn || !moves(f, half);
    last = middle;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Limit> limit_at_infinity(const Curve& curve, const Point& large) {
  for (const Growth& growth : curve.growths) {
    if (const std::optional<Limit> found = limit(curve, growth, large)) {
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace stickslip::numeric::branches
