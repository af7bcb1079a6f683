// The motion of Fig. 4 obeys all that Appendix 5 assumes: its theorems are of something.
#include <algorithm>

#include "proofs/methods/derivation.hpp"
#include "proofs/methods/gate.hpp"
#include "proofs/methods/openings.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/orbits/orbit_with.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/frequencies.hpp"
#include "proofs/pascal2012/half_period.hpp"
#include "proofs/tactics/almost_always.hpp"

namespace stickslip::proofs::pascal2012::half_period {

using namespace methods;
using kernel::Formula;
using kernel::Multiple;
using kernel::Positive;
using kernel::Term;
using kernel::Theorem;
using kernel::Variable;
using numeric::motion::PhaseKind;

namespace {

const Example& printed() {
  return example_named("P");
}

// Of what P.motion says of tau, tau1, phi and X, at frequencies that give chi and eta of Fig. 4.
class MotionOfP {
 public:
  MotionOfP(const Theorem& said, const Theorem& load_returns, const orbits::Ranges& frequencies)
      : said_(said), load_returns_(load_returns), frequencies_(frequencies) {
    const numeric::motion::ExactParameters& a = printed().data;
    const Term Theta = Term(2) * kernel::pi() / Term(a.omega), tau = Variable{"tau"};
    values_ = {{{"Theta"}, Theta}, {{"V"}, a.V}, {{"omega"}, a.omega},   {{"p"}, a.p}, {{"us"}, a.us},
               {{"t"}, 0},         {Y_, X_},     {{"ur"}, *printed().ur}};
    const Term start = relative(0), middle = relative(tau);
    const std::vector<const char *> names{"z10", "z20", "zdot10", "zdot20"},
        at_tau{"z1B", "z2B", "zdot1B", "zdot2B"};
    for (std::size_t i = 0; i < 4; ++i) {
      values_.emplace(Variable{names[i]}, entry(start, static_cast<int>(i)));
      values_.emplace(Variable{at_tau[i]}, entry(middle, static_cast<int>(i)));
    }
  }

  // ⊢ there are values of all variables, but of the frequencies, with which all these formulas hold.
  [[nodiscard]] Theorem obeys(const kernel::Formulas& formulas) const {
    std::vector<Theorem> proved;
    for (const Formula& one : formulas) {
      proved.push_back(holds(substitute(one, values_)));
    }
    Theorem theorem = tactics::both(proved);
    Formula left = kernel::all({formulas.begin(), formulas.end()});
    // First, and innermost, what has a value in terms of the others.
    const kernel::Variables variables = left.variables();
    for (const bool has_value : {true, false}) {
      for (const Variable& one : variables) {
        if (!frequencies_.contains(one) && values_.contains(one) == has_value) {
          left = kernel::exists(one, left);
          theorem =
              Theorem::witness(theorem, substitute(left, values_), has_value ? values_.at(one) : Term(one));
        }
      }
    }
    return theorem;
  }

 private:
  [[nodiscard]] Theorem known(const Formula& formula) const { return Theorem::consequence({said_}, formula); }
  // X(t) - delta_0.
  [[nodiscard]] Term relative(const Term& t) const {
    return substitute(Reader()(symbols::vocabulary::Z(symbols::vocabulary::t)),
                      {{{"t"}, t}, {{"us"}, printed().data.us}});
  }

  [[nodiscard]] Theorem holds(const Formula& formula) const {
    switch (formula.kind()) {
      case kernel::Kind::conjunction: {
        std::vector<Theorem> parts;
        for (const Formula& one : formula.parts()) {
          parts.push_back(holds(one));
        }
        return tactics::both(parts);
      }
      case kernel::Kind::continuous:
        return continuity(formula);
      case kernel::Kind::for_all:
        return at_all_times(formula);
      case kernel::Kind::finite:
        return but_finitely_often(formula);
      case kernel::Kind::equal:
        return equation(formula);
      default:
        return relation(formula);
    }
  }

  // By the motion's own equations, one at a time.
  [[nodiscard]] Theorem equation(const Formula& formula) const {
    if (formula.parts()[0] == formula.parts()[1]) {
      return Theorem::reflexive(formula.parts()[0]);
    }
    if (formula == load_returns_.conclusion()) {
      return load_returns_;
    }
    std::vector<std::vector<Multiple>> attempts{{}};
    for (const Formula& one : said_.conclusion().parts()) {
      if (one.kind() == kernel::Kind::equal && one.parts()[0].type() == formula.parts()[0].type()) {
        attempts.push_back({{known(one)}});
        attempts.push_back({{known(one), -1}});
      }
    }
    for (const std::vector<Multiple>& because : attempts) {
      for (const kernel::Definitions& opened : {kernel::Definitions{}, openings({formula}).all()}) {
        try {
          return discharged(Theorem::combination(formula, because, opened));
        } catch (const kernel::KernelError&) {
          continue;
        }
      }
    }
    throw kernel::KernelError("of this motion it is not known: " + to_string(formula));
  }

  // An inequality, or that two numbers differ: of numbers, or of the durations.
  [[nodiscard]] Theorem relation(const Formula& formula) const {
    if (formula.kind() == kernel::Kind::at_most && formula.parts()[0] == formula.parts()[1]) {
      const Term& a = formula.parts()[0];
      return Theorem::consequence({Theorem::reflexive(a), Theorem::trichotomy(a, a)}, formula);
    }
    try {
      return Theorem::sign(formula, orbits::ranges_in(formula, frequencies_));
    } catch (const kernel::KernelError&) {
      for (const Formula& one : said_.conclusion().parts()) {
        if (one.kind() == kernel::Kind::less && one.parts()[0] == Term(0) && is_inequality(formula)) {
          try {
            return Theorem::order(formula, {Positive{{known(one)}}});
          } catch (const kernel::KernelError&) {
            continue;
          }
        }
      }
      throw kernel::KernelError("of this motion it is not known: " + to_string(formula));
    }
  }
  [[nodiscard]] Theorem discharged(Theorem theorem) const {
    const kernel::Formulas hypotheses = theorem.hypotheses();
    for (const Formula& one : hypotheses) {
      if (tactics::is_divisor(one)) {
        theorem = Theorem::cut(Theorem::sign(one, orbits::ranges_in(one, frequencies_)), theorem);
      }
    }
    return theorem;
  }

  // What a phase says: its motion's continuity, and for all t between its ends the derivative and the side.
  [[nodiscard]] Theorem phase(PhaseKind kind) const {
    const kernel::Definition& definition = orbits::phase_definition(kind);
    for (const Formula& one : said_.conclusion().parts()) {
      if (one.kind() == kernel::Kind::defined && one.definition() == definition) {
        return Theorem::convert(known(one), unfold(one, {definition}), {definition});
      }
    }
    throw kernel::KernelError("the motion has no such phase");
  }
  [[nodiscard]] std::vector<Theorem> phases() const {
    return {phase(PhaseKind::slip), phase(PhaseKind::overshoot)};
  }
  [[nodiscard]] Theorem continuity(const Formula& formula) const {
    const std::vector<Theorem> both = phases();
    std::vector<Theorem> found{tactics::part(both[0], 0), tactics::part(both[1], 0)};
    found.push_back(Theorem::continuous_union(found[0], found[1]));
    for (const Theorem& one : found) {
      if (one.conclusion() == formula) {
        return one;
      }
    }
    throw kernel::KernelError("of this interval nothing is known: " + to_string(formula));
  }
  // For all t: a < t < b ⇒ a derivative, or a side of the belt.
  [[nodiscard]] Theorem at_all_times(const Formula& formula) const {
    const Variable t{"s"};
    const Formula body = opened(formula, t);
    for (const Theorem& one : phases()) {
      const Theorem during = tactics::part(one, 1);
      if (opened(during.conclusion(), t).parts()[0] == body.parts()[0]) {
        const Theorem here = tactics::at(during, t, Theorem::assume(body.parts()[0]));
        return tactics::for_every(t, body.parts()[0], in_form(body.parts()[1], here));
      }
    }
    throw kernel::KernelError("the motion has no such phase: " + to_string(formula));
  }
  // Of one time: the derivative, or the inequality, as the formula has it.
  [[nodiscard]] Theorem in_form(const Formula& formula, const Theorem& here) const {
    if (formula.kind() == kernel::Kind::conjunction) {
      return tactics::both({in_form(formula.parts()[0], here), in_form(formula.parts()[1], here)});
    }
    if (formula.kind() != kernel::Kind::derivative) {
      return Theorem::order(formula, {Positive{{tactics::part(here, 1)}}});
    }
    const Theorem slope = tactics::part(here, 0);
    const Term said = slope.conclusion().parts()[2], wanted = formula.parts()[2];
    // The same once chi and eta have their values.
    kernel::Definitions definitions = openings({equal(said, wanted)}).all();
    Reader read;
    const Term chi = read(symbols::vocabulary::chi), eta = read(symbols::vocabulary::eta);
    std::erase_if(definitions, [&](const kernel::Definition& one) {
      return one == chi.definition() || one == eta.definition();
    });
    Formula same = unfold(equal(said, wanted), definitions);
    const Variable of_chi{"of chi"}, of_eta{"of eta"};
    same = replaced(replaced(same, chi, of_chi), eta, of_eta);
    const numeric::motion::ExactParameters& a = printed().data;
    Theorem result = Theorem::combination(substitute(same, {{of_chi, Term(a.chi)}, {of_eta, Term(a.eta)}}));
    const auto put_back = [&](const Variable& place, const Term& value, const Term& symbol,
                              const Formula& in) {
      result = Theorem::replace(tactics::symmetric(Theorem::assume(equal(symbol, value))), place, in, result);
    };
    put_back(of_chi, a.chi, chi, substitute(same, {{of_eta, Term(a.eta)}}));
    put_back(of_eta, a.eta, eta, substitute(same, {{of_chi, chi}}));
    result = Theorem::convert(result, equal(said, wanted), definitions);
    return tactics::by_rewriting(slope, result);
  }

  // finite t: 0 < t < Theta and not …: at tau alone.
  [[nodiscard]] Theorem but_finitely_often(const Formula& formula) const {
    const Variable t{"s"};
    const Formula body = opened(formula, t), usual = body.parts()[1].parts()[0];
    const Term tau = Variable{"tau"};
    std::vector<Theorem> cases{Theorem::trichotomy(t, tau)};
    const Theorem inside = Theorem::assume(body.parts()[0]);
    for (std::size_t k = 0; k < 2; ++k) {
      const Theorem part_of = tactics::part(phases()[k], 1);
      const Formula side = k == 0 ? kernel::less(t, tau) : kernel::less(tau, t);
      const Theorem between = k == 0 ? tactics::both({tactics::part(inside, 0), Theorem::assume(side)})
                                     : tactics::both({Theorem::assume(side), tactics::part(inside, 1)});
      const Theorem here = tactics::at(part_of, t, between);
      const Formula& either = usual.parts()[k];
      std::vector<Theorem> both;
      for (const Formula& one : either.parts()) {
        both.push_back(in_form(one, here));
      }
      cases.push_back(Theorem::discharge(Theorem::consequence({tactics::both(both)}, usual), side));
    }
    cases.push_back(Theorem::assume(body));
    const Theorem only = Theorem::consequence(cases, equal(t, tau));
    return Theorem::finite_part(
        Theorem::finite_point(tau),
        Theorem::generalize(
            Theorem::discharge(Theorem::cut(tactics::part(Theorem::assume(body), 0), only), body), t));
  }

  Theorem said_, load_returns_;
  const orbits::Ranges& frequencies_;
  Variable X_{"X", orbits::motion_type}, Y_{"Y", orbits::motion_type};
  kernel::Substitution values_;
};

}  // namespace

Claim met_by_P() {
  static const std::vector<std::string> ids{"A5.half",  "A5.second", "A5.theorem", "A5.energy",  "A5.stable",
                                            "A5.sides", "A5.moves",  "A5.unique",  "7.symmetric"};
  std::vector<std::string> parts;
  for (const std::string& id : ids) {
    parts.push_back("all that " + id + " assumes holds of the orbit of Fig. 4 as one motion");
  }
  return {
      .id = "P.meets",
      .kind = Kind::numbers,
      .origin = Origin::auxiliary,
      .words =
          "the orbit of Fig. 4, as one motion, obeys all that Appendix 5 and 7.symmetric assume: these are "
          "theorems of something",
      .prove =
          [](Prover& prover, const Claim&) {
            const numeric::motion::ExactParameters& a = printed().data;
            Outcome outcome = at_the_data(printed(), "each assumption, from what P.motion says");
            outcome.uses = {"P.motion", "28.Theta"};
            outcome.verdict = Verdict::proved();
            outcome.by_kernel = true;
            for (const std::string& id : ids) {
              try {
                outcome.theorems.push_back(
                    at_frequencies(a.chi, a.eta, [&](const orbits::Ranges& frequencies) {
                      return orbits::of_orbit(prover.theorem("P.motion"), [&](const Theorem& said) {
                        return MotionOfP(said, prover.theorem("28.Theta"), frequencies)
                            .obeys(assumed_by(prover.claim(id)));
                      });
                    }));
              } catch (const kernel::KernelError& error) {
                outcome = {};
                outcome.verdict = Verdict::undecided(id + ": " + error.what());
                break;
              }
            }
            return outcome;
          },
      .parts = parts,
      .meets = ids};
}

}  // namespace stickslip::proofs::pascal2012::half_period
