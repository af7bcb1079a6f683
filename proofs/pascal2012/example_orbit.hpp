// An example of the paper against the complete list of orbits at its data: how many there are, and every
// inequality along the motion that the paper shows.
#pragma once

#include <type_traits>

#include "proofs/methods/motions.hpp"
#include "proofs/orbits/along.hpp"
#include "proofs/pascal2012/printed_example.hpp"

namespace stickslip::proofs::pascal2012 {

// "7.74669 ± 3.1e-6".
[[nodiscard]] std::string shown(const Ball& ball);

// The first six digits, "7.74669...", if the ball is known so well; else as shown().
[[nodiscard]] std::string digits_of(const Ball& ball);

// "tau = 7.74669..., u_r = 0.161022...": what tells one orbit of a list from another.
[[nodiscard]] std::string told_apart(const numeric::Orbit& orbit, const numeric::Family& family);

// "S.orbit": the printed orbit exists, as a theorem of the kernel.
[[nodiscard]] methods::Claim existence_claim(const methods::Example& example, const std::string& words);

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
