// stickslip atlas as its users meet it: what is refused, what survives whatever kills it.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>
#include <vector>

#include "tests/cli/machines.hpp"

namespace stickslip {
namespace {

namespace fs = std::filesystem;

// Some hundred boxes around the paper's orbit S.
Words near_S(const std::string& out, const char * resolution = "5") {
  return {"atlas", "symmetric", "--example",    "S",        "--omega", "0.55..0.57",
          "--p",   "0..0.1",    "--resolution", resolution, "--out",   out};
}

// Some thousand boxes in half a second, in several blocks.
Words around_P(const std::string& out) {
  return {"atlas", "nonsticking", "--example",    "P", "--omega", "0.5..0.8",
          "--p",   "0.5..1.5",    "--resolution", "6", "--out",   out};
}

// The atlas, or, of a program without HDF5, its table.
std::string atlas_of(const std::string& out) {
  return content(fs::exists(out) ? out : out + ".csv");
}

TEST_CASE("An atlas says the same whoever makes it, and goes on where it was killed") {
  const TemporaryDirectory directory;
  const std::string whole = directory / "whole.h5";
  const auto begin = std::chrono::steady_clock::now();
  const Run made = stickslip_program(with(around_P(whole), {"--jobs", "1"}));
  const auto time =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
  REQUIRE(made.code == 0);
  CHECK(made.out.find("decided") != std::string::npos);
  const std::string bytes = atlas_of(whole);

  std::mt19937_64 random(17);
  for (int k = 0; k < kills(); ++k) {
    const std::string out = directory / ("killed" + std::to_string(k)).c_str();
    const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    const int process = start(with(around_P(out), {"--jobs", k % 2 == 0 ? "1" : "3"}), nothing);
    ::close(nothing);
    std::this_thread::sleep_for(time * static_cast<long>(random() % 100) / 100);
    ::kill(process, SIGKILL);
    (void)wait_for(process);
    const bool begun = fs::exists(out + ".log/question") || fs::exists(out);
    if (!begun) {
      fs::remove_all(out + ".log");
    }
    const Run rest = stickslip_program(with(around_P(out), begun ? Words{"--resume"} : Words{}));
    INFO(rest.err);
    CHECK(rest.code == 0);
    CHECK(rest.out == made.out);
    CHECK(atlas_of(out) == bytes);
  }
}

TEST_CASE("An atlas is ended in order, says what is missing, and goes on") {
  const TemporaryDirectory directory;
  const std::string out = directory / "a.h5";
  Run part = stickslip_program(with(near_S(out, "6"), {"--time-limit", "0.001", "--json"}));
  CHECK(part.code == 2);
  const nlohmann::json json = nlohmann::json::parse(part.out);
  CHECK(json["volume"]["not_examined"] != "0");
  const Run other = stickslip_program(with(near_S(out, "7"), {"--resume"}));
  CHECK(other.code == 64);
  CHECK(is_one_sentence(other.err, "another question"));
  CHECK(is_one_sentence(stickslip_program(near_S(out, "6")).err, "--resume"));
  {
    const std::string question = out + ".log/question";
    const std::string asked = content(question);
    std::ofstream(question) << "S" << asked.substr(1);
    const Run damaged = stickslip_program(with(near_S(out, "6"), {"--resume"}));
    CHECK(damaged.code == 74);
    CHECK(is_one_sentence(damaged.err, "question is damaged"));
    std::ofstream(question) << asked;
  }
  {
    const int another = ::open((out + ".log/question").c_str(), O_RDONLY | O_CLOEXEC);
    REQUIRE(::flock(another, LOCK_EX) == 0);
    const Run second = stickslip_program(with(near_S(out, "6"), {"--resume"}));
    CHECK(second.code == 74);
    CHECK(is_one_sentence(second.err, "another run works on this atlas"));
    ::close(another);
  }
  {
    const std::string leaves = out + ".log/0.leaves";
    fs::rename(leaves, leaves + ".away");
    fs::create_directory(leaves);
    const Run no_file = stickslip_program(with(near_S(out, "6"), {"--resume"}));
    CHECK(no_file.code == 74);
    CHECK(is_one_sentence(no_file.err, "0.leaves is not an ordinary file"));
    fs::remove(leaves);
    fs::rename(leaves + ".away", leaves);
  }
  for (const int signal : {SIGTERM, SIGUSR1}) {
    const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    const int process = start(with(near_S(out, "6"), {"--resume"}), nothing);
    ::close(nothing);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    ::kill(process, signal);
    const int code = wait_for(process);
    CHECK((code == 130 || code == 0 || code == 128 + signal));
  }
  CHECK(stickslip_program(with(near_S(out, "6"), {"--resume"})).code == 0);
  const std::string again = directory / "b.h5";
  CHECK(stickslip_program(near_S(again, "6")).code == 0);
  CHECK(atlas_of(out) == atlas_of(again));
}

TEST_CASE("A table has a row for each box, and its volumes make the whole") {
  const TemporaryDirectory directory;
  const Run made =
      stickslip_program(with(near_S(directory / "a.h5", "3"), {"--csv", directory / "a.csv", "--json"}));
  REQUIRE(made.code == 0);
  std::ifstream table(directory / "a.csv");
  std::string line;
  std::getline(table, line);
  CHECK(line == "omega_from,omega_to,p_from,p_to,orbits,admissible,stable,reason");
  std::size_t rows = 0;
  while (std::getline(table, line)) {
    ++rows;
  }
  CHECK(nlohmann::json::parse(made.out)["boxes"] == rows);
}

TEST_CASE("A mesh for ParaView has the boxes as they are, and what was found in each") {
  const TemporaryDirectory directory;
  const std::string mesh = directory / "a.vtk";
  const Run made = stickslip_program(
      with(near_S(directory / "a.h5", "3"), {"--plot", mesh, "--csv", directory / "a.csv"}));
  REQUIRE(made.code == 0);
  std::ifstream stream(mesh);
  std::string word;
  const auto skip_to = [&](const char * name) {
    while (stream >> word && word != name) {
    }
  };
  skip_to("POINTS");
  std::size_t points = 0;
  stream >> points >> word;
  std::vector<std::array<double, 3>> corners(points);
  for (auto& x : corners) {
    stream >> x[0] >> x[1] >> x[2];
  }
  skip_to("CELLS");
  std::size_t cells = 0, size = 0;
  stream >> cells >> size;
  CHECK(points == 4 * cells);
  CHECK(size == 5 * cells);
  double area = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    std::array<std::size_t, 5> cell{};
    for (std::size_t& x : cell) {
      stream >> x;
    }
    REQUIRE(cell[0] == 4);
    const auto& from = corners.at(cell[1]);
    const auto& to = corners.at(cell[4]);
    CHECK(corners.at(cell[2]) == std::array<double, 3>{to[0], from[1], 0});
    CHECK(corners.at(cell[3]) == std::array<double, 3>{from[0], to[1], 0});
    area += (to[0] - from[0]) * (to[1] - from[1]);
  }
  CHECK(area == doctest::Approx(0.02 * 0.1));
  skip_to("orbits");
  skip_to("default");
  std::ifstream table(directory / "a.csv");
  std::string line;
  std::getline(table, line);
  for (std::size_t i = 0; i < cells; ++i) {
    std::string orbits;
    stream >> orbits;
    REQUIRE(std::getline(table, line));
    for (int k = 0; k < 4; ++k) {
      line = line.substr(line.find(',') + 1);
    }
    CHECK(orbits == (line[0] == ',' ? "-1" : line.substr(0, line.find(','))));
  }
  CHECK_FALSE(std::getline(table, line));
}

TEST_CASE("An atlas of overshooting orbits is one at the phase of the load that is given") {
  const TemporaryDirectory directory;
  const Run made =
      stickslip_program({"atlas", "overshooting", "--example", "O", "--omega", "0.63..0.631", "--p",
                         "0.05..0.051", "--resolution", "3", "--out", directory / "a.h5", "--json"});
  REQUIRE(made.code == 0);
  const nlohmann::json json = nlohmann::json::parse(made.out);
  CHECK(json["parameters"]["phi"] == "0");
  REQUIRE(json["counts"].size() > 0);
  CHECK(json["counts"][0]["orbits"] == 2);
}

// Next to example P: Omega = 10, lengths in mm.
const Machine machine_P{{"m1", "4"},
                        {"m2", "1"},
                        {"k1", "320"},
                        {"k2", "80"},
                        {"friction_force_sliding", "0.02"},
                        {"belt_velocity", "0.01"},
                        {"load_amplitude", "0.1"},
                        {"load_frequency", "1.1"}};

TEST_CASE("An atlas of machines in SI units has their own values as axes") {
  const TemporaryDirectory directory;
  const Words asked{"atlas", "nonsticking", "--resolution", "3", "--json", "--csv", directory / "a.csv"};
  const auto json = [&](const Machine& machine, const Words& more = {}) {
    const Run made = run_with(machine, with(with(asked, {"--out", directory / "a.h5"}), more));
    INFO(made.err);
    REQUIRE(made.code == 0);
    fs::remove(directory / "a.h5");
    return nlohmann::json::parse(made.out);
  };
  const auto frequency = json(with(machine_P, "load_frequency", "\"1.1+-0.01\""), {"--units", "si"});
  CHECK(frequency["axes"] == nlohmann::json{"load_frequency"});
  CHECK(frequency["units"] == "si");
  CHECK(frequency["parameters"]["load_frequency"] == "1.09..1.11");
  CHECK(frequency["parameters"]["friction_force_sliding"] == "0.02");
  CHECK(frequency["volume"]["decided"] == "3/4");  // next to 1.11 Hz two orbits merge
  CHECK(frequency["counts"][0]["stable"] == 1);
  CHECK(content(directory / "a.csv").starts_with("load_frequency_from,load_frequency_to,orbits"));
  CHECK(content(directory / "a.csv").find("\n1.09,") != std::string::npos);
  // The same by --along.
  CHECK(json(machine_P, {"--along", "load_frequency", "1.09..1.11"}) == frequency);
  // A mass and a stiffness are an axis each, however many data they move.
  Machine both = with(with(machine_P, "m1", "\"4+-1%\""), "k1", "\"320+-1%\"");
  const auto two = json(both);
  CHECK(two["axes"] == nlohmann::json{"m1", "k1"});
  CHECK(two["parameters"]["m1"] == "3.96..4.04");
  CHECK(two["volume"]["decided"] != "0");
  // Friction by coefficients; one at rest is taken where the family asks for it.
  both = without(both, {"friction_force_sliding"});
  both["normal_force"] = "0.1";
  both["friction_sliding"] = "0.2";
  both["friction_at_rest"] = "\"0.3..0.4\"";
  CHECK(json(both)["axes"] == nlohmann::json{"m1", "k1", "friction_at_rest"});
  const Run left_out = run_with(with(both, "m1", "4"), {"atlas", "symmetric", "--resolution", "1", "--json",
                                                        "--out", directory / "b.h5"});
  CHECK(nlohmann::json::parse(left_out.out)["axes"] == nlohmann::json{"k1"});
  CHECK(left_out.err.find("friction at rest is not taken") != std::string::npos);
}

TEST_CASE("An atlas of machines is made again by its own command, goes on, and is proved again") {
  const TemporaryDirectory directory;
  const Machine machine = with(machine_P, "k1", "\"320+-5%\"");
  const Words asked{"atlas", "nonsticking", "--resolution", "7", "--out", directory / "a.h5", "--json"};
  const Run part = run_with(machine, with(asked, {"--time-limit", "0.000001"}));
  REQUIRE(part.code == 2);
  CHECK(is_one_sentence(run_with(with(machine, "k2", "81"), with(asked, {"--resume"})).err,
                        "another question"));
  const Run made = run_with(machine, with(asked, {"--resume"}));
  REQUIRE(made.code == 0);
  const nlohmann::json json = nlohmann::json::parse(made.out);
  const std::string command = json["command"];
  CHECK(command.starts_with("stickslip atlas nonsticking --params <(printf"));
  std::ofstream(directory / "again.sh")
      << STICKSLIP_PROGRAM << command.substr(std::string("stickslip").size()) << " --out "
      << (directory / "b.h5") << "\n";
  REQUIRE(std::system(("bash " + std::string(directory / "again.sh") + " > /dev/null").c_str()) == 0);
  CHECK(atlas_of(directory / "a.h5") == atlas_of(directory / "b.h5"));
  if (fs::exists(directory / "a.h5")) {  // with HDF5
    const Run again = stickslip_program({"atlas", "--verify", directory / "a.h5"});
    CHECK(again.code == 0);
    CHECK(again.out.find(" 0 contradicted, 0 not decided again") != std::string::npos);
  }
}

TEST_CASE("A map of machines names their file's values, with their units") {
  const TemporaryDirectory directory;
  Machine machine = with(with(machine_P, "m1", "\"4+-1%\""), "load_frequency", "\"1.1+-0.01\"");
  const std::string map = directory / "a.svg";
  REQUIRE(run_with(machine,
                   {"atlas", "nonsticking", "--resolution", "1", "--plot", map, "--out", directory / "a.h5"})
              .code == 0);
  const std::string drawn = content(map);
  for (const char * text : {"m1 in kg", "load_frequency in Hz", "m2 = 1 kg, k1 = 320 N/m, k2 = 80 N/m",
                            "friction_force_sliding = 0.02 N", "load_amplitude = 0.1 N"}) {
    INFO(text);
    CHECK(drawn.find(text) != std::string::npos);
  }
}

TEST_CASE("Ranges of values that are no machine's are refused") {
  const TemporaryDirectory directory;
  const auto refused = [&](const Machine& machine, int code, const char * words) {
    const Run run = run_with(machine, {"atlas", "nonsticking", "--out", directory / "a.h5"});
    INFO(run.err);
    CHECK(run.code == code);
    CHECK(is_one_sentence(run.err, words));
  };
  refused(with(machine_P, "m1", "\"0..4\""), 65, "m1");
  refused(with(with(machine_P, "m1", "\"4..5\""), "load_phase", "\"0..1\""), 64, "load_phase");
  refused(with(machine_P, "friction_force_at_rest", "\"0.02..0.03\""), 65,
          "greater than friction_force_sliding = 0.02");
  Machine five = machine_P;
  for (const char * name : {"m1", "m2", "k1", "k2", "load_amplitude"}) {
    five[name] = "\"" + five[name] + "+-5%\"";
  }
  refused(five, 64, "one to four");
  refused(machine_P, 64, "one to four");
}

TEST_CASE("What lies outside the domain is no error, and said") {
  const TemporaryDirectory directory;
  const Run made = stickslip_program({"atlas", "symmetric", "--example", "S", "--p", "-1..1", "--resolution",
                                      "3", "--out", directory / "a.h5"});
  CHECK(made.code == 2);
  CHECK(made.out.find("37.5000 % lies outside the domain") != std::string::npos);
}

TEST_CASE("Questions that make no sense are refused in a sentence") {
  const TemporaryDirectory directory;
  const std::string out = directory / "a.h5";
  std::ofstream(directory / "no.h5") << "nothing\n";
  check_refused({
      {{"atlas"}, 64, "family"},
      {{"atlas", "overshooting", "--example", "O", "--ur", "0.5", "--p", "0..1", "--out", out}, 64, "phi"},
      {{"atlas", "symmetric", "--example", "S", "--out", out}, 64, "one to four"},
      {{"atlas", "symmetric", "--example", "S", "--p", "1..0", "--out", out}, 64, "p"},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..x", "--out", out}, 64, "p"},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..1", "--ur", "1", "--out", out}, 64, "ur"},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..1"}, 64, "--out"},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..1", "--resolution", "0", "--out", out},
       64,
       "resolution"},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..1", "--out", "/dev/full"}, 74, "/dev/full"},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..1", "--out", "/none/a.h5"}, 74, "/none"},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..1", "--out", out, "--resume"}, 74, "no log"},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..1", "--out", out, "--plot", directory / "a.svg"},
       64,
       "map"},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..1", "--out", out, "--plot", "/none/a.vtk"},
       74,
       "/none"},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..1", "--eta", "3..4", "--V", "1..2", "--omega",
        "0.5..0.6", "--out", out, "--plot", directory / "a.vtk"},
       64,
       "three"},
      {{"atlas", "--verify", directory / "no.h5"}, 74, ""},
      {{"atlas", "--verify", directory / "none.h5"}, 74, ""},
      {{"atlas", "symmetric", "--example", "S", "--p", "0..1", "--sample", "5", "--out", out},
       64,
       "--verify"},
  });
  CHECK_FALSE(fs::exists(out));
  CHECK_FALSE(fs::exists(out + ".log"));
}

}  // namespace
}  // namespace stickslip
