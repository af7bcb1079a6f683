#include "proofs/methods/translation.hpp"

#include "symbolic/algebra/evaluate.hpp"
#include "symbolic/algebra/symbols.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;

symbolic::algebra::Matrix expression(const Term& term) {
  using symbolic::algebra::Matrix;
  const std::vector<Term>& parts = term.parts();
  const auto scalar = [](const GiNaC::ex& value) { return Matrix::Constant(1, 1, value); };
  const auto part = [&](std::size_t i) { return expression(parts[i]); };
  switch (term.kind()) {
    case kernel::Kind::number:
      return scalar(symbolic::algebra::to_ex(term.value()));
    case kernel::Kind::pi:
      return scalar(GiNaC::Pi);
    case kernel::Kind::variable:
      if (term.type().is_scalar()) {
        return scalar(symbolic::algebra::symbol(term.name()));
      }
      break;
    case kernel::Kind::sum: {
      Matrix total = part(0);
      for (std::size_t i = 1; i < parts.size(); ++i) {
        total += part(i);
      }
      return total;
    }
    case kernel::Kind::product: {
      const Matrix left = part(0), right = part(1);
      return left.size() == 1    ? Matrix(left(0, 0) * right)
             : right.size() == 1 ? Matrix(left * right(0, 0))
                                 : Matrix(left * right);
    }
    case kernel::Kind::power:
      return scalar(term.value() == 0 ? GiNaC::ex(1)
                                      : pow(part(0)(0, 0), symbolic::algebra::to_ex(term.value())));
    case kernel::Kind::inverse: {
      const Matrix a = part(0);
      if (a.size() == 1) {
        return scalar(1 / a(0, 0));
      }
      if (a.rows() == 2) {
        Matrix adjugate(2, 2);
        adjugate << a(1, 1), -a(0, 1), -a(1, 0), a(0, 0);
        return Matrix(adjugate / (a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0)));
      }
      break;
    }
    case kernel::Kind::cosine:
      return scalar(GiNaC::cos(part(0)(0, 0)));
    case kernel::Kind::sine:
      return scalar(GiNaC::sin(part(0)(0, 0)));
    case kernel::Kind::defined:
      return expression(term.definition().unfolded(parts));
    case kernel::Kind::matrix: {
      Matrix result(term.type().rows, term.type().columns);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        result(static_cast<Eigen::Index>(i) / result.cols(), static_cast<Eigen::Index>(i) % result.cols()) =
            part(i)(0, 0);
      }
      return result;
    }
    case kernel::Kind::entry:
      return scalar(part(0)(term.row(), term.column()));
    default:
      break;
  }
  throw KernelError("a divisor is no expression: " + to_string(term));
}

Term term_of(const GiNaC::ex& scalar, Reader& read) {
  if (GiNaC::is_a<GiNaC::numeric>(scalar)) {
    return symbolic::algebra::to_rational(GiNaC::ex_to<GiNaC::numeric>(scalar));
  }
  if (GiNaC::is_a<GiNaC::symbol>(scalar)) {
    return read(symbols::scalar(GiNaC::ex_to<GiNaC::symbol>(scalar).get_name()));
  }
  if (scalar.is_equal(GiNaC::Pi)) {
    return kernel::pi();
  }
  if (GiNaC::is_a<GiNaC::add>(scalar) || GiNaC::is_a<GiNaC::mul>(scalar)) {
    Term result = term_of(scalar.op(0), read);
    for (std::size_t i = 1; i < scalar.nops(); ++i) {
      const Term part = term_of(scalar.op(i), read);
      result = GiNaC::is_a<GiNaC::add>(scalar) ? result + part : result * part;
    }
    return result;
  }
  if (GiNaC::is_a<GiNaC::power>(scalar) && scalar.op(1).info(GiNaC::info_flags::integer)) {
    const int exponent = GiNaC::ex_to<GiNaC::numeric>(scalar.op(1)).to_int();
    const Term base = term_of(scalar.op(0), read);
    return power(exponent < 0 ? inverse(base) : base, std::abs(exponent));
  }
  if (GiNaC::is_a<GiNaC::function>(scalar)) {
    const std::string name = GiNaC::ex_to<GiNaC::function>(scalar).get_name();
    const Term argument = term_of(scalar.op(0), read);
    if (name == "cos" || name == "sin") {
      return name == "cos" ? cos(argument) : sin(argument);
    }
  }
  throw KernelError("a coefficient is no rational function");
}

}  // namespace stickslip::proofs::methods
