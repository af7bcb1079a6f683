#include "numeric/branches/curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/interruption.hpp"
#include "numeric/zeros/linear_solve.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::branches {

using namespace zeros;

namespace {

// Lengths along the curve, in which the interval of the parameter has the length 1, and an unknown its own
// size where that is above 1.
constexpr double first_step = 0x1p-7;
constexpr double longest_step = 0.5;
constexpr double shortest_step = 0x1p-36;
constexpr std::size_t most_cells_of_path = 3000;
// The parameter drives unless its share of the tangent is below the first; then until it is above the second.
constexpr double steep = 0.03;
constexpr double not_steep = 0.1;

Vector one(const Ball& x) {
  return Vector::Constant(1, x);
}

// The coordinates other than the driver, as the driven equations take them.
Vector others(int driver, const Point& point) {
  Vector y = point.x;
  if (driver != by_parameter) {
    y(driver) = point.value;
  }
  return y;
}
const Ball& coordinate(int driver, const Point& point) {
  return driver == by_parameter ? point.value : point.x(driver);
}

// The point in the cell's units.
Point seen_from(const Cell& cell, const Point& point) {
  return cell.in_units ? scaled_point(*cell.in_units->units, point) : point;
}

// Whether a motion at the point, in the cell's units, whose driver lies on the cell is that of the cell:
// proved, or not known.
bool is_the_only_one(const Cell& cell, const Point& point) {
  return contains(cell.proof.unique, others(cell.driver, point));
}

// A tangent of the curve near the point, by (x, parameter) in these units, its greatest entry ±1: a proposal.
// Empty where there is none.
Eigen::VectorXd tangent(const Curve& curve, const Point& point, const Eigen::VectorXd& units) {
  const auto n = static_cast<int>(point.x.size());
  VectorOf<ParameterJet> x(n);
  for (int i = 0; i < n; ++i) {
    x(i) = ParameterJet::variable(point.x(i).midpoint(), i, n + 1);
  }
  const VectorOf<ParameterJet> p = curve.data_at(ParameterJet::variable(point.value.midpoint(), n, n + 1));
  const VectorOf<ParameterJet> f = curve.equations.closing<ParameterJet>(x, p);
  Eigen::MatrixXd slope(n, n + 1);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= n; ++j) {
      slope(i, j) = f(i).partial(j).approximate() * units(j);
    }
    const double size = slope.row(i).cwiseAbs().maxCoeff();
    if (!(size > 0) || !std::isfinite(size)) {
      return {};
    }
    slope.row(i) /= size;
  }
  const Eigen::MatrixXd kernel = zeros::kernel(slope);
  Eigen::VectorXd t = kernel.col(0);
  const double size = t.cwiseAbs().maxCoeff();
  if (!(size > 0) || !std::isfinite(size)) {
    return {};
  }
  return t / size;
}

class Walk {
 public:
  Walk(const Curve& curve, const Rational& value, const Point& start)
      : curve_(curve),
        scale_(Rational(curve.to - curve.from).get_d()),
        start_(start),
        here_(start),
        exactly_(value) {}

  Path follow(int direction);

 private:
  // One cell further; false: as far as this goes.
  bool advance();
  bool step();
  bool turn_tangent();
  [[nodiscard]] bool try_cell(double length);
  [[nodiscard]] bool is_over();
  bool comes_back(const Cell& cell);
  [[nodiscard]] bool grows_far(const Cell& cell) const;
  void leave();

  const Curve& curve_;
  double scale_;
  Point start_, here_;
  Eigen::VectorXd tangent_, units_;  // see tangent()
  int driver_ = by_parameter;
  std::optional<Rational> exactly_;  // the driver's value here, where it is exact
  double step_ = first_step;
  bool left_start_ = false;
  Path path_;
};

// The tangent here, in the direction of the one before, and the driver that suits it. Along the last cell its
// driver rose or fell all the way, and goes on so here: other coordinates may have turned.
bool Walk::turn_tangent() {
  Eigen::VectorXd units(here_.x.size() + 1);
  for (int i = 0; i < here_.x.size(); ++i) {
    units(i) = std::max(1.0, std::abs(here_.x(i).approximate()));
  }
  units(here_.x.size()) = scale_;
  const Eigen::VectorXd t = tangent(curve_, here_, units);
  if (t.size() == 0) {
    return false;
  }
  units_ = units;
  const auto n = t.size() - 1;
  const auto drove = driver_ == by_parameter ? n : driver_;
  tangent_ = t(drove) * tangent_(drove) < 0 ? Eigen::VectorXd(-t) : t;
  const double share = std::abs(tangent_(n));
  int driver = by_parameter;
  if (share < (driver_ == by_parameter ? steep : not_steep)) {
    Eigen::Index k = 0;
    tangent_.head(n).cwiseAbs().maxCoeff(&k);
    const bool keep = driver_ != by_parameter && std::abs(tangent_(driver_)) > 0.3 * std::abs(tangent_(k));
    driver = keep ? driver_ : static_cast<int>(k);
  }
  if (driver != driver_) {
    driver_ = driver;
    exactly_.reset();
  }
  return true;
}

bool Walk::try_cell(double length) {
  const Driven f{&curve_, driver_};
  const auto n = tangent_.size() - 1;
  const auto rate = [&](int i) { return tangent_(i) * units_(i); };
  const double along = rate(driver_ == by_parameter ? static_cast<int>(n) : driver_);
  const double h = along * length;
  const Ball& now = coordinate(driver_, here_);
  Cell cell;
  cell.driver = driver_;
  // Where another coordinate drove before, its value here is no exact number: begin a little before it.
  const double aside = 0x1p-44 * std::max(1.0, std::abs(now.approximate())) + 4 * now.radius().approximate();
  cell.first = exactly_ ? *exactly_ : Rational(now.approximate() - std::copysign(aside, h));
  cell.last = Rational(now.approximate() + h);
  if (driver_ == by_parameter) {
    const Rational& end = h > 0 ? curve_.to : curve_.from;
    if (h > 0 ? cell.last > end : cell.last < end) {
      cell.last = end;
    }
    if (!exactly_) {
      cell.first = h > 0 ? std::max(cell.first, curve_.from) : std::min(cell.first, curve_.to);
    }
  }
  if (h > 0 ? cell.last <= cell.first : cell.last >= cell.first) {
    return false;
  }
  const double reach = Rational(cell.last).get_d() - now.approximate();
  const auto guess_at = [&](double ahead) {
    Vector y = others(driver_, here_);
    for (int i = 0; i < n; ++i) {
      const double r = i == driver_ ? rate(static_cast<int>(n)) : rate(i);
      y(i) = (y(i) + Ball(ahead * r / along)).midpoint();
    }
    return y;
  };
  cell.range = between(cell.first, cell.last);
  cell.proof = prove_over_parameters(f, one(cell.range), guess_at(reach / 2));
  if (cell.proof.verdict.truth != Truth::proved ||
      !(exactly_ ? is_the_only_one(cell, here_) : is_on(cell, here_))) {
    return false;
  }
  const Vector q = one(Ball(cell.last));
  const ZeroProof<Eigen::Dynamic> end = prove_zero_at(f, q, guess_at(reach));
  const Point next = point_of(f, end.box, q);
  if (end.verdict.truth != Truth::proved || !is_the_only_one(cell, next)) {
    return false;
  }
  here_ = next;
  exactly_ = cell.last;
  path_.cells.push_back(std::move(cell));
  return true;
}

bool Walk::advance() {
  if (interrupted()) {
    path_.reason = zeros::was_interrupted;
    return false;
  }
  if (path_.cells.size() >= most_cells_of_path) {
    path_.reason = "more cells are needed than are allowed";
    return false;
  }
  return step() && !is_over();
}

bool Walk::step() {
  if (!turn_tangent()) {
    path_.reason = "the curve has no tangent that could be computed here";
    return false;
  }
  for (; step_ > shortest_step; step_ /= 2) {
    if (try_cell(step_)) {
      step_ = std::min(step_ * 1.5, longest_step);
      return true;
    }
  }
  path_.reason = "no further step along the branch could be proved";
  return false;
}

bool Walk::is_over() {
  const Cell& cell = path_.cells.back();
  if ((cell.driver == by_parameter && (cell.last == curve_.to || cell.last == curve_.from)) ||
      (here_.value - Ball(curve_.to)).is_positive() || (here_.value - Ball(curve_.from)).is_negative()) {
    path_.end = End::interval;
    return true;
  }
  const Driven f{&curve_, by_parameter};
  const motion::Motion motion = f.motion<Ball>(here_.x, one(here_.value));
  if (std::any_of(motion.phases.begin(), motion.phases.end(),
                  [](const motion::Phase& phase) { return phase.duration.is_negative(); })) {
    path_.end = End::absent;
    return true;
  }
  if (grows_far(cell)) {
    leave();
    return true;
  }
  return comes_back(cell);
}

// Whether the start is on the cell again, its angle perhaps some turns further.
bool Walk::comes_back(const Cell& cell) {
  const bool at_start = for_some_turn(curve_.angle, start_, [&](const Point& start) {
    path_.back = coordinate(cell.driver, seen_from(cell, start));
    return is_on(cell, start);
  });
  if (at_start && left_start_) {
    path_.end = End::closed;
    path_.once_round = path_.cells.size();
    step();
    here_ = start_;
    return true;
  }
  left_start_ = left_start_ || !at_start;
  return false;
}

// Whether an unknown is more than far, and may grow on.
bool Walk::grows_far(const Cell& cell) const {
  const VectorOf<ParameterJet> x =
      Driven{&curve_, cell.driver}.split<ParameterJet>(cell.proof.x, cell.proof.p).x;
  for (int k = 0; k < x.size(); ++k) {
    const Ball growth = x(k).partial(0) * here_.x(k) * Ball(cell.first < cell.last ? 1 : -1);
    if (std::abs(here_.x(k).approximate()) > curve_.far && !growth.is_negative()) {
      return true;
    }
  }
  return false;
}

// For infinity, where that is proved.
void Walk::leave() {
  std::optional<WayToInfinity> way = way_to_infinity(curve_, path_.cells.back(), here_);
  if (!way) {
    path_.reason = "the motion grows to more than thirty times its size, perhaps beyond all bounds";
    return;
  }
  const bool outside =
      (way->limit - Ball(curve_.to)).is_positive() || (way->limit - Ball(curve_.from)).is_negative();
  path_.end = outside ? End::interval : End::infinite;
  path_.limit = way->limit;
  std::ranges::move(way->cells, std::back_inserter(path_.cells));
}

Path Walk::follow(int direction) {
  tangent_ = Eigen::VectorXd::Zero(here_.x.size() + 1);
  tangent_(here_.x.size()) = direction;
  const Rational& end = direction > 0 ? curve_.to : curve_.from;
  if (*exactly_ == end) {
    path_.end = End::interval;
  } else {
    while (advance()) {
    }
  }
  path_.last = here_;
  return std::move(path_);
}

}  // namespace

Point scaled_point(const Units& units, const Point& point) {
  Point scaled = point;
  const Ball e = Ball(units.sign) / point.x(units.place);
  for (const int k : units.growing) {
    scaled.x(k) = point.x(k) * e;
  }
  scaled.x(units.place) = e;
  return scaled;
}

Point unscaled_point(const Units& units, const Point& point) {
  Point own = point;
  const Ball& e = point.x(units.place);
  for (const int k : units.growing) {
    own.x(k) = point.x(k) / e;
  }
  own.x(units.place) = Ball(units.sign) / e;
  return own;
}

Point point_of(const Driven& f, const Vector& y, const Vector& q) {
  const Point point{f.split<Ball>(y, q).x, f.value<Ball>(y, q)};
  return f.curve->units ? unscaled_point(*f.curve->units, point) : point;
}

Vector motion_near(const ParametricProof& proof, const Rational& value) {
  const Ball ahead = (Ball(value) - proof.p0(0)).midpoint();
  Vector guess = proof.at_middle;
  for (int i = 0; i < guess.size(); ++i) {
    guess(i) = (guess(i) + proof.x(i).partial(0).midpoint() * ahead).midpoint();
  }
  return guess;
}

Ball between(const Rational& a, const Rational& b) {
  return a == b ? Ball(a) : Ball::from_interval(std::min(a, b), std::max(a, b));
}

bool is_on(const Cell& cell, const Point& point) {
  const Point here = seen_from(cell, point);
  return cell.range.contains(coordinate(cell.driver, here)) && is_the_only_one(cell, here);
}

bool may_meet(const Cell& cell, const Point& point) {
  const Point here = seen_from(cell, point);
  const Vector y = others(cell.driver, here);
  bool meets = cell.range.overlaps(coordinate(cell.driver, here));
  for (int i = 0; i < y.size(); ++i) {
    meets = meets && cell.proof.box(i).overlaps(y(i));
  }
  return meets;
}

ProvedPoint prove_at(const Curve& curve, const Rational& value, const Vector& guess) {
  const Driven f{&curve, by_parameter};
  const Vector q = one(Ball(value));
  const ZeroProof<Eigen::Dynamic> zero = prove_zero_at(f, q, guess);
  return {zero.verdict, point_of(f, zero.box, q)};
}

Path follow(const Curve& curve, const Rational& value, const Point& start, int direction) {
  return Walk(curve, value, start).follow(direction);
}

std::vector<Cell> reversed(std::vector<Cell> cells) {
  std::reverse(cells.begin(), cells.end());
  for (Cell& cell : cells) {
    std::swap(cell.first, cell.last);
  }
  return cells;
}

}  // namespace stickslip::numeric::branches
