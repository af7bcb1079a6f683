#include "proofs/pascal2012/abbreviations.hpp"

#include <algorithm>
#include <string>

#include "proofs/methods/reading.hpp"
#include "proofs/pascal2012/appendix5.hpp"

namespace stickslip::proofs::pascal2012 {

using kernel::Definition;
using kernel::Term;
using kernel::Variable;

namespace {

// Of all that the term depends on, those of these first.
Definition named(const std::string& name, const Term& term, const std::vector<Variable>& first = {}) {
  std::vector<Variable> parameters;
  std::ranges::copy_if(first, std::back_inserter(parameters),
                       [&](const Variable& one) { return term.variables().contains(one); });
  std::ranges::copy_if(term.variables(), std::back_inserter(parameters),
                       [&](const Variable& one) { return std::ranges::find(first, one) == first.end(); });
  return {name, parameters, term};
}

// What is assumed of X between tau and Theta, of any times a and b.
Definition of_motion(const std::string& name, const methods::Assumption& assumed) {
  const Variable X{"X", kernel::function_of_time(4, 1)}, a{"a"}, b{"b"};
  return named(name, substitute(methods::Reader()(assumed.statement), {{{"tau"}, a}, {{"Theta"}, b}}),
               {X, a, b});
}

Definition determinant_of(int rows) {
  const Variable A{"A", kernel::real_matrix(rows, rows)};
  return named("det" + std::to_string(rows), kernel::determinant(A));
}

// Made of four matrices.
Definition blocks() {
  const kernel::Type part = kernel::real_matrix(2, 2);
  const std::vector<Variable> parts{{"A", part}, {"B", part}, {"C", part}, {"D", part}};
  std::vector<Term> entries;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const auto which = static_cast<std::size_t>(2 * (row / 2) + column / 2);
      entries.push_back(kernel::entry(parts[which], row % 2, column % 2));
    }
  }
  return named("blocks", kernel::matrix(4, 4, entries));
}

}  // namespace

std::vector<Definition> abbreviations() {
  using namespace symbols::vocabulary;
  methods::Reader read;
  const symbols::Term speed = symbols::Function{"xdot2", {}}(t);
  return {named("I2", kernel::identity(2)),
          named("I4", kernel::identity(4)),
          named("E", read(E)),
          named("A_slip", read(first_order(K))),
          named("A_stick", read(first_order(stick_matrix))),
          blocks(),
          determinant_of(4),
          determinant_of(3),
          determinant_of(2),
          of_motion("obeys_slip", half_period::slips_below_belt(tau, Theta)),
          of_motion("obeys_overshoot", half_period::slips_above_belt(tau, Theta)),
          of_motion("obeys_stick", half_period::sticks(tau, Theta)),
          of_motion("obeys_friction_until", two_slips::slips_with_friction("", X(t), speed, Theta))};
}

}  // namespace stickslip::proofs::pascal2012
