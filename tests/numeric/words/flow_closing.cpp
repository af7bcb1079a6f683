#include "tests/numeric/words/flow_closing.hpp"

#include <cmath>
#include <optional>

#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::words {

using Vector = FlowClosing::Vector;

FlowClosing::FlowClosing(const WordQuestion& q, const std::vector<motion::PhaseKind>& kinds)
    : o(model::oscillator<double>(motion::parameters_as<double>(q.data))),
      ur(scalars::scalar<double>(q.ur)),
      total(2 * std::acos(-1.0) / q.data.omega.get_d()),
      phases(kinds) {}

Vector FlowClosing::operator()(const Vector& x) const {
  const auto last = static_cast<Eigen::Index>(phases.size()) - 1;
  const double V = o.data.V, phi = x(last + 3);
  const auto friction_less_ur = [&](const model::Vector4<double>& Z, double t, motion::PhaseKind after) {
    return model::friction_at<double>(o.data, Z, phi + o.data.omega * t) -
           (after == motion::PhaseKind::slip ? ur : -ur);
  };
  const model::Vector4<double> Z0(x(last), x(last + 1), x(last + 2), V);
  model::Vector4<double> Z = Z0;
  double t = 0;
  Vector f(last + 4);
  for (Eigen::Index k = 0; k <= last; ++k) {
    const motion::PhaseKind kind = phases[static_cast<std::size_t>(k)];
    const double h = k < last ? x(k) : total - t;
    Z = motion::flow<double>(o, kind, phi + o.data.omega * t, Z, h);
    t += h;
    if (k < last) {
      f(k) = kind == motion::PhaseKind::stick
                 ? friction_less_ur(Z, t, phases[static_cast<std::size_t>(k) + 1])
                 : Z(3) - V;
      Z(3) = V;
    }
  }
  f.tail<4>() << Z(0) - Z0(0), Z(1) - Z0(1), Z(2) - Z0(2), friction_less_ur(Z0, 0, phases[0]);
  return f;
}

namespace {

std::optional<Vector> newton(const FlowClosing& f, Vector x) {
  for (int step = 0; step < 25; ++step) {
    const Vector at_x = f(x);
    Eigen::MatrixXd J(x.size(), x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      Vector y = x;
      const double h = 1e-7 * std::max(1.0, std::abs(x(k)));
      y(k) += h;
      J.col(k) = (f(y) - at_x) / h;
    }
    const Vector change = zeros::inverse(J) * at_x;
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
Vector nearly(const FlowClosing& f, const Eigen::VectorXd& times) {
  const double half = std::acos(-1.0);
  Vector x(times.size() + 4);
  const auto at = [&](const Eigen::Vector3d& z, double phi) {
    x << times, z, phi;
    return f(x);
  };
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Vector constant = (at(zero, 0) + at(zero, half)) / 2;
  Eigen::MatrixXd A(x.size(), 5);
  for (int k = 0; k < 3; ++k) {
    A.col(k) = at(Eigen::Vector3d::Unit(k), 0) - at(zero, 0);
  }
  A.col(3) = (at(zero, 0) - at(zero, half)) / 2;
  A.col(4) = (at(zero, half / 2) - at(zero, -half / 2)) / 2;
  const Eigen::VectorXd u = zeros::least_squares(A, -constant);
  x << times, u.head<3>(), std::atan2(u(4), u(3));
  return x;
}

}  // namespace

std::vector<Eigen::VectorXd> grid_orbits(const FlowClosing& f, int steps) {
  constexpr double shortest = 1e-3;
  std::vector<Eigen::VectorXd> found;
  const auto n = static_cast<Eigen::Index>(f.phases.size()) - 1;
  Eigen::VectorXd at = Eigen::VectorXd::Ones(n);
  while (at(n - 1) < steps) {
    if (at.sum() < steps) {
      const auto x = newton(f, nearly(f, at * (f.total / steps)));
      if (x && x->head(n).minCoeff() > shortest && x->head(n).sum() < f.total - shortest) {
        found.emplace_back(x->head(n));
      }
    }
    ++at(0);
    for (Eigen::Index k = 0; k + 1 < n && at(k) == steps; ++k) {
      at(k) = 1;
      ++at(k + 1);
    }
  }
  return found;
}

}  // namespace stickslip::numeric::words
