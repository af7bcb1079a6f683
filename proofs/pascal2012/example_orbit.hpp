// An example of the paper against the complete list of orbits at its data: how many there are, and every
// inequality along the motion that the paper shows.
#pragma once

#include "proofs/methods/example_orbits.hpp"
#include "proofs/pascal2012/printed_example.hpp"

namespace stickslip::proofs::pascal2012 {

// The value of that name. Throws InternalError when the family has none.
[[nodiscard]] const Ball& value_of(const numeric::Orbit& orbit, const std::string& name);

// "7.74669 ± 3.1e-6".
[[nodiscard]] std::string shown(const Ball& ball);

// "S.orbit": the printed orbit exists, as a theorem of the kernel.
[[nodiscard]] methods::Claim existence_claim(const PrintedPlace& where, const std::string& words);

// "S.list": the list is complete; "S.if.14.lower", …: each condition along the printed orbit; "S.stability";
// "S.raw": the friction law integrated without closed forms agrees.
[[nodiscard]] std::vector<methods::Claim> orbit_claims(const PrintedPlace& where);

// "S.from.T": the printed result is what the formula gives at the other printed values, `value`, rounded.
[[nodiscard]] methods::Claim computed_from(const PrintedPlace& where, const std::string& name,
                                           const std::string& formula, std::function<Ball()> value);

// The printed decimal of that name, exactly; with the sign of the proved value where the source has lost it.
[[nodiscard]] Ball printed_decimal(const methods::Example& example, const std::string& name);

}  // namespace stickslip::proofs::pascal2012
