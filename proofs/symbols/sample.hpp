// Scalars at a point, each computed once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/verdict.hpp"
#include "model/nonsticking.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::symbols {

// The scalars that have formulas in the model, in terms of other scalars: chi, eta, lambda_j from the
// frequencies (39), d_0 (6), Q (7), the abbreviations of (34) and (35), rho_j (70); nothing for a scalar that
// stands for itself.
template <class S>
[[nodiscard]] std::optional<S> derived(const std::string& name, const Lookup<S>& scalar) {
  if (!vocabulary_here().is_of_model()) {
    return std::nullopt;
  }
  using HalfPeriod = model::HalfPeriod<S>;
  static const std::map<std::string, S HalfPeriod::*> members{
      {"phi1", &HalfPeriod::phi1}, {"phi2", &HalfPeriod::phi2}, {"d", &HalfPeriod::d},
      {"a1", &HalfPeriod::a1},     {"a2", &HalfPeriod::a2},     {"b1", &HalfPeriod::b1},
      {"b2", &HalfPeriod::b2}};
  const auto modes = [&scalar] {
    return model::Modes<S>{scalar("omega1"), scalar("omega2"), scalar("lambda1"), scalar("lambda2")};
  };
  if (name == "chi") {
    return model::chi_from_frequencies<S>(scalar("omega1"), scalar("omega2"));
  }
  if (name == "eta") {
    return model::eta_from_frequencies<S>(scalar("omega1"), scalar("omega2"));
  }
  if (name == "lambda1" || name == "lambda2") {
    return model::lambda<S>(scalar("chi"), scalar(name == "lambda1" ? "omega1" : "omega2"));
  }
  if (name == "d01" || name == "d02") {
    return model::d0<S>(scalar("chi"), scalar("us"))(name == "d01" ? 0 : 1);
  }
  if (name == "q1" || name == "q2") {
    const model::Parameters<S> a{scalar("chi"), S(0), S(0), S(0), scalar("omega"), scalar("p")};
    return model::Q<S>(a, modes())(name == "q1" ? 0 : 1);
  }
  if (const auto member = members.find(name); member != members.end()) {
    return model::half_period<S>(scalar("chi"), modes(), {S(0), S(0)}, scalar("omega"), scalar("pi")).*
           member->second;
  }
  if (name == "rho1" || name == "rho2") {
    return model::rho<S>(scalar(name == "rho1" ? "omega1" : "omega2"), scalar("tau"), scalar("tau1"));
  }
  return std::nullopt;
}

// What a scalar is worth: the value that `given` states for it, else its formula in the model, else what
// `free` says. Refers to `given`, which has to outlive it.
template <class S>
class Sample {
 public:
  Sample(const Replacements& given, Lookup<S> free) : given_(given), free_(std::move(free)) {}

  [[nodiscard]] const S& operator()(const std::string& name) {
    if (const auto known = values_.find(name); known != values_.end()) {
      return known->second;
    }
    return values_.emplace(name, compute(name)).first->second;
  }
  // Refers to this object.
  [[nodiscard]] Lookup<S> lookup() {
    return [this](const std::string& name) { return (*this)(name); };
  }

 private:
  [[nodiscard]] S compute(const std::string& name) {
    if (const auto value = given_.find(name); value != given_.end()) {
      return evaluate<S>(value->second, lookup())(0, 0);
    }
    const std::optional<S> formula = derived<S>(name, lookup());
    return formula ? *formula : free_(name);
  }

  const Replacements& given_;
  Lookup<S> free_;
  std::map<std::string, S> values_;
};

// Statements at a point: what every symbol of the paper is worth once parameters and times have rational
// values.

// The scalars at a point, in balls through model/'s own formulas. The point gives omega1 and omega2 or chi
// and eta, from which the other pair and lambda1, lambda2 follow by (39); d01, d02 follow by (6) and q1, q2
// by (7) unless given. Throws InternalError for a symbol that neither is given nor follows. Precision: the
// working one at the time of the look-up.
[[nodiscard]] Lookup<Ball> at_point(const std::vector<Coordinate>& point);

}  // namespace stickslip::proofs::symbols
