#include "numeric/machines/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/domain.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

namespace {

void require_symmetric(const model::MatrixX<Rational>& A, std::size_t n, const char * name) {
  const auto size = static_cast<Eigen::Index>(n);
  require(A.rows() == size && A.cols() == size, name,
          fmt::format("a matrix of {} rows and {} columns", A.rows(), A.cols()),
          fmt::format("as many as masses, {}", n));
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index k = 0; k < i; ++k) {
      require(A(i, k) == A(k, i), fmt::format("{}({}, {})", name, i + 1, k + 1), A(i, k),
              fmt::format("{}({}, {}) = {}", name, k + 1, i + 1, to_string(A(k, i))));
    }
  }
}

void require_smooth(const model::SmoothFriction<Rational>& law) {
  require(law.first >= 0, "the sliding friction at 0", law.first, "a force >= 0");
  require(law.last >= 0, "the sliding friction at high velocities", law.last, "a force >= 0");
  require(law.scale > 0, "the velocity over which sliding friction falls", law.scale, "> 0");
  require(law.viscous >= 0, "the viscous part of sliding friction", law.viscous, ">= 0");
}

void require_law(const model::FrictionLaw<Rational>& law) {
  require(law.at_rest > 0, "the friction at rest", law.at_rest, "a force > 0");
  if (law.smooth) {
    require_smooth(*law.smooth);
  }
  require(!law.sliding.empty(), "the sliding friction", "nothing",
          "at least one piece, from relative velocity 0");
  require(law.sliding.front().from == 0, "the first relative velocity of the sliding friction",
          law.sliding.front().from, "0");
  for (std::size_t i = 0; i < law.sliding.size(); ++i) {
    const model::SlidingPiece<Rational>& piece = law.sliding[i];
    require(piece.force >= 0, "the sliding friction", piece.force, "a force >= 0");
    if (i == 0) {
      continue;
    }
    const model::SlidingPiece<Rational>& before = law.sliding[i - 1];
    require(piece.from > before.from, "a relative velocity of the sliding friction", piece.from,
            "more than the one before, " + to_string(before.from));
    const Rational reached = before.force + before.slope * (piece.from - before.from);
    require(
        piece.force == reached, "the sliding friction", piece.force,
        fmt::format("{}, which the piece before reaches at {}", to_string(reached), to_string(piece.from)));
  }
  const Rational& first = law.sliding.front().force;
  if (law.smooth) {
    require(law.smooth->first == first, "the sliding friction at 0", law.smooth->first,
            to_string(first) + ", as on the pieces beside it");
  }
  require(first <= law.at_rest, "the sliding friction at 0", first,
          "no more than the friction at rest, " + to_string(law.at_rest));
}

}  // namespace

double scale_of(const model::FrictionOscillator<double>& o) {
  const auto j = static_cast<Eigen::Index>(o.rubbing);
  const double stiffness = o.stiffness(j, j);
  return stiffness > 0 ? std::sqrt(stiffness / o.masses[o.rubbing]) : 1;
}

attractors::StartBoxOf<Eigen::VectorXd> start_box(const model::FrictionOscillator<double>& o) {
  const auto n = static_cast<Eigen::Index>(o.size());
  const auto j = static_cast<Eigen::Index>(o.rubbing);
  const double m = o.masses[o.rubbing];
  const double Omega = scale_of(o);
  const int side = o.V >= 0 ? 1 : -1;
  const model::SlidingPiece<double> * piece = &o.law(side).sliding.front();
  for (const model::SlidingPiece<double>& next : o.law(side).sliding) {
    piece = next.from <= std::abs(o.V) ? &next : piece;
  }
  const double friction = piece->force + piece->slope * (std::abs(o.V) - piece->from);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(n);
  forces(j) = side * friction;
  double s = std::max(std::abs(o.V), 3 * std::max(o.forward.at_rest, o.backward.at_rest) / (m * Omega));
  for (const model::HarmonicForce<double>& load : o.loads) {
    if (load.k == 0) {
      forces(static_cast<Eigen::Index>(load.mass)) += load.cosine;
    } else {
      s = std::max(s, std::hypot(load.cosine, load.sine) / (o.masses[load.mass] * Omega));
    }
  }
  attractors::StartBoxOf<Eigen::VectorXd> box{Eigen::VectorXd::Zero(2 * n), Eigen::VectorXd::Zero(2 * n)};
  box.middle.head(n) = zeros::least_squares(o.stiffness, forces);
  box.middle(n + j) = o.V - side * s;
  box.half.head(n).setConstant(2 * s / Omega);
  box.half.tail(n).setConstant(1.5 * s);
  return box;
}

Machine machine_of(const MachineInSI& m) {
  if (!m.friction_at_rest) {
    throw InternalError("a machine whose friction at rest is not known");
  }
  const model::FrictionLaw<Rational> law{*m.friction_at_rest,
                                         {{Rational(0), m.friction_sliding, Rational(0)}}};
  model::MatrixX<Rational> K(2, 2);
  K << Rational(m.k1 + m.k2), Rational(-m.k2), Rational(-m.k2), m.k2;
  return {{{m.m1, m.m2},
           model::MatrixX<Rational>::Constant(2, 2, Rational(0)),
           K,
           1,
           m.belt_velocity,
           law,
           law,
           {{1, 1, m.load_amplitude, Rational(0)}},
           m.load_frequency},
          true};
}

// Between points at a distance d a chord is away from the law by d²/8 times its curvature: by one size where
// the points are equally far apart in the integral of the curvature's root, exp(-y/2) or (1 + y)^(-1/2).
model::FrictionLaw<Rational> smooth_law(const Rational& at_rest,
                                        const model::SmoothFriction<Rational>& friction) {
  require_smooth(friction);
  const auto f = model::mapped<double>(friction, [](const Rational& x) { return x.get_d(); });
  model::FrictionLaw<Rational> law{at_rest, {}, friction};
  for (int k = 0; k < smooth_pieces; ++k) {
    const double left = 1 - static_cast<double>(k) / smooth_pieces;
    const double y = friction.fall == model::Fall::exponential ? -2 * std::log(left) : 1 / (left * left) - 1;
    const double v = y * f.scale;
    law.sliding.push_back({Rational(v), k == 0 ? friction.first : Rational(f.force(v)), friction.viscous});
  }
  for (std::size_t k = 0; k + 1 < law.sliding.size(); ++k) {
    model::SlidingPiece<Rational>& piece = law.sliding[k];
    const model::SlidingPiece<Rational>& next = law.sliding[k + 1];
    piece.slope = Rational((next.force - piece.force) / (next.from - piece.from));
  }
  return law;
}

void require_machine(const Machine& machine) {
  const model::FrictionOscillator<Rational>& o = machine.oscillator;
  require(!o.masses.empty(), "the machine", "without mass", "at least one mass");
  for (std::size_t i = 0; i < o.size(); ++i) {
    require(o.masses[i] > 0, fmt::format("mass {}", i + 1), o.masses[i], "> 0");
  }
  require_symmetric(o.damping, o.size(), "C");
  require_symmetric(o.stiffness, o.size(), "K");
  require(o.rubbing < o.size(), "the mass on the belt", o.rubbing + 1, fmt::format("1 to {}", o.size()));
  for (const model::HarmonicForce<Rational>& load : o.loads) {
    require(load.mass < o.size(), "the mass of a load", load.mass + 1, fmt::format("1 to {}", o.size()));
    require(load.k >= 0, "the multiple of the load's frequency", load.k, ">= 0");
  }
  if (!o.is_autonomous()) {
    require(o.omega > 0, "the load's frequency", o.omega, "> 0");
  }
  require_law(o.forward);
  require_law(o.backward);
}

}  // namespace stickslip::numeric::machines
