// The numbers of machines as functions of some of their data, exactly.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/friction_oscillator.hpp"
#include "numeric/machines/machine.hpp"
#include "numeric/machines/phases/in_data.hpp"

namespace stickslip::numeric::machines {

using Values = std::vector<Rational>;  // of the data

// All values middle + s half, each s between -1 and 1.
struct ValuesInBox {
  Values middle, half;

  [[nodiscard]] static ValuesInBox between(const Values& low, const Values& high);
  [[nodiscard]] Values at(const Values& s) const;
  [[nodiscard]] Values s_of(const Values& values) const;
};

struct OscillatorInData {
  std::size_t data;
  model::FrictionOscillator<InData<Ball>> numbers;
};

class NumbersInData {
 public:
  // Of the machines that `at` says for values from low to high, low < high. Assumes that each number is a sum
  // of products of at most two different data or a quotient of two linear functions of them, and that the
  // loads' multiples change only with one frequency among several. Throws as require_machine does, for the
  // machines at the corners, too, and DomainError for no data or more than eight.
  NumbersInData(const std::function<Machine(const Values&)>& at, const Values& low, const Values& high);

  // Why nothing is known of the numbers, else empty; what follows needs that.
  [[nodiscard]] const std::string& why_not() const { return why_not_; }

  // For these values, as functions of s; a smooth law has one piece, from 0, in place of those near it. Not
  // finite where a quotient may have a pole.
  [[nodiscard]] OscillatorInData over(const ValuesInBox& part) const;

 private:
  // (constant + sum of linear_k s_k + sum of products_jk s_j s_k)/(1 + sum of below_k s_k), s between -1 and
  // 1 in the box; without entries there is none of such a part.
  struct Quotient {
    Rational constant;
    Values linear, products, below;  // products with j < k at place k (k - 1)/2 + j

    [[nodiscard]] Rational top(const Values& s) const;
    [[nodiscard]] Rational bottom(const Values& s) const;
    [[nodiscard]] InData<Ball> over(const ValuesInBox& part) const;
  };
  // A point for each monomial of the third degree, and less, that tell such a polynomial, and what a number
  // is there.
  class Points;
  [[nodiscard]] static bool has_poles(const Quotient& q);
  void find(const std::vector<Machine>& machines, const Points& points);

  ValuesInBox box_;
  model::FrictionOscillator<Quotient> oscillator_;
  bool in_turns_ = false;
  std::string why_not_;
};

}  // namespace stickslip::numeric::machines
