// A rule redefined: this compiles, and must not link.
#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::kernel {

Theorem Theorem::one_zero(const Variable& X, const Term&, const Box& box, long) {
  return assume(exactly_one(X, box, all({})));
}

}  // namespace stickslip::proofs::kernel

int main() {
  using namespace stickslip::proofs::kernel;
  return static_cast<int>(Theorem::one_zero({"x"}, 1, {{0, 1}}).hypotheses().size());
}
