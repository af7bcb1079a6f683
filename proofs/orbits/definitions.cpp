#include "proofs/orbits/definitions.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using numeric::motion::PhaseKind;

namespace {

struct Letters {
  Variable X{"X", motion_type};
  Variable a{"a"}, b{"b"}, chi{"chi"}, eta{"eta"}, us{"us"}, V{"V"}, omega{"omega"}, p{"p"}, phi{"phi"},
      ur{"ur"};
  Variable x{"x", state_type}, t{"t"};
};

}  // namespace

const Definition& friction() {
  static const Letters l;
  static const Definition definition(
      "friction_at_rest", {l.x, l.t, l.chi, l.eta, l.omega, l.p, l.phi},
      Term(l.chi) * (entry(l.x, 1) - entry(l.x, 0)) - Term(l.p) / l.eta * cos(Term(l.omega) * l.t + l.phi));
  return definition;
}

namespace {

// (2) with u = sign us during (a, b), and x2' < V or x2' > V there.
Definition slipping(const std::string& name, int sign) {
  const Letters l;
  const Term x = apply(l.X, l.t), zero = 0, one = 1;
  const Term stiffness = Term(l.chi) * l.eta;
  const Term A = matrix(4, 4,
                        {zero, zero, one, zero, zero, zero, zero, one, -1, l.chi, zero, zero, stiffness,
                         -stiffness, zero, zero});
  const Term force = Term(sign) * (Term(l.eta) * l.us) + Term(l.p) * cos(Term(l.omega) * l.t + l.phi);
  const Formula moves = derivative(l.X, l.t, A * x + matrix(4, 1, {zero, zero, zero, force}));
  const Formula side = sign > 0 ? less(entry(x, 3), l.V) : less(l.V, entry(x, 3));
  return {
      name,
      {l.X, l.a, l.b, l.chi, l.eta, l.us, l.V, l.omega, l.p, l.phi},
      all({continuous(l.X, l.a, l.b), for_all(l.t, implies(between(l.a, l.t, l.b), all({moves, side})))})};
}

// (9) during (a, b), x2' = V and |r| < ur from a on until b.
Definition sticking() {
  const Letters l;
  const Term x = apply(l.X, l.t), zero = 0, one = 1;
  const Term A = matrix(
      4, 4, {zero, zero, one, zero, zero, zero, zero, one, -1, l.chi, zero, zero, zero, zero, zero, zero});
  const Term r = friction()({x, l.t, l.chi, l.eta, l.omega, l.p, l.phi});
  return {"sticks",
          {l.X, l.a, l.b, l.chi, l.eta, l.V, l.omega, l.p, l.phi, l.ur},
          all({continuous(l.X, l.a, l.b),
               for_all(l.t, implies(between(l.a, l.t, l.b), derivative(l.X, l.t, A * x))),
               for_all(l.t, implies(all({at_most(l.a, l.t), less(l.t, l.b)}),
                                    all({equal(entry(x, 3), l.V), less(-Term(l.ur), r), less(r, l.ur)})))})};
}

}  // namespace

const Definition& phase_definition(PhaseKind kind) {
  static const Definition slips = slipping("slips", 1), overshoots = slipping("overshoots", -1),
                          sticks = sticking();
  return kind == PhaseKind::slip ? slips : kind == PhaseKind::overshoot ? overshoots : sticks;
}

}  // namespace stickslip::proofs::orbits
