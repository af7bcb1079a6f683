// What needs LaTeX: what the program prints compiles, and an interruption of the compiler leaves nothing
// behind.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/error.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/table.hpp"
#include "symbolic/typeset/names.hpp"
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

TEST_CASE("every derived expression compiles without edits and fits the page" * doctest::timeout(300)) {
  for (const Words& form : {Words{"--in", "chi"},
                            {"--in", "omega"},
                            {"--example", "P"},
                            {"--example", "O", "--phi", "1/3", "--digits", "15"}}) {
    const TemporaryDirectory temporary;
    std::ofstream(temporary.path() / "all.tex")
        << "\\documentclass[a4paper]{article}\n\\usepackage{amsmath}\n\\begin{document}\n"
        << stickslip_program(with({"latex"}, form)).out << "\\end{document}\n";
    const Run result = pdflatex(temporary.path(), "all.tex");
    CAPTURE(result.out);
    CHECK(result.code == 0);
    CHECK(overfull(result.out).empty());
  }
}

TEST_CASE("the LaTeX of every symbol compiles" * doctest::timeout(300)) {
  const TemporaryDirectory temporary;
  {
    std::ofstream file(temporary.path() / "symbols.tex");
    file << "\\documentclass{article}\n\\usepackage{amsmath}\n\\begin{document}\n\\raggedright\n";
    for (const proofs::symbols::Symbol& symbol : proofs::symbols::symbol_table()) {
      file << "$" << symbolic::typeset::latex_name(symbol.name) << "$\n";
    }
    file << "\\end{document}\n";
  }
  const Run result = pdflatex(temporary.path(), "symbols.tex");
  CAPTURE(result.out);
  CHECK(result.code == 0);
}

TEST_CASE("orbits of every family compile and fit the page" * doctest::timeout(300)) {
  const TemporaryDirectory temporary;
  {
    std::ofstream file(temporary.path() / "orbits.tex");
    file << "\\documentclass[a4paper]{article}\n\\usepackage{amsmath}\n\\begin{document}\n";
    for (const Words& orbit : {Words{"overshooting:2", "--example", "O"},
                               {"overshooting:1", "--example", "O"},
                               {"symmetric:2", "--example", "S", "--p", "0"},
                               {"nonsticking:1", "--example", "P", "--digits", "15"}}) {
      const Run printed = stickslip_program(with({"latex", "--orbit"}, orbit));
      CHECK(printed.code == exit_decided);
      file << printed.out;
    }
    file << "\\end{document}\n";
  }
  const Run result = pdflatex(temporary.path(), "orbits.tex");
  CAPTURE(result.out);
  CHECK(result.code == 0);
  CHECK(overfull(result.out).empty());
}

TEST_CASE("statements compile with their headings" * doctest::timeout(300)) {
  const TemporaryDirectory temporary;
  std::ofstream(temporary.path() / "statements.tex")
      << "\\documentclass{article}\n\\usepackage[utf8]{inputenc}\n\\usepackage{amsmath}\n\\begin{document}\n"
      << stickslip_program({"latex", "sec2", "sec3", "A1", "A2", "A3"}).out << "\\end{document}\n";
  const Run result = pdflatex(temporary.path(), "statements.tex");
  CAPTURE(result.out);
  CHECK(result.code == 0);
}

TEST_CASE("every result compiles as a theorem, alone, in one column and in two, and nothing sticks out" *
          doctest::timeout(600) * doctest::test_suite("nightly") * doctest::skip()) {
  for (const proofs::methods::Result& result : proofs::pascal2012::paper().results) {
    const Run theorem = stickslip_program({"latex", "--theorem", result.id});
    REQUIRE(theorem.code == exit_decided);
    for (const char * columns : {"onecolumn", "twocolumn"}) {
      CAPTURE(result.id);
      CAPTURE(columns);
      const TemporaryDirectory temporary;
      std::ofstream(temporary.path() / "theorem.tex")
          << "\\documentclass[" << columns << "]{article}\n\\usepackage{amsmath,amsthm}\n"
          << "\\newtheorem{theorem}{Theorem}\n\\begin{document}\n"
          << theorem.out << "Theorem~\\ref{thm:" << result.id << "}.\n\\end{document}\n";
      Run compiled = pdflatex(temporary.path(), "theorem.tex");
      compiled = pdflatex(temporary.path(), "theorem.tex");
      CAPTURE(compiled.out);
      CHECK(compiled.code == 0);
      CHECK(overfull(compiled.out).empty());
      CHECK(compiled.out.find("undefined") == std::string::npos);
    }
  }
}

TEST_CASE("an interruption while LaTeX is compiled leaves no temporary directory") {
  const TemporaryDirectory temporary;
  const auto workshops = temporary.path() / "tmp";
  std::filesystem::create_directory(workshops);
  const int output = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::setenv("TMPDIR", workshops.c_str(), 1);
  const int process =
      start({"orbits", "symmetric", "--example", "S", "--out", temporary.path() / "out"}, output);
  ::unsetenv("TMPDIR");
  for (int waiting = 0; std::filesystem::is_empty(workshops) && waiting < 6000; ++waiting) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  REQUIRE_FALSE(std::filesystem::is_empty(workshops));
  ::kill(process, SIGINT);
  CHECK(wait_for(process) == exit_interrupted);
  ::close(output);
  CHECK(temporary.count() == 1);
}
