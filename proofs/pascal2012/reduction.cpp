#include "proofs/pascal2012/reduction.hpp"

#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012::reduction {

using namespace methods;
using namespace symbols;
using namespace symbolic::algebra;

namespace {

namespace v = symbols::vocabulary;

// Q and d0 by their modes: what (0, p) and (0, eta us) contribute to each.
Vector2 by_modes(const ex& force, const ex& shift) {
  const model::Modes<ex> m = modes();
  const ex share = force / (m.lambda2 - m.lambda1);
  const Vector2 y{ex(-share / (m.omega1 * m.omega1 - shift)), ex(share / (m.omega2 * m.omega2 - shift))};
  return model::Lambda<ex>(m) * y;
}

// Every pair that `compare` builds from the model's own formulas is equal, entry by entry.
Proof by_comparison(Compare compare) {
  return [compare](Prover& prover, const Claim& claim) {
    Outcome outcome;
    outcome.route = "the model's own formulas compared in the kernel, for all values of the symbols";
    Flows flows;
    Derivation derivation(prover, claim);
    try {
      for (const Equal& equal : compare(flows)) {
        for (Eigen::Index i = 0; i < equal.left.size(); ++i) {
          const kernel::Formula entry =
              kernel::equal(derivation.read(equal.left(i)), derivation.read(equal.right(i)));
          // Not kept to be shown: the terms of a sum stand in an order that differs from run to run.
          derivation.record(outcome, derivation.settled(derivation.combination(entry)));
        }
        outcome.decided.push_back({std::nullopt, equal.left, equal.right, Truth::proved});
      }
      outcome.verdict = Verdict::proved();
    } catch (const kernel::KernelError& error) {
      outcome.verdict = Verdict::undecided(error.what());
    }
    outcome.uses.merge(flows.used);
    return outcome;
  };
}

}  // namespace

model::Modes<ex> modes() {
  return {symbol("omega1"), symbol("omega2"), symbol("lambda1"), symbol("lambda2")};
}
Vector2 load() {
  return by_modes(symbol("p"), symbol("omega") * symbol("omega"));
}
Vector2 rest() {
  return by_modes(symbol("eta") * symbol("us"), 0);
}
ex period() {
  return 2 * GiNaC::Pi / symbol("omega");
}

Vector4 Flows::slip(const Vector4& Z0, const ex& psi0, const ex& t) {
  used.merge(std::set<std::string>{"5", "7.modal"});
  return model::slip_flow<ex>(modes(), load(), symbol("omega"), psi0, Z0, t);
}

Vector4 Flows::overshoot(const Vector4& Z0, const ex& psi0, const ex& t) {
  used.merge(std::set<std::string>{"8", "7.modal"});
  return model::overshoot_flow<ex>(modes(), load(), rest(), symbol("omega"), psi0, Z0, t);
}

Vector4 Flows::stick(const Vector4& Z0, const ex& t) {
  used.insert("10");
  return model::stick_flow<ex>(symbol("chi"), Z0, t);
}

Vector4 from_modes(const Vector2& y, const Vector2& ydot) {
  const model::Matrix2<ex> Lambda = model::Lambda<ex>(modes());
  return model::stack<ex>(Vector2(Lambda * y), Vector2(Lambda * ydot));
}
Vector2 to_modes(const Vector2& z) {
  return model::inverse<ex>(model::Lambda<ex>(modes())) * z;
}

Vector2 row_scale() {
  const ex scale = modes().lambda2 - modes().lambda1;
  return {scale, -scale};
}

Vector2 half_angles(const ex& duration) {
  return {symbol("omega1") * duration / 2, symbol("omega2") * duration / 2};
}
Vector2 frequencies() {
  return {symbol("omega1"), symbol("omega2")};
}

Assumption nonzero(const std::string& id, const Term& term) {
  return {id, {term, 0, Relation::not_equal}};
}

std::vector<Assumption> off_load_resonance() {
  return {nonzero("resonance", v::omega - v::omega1), nonzero("resonance", v::omega - v::omega2)};
}

std::vector<Assumption> durations(const std::vector<Term>& terms) {
  std::vector<Assumption> result = off_load_resonance();
  for (const Term& term : terms) {
    result.push_back(nonzero("duration", term));
  }
  return result;
}

Claim reduced(const std::string& id, const std::string& words, Compare compare,
              const std::vector<Assumption>& assumptions) {
  return {.id = id,
          .kind = Kind::step,
          .origin = Origin::auxiliary,
          .words = words,
          .assumptions = assumptions,
          .prove = by_comparison(compare)};
}

}  // namespace stickslip::proofs::pascal2012::reduction
