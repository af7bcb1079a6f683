// What a person at a terminal sees, and a pipe does not: colour and progress.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

#include "core/error.hpp"
#include "tests/cli/program.hpp"

using namespace stickslip;

namespace {

// Both streams of the program, run on a terminal of its own by script(1) of bsdutils.
std::string on_terminal(const std::string& arguments) {
  const Run result =
      run("/usr/bin/script", {"-qec", std::string(STICKSLIP_PROGRAM) + " " + arguments, "/dev/null"});
  CHECK(result.code == exit_decided);
  return result.out;
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("colour on a terminal, unless NO_COLOR is set") {
  ::setenv("TERM", "xterm", 1);
  CHECK(mentions(on_terminal("check 40"), "\x1b[32mas printed"));
  ::setenv("NO_COLOR", "1", 1);
  const std::string plain = on_terminal("check 40");
  ::unsetenv("NO_COLOR");
  CHECK(mentions(plain, "as printed"));
  CHECK_FALSE(mentions(plain, "\x1b[32m"));
}

TEST_CASE("tables are as wide as the terminal, and eighty columns elsewhere") {
  ::setenv("NO_COLOR", "1", 1);
  const auto widest = [](const std::string& text) {
    std::size_t most = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      most = std::max(most, line.size() - (line.ends_with('\r') ? 1 : 0));
    }
    return most;
  };
  const auto at = [&](const char * columns) {
    const Run result = run(
        "/usr/bin/script",
        {"-qec", std::string("stty cols ") + columns + "; " + STICKSLIP_PROGRAM + " check 40 41 --explain",
         "/dev/null"});
    return widest(result.out);
  };
  const std::size_t narrow = at("60"), wide = at("120");
  const std::size_t piped = widest(stickslip_program({"check", "40", "41", "--explain"}).out);
  ::unsetenv("NO_COLOR");
  CHECK(narrow <= 60);
  CHECK(wide > 80);
  CHECK(wide <= 120);
  CHECK(piped > 60);
  CHECK(piped <= 80);
}

TEST_CASE("what takes over a second says how far it is, on a terminal only") {
  const std::string shown = on_terminal("check A4 A5 --jobs 1");
  CHECK(mentions(shown, "proving "));
  CHECK(shown.ends_with(".\r\n"));
  const Run piped = stickslip_program({"check", "A4", "A5", "--jobs", "1"});
  CHECK(piped.err.empty());
}
