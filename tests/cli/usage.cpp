// What the program says to arguments it does not understand, and to those it does.
#include <doctest/doctest.h>

#include "core/error.hpp"
#include "tests/cli/program.hpp"

using namespace stickslip;

TEST_CASE("what is not understood is named in one sentence") {
  check_refused({
      {{}, exit_usage, "orbits, branch, attractors, atlas and simulate"},
      {{"frobnicate"}, exit_usage, "frobnicate"},
      {{"--frob"}, exit_usage, "--frob"},
      {{""}, exit_usage, "command"},
      {{"audit", "--frob"}, exit_usage, "--frob"},
      {{"audit", "extra"}, exit_usage, "extra"},
      {{"audit", "--out"}, exit_usage, "--out"},
      {{"check", "nonsense"}, exit_usage, "nonsense"},
      {{"check", "99.x"}, exit_usage, "99.x"},
      {{"check", "--frob"}, exit_usage, "--frob"},
      {{"check", "--list", "--json"}, exit_usage, "--json"},
      {{"check", "--list", "refuted"}, exit_usage, "refuted"},
      {{"latex", "Nonsense"}, exit_usage, "Nonsense"},
      {{"latex", "H", "Nonsense"}, exit_usage, "Nonsense"},
      {{"latex", "--in", "tau"}, exit_usage, "tau"},
  });
}

TEST_CASE("help and versions are answers, on standard output") {
  const std::vector<Words> questions = {
      {"--help"}, {"-h"}, {"--version"}, {"audit", "--help"}, {"check", "--help"}, {"latex", "--help"}};
  for (const Words& question : questions) {
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
