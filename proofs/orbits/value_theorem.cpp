#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
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
  std::vector<Formula> existences{orbit.conclusion()};
  std::vector<Variable> names;
  while (existences.back().kind() == Kind::exists) {
    names.push_back({existences.back().name(), existences.back().binds()});
    existences.push_back(opened(existences.back(), names.back()));
  }
  const Theorem body = Theorem::assume(existences.back());
  const Value named = named_value(question, name);
  const Term value = named.less == 0 ? named.bounded : named.bounded - Term(named.less);
  std::vector<Theorem> parts{body};
  if (!outside) {
    parts.push_back(decided(at_most(lower, value), named, body));
    parts.push_back(decided(at_most(value, upper), named, body));
  } else {
    try {
      parts.push_back(decided(less(upper, value), named, body));
    } catch (const KernelError&) {
      parts.push_back(decided(less(value, lower), named, body));
    }
  }
  Theorem result = both(parts);
  Formula said = result.conclusion();
  for (auto one = names.rbegin(); one != names.rend(); ++one) {
    said = kernel::exists(*one, said);
    result = Theorem::witness(result, said, *one);
  }
  for (std::size_t i = names.size(); i-- > 0;) {
    result = Theorem::choose(i == 0 ? orbit : Theorem::assume(existences[i]), names[i], result);
  }
  return result;
}

}  // namespace stickslip::proofs::orbits
