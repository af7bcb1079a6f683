// Motions that close, by Newton's method from a grid through the flows alone: doubles, and no formula of the
// lists.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <optional>
#include <vector>

#include "numeric/words/complete_list.hpp"

namespace stickslip::numeric::words {

// What is to vanish for N phases and a stick after them. The unknowns are the N durations, z10, z20, z10' and
// phi.
template <int N>
struct FlowClosing {
  using Times = Eigen::Matrix<double, N, 1>;
  using Unknowns = Eigen::Matrix<double, N + 4, 1>;

  model::Oscillator<double> o;
  double ur, total;
  std::vector<motion::PhaseKind> phases;

  FlowClosing(const WordQuestion& q, const std::vector<motion::PhaseKind>& kinds)
      : o(model::oscillator<double>(motion::parameters_as<double>(q.data))),
        ur(scalars::scalar<double>(q.ur)),
        total(2 * std::acos(-1.0) / q.data.omega.get_d()),
        phases(kinds) {}

  [[nodiscard]] Unknowns operator()(const Unknowns& x) const {
    const double V = o.data.V, phi = x(N + 3);
    const auto friction_less_ur = [&](const model::Vector4<double>& Z, double t, motion::PhaseKind after) {
      return model::friction_at<double>(o.data, Z, phi + o.data.omega * t) -
             (after == motion::PhaseKind::slip ? ur : -ur);
    };
    const model::Vector4<double> Z0(x(N), x(N + 1), x(N + 2), V);
    model::Vector4<double> Z = Z0;
    double t = 0;
    Unknowns f;
    for (int k = 0; k <= N; ++k) {
      const motion::PhaseKind kind = phases[static_cast<std::size_t>(k)];
      const double h = k < N ? x(k) : total - t;
      Z = motion::flow<double>(o, kind, phi + o.data.omega * t, Z, h);
      t += h;
      if (k < N) {
        f(k) = kind == motion::PhaseKind::stick
                   ? friction_less_ur(Z, t, phases[static_cast<std::size_t>(k) + 1])
                   : Z(3) - V;
        Z(3) = V;
      }
    }
    f.template tail<4>() << Z(0) - Z0(0), Z(1) - Z0(1), Z(2) - Z0(2), friction_less_ur(Z0, 0, phases[0]);
    return f;
  }
};

template <int N>
[[nodiscard]] auto newton(const FlowClosing<N>& f, typename FlowClosing<N>::Unknowns x)
    -> std::optional<typename FlowClosing<N>::Unknowns> {
  for (int step = 0; step < 25; ++step) {
    const auto at_x = f(x);
    Eigen::Matrix<double, N + 4, N + 4> J;
    for (int k = 0; k < N + 4; ++k) {
      auto y = x;
      const double h = 1e-7 * std::max(1.0, std::abs(x(k)));
      y(k) += h;
      J.col(k) = (f(y) - at_x) / h;
    }
    const typename FlowClosing<N>::Unknowns change = J.partialPivLu().solve(at_x);
    x -= change;
    if (!(x.norm() < 1e6)) {
      return std::nullopt;
    }
    if (change.norm() < 1e-9 * (1 + x.norm())) {
      return f(x).norm() < 1e-8 * (1 + x.norm()) ? std::optional(x) : std::nullopt;
    }
  }
  return std::nullopt;
}

// For these durations nearly: least squares in z and (cos phi, sin phi), in which all that is to vanish is
// affine.
template <int N>
[[nodiscard]] auto nearly(const FlowClosing<N>& f, const typename FlowClosing<N>::Times& times) {
  using Unknowns = typename FlowClosing<N>::Unknowns;
  const double half = std::acos(-1.0);
  const auto at = [&](const Eigen::Vector3d& z, double phi) {
    return Unknowns(f((Unknowns() << times, z, phi).finished()));
  };
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Unknowns constant = (at(zero, 0) + at(zero, half)) / 2;
  Eigen::Matrix<double, N + 4, 5> A;
  for (int k = 0; k < 3; ++k) {
    A.col(k) = at(Eigen::Vector3d::Unit(k), 0) - at(zero, 0);
  }
  A.col(3) = (at(zero, 0) - at(zero, half)) / 2;
  A.col(4) = (at(zero, half / 2) - at(zero, -half / 2)) / 2;
  const Eigen::Matrix<double, 5, 1> u = A.colPivHouseholderQr().solve(-constant);
  return Unknowns((Unknowns() << times, u(0), u(1), u(2), std::atan2(u(4), u(3))).finished());
}

// The durations of what is found from a grid of so many steps; phases shorter than 0.001 say nothing.
template <int N>
[[nodiscard]] auto grid_orbits(const FlowClosing<N>& f, int steps) {
  constexpr double shortest = 1e-3;
  std::vector<typename FlowClosing<N>::Times> found;
  Eigen::Matrix<int, N, 1> at = Eigen::Matrix<int, N, 1>::Ones();
  while (at(N - 1) < steps) {
    if (at.sum() < steps) {
      const auto x = newton<N>(f, nearly<N>(f, at.template cast<double>() * f.total / steps));
      if (x && x->template head<N>().minCoeff() > shortest &&
          x->template head<N>().sum() < f.total - shortest) {
        found.emplace_back(x->template head<N>());
      }
    }
    ++at(0);
    for (int k = 0; k + 1 < N && at(k) == steps; ++k) {
      at(k) = 1;
      ++at(k + 1);
    }
  }
  return found;
}

}  // namespace stickslip::numeric::words
