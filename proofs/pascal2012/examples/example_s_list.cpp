// Section 4, example S: the list of all solutions of the reduced equations, and the u_r that is printed among
// the data of Fig. 2 against it; and that no orbit of its family has the tau or the u_r of Fig. 2, whatever
// its other values, as its state solves the reduced equations.

#include <algorithm>

#include "model/symmetric.hpp"
#include "model/waves.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/examples/symmetric_list.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace methods;
using kernel::Formula;
using kernel::Term;
using kernel::Theorem;
using kernel::Variable;

Ball lag_of(const Orbit& orbit) {
  return (Ball::pi() - Ball(example_named("S").data.omega) * orbit.tau()) / 2;
}

bool has_the_other_phase(const Orbit& orbit) {
  const Ball later = orbit.phi() - lag_of(orbit);
  return (later - Ball::pi()).contains_zero() || (later + Ball::pi()).contains_zero();
}

namespace {

const Example& printed() {
  return example_named("S");
}

// The one of both inequalities that holds.
Theorem decided_one_of(const Formula& either, const orbits::Ranges& ranges) {
  const auto decided = tactics::first_that_works(
      either.parts(), [&](const Formula& relation) { return orbits::sign(relation, ranges); });
  if (!decided) {
    throw kernel::KernelError("some orbit may have this value");
  }
  return *decided;
}

// Of numbers near tau of the orbits of Fig. 2, those of one phase of the load.
std::vector<Rational> slips_at(const OrbitList& list, int phase) {
  std::vector<Rational> result;
  for (const Orbit& orbit : list.orbits) {
    if (has_the_other_phase(orbit) == (phase < 0)) {
      result.push_back(orbits::near(orbit.tau()));
    }
  }
  return result;
}

// The value is not in the interval that the printed result of Fig. 2 stands for.
Formula is_not_printed(const char * name, const Term& value) {
  const Decimal given = printed().result(name).value;
  return kernel::any({kernel::less(value, given.lower()), kernel::less(given.upper(), value)});
}

// From the list: for all 0 < tau < Theta and all C that solve the equations one of the two inequalities of
// the goal holds, as it does at each solution. Throws KernelError where neither is decided at one of them.
Theorem at_all_solutions(const SymmetricEquations& e, const SymmetricList& list, const Formula& goal,
                         const orbits::Ranges& frequencies) {
  using namespace kernel;
  return orbits::of_orbit(list.theorem, [&](const Theorem& known) {
    const Formula during = between(0, e.tau, e.Theta);
    const Formula every = known.conclusion().parts().back();
    const Formula rows = opened(opened(every, e.tau).parts()[1], e.C).parts()[0];
    const Theorem one_of =
        tactics::at(tactics::at(Theorem::consequence({known}, every), e.tau, Theorem::assume(during)), e.C,
                    Theorem::assume(rows));
    std::vector<Theorem> cases{one_of};
    for (std::size_t k = 0; k < list.tau.size(); ++k) {
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
          other = Theorem::cut(x == list.tau[k]
                                   ? Theorem::order(bound, {{{Theorem::consequence({known}, strict)}}})
                                   : Theorem::consequence({known}, bound),
                               other);
        }
      }
      for (const auto& [x, value] : {std::pair{e.tau, list.tau[k]}, {e.C, list.C[k]}}) {
        other = tactics::by_rewriting(other, tactics::symmetric(Theorem::assume(equal(x, value))));
      }
      for (const auto& [x, value] : {std::pair{e.tau, list.tau[k]}, {e.C, list.C[k]}}) {
        other = Theorem::discharge(other, equal(x, value));
      }
      cases.push_back(other);
    }
    return tactics::for_every(e.tau, during,
                              tactics::for_every(e.C, rows, Theorem::consequence(cases, goal)));
  });
}

// At both phases of the load.
Theorem at_both(const OrbitList& list,
                const std::function<Theorem(const SymmetricEquations&, const SymmetricList&, int,
                                            const orbits::Ranges&)>& theorem) {
  return at_frequencies(printed().data.chi, printed().data.eta, [&](const orbits::Ranges& ranges) {
    const SymmetricEquations equations(printed());
    std::vector<Theorem> parts;
    for (const int phase : {1, -1}) {
      const SymmetricList found = symmetric_list(equations, phase, ranges, slips_at(list, phase));
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
  outcome.verdict = differs_at(outcome.at, printed_orbit(printed()).value("ur"), Ball(given.value),
                               "$u_r$ of the orbit", "the printed one");
  prove(outcome, [&] {
    return at_both(list, [](const SymmetricEquations& e, const SymmetricList& found, int phase,
                            const orbits::Ranges& frequencies) {
      return at_all_solutions(e, found, is_not_printed("ur", substitute(e.ur, {{e.sigma, phase}})),
                              frequencies);
    });
  });
  return outcome;
}

// What 16.halves says of a motion, at the data of Fig. 2 and with the time lag. Its hypotheses are what that
// claim supposes, and that chi is that of the data. In letters for omega and Theta: as numbers they would
// make cos(omega tau/2) and cos(tau/2) multiples of one phase.
class OrbitAtData {
 public:
  OrbitAtData(const SymmetricEquations& e, const orbits::Ranges& frequencies, const Theorem& halves)
      : e_(e),
        frequencies_(frequencies),
        h_((Term(Theta_) - e.tau) / 2),
        data_{{{chi_, Term(printed().data.eta), Term(printed().data.us), Term(printed().data.V), omega_,
                Term(printed().data.p)},
               model::modes_of<Symbolic>(chi_, e.omega1, e.omega2),
               Theta_},
              e.sigma},
        known_(in_letters(halves)) {}

  // The amplitude of the stick about its middle.
  [[nodiscard]] Term C() const { return at_data(amplitude()); }
  // Both reduced equations hold.
  [[nodiscard]] Theorem solves() const {
    const auto reduced = model::symmetric_rows<Symbolic>(data_, e_.tau);
    const Term gap = lambda(e_.omega2) - lambda(e_.omega1);
    std::vector<Theorem> rows;
    for (const int j : {0, 1}) {
      const auto which = static_cast<std::size_t>(j);
      const Term omega_j = j == 0 ? e_.omega1 : e_.omega2, other = j == 0 ? e_.omega2 : e_.omega1,
                 c = omega_j * cos(omega_j * e_.tau / 2), s = sin(omega_j * e_.tau / 2);
      std::vector<Term> row{0, 0, lambda(other) * (s * sin(h_) - c * cos(h_)), c * power(other, 2) / 2};
      row[which] = j == 0 ? gap : -gap;
      const Theorem holds = combination(equal(reduced.left(j).term * amplitude() - reduced.right(j).term, 0),
                                        {{known_, row_of(row)}});
      rows.push_back(Theorem::convert(holds, e_.hold(1, e_.tau, C()).parts().at(which), {e_.rows.at(which)}));
    }
    return tactics::both(rows);
  }
  // (12) says that u_r is that of the reduced equations.
  [[nodiscard]] Theorem friction(const Variable& ur) const {
    const numeric::motion::ExactParameters& a = printed().data;
    const Term cos_phi = cos((kernel::pi() - Term(omega_) * e_.tau) / 2);
    const Theorem breaks = Theorem::assume(equal(Term(Rational(a.chi * a.eta)) * (z20_ - z10_),
                                                 a.p * cos_phi + Term(a.eta) * (ur - Term(a.us))));
    const Symbolic of_reduced =
        model::friction_at<Symbolic>(data_, model::symmetric_start<Symbolic>(data_, e_.tau, amplitude()),
                                     model::symmetric_phase<Symbolic>(data_, kernel::pi(), e_.tau));
    const Term lever = chi_ * (1 - chi_) / 2;
    return combination(equal(of_reduced.term, ur),
                       {{breaks, Rational(1 / a.eta)}, {known_, row_of({0, 0, chi_ * cos(h_), -lever})}});
  }

 private:
  using Symbolic = tactics::Symbolic;
  [[nodiscard]] static Term row_of(const std::vector<Term>& entries) { return kernel::matrix(1, 4, entries); }
  [[nodiscard]] Term lambda(const Term& omega_j) const { return (1 - power(omega_j, 2)) / chi_; }
  [[nodiscard]] Term amplitude() const {
    return sin(h_) * (z10_ - chi_ * z20_) + cos(h_) * (zdot10_ - chi_ * data_.V.term);
  }
  [[nodiscard]] kernel::Substitution values() const {
    return {{omega_, printed().data.omega}, {Theta_, e_.Theta}, {e_.sigma, 1}};
  }
  [[nodiscard]] Term at_data(const Term& term) const { return substitute(term, values()); }

  [[nodiscard]] Theorem combination(const Formula& equation,
                                    const std::vector<kernel::Multiple>& because) const {
    const Formula here = substitute(equation, {{e_.sigma, 1}});
    Theorem result = Theorem::instantiate(Theorem::combination(here, because), values());
    const Term minus = -Term(omega_);  // at the data -1 times a number, which is no number
    result = tactics::by_rewriting(
        result, Theorem::combination(equal(at_data(minus), Rational(-printed().data.omega))));
    result = tactics::settled_by(result, [&](const Formula& one) {
      return (is_inequality(one) || tactics::is_divisor(one)) && !one.variables().contains(e_.tau)
                 ? std::optional(orbits::sign(one, frequencies_))
                 : std::nullopt;
    });
    tactics::Domain domain{tactics::above(0, e_.tau)};
    for (const Variable& omega_j : {e_.omega1, e_.omega2}) {
      for (const Formula& one : {kernel::less(0, omega_j), differ(omega_j, printed().data.omega)}) {
        domain.push_back(orbits::sign(one, frequencies_));
      }
    }
    return tactics::nonzero(result, domain);
  }

  [[nodiscard]] Theorem in_letters(const Theorem& halves) const {
    const numeric::motion::ExactParameters& a = printed().data;
    Theorem result = Theorem::instantiate(halves, {{{"p"}, a.p},
                                                   {{"us"}, a.us},
                                                   {{"V"}, a.V},
                                                   {{"T"}, Term(Theta_) - e_.tau},
                                                   {{"phi"}, (kernel::pi() - Term(omega_) * e_.tau) / 2}});
    result = tactics::settled_by(result, [](const Formula& one) {
      return one.kind() == kernel::Kind::equal && one.parts()[0] == one.parts()[1]
                 ? std::optional(Theorem::reflexive(one.parts()[0]))
                 : std::nullopt;
    });
    kernel::Definitions opened = openings({result.conclusion()}).all();
    std::erase_if(opened, [](const kernel::Definition& one) { return one.name() == "chi"; });
    result = Theorem::convert(result, unfold(result.conclusion(), opened), opened);
    const Term chi = Reader()(symbols::vocabulary::chi);
    return tactics::by_rewriting(result, Theorem::assume(equal(chi, chi_)));
  }

  const SymmetricEquations& e_;
  const orbits::Ranges& frequencies_;
  Variable omega_{"omega"}, Theta_{"Theta"};
  Term chi_ = printed().data.chi, z10_ = Variable{"z10"}, z20_ = Variable{"z20"},
       zdot10_ = Variable{"zdot10"};
  Term h_;
  model::SymmetricData<Symbolic> data_;
  Theorem known_;
};

// From the list for the time lag, at frequencies: no orbit has a value that rounds to the printed one.
Theorem has_not(const char * name, const Theorem& halves, const OrbitList& list,
                const orbits::Ranges& frequencies) {
  const SymmetricEquations e(printed());
  const SymmetricList found = symmetric_list(e, 1, frequencies, slips_at(list, 1));
  const Variable value{name};
  const bool of_friction = value != e.tau;
  const Term said = of_friction ? substitute(e.ur, {{e.sigma, 1}}) : Term(e.tau);
  const Theorem every = at_all_solutions(e, found, is_not_printed(name, said), frequencies);
  const OrbitAtData orbit(e, frequencies, halves);
  const Theorem ends = Theorem::assume(kernel::less(0, e.Theta - e.tau));
  const Theorem during =
      tactics::both({Theorem::assume(kernel::less(0, e.tau)),
                     Theorem::order(kernel::less(e.tau, e.Theta), {kernel::Positive{{ends}}})});
  Theorem result = tactics::at(tactics::at(every, e.tau, during), orbit.C(), orbit.solves());
  if (of_friction) {
    result = tactics::by_rewriting(result, orbit.friction(value));
  }
  return closed_but_frequencies(tactics::settled_by(result, [&](const Formula& one) {
    const bool may_be = tactics::is_divisor(one) || one.kind() == kernel::Kind::less;
    return may_be && orbits::ranges_in(one, frequencies).size() == one.variables().size()
               ? std::optional(orbits::sign(one, frequencies))
               : std::nullopt;
  }));
}

Proof no_orbit_has(const char * name) {
  return [=](Prover& prover, const Claim&) {
    const OrbitList& list = orbits_of(printed()).list;
    return proved_by(at_the_data(printed(), "each of them is one of the complete list, of which none has it"),
                     {"S.list", "15", "16.halves"}, [&] {
                       const Theorem halves = Theorem::cut(prover.theorem("15"), prover.theorem("16.halves"));
                       return at_frequencies(printed().data.chi, printed().data.eta,
                                             [&](const orbits::Ranges& frequencies) {
                                               return has_not(name, halves, list, frequencies);
                                             });
                     });
  };
}

}  // namespace

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

Proofs against_the_list_of_S() {
  return {{"S.data", friction_is_no_datum},
          {"S.none.tau", no_orbit_has("tau")},
          {"S.none.ur", no_orbit_has("ur")}};
}

}  // namespace stickslip::proofs::pascal2012
