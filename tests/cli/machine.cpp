// A machine in SI units, from outside: the data taken, and what is refused.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "tests/cli/machines.hpp"

using namespace stickslip;

namespace {

using Json = nlohmann::json;
Json parameters_of(const Machine& machine) {
  const Run result = run_with(machine, {"orbits", "nonsticking", "--digits", "5", "--json"});
  CAPTURE(result.err);
  REQUIRE((result.code == exit_decided || result.code == exit_undecided));
  return Json::parse(result.out).at("parameters");
}

}  // namespace

TEST_CASE("a machine in SI units has the orbits of the data that are taken for it") {
  const Run result = run_with(machine_O, {"orbits", "overshooting", "--json"});
  REQUIRE(result.code == exit_decided);
  CHECK(result.err.empty());
  const Json json = Json::parse(result.out);
  const Json& taken = json.at("parameters");
  CHECK(taken.at("chi") == "0.2");
  CHECK(taken.at("eta") == "4");
  CHECK(taken.at("us") == "0.05");
  CHECK(taken.at("V") == "1");
  CHECK(taken.at("p") == "0.05");
  CHECK(taken.at("ur") == "0.4585");
  // 2 pi times 1.0009254372/10.
  CHECK(taken.at("omega") == "0.62890000005973438933");
  CHECK(json.at("machine").at("rounded") == Json{"omega"});
  CHECK(json.at("machine").at("si").at("friction_at_rest") == "0.1834");
  Words options{"orbits", "overshooting", "--json"};
  for (const auto& [name, value] : taken.items()) {
    options.push_back("--" + name);
    options.push_back(value.get<std::string>());
  }
  const Json same = Json::parse(stickslip_program(options).out);
  CHECK(same.at("orbits") == json.at("orbits"));
  CHECK_FALSE(same.contains("machine"));
}

TEST_CASE("friction in N is the same machine, and every value counts") {
  Machine forces = without(machine_O, {"normal_force", "friction_at_rest", "friction_sliding"});
  forces["friction_force_at_rest"] = "0.1834";
  forces["friction_force_sliding"] = "0.02";
  const Json taken = parameters_of(machine_O);
  CHECK(parameters_of(forces) == taken);
  CHECK(parameters_of(with(machine_O, "load_phase", "0.3")) == taken);
  for (const auto& [name, value] : machine_O) {
    CAPTURE(name);
    CHECK(parameters_of(with(machine_O, name, value + "1")) != taken);
  }
}

TEST_CASE("attractors, words and simulations take the machine and say which data they took") {
  const std::string data = "data taken  chi=0.2, eta=4, us=0.05, V=1, omega=0.62890000005973438933, p=0.05";
  const Run attractors = run_with(machine_O, {"attractors", "--starts", "10", "--most-periods", "300"});
  CHECK(attractors.out.find(data) != std::string::npos);
  const Run word = run_with(machine_O, {"orbits", "OTS"});
  CHECK(word.code == exit_decided);
  CHECK(word.out.find(data) != std::string::npos);
  const Run motion = run_with(with(machine_O, "load_phase", "0.25"), {"simulate", "--state", "0,0,0,0"});
  CHECK(motion.code == exit_decided);
  CHECK(motion.out.find(data) != std::string::npos);
  CHECK(motion.out.find("phi=0.25") != std::string::npos);
  // Friction at rest is a result for this family, and is not given.
  CHECK(run_with(without(machine_O, {"friction_at_rest"}), {"orbits", "symmetric"}).code == exit_decided);
}

TEST_CASE("values in SI units are those of the table in other units") {
  // Omega = 10: a time of 1 is 0.1 s, a length 1 mm, a velocity 0.01 m/s, a force 0.4 N.
  const Run word = run_with(machine_O, {"orbits", "OTS", "--units", "si", "--digits", "8"});
  CHECK(word.code == exit_decided);
  const Json orbit = Json::parse(run_with(machine_O, {"orbits", "OTS", "--json"}).out).at("orbits").at(1);
  REQUIRE(orbit.at("admissible") == true);  // that one is told first
  const auto in_table = [](const Run& run, const std::string& name) {
    const std::size_t at = run.out.find("\n  " + name + " ");
    REQUIRE(at != std::string::npos);
    return std::stod(run.out.substr(at + name.size() + 3));
  };
  const auto in_json = [&](const char * name) {
    return std::stod(orbit.at(name).at("mid").get<std::string>());
  };
  CHECK(in_table(word, "Theta") == doctest::Approx(0.1 * in_json("Theta")).epsilon(1e-6));
  CHECK(in_table(word, "z20") == doctest::Approx(1e-3 * in_json("z20")).epsilon(1e-6));
  CHECK(in_table(word, "zdot10") == doctest::Approx(1e-2 * in_json("zdot10")).epsilon(1e-6));
  CHECK(in_table(word, "phi") == doctest::Approx(in_json("phi")).epsilon(1e-6));
  // Example S, where the friction at rest is a result; a force of 1 is 0.38 N.
  const Machine S{{"m1", "3.8"},
                  {"m2", "1"},
                  {"k1", "190"},
                  {"k2", "190"},
                  {"friction_force_sliding", "0.0076"},
                  {"belt_velocity", "0.01"},
                  {"load_amplitude", "0.005"},
                  {"load_frequency", "0.954929658551372"}};
  const Run plain = run_with(S, {"orbits", "symmetric"});
  const Run in_SI = run_with(S, {"orbits", "symmetric", "--units", "si"});
  CHECK(plain.out.find("us=0.02, V=1") != std::string::npos);
  CHECK(in_table(in_SI, "ur") == doctest::Approx(0.38 * in_table(plain, "ur")).epsilon(1e-6));
  CHECK(in_table(in_SI, "tau") == doctest::Approx(0.1 * in_table(plain, "tau")).epsilon(1e-6));
}

TEST_CASE("one file of a machine serves every question, which says what of it is a result") {
  const Words told{"the friction at rest is not taken", "ur is not given for symmetric orbits"};
  const Run symmetric = run_with(machine_O, {"orbits", "symmetric"});
  const Run without_it = run_with(without(machine_O, {"friction_at_rest"}), {"orbits", "symmetric"});
  CHECK(symmetric.code == exit_decided);
  CHECK(symmetric.out == without_it.out);
  CHECK(without_it.err.empty());
  for (const std::string& part : told) {
    CHECK(symmetric.err.find(part) != std::string::npos);
  }
  const Run by_phase = run_with(machine_O, {"orbits", "overshooting", "--phi", "1"});
  CHECK(by_phase.err.find("the friction at rest is not taken: with --phi it is a result") !=
        std::string::npos);
  CHECK(by_phase.out.find("ur=") == std::string::npos);
}

TEST_CASE("a machine that is none is named in one sentence") {
  struct RefusedMachine {
    Machine machine;
    Words arguments;
    int code;
    std::string named;
  };
  const Words attractors{"attractors"};
  const std::vector<RefusedMachine> refusals{
      {without(machine_O, {"m2", "belt_velocity", "friction_at_rest"}), attractors, exit_usage,
       "missing for a machine in SI units: m2, friction_at_rest, belt_velocity"},
      {{{"m1", "4"}},
       {"orbits", "symmetric"},
       exit_usage,
       "m2, k1, k2, normal_force, friction_sliding, belt"},
      {with(machine_O, "chi", "0.2"), attractors, exit_usage, "belt_velocity and chi do not go together"},
      {with(machine_O, "mass", "1"), attractors, exit_usage, "'mass' is not a parameter"},
      {with(machine_O, "friction_force_sliding", "1"), attractors, exit_usage, "normal_force does not go"},
      {with(machine_O, "m1", "heavy"), attractors, exit_usage, "m1: "},
      {with(machine_O, "k1", "\"320+-1\""), attractors, exit_usage, "is an interval"},
      {with(machine_O, "m1", "-4"), attractors, exit_domain, "m1 = -4"},
      {with(machine_O, "k2", "0"), attractors, exit_domain, "k2 = 0"},
      {with(machine_O, "normal_force", "-1"), attractors, exit_domain, "normal_force = -1"},
      {with(machine_O, "friction_sliding", "0"), attractors, exit_domain, "friction_sliding = 0"},
      {with(machine_O, "friction_at_rest", "0.1"), attractors, exit_domain, "friction_at_rest = 0.01 N"},
      {with(machine_O, "belt_velocity", "-0.01"), attractors, exit_domain, "belt_velocity = -0.01"},
      {with(machine_O, "load_frequency", "0"),
       {"simulate", "--state", "0,0,0,0"},
       exit_domain,
       "load_frequency = 0"},
      {machine_O, {"attractors", "--chi", "0.3"}, exit_usage, "--chi does not go with the machine"},
      {machine_O, {"attractors", "--example", "O"}, exit_usage, "--example does not go with the machine"},
      {machine_O, {"simulate", "--example", "O"}, exit_usage, "--example does not go with the machine"},
      {machine_O, {"attractors", "--units", "imperial"}, exit_usage, "units: 'imperial'"},
      {machine_O, {"orbits", "OTS", "--units", "si", "--json"}, exit_usage, "--units si is for text"},
      {{{"chi", "0.2"}}, {"orbits", "symmetric", "--units", "si"}, exit_usage, "needs a machine"},
      {with(machine_O, "k1", "1e60"), attractors, exit_domain, "k1 = "},
  };
  for (const RefusedMachine& refused : refusals) {
    check_refused({{refused.arguments, refused.code, refused.named}},
                  [&](const Words& arguments) { return run_with(refused.machine, arguments); });
  }
}

TEST_CASE("what the model lacks, and what a value or a file should look like, is said where it is met") {
  const Words attractors{"attractors"};
  const auto refused = [](const Machine& machine, const Words& arguments, int code, const std::string& part) {
    check_refused({{arguments, code, part}}, [&](const Words& words) { return run_with(machine, words); });
  };
  for (const auto& [name, part] : std::vector<std::pair<std::string, std::string>>{
           {"damping", "the model has no damping"},
           {"stribeck_velocity", "the model has none: sliding friction is the same at all velocities"},
           {"second_load_frequency", "a single harmonic, with one frequency"},
           {"load_frequency_2", "a single harmonic, with one frequency"}}) {
    refused(with(machine_O, name, "0.1"), attractors, exit_usage, "'" + name + "' is not a parameter: ");
    refused(with(machine_O, name, "0.1"), attractors, exit_usage, part);
  }
  refused(with(machine_O, "load_frequency", "[5.1, 7.2]"), attractors, exit_usage,
          "load_frequency needs exactly one value: the load of the model is a single harmonic");
  for (const std::string quote : {"", "\""}) {
    refused(with(machine_O, "m1", quote + "12,4" + quote), attractors, exit_usage,
            "machine.toml: m1: '12,4' is not a number: a decimal has a point, 12.4");
    refused(with(machine_O, "m1", quote + "12.4 kg" + quote), attractors, exit_usage,
            "machine.toml: m1: '12.4 kg' is not a number: write 12.4 alone, without a unit");
  }
  refused(with(machine_O, "load_amplitude", "0"), attractors, exit_domain, "load_amplitude = 0 in ");
  refused(with(machine_O, "load_amplitude", "0"), {"orbits", "overshooting"}, exit_domain,
          "load_amplitude = 0 in ");
  refused(machine_O, {"attractors", "--along", "frequency", "1..2"}, exit_usage,
          "'frequency' is none of the parameters in ");
  refused(machine_O, {"attractors", "--along", "frequency", "1..2"}, exit_usage,
          "belt_velocity, friction_at_rest, friction_sliding, k1, k2, load_amplitude, load_frequency, m1");
}

TEST_CASE("values of a machine have the digits that its data deserve, or those of --digits") {
  const Machine five{{"m1", "12.4"},
                     {"m2", "3.1"},
                     {"k1", "8300"},
                     {"k2", "2650.5"},
                     {"friction_force_sliding", "13.1"},
                     {"friction_force_at_rest", "21.7"},
                     {"belt_velocity", "0.213"},
                     {"load_amplitude", "44.4"},
                     {"load_frequency", "5.15"}};
  const Words orbits{"orbits", "nonsticking", "--units", "si"};
  const auto line = [](const Run& run, const std::string& label) {
    CAPTURE(run.err);
    const std::size_t at = run.out.find("\n" + label);
    REQUIRE(at != std::string::npos);
    return run.out.substr(at + 1, run.out.find('\n', at + 1) - at - 1);
  };
  // Two more than the five of k2; without k2's, two more than four.
  const Run seven = run_with(five, orbits);
  CHECK(line(seven, "natural") == "natural     3.343472 Hz and 5.731309 Hz");
  CHECK(line(seven, "  Theta") == "  Theta   0.1941748 ± 4.36e-8 s");
  CHECK(line(run_with(with(five, "k2", "2.7e3"), orbits), "  Theta").starts_with("  Theta   0.194175 ± "));
  CHECK(line(run_with(five, with(orbits, {"--digits", "9"})), "  Theta")
            .starts_with("  Theta   0.194174757 ± "));
}

TEST_CASE("figures are titled by the machine, in each format") {
  const TemporaryDirectory temporary;
  const std::string svg = temporary.path() / "a.svg", png = temporary.path() / "a.png";
  const std::string springs = "m1 = 4 kg, m2 = 1 kg, k1 = 320 N/m, k2 = 80 N/m,";
  const std::string rest = "friction 0.02 N sliding, 0.1834 N at rest, belt 0.01 m/s, load 0.005 N";
  const Words start{"simulate", "--state", "0,0,0,0", "--periods", "3", "--plot"};
  const auto drawn = [&](const Words& arguments) {
    const Run run = run_with(machine_O, with(arguments, {svg}));
    CAPTURE(run.err);
    CHECK(run.code != exit_usage);
    return content(svg);
  };
  for (const Words& arguments : {start, Words{"attractors", "--plane", "x1,x2", "--pixels", "2", "--plot"},
                                 Words{"orbits", "overshooting", "--plot"}}) {
    const std::string picture = drawn(arguments);
    CHECK(picture.find(springs) != std::string::npos);
    CHECK(picture.find(rest + " at 1.0009254372 Hz") != std::string::npos);
  }
  const std::string along = drawn(
      {"attractors", "--along", "load_frequency", "1..1.1", "--values", "2", "--starts", "2", "--plot"});
  CHECK(along.find(rest + "<") != std::string::npos);
  CHECK(along.find("at 1.0009254372 Hz") == std::string::npos);
  const std::string branches =
      drawn({"branch", "overshooting", "--along", "load_frequency", "1..1.001", "--at", "1", "--plot"});
  CHECK(branches.find(springs) != std::string::npos);
  CHECK(branches.find(rest + "<") != std::string::npos);
  CHECK(run_with(machine_O, with(start, {png})).code == exit_decided);
  CHECK(content(png).starts_with("\x89PNG"));
}

TEST_CASE("a byte order mark before the parameters says nothing") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "machine.toml";
  const auto orbits = [&](const std::string& mark) {
    std::ofstream(file) << mark << "chi = 0.5\neta = 3.8\nus = 0.02\nV = 1\nomega = 0.6\np = 0.05\n";
    return stickslip_program({"orbits", "symmetric", "--params", file});
  };
  const Run plain = orbits("");
  CHECK(plain.code == exit_decided);
  CHECK(orbits("\xef\xbb\xbf").out == plain.out);
  const Run wide = orbits("\xff\xfe");
  CHECK(wide.code == exit_usage);
  CHECK(is_one_sentence(wide.err, "is in UTF-16: save it as UTF-8"));
}

TEST_CASE("a simulation and its start in SI units are those of the data in other units") {
  const TemporaryDirectory temporary;
  const auto csv = [&](const char * name, const Words& options) {
    const std::string file = temporary.path() / name;
    const Run run = run_with(machine_O, with({"simulate", "--periods", "1", "--csv", file}, options));
    CHECK(run.code == exit_decided);
    std::istringstream lines(content(file));
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) {
      all.push_back(line);
    }
    return all;
  };
  const auto plain = csv("a.csv", {"--state", "1,2,3,4"});
  const auto in_SI = csv("b.csv", {"--state", "1e-3,2e-3,3e-2,4e-2", "--units", "si"});
  CHECK(in_SI.at(0) == "t in s,phase,x1 in m,x2 in m,x1' in m/s,x2' in m/s,r in N,u in N,E in J");
  REQUIRE(plain.size() == in_SI.size());
  // Energies in m1 (x' = 1)² = 4 kg (0.01 m/s)².
  const std::vector<double> units{0.1, 0, 1e-3, 1e-3, 1e-2, 1e-2, 0.4, 0.4, 4e-4};
  const auto cells = [](const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> all;
    for (std::string cell; std::getline(stream, cell, ',');) {
      all.push_back(cell);
    }
    return all;
  };
  for (const std::size_t k : {std::size_t{1}, plain.size() / 2, plain.size() - 1}) {
    const auto a = cells(plain[k]), b = cells(in_SI[k]);
    CHECK(a[1] == b[1]);
    for (std::size_t i = 0; i < units.size(); ++i) {
      CHECK((i == 1 || std::stod(b[i]) == doctest::Approx(units[i] * std::stod(a[i])).epsilon(1e-9)));
    }
  }
  const Run text =
      run_with(machine_O, {"simulate", "--periods", "1", "--state", "1e-3,0,0,0", "--units", "si"});
  CHECK(text.out.find("x1 = 0.001, x2 = 0, x1' = 0, x2' = 0 in m and m/s") != std::string::npos);
  CHECK(text.out.find("event at t in s") != std::string::npos);
}

TEST_CASE("along a value of the machine in SI units the states are in SI, whatever the unit of length is") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "along.csv";
  // At 1e-5 N the unit of length is smaller.
  const Words along{"attractors", "--along", "load_amplitude", "0.00001..0.005",
                    "--values",   "2",       "--starts",       "3"};
  CHECK(run_with(machine_O, with(along, {"--csv", file})).code == exit_decided);
  const std::string table = content(file);
  CHECK(table.starts_with("load_amplitude in N,attractor,share,kind,period,word,stable,x1 in m,"));
  const std::pair<const char *, const char *> ends[] = {{"0.00001", "\n1.0000000000000001e-05,1,"},
                                                        {"0.005", "\n0.0050000000000000001,1,"}};
  for (const auto& [value, begin] : ends) {
    const std::size_t line = table.find(begin);
    REQUIRE(line != std::string::npos);
    std::istringstream cells(table.substr(line + 1, table.find('\n', line + 1) - line - 1));
    std::vector<std::string> first;
    for (std::string cell; std::getline(cells, cell, ',');) {
      first.push_back(cell);
    }
    REQUIRE(first.size() == 11);
    const Json alone = Json::parse(
        run_with(with(machine_O, "load_amplitude", value), {"attractors", "--starts", "3", "--json"}).out);
    const Json& units = alone.at("machine").at("units");
    const auto unit = [&](const char * name) {
      return std::stod(units.at(name).at("mid").get<std::string>());
    };
    const Json& state = alone.at("attractors").at(0).at("state");
    CHECK(std::stod(first[7]) == doctest::Approx(unit("length") * state.at(0).get<double>()).epsilon(1e-9));
    CHECK(std::stod(first[10]) ==
          doctest::Approx(unit("velocity") * state.at(3).get<double>()).epsilon(1e-9));
  }
  const Run refused = run_with(machine_O, with(along, {"--json"}));
  CHECK(refused.code == exit_usage);
  CHECK(is_one_sentence(refused.err, "--json"));
  const Run plane = run_with(machine_O, {"attractors", "--plane", "x1,x2", "--pixels", "3", "--units", "si",
                                         "--csv", temporary.path() / "p.csv"});
  CHECK(plane.code == exit_decided);
  CHECK(content(temporary.path() / "p.csv").starts_with("x1 in m,x2 in m,x1' in m/s,x2' in m/s,attractor,"));
}
