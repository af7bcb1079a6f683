// The rules of calculus.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/transformed.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/orbits/along.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

// Whether a conclusion is of a function with matrices for values.
bool of_matrices(const Theorem& theorem) {
  const Formula& formula = theorem.conclusion();
  const bool of_function = formula.kind() == Kind::derivative || formula.kind() == Kind::continuous;
  return of_function && (formula.parts()[0].type().rows > 1 || formula.parts()[0].type().columns > 1);
}

// Lemmas of the prelude that have the names of rules: how many of its arguments Coq finds itself. There are
// two more if it is of matrices.
const std::map<std::string, int> lemmas{
    {"continuous_within", 5},  {"continuous_union", 4}, {"same_continuity", 4},
    {"intermediate_value", 3}, {"monotone", 3},         {"same_derivative", 6},
    {"unique_derivative", 4},  {"finite_part", 2},      {"finite_union", 2},
};

std::string blanks(int count) {
  std::string text;
  for (int k = 0; k < count; ++k) {
    text += " _";
  }
  return text;
}

}  // namespace

std::string Script::calculus(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  if (step.rule == "differentiate" || step.rule == "continuity") {
    return by_composition(theorem, scope);
  }
  if (step.rule == "zeros_between") {
    return zeros_between(theorem, scope);
  }
  const auto premises = transformed(step.premises, [&](const Theorem& one) { return term(one, scope); });
  if (step.rule == "finite_shift") {
    return fmt::format("  exact (finite_shift _ {} {}).", coq(step.data[0]), premises[0]);
  }
  if (step.rule == "piecewise" || step.rule == "finite_point" || step.rule == "periodic") {
    std::string of = step.rule == "finite_point" ? "" : " _";
    for (const Term& data : step.data) {
      of += " " + coq(data);
    }
    return fmt::format("  exact ({}{}{} {}).", step.rule, of, step.rule == "periodic" ? " _" : "",
                       fmt::join(premises, " "));
  }
  if (step.rule == "mean_value") {
    // In the kernel b - 0 is b + 0, of which Coq knows no more than that it is equal.
    const Term& function = step.premises[0].conclusion().parts()[0];
    const Formula& rates = step.premises[1].conclusion();
    const Variable time = kernel::fresh(real_number, {function, rates});
    return fmt::format(
        "  destruct (mean_value {} {} _ _ {} {} {}) as [c' [I' E']].\n"
        "  exists c'. split; [exact I' | cbv beta in E'; lra].",
        coq(function), coq(lambda(time, opened(rates, time).parts()[1].parts()[2])), premises[2], premises[0],
        premises[1]);
  }
  const bool matrices = of_matrices(step.premises[0]);
  if (step.rule == "constant") {
    const bool everywhere = step.premises[1].conclusion().kind() == Kind::for_all;
    return fmt::format("  exact (constant{}{}{} {}).", everywhere ? "" : "_finite", matrices ? "_m" : "",
                       blanks(matrices ? 5 : 3), fmt::join(premises, " "));
  }
  const auto lemma = lemmas.find(step.rule);
  if (lemma == lemmas.end()) {
    throw KernelError("the rule " + step.rule + " has no counterpart in Coq yet");
  }
  return fmt::format("  exact ({}{}{} {}).", step.rule, matrices ? "_m" : "",
                     blanks(lemma->second + (matrices ? 2 : 0)), fmt::join(premises, " "));
}

// The whole numbers k with x = (k + 0)*pi or (k + 1/2)*pi are tried one after the other.
std::string Script::zeros_between(const Theorem& theorem, const Scope& scope) {
  const std::vector<Theorem>& premises = theorem.derivation().premises;
  const bool sine = premises[0].conclusion().parts()[0].kind() == Kind::sine;
  const Rational offset = sine ? Rational(0) : Rational(1, 2);
  const Rational from = premises[1].conclusion().parts()[0].parts()[0].value() - offset;
  const mpz_class first = orbits::rounded_down(from, 1).get_num() + 1;
  const std::size_t cases = theorem.conclusion().parts().size();
  const mpz_class last = first + cases;
  std::string text = fmt::format(
      "  destruct ({} _ {}) as [k' E'].\n  destruct (between_turns _ _ _ _ _ E' {} {}) as [L' U'].\n"
      "  assert ({} - 1 < k')%Z by (apply lt_IZR; rewrite minus_IZR; lra).\n  assert (k' < {})%Z by (apply "
      "lt_IZR; lra).\n",
      sine ? "zero_of_sine" : "zero_of_cosine", term(premises[0], scope), term(premises[1], scope),
      term(premises[2], scope), first.get_str(), last.get_str());
  for (std::size_t i = 0; i < cases; ++i) {
    std::string side;
    for (std::size_t k = 0; k < i; ++k) {
      side += "right; ";
    }
    side += i + 1 < cases ? "left; " : "";
    text += fmt::format("  destruct (Z.eq_dec k' ({})) as [->|?]; [{}rewrite E'; field|].\n",
                        mpz_class(first + i).get_str(), side);
  }
  return text + "  exfalso; lia.";
}

// The definitions in a function of time that depend on the time.
Definitions depending(const Term& function) {
  const Variable time = kernel::fresh(real_number, {function});
  Definitions found;
  const auto visit = [&](const auto& self, const Term& term) -> void {
    if (!term.variables().contains(time)) {
      return;
    }
    for (const Term& part : term.parts()) {
      self(self, part);
    }
    if (term.kind() == Kind::defined) {
      found.insert(term.definition());
      self(self, term.definition().unfolded(term.parts()));
    }
  };
  visit(visit, apply(function, time));
  return found;
}

// A derivative or continuity, by the rules for sums, products, …: what depends on the time is looked into,
// and functions with values in columns are taken apart.
std::string Script::by_composition(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  const Definitions definitions = depending(theorem.conclusion().parts()[0]);
  Variables variables = theorem.conclusion().variables();
  std::string text;
  std::vector<std::string> known;
  std::string entries;
  for (std::size_t k = 0; k < step.premises.size(); ++k) {
    const Formula& premise = step.premises[k].conclusion();
    variables.insert(premise.variables().begin(), premise.variables().end());
    const std::string name = fmt::format("d'{}", k);
    text += fmt::format("  pose proof {} as {}.\n", term(step.premises[k], scope), name);
    known.push_back(name);
    if (of_matrices(step.premises[k])) {
      const Type& type = premise.parts()[0].type();
      for (int i = 0; i < type.rows; ++i) {
        for (int j = 0; j < type.columns; ++j) {
          entries += fmt::format("  premise_entry {} {}%nat {}%nat.\n", name, i, j);
        }
      }
    }
  }
  for (const Formula& divisor : step.divisors) {
    known.push_back(hypothesis(divisor, scope));
  }
  text += opening("  ", definitions,
                  known.empty() ? ".\n" : fmt::format(" in {} |- *.\n", fmt::join(known, ", ")));
  for (const Variable& variable : variables) {
    if (variable.type == function_of_time(4, 1)) {
      const std::string name = identifier(variable.name);
      text += fmt::format("  destruct (four_functions {0}) as ({0}'1 & {0}'2 & {0}'3 & {0}'4 & ->).\n", name);
    }
  }
  text += entries;
  text += of_matrices(theorem) ? "  each_index; reduce_matrices; " : "  reduce_matrices; ";
  return text + (step.rule == "differentiate" ? "by_derivative." : "continuous.");
}

}  // namespace stickslip::proofs::certificates
