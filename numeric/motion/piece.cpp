#include "numeric/motion/piece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stickslip::numeric::motion::pieces {

using namespace scalars;
using model::Harmonic;
using model::Wave;

namespace {

void sin_cos(const Ball& x, Ball& s, Ball& c) {
  arb_sin_cos(s.raw(), c.raw(), x.raw(), WorkingPrecision::bits());
}
void sin_cos(double x, double& s, double& c) {
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
    sin_cos(S(h.nu * t), s, c);
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

}  // namespace

Taylor<Ball> Piece::at(double s) const {
  return quotient<Ball>(side->g->at(s), weighted, s);
}

Taylor<double> Piece::guess_at(double s) const {
  return quotient<double>(side->g->guess_at(s), weighted, s);
}

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

double reach(double a, double c, double b) {
  return std::nextafter(std::max(b - c, c - a), std::numeric_limits<double>::infinity());
}

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

}  // namespace stickslip::numeric::motion::pieces

namespace stickslip::numeric::motion {

using namespace pieces;

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

}  // namespace stickslip::numeric::motion
