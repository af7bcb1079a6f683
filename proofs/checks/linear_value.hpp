// Terms as linear functions of unknowns.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>

#include "proofs/checks/premises.hpp"
#include "proofs/symbols/meaning.hpp"

namespace stickslip::proofs::checks {

// The value where all unknowns are 0, and what is added where one of them is 1: all that there is to say of
// what is linear in them. An unknown is meant by its place in solved_for(); one that changes nothing is left
// out.
struct LinearValue {
  symbols::Value<Ball> constant;
  std::map<std::size_t, symbols::Value<Ball>> slopes = {};
};

// Values at one point: scalars have the values of the premises, else formulas of the model, else what `free`
// says. Each scalar is computed once. Refers to the premises, which have to outlive it.
class LinearValues {
 public:
  LinearValues(const Premises& premises, symbols::Lookup<Ball> free)
      : premises_(premises), free_(std::move(free)) {}
  // Throws NoValue.
  [[nodiscard]] LinearValue operator()(const symbols::Term& term);

 private:
  using Function = std::function<symbols::Value<Ball>(const symbols::Lookup<Ball>&)>;
  [[nodiscard]] const LinearValue& scalar(const std::string& name);
  [[nodiscard]] LinearValue product(const LinearValue& a, const LinearValue& b);
  [[nodiscard]] LinearValue block(const symbols::Term& term);
  // Of a function of scalars.
  [[nodiscard]] LinearValue by_differences(const Function& function);

  const Premises& premises_;
  symbols::Lookup<Ball> free_;
  std::map<std::string, LinearValue> known_;
};

}  // namespace stickslip::proofs::checks
