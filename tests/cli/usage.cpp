// What the program says to arguments it does not understand, and to those it does.
#include <doctest/doctest.h>

#include "cli/arguments/typed_parameters.hpp"
#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;

TEST_CASE("friction at rest that does not exceed sliding friction is refused alike by every command") {
  const Words data{"--chi", "0.3", "--eta", "4", "--us", "0.1", "--V", "0.1", "--omega", "0.6"};
  const TemporaryDirectory directory;
  for (const std::string ur : {"0.1", "0.05"}) {
    const std::string sentence = "ur = " + ur + " is outside the allowed range: ur > us = 0.1";
    std::vector<Refusal> refusals;
    for (const Words& command : {Words{"simulate", "--p", "1", "--phi", "0", "--state", "0,0,0,0"},
                                 {"attractors", "--p", "1"},
                                 {"attractors", "--p", "1", "--plane", "x1,x2"},
                                 {"orbits", "nonsticking", "--p", "1"},
                                 {"orbits", "OTS", "--p", "1"},
                                 {"orbits", "S", "--p", "1"},
                                 {"branch", "nonsticking", "--p", "0.9..1"},
                                 {"branch", "OTS", "--p", "0.9..1"},
                                 {"atlas", "nonsticking", "--p", "0.9..1", "--out", directory / "a.h5"}}) {
      refusals.push_back({with(with(command, data), {"--ur", ur}), exit_domain, sentence});
    }
    check_refused(refusals);
  }
}

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

TEST_CASE("a command line that is not understood is answered in the program's own words") {
  check_refused({
      {{"orbits", "ost"}, exit_usage, "a word of phases is written in capitals: OST"},
      {{"branch", "ots"}, exit_usage, "a word of phases is written in capitals: OTS"},
      {{"orbits", "OTS", "--example", "O", "--omega", "0,62"}, exit_usage, "a decimal has a point, 0.62"},
      {{"audit", "--frob"}, exit_usage, "there is no option --frob of stickslip audit; see stickslip audit"},
      {{"orbits", "symmetric", "--exmple", "S"}, exit_usage, "there is no option --exmple of"},
      {{"audit", "extra"}, exit_usage, "stickslip audit does not know what to do with 'extra'"},
      {{"audit", "--out"}, exit_usage, "--out needs a value: --out DIR"},
      {{"orbits", "--chi"}, exit_usage, "--chi needs a value: --chi NUMBER"},
      {{"attractors", "--along", "ur"}, exit_usage, "--along needs a value: --along NAME A..B"},
      {{"orbits", "symmetric", "--chi", "0.1", "--chi", "0.2"}, exit_usage, "--chi is given twice"},
      {{"check", "--list", "--json"}, exit_usage, "--list and --json do not go together"},
      {{"simulate", "--state", "0,0,0,0", "--orbit", "symmetric:1"}, exit_usage, "do not go together"},
      {{"audit", "--one-in", "5"}, exit_usage, "--one-in is for --mutants: give --mutants, too"},
      {{"audit", "--mutants", "--one-in", "x"}, exit_usage, "one-in: 'x' is not a whole number from 1 to"},
      {{"certify"}, exit_usage, "stickslip certify needs --out DIR, or --record DIR"},
      {{"latex", "--in", "tau"}, exit_usage, "in: 'tau' is neither chi nor omega"},
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

TEST_CASE("manual pages have examples, and the keys of a parameter file") {
  const TemporaryDirectory temporary;
  CHECK(stickslip_program({"--manual", temporary.path()}).code == exit_decided);
  for (const char * command :
       {"audit", "check", "certify", "latex", "orbits", "branch", "attractors", "atlas", "simulate"}) {
    CAPTURE(command);
    const std::string page = content(temporary.path() / (std::string("stickslip-") + command + ".1"));
    const std::size_t examples = page.find(".SH EXAMPLES\n");
    REQUIRE(examples != std::string::npos);
    CHECK(page.find(std::string("stickslip ") + command, examples) != std::string::npos);
    const bool has_file = page.find("\\-\\-params") != std::string::npos;
    for (const auto& key : cli::names_in_SI) {
      CHECK((page.find(std::string("\\fB") + key + "\\fR\n") != std::string::npos) == has_file);
    }
  }
}
