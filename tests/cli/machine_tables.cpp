// Machines in tables, from outside: what they do, exactly read, and what is refused.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/machine_tables.hpp"
#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;

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

TEST_CASE("what is no machine in tables is said with its line") {
  CHECK(refusal(good).empty());
  for (const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
           {replaced("m = 2.5", "m = 2,5"), "64 m.toml, line 2: "},
           {replaced("m = 2.5", "m = 0x19"), "64 m.toml, line 2: m: '0x19' is not a number"},
           {replaced("[0, 9],", "[0, 9], [\"\u00b5\", 9], [0.01, 8.7],"),
            "64 m.toml, line 17: a relative velocity: "},
           {replaced("m = 2.5", "m = true"), "64 m.toml, line 2: m is no number"},
           {replaced("m = 2.5", "m = inf"), "64 m.toml, line 2: m: 'inf' is not a number"},
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
           {replaced("at_rest = 13.5", "at_rest = 9"),
            "65 the sliding friction at 0 = 9 is outside the allowed range"},
           {replaced("[0.05, 7.5], [0.3, 6]", "[0.3, 6], [0.05, 7.5]"),
            "64 m.toml, line 17: the relative velocities of sliding increase: 0.05 does not follow 0.3"},
           {replaced("[0, 9], ", ""),
            "65 the first relative velocity of the sliding friction = 0.05 is outside the allowed range"},
           {replaced("[0.3, 6]", "[0.3]"), "64 m.toml, line 17: sliding is a force or a list of pairs"},
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
        {"attractors", "--params", entry.path(), "--starts", "60", "--most-periods", "3000"});
    CHECK(result.code == exit_decided);
    CHECK(result.out.find("proved, stable") != std::string::npos);
    CHECK(result.out.find("not proved") == std::string::npos);
    ++count;
  }
  CHECK(count == 4);
}

TEST_CASE("attractors of a machine in tables are proved, and other commands say that it is none for them") {
  const TemporaryDirectory directory;
  const std::string file = directory / "machine.toml";
  std::ofstream(file) << good;
  const Run result = stickslip_program({"attractors", "--params", file, "--starts", "20"});
  CAPTURE(result.err);
  CHECK(result.code == exit_decided);
  CHECK(result.out.find("2.5 kg, 0.8 kg; with dashpots") != std::string::npos);
  CHECK(result.out.find("OTS   proved, stable, |mu| =") != std::string::npos);
  CHECK(result.out.find("2 periods of the load") != std::string::npos);
  CHECK(result.out ==
        stickslip_program({"attractors", "--params", file, "--starts", "20", "--jobs", "1"}).out);
  for (const Words& words : std::vector<Words>{{"orbits", "OTS"},
                                               {"orbits", "symmetric"},
                                               {"simulate"},
                                               {"attractors", "--json"},
                                               {"attractors", "--plane", "x1,x2"},
                                               {"attractors", "--chi", "0.5"}}) {
    Words all = words;
    all.insert(all.end(), {"--params", file});
    const Run refused = stickslip_program(all);
    CAPTURE(refused.err);
    CHECK(refused.code == exit_usage);
    CHECK(refused.err.find("machine in tables") != std::string::npos);
  }
}
