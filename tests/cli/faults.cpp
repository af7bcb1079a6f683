// What the program does when the world around it fails.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;

namespace {

using Json = nlohmann::json;

// A search of several seconds: omega is a quarter of a natural frequency.
const std::vector<std::string> long_search{"orbits", "overshooting", "--chi",   "9/13", "--eta", "169/36",
                                           "--us",   "0.02",         "--V",     "1",    "--p",   "0.05",
                                           "--ur",   "0.1",          "--omega", "0.25"};

}  // namespace

TEST_CASE("an interrupted search tells what it has found, and that it is not all") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "out";
  const int output = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  std::vector<std::string> arguments = long_search;
  arguments.emplace_back("--json");
  const int process = start(arguments, output);
  std::this_thread::sleep_for(std::chrono::seconds(1));
  ::kill(process, SIGINT);
  CHECK(wait_for(process) == exit_interrupted);
  ::close(output);
  std::ifstream stream(file);
  const Json list = Json::parse(stream);
  CHECK_FALSE(list.at("complete").get<bool>());
  CHECK(list.at("remarks").dump().find("interrupted") != std::string::npos);
  CHECK(list.at("unresolved").dump().find("the search was interrupted") != std::string::npos);
}
