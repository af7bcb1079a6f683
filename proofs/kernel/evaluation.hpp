// Terms in balls and in jets of balls; for numbers.cpp only.
#pragma once

#include <map>

#include "numeric/jet.hpp"
#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {

// The values of a term, row by row, for values of its variables that contain the exact ones. Definitions are
// looked into. Over balls and jets alike the result contains the exact value (and partial derivatives); a
// divisor whose ball contains zero gives a result that is not finite, or KernelError if `strict`. Throws
// KernelError for a function variable and a variable without value.
template <class T>
class Evaluation {
 public:
  Evaluation(std::map<Variable, std::vector<T>> values, bool strict)
      : values_(std::move(values)), strict_(strict) {}

  std::vector<T> operator()(const Term& term) {
    const auto found = known_.find(term);
    return found != known_.end() ? found->second : known_.emplace(term, computed(term)).first->second;
  }

 private:
  std::vector<T> computed(const Term& term) {
    const std::vector<Term>& parts = term.parts();
    switch (term.kind()) {
      case Kind::variable: {
        const auto value = values_.find({term.name(), term.type()});
        require(value != values_.end(), "the variable " + term.name() + " has no value");
        return value->second;
      }
      case Kind::number:
        return {T(Ball(term.value()))};
      case Kind::pi:
        return {T(Ball::pi())};
      case Kind::sum: {
        std::vector<T> total = (*this)(parts[0]);
        for (std::size_t k = 1; k < parts.size(); ++k) {
          const std::vector<T> next = (*this)(parts[k]);
          for (std::size_t i = 0; i < total.size(); ++i) {
            total[i] += next[i];
          }
        }
        return total;
      }
      case Kind::product:
        return product((*this)(parts[0]), parts[0].type(), (*this)(parts[1]), parts[1].type());
      case Kind::power: {
        T result(Ball(1));
        for (long k = term.value().get_num().get_si(); k > 0; --k) {
          result *= (*this)(parts[0])[0];
        }
        return {result};
      }
      case Kind::inverse:
        return inverse_of(parts[0]);
      case Kind::cosine:
        return {T(cos((*this)(parts[0])[0]))};
      case Kind::sine:
        return {T(sin((*this)(parts[0])[0]))};
      case Kind::matrix: {
        std::vector<T> result;
        for (const Term& part : parts) {
          result.push_back((*this)(part)[0]);
        }
        return result;
      }
      case Kind::entry:
        return {(*this)(
            parts[0])[static_cast<std::size_t>(term.row() * parts[0].type().columns + term.column())]};
      case Kind::defined:
        return (*this)(term.definition().unfolded(parts));
      default:
        throw KernelError("the term has no value in balls");
    }
  }

  static std::vector<T> product(const std::vector<T>& a, const Type& left, const std::vector<T>& b,
                                const Type& right) {
    std::vector<T> result;
    if (left.is_scalar() || right.is_scalar()) {
      for (const T& one : left.is_scalar() ? b : a) {
        result.push_back(T(one * (left.is_scalar() ? a[0] : b[0])));
      }
      return result;
    }
    const auto inner = static_cast<std::size_t>(left.columns),
               columns = static_cast<std::size_t>(right.columns);
    for (std::size_t i = 0; i < static_cast<std::size_t>(left.rows); ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        T total(Ball(0));
        for (std::size_t k = 0; k < inner; ++k) {
          total += T(a[i * inner + k] * b[k * columns + j]);
        }
        result.push_back(total);
      }
    }
    return result;
  }

  // By cofactors, as terms.
  std::vector<T> inverse_of(const Term& term) {
    const int n = term.type().rows;
    const T divisor = (*this)(n == 1 ? term : determinant(term))[0];
    require(!strict_ || is_nonzero(divisor), "a divisor may be zero");
    std::vector<T> result;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const T cofactor = n == 1 ? T(Ball(1)) : (*this)(determinant(struck(term, j, i)))[0];
        result.push_back(T((i + j) % 2 == 0 ? cofactor / divisor : -cofactor / divisor));
      }
    }
    return result;
  }

  static Term struck(const Term& term, int row, int column) {
    const int n = term.type().rows;
    std::vector<Term> entries;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        if (i != row && j != column) {
          entries.push_back(entry(term, i, j));
        }
      }
    }
    return matrix(n - 1, n - 1, entries);
  }

  std::map<Variable, std::vector<T>> values_;
  std::map<Term, std::vector<T>> known_;
  bool strict_;
};

}  // namespace stickslip::proofs::kernel
