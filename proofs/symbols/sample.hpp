// Scalars at a point, each computed once.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/verdict.hpp"
#include "proofs/symbols/derived.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::symbols {

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
