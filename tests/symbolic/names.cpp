#include "symbolic/names.hpp"

#include <doctest/doctest.h>

using namespace stickslip::symbolic;

TEST_CASE("plain names become the paper's symbols") {
  CHECK(latex_name("omega1") == "\\omega_1");
  CHECK(latex_name("omega") == "\\omega");
  CHECK(latex_name("phi") == "\\varphi");
  CHECK(latex_name("phiB") == "\\varphi_B");
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
  CHECK(compare_names("pi", "chi") < 0);
  CHECK(compare_names("chi", "p") < 0);
  CHECK(compare_names("lambda2", "omega1") < 0);
  CHECK(compare_names("q1", "omega") < 0);
  CHECK(compare_names("omega", "omega1") < 0);
  CHECK(compare_names("omega2", "omega10") < 0);
  CHECK(compare_names("z20", "zdot10") < 0);
  CHECK(compare_names("t", "omega1") > 0);
  CHECK(compare_names("lambda1", "unheardof") < 0);
  CHECK(compare_names("unheardof", "us") < 0);
  CHECK(compare_names("chi", "chi") == 0);
}
