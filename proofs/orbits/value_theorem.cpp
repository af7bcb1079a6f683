#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/orbits/orbit_with.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

// In what the orbit theorem bounds.
Term named_value(const Question& question, const std::string& name) {
  const model::Parameters<Rational>& a = question.data;
  if (name == "Theta") {
    return Term(2 * question.period) * pi() / Term(a.omega);
  }
  const Term start = apply(Variable{"X1", motion_type}, 0);
  if (name == "ur_max") {
    const Term phi = question.phi ? Term(*question.phi) : Term(Variable{"phi"});
    return friction()({start, 0, a.chi, a.eta, a.omega, a.p, phi});
  }
  static const std::vector<std::string> entries{"10", "20", "dot10"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (name.substr(1) == entries[i]) {
      const Rational d01 = a.us / (1 - a.chi);
      const Term place = entry(start, static_cast<int>(i));
      return name[0] != 'z' || i == 2 ? place : place - Term(i == 0 ? d01 : Rational(d01 / a.chi));
    }
  }
  return Variable{name, real_number};
}

// Decided by these bounds.
Theorem decided(const Formula& inequality, const Theorem& orbit) {
  const Formula opened = unfold(inequality, {friction()});
  Formula here = opened;
  Letters letters;
  for (const auto& [term, known] : bounds_said(orbit)) {
    const Variable letter{"value " + std::to_string(letters.size())};
    letters.emplace(letter, known);
    here = replaced(here, term, letter);
  }
  const Theorem lemma = Theorem::sign(here, ranges_in(here, ranges_of(letters)));
  return Theorem::convert(settled(lemma, letters), inequality, {friction()});
}

}  // namespace

Theorem value_theorem(const Theorem& orbit, const Question& question, const std::string& name,
                      const Rational& lower, const Rational& upper, bool outside) {
  const Term value = named_value(question, name);
  return orbit_with(orbit, [&](const Theorem& body) {
    if (!outside) {
      return both({decided(at_most(lower, value), body), decided(at_most(value, upper), body)});
    }
    try {
      return decided(less(upper, value), body);
    } catch (const KernelError&) {
      return decided(less(value, lower), body);
    }
  });
}

}  // namespace stickslip::proofs::orbits
