// Machines in tables, from outside: what they do, exactly read, and what is refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/answers/machine_tables.hpp"
#include "core/decimal.hpp"
#include "core/error.hpp"
#include "report/tools/files.hpp"
#include "tests/cli/machines.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using Json = nlohmann::json;

namespace {

const std::string good = R"([[mass]]
m = 2.5
[[mass]]
m = 0.8
[[spring]]
between = [0, 1]
k = 1_200
c = 0.6
[[spring]]
between = [1, 2]
k = 450
[belt]
mass = 2
velocity = "1/20"
[friction]
at_rest = 13.5
sliding = [[0, 9], [0.05, 7.5], [0.3, 6]]
[[load]]
mass = 2
amplitude = 12
frequency = 3.6
)";

// The text with one part replaced.
std::string replaced(const std::string& from, const std::string& to) {
  std::string text = good;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

// What is said of it, with the code before it.
std::string refusal(const std::string& text) {
  try {
    (void)cli::machine_in_tables(text, "m.toml");
  } catch (const UsageError& error) {
    return "64 " + std::string(error.what());
  } catch (const DomainError& error) {
    return "65 " + std::string(error.what());
  }
  return "";
}

}  // namespace

TEST_CASE("a machine in tables is read exactly") {
  const auto read = cli::machine_in_tables(good, "m.toml");
  REQUIRE(read);
  CHECK(read->in_SI);
  const auto& o = read->machine.oscillator;
  CHECK(o.masses == std::vector<Rational>{Rational(5, 2), Rational(4, 5)});
  CHECK(o.stiffness(0, 0) == 1650);
  CHECK(o.stiffness(0, 1) == -450);
  CHECK(o.stiffness(1, 1) == 450);
  CHECK(o.damping(0, 0) == Rational(3, 5));
  CHECK(o.damping(1, 1) == 0);
  CHECK(o.rubbing == 1);
  CHECK(o.V == Rational(1, 20));
  CHECK(o.forward.at_rest == Rational(27, 2));
  REQUIRE(o.forward.sliding.size() == 3);
  CHECK(o.forward.sliding[0].slope == -30);
  CHECK(o.forward.sliding[1].slope == -6);
  CHECK(o.forward.sliding[2].slope == 0);
  CHECK(o.forward.sliding[2].from == Rational(3, 10));
  CHECK(read->machine.in_turns);
  CHECK(o.omega == Rational(18, 5));
  // However it is written, and wherever.
  for (const char * number :
       {"2.5", "+2.5", "25e-1", "2_5.0e-1", "\"5/2\"", "'2.5'", "\t2.5 # 3 kg, not 2,5"}) {
    CAPTURE(number);
    for (const char * end : {"\n", "\r\n"}) {
      const auto other =
          cli::machine_in_tables(replaced("m = 2.5\n", std::string("m =") + number + end), "m.toml");
      CHECK(other->machine.oscillator.masses.front() == Rational(5, 2));
    }
  }
  const auto lines = cli::machine_in_tables(
      replaced("[[0, 9], [0.05, 7.5], [0.3, 6]]", "[\n  [0, 9],  # \u00b5\n\n [ 0.05 ,7.5],\n [0.3\n, 6]]"),
      "m.toml");
  CHECK(lines->machine.oscillator.forward.sliding[2].from == Rational(3, 10));
  CHECK(lines->machine.oscillator.forward.sliding[1].slope == -6);
  CHECK_FALSE(cli::machine_in_tables("chi = 0.5\n", "m.toml"));
  CHECK_FALSE(cli::has_tables("m1 = 2\n# [[mass]] is something else\n"));
}

TEST_CASE("several loads are whole multiples of one frequency, and friction may differ from side to side") {
  const auto read = cli::machine_in_tables(good +
                                               "[[load]]\nmass = 1\namplitude = 2\nsine = 0.5\nfrequency = "
                                               "5.4\n[[load]]\nmass = 1\nconstant = -3\n"
                                               "[friction.overshoot]\nat_rest = 11\nsliding = 8\n",
                                           "m.toml");
  REQUIRE(read);
  const auto& o = read->machine.oscillator;
  CHECK(o.omega == Rational(9, 5));
  REQUIRE(o.loads.size() == 3);
  CHECK(o.loads[0].k == 2);
  CHECK(o.loads[1].k == 3);
  CHECK(o.loads[1].sine == Rational(1, 2));
  CHECK(o.loads[2].k == 0);
  CHECK(o.loads[2].cosine == -3);
  CHECK(o.backward.at_rest == 11);
  CHECK(o.backward.sliding.size() == 1);
  CHECK(o.forward.sliding.size() == 3);
}

TEST_CASE("a smooth law of friction is read, and its numbers can vary") {
  const std::string text =
      replaced("sliding = [[0, 9], [0.05, 7.5], [0.3, 6]]",
               "sliding = {falls = \"hyperbolically\", from = 9, to = \"25/4\", over = 0.05, "
               "viscous = 0.7}");
  const auto read = cli::machine_in_tables(text, "m.toml");
  REQUIRE(read);
  const auto& law = read->machine.oscillator.forward;
  REQUIRE(law.smooth);
  CHECK(law.smooth->fall == model::Fall::hyperbolic);
  CHECK(law.smooth->first == 9);
  CHECK(law.smooth->last == Rational(25, 4));
  CHECK(law.smooth->scale == Rational(1, 20));
  CHECK(law.smooth->viscous == Rational(7, 10));
  // Motions are simulated on pieces that meet it.
  CHECK(law.pieces() == 1);
  REQUIRE(law.sliding.size() == numeric::machines::smooth_pieces);
  for (const auto& piece : law.sliding) {
    const double v = piece.from.get_d();
    CHECK(piece.force.get_d() == doctest::Approx(6.25 + 2.75 / (1 + v / 0.05) + 0.7 * v));
  }
  CHECK(law.sliding.back().slope == Rational(7, 10));
  CHECK(cli::value_in_tables(text, "m.toml", "friction.sliding.over") == Rational(1, 20));
  const auto other = cli::machine_in_tables(text, "m.toml", {{"friction.sliding.to", Rational(7)}});
  CHECK(other->machine.oscillator.backward.smooth->last == 7);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    return refusal(changed.replace(changed.find(from), from.size(), to));
  };
  CHECK(with("hyperbolically", "slowly").find("64 m.toml, line 17: sliding falls = \"exponentially\" or") ==
        0);
  CHECK(with("over = 0.05, ", "").find("64 m.toml, line 17: over is missing in sliding") == 0);
  CHECK(with("viscous", "damping").find("64 m.toml, line 17: 'damping' is not known in sliding") == 0);
  CHECK(with("over = 0.05", "over = 0").find("65 the velocity over which sliding friction falls = 0") == 0);
  CHECK(with("from = 9", "from = 14").find("65 the sliding friction at 0 = 14") == 0);
  CHECK(with("from = 9", "from = true").find("64 m.toml, line 17: from is no number") == 0);
}

TEST_CASE("what is no machine in tables is said with its line") {
  CHECK(refusal(good).empty());
  for (const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
           {replaced("m = 2.5", "m = 2,5"), "64 m.toml, line 2: "},
           {replaced("m = 2.5", "m = 0x19"), "64 m.toml, line 2: m: '0x19' is not a number"},
           {replaced("[0, 9],", "[0, 9], [\"\u00b5\", 9], [0.01, 8.7],"),
            "64 m.toml, line 17: a relative velocity: "},
           {replaced("m = 2.5", "m = true"), "64 m.toml, line 2: m is no number"},
           {replaced("m = 2.5", "m = inf"), "64 m.toml, line 2: m: 'inf' is not a number"},
           {replaced("m = 2.5", "m = 1e-101"), "64 m.toml, line 2: m = 1e-101: the size of a number is from"},
           {replaced("m = 2.5", "m = \"1e400\""),
            "64 m.toml, line 2: m = 1e400: the size of a number is from"},
           {replaced("m = 2.5", "mass = 2.5"), "64 m.toml, line 2: 'mass' is not known in mass: it may be m"},
           {replaced("m = 2.5", "m = 0"), "65 mass 1 = 0 is outside the allowed range"},
           {replaced("m = 2.5", "m = -1"), "65 mass 1 = -1 is outside the allowed range"},
           {replaced("[belt]", "[blt]"),
            "64 m.toml, line 12: 'blt' is not known: it may be units, mass, spring"},
           {replaced("velocity = \"1/20\"", ""), "64 m.toml, line 12: velocity is missing in belt"},
           {replaced("velocity = \"1/20\"", "velocity = \"1/0\""), "64 m.toml, line 14: velocity: "},
           {replaced("mass = 2\nvelocity", "mass = 3\nvelocity"),
            "64 m.toml, line 13: mass = 3: it is a number from 1 to 2"},
           {replaced("between = [1, 2]", "between = [1, 1]"),
            "64 m.toml, line 10: a spring is between two different ones"},
           {replaced("between = [1, 2]", "between = 1"), "64 m.toml, line 9: a spring is between two"},
           {replaced("between = [1, 2]", "between = [1, 5]"), "64 m.toml, line 10: between 5: "},
           {replaced("k = 450", ""),
            "64 m.toml, line 9: a spring has a stiffness k, or a dashpot c, or both"},
           {replaced("k = 450", "k = -450"), "65 k = -450 is outside the allowed range"},
           {replaced("at_rest = 13.5", "at_rest = 8.9"),
            "65 the sliding friction at 0 = 9 is outside the allowed range"},
           {replaced("[0.05, 7.5], [0.3, 6]", "[0.3, 6], [0.05, 7.5]"),
            "64 m.toml, line 17: the relative velocities of sliding increase: 0.05 does not follow 0.3"},
           {replaced("[0, 9], ", ""),
            "65 the first relative velocity of the sliding friction = 0.05 is outside the allowed range"},
           {replaced("[0.3, 6]", "[0.3]"), "64 m.toml, line 17: sliding is a force, a list of pairs"},
           {replaced("frequency = 3.6", ""),
            "64 m.toml, line 18: a load has a frequency or an angular_frequency"},
           {replaced("frequency = 3.6", "frequency = 0"),
            "65 a load's frequency = 0 is outside the allowed range"},
           {good + "[[load]]\nmass = 1\namplitude = 1\nfrequency = 3.60001\n",
            "64 m.toml: the loads' frequencies have no base frequency in common: "},
           {good + "[[load]]\nmass = 1\namplitude = 1\nangular_frequency = 1\n",
            "64 m.toml, line 22: the loads have frequencies or angular frequencies, all of them the same"},
           {"units = \"cgs\"\n" + good, "64 m.toml, line 1: units is \"SI\" or \"none\""},
           {"[[mass]]\nm = 1\n", "64 m.toml: there is no table [belt]"}}) {
    CAPTURE(text);
    const std::string found = refusal(text);
    CAPTURE(found);
    CHECK(found.starts_with(said));
  }
}

TEST_CASE("the machines that are shown are read, and what they do is proved") {
  int count = 0;
  const std::filesystem::path here(__FILE__);
  for (const auto& entry : std::filesystem::directory_iterator(
           here.parent_path().parent_path().parent_path() / "examples" / "machines")) {
    CAPTURE(entry.path());
    const Run result = stickslip_program(
        {"attractors", "--params", entry.path(), "--starts", "40", "--most-periods", "3000"});
    CHECK(result.code == exit_decided);
    CHECK(result.out.find("proved, stable") != std::string::npos);
    CHECK(result.out.find("not proved") == std::string::npos);
    ++count;
  }
  CHECK(count == 8);
}

TEST_CASE("what starts end on along a number of the file, and in a plane") {
  const TemporaryDirectory directory;
  const std::string file = directory / "machine.toml";
  std::ofstream(file) << good;
  const auto run = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all{"attractors", "--params", file};
    all.insert(all.end(), words.begin(), words.end());
    return stickslip_program(all);
  };
  const std::string csv = directory / "all.csv";
  const Run along = run({"--along", "spring.1.k", "-100..1200", "--values", "3", "--starts", "4", "--json",
                         "--csv", csv, "--out", directory / "along"});
  CHECK(along.code == exit_decided);
  const Json json = Json::parse(along.out);
  REQUIRE(json["points"].size() == 3);
  CHECK(json["points"][0]["outside"].get<std::string>().find("k = -100") != std::string::npos);
  CHECK(json["points"][0]["attractors"].empty());
  // At the file's value it is what is said of the file.
  const Json alone = Json::parse(run({"--starts", "4", "--json"}).out);
  const Json& last = json["points"][2]["attractors"];
  REQUIRE(last.size() == alone["attractors"].size());
  CHECK(last[0]["orbit"] == alone["attractors"][0]["orbit"]);
  CHECK(last[0]["once"].size() == last[0]["orbit"]["periods"].get<std::size_t>());
  const std::string table = stickslip::report::tools::read_file(csv);
  CHECK(table.starts_with("spring.1.k in N/m,attractor,share,kind,periods,word,stable,x1 in m,x2 in m,"));
  CHECK(table.find("-100,,,outside the domain,,,") != std::string::npos);
  CHECK(table.find(",1,1,periodic,2,OTS,yes,") != std::string::npos);
  CHECK(std::filesystem::exists(directory / "along/diagram.svg"));
  const Json points = Json::parse(
      run({"--along", "friction.sliding.2.1", "0.1..0.4", "--values", "2", "--starts", "2", "--json"})
          .out)["points"];
  CHECK(points[0]["attractors"].size() == 1);
  CHECK(points[1]["outside"].get<std::string>().find("more than the one before, 0.4") != std::string::npos);
  // In a plane each start ends where it ends alone, in the order that the file says.
  const Run plane =
      run({"--plane", "x2,x1'", "--pixels", "3", "--json", "--csv", csv, "--out", directory / "plane"});
  CHECK(plane.code == exit_decided);
  const Json basins = Json::parse(plane.out);
  CHECK(basins["plane"] == Json{"x2", "x1'"});
  REQUIRE(basins["at"].size() == 3);
  CHECK(basins["at"][2].size() == 3);
  CHECK(basins["from"][0] == basins["to"][0]);
  CHECK(basins["from"][1].get<double>() < basins["to"][1].get<double>());
  CHECK(basins["from"][2].get<double>() < basins["to"][2].get<double>());
  CHECK(basins["from"][3] == basins["to"][3]);
  const std::string starts = stickslip::report::tools::read_file(csv);
  CHECK(std::count(starts.begin(), starts.end(), '\n') == 10);
  CHECK(std::filesystem::exists(directory / "plane/basins.svg"));
  for (const auto& [words, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--plane", "x3,x1"}, "'x3,x1' is not two of x1, x2, x1', x2'"},
           {{"--plane", "x1,x2", "--starts", "3"}, "--starts is not for --plane"},
           {{"--plane", "x1,x2", "--through", "1,2"}, "are 4 numbers, not 2"},
           {{"--plane", "x1,x2", "--along", "belt.velocity", "0..1"}, "two questions"},
           {{"--values", "3"}, "--values is for --along and --plane"},
           {{"--along", "belt.speed", "0..1"}, "nothing stands at belt.speed"},
           {{"--along", "spring.1.k", "-3..-1", "--values", "2"}, "k = -1 is outside"}}) {
    const Run refused = run(words);
    CHECK(refused.code >= exit_usage);
    CHECK(refused.err.find(said) != std::string::npos);
  }
}

TEST_CASE("a number of the file by its path takes another value, and nothing else changes") {
  const auto with = [](const char * path, const Rational& value) {
    return cli::machine_in_tables(good, "m.toml", {{path, value}})->machine.oscillator;
  };
  const auto before = cli::machine_in_tables(good, "m.toml")->machine.oscillator;
  CHECK(with("mass.2.m", 3).masses == std::vector<Rational>{Rational("5/2"), 3});
  CHECK(with("spring.1.k", 1000).stiffness(0, 0) == 1450);
  CHECK(with("spring.1.c", 2).damping(0, 0) == 2);
  CHECK(with("belt.velocity", 7).V == 7);
  CHECK(with("friction.at_rest", 20).forward.at_rest == 20);
  CHECK(with("friction.sliding.2.2", 8).forward.sliding[0].slope == Rational(-20));
  CHECK(with("load.1.amplitude", 1).loads[0].cosine == 1);
  CHECK(with("load.1.frequency", 5).omega == 5);
  CHECK(with("frequency", 5).omega == 5);
  CHECK(with("frequency", 5).V == before.V);
  for (const auto& [path, value] :
       {std::pair("mass.2.m", "4/5"), std::pair("belt.velocity", "1/20"),
        std::pair("friction.sliding.3.1", "3/10"), std::pair("frequency", "18/5")}) {
    CAPTURE(path);
    CHECK(cli::value_in_tables(good, "m.toml", path) == parse_rational(value));
  }
  // Of several loads the frequencies vary together.
  const std::string two = good + "[[load]]\nmass = 1\namplitude = 2\nfrequency = 10.8\n";
  const auto faster = cli::machine_in_tables(two, "m.toml", {{"frequency", 4}})->machine.oscillator;
  CHECK(faster.omega == 4);
  CHECK(faster.loads[0].k == 1);
  CHECK(faster.loads[1].k == 3);
  const auto refused = [](const std::string& text, const std::string& path) -> std::string {
    try {
      (void)cli::machine_in_tables(text, "m.toml", {{path, 1}});
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refused(two, "load.2.frequency") ==
        "m.toml: of several loads the frequencies vary together: --along frequency A..B, the greatest that "
        "divides "
        "them all");
  for (const char * path :
       {"belt.speed", "mass.0.m", "mass.3.m", "spring.1", "belt", "", "mass", "mass.x.m",
        "friction.sliding.2", "belt.mass", "load.1.mass", "spring.1.between.2", "units"}) {
    CAPTURE(path);
    const std::string words = refused(good, path);
    CHECK(words.starts_with("m.toml"));
  }
  CHECK(refused(good, "belt.speed").find("nothing stands at belt.speed") != std::string::npos);
  // A value that takes the place of the file's is as large as that may be.
  CHECK_THROWS_AS((void)cli::machine_in_tables(good, "m.toml", {{"mass.1.m", parse_rational("1e300")}}),
                  UsageError);
  CHECK(refused(good, "belt.mass") == "m.toml: belt.mass is no number that can vary");
}

TEST_CASE("commands about a machine in tables: orbits, a branch, a motion, pages and JSON") {
  const TemporaryDirectory directory;
  const std::string file = directory / "machine.toml";
  std::ofstream(file) << good;
  const auto run = [&](Words words) {
    words.insert(words.end(), {"--params", file});
    const Run result = stickslip_program(words);
    CAPTURE(result.err);
    return result;
  };
  const Run attractors = run({"attractors", "--starts", "20"});
  CHECK(attractors.code == exit_decided);
  CHECK(attractors.out.find("2.5 kg, 0.8 kg; with dashpots") != std::string::npos);
  CHECK(attractors.out.find("OTS   proved, stable, |mu| =") != std::string::npos);
  CHECK(attractors.out.find("2 periods of the load") != std::string::npos);
  CHECK(attractors.out == run({"attractors", "--starts", "20", "--jobs", "1"}).out);

  const Run orbits = run({"orbits", "OTS", "--period", "2"});
  CHECK(orbits.code == exit_decided);
  CHECK(orbits.out.find("Orbit 1:  admissible") != std::string::npos);
  const Run none = run({"orbits", "OSOT", "--json"});
  CHECK(none.code == exit_undecided);
  CHECK(Json::parse(none.out).at("seen").get<std::string>().find("OTS with the period 2") !=
        std::string::npos);

  // The motion that begins where the orbit does returns to it.
  const Json orbit = Json::parse(run({"orbits", "OTS", "--json"}).out).at("orbits").at(0);
  CHECK(orbit.at("pieces") == "O1O2O3O2O1TS1S2S3S2S1");
  CHECK(orbit.at("stability") == "stable");
  std::string state;
  for (const Json& x : orbit.at("phases").at(0).at("state")) {
    state += (state.empty() ? "" : ",") + x.at("mid").get<std::string>();
  }
  const std::string table = directory / "motion.csv";
  const Run motion =
      run({"simulate", "--state=" + state, "--phi=" + orbit.at("theta").at("mid").get<std::string>(),
           "--periods", "2", "--csv", table, "--json"});
  CHECK(motion.code == exit_decided);
  const Words again{"simulate",
                    "--state=" + state,
                    "--phi=" + orbit.at("theta").at("mid").get<std::string>(),
                    "--periods",
                    "2",
                    "--csv",
                    "-"};
  CHECK(run(again).out == content(table));
  CHECK(run(with(again, {"--json"})).code == exit_usage);
  const Json end = Json::parse(motion.out);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(end.at("end").at("state").at(k).get<double>() ==
          doctest::Approx(end.at("start").at(k).get<double>()).epsilon(1e-7));
  }
  const std::string lines = content(table);
  CHECK(lines.starts_with("t in s,phase,x1 in m,x2 in m,x1' in m/s,x2' in m/s,r in N,u in N,E in J\n"));
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 402);

  const Run branch = run({"branch", "OTS", "--along", "load.1.frequency", "3.58..3.6", "--csv",
                          directory / "branch.csv", "--out", directory / "page"});
  CHECK(branch.code == exit_decided);
  CHECK(branch.out.find("the condition stick.upper is gained") != std::string::npos);
  CHECK(branch.out.find("  3.587822") != std::string::npos);
  for (const char * name : {"index.html", "branches.svg", "branches.json", "branches.csv"}) {
    CHECK(std::filesystem::exists(directory / "page/" + name));
  }
  const Run whole = run({"branch", "OTS", "--along", "spring.1.c", "0.59..0.61", "--without-gaps"});
  CHECK(whole.code == exit_decided);
  CHECK(whole.out.find("a curve without a gap") != std::string::npos);
  CHECK(whole.out.find("129      stable, and at all values between") != std::string::npos);
  const Words along_both{"branch",         "OTS",     "--along",    "belt.velocity",
                         "0.0495..0.0505", "--along", "spring.1.c", "0.59..0.61"};
  const Run box = run(with(along_both, {"--csv", directory / "box.csv", "--out", directory / "box"}));
  CHECK(box.code == exit_decided);
  CHECK(box.out.find("At all data in the box there is exactly one such motion near") != std::string::npos);
  CHECK(box.out.find("100 %       1      stable") != std::string::npos);
  CHECK(content(directory / "box.csv") ==
        "motion,belt.velocity from,belt.velocity to,spring.1.c from,spring.1.c "
        "to,existence,state,names,reason\n"
        "1,0.0495,0.0505,0.59,0.61,proved,stable,\"\",\"\"\n");
  for (const char * name : {"index.html", "box-1.svg", "box.json", "box.csv"}) {
    CHECK(std::filesystem::exists(directory / "box/" + name));
  }
  // Across r = u_r while it sticks; where the law's slopes change with a velocity.
  const Run across = run({"branch", "OTS", "--along", "friction.at_rest", "13.19..13.51", "--along",
                          "spring.1.c", "0.59..0.61", "--parts", "3"});
  CHECK(across.code == exit_undecided);
  CHECK(across.out.find("there, but what they are is undecided: stick.upper") != std::string::npos);
  const Run curved = run({"branch", "OTS", "--along", "friction.sliding.2.1", "0.049..0.051", "--along",
                          "spring.1.c", "0.59..0.61"});
  CHECK(curved.code == exit_decided);
  CHECK(curved.out.find("100 %") != std::string::npos);
  CHECK(run({"attractors", "--starts", "5", "--out", directory / "attractors"}).code == exit_decided);
  CHECK(run({"orbits", "OTS", "--out", directory / "orbits"}).code == exit_decided);
  for (const char * name : {"attractors/index.html", "attractors/portrait-1.svg",
                            "attractors/attractors.json", "orbits/portrait-1.svg", "orbits/orbits.json"}) {
    CHECK(std::filesystem::exists(directory / name));
  }
}

TEST_CASE("steady sliding of a machine in tables, and where its stability is lost") {
  const TemporaryDirectory directory;
  const std::string file = directory / "free.toml";
  std::ofstream(file) << good.substr(0, good.find("[[load]]"));
  const Run found = stickslip_program({"orbits", "S", "--params", file, "--json"});
  CHECK(found.code == exit_undecided);  // 0.05 m/s is where two pieces of the friction law meet
  CHECK(Json::parse(found.out)
            .at("steady_sliding")
            .at("friction")
            .at("mid")
            .get<std::string>()
            .starts_with("7.5000000"));
  const Run along = stickslip_program({"branch", "S", "--params", file, "--along", "spring.1.c", "0..40"});
  CAPTURE(along.out);
  CHECK(along.code == exit_undecided);
  const Run faster =
      stickslip_program({"branch", "S", "--params", file, "--along", "belt.velocity", "0.1..0.5"});
  CHECK(faster.out.find("where two pieces of the friction law meet") != std::string::npos);
  const Run attractors = stickslip_program({"attractors", "--params", file, "--starts", "4"});
  CHECK(attractors.out.find("steady sliding  S2, proved") != std::string::npos);
  check_refused({{{"orbits", "S", "--near", "0,0,0,0"}, exit_usage, "--near does not go with a machine"},
                 {{"simulate", "--state=1e400,0,0,0", "--time", "1"}, exit_domain, "a number of state = inf"},
                 {{"branch", "S", "--at", "1", "--along", "belt.velocity", "0.1..0.5"},
                  exit_usage,
                  "--at does not go with a machine"},
                 {{"branch", "S", "--along", "belt.velocity", "0.1..0.5", "--without-gaps"},
                  exit_usage,
                  "--without-gaps does not go with a machine"}},
                [&](const Words& words) {
                  return stickslip_program(with(words, {"--params", file}));
                });
}

TEST_CASE("which starts of one mass on a belt end in steady sliding") {
  const TemporaryDirectory directory;
  const std::string file = directory / "machine.toml";
  const std::string text =
      "units = \"none\"\n[[mass]]\nm = 1\n[[spring]]\nbetween = [0, 1]\nk = 1\nc = 0.1\n"
      "[belt]\nmass = 1\nvelocity = 1.5\n[friction]\nat_rest = 1\n"
      "sliding = {falls = \"exponentially\", from = 1, to = 0.5, over = 0.5}\n";
  std::ofstream(file) << text;
  const auto run = [&](const Words& words) {
    return stickslip_program(with(words, {"--params", file, "--basin=-2..2,0..2"}));
  };
  const Run told = run({"orbits", "S"});
  CHECK(told.code == exit_decided);
  CHECK(told.out.find("  share         0.30712613778160089") != std::string::npos);
  CHECK(told.out.find("  all others    proved to end on one cycle that sticks") != std::string::npos);
  const Json found = Json::parse(run({"orbits", "S", "--json", "--digits", "8"}).out);
  CHECK(found.at("command").get<std::string>().find("--basin=-2..2,0..2") != std::string::npos);
  const Json& basin = found.at("basin");
  CHECK(basin.at("starts").at("x") == Json{"-2", "2"});
  CHECK(basin.at("verdict") == "proved");
  CHECK(basin.at("others") == "proved");
  CHECK(basin.at("share").at("mid").get<std::string>().starts_with("0.307126"));
  CHECK(basin.at("multiplier").at("mid").get<std::string>().starts_with("1.492750"));
  // Beyond the range there is none; both ends of the range are found, and together by the manual
  // (doc/any_machine.md).
  const Run along = run({"branch", "S", "--along", "belt.velocity", "1.1..1.152"});
  CHECK(along.code == exit_decided);
  for (const char * line : {"1.1 to 1.1511875  none", "steady sliding is unstable",
                            "1.15129254650     the basin of steady sliding is gained: the closed motion"}) {
    CAPTURE(along.out);
    CHECK(along.out.find(line) != std::string::npos);
  }
  const Json ends = Json::parse(run({"branch", "S", "--along", "belt.velocity", "1.83..1.99", "--json"}).out)
                        .at("basins")
                        .at("ends");
  REQUIRE(ends.size() == 1);
  CHECK(ends[0].at("at_belt") == true);
  CHECK(ends[0].at("gained") == false);
  // A rectangle has two sides; and it is for steady sliding of one mass on a smooth law without a load.
  const std::string two = directory / "two.toml", loaded = directory / "loaded.toml",
                    pieces = directory / "pieces.toml";
  std::ofstream(two) << text << "[[mass]]\nm = 1\n";
  std::ofstream(loaded) << text << "[[load]]\nmass = 1\nconstant = 1\n";
  std::ofstream(pieces) << text.substr(0, text.find("sliding")) << "sliding = [[0, 1], [1, 0.5]]\n";
  const auto with_file = [](const std::string& machine) {
    return [machine](const Words& words) { return stickslip_program(with(words, {"--params", machine})); };
  };
  check_refused({{{"orbits", "S", "--basin", "0..1"}, exit_usage, "basin: '0..1' is no rectangle of starts"},
                 {{"orbits", "S", "--basin", "0..1,2..1"}, exit_usage, "basin: '2..1' does not rise"},
                 {{"orbits", "S", "--basin", "0..1,2"}, exit_domain, "the starts' velocities = 2..2"},
                 {{"orbits", "ST", "--basin", "0..1,0..1"}, exit_usage, "--basin is for steady sliding, S"}},
                with_file(file));
  check_refused({{{"orbits", "S", "--basin", "0..1,0..1"}, exit_domain, "for one mass without a load"}},
                with_file(two));
  check_refused({{{"orbits", "S", "--basin", "0..1,0..1"}, exit_domain, "for one mass without a load"}},
                with_file(loaded));
  check_refused({{{"orbits", "S", "--basin", "0..1,0..1"}, exit_domain, "a smooth law"}}, with_file(pieces));
  CHECK(stickslip_program({"orbits", "symmetric", "--example", "S", "--basin", "0..1,0..1"})
            .err.find("--basin is for steady sliding, S, of a machine in tables") != std::string::npos);
}

TEST_CASE("from how far around motions come back, and where a box of starts is") {
  const std::filesystem::path here(__FILE__);
  const std::string file =
      here.parent_path().parent_path().parent_path() / "examples" / "machines" / "two_harmonics.toml";
  const auto run = [&](const Words& words) { return stickslip_program(with(words, {"--params", file})); };
  const Run told = run({"orbits", "ST", "--neighbourhood"});
  CHECK(told.code == exit_decided);
  for (const char * part :
       {"  at load phase ", "recovers if off by", "half width of all", "\nrecovers  proved: "}) {
    CAPTURE(part);
    CHECK(told.out.find(part) != std::string::npos);
  }
  const Json orbit = Json::parse(run({"orbits", "ST", "--neighbourhood", "--json"}).out).at("orbits").at(0);
  const Json& set = orbit.at("neighbourhood");
  CHECK(set.at("verdict") == "proved");
  CHECK(set.at("phase") == "slip");
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(set.at("alone").at(k).get<double>() > 0);
    CHECK(set.at("alone").at(k) <= set.at("half_widths").at(k));
    CHECK(set.at("S").at(k).size() == 2);
  }
  // Without the option there is none.
  CHECK(!Json::parse(run({"orbits", "ST", "--json"}).out).at("orbits").at(0).contains("neighbourhood"));
  // A plane around the orbit where it is at load phase 0.
  const TemporaryDirectory directory;
  const std::string picture = directory / "plane.svg";
  const Json start =
      Json::parse(run({"attractors", "--starts", "1", "--json"}).out).at("attractors").at(0).at("state");
  const std::string through = start.at(0).dump() + "," + start.at(1).dump();
  const Run plane =
      run({"attractors", "--plane", "x1,x1'", "--through=" + through, "--window", "1e-4,1e-4", "--pixels",
           "3", "--neighbourhood", "--json", "--plot", picture, "--out", directory / "page"});
  CHECK(plane.code == exit_decided);
  const Json pixels = Json::parse(plane.out);
  CHECK(pixels.at("proved") == 1.0);
  CHECK(pixels.at("proved_at") == Json{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  CHECK(std::filesystem::exists(picture));
  CHECK(stickslip::report::tools::read_file(directory / "page/index.html")
            .find("Proved of 9 of 9 pixels, 100 %") != std::string::npos);

  const Run box = run({"simulate", "--state=" + through, "--set=1e-4,1e-4", "--periods", "2"});
  CHECK(box.code == exit_decided);
  CHECK(box.out.find("of all of the starts") != std::string::npos);
  const Json after =
      Json::parse(run({"simulate", "--state=" + through, "--set=1e-4,1e-4", "--periods", "2", "--json"}).out);
  CHECK(after.at("proved").get<double>() == doctest::Approx(1));
  CHECK(after.at("parts").at(0).at("then").size() == 2);
  check_refused(
      {{{"attractors", "--window", "1,1"}, exit_usage, "--window is for --along and --plane"},
       {{"attractors", "--along", "belt.velocity", "1..2", "--neighbourhood"},
        exit_usage,
        "--neighbourhood is not for --along"},
       {{"attractors", "--plane", "x1,x1'", "--window", "1,-1"}, exit_usage, "window: two numbers above 0"},
       {{"orbits", "S", "--neighbourhood"},
        exit_usage,
        "--neighbourhood does not go with a machine in tables"},
       {{"simulate", "--state=0,0", "--set=1"}, exit_usage, "set: "},
       {{"simulate", "--state=0,0", "--set=1,-1"}, exit_domain, "half width"},
       {{"simulate", "--state=0,0", "--set=1,1", "--every", "1"}, exit_usage, "--every is for one motion"}},
      [&](const Words& words) { return run(words); });
  check_refused({{{"orbits", "symmetric", "--example", "S", "--us=0.02+-1e-9", "--neighbourhood"},
                  exit_usage,
                  "a neighbourhood is proved at numbers"},
                 {{"orbits", "nonsticking", "--chi", "0.3", "--eta", "4", "--us", "0.1", "--V", "0.1",
                   "--omega", "0.6", "--p", "1", "--neighbourhood"},
                  exit_usage,
                  "depends on ur"},
                 {{"simulate", "--example", "S", "--set=1,1,1"}, exit_usage, "set: "}},
                [](const Words& words) { return stickslip_program(words); });
  for (const Words& words : {Words{"simulate", "--state=0,0,0,0", "--set=1,1,1,1"},
                             Words{"attractors", "--plane", "x1,x2", "--window", "1,1"},
                             Words{"attractors", "--plane", "x1,x2", "--neighbourhood", "--json"}}) {
    CAPTURE(words.front());
    const Run refused = run_with(machine_O, words);
    CHECK(refused.code == exit_usage);
    CHECK(refused.err.find("in these: add --units si") != std::string::npos);
  }
}

TEST_CASE("sets of starts of the paper's oscillator are followed as those of a machine in tables" *
          doctest::test_suite("nightly") * doctest::skip()) {
  const Words start{"simulate", "--example", "O", "--state=1.344,3.70,-0.41,0.99", "--time", "20", "--json"};
  const Json set = Json::parse(stickslip_program(with(start, {"--set=1e-3,1e-3,0,1e-3"})).out);
  CHECK(set.at("proved").get<double>() == doctest::Approx(1));
  CHECK(set.at("command").get<std::string>().starts_with("stickslip simulate --chi 0.2 --eta 4 "));
  const Json end = Json::parse(stickslip_program(start).out).at("end").at("state");
  bool held = false;
  for (const Json& part : set.at("parts")) {
    bool here = true;
    for (std::size_t k = 0; k < 4; ++k) {
      const Json& range = part.at("then").at(k);
      const double mid = std::stod(range.at("mid").get<std::string>());
      const double rad = std::stod(range.at("rad").get<std::string>());
      here = here && std::abs(end.at(k).get<double>() - mid) <= rad;
    }
    held = held || here;
  }
  CHECK(held);
  const Json plane = Json::parse(
      stickslip_program({"attractors", "--example", "O", "--plane", "x1,x2", "--window", "1e-4,1e-4",
                         "--through", "1.3447,3.699,-0.4126,1", "--pixels", "2", "--neighbourhood", "--json"})
          .out);
  CHECK(plane.at("proved") == 1.0);
}

TEST_CASE("sets of starts of a machine in SI units are followed in these") {
  const Words start{"simulate", "--state=1.344e-3,3.70e-3,-4.1e-3,9.9e-3", "--periods", "3", "--units", "si"};
  const Json set = Json::parse(run_with(machine_O, with(start, {"--set=1e-7,1e-7,0,1e-6", "--json"})).out);
  CHECK(set.at("proved").get<double>() == doctest::Approx(1));
  CHECK(set.at("machine").at("units") == "SI");
  const Run one = run_with(machine_O, with(start, {"--csv", "-"}));
  std::string line;
  std::istringstream lines(one.out);
  for (std::string next; std::getline(lines, next);) {
    line = next;
  }
  std::vector<double> end;  // x1, x2, x1', x2'
  std::istringstream cells(line);
  std::string cell;
  for (int k = 0; std::getline(cells, cell, ','); ++k) {
    if (k >= 2 && k < 6) {
      end.push_back(std::stod(cell));
    }
  }
  REQUIRE(end.size() == 4);
  // The simulation takes omega and V rounded to 20 digits.
  CHECK(std::ranges::any_of(set.at("parts"), [&](const Json& part) {
    bool here = true;
    for (std::size_t k = 0; k < 4; ++k) {
      const Json& range = part.at("then").at(k);
      here = here && std::abs(end[k] - std::stod(range.at("mid").get<std::string>())) <=
                         std::stod(range.at("rad").get<std::string>());
    }
    return here;
  }));
  const Run result = run_with(machine_O, {"simulate", "--orbit", "symmetric:1", "--set=1e-7,1e-7,0,1e-6",
                                          "--units", "si", "--periods", "1"});
  CHECK(result.code == exit_usage);
  CHECK(result.err.find("the friction at rest of that orbit is another one") != std::string::npos);
  // A set without any part that is proved says 0.
  const Run none = run_with(
      machine_O, {"simulate", "--state=0,0,0,0", "--set=1,1,1,1", "--units", "si", "--periods", "1"});
  CHECK(none.code == exit_undecided);
  CHECK(none.out.find("of 0 % of the starts, in 0 parts") != std::string::npos);
  const Json plane =
      Json::parse(run_with(machine_O, {"attractors", "--units", "si", "--plane", "x1,x2", "--window",
                                       "1e-7,1e-7", "--through", "1.3447e-3,3.699e-3,-4.126e-3,9.9e-3",
                                       "--pixels", "2", "--neighbourhood", "--json"})
                      .out);
  CHECK(plane.at("proved") == 1.0);
}

TEST_CASE("a family's stable orbits have neighbourhoods, of the machine whose ur is theirs") {
  const Run text = stickslip_program({"orbits", "overshooting", "--example", "O", "--neighbourhood"});
  CHECK(text.code == exit_decided);
  const std::size_t recovers = text.out.find("recovers if off by");
  REQUIRE(recovers != std::string::npos);
  CHECK(text.out.find("recovers if off by", recovers + 1) == std::string::npos);
  CHECK(text.out.find("of the machine with ur = 0.458") != std::string::npos);
}

TEST_CASE(
    "motions of the paper's oscillator are proved over a box of its data, or of its values in SI units") {
  const TemporaryDirectory directory;
  const std::string file = directory / "flat.toml";
  std::ofstream(file)
      << "m1 = 4\nm2 = 1\nk1 = 1000\nk2 = 600\nfriction_force_sliding = 6\n"
         "friction_force_at_rest = 10\nbelt_velocity = 0.2\nload_amplitude = 20\nload_frequency = 4\n";
  const Words in_SI{
      "branch",    "OS", "--params", file, "--along", "m1", "3.98..4.02", "--along", "friction_force_sliding",
      "5.95..6.05"};
  const Run flat = stickslip_program(with(in_SI, {"--units", "si", "--json"}));
  CHECK(flat.code == exit_decided);
  const Json box = Json::parse(flat.out);
  CHECK(box.at("data").at(1).at("path") == "friction_force_sliding");
  CHECK(box.at("machine").at("units") == "SI");
  for (const Json& part : box.at("motions").at(0).at("parts")) {
    CHECK(part.at("state") == "stable");
  }
  const Words of_O{"branch",  "OTS", "--example",     "O", "--along", "us", "0.04999..0.05001",
                   "--along", "V",   "0.9999..1.0001"};
  const Run O = stickslip_program(of_O);
  CHECK(O.code == exit_decided);
  CHECK(O.out.find("motions   1 at us = 0.05, V = 1\n") != std::string::npos);
  CHECK(O.out.find("Motion 1: proved, stable, |mu| = 0.9148") != std::string::npos);
  // Load and mass go with p/eta and 1/eta.
  const Run quotients = stickslip_program({"branch", "OTS", "--example", "O", "--along", "eta",
                                           "3.999..4.001", "--along", "p", "0.0499..0.0501"});
  CHECK(quotients.code == exit_decided);
  CHECK(quotients.out.find("100 %") != std::string::npos);
  const Json again = Json::parse(stickslip_program(with(of_O, {"--json"})).out);
  CHECK(again.at("command").get<std::string>().find("--along us 0.04999..0.05001") != std::string::npos);
  check_refused(
      {{in_SI, exit_usage, "in these: add --units si"},
       {with(of_O, {"--along", "us", "0.1..0.2"}), exit_usage, "us and us vary together: give one of them"},
       {{"branch", "OTS", "--example", "O", "--along", "us", "0.04..0.05", "--along", "phi", "0..1"},
        exit_usage,
        "phi is none of chi, eta, us, V, omega, p, ur"},
       {{"branch", "symmetric", "--example", "S", "--along", "us", "0.04..0.05", "--along", "V", "0.9..1"},
        exit_usage,
        "several --along are for a word of phases such as OTS"}});
}

TEST_CASE("what is known of a whole box is not lost in many parts of it" * doctest::test_suite("nightly") *
          doctest::skip()) {
  const std::filesystem::path here(__FILE__);
  const std::string brake = here.parent_path().parent_path().parent_path() / "examples/machines/brake.toml";
  const Run box =
      stickslip_program({"branch", "STST", "--params", brake, "--along", "belt.velocity", "0.0938..0.0949",
                         "--along", "mass.1.m", "0.59999..0.60001", "--all", "--parts", "500", "--json"});
  CHECK(box.code == exit_undecided);  // the stability
  const Json parts = Json::parse(box.out).at("motions").at(0).at("parts");
  CHECK(parts.size() > 500);
  CHECK(parts.size() < 5000);
  for (const Json& part : parts) {
    CAPTURE(part);
    CHECK(part.at("existence") == "proved");
  }
}

TEST_CASE("what does not go with a machine in tables is refused in a sentence") {
  const TemporaryDirectory directory;
  const std::string file = directory / "machine.toml";
  std::ofstream(file) << good;
  const std::string free = directory / "free.toml";
  std::ofstream(free) << good.substr(0, good.find("[[load]]"));
  const auto about = [](const std::string& machine) {
    return [machine](const Words& words) { return stickslip_program(with(words, {"--params", machine})); };
  };
  check_refused(
      {{{"orbits", "symmetric"}, exit_usage, "for a word of phases such as OTS, not for a family"},
       {{"orbits", "OTS", "--certify", directory / "c"}, exit_usage, "--certify does not go with a machine"},
       {{"orbits", "OTS", "--near", "1,2,3"},
        exit_usage,
        "near: the positions of the 2 masses and then their velocities are 4 numbers, not 3"},
       {{"simulate"}, exit_usage, "the start is missing: --state"},
       {{"simulate", "--state=0,0,0,0", "--periods", "2", "--time", "3"},
        exit_usage,
        "--periods and --time do not go together"},
       {{"simulate", "--state=0,0,0,0", "--units", "si"}, exit_usage, "says what its units are"},
       {{"attractors", "--plane", "x1,x3"}, exit_usage, "is not two of x1, x2, x1', x2'"},
       {{"attractors", "--chi", "0.5"}, exit_usage, "--chi does not go with it"},
       {{"branch", "OTS"}, exit_usage, "what varies is missing: --along PATH A..B"},
       {{"branch", "OTS", "--along", "belt.speed", "1..2"}, exit_usage, "nothing stands at belt.speed"},
       {{"branch", "OTS", "--along", "belt.velocity", "1..2", "--at", "3"},
        exit_usage,
        "at: belt.velocity = 3 is not in the interval"},
       {{"branch", "OTS", "--along", "friction.sliding.2.1", "0.2..0.4"},
        exit_domain,
        "more than the one before"},
       {{"branch", "OTS", "--along", "friction.at_rest", "5..12"}, exit_domain, "friction at rest"},
       {{"branch", "OTS", "--along", "belt.velocity", "0.04..0.05", "--along", "friction.at_rest", "5..14"},
        exit_domain,
        "friction at rest"},
       {{"branch", "OTS", "--along", "belt.velocity", "0.04..0.05", "--along", "belt.velocity", "0.04..0.05"},
        exit_usage,
        "belt.velocity and belt.velocity vary together"},
       {{"branch", "OTS", "--along", "frequency", "3..4", "--along", "load.1.frequency", "3..4"},
        exit_usage,
        "frequency and load.1.frequency vary together"},
       {{"branch", "OTS", "--along", "belt.velocity", "0.05..0.05", "--along", "spring.1.c", "0.5..0.6"},
        exit_usage,
        "'0.05..0.05' does not rise"},
       {{"branch", "OTS", "--along", "belt.velocity", "0.04..0.05", "--along", "spring.1.c", "0.5..0.6",
         "--at", "0.05"},
        exit_usage,
        "--at is for one --along"},
       {{"branch", "OTS", "--along", "belt.velocity", "0.04..0.05", "--parts", "9"},
        exit_usage,
        "--parts is for several --along"},
       {{"branch", "S", "--along", "belt.velocity", "0.04..0.05", "--along", "spring.1.c", "0.5..0.6"},
        exit_usage,
        "--along is for one number here, not for 2 of them"},
       {{"attractors", "--along", "belt.velocity", "0.04..0.05", "--along", "spring.1.c", "0.5..0.6"},
        exit_usage,
        "--along is for one number here, not for 2 of them"},
       {{"atlas", "symmetric"}, exit_usage, "is a machine in tables: that is for stickslip orbits WORD"}},
      about(file));
  check_refused({{{"simulate", "--state=0,0,0,0"}, exit_usage, "--time T says how long"},
                 {{"simulate", "--state=0,0,0,0", "--periods", "3"}, exit_usage, "has no load that varies"},
                 {{"orbits", "ST", "--period", "2"}, exit_usage, "--period counts periods of the load"}},
                about(free));
  CHECK(stickslip_program({"simulate", "--state=0,0,0,0", "--time", "3", "--params", free}).code ==
        exit_decided);
}
