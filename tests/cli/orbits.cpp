// stickslip orbits from outside: exit codes, sentences, JSON.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;

namespace {

using Json = nlohmann::json;

Run orbits(Words arguments) {
  arguments.insert(arguments.begin(), "orbits");
  return stickslip_program(arguments);
}

void check_orbits_refused(const std::vector<Refusal>& refusals) {
  check_refused(refusals, orbits);
}

}  // namespace

TEST_CASE("what is missing, misplaced or no number is a usage error that names it") {
  check_orbits_refused({
      {{}, exit_usage, "family"},
      {{"frob"}, exit_usage, "frob"},
      {{"symmetric"}, exit_usage, "missing: --chi, --eta, --us, --V, --omega, --p; give them"},
      {{"overshooting", "--chi", "1/2", "--V", "1"}, exit_usage, "--eta, --us, --omega, --p, --phi or --ur;"},
      {{"symmetric", "--chi", "1/2", "--eta", "2", "--us", "1", "--V", "1", "--p", "1"},
       exit_usage,
       "missing: --omega; give it"},
      {{"symmetric", "--example", "Q"}, exit_usage, "'Q'"},
      {{"symmetric", "--example", "S", "--ur", "0.2"}, exit_usage, "ur"},
      {{"symmetric", "--example", "S", "--phi", "0"}, exit_usage, "phi"},
      {{"overshooting", "--example", "S"}, exit_usage, "exactly one of phi and ur"},
      {{"overshooting", "--example", "O", "--phi", "0", "--ur", "1"}, exit_usage, "exactly one"},
      {{"nonsticking", "--example", "P", "--phi", "1"}, exit_usage, "phi"},
      {{"symmetric", "--example", "S", "--chi", "abc"}, exit_usage, "chi: 'abc'"},
      {{"symmetric", "--example", "S", "--chi", "1/0"}, exit_usage, "1/0"},
      {{"symmetric", "--example", "S", "--chi", "0.5+-"}, exit_usage, "chi"},
      {{"symmetric", "--example", "S", "--chi", "0.5+--1"}, exit_usage, "chi"},
      {{"symmetric", "--example", "S", "--digits", "0"}, exit_usage, "digits"},
      {{"symmetric", "--example", "S", "--digits", "ten"}, exit_usage, "digits"},
      {{"symmetric", "--example", "S", "--plot", "a.jpg"}, exit_usage, "a.jpg"},
      {{"symmetric", "--example", "S", "--jobs", "0"}, exit_usage, "jobs: '0'"},
      {{"symmetric", "--example", "S", "--jobs", "2x"}, exit_usage, "jobs: '2x'"},
      {{"symmetric", "--example", "S", "--jobs", "100000"}, exit_usage, "from 1 to 1024"},
      {{"symmetric", "--example", "S", "--frob"}, exit_usage, "--frob"},
  });
}

TEST_CASE("parameters outside the domain are named with value and allowed range") {
  const Words S{"symmetric", "--example", "S"};
  check_orbits_refused({
      {with(S, {"--chi", "1.5"}), exit_domain, "chi = 1.5 is outside the allowed range: 0 < chi < 1"},
      {with(S, {"--chi", "0"}), exit_domain, "chi = 0"},
      {with(S, {"--chi", "0.5+-0.5"}), exit_domain, "chi = 0"},
      {with(S, {"--eta", "-1"}), exit_domain, "eta = -1"},
      {with(S, {"--us", "0"}), exit_domain, "us = 0"},
      {with(S, {"--V", "-1"}), exit_domain, "V = -1"},
      {with(S, {"--omega", "0"}), exit_domain, "omega = 0"},
      {with(S, {"--p", "-0.1"}), exit_domain, "p = -0.1"},
      {{"nonsticking", "--example", "P", "--ur", "0.05"}, exit_domain, "ur = 0.05"},
  });
}

TEST_CASE("the examples are complete and decided, and JSON is all that is printed") {
  const std::vector<Words> questions = {
      {"symmetric", "--example", "S"},
      {"overshooting", "--example", "O"},
      {"nonsticking", "--example", "P"},
      {"nonsticking", "--example", "P", "--ur", "0.2"},
  };
  for (Words question : questions) {
    CHECK(orbits(question).code == exit_decided);
    question.emplace_back("--json");
    const Run result = orbits(question);
    CHECK(result.code == exit_decided);
    CHECK(result.err.empty());
    const Json json = Json::parse(result.out);
    CHECK(json.at("family") == question.front());
    CHECK(json.at("complete") == true);
    CHECK(json.at("orbits").size() >= 2);
  }
}

TEST_CASE("the list is the same for any number of threads") {
  for (const char * letter : {"O", "S"}) {
    const Words question{letter[0] == 'O' ? "overshooting" : "symmetric", "--example", letter, "--json"};
    const Run alone = orbits(with(question, {"--jobs", "1"}));
    CHECK(alone.code == exit_decided);
    CHECK(orbits(question).out == alone.out);
    CHECK(orbits(with(question, {"--jobs", "1000"})).out == alone.out);
  }
}

TEST_CASE("an undecided orbit is exit code 2") {
  const Run result = orbits({"nonsticking", "--example", "P", "--p", "1+-1e-2"});
  CHECK(result.code == exit_undecided);
  CHECK(result.out.find("split p first") != std::string::npos);
}

TEST_CASE(
    "a box of parameters with the friction given: proved where it is small, where to split where it is not") {
  const Run small = orbits({"overshooting", "--example", "O", "--ur", "0.4589+-1e-6"});
  CHECK(small.code == exit_decided);
  const Run wide = orbits({"overshooting", "--example", "O", "--ur", "0.4589+-1e-1"});
  CHECK(wide.code == exit_undecided);
  CHECK(wide.out.find("first ur") != std::string::npos);
}

TEST_CASE("a box of parameters that may hold a resonance is not decided, whatever its middle has") {
  const Words data{"--chi", "9/13", "--eta", "169/36"};  // omega1 = 1/2, omega2 = 2
  for (const auto& [family, example] :
       {std::pair("symmetric", "S"), {"overshooting", "O"}, {"nonsticking", "P"}}) {
    const Run near = orbits(with({family, "--example", example, "--omega", "0.51+-0.02"}, data));
    CHECK(near.code == exit_undecided);
    CHECK(near.out.find("1 omega = omega1") != std::string::npos);
  }
  const Run twice = orbits(with({"nonsticking", "--example", "P", "--omega", "0.2501+-0.001"}, data));
  CHECK(twice.code == exit_undecided);
  CHECK(twice.out.find("2 omega = omega1") != std::string::npos);
  check_orbits_refused({{{"symmetric", "--example", "S", "--V", "0.5+-1"}, exit_domain, "V = -0.5"}});
}

TEST_CASE("a box that reaches down to omega = 0, where there are resonances without number") {
  for (const char * omega : {"0.5+-0.49999999999999", "0.5+-0.4999999999999999999999999999999999999999999"}) {
    const Run result = orbits({"nonsticking", "--example", "P", "--omega", omega});
    CHECK(result.code == exit_undecided);
    CHECK(result.out.find("1 omega = omega1") != std::string::npos);
    CHECK(result.out.find("2 omega = omega1, and further multiples") != std::string::npos);
    CHECK(result.out.find("3 omega = omega1") == std::string::npos);
    CHECK(orbits({"symmetric", "--example", "S", "--omega", omega}).code == exit_undecided);
  }
}

TEST_CASE("degenerate data: a precise answer or a precise refusal, for each family") {
  const Words O{"overshooting", "--example", "O"};
  const Words S{"symmetric", "--example", "S"};
  const Words P{"nonsticking", "--example", "P"};
  // omega1 = 1/2, omega2 = 2.
  const Words half{"--chi", "9/13", "--eta", "169/36", "--omega", "1/2"};
  const Run families = orbits(with(P, {"--chi", "9/13", "--eta", "169/36", "--omega", "1/4"}));
  CHECK(families.code == exit_decided);
  CHECK(families.out.find("with such an oscillation added") != std::string::npos);
  const Run moving = orbits(with(P, {"--chi", "9/13", "--eta", "169/36", "--omega", "1/4", "--V", "0.1"}));
  CHECK(moving.code == exit_undecided);
  CHECK(moving.out.find("2 omega is a natural frequency") != std::string::npos);
  check_orbits_refused({
      {with(S, half), exit_domain, "omega = 0.5 is outside the allowed range: not a natural frequency"},
      {with(O, half), exit_domain, "omega = 0.5 is outside the allowed range: not a natural frequency"},
      {with(P, half), exit_domain, "omega = 0.5 is outside the allowed range: not a natural frequency"},
      {with(S, {"--V", "0"}), exit_domain, "V = 0"},
      {with(O, {"--V", "-0.5"}), exit_domain, "V = -0.5"},
      {with(O, {"--us", "0"}), exit_domain, "us = 0"},
      {with(P, {"--us", "0"}), exit_domain, "us = 0"},
      {with(O, {"--ur", "0.01"}), exit_domain, "ur = 0.01"},
      {with(O, {"--ur", "0.4", "--p", "0"}), exit_domain, "p = 0"},
      {with(O, {"--chi", "1"}), exit_domain, "chi = 1"},
      {with(P, {"--chi", "0"}), exit_domain, "chi = 0"},
      {with(O, {"--phi", "east"}), exit_usage, "phi: 'east'"},
  });
  struct Answer {
    Words arguments;
    int code;
    std::size_t count;
  };
  const std::vector<Answer> answers = {
      {with(S, {"--p", "0"}), exit_decided, 2},
      {with(O, {"--p", "0"}), exit_decided, 2},
      {with(P, {"--p", "0"}), exit_decided, 0},
      {with(P, {"--p", "0", "--V", "0.1"}), exit_decided, 0},
      {with(S, {"--omega", "1"}), exit_decided, 0},
      {with(O, {"--omega", "1"}), exit_decided, 0},
      {with(P, {"--omega", "1"}), exit_decided, 0},
      {with(S, {"--chi", "0.0001"}), exit_decided, 0},
      {with(S, {"--chi", "0.9999"}), exit_decided, 4},
      {with(O, {"--chi", "0.0001"}), exit_decided, 0},
      {with(P, {"--chi", "0.9999"}), exit_decided, 8},
      // A load's phase is any real number, and means the same a turn later.
      {with(O, {"--phi", "6.283185307179586"}), exit_decided, 2},
  };
  for (const Answer& answer : answers) {
    const Run result = orbits(with(answer.arguments, {"--json"}));
    CAPTURE(result.out);
    CHECK(result.code == answer.code);
    const Json json = Json::parse(result.out);
    CHECK(json.at("orbits").size() == answer.count);
    CHECK(json.at("complete") == (answer.code == exit_decided));
  }
}

TEST_CASE("a parameter file gives the same answer as options, and options go before it") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "p.toml";
  std::ofstream(file) << "# an oscillator\nchi = 0.5  # ratio\neta = \"19/5\"\nus = 0.02\nV = 1\n"
                         "omega = 0.6\np = 0.05\n";
  const std::string expected = orbits({"symmetric", "--example", "S", "--json"}).out;
  CHECK(orbits({"symmetric", "--params", file, "--json"}).out == expected);
  CHECK(orbits({"symmetric", "--params", file, "--p", "0.06", "--json"}).out != expected);
  const std::vector<std::pair<std::string, std::string>> broken = {
      {"kappa = 1\n", "kappa"}, {"[orbits]\nchi = 0.5\n", "section"}, {"chi = [1, 2]\n", "chi"}};
  for (const auto& [text, named] : broken) {
    std::ofstream(file) << text;
    const Run result = orbits({"symmetric", "--params", file});
    CHECK(result.code == exit_usage);
    CHECK(is_one_sentence(result.err, named));
  }
  CHECK(orbits({"symmetric", "--params", temporary.path() / "missing"}).code == exit_io);
}

TEST_CASE(
    "one file with phi and ur serves every family, what is a result of one is said, on options refused") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "p.toml", plain = temporary.path() / "q.toml";
  const std::string data = "chi = 0.2\neta = 4\nus = 0.05\nV = 1\nomega = 0.6289\np = 0.05\n";
  std::ofstream(plain) << data;
  std::ofstream(file) << data << "phi = 1\nur = 0.4589\n";
  struct Question {
    Words arguments, same;
    std::string said;
  };
  const std::vector<Question> questions{
      {{"symmetric"}, {}, ": ur is not taken: ur is not given for symmetric orbits"},
      {{"symmetric"}, {}, ": phi is not taken: phi is not given for symmetric orbits"},
      {{"overshooting"}, {"--ur", "0.4589"}, ": phi is not taken: with ur it is a result"},
      {{"overshooting", "--ur", "0.45"}, {}, ": phi is not taken: with ur it is a result"},
      {{"overshooting", "--phi", "1"}, {}, ": ur is not taken: with --phi it is a result"},
      {{"nonsticking"}, {"--ur", "0.4589"}, ": phi is not taken: phi is not given for non-sticking"},
      {{"OTS"}, {"--ur", "0.4589"}, ": phi is not taken: the load is cos(omega t)"},
  };
  for (const Question& question : questions) {
    const Run result = orbits(with(question.arguments, {"--params", file, "--json"}));
    CAPTURE(result.err);
    CHECK(result.err.find(question.said) != std::string::npos);
    const Run same = orbits(with(with(question.arguments, question.same), {"--params", plain, "--json"}));
    CHECK(same.err.empty());
    CHECK(result.out == same.out);
    CHECK(result.code == same.code);
  }
  check_orbits_refused({
      {{"symmetric", "--params", plain, "--ur", "1"}, exit_usage, "ur is not given for symmetric"},
      {{"nonsticking", "--params", plain, "--phi", "1"}, exit_usage, "phi is not given for non-sticking"},
      {{"OTS", "--params", file, "--phi", "1"}, exit_usage, "phi is not given"},
  });
  std::ofstream(file) << data << "phi = east\nur = 0.4589\n";
  check_orbits_refused({{{"symmetric", "--params", file}, exit_usage, "phi: 'east'"}});
}

TEST_CASE(
    "admissible orbits come first and in full, formal solutions in a line each unless all are asked for") {
  const Words O{"overshooting", "--example", "O"};
  const Run brief = orbits(O), full = orbits(with(O, {"--all"}));
  CHECK(brief.code == exit_decided);
  CHECK(full.code == exit_decided);
  const auto has = [](const Run& run, const std::string& part) {
    return run.out.find(part) != std::string::npos;
  };
  CHECK(has(brief, "Orbit 2 of 2:  admissible"));
  CHECK_FALSE(has(brief, "Orbit 1 of 2"));
  CHECK(has(brief, "\n  1      2.63206  4.84765  2.51104  -0.205576  ur, 12, slip and 5 more\n"));
  CHECK(has(full, "Orbit 1 of 2:  not admissible: ur, 12, slip, 18,"));
  CHECK(full.out.find("Orbit 2 of 2") < full.out.find("Orbit 1 of 2"));
  CHECK_FALSE(has(full, "Formal solutions"));
  CHECK(orbits(with(O, {"--all", "--json"})).out == orbits(with(O, {"--json"})).out);
  CHECK(has(orbits({"symmetric", "--example", "S"}), "belongs to another u_r"));
  const Run wide = orbits(with(O, {"--ur", "0.4589+-1e-1"}));
  CHECK(wide.code == exit_undecided);
  CHECK(has(wide, "not proved for the whole box\n"));
  CHECK_FALSE(has(wide, "no orbits"));
}

TEST_CASE("each admissible orbit has a certificate, and what can have none is said") {
  const TemporaryDirectory directory;
  const std::filesystem::path out = directory.path() / "certificates";
  const Run S = orbits({"symmetric", "--example", "S", "--certify", out.string()});
  CHECK(S.code == exit_decided);
  CHECK(S.err.find("Certificates of 4 orbits") != std::string::npos);
  CHECK(std::filesystem::exists(out / "Claim_symmetric_1.v"));
  CHECK(std::filesystem::exists(out / "Krawczyk.v"));
  const std::string never = (directory.path() / "never").string();
  const Run free = orbits({"nonsticking", "--chi", "0.5", "--eta", "2", "--us", "0.1", "--V", "0.1",
                           "--omega", "0.5", "--p", "1", "--certify", never});
  CHECK(free.err.find("nonsticking.2 has none: of an orbit that never sticks ur is a datum") !=
        std::string::npos);
  check_orbits_refused({
      {{"OTS", "--example", "O", "--ur", "0.46", "--certify", never}, exit_usage, "not for a word"},
      {{"symmetric", "--example", "S", "--chi", "0.5+-0.001", "--certify", never},
       exit_usage,
       "exact parameters"},
      {{"symmetric", "--example", "S", "--certify", "/usr"},
       exit_usage,
       "'/usr' holds files that are not certificates"},
  });
  CHECK_FALSE(std::filesystem::exists(never));
}

TEST_CASE("a plot is written whole or not at all") {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "orbit.svg";
  CHECK(orbits({"overshooting", "--example", "O", "--plot", file}).code == exit_decided);
  CHECK(std::filesystem::file_size(file) > 1000);
  const Run missing = orbits({"overshooting", "--example", "O", "--plot", file + ".d/a.svg"});
  CHECK(missing.code == exit_io);
  CHECK(is_one_sentence(missing.err, file));
  CHECK(missing.out.empty());
  CHECK(temporary.count() == 1);
}

TEST_CASE("without gnuplot there is a sentence instead of a plot") {
  const TemporaryDirectory temporary;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", temporary.path().c_str(), 1);
  const Run result = orbits({"symmetric", "--example", "S", "--plot", temporary.path() / "a.svg"});
  ::setenv("PATH", path.c_str(), 1);
  CHECK(result.code == exit_io);
  CHECK(is_one_sentence(result.err, "gnuplot"));
  CHECK(temporary.count() == 0);
}
