// stickslip simulate from outside: exit codes, sentences, files.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;

namespace {

Run simulate(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "simulate");
  return stickslip_program(arguments);
}

std::vector<std::vector<std::string>> read_csv(const std::string& file) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) {
      rows.back().push_back(cell);
    }
  }
  return rows;
}

const std::vector<std::string> own_state{"--chi", "0.5",  "--eta", "2", "--us",    "0.1",
                                         "--ur",  "0.25", "--V",   "1", "--omega", "0.6",
                                         "--p",   "0.3",  "--phi", "0", "--state", "0,0.5,0,1"};

}  // namespace

TEST_CASE("what is missing or malformed is a usage error that names it") {
  const std::vector<std::pair<std::vector<std::string>, std::string>> refusals = {
      {{}, "--state"},
      {{"--state", "0,0,0,0"}, "--chi"},
      {{"--example", "Q"}, "'Q'"},
      {{"--example", "S", "--periods", "-1"}, "periods: '-1'"},
      {{"--example", "S", "--every", "0"}, "every: '0'"},
      {{"--example", "S", "--perturb", "1,2,3"}, "perturb: '1,2,3'"},
      {{"--example", "S", "--perturb", "1,2,3,4,5"}, "perturb"},
      {{"--example", "S", "--state", "a,2,3,4"}, "state: 'a'"},
      {{"--example", "S", "--chi", "0.5+-0.1"}, "interval"},
      {{"--example", "S", "--plot", "a.png"}, "a.png"},
  };
  for (const auto& [arguments, named] : refusals) {
    const Run result = simulate(arguments);
    CAPTURE(result.err);
    CHECK(result.code == exit_usage);
    CHECK(is_one_sentence(result.err, named));
    CHECK(result.out.empty());
  }
  const Run domain = simulate({"--example", "S", "--ur", "0.001"});
  CHECK(domain.code == exit_domain);
  CHECK(is_one_sentence(domain.err, "ur = 0.001"));
  CHECK(is_one_sentence(simulate({"--example", "S", "--omega", "0"}).err, "omega = 0"));
  CHECK(simulate({"--example", "S", "--csv", "/no/such/directory/a.csv"}).code == exit_io);
}

TEST_CASE("data whose squares overflow are refused by name, with the range") {
  const std::vector<std::vector<std::string>> refusals = {
      {"--state", "0,0.5,1e155,1", "the state = 1e+155", "from -1e100 to 1e100"},
      {"--state", "-1e101,0.5,0,1", "the state = -1e+101", "from -1e100 to 1e100"},
      {"--perturb", "0,0,0,1e200", "the state = 1e+200", "from -1e100 to 1e100"},
      {"--p", "1e155", "p = 1e+155", "0 <= p <= 1e100"},
      {"--us", "1e155", "us = 1e+155", "0 < us <= 1e100"},
      {"--ur", "1e155", "ur = 1e+155", "us <= ur <= 1e100"},
      {"--V", "-1e155", "V = -1e+155", "-1e100 <= V <= 1e100"},
      {"--omega", "1e11", "omega = 100000000000", "1e-100 <= omega <= 1e10"},
      {"--omega", "1e-200", "omega = 1e-200", "1e-100 <= omega <= 1e10"},
      {"--eta", "1e155", "eta = 1e+155", "1e-20 <= eta <= 1e20"},
      {"--chi", "1e-155", "chi = 1e-155", "1e-100 <= chi < 1"},
  };
  for (const std::vector<std::string>& refusal : refusals) {
    const Run result = simulate({"--example", "O", refusal[0], refusal[1]});
    CAPTURE(result.err);
    CHECK(result.code == exit_domain);
    CHECK(is_one_sentence(result.err, refusal[2]));
    CHECK(is_one_sentence(result.err, refusal[3]));
    CHECK(result.out.empty());
  }
}

TEST_CASE("the largest data are simulated, and an interruption is noticed whatever they are") {
  for (const std::vector<std::string>& data : {std::vector<std::string>{"--state", "1e100,-1e100,1e100,1"},
                                               {"--p", "1e100"},
                                               {"--V", "1e100"},
                                               {"--perturb", "1e-300,0,0,1e99"},
                                               {"--us", "1e100", "--ur", "1e100"},
                                               {"--phi", "1e300"}}) {
    std::vector<std::string> arguments{"--example", "O", "--periods", "3"};
    arguments.insert(arguments.end(), data.begin(), data.end());
    CAPTURE(data[1]);
    CHECK(simulate(arguments).code == exit_decided);
  }
  const int output = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const std::vector<std::string>& data :
       {std::vector<std::string>{"--omega", "1e-100"},
        {"--eta", "1e18", "--us", "1e-3", "--ur", "1e-3", "--V", "0", "--p", "1e19"},
        {"--omega", "1e-12", "--p", "1e100"},
        {"--V", "-1e100", "--us", "1e-300", "--ur", "1e-300", "--periods", "1e6"}}) {
    std::vector<std::string> arguments{"simulate", "--example", "O"};
    arguments.insert(arguments.end(), data.begin(), data.end());
    CAPTURE(data[1]);
    const int process = start(arguments, output);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ::kill(process, SIGINT);
    const auto asked = std::chrono::steady_clock::now();
    CHECK(wait_for(process) == exit_interrupted);
    CHECK(std::chrono::steady_clock::now() - asked < std::chrono::seconds(10));
  }
  ::close(output);
}

TEST_CASE("an example's orbit returns to where it began, and the CSV tells so") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "o.csv";
  const Run result = simulate({"--example", "O", "--periods", "2", "--csv", file});
  CHECK(result.code == exit_decided);
  CHECK(result.err.empty());
  const auto rows = read_csv(file);
  REQUIRE(rows.size() == 402);
  CHECK(rows.front().size() == 9);
  for (std::size_t column = 2; column < 6; ++column) {
    CHECK(std::abs(std::stod(rows[1][column]) - std::stod(rows[401][column])) < 1e-10);
    CHECK(std::abs(std::stod(rows[1][column]) - std::stod(rows[201][column])) < 1e-10);
  }
  for (const char * part : {"2 periods", "shares", "overshoot 28.", "stick 22.", "energy", "event at t"}) {
    CAPTURE(part);
    CHECK(result.out.find(part) != std::string::npos);
  }
}

TEST_CASE("any state, any parameters; samples at the asked times") {
  const TemporaryDirectory temporary;
  std::vector<std::string> arguments = own_state;
  const std::string file = temporary.path() / "a.csv";
  arguments.insert(arguments.end(), {"--periods", "3", "--every", "0.25", "--csv", file});
  CHECK(simulate(arguments).code == exit_decided);
  const auto rows = read_csv(file);
  REQUIRE(rows.size() > 100);
  CHECK(std::stod(rows[5][0]) == doctest::Approx(1.0));
  CHECK(std::stod(rows[1][5]) == 1.0);
}

TEST_CASE("a perturbation of the unstable orbit S grows, of the stable O dies out") {
  const TemporaryDirectory temporary;
  const auto distance = [&](const std::string& name) {
    const std::string file = temporary.path() / "a.csv";
    const std::string period = name == "S" ? "0.6" : "0.6289";
    CHECK(simulate({"--example", name, "--perturb", "1e-6,0,0,0", "--periods", "60", "--csv", file}).code ==
          exit_decided);
    const auto rows = read_csv(file);
    return std::abs(std::stod(rows.back()[2]) - std::stod(rows[1][2]));
  };
  CHECK(distance("S") > 1.5e-6);
  CHECK(distance("O") < 1.2e-6);
}

TEST_CASE("a plot is drawn") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "a.svg";
  CHECK(simulate({"--example", "P", "--periods", "5", "--plot", file}).code == exit_decided);
  CHECK(std::filesystem::file_size(file) > 10000);
  CHECK(temporary.count() == 1);
}

TEST_CASE("an interruption leaves what was computed") {
  const TemporaryDirectory temporary;
  const std::string csv = temporary.path() / "a.csv";
  const int output = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  std::vector<std::string> arguments = own_state;
  arguments.insert(arguments.begin(), "simulate");
  arguments.insert(arguments.end(), {"--periods", "100000000", "--every", "1000", "--csv", csv});
  const int process = start(arguments, output);
  std::this_thread::sleep_for(std::chrono::seconds(1));
  ::kill(process, SIGINT);
  CHECK(wait_for(process) == exit_interrupted);
  ::close(output);
  const auto rows = read_csv(csv);
  CHECK(rows.size() > 10);
  CHECK(rows.back().size() == 9);
}
