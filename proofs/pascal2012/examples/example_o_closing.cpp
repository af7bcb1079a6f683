#include "proofs/pascal2012/examples/example_o_closing.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/printed.hpp"
#include "numeric/families/overshooting.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using kernel::Term;
using kernel::Theorem;
using kernel::Variable;
using tactics::Symbolic;
using Coefficients = model::ClosingCoefficients<Symbolic>;

namespace {

const Variable tau_{"tau"}, tau1_{"tau1"};

const methods::Example& printed() {
  return example_named("O");
}

// As a definition O_NAME.
Term named(const std::string& name, const Term& number) {
  return tactics::defined("O_" + name, number);
}

Coefficients in_entries(model::Reading reading) {
  const numeric::motion::ExactParameters& a = printed().data;
  const Term T = Term(2) * kernel::pi() / Term(a.omega) - tau_ - tau1_;
  methods::Reader read;
  const auto value = [&](const symbols::Term& symbol) {
    return substitute(
        read(symbol),
        {{Variable{"T"}, T}, {Variable{"omega"}, a.omega}, {Variable{"p"}, a.p}, {Variable{"us"}, a.us}});
  };
  const auto entries = [&](const char * name, const symbols::Term& symbol) {
    const Term matrix = value(symbol);
    return model::Matrix4<Symbolic>(model::Matrix4<Symbolic>::NullaryExpr([&](auto i, auto j) {
      return Symbolic(named(fmt::format("{}{}{}", name, i + 1, j + 1),
                            entry(matrix, static_cast<int>(i), static_cast<int>(j))));
    }));
  };
  namespace v = symbols::vocabulary;
  const Symbolic omega = Term(a.omega), phi = Term(*printed().phi);
  return model::appendix3<Symbolic>({entries("H", v::H(v::tau)),
                                     entries("h", v::H(v::tau1)),
                                     entries("Htilde", v::H(v::tau + v::tau1)),
                                     entries("Gamma", v::Gamma(v::T)),
                                     {value(v::q1), value(v::q2)},
                                     {value(v::d01), value(v::d02)},
                                     omega,
                                     Term(a.V),
                                     T,
                                     phi,
                                     omega * Symbolic(tau_) + phi,
                                     omega * (Symbolic(tau_) + Symbolic(tau1_)) + phi},
                                    reading);
}

// Each of the twenty coefficients by another, with a name: a_1, ….
template <class Change>
Coefficients changed(Coefficients k, const Change& change) {
  model::each_coefficient(
      k, [&](char letter, int i, Symbolic& one) { one = change(fmt::format("{}_{}", letter, i), one.term); });
  return k;
}

// With it F_1 + share F_2 depends on tau hardly at all.
const Rational share(-729, 100);

// F_1 + share F_2 is the determinant of rows 1, 2, 3 of (21) and of row 4 + share row 5, by columns a, b, c,
// d.
template <class S>
Eigen::Matrix<S, 4, 4> closing_matrix(const model::ClosingCoefficients<S>& k, const S& factor) {
  Eigen::Matrix<S, 4, 4> rows;
  int column = 0;
  for (const std::array<S, 5> * x : {&k.a, &k.b, &k.c, &k.d}) {
    rows.col(column++) << x->at(0), x->at(1), x->at(2), S(x->at(3) + factor * x->at(4));
  }
  return rows;
}

// That matrix is nearly singular, and its determinant a sum of large numbers that cancel. A sum of its
// columns that is nearly zero stands here in the place of one of them, and such a sum of its rows in that of
// a row: the determinant is the same, as either sum has that column or row once.
struct Bordered {
  model::Matrix4<Symbolic> matrix;
  int row;

  [[nodiscard]] Symbolic& entry(int column) { return matrix(row, column); }
  // By its entries in that row.
  [[nodiscard]] Term determinant() const {
    std::vector<Term> sum;
    for (int column = 0; column < 4; ++column) {
      std::vector<Term> minor;
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
          if (i != row && j != column) {
            minor.push_back(matrix(i, j).term);
          }
        }
      }
      const Term product = matrix(row, column).term * kernel::determinant(kernel::matrix(3, 3, minor));
      sum.push_back((row + column) % 2 == 0 ? product : -product);
    }
    return kernel::sum(sum);
  }
};

// In doubles, at the middles of the ranges: the inverse is nearly a column times a row, which say what sums.
Bordered bordered(const model::Matrix4<Symbolic>& matrix, const orbits::Ranges& ranges) {
  const auto middle = [&](const Variable& time) {
    const auto& [from, to] = ranges.at(time);
    return Ball(Rational((from.value() + to.value()) / 2));
  };
  const Eigen::Matrix4d inverse =
      closing_matrix<Ball>(closing_of_O(middle(tau_), middle(tau1_), model::Reading::derived), Ball(share))
          .unaryExpr([](const Ball& one) { return one.approximate(); })
          .inverse();
  if (!inverse.allFinite()) {
    throw kernel::KernelError("the closing conditions are singular in the middle of the ranges");
  }
  Eigen::Index column = 0, row = 0;
  inverse.cwiseAbs().maxCoeff(&column, &row);
  model::Vector4<Symbolic> of_columns, of_rows;
  for (int i = 0; i < 4; ++i) {
    constexpr long unit = 1000000;
    const auto decimal = [&](double value) {
      return Symbolic(Term(Rational(std::lround(unit * value / inverse(column, row)), unit)));
    };
    of_columns(i) = decimal(inverse(i, row));
    of_rows(i) = decimal(inverse(column, i));
  }
  Bordered result{matrix, static_cast<int>(row)};
  result.matrix.col(column) = matrix * of_columns;
  result.matrix.row(row) = of_rows.transpose() * result.matrix;
  return result;
}

}  // namespace

Coefficients closing_of_O(const Term& tau, const Term& tau1, model::Reading reading) {
  const auto at_times = [&](const std::string& name, const Term& number) {
    return substitute(named(name, number), {{tau_, tau}, {tau1_, tau1}});
  };
  Coefficients k = changed(in_entries(model::Reading::derived), at_times);
  if (reading == model::Reading::printed) {
    k.c[0] = at_times("c_1_printed", in_entries(reading).c[0].term);
  }
  return k;
}

model::ClosingCoefficients<Ball> closing_of_O(const Ball& tau, const Ball& tau1, model::Reading reading) {
  const model::Oscillator<Ball>& o = printed_orbit(printed()).motion.oscillator;
  const Ball rest = Ball(2) * Ball::pi() / o.data.omega - tau - tau1;
  return model::appendix3<Ball>(
      model::appendix3_letters<Ball>(o.data.chi, o.modes, o.Q, o.d0, o.data.omega, o.data.V,
                                     Ball(*printed().phi), tau, tau1, rest),
      reading);
}

Theorem incompatible(const orbits::Ranges& ranges) {
  // In letters for the coefficients: none of them need be looked into.
  kernel::Substitution values;
  const Coefficients k = changed(closing_of_O(tau_, tau1_, model::Reading::derived),
                                 [&](const std::string& name, const Term& number) {
                                   values.emplace(Variable{name}, number);
                                   return Variable{name};
                                 });
  const auto F = model::compatibility<Symbolic>(k);
  const kernel::Formula both_zero = kernel::all({equal(F[0].term, 0), equal(F[1].term, 0)});
  const Theorem both = Theorem::assume(both_zero);
  Bordered sum = bordered(closing_matrix<Symbolic>(k, Term(share)), ranges);
  const kernel::Formula differs = differ(sum.determinant(), 0);
  const Theorem vanishes =
      Theorem::combination(differs.parts()[0], {{tactics::part(both, 0)}, {tactics::part(both, 1), share}});
  const Theorem excluded = Theorem::consequence(
      {Theorem::discharge(vanishes, both_zero), Theorem::assume(differs)}, negation(both_zero));
  // The sum of rows is nearly zero throughout, though the coefficients vary.
  orbits::Letters letters;
  kernel::Definitions names;
  for (int column = 0; column < 4; ++column) {
    const Variable letter{fmt::format("sum_{}", column + 1)};
    const Term number = named(letter.name, substitute(sum.entry(column).term, values));
    names.insert(number.definition());
    letters.emplace(letter, orbits::bounded_by_slopes(number, {tau_, tau1_}, ranges));
    sum.entry(column) = letter;
  }
  orbits::Ranges all = orbits::ranges_of(letters);
  all.insert(ranges.begin(), ranges.end());
  const Theorem other =
      orbits::settled(orbits::sign_by_parts(substitute(differ(sum.determinant(), 0), values), all), letters);
  return Theorem::cut(Theorem::convert(other, substitute(differs, values), names),
                      Theorem::instantiate(excluded, values));
}

PrintedClosing printed_closing_overshooting(const numeric::motion::ExactParameters& a, const Rational& phi,
                                            const std::array<Decimal, 5>& printed) {
  using namespace numeric::motion;
  using numeric::zeros::Box;
  require_stick_slip_domain(a);
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(a));
  const auto residuals = [&](const auto& number) -> Box<5> {
    Box<5> x;
    std::transform(printed.begin(), printed.end(), x.begin(), number);
    const Ball rest = Ball(2) * Ball::pi() / o.data.omega - x(0) - x(1);
    const Motion m =
        compose(o, Ball(phi), {x(2), x(3), x(4), o.data.V},
                {{PhaseKind::slip, x(0)}, {PhaseKind::overshoot, x(1)}, {PhaseKind::stick, rest}});
    const Phase& stick = m.phases[2];
    const model::Vector4<Ball> Z = flow<Ball>(o, stick.kind, stick.load, stick.Z, stick.duration);
    const Ball& V = o.data.V;  // a stick keeps z2' as it is
    return (Box<5>() << m.phases[1].Z(3) - V, Z(0) - x(2), Z(1) - x(3), Z(2) - x(4), stick.Z(3) - V)
        .finished();
  };
  PrintedClosing result{residuals([](const Decimal& decimal) { return Ball(decimal.value); }),
                        residuals(printed_interval),
                        Verdict::undecided("every closing condition may hold somewhere in the intervals")};
  if (std::ranges::any_of(result.at_intervals, [](const Ball& residual) { return residual.is_nonzero(); })) {
    result.verdict = Verdict::refuted("a closing condition holds nowhere in the printed intervals");
  }
  return result;
}

}  // namespace stickslip::proofs::pascal2012
