// What `stickslip latex` prints is the same on every run and compiles.
#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;

namespace {

// What pdflatex says to the file, which stands in the directory; its output goes there too.
Run pdflatex(const std::filesystem::path& directory, const std::string& file) {
  return run(STICKSLIP_PDFLATEX, {"-interaction=nonstopmode", "-halt-on-error",
                                  "-output-directory=" + directory.string(), (directory / file).string()});
}

// The lines that complain of what sticks out into the margin.
std::string overfull(const std::string& log) {
  std::istringstream stream(log);
  std::string found;
  for (std::string line; std::getline(stream, line);) {
    found += line.starts_with("Overfull") ? line + "\n" : "";
  }
  return found;
}

}  // namespace

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

TEST_CASE("every derived expression compiles without edits and fits the page" * doctest::test_suite("full") *
          doctest::timeout(300)) {
  for (const char * form : {"chi", "omega"}) {
    const TemporaryDirectory temporary;
    std::ofstream(temporary.path() / "all.tex")
        << "\\documentclass[a4paper]{article}\n\\usepackage{amsmath}\n\\begin{document}\n"
        << stickslip_program({"latex", "--in", form}).out << "\\end{document}\n";
    const Run result = pdflatex(temporary.path(), "all.tex");
    CAPTURE(result.out);
    CHECK(result.code == 0);
    CHECK(overfull(result.out).empty());
  }
}

TEST_CASE("the article of the audit compiles and fits the page" * doctest::test_suite("full") *
          doctest::timeout(300)) {
  const TemporaryDirectory temporary;
  const Run audit = stickslip_program({"audit", "--out", temporary.path()});
  REQUIRE(audit.code != exit_io);
  const Run result = pdflatex(temporary.path(), "audit.tex");
  CAPTURE(result.out);
  CHECK(result.code == 0);
  CHECK(overfull(result.out).empty());
}

TEST_CASE("the errata name the misprint of (45) and the hypothesis of (7)") {
  const Run errata = stickslip_program({"latex", "--errata"});
  CHECK(errata.code == exit_decided);
  CHECK(errata.out.find("\\textbf{(45)}") != std::string::npos);
  CHECK(errata.out.find("\\omega-\\omega_1 \\neq 0") != std::string::npos);
}

TEST_CASE("the errata compile and fit the page" * doctest::test_suite("full") * doctest::timeout(300)) {
  const Run errata = stickslip_program({"latex", "--errata"});
  const TemporaryDirectory temporary;
  std::ofstream(temporary.path() / "errata.tex") << errata.out;
  const Run result = pdflatex(temporary.path(), "errata.tex");
  CAPTURE(result.out);
  CHECK(result.code == 0);
  CHECK(overfull(result.out).empty());
}
