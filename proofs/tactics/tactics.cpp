#include "proofs/tactics/tactics.hpp"

#include <algorithm>
#include <optional>

#include "proofs/tactics/almost_always.hpp"
#include "proofs/tactics/text.hpp"

namespace stickslip::proofs::tactics {

using namespace kernel;

Theorem above(const Term& lower, const Variable& x) {
  return Theorem::assume(less(lower, x));
}
Theorem below(const Variable& x, const Term& upper) {
  return Theorem::assume(less(x, upper));
}

bool is_inequality(const Formula& formula) {
  return formula.kind() == Kind::less || formula.kind() == Kind::at_most;
}

const std::vector<Term>& sides_of(const Formula& relation) {
  if (relation.kind() != Kind::equal && !is_inequality(relation)) {
    throw KernelError("it has no two sides to be compared: " + to_string(relation));
  }
  return relation.parts();
}

Term gap_of(const Formula& relation) {
  const std::vector<Term>& sides = sides_of(relation);
  return sides[1] - sides[0];
}

Term unit(int rows, int columns, std::size_t place) {
  std::vector<Term> entries(static_cast<std::size_t>(rows * columns), 0);
  entries.at(place) = 1;
  return matrix(rows, columns, entries);
}

Term defined(const std::string& name, const Term& body, const std::vector<Variable>& first) {
  std::vector<Variable> parameters = first;
  std::ranges::copy_if(body.variables(), std::back_inserter(parameters),
                       [&](const Variable& one) { return std::ranges::find(first, one) == first.end(); });
  return Definition(name, parameters, body)({parameters.begin(), parameters.end()});
}

Definitions definitions_in(std::vector<Term> terms) {
  Definitions found;
  while (!terms.empty()) {
    std::vector<Term> bodies;
    each_part(terms, [&](const Term& part) {
      if (part.kind() == Kind::defined && found.insert(part.definition()).second) {
        bodies.push_back(part.definition().body());
      }
      return true;
    });
    terms = bodies;
  }
  return found;
}

Theorem symmetric(const Theorem& equation) {
  const Term a = equation.conclusion().parts().at(0);
  const Variable x = fresh(a.type(), {equation.conclusion()});
  return Theorem::replace(equation, x, equal(x, a), Theorem::reflexive(a));
}

Theorem both(const std::vector<Theorem>& parts) {
  std::vector<Formula> formulas;
  for (const Theorem& theorem : parts) {
    formulas.push_back(theorem.conclusion());
  }
  return Theorem::consequence(parts, all(formulas));
}

Theorem part(const Theorem& conjunction, std::size_t index) {
  return Theorem::consequence({conjunction}, conjunction.conclusion().parts().at(index));
}

std::vector<Theorem> parts_of(const Theorem& conjunction) {
  std::vector<Theorem> parts;
  for (const Formula& one : conjunction.conclusion().parts()) {
    parts.push_back(Theorem::consequence({conjunction}, one));
  }
  return parts;
}

Theorem cut_all(const std::vector<Theorem>& lemmas, Theorem theorem) {
  for (const Theorem& lemma : lemmas) {
    theorem = Theorem::cut(lemma, theorem);
  }
  return theorem;
}

Theorem there_are(const std::vector<Variable>& names, Formula formula, const kernel::Substitution& values,
                  Theorem theorem) {
  for (auto name = names.rbegin(); name != names.rend(); ++name) {
    formula = exists(*name, formula);
    const auto value = values.find(*name);
    theorem = Theorem::witness(theorem, substitute(formula, values),
                               value != values.end() ? value->second : Term(*name));
  }
  return theorem;
}

Theorem there_are(const std::vector<Variable>& names, const Theorem& theorem) {
  return there_are(names, theorem.conclusion(), {}, theorem);
}

Theorem detach(const Theorem& implication, const Theorem& premise) {
  return Theorem::consequence({implication, premise}, implication.conclusion().parts().at(1));
}

Theorem at(const Theorem& theorem, const Term& x, const Theorem& premise) {
  return detach(Theorem::specialize(theorem, x), premise);
}

Theorem for_every(const Variable& t, const Formula& a, const Theorem& theorem) {
  return Theorem::generalize(Theorem::discharge(theorem, a), t);
}

Theorem by_rewriting(const Theorem& theorem, const Theorem& equation) {
  const Term a = equation.conclusion().parts().at(0);
  const Variable place = fresh(a.type(), {theorem.conclusion(), equation.conclusion()});
  return Theorem::replace(equation, place, replaced(theorem.conclusion(), a, place), theorem);
}

Theorem settled_by(Theorem theorem, const Lemma& lemma) {
  const Formulas hypotheses = theorem.hypotheses();
  for (const Formula& one : hypotheses) {
    if (const std::optional<Theorem> known = lemma(one)) {
      theorem = Theorem::cut(*known, theorem);
    }
  }
  return theorem;
}

Theorem either_side(const Theorem& before, const Theorem& after, const Term& x, const Term& c) {
  return Theorem::consequence({Theorem::discharge(before, at_most(x, c)),
                               Theorem::discharge(after, at_most(c, x)), Theorem::trichotomy(x, c)},
                              before.conclusion());
}

Theorem impossible(const Formula& a, const Theorem& contradiction) {
  return Theorem::consequence(
      {Theorem::discharge(contradiction, a), Theorem::trichotomy(0, 0), Theorem::reflexive(0)}, negation(a));
}

Theorem different(const Theorem& inequality) {
  const Term a = inequality.conclusion().parts().at(0), b = inequality.conclusion().parts().at(1);
  const Theorem cases = Theorem::trichotomy(a, b);
  const Term d = a == Term(0) ? b : a;
  const Theorem zero = Theorem::assume(equal(d, 0));
  const Theorem turned = a == Term(0) ? symmetric(zero) : zero;  // a = b
  return Theorem::consequence({Theorem::discharge(turned, equal(d, 0)), cases, inequality}, differ(d, 0));
}

Theorem refuted(const Formula& claim, const Term& t, const Theorem& counterexample) {
  const Theorem one = Theorem::discharge(Theorem::specialize(Theorem::assume(claim), t), claim);
  return Theorem::consequence({one, counterexample}, negation(claim));
}

Theorem zero_product(const Term& a, const Term& b) {
  static thread_local const Variable u{"u"}, v{"v"};
  static thread_local const Theorem lemma = [] {
    const Formula zero = equal(Term(u) * v, 0), factor = differ(u, 0);
    const Theorem other =
        Theorem::combination(equal(v, 0), {{Theorem::assume(zero), inverse(u)}});  // where u is not 0
    return Theorem::discharge(
        Theorem::consequence({Theorem::discharge(other, factor)}, any({equal(u, 0), equal(v, 0)})), zero);
  }();
  return Theorem::instantiate(lemma, {{u, a}, {v, b}});
}

Theorem inverse_of(const Theorem& product) {
  const Formula& said = product.conclusion();
  if (said.kind() != Kind::equal || said.parts()[0].kind() != Kind::product) {
    throw KernelError("an inverse is known by a product of two matrices");
  }
  const std::vector<Term>& factors = said.parts()[0].parts();
  const int n = factors[0].type().rows;
  const Variable A{"A", factors[0].type()}, B{"B", factors[1].type()}, M{"M", real_matrix(n, n)};
  const Formula unit = equal(Term(A) * B, identity(n));
  const Term one = determinant(A) * determinant(B);
  const Theorem of_product = Theorem::combination(equal(one, determinant(Term(A) * B)));
  const Theorem of_unit = Theorem::replace(Theorem::assume(unit), M, equal(one, determinant(M)), of_product);
  const Formula zero = equal(determinant(A), 0);
  const Theorem absurd = Theorem::combination(
      equal(1, 0), {{Theorem::assume(zero), determinant(B)}, {of_unit, -1}});  // det(A) det(B) = 1
  const Theorem differs = Theorem::consequence(
      {Theorem::discharge(absurd, zero), different(Theorem::sign(less(0, 1)))}, negation(zero));
  const Theorem lemma = Theorem::cut(
      differs, Theorem::combination(equal(inverse(A), B), {{Theorem::assume(unit), -inverse(A)}}));
  const Theorem instance =
      Theorem::instantiate(Theorem::discharge(lemma, unit), {{A, factors[0]}, {B, factors[1]}});
  return detach(instance, product);
}

Theorem below_by_squares(const Theorem& squares, const Theorem& not_negative, const Term& a, const Term& b) {
  const Formula wrong = at_most(b, a);
  const Theorem assumed = Theorem::assume(wrong);
  const Theorem too_large =
      Theorem::order(at_most(power(b, 2), power(a, 2)),
                     {Positive{{assumed, assumed}}, Positive{{assumed, not_negative}, 2}});
  return Theorem::consequence({Theorem::discharge(too_large, wrong), squares,
                               Theorem::trichotomy(power(a, 2), power(b, 2)), Theorem::trichotomy(a, b)},
                              less(a, b));
}

Theorem at_most_by_squares(const Theorem& squares, const Theorem& not_negative, const Term& a,
                           const Term& b) {
  const Formula wrong = less(b, a);
  const Theorem assumed = Theorem::assume(wrong);
  const Theorem none = Theorem::order(
      less(0, 0), {Positive{{assumed, assumed}}, Positive{{assumed, not_negative}, 2}, Positive{{squares}}});
  return Theorem::consequence({impossible(wrong, none), Theorem::trichotomy(a, b)}, at_most(a, b));
}

Theorem by_normal_form(const Formula& equation, const Definitions& unfolded, const Domain& domain) {
  return nonzero(Theorem::combination(equation, {}, unfolded), domain);
}

Theorem by_combination(const Formula& equation, const std::vector<Multiple>& multiples,
                       const Definitions& unfolded, const Domain& domain) {
  return nonzero(Theorem::combination(equation, multiples, unfolded), domain);
}

Theorem by_positive_combination(const Formula& inequality, const std::vector<Positive>& positives,
                                const std::vector<Multiple>& multiples, const Definitions& unfolded,
                                const Domain& domain) {
  return nonzero(Theorem::order(inequality, positives, multiples, unfolded), domain);
}

namespace {

// The matrix A of a rate A x + f.
std::optional<Term> linear_part(const Term& rate, const Term& x) {
  const Term& first = rate.kind() == Kind::sum ? rate.parts()[0] : rate;
  return first.kind() == Kind::product && first.parts()[1] == x ? std::optional(first.parts()[0])
                                                                : std::nullopt;
}

// (flow (z - forced))' = 0, from flow' = -flow A and (z - forced)' = A (z - forced), each by normal form: two
// small identities in the place of a large one. Nothing if they are not so simple.
std::optional<Theorem> flat_in_two_steps(const Term& value, const Theorem& rate,
                                         const Definitions& unfolded) {
  const std::optional<Term> A = linear_part(
      rate.conclusion().parts()[2], apply(rate.conclusion().parts()[0], rate.conclusion().parts()[1]));
  if (!A || value.kind() != Kind::sum || value.parts().size() != 2 ||
      value.parts()[0].kind() != Kind::product || value.parts()[1].kind() != Kind::product) {
    return std::nullopt;
  }
  const Term &flow_rate = value.parts()[0].parts()[0], &w = value.parts()[0].parts()[1],
             &flow = value.parts()[1].parts()[0], &w_rate = value.parts()[1].parts()[1];
  return attempt([&] {
    const Theorem backward = Theorem::combination(equal(flow_rate, -(flow * *A)), {}, unfolded);
    const Theorem forward = Theorem::combination(equal(w_rate, *A * w), {}, unfolded);
    return Theorem::combination(equal(value, zero(value.type())), {{backward, 1, w}, {forward, flow, 1}});
  });
}

}  // namespace

Theorem by_differential_equation(const Motion& motion, const Term& z, const Term& flow, const Term& forced,
                                 const Variable& t, const std::vector<Multiple>& because,
                                 const Definitions& unfolded, const Domain& domain) {
  const Formula& smooth = motion.continuity.conclusion();
  const Term a = smooth.parts().at(1), b = smooth.parts().at(2);
  const Term G = lambda(t, apply(flow, a - t) * (apply(z, t) - apply(forced, t)));
  // Inside, G' = 0.
  const auto flat_by = [&](const Theorem& rate) {
    const Theorem slope = Theorem::differentiate(G, t, {rate});
    const Term value = slope.conclusion().parts()[2];
    const std::optional<Theorem> two_steps = flat_in_two_steps(value, rate, unfolded);
    const Theorem nothing =
        two_steps ? *two_steps : Theorem::combination(equal(value, zero(value.type())), because, unfolded);
    return nonzero(by_rewriting(slope, nothing), domain);
  };
  const Formula inside_open = between(a, t, b);
  const Theorem flat =
      motion.rate.conclusion().kind() == Kind::finite
          ? but_finitely_often(
                {motion.rate}, a, b, t,
                [&](const Theorem&, const std::vector<Theorem>& usually) { return flat_by(usually.front()); })
          : for_every(t, inside_open, flat_by(at(motion.rate, t, Theorem::assume(inside_open))));
  // So G(t) = G(a), and flow(t - a) undoes flow(a - t).
  const Theorem continuous_G = nonzero(Theorem::continuity(G, a, b, {motion.continuity}), domain);
  const Theorem constant = Theorem::constant(continuous_G, flat);
  const Formula inside_closed = within(a, t, b);
  const Theorem kept = at(constant, t, Theorem::assume(inside_closed));
  const Formula closed_form =
      equal(apply(z, t), apply(flow, t - a) * (apply(z, a) - apply(forced, a)) + apply(forced, t));
  const Term forth = apply(flow, t - a), back = apply(flow, a - t), still = apply(flow, a - a);
  const auto is_identity = [&](const Term& matrix) {
    return Theorem::combination(equal(matrix, identity(matrix.type().rows)), {}, unfolded);
  };
  try {
    return for_every(t, inside_closed,
                     by_combination(closed_form,
                                    {{kept, forth},
                                     {is_identity(forth * back), -1, apply(z, t) - apply(forced, t)},
                                     {is_identity(still), forth, apply(z, a) - apply(forced, a)}},
                                    {}, domain));
  } catch (const KernelError&) {  // then all at once
    return for_every(t, inside_closed, by_combination(closed_form, {{kept, forth}}, unfolded, domain));
  }
}

}  // namespace stickslip::proofs::tactics
