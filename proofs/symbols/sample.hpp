// Scalars at a point, each computed once.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "proofs/symbols/derived.hpp"
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

}  // namespace stickslip::proofs::symbols
