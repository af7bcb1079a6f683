#include <set>
#include <string>

#include "den_hartog.hpp"

namespace den_hartog {

namespace tactics = stickslip::proofs::tactics;
using namespace kernel;

Term position(const Term& time) {
  return (Term(X) - f - q * cos(phi)) * cos(time) + q * omega * sin(phi) * sin(time) +
         q * cos(Term(omega) * time + phi) + f;
}

Term velocity(const Term& time) {
  return -(Term(X) - f - q * cos(phi)) * sin(time) + q * omega * sin(phi) * cos(time) -
         q * omega * sin(Term(omega) * time + phi);
}

methods::Claim claim(const char * id, const char * words, std::vector<Theorem> (*prove)(),
                     methods::Origin origin) {
  methods::Claim claim;
  claim.id = id;
  claim.kind = methods::Kind::theorem;
  claim.origin = origin;
  claim.words = words;
  const std::vector<Theorem> theorems = prove();
  for (const Theorem& theorem : theorems) {
    claim.supposed.insert(theorem.hypotheses().begin(), theorem.hypotheses().end());
  }
  claim.prove = [theorems](methods::Prover&, const methods::Claim& stated) {
    methods::Outcome outcome;
    outcome.theorems = theorems;
    outcome.by_kernel = true;
    std::set<std::string> hypotheses;
    for (const Formula& hypothesis : stated.supposed) {
      hypotheses.insert(kernel::to_string(hypothesis));
    }
    outcome.route = "a theorem of the kernel";
    for (const std::string& hypothesis : hypotheses) {
      outcome.route += (hypothesis == *hypotheses.begin() ? ", if " : " and ") + hypothesis;
    }
    outcome.verdict = stickslip::Verdict::proved();
    return outcome;
  };
  return claim;
}

namespace {

// The derivative of one function of the time t is another.
Theorem rate(const Term& function, const Term& is) {
  const Theorem computed = Theorem::differentiate(lambda(t, function), t);
  const Variable value{"value"};
  return Theorem::replace(tactics::by_normal_form(equal(computed.conclusion().parts().at(2), is), {}), value,
                          derivative(lambda(t, function), t, value), computed);
}

std::vector<Theorem> velocity_is_rate() {
  return {rate(position(t), velocity(t))};
}
std::vector<Theorem> equation_of_motion() {
  return {rate(velocity(t), Term(a) * cos(Term(omega) * t + phi) + f - position(t))};
}
std::vector<Theorem> begins() {
  return {tactics::by_normal_form(equal(position(0), X), {}),
          tactics::by_normal_form(equal(velocity(0), 0), {})};
}

// Any Z = (x, x') with these derivatives is x(t) = flow(t - b) (Z(b) - forced(b)) + forced(t).
std::vector<Theorem> every_motion() {
  const Variable Z{"Z", function_of_time(2)}, b{"b"}, c{"c"};
  const Term system = matrix(2, 2, {0, 1, -1, 0}), psi = Term(omega) * t + phi;
  const Formula obeys =
      for_all(t, implies(between(b, t, c),
                         derivative(Z, t, system * apply(Z, t) + matrix(2, 1, {0, Term(a) * cos(psi) + f}))));
  const tactics::Motion motion{Theorem::assume(continuous(Z, b, c)), Theorem::assume(obeys)};
  const Term flow = lambda(t, matrix(2, 2, {cos(t), sin(t), -sin(t), cos(t)}));
  const Term forced = lambda(t, matrix(2, 1, {q * cos(psi) + f, -q * omega * sin(psi)}));
  return {tactics::by_differential_equation(motion, Z, flow, forced, t, {}, {}, {})};
}

}  // namespace

std::vector<methods::Claim> motion() {
  return {
      claim("motion.velocity", "the velocity is the rate of the position", velocity_is_rate,
            methods::Origin::auxiliary),
      claim("motion.equation", "the motion obeys $x'' + x = a cos(omega t + phi) + f$", equation_of_motion),
      claim("motion.begins", "it begins at $X$ at rest", begins),
      claim("motion.every", "every motion that obeys the equation has this closed form", every_motion)};
}

}  // namespace den_hartog
