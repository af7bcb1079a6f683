// Two motions through the same phases put together, number by number.
#pragma once

#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::motion {

// f makes a Ball of an A and a Ball; so does this of whatever consists of such.
template <class F>
struct Zip {
  F f;

  template <class A, int N>
  [[nodiscard]] Eigen::Matrix<Ball, N, 1> operator()(const Eigen::Matrix<A, N, 1>& a,
                                                     const Eigen::Matrix<Ball, N, 1>& b) const {
    Eigen::Matrix<Ball, N, 1> result;
    for (int i = 0; i < N; ++i) {
      result(i) = f(a(i), b(i));
    }
    return result;
  }
  template <class A>
  [[nodiscard]] model::Wave<Ball> operator()(const model::Wave<A>& a, const model::Wave<Ball>& b) const {
    model::Wave<Ball> w;
    w.constant = f(a.constant, b.constant);
    w.slope = f(a.slope, b.slope);
    for (std::size_t k = 0; k < static_cast<std::size_t>(a.count); ++k) {
      const model::Harmonic<A>& h = a.harmonics[k];
      const model::Harmonic<Ball>& g = b.harmonics[k];
      w.add(f(h.nu, g.nu), f(h.a, g.a), f(h.b, g.b));
    }
    return w;
  }
  template <class A>
  [[nodiscard]] model::PhaseWaves<Ball> operator()(const model::PhaseWaves<A>& a,
                                                   const model::PhaseWaves<Ball>& b) const {
    const Zip& zip = *this;
    return {zip(a.z1, b.z1), zip(a.z2, b.z2), zip(a.zdot2, b.zdot2), zip(a.r, b.r)};
  }
  template <class A>
  [[nodiscard]] Motion operator()(const MotionOf<A>& a, const Motion& b) const {
    Motion motion{oscillator(a.oscillator, b.oscillator), {}};
    for (std::size_t k = 0; k < b.phases.size(); ++k) {
      const PhaseOf<A>& g = a.phases[k];
      const Phase& h = b.phases[k];
      motion.phases.push_back(
          {g.kind, f(g.start, h.start), f(g.duration, h.duration), f(g.load, h.load), (*this)(g.Z, h.Z)});
    }
    return motion;
  }

 private:
  template <class A>
  [[nodiscard]] model::Oscillator<Ball> oscillator(const model::Oscillator<A>& a,
                                                   const model::Oscillator<Ball>& b) const {
    const auto& [m, n] = std::tie(a.modes, b.modes);
    const auto& [d, e] = std::tie(a.data, b.data);
    return {{f(d.chi, e.chi), f(d.eta, e.eta), f(d.us, e.us), f(d.V, e.V), f(d.omega, e.omega), f(d.p, e.p)},
            {f(m.omega1, n.omega1), f(m.omega2, n.omega2), f(m.lambda1, n.lambda1), f(m.lambda2, n.lambda2)},
            (*this)(a.Q, b.Q),
            (*this)(a.d0, b.d0)};
  }
};

}  // namespace stickslip::numeric::motion
