// The evaluation behind meaning.hpp, as templates over the scalar S: a series in the time over balls or exact
// numbers, instantiated by meaning.cpp; include meaning.hpp instead.
#pragma once

#include <fmt/format.h>

#include <map>
#include <set>

#include "core/error.hpp"
#include "model/flows.hpp"
#include "model/nonsticking.hpp"
#include "numeric/scalars/series.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/symbols/table.hpp"

namespace stickslip::proofs::symbols {
namespace detail {

using numeric::scalars::Series;

template <class S>
Value<S> value_of(const Term& term, const Lookup<S>& scalar);

template <class S>
Value<S> scalar_value(const S& value) {
  return Value<S>::Constant(1, 1, value);
}

// In groups of nine digits, as S is made of an int.
template <class S>
S whole(const mpz_class& number) {
  constexpr int group = 1'000'000'000;
  return number.fits_sint_p()
             ? S(static_cast<int>(number.get_si()))
             : S(whole<S>(mpz_class(number / group)) * S(group) + whole<S>(mpz_class(number % group)));
}

template <class S>
model::Modes<S> modes(const Lookup<S>& scalar) {
  return {scalar("omega1"), scalar("omega2"), scalar("lambda1"), scalar("lambda2")};
}

template <class S>
model::Vector4<S> load(const Lookup<S>& scalar, const S& t) {
  return model::F<S>({scalar("q1"), scalar("q2")}, scalar("omega"), S(scalar("omega") * t + scalar("phi")));
}

template <class S>
using Matrices = std::map<std::string, std::function<Value<S>(const Lookup<S>&)>>;

// Vectors and matrices that do not depend on time and are formulas of the model.
template <class S>
const Matrices<S>& matrices() {
  using L = Lookup<S>;
  using V = Value<S>;
  static const Matrices<S> known{
      {"E", [](const L&) -> V { return model::reversal<S>(); }},
      {"K", [](const L& s) -> V { return model::stiffness<S>(s("chi"), s("eta")); }},
      {"Lambda", [](const L& s) -> V { return model::Lambda<S>(modes<S>(s)); }},
      {"Sigma", [](const L& s) -> V { return model::Sigma<S>(s("chi")); }},
      {"P1", [](const L& s) -> V { return model::speed_from_place<S>(modes<S>(s), s("tau")); }},
      {"P2", [](const L& s) -> V { return model::speed_from_place<S>(modes<S>(s), s("tau1")) * S(-1); }},
  };
  return known;
}

template <class S>
S absolute_value(const S& value) {
  if constexpr (requires { S(abs(value)); }) {
    return S(abs(value));
  } else {
    throw NoValue("an absolute value has no derivative, and no exact value");
  }
}

// NaN of what may be below 0: what is said of a root says nothing where it is none. What changes with time
// has no root here: nothing asks for its rate.
template <class S>
S square_root(const S& value) {
  if constexpr (requires { S(sqrt(value)); }) {
    return S(sqrt(value));
  } else if constexpr (requires { value.size(), square_root(value[0]); }) {
    return value.size() == 1 ? S(square_root(value[0])) : throw NoValue("a root of what changes with time");
  } else {
    throw numeric::scalars::NoExactValue("a root has no exact value");
  }
}

template <class S>
using Functions = std::map<std::string, std::function<Value<S>(const Lookup<S>&, const S&)>>;

template <class S>
const Functions<S>& functions() {
  using L = Lookup<S>;
  using V = Value<S>;
  using std::cos;
  using std::exp;
  using std::sin;
  static const Functions<S> known{
      {"cos", [](const L&, const S& t) -> V { return scalar_value<S>(S(cos(t))); }},
      {"sin", [](const L&, const S& t) -> V { return scalar_value<S>(S(sin(t))); }},
      {"exp", [](const L&, const S& t) -> V { return scalar_value<S>(S(exp(t))); }},
      {"tan", [](const L&, const S& t) -> V { return scalar_value<S>(S(S(sin(t)) / S(cos(t)))); }},
      {"sqrt", [](const L&, const S& t) -> V { return scalar_value<S>(square_root(t)); }},
      {"abs", [](const L&, const S& t) -> V { return scalar_value<S>(absolute_value(t)); }},
      {"H", [](const L& s, const S& t) -> V { return model::H<S>(modes<S>(s), t); }},
      {"H1", [](const L& s, const S& t) -> V { return model::H_blocks<S>(modes<S>(s), t).first; }},
      {"H2", [](const L& s, const S& t) -> V { return model::H_blocks<S>(modes<S>(s), t).second; }},
      {"H3", [](const L& s, const S& t) -> V { return model::H_blocks<S>(modes<S>(s), t).third; }},
      {"B1", [](const L& s, const S& t) -> V { return model::B<S>(modes<S>(s), t).first; }},
      {"B2", [](const L& s, const S& t) -> V { return model::B<S>(modes<S>(s), t).second; }},
      {"B3", [](const L& s, const S& t) -> V { return model::B<S>(modes<S>(s), t).third; }},
      {"Gamma", [](const L& s, const S& t) -> V { return model::Gamma<S>(s("chi"), t); }},
      {"Gamma1", [](const L& s, const S& t) -> V { return model::Gamma_blocks<S>(s("chi"), t).first; }},
      {"Gamma2", [](const L& s, const S& t) -> V { return model::Gamma_blocks<S>(s("chi"), t).second; }},
      {"Gamma3", [](const L& s, const S& t) -> V { return model::Gamma_blocks<S>(s("chi"), t).third; }},
      {"gamma1", [](const L&, const S& t) -> V { return model::gamma<S>(t).first; }},
      {"gamma2", [](const L&, const S& t) -> V { return model::gamma<S>(t).second; }},
      {"gamma3", [](const L&, const S& t) -> V { return model::gamma<S>(t).third; }},
      {"F", [](const L& s, const S& t) -> V { return load<S>(s, t); }},
      {"R", [](const L& s, const S& t) -> V { return load<S>(s, t).template head<2>(); }},
      {"L", [](const L& s, const S& t) -> V { return model::L<S>(modes<S>(s), t); }},
  };
  return known;
}

// The formula that a name has: what is elementary has its own everywhere, everything else in the model's
// vocabulary.
template <class S, class Formulas>
auto formula_of(const Formulas& known, const std::string& name) {
  return vocabulary_here().is_of_model() || is_elementary(name) || name == "abs" ? known.find(name)
                                                                                 : known.end();
}

template <class S>
Value<S> evaluate_symbol(const Term& term, const Lookup<S>& scalar) {
  if (term.name() == "I") {
    return Value<S>::Identity(term.shape().rows, term.shape().columns);
  }
  const Symbol * symbol = symbol_table().find(term);
  if (symbol != nullptr && (symbol->value || symbol->means)) {
    return value_of<S>(symbol->value ? *symbol->value : *symbol->means, scalar);
  }
  if (term.shape().is_scalar()) {
    return scalar_value<S>(scalar(term.name()));
  }
  const auto found = formula_of<S>(matrices<S>(), term.name());
  if (found == matrices<S>().end()) {
    throw NoValue(fmt::format("the symbol {} has no meaning in the model", term.name()));
  }
  return found->second(scalar);
}

template <class S>
Value<S> evaluate_function(const Term& term, const Lookup<S>& scalar) {
  const auto found = formula_of<S>(functions<S>(), term.name());
  if (found == functions<S>().end()) {
    throw NoValue(fmt::format("the function {} has no meaning in the model", term.name()));
  }
  return found->second(scalar, value_of<S>(term.arguments().front(), scalar)(0, 0));
}

template <class S>
Value<S> times(const Value<S>& a, const Value<S>& b) {
  if (a.size() == 1) {
    return b * S(a(0, 0));
  }
  return b.size() == 1 ? Value<S>(a * S(b(0, 0))) : Value<S>(a.lazyProduct(b));
}

template <class S>
Value<S> evaluate_sum(const Term& term, const Lookup<S>& scalar) {
  Value<S> sum = Value<S>::Constant(term.shape().rows, term.shape().columns, S(0));
  for (const Term& argument : term.arguments()) {
    if (!argument.is_zero()) {
      sum += value_of<S>(argument, scalar);
    }
  }
  return sum;
}

template <class S>
Value<S> evaluate_product(const Term& term, const Lookup<S>& scalar) {
  Value<S> product = value_of<S>(term.arguments().front(), scalar);
  for (std::size_t i = 1; i < term.arguments().size(); ++i) {
    product = times<S>(product, value_of<S>(term.arguments()[i], scalar));
  }
  return product;
}

// Without that row and column.
template <class S>
Value<S> minor_of(const Value<S>& m, Eigen::Index row, Eigen::Index column) {
  Value<S> result(m.rows() - 1, m.cols() - 1);
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index j = 0; j < result.cols(); ++j) {
      result(i, j) = m(i < row ? i : i + 1, j < column ? j : j + 1);
    }
  }
  return result;
}

// By the first row; no pivoting, which would need an order.
template <class S>
S determinant(const Value<S>& m) {
  if (m.rows() == 1) {
    return m(0, 0);
  }
  S sum(0);
  for (Eigen::Index column = 0; column < m.cols(); ++column) {
    const S part = m(0, column) * determinant<S>(minor_of<S>(m, 0, column));
    sum = column % 2 == 0 ? S(sum + part) : S(sum - part);
  }
  return sum;
}

// By cofactors.
template <class S>
Value<S> inverse(const Value<S>& m) {
  if (m.rows() == 1) {
    return scalar_value<S>(S(S(1) / m(0, 0)));
  }
  if (m.rows() == 2) {
    return model::inverse<S>(model::Matrix2<S>(m));
  }
  const S det = determinant<S>(m);
  Value<S> result(m.rows(), m.cols());
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    for (Eigen::Index j = 0; j < m.cols(); ++j) {
      result(i, j) = S((i + j) % 2 == 0 ? 1 : -1) * determinant<S>(minor_of<S>(m, j, i)) / det;
    }
  }
  return result;
}

template <class S>
Value<S> evaluate_power(const Term& term, const Lookup<S>& scalar) {
  Value<S> base = value_of<S>(term.arguments().front(), scalar);
  const long exponent = term.number().get_num().get_si();
  if (exponent < 0) {
    base = inverse<S>(base);
  }
  Value<S> product = Value<S>::Identity(base.rows(), base.cols());
  for (long i = 0; i < std::abs(exponent); ++i) {
    product = Value<S>(product.lazyProduct(base));
  }
  return product;
}

template <class S>
Value<S> evaluate_block(const Term& term, const Lookup<S>& scalar) {
  Value<S> result(term.shape().rows, term.shape().columns);
  Eigen::Index row = 0;
  Eigen::Index column = 0;
  for (const Term& argument : term.arguments()) {
    const Value<S> part = value_of<S>(argument, scalar);
    result.block(row, column, part.rows(), part.cols()) = part;
    column += part.cols();
    if (column == result.cols()) {
      column = 0;
      row += part.rows();
    }
  }
  return result;
}

// From the series to one order more.
template <class S>
Value<Series<S>> derivative_of(const Term& inside, const Lookup<Series<S>>& scalar) {
  const Lookup<Series<S>> one_more = [&](const std::string& name) {
    const Series<S> value = scalar(name);
    return name == "t" ? Series<S>::variable(value[0], value.size()) : value;
  };
  return value_of<Series<S>>(inside, one_more).unaryExpr([](const Series<S>& e) { return e.derivative(); });
}

template <class S>
Value<S> value_of(const Term& term, const Lookup<S>& scalar) {
  switch (term.op()) {
    case Op::number: {
      const S numerator = whole<S>(term.number().get_num());
      const S denominator = whole<S>(term.number().get_den());
      return Value<S>::Constant(term.shape().rows, term.shape().columns, S(numerator / denominator));
    }
    case Op::symbol:
      return evaluate_symbol<S>(term, scalar);
    case Op::function:
      return evaluate_function<S>(term, scalar);
    case Op::sum:
      return evaluate_sum<S>(term, scalar);
    case Op::product:
      return evaluate_product<S>(term, scalar);
    case Op::quotient:
      return value_of<S>(term.arguments()[0], scalar) *
             S(S(1) / value_of<S>(term.arguments()[1], scalar)(0, 0));
    case Op::power:
      return evaluate_power<S>(term, scalar);
    case Op::negate:
      return value_of<S>(term.arguments().front(), scalar) * S(-1);
    case Op::derivative:
      if constexpr (requires { derivative_of(term, scalar); }) {
        return derivative_of(term.arguments().front(), scalar);
      }
      break;
    case Op::block:
      return evaluate_block<S>(term, scalar);
    case Op::determinant:
      return scalar_value<S>(determinant<S>(value_of<S>(term.arguments().front(), scalar)));
  }
  throw InternalError("a term of unknown kind");
}

}  // namespace detail

[[nodiscard]] inline bool has_derivative(const Term& term) {
  return term.op() == Op::derivative || std::ranges::any_of(term.arguments(), has_derivative);
}

// Over numbers; where there are derivatives in the term, by series in the time of as many orders.
template <class S>
Value<S> evaluate(const Term& term, const Lookup<S>& scalar) {
  if (!has_derivative(term)) {
    return detail::value_of<S>(term, scalar);
  }
  using Series = numeric::scalars::Series<S>;
  const Lookup<Series> lifted = [&](const std::string& name) { return Series(scalar(name)); };
  return detail::value_of<Series>(term, lifted).unaryExpr([](const Series& e) { return e[0]; });
}

}  // namespace stickslip::proofs::symbols
