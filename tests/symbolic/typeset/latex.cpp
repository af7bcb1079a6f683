// Exact strings: that they are met in every run, under any order of construction, is the test of determinism.
#include "symbolic/typeset/latex.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>

#include "core/error.hpp"
#include "model/flows.hpp"

using namespace stickslip;
using namespace stickslip::symbolic::typeset;
using GiNaC::ex;
using GiNaC::Pi;

namespace {

const std::vector<std::string> names = {
    "chi",  "eta", "us",  "p",   "omega",  "omega1", "omega2", "lambda1", "lambda2", "t", "phi", "tau",
    "tau1", "T",   "z10", "z20", "zdot10", "V",      "q1",     "q2",      "d01",     "a", "b",   "x"};

// Symbols made in an order and at addresses that depend on the seed.
class Symbols {
 public:
  explicit Symbols(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::string> shuffled = names;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    for (const std::string& name : shuffled) {
      for (unsigned i = random() % 4; i > 0; --i) {
        noise_.push_back(GiNaC::symbol());
      }
      symbols_[name] = GiNaC::symbol(name);
    }
  }
  const ex& operator()(const std::string& name) const { return symbols_.at(name); }

  // Reads what text() wrote.
  [[nodiscard]] ex parse(const std::string& text) const {
    GiNaC::symtab table(symbols_.begin(), symbols_.end());
    table["pi"] = Pi;
    return GiNaC::parser(table, true)(text);
  }

  [[nodiscard]] model::Modes<ex> modes() const {
    return {symbols_.at("omega1"), symbols_.at("omega2"), symbols_.at("lambda1"), symbols_.at("lambda2")};
  }
  // With (39): lambda_j, and chi as well if it is not given.
  [[nodiscard]] model::Modes<ex> modes(const ex& chi) const {
    return model::modes_of<ex>(chi, symbols_.at("omega1"), symbols_.at("omega2"));
  }
  [[nodiscard]] ex chi_in_frequencies() const {
    return model::chi_from_frequencies<ex>(symbols_.at("omega1"), symbols_.at("omega2"));
  }

 private:
  std::map<std::string, ex> symbols_;
  std::vector<ex> noise_;
};

const Symbols s(1);

// A random rational expression in the seed's choice of symbols and phases, its operands in the given symbols.
class RandomExpression {
 public:
  RandomExpression(unsigned seed, const Symbols& symbols) : random_(seed), symbols_(symbols) {}

  ex sum(int depth) {
    ex result = below(7) - 3;
    for (int i = below(3); i >= 0; --i) {
      result += (below(7) - 3) * product(depth);
    }
    return result;
  }

 private:
  int below(unsigned n) { return static_cast<int>(random_() % n); }

  ex product(int depth) {
    ex result = 1;
    for (int i = below(3); i >= 0; --i) {
      result *= factor(depth);
    }
    return result;
  }

  ex factor(int depth) {
    static const std::vector<std::string> few = {"a", "b", "x", "omega1", "omega2", "chi"};
    const ex phase = symbols_("omega1") * symbols_("t") + below(2) * symbols_("phi");
    switch (below(depth > 0 ? 10 : 7)) {
      case 0:
        return cos(phase);
      case 1:
        return sin(phase / 2);
      case 7:
        return sum(depth - 1);
      case 8:
        return pow(sum(depth - 1), 2);
      case 9:
        return 1 / (sum(depth - 1) + symbols_("eta"));
      default:
        return pow(symbols_(few[static_cast<std::size_t>(below(6))]), below(3));
    }
  }

  std::mt19937 random_;
  const Symbols& symbols_;
};

ex random_expression(unsigned seed, const Symbols& symbols) {
  return RandomExpression(seed, symbols).sum(1);
}

// The sum of the terms of a sum and the product of the factors of a product, built in a shuffled order.
ex rebuilt(const ex& e, std::mt19937& random) {
  if (!GiNaC::is_a<GiNaC::add>(e) && !GiNaC::is_a<GiNaC::mul>(e)) {
    return e;
  }
  std::vector<ex> operands;
  for (const ex& operand : e) {
    operands.push_back(rebuilt(operand, random));
  }
  std::shuffle(operands.begin(), operands.end(), random);
  ex result = GiNaC::is_a<GiNaC::add>(e) ? 0 : 1;
  for (const ex& operand : operands) {
    result = GiNaC::is_a<GiNaC::add>(e) ? result + operand : result * operand;
  }
  return result;
}

}  // namespace

TEST_CASE("numbers, signs and products") {
  const ex x = s("x"), a = s("a"), b = s("b"), chi = s("chi");
  CHECK(latex(ex(0)) == "0");
  CHECK(latex(ex(-3)) == "-3");
  CHECK(latex(-ex(1) / 2) == "-\\frac{1}{2}");
  CHECK(latex(-x) == "-x");
  CHECK(latex(2 * Pi / s("omega")) == "\\frac{2\\pi}{\\omega}");
  CHECK(latex(s("T") * chi * pow(s("p"), 3) * 2) == "2\\chi p^{3} T");
  CHECK(latex(-2 * Pi * chi * s("V")) == "-2\\pi\\chi V");
  CHECK(latex(b - a) == "b-a");
  CHECK(latex(-chi - 1) == "-\\chi-1");
  CHECK(latex(a / 2 - b / 3) == "\\frac{3a-2b}{6}");
  CHECK(latex(1 / (b - a)) == "\\frac{1}{b-a}");
  CHECK(latex(-a / (a + b)) == "-\\frac{a}{a+b}");
  CHECK(latex(-s("us") / (1 - chi)) == "-\\frac{u_s}{1-\\chi}");
  CHECK(latex(pow(a + b, 2) * (a - b)) == "(a+b)^{2}(a-b)");
  CHECK(latex(2 * a * x - 2 * a * b + x * x - b * x) == "(2a+x)(x-b)");
  CHECK(latex(1 / (1 / a + 1 / b) + 1) == "\\frac{a b+a+b}{a+b}");
  CHECK(latex(pow(a, 4) - pow(b, 4)) == "(a^{2}+b^{2})(a^{2}-b^{2})");
  CHECK(latex(sqrt(a / b)) == "\\sqrt{\\frac{a}{b}}");
  CHECK(latex(sqrt(a / b) / x) == "\\frac{\\sqrt{a/b}}{x}");
  CHECK(latex(abs(b - a) * x) == "x|a-b|");
}

TEST_CASE("phases") {
  const ex t = s("t"), phi = s("phi"), tau = s("tau"), tau1 = s("tau1"), omega = s("omega"),
           omega1 = s("omega1");
  CHECK(latex(cos(phi + omega * t)) == "\\cos(\\omega t+\\varphi)");
  CHECK(latex(sin(-tau * omega / 2)) == "-\\sin\\frac{\\omega\\tau}{2}");
  CHECK(latex(cos(tau * omega / 2) / omega) == "\\frac{\\cos(\\omega\\tau/2)}{\\omega}");
  CHECK(latex(pow(cos(omega1 * t), 2) * sin(t)) == "\\cos^{2}\\omega_1 t\\sin t");
  CHECK(latex(pow(cos(omega1 * t), 2) - 1) == "\\cos^{2}\\omega_1 t-1");
  CHECK(latex(cos(omega * tau + omega * tau1 + phi)) == "\\cos(\\omega(\\tau+\\tau_1)+\\varphi)");
  CHECK(latex(sin(omega1 * tau / 2 + omega1 * tau1 / 2)) == "\\sin(\\omega_1(\\tau+\\tau_1)/2)");
  CHECK(latex(cos(omega1 * (t - tau))) == "\\cos(\\omega_1(\\tau-t))");
  CHECK(latex(sin(omega1 * (t - tau))) == "-\\sin(\\omega_1(\\tau-t))");
  CHECK(latex(cos(omega1 * (2 * Pi / omega - tau))) == "\\cos(\\omega_1(2\\pi/\\omega-\\tau))");
  CHECK(latex(tan(omega1 * Pi / 2 / omega)) == "\\tan\\frac{\\pi\\omega_1}{2\\omega}");
  CHECK(latex(tan(omega1 * Pi / 2 / omega) / tau) == "\\frac{\\tan(\\pi\\omega_1/(2\\omega))}{\\tau}");
  CHECK(latex((Pi - omega * tau) / 2) == "\\frac{\\pi-\\omega\\tau}{2}");
  CHECK(latex(cos(omega * (t + tau) - omega * t - omega * tau)) == "1");
  CHECK(latex(cos(omega * (t + tau)) - cos(omega * t + omega * tau)) == "0");
  CHECK(latex(s("q1") * cos(phi) - s("d01") - s("z10") * sin(phi)) ==
        "q_1\\cos\\varphi-z_{10}\\sin\\varphi-d_{01}");
}

TEST_CASE("the slip flow with free modes and with (39)") {
  const ex t = s("t");
  const model::Blocks<ex> h = model::H_blocks<ex>(s.modes(), t);
  CHECK(latex(h.first(0, 0)) ==
        "\\frac{\\lambda_2\\cos\\omega_1 t-\\lambda_1\\cos\\omega_2 t}{\\lambda_2-\\lambda_1}");
  CHECK(latex(h.first(0, 1)) == "\\frac{\\cos\\omega_1 t-\\cos\\omega_2 t}{\\lambda_1-\\lambda_2}");
  CHECK(latex(h.first) ==
        "\\frac{1}{\\lambda_2-\\lambda_1}\\begin{pmatrix}\n"
        "\\lambda_2\\cos\\omega_1 t-\\lambda_1\\cos\\omega_2 t & \\cos\\omega_2 t-\\cos\\omega_1 t \\\\\n"
        "\\lambda_1\\lambda_2(\\cos\\omega_1 t-\\cos\\omega_2 t) & "
        "\\lambda_2\\cos\\omega_2 t-\\lambda_1\\cos\\omega_1 t\n\\end{pmatrix}");
  CHECK(latex(h.second(0, 0)) ==
        "\\frac{\\lambda_2\\omega_2\\sin\\omega_1 t-\\lambda_1\\omega_1\\sin\\omega_2 t}"
        "{\\omega_1\\omega_2(\\lambda_2-\\lambda_1)}");
  CHECK(latex(h.third(1, 0)) ==
        "\\frac{\\lambda_1\\lambda_2(\\omega_1\\sin\\omega_1 t-\\omega_2\\sin\\omega_2 t)}"
        "{\\lambda_1-\\lambda_2}");
  CHECK(latex(model::L<ex>(s.modes(), t)(0, 0)) ==
        "\\frac{\\lambda_2\\cos\\omega_1 t-\\lambda_1\\cos\\omega_2 "
        "t+\\lambda_1-\\lambda_2}{\\lambda_2-\\lambda_1}");

  const model::Blocks<ex> g = model::H_blocks<ex>(s.modes(s("chi")), t);
  CHECK(latex(g.first) ==
        "\\frac{1}{\\omega_2^{2}-\\omega_1^{2}}\\begin{pmatrix}\n"
        "(\\omega_2^{2}-1)\\cos\\omega_1 t+(1-\\omega_1^{2})\\cos\\omega_2 t & "
        "\\chi(\\cos\\omega_1 t-\\cos\\omega_2 t) \\\\[8pt]\n"
        "\\dfrac{(1-\\omega_1^{2})(\\omega_2^{2}-1)(\\cos\\omega_1 t-\\cos\\omega_2 t)}{\\chi} & "
        "(1-\\omega_1^{2})\\cos\\omega_1 t+(\\omega_2^{2}-1)\\cos\\omega_2 t\n\\end{pmatrix}");
  const model::Blocks<ex> f = model::H_blocks<ex>(s.modes(s.chi_in_frequencies()), t);
  CHECK(latex(f.second(1, 0)) ==
        "\\frac{(\\omega_1^{2}+\\omega_2^{2}-1)(\\omega_2\\sin\\omega_1 t-\\omega_1\\sin\\omega_2 t)}"
        "{\\omega_1\\omega_2(\\omega_2^{2}-\\omega_1^{2})}");
}

TEST_CASE("parameters, load and stick") {
  const ex chi = s("chi"), omega1 = s("omega1"), omega2 = s("omega2"), t = s("t");
  CHECK(latex(model::lambda<ex>(chi, omega2)) == "\\frac{1-\\omega_2^{2}}{\\chi}");
  CHECK(latex(s.chi_in_frequencies()) ==
        "\\frac{(1-\\omega_1^{2})(\\omega_2^{2}-1)}{\\omega_1^{2}+\\omega_2^{2}-1}");
  CHECK(latex(1 - s.chi_in_frequencies()) ==
        "\\frac{\\omega_1^{2}\\omega_2^{2}}{\\omega_1^{2}+\\omega_2^{2}-1}");
  CHECK(latex(model::eta_from_frequencies<ex>(omega1, omega2)) ==
        "\\frac{(\\omega_1^{2}+\\omega_2^{2}-1)^{2}}{(1-\\omega_1^{2})(\\omega_2^{2}-1)}");
  CHECK(latex(model::lambda<ex>(s.chi_in_frequencies(), omega1)) ==
        "\\frac{\\omega_1^{2}+\\omega_2^{2}-1}{\\omega_2^{2}-1}");
  CHECK(latex(model::d0<ex>(chi, s("us"))) ==
        "\\frac{u_s}{1-\\chi}\\begin{pmatrix}\n1 \\\\[8pt]\n\\dfrac{1}{\\chi}\n\\end{pmatrix}");
  CHECK(latex(model::Sigma<ex>(chi) * model::Sigma<ex>(chi)) ==
        "\\begin{pmatrix}\n1 & 2\\chi \\\\\n0 & 1\n\\end{pmatrix}");
  const model::Parameters<ex> all{chi, s("eta"), s("us"), s("V"), s("omega"), s("p")};
  CHECK(latex(model::Q<ex>(all, s.modes())) ==
        "\\frac{p}{(\\omega^{2}-\\omega_1^{2})(\\omega^{2}-\\omega_2^{2})}"
        "\\begin{pmatrix}\n\\chi \\\\\n1-\\omega^{2}\n\\end{pmatrix}");
  const model::Vector2<ex> q(s("q1"), s("q2"));
  CHECK(latex(model::F<ex>(q, s("omega"), s("omega") * t + s("phi"))) ==
        "\\begin{pmatrix}\nq_1\\cos(\\omega t+\\varphi) \\\\\nq_2\\cos(\\omega t+\\varphi) \\\\\n"
        "-q_1\\omega\\sin(\\omega t+\\varphi) \\\\\n-q_2\\omega\\sin(\\omega t+\\varphi)\n\\end{pmatrix}");
  CHECK(latex(model::Gamma<ex>(chi, t).topRows<2>()) ==
        "\\begin{pmatrix}\n\\cos t & \\chi(1-\\cos t) & \\sin t & \\chi(t-\\sin t) \\\\\n0 & 1 & 0 & t\n"
        "\\end{pmatrix}");
}

TEST_CASE("plain text") {
  CHECK(text(pow(s("omega1"), 2) - pow(s("omega2"), 2)) == "omega1^2 - omega2^2");
  CHECK(text(model::H_blocks<ex>(s.modes(), s("t")).first(0, 0)) ==
        "(lambda2*cos(omega1*t) - lambda1*cos(omega2*t))/(lambda2 - lambda1)");
  CHECK(text(pow(sin(s("omega") * s("tau") / 2), 2) / -2) == "-sin(omega*tau/2)^2/2");
  CHECK(text(Pi / s("omega") / 2) == "pi/(2*omega)");
}

TEST_CASE("random expressions: the text of the layout is equal to what was laid out") {
  for (unsigned seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    const ex e = random_expression(seed, s);
    const std::string printed = text(e);
    CAPTURE(printed);
    CHECK((s.parse(printed) - e).normal().is_zero());
    CHECK(text(s.parse(printed)) == printed);
    CHECK(latex(e.expand()) == latex(e));
  }
}

TEST_CASE("the order in which symbols and operands were made leaves no trace") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const std::string expected = latex(random_expression(seed, s));
    for (unsigned other = 2; other < 6; ++other) {
      const Symbols symbols(other + 10 * seed);
      std::mt19937 random(other);
      const ex e = random_expression(seed, symbols);
      CHECK(latex(e) == expected);
      CHECK(latex(rebuilt(e, random)) == expected);
    }
  }
}

TEST_CASE("no fraction stands within a fraction") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const std::string printed = latex(random_expression(seed, s) / (s("eta") - s("a")));
    CAPTURE(printed);
    const bool built_up = printed.starts_with("\\frac") || printed.starts_with("-\\frac");
    CHECK((!built_up || printed.find("\\frac", 2) == std::string::npos));
  }
}

TEST_CASE("what is not an exact scalar is refused") {
  CHECK_THROWS_AS((void)latex(ex(0.5)), InternalError);
  CHECK_THROWS_AS((void)latex(s("x") * GiNaC::I), InternalError);
  CHECK_THROWS_AS((void)latex(pow(s("a"), s("x"))), InternalError);
  CHECK_THROWS_AS((void)latex(s("a") == s("x")), InternalError);
}
