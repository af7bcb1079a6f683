// Where a branch leaves for infinity.
//
// The friction law is homogeneous: a motion whose lengths, with us, V, p and ur, are all multiplied by e > 0
// obeys it as before, and the closing conditions are multiplied by e. In units in which one length of a large
// motion has the size 1, and e takes its place among the unknowns, they are finite at e = 0, where us, V and
// p vanish. Lengths that stay bounded are left as they are, and so are the conditions that do not depend on
// the growing ones, or these would vanish with e. Where all are regular at e = 0 the branch goes through
// there in these coordinates, and the motion grows beyond all bounds as e falls to 0.
#include <algorithm>
#include <cmath>

#include "numeric/branches/curve.hpp"

namespace stickslip::numeric::branches {

using namespace zeros;

namespace {

// How often the way to infinity is halved at most.
constexpr int most_halvings = 20;

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

bool all_last(const Driven& f, const Cell& cell) {
  const motion::Motion motion = f.motion<Ball>(cell.proof.box, Vector::Constant(1, cell.range));
  return std::all_of(motion.phases.begin(), motion.phases.end(),
                     [](const motion::Phase& phase) { return phase.duration.is_positive(); });
}

// In units in which the greatest of the growing unknowns has the size 1.
std::shared_ptr<const Curve> in_units(const Curve& curve, const Growth& growth, const Point& large) {
  const auto size = [&](int k) { return std::abs(large.x(k).approximate()); };
  const int place = *std::max_element(growth.growing.begin(), growth.growing.end(),
                                      [&](int a, int b) { return size(a) < size(b); });
  std::vector<int> of_data;
  const std::vector<std::string> names = curve.equations.parameter_names();
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == "us" || names[k] == "V" || names[k] == "p" || names[k] == "ur") {
      of_data.push_back(static_cast<int>(k));
    }
  }
  const int sign = large.x(place).is_positive() ? 1 : -1;
  auto scaled = std::make_shared<Curve>(curve);
  scaled->equations = Scaled{curve.equations, growth, of_data, place, sign};
  scaled->units = Units{place, sign, growth.growing};
  return scaled;
}

// A proved motion: e, and the others as the equations driven by it take them.
struct Here {
  Ball e;
  Vector y;
};

// The cell from here to that e, and the motion there.
std::optional<std::pair<Cell, Here>> step(const std::shared_ptr<const Curve>& curve, const Here& here,
                                          const Rational& from, const Rational& to) {
  const Driven f{curve.get(), curve->units->place};
  const Ball range = between(from, to);
  const Cell cell{f.driver, from, to, range, prove_over_parameters(f, Vector::Constant(1, range), here.y),
                  curve};
  if (cell.proof.verdict.truth != Truth::proved || !range.contains(here.e) ||
      !contains(cell.proof.unique, here.y) || !all_last(f, cell)) {
    return std::nullopt;
  }
  const ZeroProof<Eigen::Dynamic> end =
      prove_zero_at(f, Vector::Constant(1, Ball(to)), motion_near(cell.proof, to));
  if (end.verdict.truth != Truth::proved || !contains(cell.proof.unique, end.box)) {
    return std::nullopt;
  }
  return std::pair(cell, Here{Ball(to), end.box});
}

std::optional<WayToInfinity> way(const Curve& curve, const Growth& growth, const Cell& last,
                                 const Point& large) {
  const std::shared_ptr<const Curve> scaled = in_units(curve, growth, large);
  const int place = scaled->units->place;
  // Along the last cell the motions grow, so those in which e is less are others.
  const ParameterJet length =
      Driven{&curve, last.driver}.split<ParameterJet>(last.proof.x, last.proof.p).x(place);
  const int ahead = (last.first < last.last ? 1 : -1) * scaled->units->sign;
  if (!large.x(place).is_nonzero() || !(Ball(ahead) * length.partial(0)).is_positive()) {
    return std::nullopt;
  }
  const Point start = scaled_point(*scaled->units, large);
  Here here{start.x(place), start.x};
  here.y(place) = start.value;
  // Here e is no exact number: begin a little before it.
  Rational from(std::nextafter(here.e.upper().approximate(), HUGE_VAL));
  WayToInfinity way;
  for (int halvings = 0; halvings < most_halvings; ++halvings) {
    if (const auto whole = step(scaled, here, from, 0)) {
      way.cells.push_back(whole->first);
      way.limit = whole->second.y(place);
      return way;
    }
    const auto half = step(scaled, here, from, from / 2);
    if (!half) {
      return std::nullopt;
    }
    way.cells.push_back(half->first);
    here = half->second;
    from /= 2;
  }
  return std::nullopt;
}

}  // namespace

std::optional<WayToInfinity> way_to_infinity(const Curve& curve, const Cell& cell, const Point& large) {
  for (const Growth& growth : curve.growths) {
    if (std::optional<WayToInfinity> found = way(curve, growth, cell, large)) {
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace stickslip::numeric::branches
