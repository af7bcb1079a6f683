// Derived expressions at the parameters of a machine, for papers.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/rational.hpp"
#include "numeric/orbits.hpp"
#include "symbolic/objects/objects.hpp"

namespace stickslip::report::orbits {

using GivenParameters = std::map<std::string, Rational>;  // by the names of the command line

// The parameters among chi, eta, us, V, omega, p that values of these expressions depend on, in this order.
[[nodiscard]] std::vector<std::string> parameters_of(
    const std::vector<const symbolic::objects::Object *>& objects);

// What is given, what follows from it, and each line of the expression as a combination of what is free
// (times, states, phi and u_r where they are not given) with numbers for coefficients: LaTeX for a document
// with amsmath. Frequencies stay letters within sines and cosines. Each number is right to one unit of its
// last digit. A line that follows from a later one by its number, as p_min from b_1, is given with it. Throws
// DomainError for data outside the domain of (2), for omega = omega_j where Q occurs, and for ur <= us;
// UsageError for what else has no value there, as where a cosine in a denominator is zero. All of
// parameters_of() must be given.
[[nodiscard]] std::string values_latex(const symbolic::objects::Object& object, const GivenParameters& given,
                                       int digits);

// One orbit for a paper.

// Orbit `index` of a list that is none of a box, as LaTeX for a document with amsmath: a comment with the
// command that lists it, its data, its values, what is proved of it, and phase by phase the closed forms of
// x_1 and x_2, (5), (8) or (10), with its numbers: to at most so many significant digits, each of them right
// to one unit of the last one.
[[nodiscard]] std::string orbit_latex(const numeric::OrbitList& list, std::size_t index, int digits);

}  // namespace stickslip::report::orbits
