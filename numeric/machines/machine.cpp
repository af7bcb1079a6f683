#include "numeric/machines/machine.hpp"

#include <fmt/format.h>

#include "core/decimal.hpp"
#include "core/error.hpp"

namespace stickslip::numeric::machines {

namespace {

void require(bool holds, const std::string& name, const Rational& value, const std::string& range) {
  if (!holds) {
    throw DomainError(name, to_string(value), range);
  }
}

void require_symmetric(const model::MatrixX<Rational>& A, std::size_t n, const char * name) {
  const auto size = static_cast<Eigen::Index>(n);
  if (A.rows() != size || A.cols() != size) {
    throw DomainError(name, fmt::format("a matrix of {} rows and {} columns", A.rows(), A.cols()),
                      fmt::format("as many as masses, {}", n));
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index k = 0; k < i; ++k) {
      require(A(i, k) == A(k, i), fmt::format("{}({}, {})", name, i + 1, k + 1), A(i, k),
              fmt::format("{}({}, {}) = {}", name, k + 1, i + 1, to_string(A(k, i))));
    }
  }
}

void require_law(const model::FrictionLaw<Rational>& law, bool strict) {
  require(law.at_rest > 0, "the friction at rest", law.at_rest, "a force > 0");
  if (law.sliding.empty()) {
    throw DomainError("the sliding friction", "nothing", "at least one piece, from relative velocity 0");
  }
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
  require(
      strict ? first < law.at_rest : first <= law.at_rest, "the sliding friction at 0", first,
      fmt::format("{} than the friction at rest, {}", strict ? "less" : "no more", to_string(law.at_rest)));
}

}  // namespace

void require_machine(const Machine& machine, bool strict) {
  const model::FrictionOscillator<Rational>& o = machine.oscillator;
  if (o.masses.empty()) {
    throw DomainError("the machine", "without mass", "at least one mass");
  }
  for (std::size_t i = 0; i < o.size(); ++i) {
    require(o.masses[i] > 0, fmt::format("mass {}", i + 1), o.masses[i], "> 0");
  }
  require_symmetric(o.damping, o.size(), "C");
  require_symmetric(o.stiffness, o.size(), "K");
  if (o.rubbing >= o.size()) {
    throw DomainError("the mass on the belt", fmt::format("{}", o.rubbing + 1),
                      fmt::format("1 to {}", o.size()));
  }
  for (const model::HarmonicForce<Rational>& load : o.loads) {
    if (load.mass >= o.size()) {
      throw DomainError("the mass of a load", fmt::format("{}", load.mass + 1),
                        fmt::format("1 to {}", o.size()));
    }
    require(load.k >= 0, "the multiple of the load's frequency", load.k, ">= 0");
  }
  if (!o.is_autonomous()) {
    require(o.omega > 0, "the load's frequency", o.omega, "> 0");
  }
  require_law(o.forward, strict);
  require_law(o.backward, strict);
}

}  // namespace stickslip::numeric::machines
