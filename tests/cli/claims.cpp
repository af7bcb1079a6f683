// Papers as text, as their users meet them.
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "tests/cli/program.hpp"

using namespace stickslip;

namespace {

namespace fs = std::filesystem;

// A file of claims, gone at the end.
class ClaimsFile {
 public:
  explicit ClaimsFile(const std::string& entries)
      : path_(fs::temp_directory_path() / ("stickslip-" + std::to_string(::getpid()) + ".claims")) {
    std::ofstream(path_) << "paper A note\n  author A. Reader\nsymbols a, b, us\n" << entries;
  }
  ~ClaimsFile() { fs::remove(path_); }
  ClaimsFile(const ClaimsFile&) = delete;
  ClaimsFile& operator=(const ClaimsFile&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("a paper of one's own is audited, with pages") {
  const ClaimsFile file("claim square identity: the square\n  (a + b)^2 = a^2 + 2 a b + b^2\n");
  const Run checked = stickslip_program({"check", file.path()});
  CHECK(checked.code == exit_decided);
  CHECK(checked.out == "square  as printed  the square\n1 statement of the paper: 1 as printed.\n");
  CHECK(stickslip_program({"check", file.path(), "square", "--explain"}).out.find("a, b") !=
        std::string::npos);
  check_refused({{{"check", file.path(), "40"}, exit_usage, "there is no claim '40'"}});
  const fs::path pages = fs::temp_directory_path() / ("stickslip-" + std::to_string(::getpid()));
  const Run audited = stickslip_program({"audit", file.path(), "--out", pages.string()});
  CHECK(audited.code == exit_decided);
  const std::string index = content(pages / "index.html");
  CHECK(index.find("A note") != std::string::npos);
  CHECK(index.find("Pascal") == std::string::npos);
  const std::string older = pages / "audit.json";
  const Run again = stickslip_program({"audit", file.path(), "--compare", older});
  CHECK(again.code == exit_decided);
  CHECK(again.out.find("0 differ, 0 are gone, 0 are new") != std::string::npos);
  const ClaimsFile other("claim square identity: the square\n  (a + b)^2 = a^2 + 3 a b + b^2\n");
  const Run differs = stickslip_program({"audit", other.path(), "--compare", older});
  CHECK(differs.code == exit_refuted);
  CHECK(differs.out.find("square: status\n  before  as_printed\n  now     refuted\n") != std::string::npos);
  check_refused(
      {{{"audit", file.path(), "--compare", "/nowhere/audit.json"}, exit_io, "/nowhere/audit.json"},
       {{"audit", file.path(), "--compare", file.path()}, exit_usage, "is not the JSON of an audit"},
       {{"audit", file.path(), "--compare", older, "--json"}, exit_usage, "--json"}});
  fs::remove_all(pages);
}

TEST_CASE("statements are named by what is found of them, too") {
  const ClaimsFile file(
      "claim square identity: the square\n  (a + b)^2 = a^2 + 2 a b + b^2\n"
      "claim wrong identity: not the square\n  (a + b)^2 = a^2 + b^2\n");
  const Run printed = stickslip_program({"check", file.path(), "as_printed"});
  CHECK(printed.code == exit_decided);
  CHECK(printed.out == "square  as printed  the square\n1 claim of the paper: 1 as printed.\n");
  const Run refuted = stickslip_program({"check", file.path(), "refuted"});
  CHECK(refuted.code == exit_refuted);
  CHECK(refuted.out.starts_with("wrong"));
  CHECK(refuted.out.find("square  as printed") == std::string::npos);
}

TEST_CASE("statements of a file are printed as LaTeX") {
  const ClaimsFile file("claim square identity: the square\n  (a + b)^2 = a^2 + 2 a b + us^2*b^2/us^2\n");
  const Run run = stickslip_program({"latex", file.path(), "square", "--bare"});
  CHECK(run.code == exit_decided);
  CHECK(run.out == "\\left(a + b\\right)^{2} = a^{2} + 2 a b + \\frac{u_s^{2} b^{2}}{u_s^{2}}\n");
}

TEST_CASE("a name of the oscillator's is but a letter in another paper") {
  const ClaimsFile file("claim positive step: positive\n  us > 0\n");
  CHECK(stickslip_program({"check", file.path()}).code == exit_refuted);
}

TEST_CASE("a status that is not as expected is said, and is the exit code") {
  const ClaimsFile file(
      "claim square identity: the square\n  (a + b)^2 = a^2 + 2 a b + b^2\n  expect refuted\n");
  const Run run = stickslip_program({"check", file.path()});
  CHECK(run.code == exit_refuted);
  CHECK(run.err == "stickslip: square is as_printed, and not refuted as expected.\n");
}

TEST_CASE("what is wrong in a file is pointed at") {
  const ClaimsFile file("claim square identity: the square\n  (a + c)^2 = 1\n");
  const Run run = stickslip_program({"audit", file.path()});
  CHECK(run.code == exit_usage);
  CHECK(run.err.find(".claims:5: column 6: no symbol 'c'; there are a, b, t.\n  (a + c)^2 = 1\n       ^\n") !=
        std::string::npos);
  check_refused({{{"audit", "/nowhere/x.claims"}, exit_io, "/nowhere/x.claims"},
                 {{"audit", "x.toml"}, exit_usage, "x.toml"}});
}
