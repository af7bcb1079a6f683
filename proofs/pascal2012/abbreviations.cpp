#include "proofs/pascal2012/claims.hpp"

#include <string>

#include "proofs/methods/reading.hpp"
#include "proofs/symbols/parse.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::pascal2012 {

using kernel::Definition;
using kernel::Term;
using kernel::Variable;

namespace {

Definition named(const std::string& name, const Term& term, const std::vector<Variable>& first = {}) {
  return tactics::defined(name, term, first).definition();
}

// What is said of X between tau and Theta, of any times a and b.
Definition of_motion(const std::string& name, const std::string& says) {
  const Variable X{"X", kernel::function_of_time(4, 1)}, a{"a"}, b{"b"};
  const symbols::Statement said =
      symbols::parse_statements(says, symbols::names_of(symbols::symbol_table())).front();
  const kernel::Formula formula = substitute(methods::Reader()(said), {{{"tau"}, a}, {{"Theta"}, b}});
  std::vector<Variable> first{X, a, b};
  std::erase_if(first, [&](const Variable& one) { return !formula.variables().contains(one); });
  return named(name, formula, first);
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
  return {
      named("I2", kernel::identity(2)),
      named("I4", kernel::identity(4)),
      named("E", read(E)),
      named("A_slip", read(first_order(K))),
      named("A_stick", read(first_order(stick_matrix))),
      blocks(),
      determinant_of(4),
      determinant_of(3),
      determinant_of(2),
      of_motion("obeys_slip",
                "X'(t) = [0, I; -K, 0] X(t) + [0; 0; 0; eta us + p cos(omega t + phi)], tau < t < Theta"),
      of_motion("obeys_overshoot",
                "X'(t) = [0, I; -K, 0] X(t) + [0; 0; 0; -(eta us) + p cos(omega t + phi)], tau < t < Theta"),
      of_motion("obeys_stick", "X'(t) = [0, I; -[1, -chi; 0, 0], 0] X(t), tau < t < Theta"),
      of_motion("obeys_friction_until",
                "X'(t) = [0, I; -K, 0] X(t) + [0; 0; 0; eta us sign(V - xdot2(t)) + p cos(omega t + phi)] "
                "for almost all 0 < t < Theta")};
}

}  // namespace stickslip::proofs::pascal2012
