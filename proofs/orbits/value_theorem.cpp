#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/orbits/orbit_with.hpp"
#include "proofs/tactics/closed.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

// A value of the orbit: something that its theorem bounds, minus a number.
struct Value {
  Term bounded;
  Rational less;
};

Value named_value(const Question& question, const std::string& name) {
  const model::Parameters<Rational>& a = question.data;
  if (name == "Theta") {
    return {Term(2 * question.period) * pi() / Term(a.omega), 0};
  }
  static const std::vector<std::string> entries{"10", "20", "dot10"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (name.substr(1) == entries[i]) {
      const Rational d01 = a.us / (1 - a.chi);
      const Rational shift = name[0] != 'z' || i == 2 ? Rational(0) : i == 0 ? d01 : Rational(d01 / a.chi);
      return {entry(apply(Variable{"X1", motion_type}, 0), static_cast<int>(i)), shift};
    }
  }
  return {Variable{name, real_number}, 0};
}

// low <= value, value <= high; strictly below, strictly above.
Theorem decided(const Formula& inequality, const Value& value, const Theorem& orbit) {
  if (inequality.variables().empty()) {
    return certainly(inequality);
  }
  const std::vector<Term>& sides = inequality.parts();
  const bool from_below = sides[0].kind() == Kind::number;
  for (const Formula& one : orbit.conclusion().parts()) {
    if (one.kind() == Kind::less && one.parts()[from_below ? 1 : 0] == value.bounded &&
        one.parts()[from_below ? 0 : 1].kind() == Kind::number) {
      const Rational& known = one.parts()[from_below ? 0 : 1].value();
      const Rational rest = from_below ? Rational(known - value.less - sides[0].value())
                                       : Rational(sides[1].value() - known + value.less);
      if (rest > 0) {
        return Theorem::order(inequality,
                              {Positive{{Theorem::consequence({orbit}, one)}}, Positive{{}, rest}});
      }
    }
  }
  throw KernelError("the bounds that are known do not decide " + to_string(inequality));
}

}  // namespace

Theorem value_theorem(const Theorem& orbit, const Question& question, const std::string& name,
                      const Rational& lower, const Rational& upper, bool outside) {
  const Value named = named_value(question, name);
  const Term value = named.less == 0 ? named.bounded : named.bounded - Term(named.less);
  return orbit_with(orbit, [&](const Theorem& body) {
    if (!outside) {
      return both({decided(at_most(lower, value), named, body), decided(at_most(value, upper), named, body)});
    }
    try {
      return decided(less(upper, value), named, body);
    } catch (const KernelError&) {
      return decided(less(value, lower), named, body);
    }
  });
}

}  // namespace stickslip::proofs::orbits
