#include "proofs/symbols/meaning.hpp"

#include <doctest/doctest.h>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "proofs/checks/premises.hpp"
#include "proofs/kernel/entrywise.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/symbols/sample.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/symbols/vocabulary.hpp"

using namespace stickslip;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

// Of every scalar that stands for itself a number of its own.
const std::vector<Coordinate>& point() {
  static const std::vector<Coordinate> all = [] {
    std::vector<Coordinate> result{{"omega1", Rational(3, 5)}, {"omega2", Rational(11, 5)}};
    int next = 10;
    for (const Symbol& symbol : symbol_table()) {
      if (symbol.shape.is_scalar() && !symbol.of_time && !symbol.name.starts_with("omega") &&
          proofs::checks::stands_for_itself(scalar(symbol.name))) {
        result.push_back({symbol.name, Rational(++next, 70)});
      }
    }
    result.push_back({"omega", Rational(4, 5)});
    return result;
  }();
  return all;
}

// The numbers of which terms are made, there.
struct There {
  using Number = Ball;
  static Ball number(const Rational& value) { return Ball(value); }
  static Ball pi() { return Ball::pi(); }
  static Ball reciprocal(const Ball& value) { return Ball(1) / value; }
  static Ball cosine(const proofs::kernel::Term& argument, auto& entries) {
    return cos(entries(argument)[0]);
  }
  static Ball sine(const proofs::kernel::Term& argument, auto& entries) { return sin(entries(argument)[0]); }
  static Ball exponential(const proofs::kernel::Term& argument, auto& entries) {
    return exp(entries(argument)[0]);
  }
  static std::vector<Ball> atom(const proofs::kernel::Term& term, auto& entries) {
    return term.kind() == proofs::kernel::Kind::defined ? entries(term.definition().unfolded(term.parts()))
                                                        : std::vector<Ball>{at_point(point())(term.name())};
  }
};

// The same term by both engines: the model's templates over balls (and jets), and what it is read as in the
// kernel, definitions opened.
void both_engines_agree(const Term& term) {
  CAPTURE(text(term));
  const Value<Ball> direct = evaluate<Ball>(term, at_point(point()));
  proofs::methods::Reader read;
  const proofs::kernel::Term as_read = read(term);
  proofs::kernel::Entrywise<There> there({});
  const std::vector<Ball>& entries = there(as_read);
  REQUIRE(direct.size() == static_cast<Eigen::Index>(entries.size()));
  for (Eigen::Index i = 0; i < direct.size(); ++i) {
    const Ball& one = direct(i / direct.cols(), i % direct.cols());
    const Ball& other = entries[static_cast<std::size_t>(i)];
    CHECK(one.is_finite());
    CHECK(one.overlaps(other));
    CHECK((one - other).radius().approximate() < 1e-25);
  }
}

}  // namespace

TEST_CASE("every symbol that has a meaning means the same to both engines") {
  int tried = 0;
  for (const Symbol& symbol : symbol_table()) {
    const Term term(Term::Node{symbol.of_time ? Op::function : Op::symbol, symbol.shape, symbol.name, 0,
                               symbol.of_time ? std::vector<Term>{t} : std::vector<Term>{}});
    if (is_in_field(term) && (!symbol.shape.is_scalar() || symbol.value)) {
      both_engines_agree(term);
      ++tried;
    }
  }
  CHECK(tried > 100);
}

TEST_CASE("every operation means the same to both engines") {
  for (const Term& term : {H(t) * (Z0 - F0) + F(t) + 2 * L(t) * d0, determinant(H(t)), inverse(H2(t)) * H1(t),
                           power(H1(t - s), 3), -H1(t) / omega, block(2, {H1(t), zero(2, 2), H2(t), I2}),
                           exp(-chi * t) * sin(t)}) {
    both_engines_agree(term);
  }
}

TEST_CASE("numbers of any length have their value") {
  const Rational long_one = parse_decimal("-3.14159265358979323846264338327950288").value;
  const Ball value = evaluate<Ball>(Term(long_one), at_point(point()))(0, 0);
  CHECK(value.overlaps(Ball(long_one)));
  CHECK(value.radius().approximate() < 1e-25);
}

TEST_CASE("a motion has no meaning by itself, and derivatives of any order are exact") {
  const auto data = point();
  const Lookup<Ball> here = at_point(data);
  CHECK_THROWS_AS((void)evaluate<Ball>(Z(t), here), NoValue);
  const Value<Ball> flow = evaluate<Ball>(derivative(H(t)) * Z0, here),
                    system = evaluate<Ball>(block(2, {zero(2, 2), I2, -K, zero(2, 2)}) * H(t) * Z0, here);
  for (Eigen::Index i = 0; i < flow.size(); ++i) {
    CHECK(flow(i).overlaps(system(i)));
  }
  const Ball third = evaluate<Ball>(derivative(derivative(derivative(sin(2 * t)))), here)(0, 0);
  CHECK(third.overlaps(evaluate<Ball>(-8 * cos(2 * t), here)(0, 0)));
  CHECK_FALSE(third.overlaps(evaluate<Ball>(8 * cos(2 * t), here)(0, 0)));
  const Ball decay = evaluate<Ball>(derivative(derivative(exp(-3 * t) * t)), here)(0, 0);
  CHECK(decay.overlaps(evaluate<Ball>((9 * t - 6) * exp(-3 * t), here)(0, 0)));
  CHECK_FALSE(decay.overlaps(evaluate<Ball>((9 * t + 6) * exp(-3 * t), here)(0, 0)));
}
