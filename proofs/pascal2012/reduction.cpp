#include "proofs/pascal2012/reduction.hpp"

namespace stickslip::proofs::pascal2012::reduction {

using namespace methods;
using namespace symbols;

namespace {

// Q and d0 by their modes: what (0, p) and (0, eta us) contribute to each.
Vector2 by_modes(const Symbolic& force, const Symbolic& shift) {
  const model::Modes<Symbolic> m = modes();
  const Symbolic share = force / (m.lambda2 - m.lambda1);
  const Vector2 y{Symbolic(-share / (m.omega1 * m.omega1 - shift)),
                  Symbolic(share / (m.omega2 * m.omega2 - shift))};
  return model::Lambda<Symbolic>(m) * y;
}

}  // namespace

Symbolic symbol(const std::string& name) {
  return kernel::Variable{name};
}
Symbolic half_turn() {
  return kernel::pi();
}

model::Modes<Symbolic> modes() {
  return {symbol("omega1"), symbol("omega2"), symbol("lambda1"), symbol("lambda2")};
}
Vector2 load() {
  return by_modes(symbol("p"), symbol("omega") * symbol("omega"));
}
Vector2 rest() {
  return by_modes(symbol("eta") * symbol("us"), 0);
}
Symbolic period() {
  return 2 * half_turn() / symbol("omega");
}

Vector4 Flows::slip(const Vector4& Z0, const Symbolic& psi0, const Symbolic& t) {
  used.merge(std::set<std::string>{"5", "7.modal"});
  return model::slip_flow<Symbolic>(modes(), load(), symbol("omega"), psi0, Z0, t);
}

Vector4 Flows::overshoot(const Vector4& Z0, const Symbolic& psi0, const Symbolic& t) {
  used.merge(std::set<std::string>{"8", "7.modal"});
  return model::overshoot_flow<Symbolic>(modes(), load(), rest(), symbol("omega"), psi0, Z0, t);
}

Vector4 Flows::stick(const Vector4& Z0, const Symbolic& t) {
  used.insert("10");
  return model::stick_flow<Symbolic>(symbol("chi"), Z0, t);
}

Vector4 from_modes(const Vector2& y, const Vector2& ydot) {
  const model::Matrix2<Symbolic> Lambda = model::Lambda<Symbolic>(modes());
  return model::stack<Symbolic>(Vector2(Lambda * y), Vector2(Lambda * ydot));
}
Vector2 to_modes(const Vector2& z) {
  return model::inverse<Symbolic>(model::Lambda<Symbolic>(modes())) * z;
}

Vector2 row_scale() {
  const Symbolic scale = modes().lambda2 - modes().lambda1;
  return {scale, -scale};
}

Vector2 half_angles(const Symbolic& duration) {
  return {symbol("omega1") * duration / 2, symbol("omega2") * duration / 2};
}
Vector2 frequencies() {
  return {symbol("omega1"), symbol("omega2")};
}

Proof reduced(Compare compare) {
  return [compare](Prover& prover, const Claim& claim) {
    std::set<std::string> used;
    Outcome outcome =
        compared("the model's own formulas compared in the kernel, for all values of the symbols", prover,
                 claim, [&](Derivation& derivation) {
                   Flows flows{derivation};
                   std::vector<Equal> pairs = compare(flows);
                   used = flows.used;
                   return pairs;
                 });
    outcome.uses.merge(used);
    return outcome;
  };
}

}  // namespace stickslip::proofs::pascal2012::reduction
