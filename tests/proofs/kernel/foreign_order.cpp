// A program of somebody else's, on the kernel alone, who says how terms are ordered: that all are alike. The
// kernel's sets have an order of their own, so that no hypothesis is lost. It links no computer algebra.
#include <functional>

#include "proofs/kernel/theorem.hpp"

using namespace stickslip::proofs::kernel;

template <>
struct std::less<Term> {
  bool operator()(const Term&, const Term&) const { return false; }
};
template <>
struct std::less<Variable> {
  bool operator()(const Variable&, const Variable&) const { return false; }
};

int main() {
  const Variable x{"x"}, y{"y"};
  const Theorem both = Theorem::consequence(
      {Theorem::assume(less(0, x)), Theorem::assume(less(0, y)), Theorem::assume(equal(x, y))}, less(0, x));
  const Theorem moved = Theorem::instantiate(both, {{x, Term(y) + 1}, {y, 2}});
  const bool all_there = both.hypotheses().size() == 3 && both.hypotheses().contains(equal(x, y)) &&
                         equal(x, y).variables().size() == 2 && moved.conclusion() == less(0, Term(y) + 1) &&
                         moved.hypotheses().size() == 3;
  return all_there ? 0 : 1;
}
