// What `stickslip latex` prints is the same on every run.
#include <doctest/doctest.h>

#include "core/error.hpp"
#include "tests/cli/program.hpp"

using namespace stickslip;

TEST_CASE("every run prints the same characters") {
  const auto runs = [](const Words& arguments, int count) {
    const std::string first = stickslip_program(arguments).out;
    CHECK(first.find("\\cos") != std::string::npos);
    for (int i = 1; i < count; ++i) {
      CHECK(stickslip_program(arguments).out == first);
    }
  };
  runs({"latex", "H"}, 10);
  // All there is, which takes a second or two each.
  runs({"latex"}, 3);
  runs({"latex", "--in", "omega"}, 3);
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
  CHECK(stickslip_program({"latex", "7.only.half"}).out == "% (7.only.half) refuted\n");
  const Run unknown = stickslip_program({"latex", "H", "frob"});
  CHECK(unknown.code == exit_usage);
  CHECK(is_one_sentence(unknown.err, "frob"));
  CHECK(unknown.out.empty());
}

TEST_CASE("a result is printed as a theorem, an unknown one names those that there are") {
  const Run uniqueness = stickslip_program({"latex", "--theorem", "uniqueness"});
  CHECK(uniqueness.code == exit_decided);
  CHECK(uniqueness.out.find("\\begin{theorem}") != std::string::npos);
  CHECK(uniqueness.out.find("u_s > 0") != std::string::npos);
  CHECK(uniqueness.out.find("X(t) = Y(t)") != std::string::npos);
  CHECK(uniqueness.out.find("<<") == std::string::npos);
  // It stands alone: what a motion is, the equations, the frequencies; a command in a comment may be copied.
  for (const char * part : {"\\label{thm:uniqueness}", "A motion is", "x_1'' + x_1 - \\chi x_2 = 0",
                            "\\omega_1 < \\omega_2", " --explain\n"}) {
    CAPTURE(part);
    CHECK(uniqueness.out.find(part) != std::string::npos);
  }
  const std::string lists = stickslip_program({"latex", "--theorem", "lists"}).out;
  for (const char * part : {"\\item", "4 orbits, all of them admissible", "$\\tau = 7.74669 \\dots$"}) {
    CAPTURE(part);
    CHECK(lists.find(part) != std::string::npos);
  }
  const std::string resonance = stickslip_program({"latex", "--theorem", "resonance"}).out;
  CHECK(resonance.find("\\chi = 3519 / 11800") != std::string::npos);
  const Run unknown = stickslip_program({"latex", "--theorem", "flat-earth"});
  CHECK(unknown.code == exit_usage);
  CHECK(unknown.out.empty());
  CHECK(unknown.err.find("uniqueness") != std::string::npos);
}

TEST_CASE("an expression has a heading with the number of its equation") {
  CHECK(stickslip_program({"latex", "H1"})
            .out.starts_with("\\paragraph{First block of $H$ (38)}\n\\begin{gather*}"));
  CHECK(stickslip_program({"latex", "44.H"}).out.find(" (44.H)}\n\\begin{gather*}") != std::string::npos);
  CHECK(stickslip_program({"latex", "--list"}).out.find("first block of H\n") != std::string::npos);
}

TEST_CASE("an expression is printed with its values at parameters of one's own") {
  const std::string general = stickslip_program({"latex", "H2"}).out;
  const Run own = stickslip_program({"latex", "H2", "--chi", "0.3", "--eta", "4", "--digits", "6"});
  CHECK(own.code == exit_decided);
  CHECK(own.out.starts_with(general));
  CHECK(own.out.find("At $\\chi = 0.3$, $\\eta = 4$, $\\omega_1 = 0.701230$") != std::string::npos);
  const Run of_example = stickslip_program({"latex", "Q", "--example", "P", "--omega", "0.5"});
  CHECK(of_example.out.find("$\\omega = 0.5$, $p = 1$") != std::string::npos);
  check_refused({
      {{"latex", "H2", "Q", "d0", "--chi", "0.3"}, exit_usage, "missing: --eta, --us, --omega, --p"},
      {{"latex", "H2", "--chi", "0.3", "--eta", "4+-1e-3"}, exit_usage, "interval"},
      {{"latex", "H2", "--chi", "1.3", "--eta", "4"}, exit_domain, "0 < chi < 1"},
      {{"latex", "44.H", "--chi", "0.3"}, exit_usage, "44.H is a statement"},
      {{"latex", "H2", "44.H", "--chi", "0.3", "--eta", "4"}, exit_usage, "44.H is a statement"},
  });
}

TEST_CASE("an orbit is printed phase by phase, with numbers that are those of the list") {
  const Words orbit{"latex", "--orbit", "overshooting:2", "--example", "O"};
  const Run printed = stickslip_program(orbit);
  CHECK(printed.code == exit_decided);
  CHECK(printed.err.empty());
  // By hand: x_i(0) is the sum of the constant and of the cosines, and x_2'(0) = V.
  for (const char * part :
       {"$\\tau = 4.909122803$", "\\paragraph{Slip, $0 \\le t \\le \\tau$.} With $s = t$,",
        "\\paragraph{Stick, $\\tau + \\tau_1 \\le t \\le \\Theta$.}", "x_2 ={}& 1.447798361 + s\n",
        "Proved to exist, and admissible; stability: stable."}) {
    CAPTURE(part);
    CHECK(printed.out.find(part) != std::string::npos);
  }
  CHECK(stickslip_program(with(orbit, {"--digits", "40"})).out.find("4.90912280332345146") !=
        std::string::npos);
  check_refused({
      {{"latex", "--orbit", "overshooting:3", "--example", "O"},
       exit_usage,
       "there is no orbit overshooting:3"},
      {{"latex", "--orbit", "symmetric:1", "--example", "S", "--p", "0.05+-1e-9"}, exit_usage, "interval"},
      {{"latex", "--orbit", "symmetric:1"}, exit_usage, "missing: --chi"},
      {{"latex", "--orbit", "symmetric:1", "H"}, exit_usage, "--orbit"},
      {{"latex", "--theorem", "uniqueness", "--chi", "0.5"}, exit_usage, "theorems and errata have none"},
      {{"latex", "H", "--digits", "5"}, exit_usage, "--digits is for values"},
      {{"latex", "--orbit", "symmetric:1", "--example", "S", "--digits", "0"}, exit_usage, "digits: '0'"},
  });
}

TEST_CASE("formulas alone are lines for an environment of one's own") {
  const std::string H1 = stickslip_program({"latex", "H1", "--bare"}).out;
  CHECK(H1.starts_with("H_1(t) = "));
  CHECK(stickslip_program({"latex", "H1"}).out.find(H1) != std::string::npos);
  CHECK(stickslip_program({"latex", "44.H", "--bare"}).out == "H(\\tau - t) = H(\\tau) H(-t)\n");
  CHECK(stickslip_program({"latex", "H1", "44.H", "--bare"}).out ==
        H1.substr(0, H1.size() - 1) + " \\\\\n" + "H(\\tau - t) = H(\\tau) H(-t)\n");
  check_refused({{{"latex", "--bare"}, exit_usage, "--bare needs the name of an expression or a statement"},
                 {{"latex", "H", "--bare", "--chi", "0.3"}, exit_usage, "leave the parameters out"},
                 {{"latex", "--list", "--bare"}, exit_usage, "--list and --bare do not go together"},
                 {{"latex", "7.only.half", "--bare"}, exit_usage, "7.only.half is refuted"}});
}

TEST_CASE("a determinant is printed as one") {
  const std::string expression = stickslip_program({"latex", "cramer", "--bare"}).out;
  CHECK(expression.starts_with("\\Delta = \\begin{vmatrix}\na_1 & b_1 & c_1 \\\\\na_2 & b_2 & c_2 \\\\\n"));
  const std::string statement = stickslip_program({"latex", "22.Delta"}).out;
  CHECK(statement.find("\\Delta = \\begin{vmatrix} a_1 & b_1 & c_1 \\\\ a_2 & b_2 & c_2 \\\\ ") !=
        std::string::npos);
  CHECK(statement.find("pmatrix") == std::string::npos);
}
