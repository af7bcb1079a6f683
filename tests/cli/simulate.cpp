// stickslip simulate from outside: exit codes, sentences, files.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using Json = nlohmann::json;

namespace {

Run simulate(Words arguments) {
  arguments.insert(arguments.begin(), "simulate");
  return stickslip_program(arguments);
}

std::vector<Words> read_csv(const std::string& file) {
  std::vector<Words> rows;
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

const Words own_state{"--chi", "0.5",     "--eta", "2",   "--us", "0.1",   "--ur", "0.25",    "--V",
                      "1",     "--omega", "0.6",   "--p", "0.3",  "--phi", "0",    "--state", "0,0.5,0,1"};

}  // namespace

TEST_CASE("what is missing or malformed is a usage error that names it") {
  check_refused(
      {
          {{}, exit_usage, "--state"},
          {{"--state", "0,0,0,0"}, exit_usage, "--chi"},
          {{"--example", "Q"}, exit_usage, "'Q'"},
          {{"--example", "S", "--periods", "-1"}, exit_usage, "periods: '-1'"},
          {{"--example", "S", "--every", "0"}, exit_usage, "every: '0'"},
          {{"--example", "S", "--perturb", "1,2,3"}, exit_usage, "perturb: '1,2,3'"},
          {{"--example", "S", "--perturb", "1,2,3,4,5"}, exit_usage, "perturb"},
          {{"--example", "S", "--state", "a,2,3,4"}, exit_usage, "state: 'a'"},
          {{"--example", "S", "--chi", "0.5+-0.1"}, exit_usage, "interval"},
          {{"--example", "S", "--plot", "a.jpg"}, exit_usage, "a.jpg"},
          {{"--example", "S", "--ur", "0.001"}, exit_domain, "ur = 0.001"},
          {{"--example", "S", "--omega", "0"}, exit_domain, "omega = 0"},
          {{"--example", "S", "--csv", "/no/such/directory/a.csv"}, exit_io, "/no/such/directory"},
      },
      simulate);
}

TEST_CASE("data whose squares overflow are refused by name, with the range") {
  const std::vector<Words> refusals = {
      {"--state", "0,0.5,1e155,1", "the state = 1e+155", "from -1e100 to 1e100"},
      {"--state", "-1e101,0.5,0,1", "the state = -1e+101", "from -1e100 to 1e100"},
      {"--perturb", "0,0,0,1e200", "the state = 1e+200", "from -1e100 to 1e100"},
      {"--p", "1e155", "p = 1e+155", "0 <= p <= 1e100"},
      {"--us", "1e155", "ur = 0.45899", "ur > us = 1e+155"},
      {"--ur", "1e155", "ur = 1e+155", "us <= ur <= 1e100"},
      {"--V", "-1e155", "V = -1e+155", "-1e100 <= V <= 1e100"},
      {"--omega", "1e11", "omega = 100000000000", "1e-100 <= omega <= 1e10"},
      {"--omega", "1e-200", "omega = 1e-200", "1e-100 <= omega <= 1e10"},
      {"--eta", "1e155", "eta = 1e+155", "1e-20 <= eta <= 1e20"},
      {"--chi", "1e-155", "chi = 1e-155", "1e-100 <= chi < 1"},
  };
  for (const Words& refusal : refusals) {
    const Run result = simulate({"--example", "O", refusal[0], refusal[1]});
    CAPTURE(result.err);
    CHECK(result.code == exit_domain);
    CHECK(is_one_sentence(result.err, refusal[2]));
    CHECK(is_one_sentence(result.err, refusal[3]));
    CHECK(result.out.empty());
  }
}

TEST_CASE("the largest data are simulated, and an interruption is noticed whatever they are") {
  for (const Words& data : {Words{"--state", "1e100,-1e100,1e100,1"},
                            {"--p", "1e100"},
                            {"--V", "1e100"},
                            {"--perturb", "1e-300,0,0,1e99"},
                            {"--us", "1e99", "--ur", "1e100"},
                            {"--phi", "1e300"}}) {
    Words arguments{"--example", "O", "--periods", "3"};
    arguments.insert(arguments.end(), data.begin(), data.end());
    CAPTURE(data[1]);
    CHECK(simulate(arguments).code == exit_decided);
  }
  const int output = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const Words& data : {Words{"--omega", "1e-100"},
                            {"--eta", "1e18", "--us", "1e-3", "--ur", "2e-3", "--V", "0", "--p", "1e19"},
                            {"--omega", "1e-12", "--p", "1e100"},
                            {"--V", "-1e100", "--us", "1e-300", "--ur", "2e-300", "--periods", "1e8"}}) {
    Words arguments{"simulate", "--example", "O"};
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

TEST_CASE("any state, any parameters, samples at the asked times") {
  const TemporaryDirectory temporary;
  Words arguments = own_state;
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
  Words arguments = own_state;
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

TEST_CASE("a simulation starts from any orbit of a list, and stays on it if it is stable") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "machine.toml";
  std::ofstream(file)
      << "chi = 0.2\neta = 4\nus = 0.05\nV = 1\nomega = 0.6289\np = 0.05\nur = 0.4589936599332\n"
         "phi = 3\n";
  const Run overshooting =
      simulate({"--orbit", "overshooting:2", "--params", file, "--periods", "3", "--json"});
  CHECK(overshooting.code == exit_decided);
  CHECK(overshooting.err.find("phi is not taken: with ur it is a result") != std::string::npos);
  const Json json = Json::parse(overshooting.out);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(json.at("end").at("state").at(i).get<double>() ==
          doctest::Approx(json.at("start").at(i).get<double>()).epsilon(1e-10));
  }
  CHECK(json.at("parameters").at("ur") == 0.4589936599332);
  const int events = json.at("events").at("count").get<int>();
  CHECK((events == 9 || events == 8));  // the last one is at the end, up to rounding
  CHECK(json.at("settles").at("word") == "OTS");
  CHECK(json.at("settles").at("verdict") == "proved");
  CHECK_FALSE(json.contains("energy"));
  // What it says to give the same result again does.
  Words again;
  std::istringstream words(json.at("command").get<std::string>());
  for (std::string word; words >> word;) {
    again.push_back(word);
  }
  const Json same = Json::parse(stickslip_program(with({again.begin() + 1, again.end()}, {"--json"})).out);
  CHECK(same == json);
  const Run formal = simulate({"--orbit", "overshooting:1", "--params", file, "--periods", "3"});
  CHECK(formal.code == exit_decided);
  CHECK(formal.err.find("overshooting:1 is not admissible: 18; the motion leaves it") != std::string::npos);
  check_refused(
      {
          {{"--orbit", "overshooting:99", "--params", file}, exit_usage, "there is no orbit overshooting:99"},
          {{"--orbit", "overshooting:0", "--params", file}, exit_usage, "orbit: '0'"},
          {{"--orbit", "overshooting", "--params", file}, exit_usage, "'overshooting' is not FAMILY:K"},
          {{"--orbit", "sideways:1", "--params", file}, exit_usage, "'sideways'"},
          {{"--orbit", "symmetric:1"}, exit_usage, "missing: --chi, --eta"},
          {{"--orbit", "symmetric:1", "--params", file, "--state", "0,0,0,0"}, exit_usage, "--state"},
          {{"--orbit", "symmetric:1", "--params", file, "--p", "0.05+-0.01"}, exit_usage, "interval"},
          {{"--orbit", "symmetric:1", "--params", file, "--ur", "1"}, exit_usage, "ur is not given"},
          {{"--orbit", "nonsticking:1", "--example", "P", "--us", "0.2996"}, exit_domain, "ur = 0.2996"},
      },
      simulate);
}

TEST_CASE("samples go to standard output alone, and only where they are asked for") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "o.csv";
  const Words question{"--example", "O", "--periods", "2"};
  const Run report = simulate(with(question, {"--csv", file}));
  const Run samples = simulate(with(question, {"--csv", "-"}));
  CHECK(samples.code == exit_decided);
  CHECK(samples.err.empty());
  CHECK(samples.out == content(file));
  CHECK(report.out.find("; between") != std::string::npos);
  CHECK(simulate(question).out.find("; between") == std::string::npos);
  check_refused({{{"--example", "O", "--csv", "-", "--json"}, exit_usage, "--csv - and --json"},
                 {{"--example", "O", "--csv", ""}, exit_usage, "csv: ''"}},
                simulate);
}

#ifndef __SANITIZE_ADDRESS__
TEST_CASE("samples without number need no memory") {
  const Run result =
      run("/bin/sh", {"-c", "ulimit -v 200000; exec \"$@\" | tail -n 1", "sh", STICKSLIP_PROGRAM, "simulate",
                      "--example", "O", "--periods", "8000", "--csv", "-"});
  CHECK(result.out.starts_with("79926.03"));
}
#endif
