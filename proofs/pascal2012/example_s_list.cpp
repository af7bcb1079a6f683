// Section 4, example S: the list of all solutions of the reduced equations, and the u_r that is printed among
// the data of Fig. 2 against it.
#include <fmt/format.h>

#include <algorithm>

#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/frequencies.hpp"
#include "proofs/pascal2012/symmetric_list.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace methods;

namespace {

const Example& printed() {
  return example_named("S");
}

// The one of both inequalities that holds.
kernel::Theorem decided_one_of(const kernel::Formula& either, const orbits::Ranges& ranges) {
  for (const kernel::Formula& relation : either.parts()) {
    try {
      return kernel::Theorem::sign(relation, orbits::ranges_in(relation, ranges));
    } catch (const kernel::KernelError&) {
      continue;
    }
  }
  throw kernel::KernelError("some orbit may have this value");
}

}  // namespace

std::vector<Rational> slips_at(const OrbitList& list, int phase) {
  std::vector<Rational> result;
  for (const Orbit& orbit : list.orbits) {
    const Ball later =
        orbit.value("phi") - (Ball::pi() - Ball(printed().data.omega) * orbit.value("tau")) / 2;
    if (later.is_positive() == (phase < 0)) {
      result.push_back(orbits::near(orbit.value("tau")));
    }
  }
  return result;
}

kernel::Formula is_not_printed(const char * name, const kernel::Term& value) {
  const Decimal given = printed().result(name).value;
  return kernel::any({kernel::less(value, given.lower()), kernel::less(given.upper(), value)});
}

kernel::Theorem at_all_solutions(const SymmetricEquations& e, const SymmetricList& list,
                                 const kernel::Formula& goal, const orbits::Ranges& frequencies) {
  using namespace kernel;
  const Formula during = between(0, e.tau, e.Theta);
  const std::size_t count = list.tau.size();

  // The list, opened.
  Formula said = list.theorem.conclusion();
  std::vector<std::pair<Variable, Formula>> openings;
  for (std::size_t k = 0; k < count; ++k) {
    for (const Variable& x : {list.tau[k], list.C[k]}) {
      openings.emplace_back(x, said);
      said = opened(said, x);
    }
  }
  const Theorem known = Theorem::assume(said);
  const Formula every = said.parts().back();
  const Formula rows = opened(opened(every, e.tau).parts()[1], e.C).parts()[0];
  const Theorem one_of =
      tactics::at(tactics::at(Theorem::consequence({known}, every), e.tau, Theorem::assume(during)), e.C,
                  Theorem::assume(rows));
  std::vector<Theorem> cases{one_of};
  for (std::size_t k = 0; k < count; ++k) {
    const std::vector<Formula>& parts = list.says[k].parts();
    const orbits::Ranges bounds{{list.tau[k], {parts[0].parts()[0].value(), parts[1].parts()[1].value()}},
                                {list.C[k], {parts[2].parts()[0].value(), parts[3].parts()[1].value()}}};
    orbits::Ranges here = frequencies;
    here.insert(bounds.begin(), bounds.end());
    const Formula there = substitute(goal, {{e.tau, list.tau[k]}, {e.C, list.C[k]}});
    Theorem other = Theorem::consequence({decided_one_of(there, here)}, there);
    for (const auto& [x, range] : bounds) {
      for (const auto& [bound, strict] : {std::pair{at_most(range.first, x), less(range.first, x)},
                                          {at_most(x, range.second), less(x, range.second)}}) {
        other =
            Theorem::cut(x == list.tau[k] ? Theorem::order(bound, {{{Theorem::consequence({known}, strict)}}})
                                          : Theorem::consequence({known}, bound),
                         other);
      }
    }
    for (const auto& [x, value] : {std::pair{e.tau, list.tau[k]}, {e.C, list.C[k]}}) {
      const Formula equation = equal(x, value);
      other = tactics::by_rewriting(other, tactics::symmetric(Theorem::assume(equation)));
    }
    for (const auto& [x, value] : {std::pair{e.tau, list.tau[k]}, {e.C, list.C[k]}}) {
      other = Theorem::discharge(other, equal(x, value));
    }
    cases.push_back(other);
  }
  Theorem result =
      tactics::for_every(e.tau, during, tactics::for_every(e.C, rows, Theorem::consequence(cases, goal)));
  for (auto opening = openings.rbegin(); opening != openings.rend(); ++opening) {
    result = Theorem::choose(Theorem::assume(opening->second), opening->first, result);
  }
  return Theorem::cut(list.theorem, result);
}

namespace {

// At both phases of the load.
kernel::Theorem at_both(const OrbitList& list,
                        const std::function<kernel::Theorem(const SymmetricEquations&, const SymmetricList&,
                                                            int, const orbits::Ranges&)>& theorem) {
  return at_frequencies(printed().data.chi, printed().data.eta, [&](const orbits::Ranges& ranges) {
    const SymmetricEquations equations(printed());
    std::vector<kernel::Theorem> parts;
    for (const int phase : {1, -1}) {
      const SymmetricList found = symmetric_list(equations, printed(), phase, ranges, slips_at(list, phase));
      parts.push_back(theorem(equations, found, phase, ranges));
    }
    return tactics::both(parts);
  });
}

// Fig. 2 gives u_r as a datum, beside the others.
Outcome friction_is_no_datum(Prover&, const Claim&) {
  const OrbitList& list = orbits_of(printed()).list;
  const Decimal given = printed().result("ur").value;
  Outcome outcome = at_the_data(printed(), "the $u_r$ of each orbit in the complete list, in balls");
  outcome.uses = {"S.list", "S.lag"};
  outcome.verdict = Verdict::undecided("the list is not complete");
  if (!list.complete() || list.orbits.empty()) {
    return outcome;
  }
  const Ball stated = Ball::hull(Ball(given.lower()), Ball(given.upper()));
  if (std::ranges::any_of(list.orbits, [&](const Orbit& orbit) { return orbit.ur().overlaps(stated); })) {
    outcome.verdict = Verdict::undecided("some orbit may have this u_r");
    return outcome;
  }
  outcome.verdict = Verdict::refuted(Witness{outcome.at,
                                             {},
                                             printed_orbit(printed()).value("ur"),
                                             Ball(given.value),
                                             "$u_r$ of the orbit",
                                             "the printed one"});
  prove(outcome, [&] {
    return at_both(list, [](const SymmetricEquations& e, const SymmetricList& found, int phase,
                            const orbits::Ranges& frequencies) {
      return at_all_solutions(e, found, is_not_printed("ur", substitute(e.ur, {{e.sigma, phase}})),
                              frequencies);
    });
  });
  return outcome;
}

}  // namespace

Proofs friction_of_S() {
  return {{"S.data", friction_is_no_datum}};
}

ListTheorem list_of_S() {
  return {[](const OrbitList& list) {
            return at_both(list, [](const auto&, const SymmetricList& found, auto, const auto&) {
              return found.theorem;
            });
          },
          {"16.reduced", "16.reduced.converse", "15.reduced", "15.reduced.converse"},
          "for each of both phases of the load the two reduced equations (16.reduced) have exactly two "
          "solutions $tau$, $C$ with $0 < tau < Theta$, at frequencies that give the $chi$ and $eta$ of "
          "Fig. 2"};
}

}  // namespace stickslip::proofs::pascal2012
