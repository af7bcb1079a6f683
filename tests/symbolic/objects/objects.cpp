#include "symbolic/objects/objects.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "model/appendix3.hpp"
#include "symbolic/algebra/symbols.hpp"

using namespace stickslip;
using namespace stickslip::symbolic::objects;

TEST_CASE("every object has a name of its own, an equation number and a title") {
  std::set<std::string> names;
  for (const Object& object : objects()) {
    CHECK(names.insert(object.name).second);
    CHECK(object.number.starts_with("("));
    CHECK_FALSE(object.title.empty());
    CHECK(find_object(object.name) == &object);
  }
  for (const char * name : {"H", "H1", "H2", "H3", "L", "Gamma", "Q", "F", "d0", "slip", "overshoot", "stick",
                            "symmetric", "closing", "nonsticking", "phase", "load", "P", "rho"}) {
    CHECK_MESSAGE(names.contains(name), name);
  }
  CHECK(find_object("h") == nullptr);
}

TEST_CASE("a display is whole LaTeX") {
  for (const Object& object : objects()) {
    for (const Unknowns unknowns : {Unknowns::chi, Unknowns::omega}) {
      const std::string text = displayed(object, unknowns);
      CAPTURE(text);
      CHECK(std::ranges::count(text, '{') == std::ranges::count(text, '}'));
      const bool single = text.starts_with("\\[\n") && text.ends_with("\\]\n");
      CHECK((single || (text.starts_with("\\begin{gather*}\n") && text.ends_with("\\end{gather*}\n"))));
      CHECK(text == displayed(object, unknowns));
    }
  }
}

TEST_CASE("in the frequencies, chi, eta and lambda are gone or explained") {
  CHECK(displayed(*find_object("K"), Unknowns::omega).find("\\chi") == std::string::npos);
  CHECK(displayed(*find_object("H"), Unknowns::omega).find("\\lambda") == std::string::npos);
  CHECK(displayed(*find_object("Q"), Unknowns::omega).find("\\chi") == std::string::npos);
  CHECK(displayed(*find_object("slip"), Unknowns::omega).find("\\lambda_1 = ") != std::string::npos);
  CHECK(displayed(*find_object("stick"), Unknowns::omega).find("\\chi = ") != std::string::npos);
}

TEST_CASE("formulas of the paper, as a reader would write them") {
  CHECK(displayed(*find_object("Q"), Unknowns::chi) ==
        "\\[\nQ = \\frac{p}{(\\omega^{2}-\\omega_1^{2})(\\omega^{2}-\\omega_2^{2})}\\begin{pmatrix}\n"
        "\\chi \\\\\n1-\\omega^{2}\n\\end{pmatrix}\n\\]\n");
  const std::string H = displayed(*find_object("H"), Unknowns::chi);
  CHECK(H.find("H(t) = \\begin{pmatrix}\nH_1(t) & H_2(t) \\\\\nH_3(t) & H_1(t)\n\\end{pmatrix}") !=
        std::string::npos);
  // Gamma_13 = sin T, with + where the paper prints -.
  const std::string closing = displayed(*find_object("closing"), Unknowns::chi);
  const std::size_t c1 = closing.find("\nc_1 = ");
  REQUIRE(c1 != std::string::npos);
  CHECK(closing.substr(c1, closing.find('\n', c1 + 1) - c1).find("+\\sin T") != std::string::npos);
  CHECK(displayed(*find_object("rho"), Unknowns::chi)
            .find("\\rho_1 = \\frac{\\omega_1\\sin(\\omega_1(\\tau+\\tau_1)/2)}"
                  "{\\sin(\\omega_1\\tau/2)\\sin(\\omega_1\\tau_1/2)}") != std::string::npos);
  CHECK(H.find("\\lambda_2 c_1-\\lambda_1 c_2 & c_2-c_1") != std::string::npos);
}

TEST_CASE("the determinants that are printed are those of the model") {
  model::ClosingCoefficients<GiNaC::ex> k;
  for (std::size_t i = 0; i < 5; ++i) {
    const std::string number = std::to_string(i + 1);
    k.a[i] = symbolic::algebra::symbol("a" + number);
    k.b[i] = symbolic::algebra::symbol("b" + number);
    k.c[i] = symbolic::algebra::symbol("c" + number);
    k.d[i] = symbolic::algebra::symbol("d" + number);
  }
  const auto c = model::cramer<GiNaC::ex>(k);
  const std::vector<Line> lines = find_object("cramer")->lines(Unknowns::chi);
  REQUIRE(lines.size() == 4);
  CHECK((lines[0].entries.at(0) - c.Delta).expand().is_zero());
  CHECK((lines[1].entries.at(0) - c.Delta1).expand().is_zero());
  CHECK((lines[2].entries.at(0) - c.Delta2).expand().is_zero());
  CHECK((lines[3].entries.at(0) - c.Delta3).expand().is_zero());
}
