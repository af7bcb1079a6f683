#include <algorithm>

#include "core/error.hpp"
#include "proofs/symbols/evaluate.hpp"
#include "proofs/symbols/sample.hpp"

namespace stickslip::proofs::symbols {
namespace {

using Values = std::map<std::string, Rational>;

Ball value_of(const Values& given, const std::string& name) {
  if (const auto found = given.find(name); found != given.end()) {
    return Ball(found->second);
  }
  if (name == "pi") {
    return Ball::pi();
  }
  const Lookup<Ball> lookup = [&given](const std::string& other) { return value_of(given, other); };
  const bool has_frequencies =
      !vocabulary_here().is_of_model() || (given.contains("omega1") && given.contains("omega2"));
  if (!has_frequencies && (name == "omega1" || name == "omega2")) {
    const model::Modes<Ball> m = model::modes<Ball>(lookup("chi"), lookup("eta"));
    return name == "omega1" ? m.omega1 : m.omega2;
  }
  const bool follows = has_frequencies || (name != "chi" && name != "eta");
  if (const auto value = follows ? derived<Ball>(name, lookup) : std::nullopt) {
    return *value;
  }
  throw InternalError("the symbol " + name + " has no value at this point");
}

}  // namespace

Lookup<Ball> at_point(const std::vector<Coordinate>& point) {
  Values given;
  for (const Coordinate& coordinate : point) {
    given[coordinate.name] = coordinate.value;
  }
  return [given = std::move(given)](const std::string& name) { return value_of(given, name); };
}

template Value<Ball> evaluate(const Term&, const Lookup<Ball>&);

bool is_in_field(const Term& term) {
  const bool matrix = term.op() == Op::symbol && !term.shape().is_scalar() && term.name() != "I";
  const Symbol * symbol = symbol_table().find(term);
  using S = numeric::scalars::Series<Ball>;
  const auto& functions = detail::functions<S>();
  const auto& matrices = detail::matrices<S>();
  if (term.name() == "abs" ||
      (term.op() == Op::function && detail::formula_of<S>(functions, term.name()) == functions.end()) ||
      (matrix && !(symbol != nullptr && symbol->value) &&
       detail::formula_of<S>(matrices, term.name()) == matrices.end())) {
    return false;
  }
  return std::ranges::all_of(term.arguments(), is_in_field);
}

using numeric::scalars::Exact;

template Value<Exact> evaluate(const Term&, const Lookup<Exact>&);

}  // namespace stickslip::proofs::symbols
