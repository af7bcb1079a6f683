#include "proofs/point.hpp"

#include <optional>

#include "core/error.hpp"
#include "model/nonsticking.hpp"
#include "model/nonsticking_closed_form.hpp"

namespace stickslip::proofs {
namespace {

using Values = std::map<std::string, Rational>;

Ball value_of(const Values& given, const std::string& name);

// chi and eta; from the frequencies where those are given.
Ball stiffness_of(const Values& given, const std::string& name) {
  const Ball omega1 = value_of(given, "omega1");
  const Ball omega2 = value_of(given, "omega2");
  return name == "chi" ? model::chi_from_frequencies<Ball>(omega1, omega2)
                       : model::eta_from_frequencies<Ball>(omega1, omega2);
}

model::Modes<Ball> modes_at(const Values& given) {
  if (given.contains("omega1") && given.contains("omega2")) {
    return model::modes_of<Ball>(value_of(given, "chi"), value_of(given, "omega1"),
                                 value_of(given, "omega2"));
  }
  return model::modes<Ball>(value_of(given, "chi"), value_of(given, "eta"));
}

// (34), (35).
std::optional<Ball> half_period_value(const Values& given, const std::string& name) {
  using HalfPeriod = model::HalfPeriod<Ball>;
  static const std::map<std::string, Ball HalfPeriod::*> members{
      {"phi1", &HalfPeriod::phi1}, {"phi2", &HalfPeriod::phi2}, {"d", &HalfPeriod::d},
      {"a1", &HalfPeriod::a1},     {"a2", &HalfPeriod::a2},     {"b1", &HalfPeriod::b1},
      {"b2", &HalfPeriod::b2}};
  const auto member = members.find(name);
  if (member == members.end()) {
    return std::nullopt;
  }
  const HalfPeriod h = model::half_period<Ball>(value_of(given, "chi"), modes_at(given), {Ball(0), Ball(0)},
                                                value_of(given, "omega"), Ball::pi());
  return h.*member->second;
}

Ball value_of(const Values& given, const std::string& name) {
  if (const auto found = given.find(name); found != given.end()) {
    return Ball(found->second);
  }
  if (name == "pi") {
    return Ball::pi();
  }
  const bool has_frequencies = given.contains("omega1") && given.contains("omega2");
  if ((name == "chi" || name == "eta") && has_frequencies) {
    return stiffness_of(given, name);
  }
  if (name == "omega1" || name == "omega2" || name == "lambda1" || name == "lambda2") {
    const model::Modes<Ball> m = modes_at(given);
    return name == "omega1"    ? m.omega1
           : name == "omega2"  ? m.omega2
           : name == "lambda1" ? m.lambda1
                               : m.lambda2;
  }
  if (name == "d01" || name == "d02") {
    return model::d0<Ball>(value_of(given, "chi"), value_of(given, "us"))(name == "d01" ? 0 : 1);
  }
  if (name == "q1" || name == "q2") {
    const model::Parameters<Ball> a{
        value_of(given, "chi"), Ball(0), Ball(0), Ball(0), value_of(given, "omega"), value_of(given, "p")};
    return model::Q<Ball>(a, modes_at(given))(name == "q1" ? 0 : 1);
  }
  if (const auto half = half_period_value(given, name)) {
    return *half;
  }
  if (name == "rho1" || name == "rho2") {
    return model::rho<Ball>(value_of(given, name == "rho1" ? "omega1" : "omega2"), value_of(given, "tau"),
                            value_of(given, "tau1"));
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

symbolic::BallValues values_at(const std::vector<Coordinate>& point, const GiNaC::exset& symbols) {
  const Lookup<Ball> lookup = at_point(point);
  symbolic::BallValues values;
  for (const GiNaC::ex& symbol : symbols) {
    values[symbol] = lookup(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
  }
  return values;
}

}  // namespace stickslip::proofs
