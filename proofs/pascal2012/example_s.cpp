// Section 4, example S: the orbit of Fig. 2, and the numbers that are printed for it.
#include <array>

#include "model/symmetric.hpp"
#include "numeric/families/symmetric.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/printed_example.hpp"
#include "proofs/pascal2012/symmetric_list.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::motion;
using namespace methods;

namespace {

const Example& printed() {
  return example_named("S");
}

// What (16) leaves at the printed decimals, with the paper's load phase.
std::vector<Ball> left_by_16() {
  const Printed<Ball> number{printed()};
  const auto a = families::symmetric_data(printed().data, families::LoadPhase::first);
  const model::Vector2<Ball> Q = model::Q<Ball>(number.data(), a.m) * a.sigma;
  const model::Vector4<Ball> left =
      model::symmetric_residual<Ball>(a.chi, a.m, Q, a.omega, a.Theta, number("tau"),
                                      {number("z10"), number("z20")}, {number("zdot10"), a.V});
  return {left.begin(), left.end()};
}

// By 16.zeros and 16.det, as the determinant does not vanish over the printed interval: for all tau there and
// all z(0), z1'(0) not both of (16).
kernel::Theorem does_not_close(const kernel::Theorem& zeros, const kernel::Theorem& factors) {
  using kernel::Formula;
  using kernel::Term;
  using kernel::Theorem;
  using kernel::Variable;
  const ExactParameters& a = printed().data;
  const Variable tau{"tau"};
  const std::vector<Variable> unknowns{{"z10"}, {"z20"}, {"zdot10"}};
  const Decimal decimal = printed().result("tau").value;
  return at_frequencies(a.chi, a.eta, [&](orbits::Ranges ranges) {
    Theorem result = Theorem::instantiate(tactics::by_rewriting(zeros, factors),
                                          {{{"T"}, Term(2) * kernel::pi() / Term(a.omega) - tau},
                                           {{"omega"}, a.omega},
                                           {{"p"}, a.p},
                                           {{"V"}, a.V},
                                           {{"zdot20"}, a.V}});
    std::vector<Formula> solved;
    result = tactics::settled_by(result, [&](const Formula& one) -> std::optional<Theorem> {
      if (one.variables().contains(unknowns[0])) {
        solved.push_back(one);
        return std::nullopt;
      }
      return one.kind() == kernel::Kind::equal ? Theorem::reflexive(one.parts()[0])
                                               : orbits::sign(one, ranges);
    });
    ranges.emplace(tau, kernel::Interval{decimal.lower(), decimal.upper()});
    const Formula both = kernel::all(solved);
    result = tactics::cut_all(tactics::parts_of(Theorem::assume(both)), result);
    const Theorem apart = orbits::in_pieces(tau, ranges, [&](const orbits::Ranges& here) {
      return orbits::sign_by_parts(differ(result.conclusion().parts()[0], 0), here);
    });
    result = Theorem::consequence({Theorem::discharge(result, both), apart}, negation(both));
    for (const Variable& one : unknowns) {
      result = Theorem::generalize(result, one);
    }
    return orbits::for_all_in(result, {tau}, ranges);
  });
}

Outcome printed_values_close(Prover& prover, const Claim&) {
  Outcome outcome =
      at_the_data(printed(), "the determinant of (16) over the printed interval of $tau$, by signs in balls");
  outcome.uses = {"16.zeros", "16.det"};
  outcome.verdict =
      Verdict::refuted("no solution of (16) has the printed $tau$; at the printed decimals it leaves " +
                       residuals(left_by_16()));
  prove(outcome, [&] { return does_not_close(prover.theorem("16.zeros"), prover.theorem("16.det")); });
  return outcome;
}

// z10 and zdot10 as the first two of (16), which are linear in them, give them.
template <class S>
std::array<S, 2> from_the_slip(const model::Modes<S>& modes) {
  const Printed<S> number{printed()};
  const model::Parameters<S> a = number.data();
  const S tau = number("tau");
  const auto rows = [&](const S& z10, const S& zdot10) {
    return model::Vector4<S>(model::symmetric_residual<S>(a.chi, modes, model::Q<S>(a, modes), a.omega, tau,
                                                          tau, {z10, number("z20")}, {zdot10, a.V}));
  };
  const model::Vector4<S> rest = rows(0, 0), place = rows(1, 0) - rest, speed = rows(0, 1) - rest;
  const S determinant = place(0) * speed(1) - place(1) * speed(0);
  return {S((rest(1) * speed(0) - rest(0) * speed(1)) / determinant),
          S((rest(0) * place(1) - rest(1) * place(0)) / determinant)};
}

Claim by_the_slip(const std::string& name, std::size_t which) {
  using tactics::Symbolic;
  return computed_from(
      printed(), name, "a solution of the slip's half of (16), a function",
      [which] { return from_the_slip(printed_orbit(printed()).motion.oscillator.modes).at(which); },
      [which](const Decimal& decimal, bool it_is) {
        const Rational chi = printed().data.chi;
        return at_frequencies(chi, printed().data.eta, [&](const orbits::Ranges& ranges) {
          const auto modes = model::modes_of<Symbolic>(
              Symbolic(kernel::Term(chi)), kernel::Variable{"omega1"}, kernel::Variable{"omega2"});
          return rounds_to(decimal, from_the_slip(modes).at(which).term, it_is, ranges);
        });
      });
}

// Which printed numbers were computed from which.
std::vector<Claim> origins() {
  const Example& example = printed();
  return {computed_by(example, "T", "$Theta - tau$",
                      [](const auto& printed) { return printed("Theta") - printed("tau"); }),
          computed_by(example, "z20", "$V T/2$, by (16),",
                      [](const auto& printed) {
                        return printed.data().V * printed("T") * printed.number(Rational(1, 2));
                      }),
          by_the_slip("z10", 0), by_the_slip("zdot10", 1),
          computed_by(example, "ur", "(12) solved for $u_r$", [](const auto& printed) {
            const auto a = printed.data();
            const auto cos_phi = sin(a.omega * printed("tau") * printed.number(Rational(1, 2)));
            return a.us + a.chi * (printed("z20") - printed("z10")) - a.p / a.eta * cos_phi;
          })};
}

}  // namespace

Proofs printed_values_of_S() {
  return {{"S.16", printed_values_close}};
}

std::vector<Claim> values_of_S() {
  const Claim existence =
      existence_claim(printed(),
                      "an orbit with the data of Fig. 2 exists: a slip and a stick that close, with the "
                      "paper's time lag, and obey the friction law at all times");
  return joined(
      {{existence},
       printed_values(printed(), "Krawczyk's test in balls on equations equivalent to (13) and (15)",
                      {"tau", "T", "Theta", "z10", "z20", "zdot10", "ur"})});
}

std::vector<Claim> orbit_of_S() {
  return joined({origins(), orbit_claims(printed(), list_of_S())});
}

}  // namespace stickslip::proofs::pascal2012
