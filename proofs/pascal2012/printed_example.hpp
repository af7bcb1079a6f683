// Claims about the numbers that the paper prints for an example: each against the value that is proved.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proofs/methods/claim.hpp"
#include "proofs/orbits/phases.hpp"
#include "proofs/pascal2012/examples.hpp"

namespace stickslip::proofs::pascal2012 {

// The printed value; where its sign is lost, with the one that the proved value has.
[[nodiscard]] Decimal as_printed(const methods::PrintedResult& result, const Ball& value);

// A printed value beside the proved one.
[[nodiscard]] methods::Comparison compared(const std::string& name, const Decimal& printed,
                                           const Ball& value);

// An outcome at the example's data: its parameters, and phi and u_r where they are given.
[[nodiscard]] methods::Outcome at_the_data(const methods::Example& example, const std::string& route);

// What the claims about an example share.
struct PrintedPlace {
  const methods::Example& example;
  std::string orbit;  // the id of the claim that the orbit exists
  std::string route;  // how its values were found
};

// Data and u_r.
[[nodiscard]] std::vector<Coordinate> coordinates(const numeric::motion::ExactParameters& a,
                                                  const Rational& ur);

// Proved by this theorem, which takes these claims; undecided, with the reason, where it throws KernelError.
[[nodiscard]] methods::Outcome proved_by(methods::Outcome outcome, const std::set<std::string>& uses,
                                         const std::function<kernel::Theorem()>& theorem);
// Makes of what was decided in balls this theorem; undecided, with the reason, where it throws KernelError.
void prove(methods::Outcome& outcome, const std::function<kernel::Theorem()>& theorem);

// Makes of what was decided in balls a theorem: what `theorem` makes of the orbit's existence, if that is
// proved; undecided, with the reason, where it makes none.
void prove_of_orbit(
    methods::Outcome& outcome, methods::Prover& prover, const PrintedPlace& where,
    const std::function<kernel::Theorem(const kernel::Theorem& orbit, const orbits::Question&)>& theorem);

// "S.tau", …: the printed results of these names, each against the value of the orbit that is proved.
[[nodiscard]] std::vector<methods::Claim> printed_values(const PrintedPlace& where,
                                                         const std::vector<std::string>& names);

// Every component contains zero, and is small enough (1e-20) for that to mean something.
[[nodiscard]] Verdict vanishes(const std::vector<Ball>& residual, const std::string& what);

// "-0.0016, 0.0021, …": midpoints of balls that are far smaller than their last digit.
[[nodiscard]] std::string residuals(const std::vector<Ball>& values);

}  // namespace stickslip::proofs::pascal2012
