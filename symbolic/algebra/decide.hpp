// Decides whether two expressions are identically equal, for all parameters.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/verdict.hpp"
#include "symbolic/algebra/scalar.hpp"

namespace stickslip::symbolic::algebra {

using Matrix = Eigen::Matrix<GiNaC::ex, Eigen::Dynamic, Eigen::Dynamic>;

// Symbols that stand for something: they stay closed unless an identity needs to look inside.
struct Definition {
  std::string id;            // the equation that defines them
  GiNaC::exmap replacement;  // symbol -> expression
};

struct Decision {
  Verdict verdict;
  // What the two sides divide by, as irreducible factors that must not vanish; those that cannot vanish for
  // 0 < omega1 < 1 < omega2 and positive omega, us, ur are discharged and not listed. In omega1, omega2
  // instead of chi, eta, lambda1, lambda2. Each in a sign of its own; sorted by their text.
  std::vector<GiNaC::ex> nonzero;
  // The ids of the definitions that had to be opened, "39" among them if the identity needs (39).
  std::set<std::string> opened;
};

// Decides left = right entry by entry. Expressions are rational in the symbols, π and cos, sin, tan of
// rational combinations of monomials (see normal_form.hpp); chi, eta, lambda1, lambda2 stand for (39). As few
// definitions as possible are opened, so that an identity is proved in its most general form, with the fewest
// denominators.
//   proved:     the normal form of every difference is zero.
//   refuted:    some difference is not, and at the witness both sides are disjoint balls.
//   undecided:  an entry lies outside the field, divides by zero identically, or no witness was found.
// Throws InternalError if the shapes differ.
[[nodiscard]] Decision decide_equal(const Matrix& left, const Matrix& right,
                                    const std::vector<Definition>& definitions = {});
[[nodiscard]] Decision decide_equal(const GiNaC::ex& left, const GiNaC::ex& right,
                                    const std::vector<Definition>& definitions = {});

// Whether the expression is certainly not identically zero: at some point its ball excludes zero. Symbols
// take any positive values, those of chi, eta, lambda1, lambda2 independent of omega1 and omega2.
[[nodiscard]] bool differs_from_zero(const GiNaC::ex& expression);

// A point of the domain where the two sides, free of chi, eta, lambda1, lambda2, are disjoint balls, if one
// of the points tried is.
[[nodiscard]] std::optional<Witness> find_witness(const GiNaC::ex& left, const GiNaC::ex& right);

}  // namespace stickslip::symbolic::algebra
