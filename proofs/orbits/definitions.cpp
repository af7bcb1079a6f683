#include "proofs/orbits/definitions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stickslip::proofs::orbits {

using namespace kernel;
using numeric::motion::PhaseKind;

namespace {

struct Alphabet {
  Variable X{"X", motion_type};
  Variable a{"a"}, b{"b"}, chi{"chi"}, eta{"eta"}, us{"us"}, V{"V"}, omega{"omega"}, p{"p"}, phi{"phi"},
      ur{"ur"};
  Variable x{"x", state_type}, t{"t"};
};

// A of X' = A X + …: of (2), of (9).
Term rates(bool slips, const Term& chi, const Term& eta) {
  const Term zero = 0, one = 1, stiffness = chi * eta;
  return matrix(4, 4,
                {zero, zero, one, zero, zero, zero, zero, one, -1, chi, zero, zero, slips ? stiffness : zero,
                 slips ? -stiffness : zero, zero, zero});
}

// (2) with u = sign us during (a, b), and x2' < V or x2' > V there.
Definition slipping(const std::string& name, int sign) {
  const Alphabet l;
  const Term x = apply(l.X, l.t), zero = 0, A = rates(true, l.chi, l.eta);
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
  const Alphabet l;
  const Term x = apply(l.X, l.t), A = rates(false, l.chi, l.eta);
  const Term r = friction()({x, l.t, l.chi, l.eta, l.omega, l.p, l.phi});
  return {"sticks",
          {l.X, l.a, l.b, l.chi, l.eta, l.V, l.omega, l.p, l.phi, l.ur},
          all({continuous(l.X, l.a, l.b),
               for_all(l.t, implies(between(l.a, l.t, l.b), derivative(l.X, l.t, A * x))),
               for_all(l.t, implies(all({at_most(l.a, l.t), less(l.t, l.b)}),
                                    all({equal(entry(x, 3), l.V), less(-Term(l.ur), r), less(r, l.ur)})))})};
}

Definition varying(const std::string& name, bool slips) {
  const Alphabet l;
  const Variable Y{"Y", variation_type}, d{"d"};
  std::vector<Variable> parameters{Y, d, l.chi};
  if (slips) {
    parameters.push_back(l.eta);
  }
  const Formula moves = derivative(Y, l.t, rates(slips, l.chi, l.eta) * apply(Y, l.t));
  return {name, parameters,
          all({continuous(Y, 0, d), for_all(l.t, implies(between(0, l.t, d), moves)),
               equal(apply(Y, 0), identity(4))})};
}

// I with another last row.
Term last_row(const std::vector<Term>& row) {
  std::vector<Term> entries = identity(4).parts();
  std::copy(row.begin(), row.end(), entries.end() - 4);
  return matrix(4, 4, entries);
}

// The sum of the determinants of the n rows and columns of the same numbers.
Term principal_minors(const Term& M, std::size_t n) {
  std::vector<Term> minors;
  for (unsigned chosen = 0; chosen < 16; ++chosen) {
    std::vector<int> rows;
    for (int i = 0; i < 4; ++i) {
      if ((chosen >> i & 1U) != 0) {
        rows.push_back(i);
      }
    }
    if (rows.size() != n) {
      continue;
    }
    std::vector<Term> entries;
    for (const int i : rows) {
      for (const int j : rows) {
        entries.push_back(entry(M, i, j));
      }
    }
    const int size = static_cast<int>(n);
    minors.push_back(n == 1 ? entries[0] : determinant(matrix(size, size, entries)));
  }
  return minors.size() == 1 ? minors[0] : sum(minors);
}

}  // namespace

const Definition& friction() {
  static const Alphabet l;
  static const Definition definition(
      "friction_at_rest", {l.x, l.t, l.chi, l.eta, l.omega, l.p, l.phi},
      Term(l.chi) * (entry(l.x, 1) - entry(l.x, 0)) - Term(l.p) / l.eta * cos(Term(l.omega) * l.t + l.phi));
  return definition;
}

const Definition& phase_definition(PhaseKind kind) {
  static const Definition slips = slipping("slips", 1), overshoots = slipping("overshoots", -1),
                          sticks = sticking();
  return kind == PhaseKind::slip ? slips : kind == PhaseKind::overshoot ? overshoots : sticks;
}

const Definition& variation(PhaseKind kind) {
  static const Definition slipping = varying("varies_slipping", true),
                          sticking = varying("varies_sticking", false);
  return kind == PhaseKind::stick ? sticking : slipping;
}

const Definition& friction_rate() {
  static const Alphabet l;
  static const Definition definition("friction_rate", {l.x, l.t, l.chi, l.eta, l.omega, l.p, l.phi},
                                     Term(l.chi) * (entry(l.x, 3) - entry(l.x, 2)) +
                                         Term(l.p) * l.omega / l.eta * sin(Term(l.omega) * l.t + l.phi));
  return definition;
}

const Definition& crossing() {
  static const Variable before{"before"}, after{"after"};
  static const Definition definition("crossing", {before, after}, last_row({0, 0, 0, Term(after) / before}));
  return definition;
}

const Definition& break_away() {
  static const Variable chi{"chi"}, after{"after"}, rate{"rate"};
  static const Term share = Term(chi) * (Term(after) / rate);
  static const Definition definition("break_away", {chi, after, rate}, last_row({-share, share, 0, 1}));
  return definition;
}

const Definition& landing() {
  static const Definition definition("landing", {}, last_row({0, 0, 0, 0}));
  return definition;
}

const Definition& characteristic() {
  static const Variable M{"M", real_matrix(4, 4)};
  static const Definition definition("characteristic", {M},
                                     matrix(5, 1,
                                            {principal_minors(M, 4), -principal_minors(M, 3),
                                             principal_minors(M, 2), -principal_minors(M, 1), 1}));
  return definition;
}

const Definition& polynomial_at() {
  static const Variable c{"c", real_matrix(5, 1)}, z{"z"};
  static const Definition definition("polynomial_at", {c, z},
                                     sum({entry(c, 0), entry(c, 1) * z, entry(c, 2) * power(z, 2),
                                          entry(c, 3) * power(z, 3), entry(c, 4) * power(z, 4)}));
  return definition;
}

Term Names::phi() const {
  return q_.phi && !q_.lag ? Term(*q_.phi) : Variable{"phi"};
}
Term Names::ur() const {
  return q_.ur ? Term(*q_.ur) : Variable{"ur"};
}
Variable Names::motion(std::size_t k) {
  return {fmt::format("X{}", k + 1), motion_type};
}
Term Names::state(std::size_t k, const Term& t) {
  return apply(motion(k), t);
}
Term Names::friction_at(std::size_t k, const Term& t) const {
  return friction()({state(k, t), t, chi(), eta(), omega_, q_.data.p, phi()});
}

Term Names::end(std::size_t k) const {
  return k + 1 == q_.phases.size() ? Term(2 * q_.period) * pi() / omega_ : start(k + 1);
}

Formula Names::phase(std::size_t k) const {
  const bool stick = q_.phases.at(k) == PhaseKind::stick;
  std::vector<Term> arguments{motion(k), start(k), end(k), chi(), eta()};
  if (!stick) {
    arguments.push_back(us());
  }
  arguments.insert(arguments.end(), {V(), omega_, q_.data.p, phi()});
  if (stick) {
    arguments.push_back(ur());
  }
  return phase_definition(q_.phases[k])(arguments);
}
Definitions Names::definitions(std::size_t k) const {
  Definitions result{phase_definition(q_.phases.at(k))};
  if (q_.phases[k] == PhaseKind::stick) {
    result.insert(friction());
  }
  return result;
}

}  // namespace stickslip::proofs::orbits
