#include "symbolic/typeset/names.hpp"

#include <doctest/doctest.h>

using namespace stickslip::symbolic::typeset;

namespace {

bool precedes(const char * a, const char * b) {
  return std::is_lt(compare_names(a, b)) && std::is_gt(compare_names(b, a));
}

}  // namespace

TEST_CASE("plain names become the paper's symbols") {
  CHECK(latex_name("omega1") == "\\omega_1");
  CHECK(latex_name("omega") == "\\omega");
  CHECK(latex_name("phi") == "\\varphi");
  CHECK(latex_name("phiB") == "\\varphi_B");
  CHECK(latex_name("z2C") == "z_{2C}");
  CHECK(latex_name("zdot2B") == "\\dot z_{2B}");
  CHECK(latex_name("phi_B") == "\\varphi_B");
  CHECK(latex_name("Theta") == "\\Theta");
  CHECK(latex_name("us") == "u_s");
  CHECK(latex_name("z10") == "z_{10}");
  CHECK(latex_name("zdot10") == "\\dot z_{10}");
  CHECK(latex_name("Htilde11") == "\\tilde H_{11}");
  CHECK(latex_name("psidot") == "\\dot\\psi");
  CHECK(latex_name("zB1") == "z_{B1}");
  CHECK(latex_name("eta") == "\\eta");
  CHECK(latex_name("stiff_1%") == "\\mathrm{stiff\\_1\\%}");
}

TEST_CASE("symbols have their place in a product") {
  CHECK(precedes("pi", "chi"));
  CHECK(precedes("chi", "p"));
  CHECK(precedes("lambda2", "omega1"));
  CHECK(precedes("q1", "omega"));
  CHECK(precedes("omega", "omega1"));
  CHECK(precedes("omega2", "omega10"));
  CHECK(precedes("z20", "zdot10"));
  CHECK(precedes("omega1", "t"));
  CHECK(precedes("lambda1", "unheardof"));
  CHECK(precedes("unheardof", "us"));
  CHECK(std::is_eq(compare_names("chi", "chi")));
}
