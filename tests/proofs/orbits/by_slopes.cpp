#include "proofs/orbits/enclosed_matrix.hpp"

#include <doctest/doctest.h>

#include "tests/proofs/orbits/letters.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::orbits;
using namespace stickslip::proofs::orbits::letters;

namespace {

Term square(const Term& of) {
  return Definition("square", {x}, power(x, 2))({of});
}
// Of x and y nearly 1: x² - 2x + y⁴ - 4y + a, whose slopes are zero at 1.
Term level() {
  return Definition("level", {a, x, y},
                    square(x) - Term(2) * x + square(square(y)) - Term(4) * y + Term(a))({a, x, y});
}
Ranges about_one_each(const std::vector<Variable>& variables) {
  Ranges ranges;
  for (const Variable& one : variables) {
    ranges.merge(about_one(one));
  }
  return ranges;
}
Rational width(const Known& known) {
  return known.range.second.value() - known.range.first.value();
}

}  // namespace

TEST_CASE("a number that varies little is bounded by its slopes, and they say so of the number itself") {
  Ranges ranges = about_one_each({x, y});
  ranges.emplace(a, Interval{5, 5});
  const Known known = bounded_by_slopes(level(), {x, y}, ranges);
  CHECK(known.value == level());
  CHECK(known.lower.conclusion() == at_most(known.range.first, level()));
  CHECK(known.upper.conclusion() == at_most(level(), known.range.second));
  Formulas said;
  for (const auto& [variable, range] : ranges) {
    said.insert({at_most(range.first, variable), at_most(variable, range.second)});
  }
  for (const Theorem& side : {known.lower, known.upper}) {
    CHECK(std::ranges::includes(said, side.hypotheses(), Before{}));
  }
  // It is 1 + 7e-6 at the corners, 1 in the middle; of its parts alone no more is said than 1 ± 1.2e-2.
  CHECK(known.range.first.value() <= 1);
  CHECK(known.range.second.value() >= Rational(1000007, 1000000));
  CHECK(width(known) < Rational(1, 10000));
  CHECK(width(bounded_by_parts(level(), ranges)) > Rational(1, 100));
}

TEST_CASE("bounds by slopes hold where the number rises and where it falls, and with variables that stay") {
  const auto ends = [](const Term& body) {
    const std::vector<Variable> parameters(body.variables().begin(), body.variables().end());
    const Term number = Definition("number", parameters, body)({parameters.begin(), parameters.end()});
    return bounded_by_slopes(number, {x}, about_one_each(parameters)).range;
  };
  for (const auto& [body, least, most] :
       {std::tuple(Term(x), Rational(999, 1000), Rational(1001, 1000)),
        {Term(-3) * x, Rational(-3003, 1000), Rational(-2997, 1000)},
        {inverse(Term(y)) * x, Rational(999, 1001), Rational(1001, 999)},
        {square(x) * y, Rational(997002999, 1000000000), Rational(1003003001, 1000000000)}}) {
    CAPTURE(least.get_d());
    const auto [from, to] = ends(body);
    CHECK(from.value() <= least);
    CHECK(to.value() >= most);
    CHECK(to.value() - from.value() < (most - least) * 3 / 2);
  }
}

TEST_CASE("bounds by slopes are refused of what is no definition, does not vary, or divides by zero") {
  const auto refused = [](const Term& number, const Variable& along) {
    CHECK_THROWS_AS(static_cast<void>(bounded_by_slopes(number, {along}, about_one_each({a, x, y}))),
                    KernelError);
  };
  refused(Term(2) * x, x);
  refused(square(x), y);
  refused(Definition("column", {x}, matrix(2, 1, {x, 1}))({x}), x);
  refused(Definition("pole", {x}, inverse(Term(x) - 1))({x}), x);
  refused(Definition("pole", {x, y}, Term(x) * inverse(Term(y) - 1))({x, y}), x);
  refused(Definition("divided", {x}, inverse(Term(x)))({x}), x);
}
