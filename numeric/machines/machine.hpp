// A friction oscillator exactly as it is given.
#pragma once

#include "core/rational.hpp"
#include "model/friction_oscillator.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::machines {

struct Machine {
  model::FrictionOscillator<Rational> oscillator;
  bool in_turns = false;  // omega stands for 2 pi times it: a frequency in Hz
};

// At the working precision.
template <class S>
[[nodiscard]] model::FrictionOscillator<S> oscillator_as(const Machine& machine) {
  const model::FrictionOscillator<Rational>& o = machine.oscillator;
  const auto matrix = [](const model::MatrixX<Rational>& A) {
    model::MatrixX<S> B(A.rows(), A.cols());
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
      for (Eigen::Index k = 0; k < A.cols(); ++k) {
        B(i, k) = scalars::scalar<S>(A(i, k));
      }
    }
    return B;
  };
  const auto law = [](const model::FrictionLaw<Rational>& given) {
    model::FrictionLaw<S> result{scalars::scalar<S>(given.at_rest), {}};
    for (const model::SlidingPiece<Rational>& piece : given.sliding) {
      result.sliding.push_back(
          {scalars::scalar<S>(piece.from), scalars::scalar<S>(piece.force), scalars::scalar<S>(piece.slope)});
    }
    return result;
  };
  model::FrictionOscillator<S> result{{},
                                      matrix(o.damping),
                                      matrix(o.stiffness),
                                      o.rubbing,
                                      scalars::scalar<S>(o.V),
                                      law(o.forward),
                                      law(o.backward),
                                      {},
                                      scalars::scalar<S>(o.omega)};
  if (machine.in_turns) {
    result.omega = S(2) * scalars::pi<S>() * result.omega;
  }
  for (const Rational& m : o.masses) {
    result.masses.push_back(scalars::scalar<S>(m));
  }
  for (const model::HarmonicForce<Rational>& load : o.loads) {
    result.loads.push_back(
        {load.mass, load.k, scalars::scalar<S>(load.cosine), scalars::scalar<S>(load.sine)});
  }
  return result;
}

// Throws DomainError unless there is a mass, all are > 0, C and K are symmetric and as large, the rubbing
// mass is one of them, omega > 0 where a load varies, and the friction of each side is a law: > 0 at rest,
// pieces that begin at 0, each after the one before, together continuous and >= 0 where they begin, and below
// the friction at rest at first: at most it, where motions are only followed (`strict` false).
void require_machine(const Machine& machine, bool strict);

}  // namespace stickslip::numeric::machines
