#include "proofs/symbols/parse.hpp"

#include <doctest/doctest.h>

#include <random>

#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"

using namespace stickslip;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

const Names& names() {
  static const Names all = names_of(symbol_table());
  return all;
}

Statement read(std::string_view line) {
  const std::vector<Statement> all = parse_statements(line, names());
  REQUIRE(all.size() == 1);
  return all.front();
}

std::string refusal(std::string_view line) {
  try {
    (void)parse_statements(line, names());
    return "";
  } catch (const ParseError& error) {
    return error.what();
  }
}

void check_round_trip(const Statement& statement) {
  const std::string line = text(statement);
  CAPTURE(line);
  const Statement again = read(line);
  CHECK(text(again) == line);
  CHECK(latex(again) == latex(statement));
  CHECK(again.relation == statement.relation);
  CHECK(again.left.shape() == statement.left.shape());
}

}  // namespace

TEST_CASE("every statement of the paper is read back from its own print") {
  int statements = 0;
  for (const auto& claim : proofs::pascal2012::paper().claims) {
    CAPTURE(claim.id);
    std::vector<Statement> all = claim.printed;
    all.insert(all.end(), claim.corrected.begin(), claim.corrected.end());
    for (const auto& assumption : claim.assumptions) {
      all.push_back(assumption.statement);
    }
    for (const Statement& one : all) {
      check_round_trip(one);
      ++statements;
    }
  }
  CHECK(statements > 1000);
}

TEST_CASE("a line is read as it is meant") {
  CHECK(equal(read("H1(t)^2 - I = H2(t) H3(t)"), equation(power(H1(t), 2) - I2, H2(t) * H3(t))));
  CHECK(equal(read("H1^2(t) − I ≠ H2(t)·H3(t)"),
              Statement{power(H1(t), 2) - I2, H2(t) * H3(t), Relation::not_equal}));
  CHECK(
      equal(read("ω₁² ≤ omega_2^2"), Statement{power(omega1, 2), power(omega2, 2), Relation::less_or_equal}));
  CHECK(equal(read("-chi eta = 0.25"), equation(-chi * eta, Term(Rational(1, 4)))));
  CHECK(equal(read("d/dt[t B2(t)] = B2(t) + t B2'(t)"),
              equation(derivative(t * B2(t)), B2(t) + t * derivative(B2(t)))));
  CHECK(equal(read("[0, I; -K, 0] Z0 = 0"), equation(first_order(K) * Z0, zero(4, 1))));
  CHECK(text(read("Z0 - 0 + (0)/2 = [1; 0; 0; 0]")) == "Z0 - 0 + 0/2 = [1; 0; 0; 0]");
  CHECK(text(read("K ([0; V] - 0) = d0")) == "K*([0; V] - 0) = d0");
  CHECK(equal(read("det(H3(t)) > 0"), Statement{determinant(H3(t)), 0, Relation::greater}));
  CHECK(equal(read("|q1| < us, 0 < t < tau"), during(0, tau, Statement{abs(q1), us, Relation::less})));
  CHECK(equal(read("X'(t) = Y(t) for almost all 0 < t < tau"),
              almost_always(0, tau, equation(derivative(X(t)), Y(t)))));
  // A quantity and a function of one name: the bracket says which.
  CHECK(equal(read("x1 (t + s) = x1(t)"), equation(scalar("x1") * (t + s), Function{"x1", {}}(t))));
  const std::vector<Statement> chain = parse_statements("0 < omega1 < 1 < omega2", names());
  REQUIRE(chain.size() == 3);
  CHECK(equal(chain[1], Statement{omega1, 1, Relation::less}));
}

TEST_CASE("what cannot be read is refused where it goes wrong") {
  CHECK(refusal("H1(t)^2 - I = H9(t)") == "column 15: no symbol 'H9'; there are H, H1, H2, H3, H11, H12");
  CHECK(refusal("tau/2 omega = 1") == "column 7: a product after a fraction: write a/b*c or a/(b c)");
  CHECK(refusal("Z0 + d0 = 0") ==
        "column 6: this is a column of 2, and what it stands with is a column of 4");
  CHECK(refusal("K Z0 = 0") ==
        "column 3: this is a column of 4, and is multiplied by a 2 x 2 matrix from the left");
  CHECK(refusal("chi +") ==
        "column 6: the line ends, where one expects a number, a symbol, a function or a bracket");
  CHECK(refusal("chi eta") ==
        "column 8: the line ends, where one expects =, !=, <, <=, > or >= and what stands on its other side");
  CHECK(refusal("I = I") == "column 1: nothing says how large this I is");
  CHECK(refusal("tau' = 1") == "column 4: a prime is the rate of a function of time, and tau is none");
  CHECK(refusal("X'(tau) = 0") == "column 4: a prime is a rate in t: write X'(t), or d/dt[...]");
  CHECK(refusal("H = 1") == "column 1: H is a function: write H(t)");
  CHECK(refusal("chi^-x = 1") == "column 6: there is 'x', where one expects a whole number as exponent");
  CHECK(refusal("chi^100000 = 1") == "column 5: an exponent is at most 200");
  CHECK(refusal("cos^-1(t) = 1") == "column 1: cos^-1 may mean two things: write 1/cos(t)");
  CHECK(refusal("x1(t) < V, 0 < t < tau, continuous on [0, 5]")
            .starts_with("column 40: what is differentiated is"));
  CHECK(refusal("X'(t) = Y(t), 0 < t < tau, continuous on [0, 5]")
            .starts_with("column 43: what is differentiated is"));
  CHECK(refusal("chi^0.5 = 1") == "column 5: there is '0.5', where one expects a whole number as exponent");
  CHECK(refusal("H(t)^51 = I") == "column 1: the exponent of a matrix is at most 50");
  CHECK(refusal("Z0^2 = 0") ==
        "column 1: this is a column of 4, and only square matrices have powers and determinants");
  CHECK(refusal("[1, 2; 3] = 0") == "column 9: a row of 1, and the first row has 2");
  CHECK(refusal("chi = \\eta") == "column 7: a character that is no part of a formula");
  CHECK(refusal("chi = 2 3") == "column 9: a number after a factor: write the number first, or '*' between");
  CHECK(refusal("η = ω₃").starts_with("column 5: no symbol 'omega3'; there are"));
  CHECK(refusal("") ==
        "column 1: the line ends, where one expects a number, a symbol, a function or a bracket");
  const std::string deep = std::string(100000, '(');
  CHECK(refusal(deep) == "column 1: a line has at most 20000 characters");
  CHECK(refusal(std::string(1000, '(') + "1") ==
        "column 201: brackets stand in one another at most 200 deep");
  std::string fractions = "1";
  for (int i = 0; i < 300; ++i) {
    fractions += "/2";
  }
  CHECK(refusal(fractions + " = 1") == "column 402: at most 200 fractions one after the other");
  try {
    (void)parse_statements("χ = ", names());
    FAIL("it ends too early");
  } catch (const ParseError& error) {
    CHECK(error.excerpt() == "  χ = \n      ^");
  }
}

namespace {

// Terms drawn at random, numbers or 2 x 2 matrices.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  Term number(int depth) {
    switch (depth == 0 ? below(2) : below(10)) {
      case 0:
        return below(20);
      case 1:
        return std::vector<Term>{chi, eta, omega1, tau, scalar("b_1"), scalar("x1"), t}[index(7)];
      case 2:
        return number(depth - 1) + number(depth - 1);
      case 3:
        return number(depth - 1) - number(depth - 1);
      case 4:
        return number(depth - 1) * number(depth - 1);
      case 5:
        return number(depth - 1) / number(depth - 1);
      case 6:
        return power(number(depth - 1), below(4) - 1);
      case 7:
        return std::vector<Term (*)(const Term&)>{cos, exp, sqrt, abs}[index(4)](number(depth - 1));
      case 8:
        return determinant(matrix(depth - 1));
      default:
        return -number(depth - 1);
    }
  }

  Term matrix(int depth) {
    switch (depth == 0 ? below(2) : below(9)) {
      case 0:
        return K;
      case 1:
        return Lambda;
      case 2:
        return matrix(depth - 1) + matrix(depth - 1);
      case 3:
        return matrix(depth - 1) - I2;
      case 4:
        return matrix(depth - 1) * matrix(depth - 1);
      case 5:
        return number(depth - 1) * matrix(depth - 1);
      case 6:
        return inverse(matrix(depth - 1));
      case 7:
        return block(2, {number(depth - 1), number(depth - 1), number(depth - 1), number(depth - 1)});
      default:
        return below(2) == 0 ? H1(number(depth - 1)) : derivative(H2(t));
    }
  }

  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }

 private:
  std::size_t index(int end) { return static_cast<std::size_t>(below(end)); }
  std::mt19937 random_;
};

}  // namespace

TEST_CASE("terms drawn at random are read back from their print") {
  Draw draw(20261125);
  for (int i = 0; i < 3000; ++i) {
    const int depth = 1 + draw.below(4);
    const Term left = draw.below(2) == 0 ? draw.number(depth) : draw.matrix(depth);
    check_round_trip({left, left.shape().is_scalar() ? draw.number(2) : draw.matrix(2),
                      static_cast<Relation>(draw.below(6))});
  }
}

TEST_CASE("characters left out or put in end in a refusal or in another statement") {
  std::mt19937 random(7);
  const std::string line = "Z(t) = H(t)*(Z0 - F0) + [0, I; -K, 0]*F(t)/2, 0 < t < tau";
  const std::string signs = "+-*/^()[]|,;=<>'t12 .ωI";
  int read_anyway = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string changed = line;
    for (int k = 0; k < 1 + i % 3; ++k) {
      changed[random() % changed.size()] = signs[random() % signs.size()];
    }
    try {
      read_anyway += parse_statements(changed, names()).empty() ? 0 : 1;
    } catch (const ParseError&) {
      continue;
    }
  }
  CHECK(read_anyway > 100);
  CHECK(read_anyway < 15000);
}
