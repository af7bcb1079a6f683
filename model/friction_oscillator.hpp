// Any number of masses with springs and dashpots, one of which rubs on a moving belt: linear but for a
// friction that depends on the relative velocity, piecewise linearly or smoothly.
//
//   m_i x_i'' + (C x')_i + (K x)_i = F_i(t) + u at the rubbing mass j, with the belt's velocity V and
//   the friction at rest r = (C x' + K x)_j - F_j(t):
//     slip,      x_j' < V   u =  f(V - x_j'), f the sliding friction of the side on which the belt pulls
//     overshoot, x_j' > V   u = -g(x_j' - V), g that of the other side
//     stick,     x_j' = V   u = r, as long as r is between minus the friction at rest of the other side and
//                           that of the first
// (2), (4) are the case of two masses, C = 0 and f = g = us.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "model/parameters.hpp"

namespace stickslip::model {

template <class S>
using VectorX = Eigen::Matrix<S, Eigen::Dynamic, 1>;
template <class S>
using MatrixX = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

// force + slope (v - from) for relative velocities v from `from` to where the next piece begins.
template <class S>
struct SlidingPiece {
  S from, force, slope;
};

// A friction that changes smoothly with the relative velocity v: last + (first - last) s(v/scale) + viscous
// v, s(y) = exp(-y) or 1/(1 + y).
enum class Fall { exponential, hyperbolic };
template <class S>
struct SmoothFriction {
  Fall fall;
  S first, last, scale, viscous;

  [[nodiscard]] S shape(const S& v) const {
    using std::exp;
    return fall == Fall::exponential ? S(exp(S(-v / scale))) : S(scale / S(scale + v));
  }
  [[nodiscard]] S force(const S& v) const { return last + (first - last) * shape(v) + viscous * v; }
  [[nodiscard]] S slope(const S& v) const {
    const S y = shape(v);
    return viscous - (first - last) / scale * (fall == Fall::exponential ? y : S(y * y));
  }
};

// The friction when the mass slides to one side.
template <class S>
struct FrictionLaw {
  S at_rest;                             // |r| up to which it sticks
  std::vector<SlidingPiece<S>> sliding;  // at least one, the first from 0, `from` increasing
  // If there is one, it is the law, and the pieces are near it: motions are simulated on these.
  std::optional<SmoothFriction<S>> smooth = {};

  [[nodiscard]] std::size_t pieces() const { return smooth ? 1 : sliding.size(); }
};

// cosine cos(k theta) + sine sin(k theta) on a mass, theta the phase of the load; k = 0 is a constant force.
template <class S>
struct HarmonicForce {
  std::size_t mass;  // counted from 0
  int k;
  S cosine, sine;
};

template <class S>
struct FrictionOscillator {
  std::vector<S> masses;
  MatrixX<S> damping, stiffness;  // C and K, symmetric
  std::size_t rubbing;            // j, counted from 0
  S V;                            // the belt's velocity
  FrictionLaw<S> forward;         // on a slip, where the belt is the faster one
  FrictionLaw<S> backward;        // on an overshoot
  std::vector<HarmonicForce<S>> loads;
  S omega;  // theta' > 0; without meaning where no load varies

  [[nodiscard]] std::size_t size() const { return masses.size(); }
  [[nodiscard]] const FrictionLaw<S>& law(int side) const { return side > 0 ? forward : backward; }
  [[nodiscard]] bool is_autonomous() const {
    for (const HarmonicForce<S>& load : loads) {
      if (load.k != 0) {
        return false;
      }
    }
    return true;
  }
};

// Of the masses and springs at X = (x, x').
template <class S>
[[nodiscard]] S energy(const FrictionOscillator<S>& o, const VectorX<S>& X) {
  const auto n = static_cast<Eigen::Index>(o.size());
  S twice = X.head(n).dot(o.stiffness * X.head(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    twice += o.masses[static_cast<std::size_t>(i)] * X(n + i) * X(n + i);
  }
  return twice / S(2);
}

// The law, the oscillator whose numbers are f of these.
template <class T, class S, class F>
[[nodiscard]] SmoothFriction<T> mapped(const SmoothFriction<S>& law, const F& f) {
  return {law.fall, f(law.first), f(law.last), f(law.scale), f(law.viscous)};
}
template <class T, class S, class F>
[[nodiscard]] FrictionOscillator<T> mapped(const FrictionOscillator<S>& o, const F& f) {
  const auto all = [&](const auto& A) {
    MatrixX<T> B(A.rows(), A.cols());
    for (Eigen::Index i = 0; i < A.size(); ++i) {
      B.data()[i] = f(A.data()[i]);
    }
    return B;
  };
  const auto law = [&](const FrictionLaw<S>& given) {
    FrictionLaw<T> result{f(given.at_rest), {}, {}};
    for (const SlidingPiece<S>& piece : given.sliding) {
      result.sliding.push_back({f(piece.from), f(piece.force), f(piece.slope)});
    }
    if (given.smooth) {
      result.smooth = mapped<T>(*given.smooth, f);
    }
    return result;
  };
  FrictionOscillator<T> result{{},        all(o.damping), all(o.stiffness), o.rubbing,
                               f(o.V),    law(o.forward), law(o.backward),  {},
                               f(o.omega)};
  for (const S& m : o.masses) {
    result.masses.push_back(f(m));
  }
  for (const HarmonicForce<S>& load : o.loads) {
    result.loads.push_back({load.mass, load.k, f(load.cosine), f(load.sine)});
  }
  return result;
}

// (2), (4): masses 1 and 1/eta, so that forces are lengths.
template <class S>
[[nodiscard]] FrictionOscillator<S> friction_oscillator(const Parameters<S>& a, const S& ur) {
  const Matrix2<S> K = matrix<S>(S(1), S(-a.chi), S(-a.chi), a.chi);
  const FrictionLaw<S> law{ur, {{S(0), a.us, S(0)}}};
  return {{S(1), S(S(1) / a.eta)},
          MatrixX<S>::Constant(2, 2, S(0)),
          K,
          1,
          a.V,
          law,
          law,
          {{1, 1, S(a.p / a.eta), S(0)}},
          a.omega};
}

}  // namespace stickslip::model
