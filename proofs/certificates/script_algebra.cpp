// The rules of algebra: equations and inequalities from others.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/transformed.hpp"
#include "proofs/certificates/coq_terms.hpp"
#include "proofs/certificates/script.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

// Σ left (a - b) right, and the proof that each of these products is 0, as terms z'1, z'2, ….
struct Script::Zeros {
  std::vector<Term> products;
  std::string proofs;
};

void Script::add_zero(Zeros& zeros, const Term& left, const Theorem& equation, const Term& right,
                      const Scope& scope) {
  const Term &a = equation.conclusion().parts()[0], &b = equation.conclusion().parts()[1];
  zeros.products.push_back(left * difference(a, b) * right);
  const Type& type = zeros.products.back().type();
  zeros.proofs +=
      fmt::format("  assert (z'{} : {} = {}) by (rewrite ({} {}); vanish).\n", zeros.products.size(),
                  coq(zeros.products.back()), nothing(type),
                  a.type().is_scalar() ? "rdiffer _ _" : "mdiffer _ _ _ _", term(equation, scope));
}

namespace {

// Which entry of a column of equations the step takes, if that is all it does: the multiplier is a row of
// zeros with a one.
std::optional<int> one_row(const Theorem& theorem) {
  const Step& step = theorem.derivation();
  if (step.premises.size() != 1 || step.data.size() != 3) {
    return std::nullopt;
  }
  const Term &column = step.premises[0].conclusion().parts()[0], &row = step.data[1];
  if (column.kind() != Kind::matrix || column.type().columns != 1 || row.kind() != Kind::matrix ||
      row.type().columns != column.type().rows) {
    return std::nullopt;
  }
  const auto unit = std::find(row.parts().begin(), row.parts().end(), Term(1));
  const auto i = unit - row.parts().begin();
  const bool alone = unit != row.parts().end() &&
                     std::count(row.parts().begin(), row.parts().end(), Term(0)) + 1 == row.type().columns;
  return alone && column.parts()[static_cast<std::size_t>(i)] == theorem.conclusion().parts()[0] &&
                 theorem.conclusion().parts()[1] == Term(0)
             ? std::optional(static_cast<int>(i))
             : std::nullopt;
}

}  // namespace

// inverse(A) M = N by M = A N, where that is said of two rows and nothing else is needed: without the
// determinant of A below every fraction.
std::string Script::solved(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  const Term left = theorem.conclusion().parts()[0], right = theorem.conclusion().parts()[1];
  if (!step.premises.empty() || left.kind() != Kind::product || left.parts()[0].kind() != Kind::inverse ||
      left.parts()[0].type() != real_matrix(2, 2) || right.type() != real_matrix(2, 2) ||
      !identity(left.parts()[1], left.parts()[0].parts()[0] * right, step.unfolded)) {
    return "";
  }
  needs_.insert("Inverses");
  const Term A = left.parts()[0].parts()[0], M = left.parts()[1];
  const auto divisors =
      transformed(step.divisors, [&](const Formula& one) { return hypothesis(one, scope); });
  std::string tries;
  std::string reduced = opening("", step.unfolded, " in *; ") + "reduce_matrices; ";
  for (const std::string& divisor : divisors) {
    reduced += fmt::format("reduce_matrices_in {}; ", divisor);
    tries += fmt::format("{}nonzero_like {}", tries.empty() ? "" : " | ", divisor);
  }
  return fmt::format(
      "  apply (inverse_solves {} _ _).\n  {{\n  {}first [{}].\n  }}\n"
      "  apply (by_difference_m 2 2 _ _ {}); [|reflexivity].\n{}",
      coq(A), reduced, tries, nothing(right.type()),
      normal_form(difference(M, A * right), zero(right.type()), step, scope));
}

std::string Script::combination(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  if (const std::optional<int> row = one_row(theorem)) {
    return fmt::format("  exact (f_equal (fun A => ent {} 0 A) {}).", *row, term(step.premises[0], scope));
  }
  const Term left = theorem.conclusion().parts()[0], right = theorem.conclusion().parts()[1];
  if (const std::string text = solved(theorem, scope); !text.empty()) {
    return text;
  }
  Zeros zeros;
  for (std::size_t k = 0; k < step.premises.size(); ++k) {
    add_zero(zeros, step.data[2 * k + 1], step.premises[k], step.data[2 * k + 2], scope);
  }
  const bool scalar = left.type().is_scalar();
  std::string proof = zeros.products.empty() ? "eq_refl" : "z'1";
  for (std::size_t k = 2; k <= zeros.products.size(); ++k) {
    proof = fmt::format("({} {} z'{})", scalar ? "zero_plus _ _" : "zero_mplus _ _ _ _", proof, k);
  }
  const Term total = zeros.products.empty() ? zero(left.type()) : sum(zeros.products);
  return fmt::format("  apply ({} {}).\n  {{\n{}  }}\n  {{\n{}  exact {}.\n  }}",
                     scalar ? "by_difference _ _"
                            : fmt::format("by_difference_m {} {} _ _", left.type().rows, left.type().columns),
                     zeros.products.empty() ? nothing(left.type()) : coq(total),
                     normal_form(difference(left, right), total, step, scope), zeros.proofs, proof);
}

std::string Script::order(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  const Formula& inequality = step.data[0];
  std::vector<Term> parts;
  std::string positives;
  const auto is_equation = [](const Theorem& known) { return known.conclusion().kind() == Kind::equal; };
  const auto equations =
      static_cast<std::size_t>(std::count_if(step.premises.begin(), step.premises.end(), is_equation));
  // Products first: factor, square, how many inequalities; then multiples: left, right.
  std::size_t premise = 0, datum = 1;
  for (; datum < step.data.size() - 2 * equations; datum += 3) {
    Term product = step.data[datum] * power(step.data[datum + 1], 2);
    for (long n = step.data[datum + 2].value().get_num().get_si(); n > 0; --n, ++premise) {
      const Formula& known = step.premises[premise].conclusion();
      product = product * difference(known.parts()[1], known.parts()[0]);
      positives += fmt::format("  pose proof ({} _ _ {}) as p'{}.\n",
                               known.kind() == Kind::less ? "less_gap" : "at_most_gap",
                               term(step.premises[premise], scope), premise);
    }
    parts.push_back(product);
  }
  Zeros zeros;
  for (; premise < step.premises.size(); ++premise, datum += 2) {
    add_zero(zeros, step.data[datum], step.premises[premise], step.data[datum + 1], scope);
  }
  parts.insert(parts.end(), zeros.products.begin(), zeros.products.end());
  for (std::size_t k = 1; k <= zeros.products.size(); ++k) {
    positives += fmt::format("  pose proof (Req_le_sym _ _ z'{0}) as p''{0}.\n", k);
  }
  const Term total = parts.empty() ? Term(0) : sum(parts);
  return fmt::format(
      "  apply ({} _ _ {}).\n  {{\n{}  }}\n  {{\n{}{}  positive_sum.\n  }}",
      inequality.kind() == Kind::less ? "by_less" : "by_at_most", coq(total),
      normal_form(difference(inequality.parts()[1], inequality.parts()[0]), total, step, scope), zeros.proofs,
      positives);
}

}  // namespace stickslip::proofs::certificates
