#include "proofs/pascal2012/abbreviations.hpp"

#include <string>

#include "proofs/methods/reading.hpp"
#include "proofs/pascal2012/half_period.hpp"

namespace stickslip::proofs::pascal2012 {

using kernel::Definition;
using kernel::Term;
using kernel::Variable;

namespace {

// Of all that the term depends on, these first.
Definition named(const std::string& name, const Term& term, const std::vector<Variable>& first = {}) {
  std::vector<Variable> parameters = first;
  for (const Variable& one : term.variables()) {
    if (std::ranges::find(first, one) == first.end()) {
      parameters.push_back(one);
    }
  }
  return {name, parameters, term};
}

Definition phase(const std::string& name,
                 methods::Assumption (*assumed)(const symbols::Term&, const symbols::Term&)) {
  using namespace symbols::vocabulary;
  const Variable X{"X", kernel::function_of_time(4, 1)}, a{"a"}, b{"b"};
  const kernel::Formula read = methods::Reader()(assumed(tau, Theta).statement);
  return named(name, substitute(read, {{{"tau"}, a}, {{"Theta"}, b}}), {X, a, b});
}

}  // namespace

std::vector<Definition> abbreviations() {
  using namespace symbols::vocabulary;
  methods::Reader read;
  return {named("I2", kernel::identity(2)),
          named("I4", kernel::identity(4)),
          named("E", read(E)),
          named("A_slip", read(first_order(K))),
          named("A_stick", read(first_order(stick_matrix))),
          phase("obeys_slip", half_period::slips_below_belt),
          phase("obeys_overshoot", half_period::slips_above_belt),
          phase("obeys_stick", half_period::sticks)};
}

}  // namespace stickslip::proofs::pascal2012
