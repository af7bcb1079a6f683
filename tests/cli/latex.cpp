// What `stickslip latex` prints is the same on every run.
#include <doctest/doctest.h>

#include "core/error.hpp"
#include "tests/cli/program.hpp"

using namespace stickslip;

TEST_CASE("ten runs print the same characters") {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"latex", "H"}, {"latex"}, {"latex", "--in", "omega"}}) {
    const std::string first = stickslip_program(arguments).out;
    CHECK(first.find("\\cos") != std::string::npos);
    for (int i = 1; i < 10; ++i) {
      CHECK(stickslip_program(arguments).out == first);
    }
  }
}

TEST_CASE("names are printed in the order asked for") {
  const std::string text = stickslip_program({"latex", "Q", "K"}).out;
  CHECK(text.find("Q = ") < text.find("K = "));
  CHECK(text.find("\nQ = ") != std::string::npos);
}

TEST_CASE("a statement is printed in the form that is proved, and what is refuted is not") {
  const Run both = stickslip_program({"latex", "47.c", "rho", "--in", "omega"});
  CHECK(both.code == exit_decided);
  CHECK(both.out.starts_with("% (47.c) misprint"));
  CHECK(both.out.find("\\tilde H_{13} + \\Gamma_{13}") != std::string::npos);
  CHECK(both.out.find("\\rho_1 = ") != std::string::npos);
  CHECK(both.out.find("\\lambda_1 = ") != std::string::npos);
  CHECK(stickslip_program({"latex", "7.only"}).out == "% (7.only) refuted\n");
  const Run unknown = stickslip_program({"latex", "H", "frob"});
  CHECK(unknown.code == exit_usage);
  CHECK(is_one_sentence(unknown.err, "frob"));
  CHECK(unknown.out.empty());
}

TEST_CASE("the errata name the misprint of (45) and the hypothesis of (7)") {
  const Run errata = stickslip_program({"latex", "--errata"});
  CHECK(errata.code == exit_decided);
  CHECK(errata.out.find("\\textbf{(45)}") != std::string::npos);
  CHECK(errata.out.find("\\omega-\\omega_1 \\neq 0") != std::string::npos);
}
