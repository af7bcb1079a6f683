// An example of the paper: the numbers that are printed for it, each against the value that is proved, and
// the motion that the paper shows against the complete list of orbits at its data.
#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/printed.hpp"
#include "model/parameters.hpp"
#include "proofs/methods/claim.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/orbits/along.hpp"
#include "proofs/orbits/phases.hpp"
#include "proofs/pascal2012/examples/examples.hpp"
#include "proofs/tactics/model_terms.hpp"

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
// Makes of what was decided in balls, if anything was, this theorem; undecided, with the reason, where it
// throws KernelError.
void prove(methods::Outcome& outcome, const std::function<kernel::Theorem()>& theorem);

// Makes of what was decided in balls a theorem: what `theorem` makes of the orbit's existence, if that is
// proved; undecided, with the reason, where it makes none.
void prove_of_orbit(
    methods::Outcome& outcome, methods::Prover& prover, const methods::Example& example,
    const std::function<kernel::Theorem(const kernel::Theorem& orbit, const orbits::Question&)>& theorem);

// "S.orbit": the printed orbit exists, as a theorem of the kernel. "S.tau", …: the printed results of these
// names, each against the value of the orbit that is proved; the route says how that was found.
[[nodiscard]] std::vector<methods::Claim> printed_values(const methods::Example& example,
                                                         const std::string& words, const std::string& route,
                                                         const std::vector<std::string>& names);

// "-0.0016, 0.0021, …": midpoints of balls that are far smaller than their last digit.
[[nodiscard]] std::string residuals(const std::vector<Ball>& values);

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

// "7.74669 ± 3.1e-6".
[[nodiscard]] std::string shown(const Ball& ball);

// The first six digits, "7.74669...", if the ball is known so well; else as shown().
[[nodiscard]] std::string digits_of(const Ball& ball);

// "tau = 7.74669..., u_r = 0.161022...": what tells one orbit of a list from another.
[[nodiscard]] std::string told_apart(const numeric::Orbit& orbit, const numeric::Family& family);

// That a list found in balls is complete, as a theorem, and what reduces the orbits' conditions to what it
// says.
struct ListTheorem {
  std::function<kernel::Theorem(const numeric::OrbitList& list)> prove = {};
  std::set<std::string> uses = {};
  std::string says = {};  // in words
};
// "S.motion": the printed orbit as one motion; "S.list": the list is complete; "S.if.14.lower", …: each
// condition along the printed orbit; "S.stability"; "S.raw": the friction law integrated without closed forms
// agrees.
[[nodiscard]] std::vector<methods::Claim> orbit_claims(const methods::Example& example,
                                                       const ListTheorem& list = {});

// The printed decimal of that name, exactly; with the sign of the proved value where the source has lost it.
[[nodiscard]] Rational printed_decimal(const methods::Example& example, const std::string& name);

// From ranges of its variables: the value lies within the interval for which the decimal stands, or does not.
[[nodiscard]] kernel::Theorem rounds_to(const Decimal& decimal, const kernel::Term& value, bool it_does,
                                        const orbits::Ranges& ranges = {});

// "S.from.T": the printed result is what the formula gives at the other printed values, `value`, rounded; as
// the theorem says, which is made of the decimal and whether it is.
[[nodiscard]] methods::Claim computed_from(
    const methods::Example& example, const std::string& name, const std::string& formula,
    std::function<Ball()> value, std::function<kernel::Theorem(const Decimal& printed, bool it_is)> theorem);

// What is printed of an example, as numbers of a scalar: balls, or terms.
template <class S>
struct Printed {
  const methods::Example& example;

  [[nodiscard]] static S number(const Rational& value) {
    if constexpr (std::is_same_v<S, Ball>) {
      return S(value);
    } else {
      return S(kernel::Term(value));
    }
  }
  [[nodiscard]] S operator()(const std::string& name) const { return number(printed_decimal(example, name)); }
  [[nodiscard]] model::Parameters<S> data() const {
    return model::mapped<S>(example.data, [](const Rational& value) { return number(value); });
  }
};

// The value by one formula over both scalars.
template <class Formula>
[[nodiscard]] methods::Claim computed_by(const methods::Example& example, const std::string& name,
                                         const std::string& words, const Formula& formula) {
  return computed_from(
      example, name, words, [&example, formula] { return formula(Printed<Ball>{example}); },
      [&example, formula](const Decimal& printed, bool it_is) {
        return rounds_to(printed, formula(Printed<tactics::Symbolic>{example}).term, it_is);
      });
}

}  // namespace stickslip::proofs::pascal2012
