#include "numeric/motion/infimum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace stickslip::numeric::motion {

using namespace scalars;
using model::Harmonic;
using model::Wave;

namespace {

void sine_and_cosine(const Ball& x, Ball& s, Ball& c) {
  arb_sin_cos(s.raw(), c.raw(), x.raw(), WorkingPrecision::bits());
}
void sine_and_cosine(double x, double& s, double& c) {
  s = std::sin(x);
  c = std::cos(x);
}

// g, g', g'', g''' at t.
template <class S>
std::array<S, 4> derivatives(const Wave<S>& g, const S& t) {
  std::array<S, 4> d{g.constant, g.slope, S(0), S(0)};
  add_product(d[0], g.slope, t);
  S s(0);
  S c(0);
  for (int k = 0; k < g.count; ++k) {
    const Harmonic<S>& h = g.harmonics[static_cast<unsigned>(k)];
    sine_and_cosine(S(h.nu * t), s, c);
    S p = h.a * c;
    add_product(p, h.b, s);
    S q = h.b * c;
    subtract_product(q, h.a, s);
    q *= h.nu;
    const S square = h.nu * h.nu;
    d[0] += p;
    d[1] += q;
    subtract_product(d[2], square, p);
    subtract_product(d[3], square, q);
  }
  return d;
}

// A function and its first two derivatives at a point.
template <class S>
struct Taylor {
  S value, slope, curvature;
};

// g/w, with w = s or 1.
template <class S>
Taylor<S> quotient(const std::array<S, 4>& d, bool weighted, double s) {
  if (!weighted) {
    return {d[0], d[1], d[2]};
  }
  if (s == 0) {
    return {d[1], d[2] / S(2), d[3] / S(3)};
  }
  const S k = d[0] / S(s);
  const S k1 = (d[1] - k) / S(s);
  return {k, k1, (d[2] - S(2) * k1) / S(s)};
}

Wave<double> approximate(const Wave<Ball>& g) {
  Wave<double> w;
  w.constant = g.constant.approximate();
  w.slope = g.slope.approximate();
  for (int k = 0; k < g.count; ++k) {
    const Harmonic<Ball>& h = g.harmonics[static_cast<unsigned>(k)];
    w.add(h.nu.approximate(), h.a.approximate(), h.b.approximate());
  }
  return w;
}

// The time s counts from that end of the phase.
struct Side {
  const Course * g;
  bool from_end;
};

// g/w on [a, b] of a side, w = s when weighted and 1 otherwise; `third` bounds the third derivative of g/w.
// For g(0) = 0: g(s)/s is the mean of g'(s x) over 0 < x < 1, so its n-th derivative is the mean of
// x^n g^(n+1)(s x), at most max |g^(n+1)|/(n+1), and g^(n+1)(0)/(n+1) at s = 0.
struct Piece {
  const Side * side;
  bool weighted;
  double a, b;
  Ball third;

  // g/w and its first two derivatives at s.
  [[nodiscard]] Taylor<Ball> at(double s) const {
    if (weighted && s > 0) {
      const auto k = side->g->quotient_at(s);
      return {k[0], k[1], k[2]};
    }
    return quotient<Ball>(side->g->at(s), weighted, s);
  }
  // The same in floating point: only a guess.
  [[nodiscard]] Taylor<double> guess_at(double s) const {
    return quotient<double>(side->g->guess_at(s), weighted, s);
  }
  // A guess of where the piece is smallest near s, within [low, high].
  [[nodiscard]] double descend(double s, double low, double high) const;
};

double Piece::descend(double s, double low, double high) const {
  for (int i = 0; i < 6; ++i) {
    const Taylor<double> k = guess_at(s);
    double step = k.curvature > 0 ? -k.slope / k.curvature : (k.slope > 0 ? low - s : high - s);
    if (!std::isfinite(step)) {
      return s;
    }
    const double next = std::clamp(s + step, low, high);
    if (std::abs(next - s) <= 1e-16 * (1 + std::abs(s))) {
      return next;
    }
    s = next;
  }
  return s;
}

// A guess of where the piece is smallest.
struct Guess {
  double value, s;
};
Guess sampled_minimum(const Piece& piece) {
  const int n = 4 + static_cast<int>(2 * (piece.b - piece.a));
  const double step = (piece.b - piece.a) / n;
  double best = std::numeric_limits<double>::infinity();
  double where = piece.a;
  for (int i = 0; i <= n; ++i) {
    const double s = i == n ? piece.b : piece.a + i * step;
    const double k = piece.guess_at(s == 0 ? 0 : std::max(s, 1e-6)).value;
    if (k < best) {
      best = k;
      where = s;
    }
  }
  const double low = std::max(piece.a, where - step);
  const double high = std::min(piece.b, where + step);
  where = piece.descend(where, low, high);
  return {piece.guess_at(where).value, where};
}

}  // namespace

std::array<Ball, 3> Course::quotient_at(double s) const {
  const Taylor<Ball> k = quotient<Ball>(at(s), true, s);
  return {k.value, k.slope, k.curvature};
}

WaveCourse::WaveCourse(const Wave<Ball>& g) : g_(g), guess_(approximate(g)) {}

std::array<Ball, 4> WaveCourse::at(double s) const {
  return derivatives<Ball>(g_, Ball(s));
}

std::array<double, 4> WaveCourse::guess_at(double s) const {
  return derivatives<double>(guess_, s);
}

DerivativeBounds WaveCourse::bounds() const {
  DerivativeBounds sum;
  for (int k = 0; k < g_.count; ++k) {
    const Harmonic<Ball>& h = g_.harmonics[static_cast<unsigned>(k)];
    Ball amplitude = sqrt(h.a * h.a + h.b * h.b);
    if (!amplitude.is_finite()) {  // both contain zero
      amplitude = abs(h.a) + abs(h.b);
    }
    const Ball term = abs(amplitude * h.nu * h.nu * h.nu);
    sum.third += term;
    sum.fourth += term * abs(h.nu);
  }
  return {sum.third.upper(), sum.fourth.upper()};
}

namespace {

class Search {
 public:
  Search(const Ball& T, double last) : T_(T), last_(last) {}

  // A value that g/w takes, so the infimum is at most its upper end. A time past the end of a phase of
  // uncertain length is replaced by the last one that is certain.
  void offer(const Piece& piece, double s, const Ball& value, const Ball& around) {
    if (s > last_) {
      return offer(piece, last_, piece.at(last_).value, Ball(last_));
    }
    if (!value.is_finite() || (found_ && (value.upper() - best_.upper()).is_positive())) {
      return;
    }
    found_ = true;
    best_ = value;
    target_ = value.lower();
    time_ = piece.side->from_end ? T_ - around : around;
  }

  // Where the infimum is likely to be.
  void propose(const Piece& piece, double s) {
    proposal_ = {&piece, s};
    offer(piece, s, piece.at(s).value, Ball(s));
  }

  void cover(const Piece& piece) {
    leaves_.clear();
    const int n = 1 + static_cast<int>(piece.b - piece.a);
    for (int i = 0; i < n; ++i) {
      const double step = (piece.b - piece.a) / n;
      leaves_.emplace_back(piece.a + i * step, i + 1 == n ? piece.b : piece.a + (i + 1) * step);
    }
    while (!leaves_.empty()) {
      const auto [a, b] = leaves_.back();
      leaves_.pop_back();
      ++examined_;
      if (!settle(piece, a, b)) {
        const double middle = a + (b - a) / 2;
        leaves_.emplace_back(a, middle);
        leaves_.emplace_back(middle, b);
      }
    }
  }

  [[nodiscard]] Infimum result() const {
    if (!found_ || !floor_ || !floor_->is_finite()) {
      Ball everything;
      arb_zero_pm_inf(everything.raw());
      return {everything, T_, {}, {}};
    }
    return {Ball::hull(*floor_, best_.upper()), time_, {}, {}};
  }

 private:
  void accept(const Ball& lower) {
    if (!floor_ || !lower.is_finite() || (*floor_ - lower).is_positive()) {
      floor_ = lower;
    }
  }

  // Takes g/w at s, where the least value of [a, b] is known to be, as that least value.
  bool accept_end(const Piece& piece, double s) {
    const Ball k = piece.at(s).value;
    offer(piece, s, k, Ball(s));
    accept(k.lower());
    return true;
  }

  bool settle(const Piece& piece, double a, double b);
  bool settle_convex(const Piece& piece, double a, double b, const Ball& curvature);

  Ball T_;
  double last_;
  bool found_ = false;
  Ball best_, target_, time_;
  std::optional<Ball> floor_;
  std::pair<const Piece *, double> proposal_{nullptr, 0};
  std::vector<std::pair<double, double>> leaves_;
  int examined_ = 0;
};

// Bounds g/w on [a, b] from below well enough; false: split it.
bool Search::settle(const Piece& piece, double a, double b) {
  const bool one_sided = piece.weighted && a == 0;
  const double c = one_sided ? 0 : a + (b - a) / 2;
  const Ball h(reach(a, c, b));
  const Taylor<Ball> k = piece.at(c);
  const Ball spread = piece.third * h * h * h / Ball(6);
  const Ball lowest_slope = one_sided ? k.slope.lower() : -abs(k.slope).upper();
  Ball lower = k.value - spread;
  if (!lowest_slope.is_positive()) {
    lower += lowest_slope * h;
  }
  if (!k.curvature.is_positive()) {
    lower += k.curvature.lower() * h * h / Ball(2);
  } else {
    const Ball vertex = k.value - k.slope * k.slope / (Ball(2) * k.curvature) - spread;
    lower = (vertex.lower() - lower.lower()).is_positive() ? vertex : lower;
  }
  lower = lower.lower();
  if (found_ && !(lower - target_).is_negative()) {
    accept(lower);
    return true;
  }
  // Splitting gains nothing any more once the width of the data dominates, or lower is not finite at all.
  const bool spent = b - a < 1e-9 || examined_ > 4000 || !lower.is_finite();
  if (spent || !(k.value.lower() - lower - k.value.radius()).is_positive()) {
    offer(piece, c, k.value, Ball(c));
    accept(lower);
    return true;
  }
  const Ball sway = piece.third * h;
  const Ball curvature_low = (k.curvature - sway).lower();
  if (curvature_low.is_positive()) {
    return settle_convex(piece, a, b, Ball::hull(curvature_low, (k.curvature + sway).upper()));
  }
  const Ball slope_change = (abs(k.curvature) + sway / Ball(2)) * h;
  if ((k.slope - slope_change).is_positive()) {
    return accept_end(piece, a);
  }
  if ((k.slope + slope_change).is_negative()) {
    return accept_end(piece, b);
  }
  if ((k.curvature + sway).is_negative()) {
    return accept_end(piece, a) && accept_end(piece, b);
  }
  return false;
}

// g/w on [a, b], whose second derivative stays in the positive ball `curvature`: with k at s,
// g/w >= k + k' (x - s) + c (x - s)²/2 >= k - k'²/(2c), and its minimiser in the interior is s - k'/c.
bool Search::settle_convex(const Piece& piece, double a, double b, const Ball& curvature) {
  const bool proposed = proposal_.first == &piece && a <= proposal_.second && proposal_.second <= b;
  const double s = proposed ? proposal_.second : piece.descend(a + (b - a) / 2, a, b);
  const Taylor<Ball> k = piece.at(s);
  Ball lower = k.value - k.slope * k.slope / (Ball(2) * curvature);
  const bool at_a = s == a && !k.slope.is_negative() && !k.slope.contains_zero();
  const bool at_b = s == b && k.slope.is_negative();
  Ball around(s);
  if (at_a || at_b) {
    lower = k.value;
  } else {
    // The whole leaf when Newton's image leaves it: then the minimiser may be at an end of it.
    const Ball newton = Ball(s) - k.slope / curvature;
    const bool inside =
        !(newton.lower() - Ball(a)).is_negative() && !(Ball(b) - newton.upper()).is_negative();
    around = inside ? newton : Ball(s);
  }
  offer(piece, s, k.value, around);
  accept(lower.lower());
  return true;
}

void add_pieces(std::vector<Piece>& pieces, const Side& side, const DerivativeBounds& bounds, bool touched,
                double length) {
  if (!touched) {
    pieces.push_back({&side, false, 0, length, bounds.third});
    return;
  }
  const double collar = std::min(1.0, length);
  pieces.push_back({&side, true, 0, collar, bounds.fourth / Ball(4)});
  if (length > collar) {
    pieces.push_back({&side, false, collar, length, bounds.third});
  }
}

}  // namespace

Infimum weighted_infimum(const Wave<Ball>& g, const Ball& T, Touches touches) {
  const WaveCourse course(g);
  return weighted_infimum(course, WaveCourse(reversed(g, T)), course.bounds(), T, touches);
}

Infimum weighted_infimum(const Course& g, const Course& reversed, const DerivativeBounds& bounds,
                         const Ball& T, Touches touches) {
  const auto [last, longest] = ends(T);
  const double half = std::nextafter(longest / 2, std::numeric_limits<double>::infinity());
  Search search(T, last);
  const auto finish = [&] {
    Infimum found = search.result();
    found.start = g.at(0)[0];
    found.end = reversed.at(0)[0];
    return found;
  };
  if (!(last > 0) || !(half < last)) {
    return finish();
  }
  // Each end is looked at from itself, for a phase of uncertain length is best known there; a single touched
  // end sees the whole phase, so that w is the distance to it wherever that is below 1.
  const Side start{&g, false};
  const Side end{&reversed, true};
  std::vector<Piece> all;
  if (touches.start == touches.end) {
    add_pieces(all, start, bounds, touches.start, half);
    add_pieces(all, end, bounds, touches.end, half);
  } else {
    add_pieces(all, touches.start ? start : end, bounds, true, longest);
  }
  const Piece * best = nullptr;
  Guess lowest{};
  for (const Piece& piece : all) {
    const Guess guess = sampled_minimum(piece);
    if (best == nullptr || guess.value < lowest.value) {
      best = &piece;
      lowest = guess;
    }
  }
  if (std::isfinite(lowest.s)) {
    search.propose(*best, lowest.s);
  }
  for (const Piece& piece : all) {
    search.cover(piece);
  }
  return finish();
}

std::optional<Violation> violation(const Course& g, const Ball& T, const Ball& near) {
  const double last = ends(T).first;
  double t = near.approximate();
  const bool at_start = !(t > 0);
  const bool at_end = !(t < last);
  for (double step = 0.25 * last; step > 1e-12 * last; step /= 2) {
    const double inside = at_start ? step : (at_end ? last - step : t);
    const Ball value = g.at(inside)[0];
    if (value.is_negative()) {
      return Violation{Ball(inside), value};
    }
    if (!at_start && !at_end) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace stickslip::numeric::motion
