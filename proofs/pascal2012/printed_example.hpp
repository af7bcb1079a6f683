// Claims about the numbers that the paper prints for an example: each against the value that is proved.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "core/printed.hpp"
#include "model/parameters.hpp"
#include "proofs/methods/claim.hpp"
#include "proofs/orbits/along.hpp"
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

// Refuted at these data: what is called left is not what is called right.
[[nodiscard]] Verdict differs_at(const std::vector<Coordinate>& data, const Ball& left, const Ball& right,
                                 const std::string& left_name, const std::string& right_name);
// "S.orbit": the id of the claim that the orbit exists. Claims refer to examples, which have to outlive them.
[[nodiscard]] std::string orbit_claim(const methods::Example& example);
// The same outcome, which rests on that.
[[nodiscard]] methods::Outcome of_its_orbit(const methods::Example& example, const std::string& route);

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
    methods::Outcome& outcome, methods::Prover& prover, const methods::Example& example,
    const std::function<kernel::Theorem(const kernel::Theorem& orbit, const orbits::Question&)>& theorem);

// "S.tau", …: the printed results of these names, each against the value of the orbit that is proved; the
// route says how that was found.
[[nodiscard]] std::vector<methods::Claim> printed_values(const methods::Example& example,
                                                         const std::string& route,
                                                         const std::vector<std::string>& names);

// "-0.0016, 0.0021, …": midpoints of balls that are far smaller than their last digit.
[[nodiscard]] std::string residuals(const std::vector<Ball>& values);

// The closing conditions at the values that the paper prints for an orbit.

// What conditions leave at printed decimals.
struct PrintedClosing {
  Eigen::Matrix<Ball, 5, 1> at_points;     // at the decimals themselves
  Eigen::Matrix<Ball, 5, 1> at_intervals;  // over the intervals that they stand for
  Verdict verdict;  // of "the intervals contain a zero"; undecided at best by evaluation
};

// z2'(tau) - V, then z1, z2, z1', z2' of Z(Theta) - Z0, through the flows (5), (8), (10), at (tau, tau1, z10,
// z20, zdot10); refuted when one of them is zero nowhere in the intervals. Throws DomainError outside the
// domain of orbits that stick.
[[nodiscard]] PrintedClosing printed_closing_overshooting(const numeric::motion::ExactParameters& a,
                                                          const Rational& phi,
                                                          const std::array<Decimal, 5>& printed);

// The frequencies (39) as parameters in place of chi and eta (frequencies.cpp).

// For all values of the other variables: all hypotheses that are not of omega1 and omega2 alone imply what it
// says.
[[nodiscard]] kernel::Theorem closed_but_frequencies(kernel::Theorem theorem);

// For numbers at the data of an example, of which omega1 and omega2 are not rational: from ranges of these
// two, which are the hypotheses of what `more` makes, and that chi and eta have these values, ⊢ C, to ⊢ there
// are 0 < omega1 < 1 < omega2 at which chi and eta have these values, and C. Throws KernelError outside 0 <
// chi < 1, 0 < eta.
[[nodiscard]] kernel::Theorem at_frequencies(
    const Rational& chi, const Rational& eta,
    const std::function<kernel::Theorem(const orbits::Ranges& ranges)>& more);

}  // namespace stickslip::proofs::pascal2012
