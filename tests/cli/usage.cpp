// What the program says to arguments it does not understand, and to those it does.
#include <doctest/doctest.h>

#include "core/error.hpp"
#include "tests/cli/program.hpp"

using namespace stickslip;

namespace {

struct Misuse {
  std::vector<std::string> arguments;
  std::string named;  // what the sentence has to name
};

}  // namespace

TEST_CASE("what is not understood is named in one sentence") {
  const std::vector<Misuse> misuses = {
      {{}, "a command is missing"},
      {{"frobnicate"}, "frobnicate"},
      {{"--frob"}, "--frob"},
      {{""}, "command"},
      {{"audit", "--frob"}, "--frob"},
      {{"audit", "extra"}, "extra"},
      {{"audit", "--out"}, "--out"},
      {{"check", "nonsense"}, "nonsense"},
      {{"check", "99.x"}, "99.x"},
      {{"check", "--frob"}, "--frob"},
      {{"check", "--list", "--json"}, "--json"},
      {{"check", "--list", "refuted"}, "refuted"},
      {{"latex", "Nonsense"}, "Nonsense"},
      {{"latex", "H", "Nonsense"}, "Nonsense"},
      {{"latex", "--in", "tau"}, "tau"},
  };
  for (const Misuse& misuse : misuses) {
    const Run result = stickslip_program(misuse.arguments);
    CAPTURE(misuse.named);
    CAPTURE(result.err);
    CHECK(result.code == exit_usage);
    CHECK(is_one_sentence(result.err, misuse.named));
    CHECK(result.out.empty());
  }
}

TEST_CASE("help and versions are answers, on standard output") {
  const std::vector<std::vector<std::string>> questions = {
      {"--help"}, {"-h"}, {"--version"}, {"audit", "--help"}, {"check", "--help"}, {"latex", "--help"}};
  for (const std::vector<std::string>& question : questions) {
    const Run result = stickslip_program(question);
    CAPTURE(question.front());
    CHECK(result.code == exit_decided);
    CHECK(result.err.empty());
    CHECK(result.out.size() > 50);
  }
  CHECK(stickslip_program({"--version"}).out.find("GiNaC") != std::string::npos);
}

TEST_CASE("lists cost nothing and name everything once") {
  const Run claims = stickslip_program({"check", "--list"});
  CHECK(claims.code == exit_decided);
  CHECK(claims.out.find("identity") != std::string::npos);
  const Run objects = stickslip_program({"latex", "--list"});
  CHECK(objects.code == exit_decided);
  CHECK(objects.out.find("Gamma2") != std::string::npos);
}
