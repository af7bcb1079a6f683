// The scalars that have formulas in the model, in terms of other scalars.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "model/nonsticking.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/symbols/table.hpp"

namespace stickslip::proofs::symbols {

// chi, eta, lambda_j from the frequencies (39), d_0 (6), Q (7), the abbreviations of (34) and (35), rho_j
// (70); nothing for a scalar that stands for itself.
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

}  // namespace stickslip::proofs::symbols
