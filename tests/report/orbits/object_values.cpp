// Expressions printed at given parameters are read back as a reader would, and compared with the model's
// formulas in doubles.
#include "report/orbits/object_values.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "model/flows.hpp"
#include "model/nonsticking.hpp"

using namespace stickslip;
using report::orbits::GivenParameters;
using report::orbits::parameters_of;
using report::orbits::values_latex;
using symbolic::objects::find_object;

namespace {

const GivenParameters data{{"chi", Rational(3, 10)},  {"eta", 4}, {"us", Rational(1, 10)}, {"V", 0},
                           {"omega", Rational(3, 5)}, {"p", 1},   {"ur", Rational(3, 10)}};
const model::Parameters<double> a{0.3, 4, 0.1, 0, 0.6, 1};

std::string printed(const char * name, const GivenParameters& given = data, int digits = 14) {
  return values_latex(*find_object(name), given, digits);
}

// What stands behind "left = ", up to the end of the display or the next line.
std::string right_side(const std::string& text, const std::string& left) {
  const std::size_t from = text.find("\n" + left + " = ");
  REQUIRE(from != std::string::npos);
  const std::size_t end = std::min(text.find("\n\\end{gather*}", from), text.find("\n\\]", from));
  const std::string rest = text.substr(from + left.size() + 4, end - from - left.size() - 4);
  return rest.substr(0, rest.find(" = "));
}

std::vector<double> numbers_in(const std::string& text) {
  static const std::regex number(R"(-?[0-9]+\.?[0-9]*)");
  std::vector<double> found;
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i) {
    found.push_back(std::stod((*i)[0]));
  }
  return found;
}

// The 2×2 matrix of a block of H at t, from its matrices and the sine or cosine behind each.
model::Matrix2<double> block_at(double t, const std::string& text, const model::Modes<double>& m) {
  static const std::regex term(R"(\\begin\{pmatrix\}([^p]*)\\end\{pmatrix\}\\(cos|sin)\\omega_([12]) t)");
  model::Matrix2<double> sum = model::Matrix2<double>::Zero();
  for (std::sregex_iterator i(text.begin(), text.end(), term), end; i != end; ++i) {
    const std::vector<double> entries = numbers_in((*i)[1]);
    REQUIRE(entries.size() == 4);
    const double angle = ((*i)[3] == "1" ? m.omega1 : m.omega2) * t;
    const double wave = (*i)[2] == "cos" ? std::cos(angle) : std::sin(angle);
    sum += wave * model::matrix<double>(entries[0], entries[1], entries[2], entries[3]);
  }
  return sum;
}

}  // namespace

TEST_CASE("the blocks of H at given parameters are those of the model at any time") {
  const model::Modes<double> m = model::modes<double>(a.chi, a.eta);
  const std::string text = printed("H");
  for (const double t : {0.0, 0.7, 5.0}) {
    const model::Blocks<double> h = model::H_blocks(m, t);
    CHECK((block_at(t, right_side(text, "H_1(t)"), m) - h.first).norm() < 1e-11);
    CHECK((block_at(t, right_side(text, "H_2(t)"), m) - h.second).norm() < 1e-11);
    CHECK((block_at(t, right_side(text, "H_3(t)"), m) - h.third).norm() < 1e-11);
  }
}

TEST_CASE("what depends on the parameters alone is a number") {
  const model::Modes<double> m = model::modes<double>(a.chi, a.eta);
  CHECK(printed("K", data, 3).find("1 & -0.300 \\\\\n-1.20 & 1.20\n") != std::string::npos);
  const std::vector<double> Q = numbers_in(right_side(printed("Q"), "Q"));
  REQUIRE(Q.size() == 2);
  CHECK(Q[0] == doctest::Approx(model::Q(a, m)(0)).epsilon(1e-12));
  CHECK(Q[1] == doctest::Approx(model::Q(a, m)(1)).epsilon(1e-12));
  // With b_1 and b_2 by their numbers.
  const auto h = model::half_period<double>(a.chi, m, model::d0(a.chi, a.us), a.omega, M_PI);
  const std::vector<double> load = numbers_in(right_side(printed("load"), "p^2 > p_{\\min}^2"));
  REQUIRE(!load.empty());
  CHECK(load[0] == doctest::Approx(model::least_load_squared<double>(a, m, h, 0.3)).epsilon(1e-12));
}

TEST_CASE("what is not given stays a letter, and phi is in radians") {
  GivenParameters without = data;
  without.erase("ur");
  CHECK(right_side(printed("load", without), "p^2 > p_{\\min}^2").find("u_r^{2}") != std::string::npos);
  CHECK(printed("F").find("\\cos(\\omega t+\\varphi)") != std::string::npos);
  without["phi"] = Rational(1, 3);
  CHECK(printed("friction", without).find("$\\varphi = 1/3$ rad") != std::string::npos);
  CHECK(printed("cramer") == "% cramer is the same at all parameters.\n");
}

TEST_CASE("an expression needs the parameters that it depends on and no others") {
  using Names = std::vector<std::string>;
  CHECK(parameters_of({find_object("H1")}) == Names{"chi", "eta"});
  CHECK(parameters_of({find_object("Gamma")}) == Names{"chi"});
  CHECK(parameters_of({find_object("d0")}) == Names{"chi", "us"});
  CHECK(parameters_of({find_object("d0"), find_object("Q")}) == Names{"chi", "eta", "us", "omega", "p"});
  CHECK(parameters_of({find_object("cramer")}).empty());
}

TEST_CASE("where an expression has no value, none is printed") {
  // omega_1 = 1/2, omega_2 = 7/3.
  GivenParameters resonant = data;
  resonant["chi"] = Rational(120, 169);
  resonant["eta"] = Rational(28561, 4320);
  resonant["omega"] = Rational(1, 2);
  CHECK_THROWS_WITH_AS(printed("Q", resonant), doctest::Contains("not a natural frequency"), DomainError);
  // cos(3 pi/2) = 0.
  resonant["omega"] = Rational(1, 6);
  CHECK_NOTHROW(printed("Q", resonant));
  CHECK_THROWS_WITH_AS(printed("load", resonant), doctest::Contains("load has no value"), UsageError);
  CHECK_NOTHROW(printed("H", resonant));
  GivenParameters outside = data;
  outside["chi"] = 1;
  CHECK_THROWS_AS(printed("H", outside), DomainError);
  outside = data;
  outside["ur"] = Rational(1, 10);
  CHECK_THROWS_AS(printed("load", outside), DomainError);
}
