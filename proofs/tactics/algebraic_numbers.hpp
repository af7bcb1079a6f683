// Numbers made of square roots and of sines and cosines of rational multiples of pi: equations between them.
#pragma once

#include <functional>

#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/letters.hpp"

namespace stickslip::proofs::tactics {

// a = b, where what does not divide is a polynomial in such numbers, and perhaps in other letters, for all
// values of which it holds then; sin(u + pi/4) is taken apart. The sines and cosines are of multiples of pi/n
// with one n of at most 64; the roots are known. What it divides by is a hypothesis.
//
// A coefficient g, as an element of the algebra over the rational numbers of which these are the generators,
// has powers that depend on each other: g^k h(g) = 0 with h(0) != 0. If g is zero, h(g) is h(0), and is not
// zero in balls, so that g is zero. Throws KernelError where h is all there is, for g is not zero then, and
// where the algebra has more than 96 dimensions.
[[nodiscard]] Theorem equal_numbers(const Formula& equation, const KnownRoots& roots = {});

// f = 0, where f is the only one of the irreducible factors of what is known to be zero of which it is not
// shown that it is not. Throws KernelError where it is no factor, or another one may be zero.
using Differs = std::function<Theorem(const Term& factor)>;  // that it is not zero, or throws KernelError
[[nodiscard]] Theorem zero_factor(const Term& f, const Theorem& known, const Differs& differs);

}  // namespace stickslip::proofs::tactics
