// What a printed statement says, in the kernel's language, and its proof there by normal form.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

// Printed terms as kernel terms. A scalar is a variable, a number, or, where the table of symbols or model/
// has a formula for it, a definition in what it depends on: chi is chi(omega1, omega2), H(t) is H(t, omega1,
// omega2), F_0 is F0(omega, phi, …). A derivative d/dt f is D(t) with a function D of which the formula says
// that it is the derivative of f at all times. Throws symbols::NoValue for what has no meaning in the model:
// a motion Z(t), an absolute value.
class Reader {
 public:
  [[nodiscard]] kernel::Term operator()(const symbols::Term& printed);
  // There are functions D1, D2, …, the derivatives that occur, with left = right (or <, …).
  [[nodiscard]] kernel::Formula operator()(const symbols::Statement& statement);

  // Of all terms read so far: those that stay closed unless an identity needs to look inside (39, 6.d0, 7, …:
  // by the claim that says what they are), and all others.
  [[nodiscard]] const std::map<std::string, kernel::Definitions>& closed() const { return closed_; }
  [[nodiscard]] const kernel::Definitions& open() const { return open_; }
  // Those and all that they are made of.
  [[nodiscard]] kernel::Definitions all() const;

 private:
  [[nodiscard]] kernel::Term scalar(const std::string& name);
  [[nodiscard]] kernel::Term symbol(const symbols::Term& printed);
  [[nodiscard]] kernel::Term function(const symbols::Term& printed);
  [[nodiscard]] kernel::Term define(const std::string& name, const std::vector<kernel::Variable>& first,
                                    const kernel::Term& body, kernel::Definitions& among);

  std::map<std::string, kernel::Term> scalars_;
  std::map<std::string, kernel::Definitions> closed_;
  kernel::Definitions open_;
  std::vector<std::pair<kernel::Variable, kernel::Term>>
      rates_;  // of the derivatives: D, and what it is the derivative of
};

// The parameters' domain, which every statement supposes: 0 < omega1 < 1 < omega2, positive omega, us, ur.
[[nodiscard]] const std::vector<kernel::Theorem>& parameters();

// A printed equation as a theorem: {assumptions symbol = value, d ≠ 0, …} ⊢ its reading.
struct Identity {
  kernel::Theorem theorem;
  std::set<std::string> assumed;   // ids of the assumptions among the hypotheses
  std::vector<GiNaC::ex> nonzero;  // the hypotheses d ≠ 0, as irreducible factors
};
// By normal form, with these definitions opened (ids as in Reader::closed). Throws KernelError where the
// kernel refuses, and NoValue where the statement has no reading.
[[nodiscard]] Identity prove_identity(const symbols::Statement& statement,
                                      const std::vector<Assumption>& assumptions,
                                      const std::set<std::string>& open);

}  // namespace stickslip::proofs::methods
