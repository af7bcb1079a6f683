// Den Hartog's symmetric motion of one mass with Coulomb friction under a harmonic load, as text books give
// it (after Trans. ASME 53, 1931, APM-53-9, which is not at hand: nothing here reads "as printed").
//
// Dimensionless, time in units of the natural one: x'' + x = a cos(omega t + phi) - f sgn(x'). At t = 0 the
// mass is at its greatest distance, x(0) = X, x'(0) = 0; it comes back without a stop, x' < 0, until t =
// pi/omega, when x = -X, x' = 0; and so on, mirrored. In between x'' + x = a cos(omega t + phi) + f.
#pragma once

#include <vector>

#include <stickslip/proofs/methods/paper.hpp>
#include <stickslip/proofs/tactics/tactics.hpp>

namespace den_hartog {

namespace kernel = stickslip::proofs::kernel;
namespace methods = stickslip::proofs::methods;
using kernel::equal, kernel::less, kernel::Formula, kernel::Term, kernel::Theorem, kernel::Variable;

inline const Variable X{"X"}, a{"a"}, f{"f"}, omega{"omega"}, phi{"phi"}, t{"t"};

// The amplitude of the forced motion, without friction; the half period.
inline const Term q = Term(a) / (1 - power(omega, 2)), half = kernel::pi() / omega;

// The motion on 0 <= time <= pi/omega that begins at X at rest, and its velocity.
[[nodiscard]] Term position(const Term& time);
[[nodiscard]] Term velocity(const Term& time);

// A claim with theorems of the kernel, made when it is asked for; of text books, if it is not of our own.
[[nodiscard]] methods::Claim claim(const char * id, const char * words, std::vector<Theorem> (*prove)(),
                                   methods::Origin origin = methods::Origin::textbook);

[[nodiscard]] std::vector<methods::Claim> motion();   // what the motion between two turns is
[[nodiscard]] std::vector<methods::Claim> closing();  // when it is symmetric: amplitude and lag
[[nodiscard]] std::vector<methods::Claim> numbers();  // the limit of motion without stops; figures

}  // namespace den_hartog
