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

TEST_CASE("the errata are by place, formulas and numbers alone, without the ids of claims") {
  const Run errata = stickslip_program({"latex", "--errata"});
  CHECK(errata.code == exit_decided);
  for (const char * part : {"\\entry{(45)}", "\\entry{(47), $c_1$}", "should read", "$7.747$"}) {
    CAPTURE(part);
    CHECK(errata.out.find(part) != std::string::npos);
  }
  CHECK(errata.out.find("\\omega-\\omega_1 \\neq 0") != std::string::npos);
  for (const char * id : {"(16.back)", "(A5.longer)", "37.sharp", "S.tau", "does not matter"}) {
    CAPTURE(id);
    CHECK(errata.out.find(id) == std::string::npos);
  }
}

TEST_CASE("a result is printed as a theorem, an unknown one names those that there are") {
  const Run uniqueness = stickslip_program({"latex", "--theorem", "uniqueness"});
  CHECK(uniqueness.code == exit_decided);
  CHECK(uniqueness.out.find("\\begin{theorem}") != std::string::npos);
  CHECK(uniqueness.out.find("u_s > 0") != std::string::npos);
  CHECK(uniqueness.out.find("X(t) = Y(t)") != std::string::npos);
  CHECK(uniqueness.out.find("<<") == std::string::npos);
  const Run unknown = stickslip_program({"latex", "--theorem", "flat-earth"});
  CHECK(unknown.code == exit_usage);
  CHECK(unknown.out.empty());
  CHECK(unknown.err.find("uniqueness") != std::string::npos);
}
