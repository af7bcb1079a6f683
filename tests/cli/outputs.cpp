// Where results go, and what happens when they cannot go there.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;

namespace {

using Json = nlohmann::json;

// The exit code that `check` owes for these results.
int code_of_check(const Json& audit) {
  bool refuted = false;
  for (const Json& place : audit.at("places")) {
    for (const Json& claim : place.at("claims")) {
      refuted = refuted || claim.at("status") == "refuted" || claim.at("status") == "digits_off";
    }
  }
  return refuted                                         ? exit_refuted
         : audit.at("summary").at("decided").get<bool>() ? exit_decided
                                                         : exit_undecided;
}

}  // namespace

TEST_CASE("a place for the report that does not exist is named, and nothing is written") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "file";
  std::ofstream(file) << "content";
  const Words places = {temporary.path() / "missing" / "out", file, file + "/out", "/proc/stickslip", ""};
  for (const std::string& place : places) {
    const Run result = stickslip_program({"audit", "--out", place});
    CAPTURE(result.err);
    CHECK(result.code == exit_io);
    CHECK(is_one_sentence(result.err, place));
    CHECK(result.out.empty());
  }
  CHECK(content(file) == "content");
  CHECK(temporary.count() == 1);
}

TEST_CASE("standard output that is full or closed is an error") {
  for (const Words& arguments :
       {Words{"latex"}, {"latex", "--list"}, {"check", "--list"}, {"--help"}, {"--version"}}) {
    const Run full = run_into(STICKSLIP_PROGRAM, arguments, "/dev/full");
    CHECK(full.code == exit_io);
    CHECK(is_one_sentence(full.err, "standard output"));
    const Run closed = run_into(STICKSLIP_PROGRAM, arguments, "");
    CHECK(closed.code == exit_io);
    CHECK(is_one_sentence(closed.err, "standard output"));
  }
}

TEST_CASE("a reader that has gone is no reason for noise") {
  int ends[2];
  REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
  ::close(ends[0]);
  const int process = start({"latex"}, ends[1]);
  ::close(ends[1]);
  CHECK(wait_for(process) == exit_io);
}

TEST_CASE("an interruption ends the program with its own exit code") {
  // The program writes more than the pipe holds, and nobody reads: it waits.
  int ends[2];
  REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
  const int capacity = ::fcntl(ends[1], F_SETPIPE_SZ, 4096);
  REQUIRE(capacity > 0);
  const int process = start({"latex"}, ends[1]);
  for (int waiting = 0, held = 0; held < capacity && waiting < 2000; ++waiting) {
    ::usleep(10000);
    REQUIRE(::ioctl(ends[0], FIONREAD, &held) == 0);
  }
  ::kill(process, SIGINT);
  CHECK(wait_for(process) == exit_interrupted);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST_CASE("statements are named by kind as well") {
  const Run theorems = stickslip_program({"check", "--list", "theorem"});
  CHECK(theorems.code == exit_decided);
  CHECK(theorems.out.find("A5.theorem") != std::string::npos);
  CHECK(theorems.out.find("44.H") == std::string::npos);
}

TEST_CASE("claims are named by whose they are") {
  const Run ours = stickslip_program({"check", "--list", "new"});
  CHECK(ours.code == exit_decided);
  CHECK(ours.out.find("A5.unique") != std::string::npos);
  CHECK(ours.out.find("S.stability") != std::string::npos);
  CHECK(ours.out.find("A5.theorem") == std::string::npos);
  const Run converses = stickslip_program({"check", "converse"});
  CHECK(converses.code == exit_decided);
  CHECK(converses.out.find("12.back") != std::string::npos);
  CHECK(converses.out.find("as printed") == std::string::npos);
}

TEST_CASE("check answers by its exit code, whatever the form of its output") {
  for (const Words& asked : {Words{"check", "A1"}, {"check", "4", "44"}}) {
    const Run json = stickslip_program(with(asked, {"--json"}));
    const int expected = code_of_check(Json::parse(json.out));
    CHECK(expected == (asked.size() > 2 ? exit_refuted : exit_decided));
    CHECK(json.code == expected);
    const Run lines = stickslip_program(asked);
    CHECK(lines.code == expected);
    const auto claims = Json::parse(json.out).at("summary").at("claims").get<std::ptrdiff_t>();
    CHECK(std::count(lines.out.begin(), lines.out.end(), '\n') == claims + 1);
    CHECK(lines.out.find('\x1b') == std::string::npos);
  }
}
