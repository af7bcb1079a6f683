// What a numeric term means, entry by entry, in a system of numbers: quotients of polynomials
// (normal_form.cpp), balls and jets of balls (balls.hpp); and outside, what a second opinion is of.
#pragma once

#include <map>

#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {

// A System has a type Number with + and *, and
//   Number number(const Rational&), pi(), reciprocal(const Number&),
//   Number cosine(const Term& argument, entries), sine(…), exponential(…): entries is this object, for the
//   argument's value,
//   std::vector<Number> atom(const Term&, entries): of a variable, a function applied, a definition applied.
// The entries of a matrix stand row by row.
template <class System>
class Entrywise {
 public:
  using Number = typename System::Number;
  using Entries = std::vector<Number>;

  explicit Entrywise(System system) : system_(std::move(system)) {}

  const Entries& operator()(const Term& term) {
    const auto found = known_.find(term);
    return found != known_.end() ? found->second : known_.emplace(term, computed(term)).first->second;
  }

 private:
  Entries computed(const Term& term) {
    const std::vector<Term>& parts = term.parts();
    switch (term.kind()) {
      case Kind::number:
        return {system_.number(term.value())};
      case Kind::pi:
        return {system_.pi()};
      case Kind::sum: {
        Entries total = (*this)(parts[0]);
        for (std::size_t k = 1; k < parts.size(); ++k) {
          const Entries& next = (*this)(parts[k]);
          for (std::size_t i = 0; i < total.size(); ++i) {
            total[i] = total[i] + next[i];
          }
        }
        return total;
      }
      case Kind::product:
        return product((*this)(parts[0]), parts[0].type(), (*this)(parts[1]), parts[1].type());
      case Kind::power: {
        Number result = system_.number(1);
        for (long k = term.value().get_num().get_si(); k > 0; --k) {
          result = result * (*this)(parts[0])[0];
        }
        return {result};
      }
      case Kind::inverse:
        return product((*this)(adjugate(parts[0])), term.type(),
                       {system_.reciprocal((*this)(determinant(parts[0]))[0])}, real_number);
      case Kind::cosine:
        return {system_.cosine(parts[0], *this)};
      case Kind::sine:
        return {system_.sine(parts[0], *this)};
      case Kind::exponential:
        return {system_.exponential(parts[0], *this)};
      case Kind::matrix: {
        Entries result;
        for (const Term& part : parts) {
          result.push_back((*this)(part)[0]);
        }
        return result;
      }
      case Kind::entry:
        return {(*this)(
            parts[0])[static_cast<std::size_t>(term.row() * parts[0].type().columns + term.column())]};
      case Kind::variable:
      case Kind::apply:
      case Kind::defined:
        return system_.atom(term, *this);
      default:
        throw KernelError("only numbers and matrices have entries");
    }
  }

  Entries product(const Entries& a, const Type& left, const Entries& b, const Type& right) {
    Entries result;
    if (left.is_scalar() || right.is_scalar()) {
      for (const Number& one : left.is_scalar() ? b : a) {
        result.push_back(one * (left.is_scalar() ? a[0] : b[0]));
      }
      return result;
    }
    const auto inner = static_cast<std::size_t>(left.columns),
               columns = static_cast<std::size_t>(right.columns);
    for (std::size_t i = 0; i < static_cast<std::size_t>(left.rows); ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        Number total = system_.number(0);
        for (std::size_t k = 0; k < inner; ++k) {
          total = total + a[i * inner + k] * b[k * columns + j];
        }
        result.push_back(total);
      }
    }
    return result;
  }

  System system_;
  std::map<Term, Entries, Before> known_;
};

}  // namespace stickslip::proofs::kernel
