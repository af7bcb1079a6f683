// What the program does when the world around it fails.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;

namespace {

using Json = nlohmann::json;

// A search of several seconds: omega is a quarter of a natural frequency.
const Words long_search{"orbits", "overshooting", "--chi", "9/13", "--eta", "169/36",  "--us", "0.02", "--V",
                        "1",      "--p",          "0.05",  "--ur", "0.1",   "--omega", "0.25"};

// Runs the program where the shell has prepared the ground.
Run in_shell(const std::string& before, const Words& arguments) {
  Words words{"-c", before + "; exec \"$@\"", "sh", STICKSLIP_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run("/bin/sh", words);
}

}  // namespace

TEST_CASE("an interrupted search tells what it has found, and that it is not all") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "out";
  const int output = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  Words arguments = long_search;
  arguments.emplace_back("--json");
  const int process = start(arguments, output);
  std::this_thread::sleep_for(std::chrono::seconds(2));
  ::kill(process, SIGINT);
  CHECK(wait_for(process) == exit_interrupted);
  ::close(output);
  const Json list = Json::parse(content(file));
  CHECK_FALSE(list.at("complete").get<bool>());
  CHECK(list.at("remarks").dump().find("interrupted") != std::string::npos);
  CHECK(list.at("unresolved").dump().find("the search was interrupted") != std::string::npos);
}

namespace {

// What the program prints as JSON when it is interrupted after so many seconds.
Json interrupted_after(int seconds, const Words& arguments) {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "out";
  const int output = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const int process = start(arguments, output);
  std::this_thread::sleep_for(std::chrono::seconds(seconds));
  ::kill(process, SIGINT);
  CHECK(wait_for(process) == exit_interrupted);
  ::close(output);
  return Json::parse(content(file));
}

}  // namespace

namespace {

// Of the processor, used by a process so far, or by all children that have ended.
double seconds_of(int process) {
  std::istringstream fields(content("/proc/" + std::to_string(process) + "/stat"));
  std::string skipped;
  for (int k = 1; k < 14; ++k) {
    fields >> skipped;
  }
  long user = 0, system = 0;
  fields >> user >> system;
  return static_cast<double>(user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}
double seconds_of_children() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

}  // namespace

TEST_CASE("whatever is interrupted comes to its end within two seconds of processor time") {
#ifdef __SANITIZE_ADDRESS__
  constexpr double longest =
      60;  // what is followed is proved to its end, which takes up to forty times as long
#else
  constexpr double longest = 2;
#endif
  const Words overshooting{"branch", "overshooting", "--example", "O", "--ur", "0.4585", "--omega"};
  for (const Words& arguments :
       {Words{"attractors", "--example", "S", "--starts", "100000"},
        Words{"orbits", "STST", "--example", "S"}, long_search, with(overshooting, {"0.355..0.49"}),
        Words{"simulate", "--example", "S", "--periods", "100000000"}}) {
    CAPTURE(arguments.front());
    const TemporaryDirectory temporary;
    const int output = ::open((temporary.path() / "out").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    const double before = seconds_of_children();
    const int process = start(arguments, output);
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    const double until_then = seconds_of(process);
    ::kill(process, SIGINT);
    CHECK(wait_for(process) == exit_interrupted);
    ::close(output);
    CHECK(seconds_of_children() - before - until_then < longest);
  }
}

TEST_CASE("the shares of interrupted attractors are of the starts that were followed to their end") {
  const Json list = interrupted_after(2, {"attractors", "--example", "S", "--starts", "100000", "--json"});
  CHECK(list.at("interrupted") == true);
  CHECK(list.at("followed") < 100000);
  long count = 0;
  double shares = 0;
  for (const Json& one : list.at("attractors")) {
    count += one.at("count").get<long>();
    shares += one.at("share").get<double>();
  }
  CHECK(list.at("followed") == count);
  CHECK((count == 0 || std::abs(shares - 1) < 1e-9));
}

TEST_CASE(
    "an interrupted search for branches says where it is open once, however many boxes it has left there") {
  const Json list = interrupted_after(
      4, {"branch", "overshooting", "--example", "O", "--ur", "0.4585", "--omega", "0.355..0.49", "--json"});
  CHECK(list.at("interrupted") == true);
  CHECK(list.at("complete") == false);
  // Hundreds of boxes, on both sides of a resonance; beside them places where branches that are followed so
  // far may turn.
  const Json& open = list.at("unresolved");
  const auto interrupted = std::count_if(open.begin(), open.end(), [](const Json& part) {
    return part.at("reason") == "there may be orbits that are on no branch: the search was interrupted";
  });
  CHECK(interrupted >= 1);
  CHECK(interrupted <= 2);
}

TEST_CASE("a list of four phases has what simulations find before all is searched") {
  // Some minutes for all of it; the attractor of two thirds of the starts.
  const Words arguments{"orbits",   "OTST", "--json",   "--chi", "0.170243", "--eta",
                        "5.23063",  "--us", "0.339466", "--V",   "0.167912", "--omega",
                        "0.195101", "--p",  "4.61749",  "--ur",  "2.37177"};
  bool found = false;
  for (int seconds = 4; !found && seconds <= 64; seconds *= 2) {  // as the machine is slow
    const Json list = interrupted_after(seconds, arguments);
    CHECK(list.at("complete") == false);
    found = !list.at("orbits").empty() && list.at("orbits").at(0).at("stability") == "stable";
  }
  CHECK(found);
}

TEST_CASE("a device or a pipe is not replaced by a file") {
  const TemporaryDirectory temporary;
  for (const char * option : {"--csv", "--plot"}) {
    const std::string pipe = temporary.path() / (std::string(option) + ".svg");
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const Run result = stickslip_program({"simulate", "--example", "O", option, pipe});
    CHECK(result.code == exit_io);
    CHECK(is_one_sentence(result.err, pipe));
    CHECK(std::filesystem::is_fifo(pipe));
  }
  CHECK(temporary.count() == 2);
}

TEST_CASE("a disk that is full leaves nothing that could be taken for a result") {
  const TemporaryDirectory temporary;
  const std::string csv = temporary.path() / "a.csv";
  const std::string svg = temporary.path() / "a.svg";
  const std::string out = temporary.path() / "out";
  for (const Words& arguments : {Words{"simulate", "--example", "O", "--csv", csv},
                                 {"simulate", "--example", "O", "--plot", svg},
                                 {"orbits", "symmetric", "--example", "S", "--plot", svg},
                                 {"orbits", "symmetric", "--example", "S", "--out", out}}) {
    // Files, those of other programs that this one starts too, stop at eight blocks of 512 bytes.
    const Run result = in_shell("ulimit -f 8", arguments);
    CAPTURE(result.err);
    CHECK(result.code == exit_io);
    CHECK(is_one_sentence(result.err, "cannot"));
    CHECK(result.out.empty());
    CHECK(temporary.count() == 0);
  }
}

TEST_CASE("a disk that is full ends an atlas, whose log stays, and it goes on from there") {
  const TemporaryDirectory temporary;
  const Words atlas{"atlas",        "symmetric", "--example", "S",     "--omega",
                    "0.55..0.57",   "--p",       "0..0.1",    "--out", temporary.path() / "a.h5",
                    "--resolution", "2"};
  const Run full = in_shell("ulimit -f 8", atlas);
  CAPTURE(full.err);
  CHECK(full.code == exit_io);
  CHECK(is_one_sentence(full.err, "a.h5"));
  CHECK_FALSE(std::filesystem::exists(temporary.path() / "a.h5"));
  CHECK(std::filesystem::exists(temporary.path() / "a.h5.log"));
  Words again = atlas;
  again.push_back("--resume");
  CHECK(stickslip_program(again).code == exit_decided);
}

TEST_CASE("a directory that vanishes while the program works is an error") {
  const TemporaryDirectory temporary;
  const auto directory = temporary.path() / "results" / "today";
  std::filesystem::create_directories(directory);
  const int output = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  const int process = start(
      {"simulate", "--example", "O", "--periods", "1e8", "--every", "1e4", "--csv", directory / "a.csv"},
      output);
  for (int wait = 0; wait < 200 && std::filesystem::is_empty(directory); ++wait) {  // until it writes
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));
  std::filesystem::remove_all(directory.parent_path());
  ::kill(process, SIGINT);
  CHECK(wait_for(process) == exit_io);
  ::close(output);
  CHECK(temporary.count() == 0);
}

TEST_CASE("an interrupted audit writes no report, and prints what is done") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "printed";
  for (const bool as_json : {false, true}) {
    const int output = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    Words arguments{"audit", "--out", temporary.path() / "out"};
    if (as_json) {
      arguments.emplace_back("--json");
    }
    const int process = start(arguments, output);
    std::this_thread::sleep_for(std::chrono::seconds(2));
    ::kill(process, SIGINT);
    CHECK(wait_for(process) == exit_interrupted);
    ::close(output);
    const std::string printed = content(file);
    if (as_json) {
      CHECK(Json::parse(printed).at("interrupted") == true);
    } else {
      CHECK(printed.find("claims were examined.\n") != std::string::npos);
    }
  }
  CHECK(temporary.count() == 1);
}

TEST_CASE("whatever the command, a reader that has gone is no reason for noise") {
  for (const Words& arguments : {Words{"check", "40"},
                                 {"check", "40", "--json"},
                                 {"orbits", "symmetric", "--example", "S"},
                                 {"simulate", "--example", "O", "--periods", "2"},
                                 {"--help"}}) {
    int ends[2];
    REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
    ::close(ends[0]);
    const int process = start(arguments, ends[1]);
    ::close(ends[1]);
    CHECK(wait_for(process) == exit_io);
  }
}

TEST_CASE("neither the locale nor the home directory changes a result") {
  const TemporaryDirectory temporary;
  const std::string svg = temporary.path() / "a.svg";
  for (const Words& arguments : {Words{"orbits", "symmetric", "--example", "S", "--plot", svg},
                                 {"simulate", "--example", "O", "--periods", "3"},
                                 {"latex", "Q"},
                                 {"check", "40", "--explain"}}) {
    const Run usual = stickslip_program(arguments);
    CHECK(usual.code == exit_decided);
    const std::string picture = content(svg);
    for (const char * surroundings :
         {"export LC_ALL=C", "export LC_ALL=de_DE.UTF-8", "export LC_ALL=no_such.locale",
          "unset LC_ALL LC_CTYPE LC_NUMERIC LANG LANGUAGE", "export HOME=/nonexistent", "export HOME=/proc",
          "unset HOME"}) {
      CAPTURE(std::string(surroundings));
      const Run result = in_shell(surroundings, arguments);
      CHECK(result.code == usual.code);
      CHECK(result.out == usual.out);
      CHECK(result.err == usual.err);
      CHECK(content(svg) == picture);
    }
  }
}

TEST_CASE("without a home or a temporary directory a report is made all the same") {
  const TemporaryDirectory temporary;
  const auto out = temporary.path() / "out";
  const Words arguments{"orbits", "symmetric", "--example", "S", "--out", out};
  const Run homeless = in_shell("export HOME=/proc; unset XDG_CACHE_HOME", arguments);
  CHECK(homeless.code == exit_decided);
  CHECK(std::filesystem::exists(out / "orbits.pdf") == !std::string(STICKSLIP_PDFLATEX).empty());
  const Run elsewhere = in_shell("export TMPDIR=/nonexistent", arguments);
  CHECK(elsewhere.code == exit_decided);
  CHECK(content(out / "index.html").ends_with("</html>\n"));
  if (!std::string(STICKSLIP_PDFLATEX).empty()) {
    CHECK(elsewhere.err.find("no temporary directory") != std::string::npos);
  }
}

#ifndef __SANITIZE_ADDRESS__
TEST_CASE("at any limit of memory there is an answer or a sentence, from the libraries in C too") {
  // Not loaded; or a library, CLN, has no memory for its own numbers before main() begins.
  constexpr int not_loaded = 127, not_begun = 128 + SIGABRT, plenty = 4000000;
  int sentences = 0;
  for (const int kilobytes : {50000, 55000, 60000, 65000, 70000, 75000, 80000, 90000, 100000, plenty}) {
    CAPTURE(kilobytes);
    const Run result = in_shell(fmt::format("ulimit -v {}", kilobytes),
                                {"orbits", "symmetric", "--example", "S", "--digits", "1000"});
    if (result.code == exit_internal) {
      ++sentences;
      CHECK(result.err.find("out of memory") != std::string::npos);
      CHECK(result.out.empty());
    } else {
      CHECK((result.code == exit_decided || result.code == not_loaded || result.code == not_begun));
      CHECK(
          (result.code != not_begun || result.err.find("without an active exception") != std::string::npos));
    }
    CHECK((kilobytes < plenty || result.code == exit_decided));
  }
  CHECK(sentences > 0);
}
#endif
