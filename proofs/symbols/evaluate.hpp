// The evaluation behind meaning.hpp, as templates over the scalar S: GiNaC::ex, or a series in the time over
// balls or exact numbers. Instantiated by evaluate_*.cpp; include meaning.hpp instead.
#pragma once

#include <fmt/format.h>

#include <map>

#include "core/error.hpp"
#include "model/flows.hpp"
#include "model/nonsticking_closed_form.hpp"
#include "numeric/scalars/series.hpp"
#include "proofs/symbols/abbreviations.hpp"
#include "proofs/symbols/meaning.hpp"

namespace stickslip::proofs::symbols {
namespace detail {

using numeric::scalars::Series;

template <class S>
Value<S> value_of(const Term& term, const Lookup<S>& scalar);

template <class S>
Value<S> scalar_value(const S& value) {
  return Value<S>::Constant(1, 1, value);
}

template <class S>
model::Modes<S> modes(const Lookup<S>& scalar) {
  return {scalar("omega1"), scalar("omega2"), scalar("lambda1"), scalar("lambda2")};
}

template <class S>
model::Vector2<S> pair(const S& a, const S& b) {
  return {a, b};
}

// (x1, x2)ᵀ from the names of its components; `suffix` 0, B or C.
template <class S>
model::Vector2<S> pair_named(const Lookup<S>& scalar, const std::string& letter, const std::string& suffix) {
  return {scalar(letter + "1" + suffix), scalar(letter + "2" + suffix)};
}

// (z, z') at 0, B or C.
template <class S>
model::Vector4<S> state(const Lookup<S>& scalar, const std::string& suffix) {
  return model::stack<S>(pair_named<S>(scalar, "z", suffix), pair_named<S>(scalar, "zdot", suffix));
}

// The states of x = z + d_0 (once) and of z + 2 d_0 (twice).
template <class S>
model::Vector4<S> shifted(const model::Vector4<S>& Z, const Lookup<S>& scalar, int times) {
  model::Vector4<S> result = Z;
  result(0) += S(times) * scalar("d01");
  result(1) += S(times) * scalar("d02");
  return result;
}

template <class S>
model::Vector4<S> load(const Lookup<S>& scalar, const S& t) {
  return model::F<S>(pair<S>(scalar("q1"), scalar("q2")), scalar("omega"),
                     S(scalar("omega") * t + scalar("phi")));
}

template <class S>
using Symbols = std::map<std::string, std::function<Value<S>(const Lookup<S>&)>>;

// (57): xi_1 = (H(tau) + E)(Z_0 - F_0), xi_2 = (H(-tau_1) + E)(Zbar_0 - F_0).
template <class S>
model::Vector4<S> xi(const Lookup<S>& scalar, int which) {
  const S t = which == 1 ? scalar("tau") : S(S(0) - scalar("tau1"));
  const model::Vector4<S> start = shifted<S>(state<S>(scalar, "0"), scalar, which == 1 ? 0 : 2);
  return (model::H<S>(modes<S>(scalar), t) + model::reversal<S>()) *
         model::Vector4<S>(start - load<S>(scalar, S(0)));
}

// (63), (64): P_1, P_2 and P = P_1 - P_2.
template <class S>
model::Matrix2<S> P(const Lookup<S>& scalar, int which) {
  const auto first = [&] { return model::speed_from_place<S>(modes<S>(scalar), scalar("tau")); };
  const auto second = [&] { return model::speed_from_place<S>(modes<S>(scalar), scalar("tau1")); };
  return which == 1   ? first()
         : which == 2 ? model::Matrix2<S>(second() * S(-1))
                      : model::Matrix2<S>(first() + second());
}

// Vectors and matrices that do not depend on time.
template <class S>
const Symbols<S>& symbols() {
  using L = Lookup<S>;
  using V = Value<S>;
  static const Symbols<S> known{
      {"E", [](const L&) -> V { return model::reversal<S>(); }},
      {"K", [](const L& s) -> V { return model::stiffness<S>(s("chi"), s("eta")); }},
      {"Lambda", [](const L& s) -> V { return model::Lambda<S>(modes<S>(s)); }},
      {"Sigma", [](const L& s) -> V { return model::Sigma<S>(s("chi")); }},
      {"d0", [](const L& s) -> V { return pair<S>(s("d01"), s("d02")); }},
      {"Q", [](const L& s) -> V { return pair<S>(s("q1"), s("q2")); }},
      {"psi1", [](const L& s) -> V { return pair<S>(S(1), s("lambda1")); }},
      {"psi2", [](const L& s) -> V { return pair<S>(S(1), s("lambda2")); }},
      {"F0", [](const L& s) -> V { return load<S>(s, S(0)); }},
      {"delta",
       [](const L& s) -> V {
         return model::stack<S>(pair<S>(s("delta1"), s("delta2")), pair<S>(s("deltadot1"), s("deltadot2")));
       }},
      {"FB", [](const L& s) -> V { return load<S>(s, s("tau")); }},
      {"Z0", [](const L& s) -> V { return state<S>(s, "0"); }},
      {"ZB", [](const L& s) -> V { return state<S>(s, "B"); }},
      {"ZC", [](const L& s) -> V { return state<S>(s, "C"); }},
      {"z0", [](const L& s) -> V { return pair_named<S>(s, "z", "0"); }},
      {"zB", [](const L& s) -> V { return pair_named<S>(s, "z", "B"); }},
      {"zdot0", [](const L& s) -> V { return pair_named<S>(s, "zdot", "0"); }},
      {"zdotB", [](const L& s) -> V { return pair_named<S>(s, "zdot", "B"); }},
      {"X0", [](const L& s) -> V { return shifted<S>(state<S>(s, "0"), s, 1); }},
      {"XB", [](const L& s) -> V { return shifted<S>(state<S>(s, "B"), s, 1); }},
      {"x0", [](const L& s) -> V { return shifted<S>(state<S>(s, "0"), s, 1).template head<2>(); }},
      {"xB", [](const L& s) -> V { return shifted<S>(state<S>(s, "B"), s, 1).template head<2>(); }},
      {"Zbar0", [](const L& s) -> V { return shifted<S>(state<S>(s, "0"), s, 2); }},
      {"ZbarB", [](const L& s) -> V { return shifted<S>(state<S>(s, "B"), s, 2); }},
      {"zbar0", [](const L& s) -> V { return shifted<S>(state<S>(s, "0"), s, 2).template head<2>(); }},
      {"zbarB", [](const L& s) -> V { return shifted<S>(state<S>(s, "B"), s, 2).template head<2>(); }},
      {"delta0", [](const L& s) -> V { return shifted<S>(model::Vector4<S>::Constant(S(0)), s, 1); }},
      {"xi1", [](const L& s) -> V { return xi<S>(s, 1); }},
      {"xi2", [](const L& s) -> V { return xi<S>(s, 2); }},
      {"X1", [](const L& s) -> V { return xi<S>(s, 1).template head<2>(); }},
      {"Y1", [](const L& s) -> V { return xi<S>(s, 1).template tail<2>(); }},
      {"X2", [](const L& s) -> V { return xi<S>(s, 2).template head<2>(); }},
      {"Y2", [](const L& s) -> V { return xi<S>(s, 2).template tail<2>(); }},
      {"P1", [](const L& s) -> V { return P<S>(s, 1); }},
      {"P2", [](const L& s) -> V { return P<S>(s, 2); }},
      {"P", [](const L& s) -> V { return P<S>(s, 0); }},
      {"Ptilde", [](const L& s) -> V { return model::diagonal<S>(s("rho1"), s("rho2")); }},
  };
  return known;
}

inline GiNaC::ex absolute_value(const GiNaC::ex& value) {
  return abs(value);
}

template <class S>
Series<S> absolute_value(const Series<S>& value) {
  if constexpr (requires { S(abs(value[0])); }) {
    if (value.size() == 1) {
      return S(abs(value[0]));
    }
  }
  throw NoValue("an absolute value has no derivative, and no exact value");
}

template <class S>
using Functions = std::map<std::string, std::function<Value<S>(const Lookup<S>&, const S&)>>;

template <class S>
const Functions<S>& functions() {
  using L = Lookup<S>;
  using V = Value<S>;
  using std::cos;
  using std::sin;
  static const Functions<S> known{
      {"cos", [](const L&, const S& t) -> V { return scalar_value<S>(S(cos(t))); }},
      {"sin", [](const L&, const S& t) -> V { return scalar_value<S>(S(sin(t))); }},
      {"tan", [](const L&, const S& t) -> V { return scalar_value<S>(S(S(sin(t)) / S(cos(t)))); }},
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

template <class S>
Value<S> evaluate_symbol(const Term& term, const Lookup<S>& scalar) {
  if (term.name() == "I") {
    return Value<S>::Identity(term.shape().rows, term.shape().columns);
  }
  if (term.shape().is_scalar()) {
    const std::optional<Term> meaning = abbreviated(term.name());
    return meaning ? value_of<S>(*meaning, scalar) : scalar_value<S>(scalar(term.name()));
  }
  const auto found = symbols<S>().find(term.name());
  if (found == symbols<S>().end()) {
    throw NoValue(fmt::format("the symbol {} has no meaning in the model", term.name()));
  }
  return found->second(scalar);
}

template <class S>
Value<S> evaluate_function(const Term& term, const Lookup<S>& scalar) {
  const auto found = functions<S>().find(term.name());
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

// With respect to the symbol t, then at the value that t has.
inline Value<GiNaC::ex> derivative_of(const Term& inside, const Lookup<GiNaC::ex>& scalar) {
  const GiNaC::symbol time;
  const GiNaC::ex now = scalar("t");
  const Lookup<GiNaC::ex> in_time = [&](const std::string& name) {
    return name == "t" ? GiNaC::ex(time) : scalar(name);
  };
  return value_of<GiNaC::ex>(inside, in_time).unaryExpr([&](const GiNaC::ex& e) {
    return GiNaC::ex(e.diff(time).subs(time == now));
  });
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
      if (!term.number().get_num().fits_sint_p() || !term.number().get_den().fits_sint_p()) {
        throw NoValue(fmt::format("{} is too long a number", text(term)));
      }
      const S numerator(static_cast<int>(term.number().get_num().get_si()));
      const S denominator(static_cast<int>(term.number().get_den().get_si()));
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
      return derivative_of(term.arguments().front(), scalar);
    case Op::block:
      return evaluate_block<S>(term, scalar);
    case Op::determinant:
      return scalar_value<S>(determinant<S>(value_of<S>(term.arguments().front(), scalar)));
  }
  throw InternalError("a term of unknown kind");
}

}  // namespace detail

// Over numbers: by series in the time of as many orders as there are derivatives in the term.
template <class S>
Value<S> evaluate(const Term& term, const Lookup<S>& scalar) {
  using Series = numeric::scalars::Series<S>;
  const Lookup<Series> lifted = [&](const std::string& name) { return Series(scalar(name)); };
  return detail::value_of<Series>(term, lifted).unaryExpr([](const Series& e) { return e[0]; });
}

}  // namespace stickslip::proofs::symbols
