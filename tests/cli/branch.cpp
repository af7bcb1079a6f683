// stickslip branch from outside: exit codes, sentences, JSON, tables.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "tests/cli/machines.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using Json = nlohmann::json;

TEST_CASE("branch: questions that are none are named") {
  check_refused({
      {{"branch"}, exit_usage, "family"},
      {{"branch", "asymmetric", "--example", "S", "--omega", "0.5..0.6"}, exit_usage, "'asymmetric'"},
      {{"branch", "symmetric", "--example", "S"}, exit_usage, "interval A..B"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5..0.6", "--along", "omega", "0.6..0.7"},
       exit_usage,
       "omega is given twice"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5..0.6", "--p", "0..1"},
       exit_usage,
       "omega and p"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.6..0.5"}, exit_usage, "does not rise"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5.."},
       exit_usage,
       "omega: '0.5..' is not an interval A..B"},
      {{"branch", "symmetric", "--example", "S", "--omega", "a..b"}, exit_usage, "omega: 'a'"},
      {{"branch", "symmetric", "--example", "S", "--ur", "0.1..0.2"}, exit_usage, "ur is not given"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5..0.6", "--period", "2"},
       exit_usage,
       "--period is for words"},
      {{"branch", "OO", "--example", "O", "--ur", "0.43..0.44"}, exit_usage, "OO"},
      {{"branch", "OTS", "--example", "O", "--ur", "0..0.44"}, exit_domain, "ur"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5..0.6", "--at", "0.7"},
       exit_usage,
       "at: omega"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5..0.6", "--chi", "0.5+-0.1"},
       exit_usage,
       "all other parameters are exact"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5..0.6", "--plot", "a.jpg"},
       exit_usage,
       "a.jpg"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5..0.6", "--out", "/no/such/place"},
       exit_io,
       "/no/such"},
      {{"branch", "symmetric", "--example", "S", "--chi", "0.5..1"}, exit_domain, "chi = 1"},
      {{"branch", "symmetric", "--example", "S", "--omega", "-1..1"}, exit_domain, "omega = -1"},
  });
}

TEST_CASE("branch: the table, the JSON, the CSV and the page of a short interval") {
  const TemporaryDirectory directory;
  const std::string csv = (directory.path() / "branches.csv").string();
  const auto page = directory.path() / "page";
  const Run json = stickslip_program({"branch", "symmetric", "--example", "S", "--omega", "0.586..0.588",
                                      "--csv", csv, "--out", page, "--json"});
  CHECK(json.code == exit_decided);
  const Json data = Json::parse(json.out);
  CHECK(data["parameter"] == "omega");
  CHECK(data["branches"].size() == 4);
  CHECK(data["unresolved"].empty());
  int changes = 0;
  for (const Json& branch : data["branches"]) {
    for (const Json& end : branch["ends"]) {
      CHECK(end["kind"] == "interval");
    }
    for (const Json& change : branch["changes"]) {
      ++changes;
      CHECK(change["kind"] == "stability");
      CHECK(change["multiplier"] == "real -1");
      CHECK(change["verdict"] == "proved");
    }
  }
  CHECK(changes == 1);
  std::ifstream table(csv);
  std::string names;
  std::getline(table, names);
  CHECK(names == "omega,branch,piece,state,tau,T,phi,x10,x20,xdot10");
  CHECK(content(page / "branches.json") == json.out);
  CHECK(content(page / "branches.csv") == content(csv));
  const std::string html = content(page / "index.html");
  CHECK(html.ends_with("</html>\n"));
  CHECK(html.find("<tex>") == std::string::npos);
  CHECK(html.find("id=\"branch-4\"") != std::string::npos);
  CHECK(html.find("stability real -1") != std::string::npos);
  for (const char * picture : {"branches.svg", "branches-narrow.svg"}) {
    CHECK(html.find(std::string("\"") + picture + "\"") != std::string::npos);
    CHECK(content(page / picture).find("</svg>") != std::string::npos);
  }
  CHECK(content(page / "branches.pdf").starts_with("%PDF"));
  const Run text = stickslip_program({"branch", "symmetric", "--example", "S", "--omega", "0.586..0.588"});
  CHECK(text.code == exit_decided);
  CHECK(text.out.find("stability real -1") != std::string::npos);
}

TEST_CASE("branch: across a resonance that nothing comes through") {
  const Words words{
      "branch", "nonsticking", "--eta", "4",     "--us",           "0.1",     "--V",
      "0.1",    "--p",         "1",     "--chi", "0.2785..0.2787", "--omega", "0.4239250651584028",
      "--at",   "0.2785"};
  const Run json = stickslip_program([&] {
    Words with = words;
    with.push_back("--json");
    return with;
  }());
  CHECK(json.code == exit_decided);
  const Json list = Json::parse(json.out);
  REQUIRE(list["unresolved"].size() == 1);
  CHECK(list["unresolved"][0]["resonance"] == true);
  CHECK(list["unresolved"][0]["chi"].is_object());
  CHECK(list["branches"][0]["ends"][1]["kind"] == "stopped");
  CHECK(list["branches"][0]["ends"][1]["resolved"] == false);
  CHECK(stickslip_program(words).out.find("resonance 3 omega = omega2") != std::string::npos);
}

TEST_CASE("branch: overshooting orbits across a resonance, in text and JSON") {
  const Words words{"branch", "overshooting", "--example", "O", "--omega", "0.9991..1.001"};
  const Run json = stickslip_program(with(words, {"--json"}));
  CHECK(json.code == exit_decided);
  const Json list = Json::parse(json.out);
  CHECK(list["complete"] == false);
  REQUIRE(list["unresolved"].size() == 1);
  CHECK(list["unresolved"][0]["resonance"] == true);
  CHECK(list["unresolved"][0]["omega"].is_object());
  CHECK(list["unresolved"][0]["reason"] == "the resonance omega = 1: not looked into next to it");
  CHECK(stickslip_program(words).out.find("resonance omega = 1:") != std::string::npos);
}

TEST_CASE("branch: a closed branch is said to be one") {
  const Words words{"branch", "overshooting", "--chi", "0.3351",    "--eta",   "5.424",
                    "--us",   "0.3421",       "--V",   "0.184",     "--omega", "1.037",
                    "--p",    "0.02293",      "--ur",  "0.6..0.63", "--at",    "0.6165"};
  const Json list = Json::parse(stickslip_program(with(words, {"--json"})).out);
  REQUIRE(list["branches"].size() == 1);
  CHECK(list["branches"][0]["closed"] == true);
  CHECK(list["branches"][0]["changes"].size() == 2);
  for (const Json& end : list["branches"][0]["ends"]) {
    CHECK(end["kind"] == "closed");
    CHECK(end["resolved"] == true);
  }
  const Run text = stickslip_program(words);
  CHECK(text.code == exit_decided);
  CHECK(text.out.find("Branch 1:  a closed curve, from 0.616500000000 once round") != std::string::npos);
}

TEST_CASE("branch: of a word the admissible orbits, one of the list, or one near a state") {
  const Words word{"branch", "OTS", "--example", "O", "--ur", "0.4375..0.4385", "--at", "0.438"};
  const auto with = [&](const Words& more) {
    Words arguments = word;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return stickslip_program(arguments);
  };
  const auto branches = [&](Words more) {
    more.emplace_back("--json");
    return Json::parse(with(more).out).at("branches").size();
  };
  CHECK(with({}).out.find("near 1 known orbit at ur = 0.438, and not near 1 that are") != std::string::npos);
  CHECK(branches({}) == 1);
  CHECK(branches({"--all"}) == 2);
  CHECK(branches({"--orbit", "1"}) == 1);
  CHECK(branches({"--orbit", "2"}) == 1);
  CHECK(branches({"--near", "0.5,0.9,0.4,0.7"}) == 1);
  check_refused({{{"branch", "OTS", "--example", "O", "--ur", "0.4375..0.4385", "--orbit", "3"},
                  exit_usage,
                  "--orbit 3: of OTS there are 2 orbits at ur = 0.438"},
                 {{"branch", "symmetric", "--example", "S", "--omega", "0.58..0.59", "--all"},
                  exit_usage,
                  "for words of phases"},
                 {{"branch", "symmetric", "--example", "S", "--omega", "0.58..0.59", "--without-gaps"},
                  exit_usage,
                  "--without-gaps is for words of a machine in tables"}});
}

TEST_CASE("branch: of a word, and what is not looked for is said") {
  const Run json = stickslip_program(
      {"branch", "OTS", "--example", "O", "--ur", "0.4375..0.4385", "--at", "0.438", "--all", "--json"});
  CHECK(json.code == exit_decided);
  const Json data = Json::parse(json.out);
  CHECK(data["family"] == "OTS");
  CHECK(data["complete"] == false);
  CHECK(data["branches"].size() == 2);
  CHECK(data["branches"][0]["samples"][0].contains("t3"));
  const Run text =
      stickslip_program({"branch", "OTS", "--example", "O", "--ur", "0.4375..0.4385", "--at", "0.438"});
  CHECK(text.code == exit_decided);
  CHECK(text.out.find("other branches are not looked for") != std::string::npos);
  CHECK(text.out.find("condition crossing") != std::string::npos);
}

namespace {

// Example O as a machine, whose orbit is admissible at its own load; the friction at rest is a result at phi.
Words along_machine(const char * name, const char * interval, Words more = {}) {
  Words words{"branch", "overshooting", "--along", name, interval};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

double middle_of(const Json& ball) {
  return std::stod(ball["mid"].get<std::string>());
}

// The places where something changes, in order.
std::vector<double> changes_of(const Json& list) {
  std::vector<double> places;
  for (const Json& branch : list["branches"]) {
    for (const Json& change : branch["changes"]) {
      places.push_back(middle_of(change["at"]));
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace

TEST_CASE("branch: for which load frequencies the orbit of a machine in SI units persists") {
  const TemporaryDirectory directory;
  const auto page = directory.path() / "page";
  const Machine machine = without(machine_O, {"load_frequency"});
  const Words asked = along_machine("load_frequency", "0.99..1.01");
  const Run json = run_with(machine, with(asked, {"--json", "--units", "si", "--out", page}));
  CAPTURE(json.err);
  REQUIRE(json.code == exit_decided);
  const Json list = Json::parse(json.out);
  CHECK(list["parameter"] == "load_frequency");
  CHECK(list["interval"] == Json{"0.99", "1.01"});
  CHECK(list["parameters"]["k1"] == "320");
  CHECK(list["parameters"]["friction_sliding"] == "0.02");
  CHECK(list["units"] == "si");
  CHECK(list["complete"] == true);
  // The same along omega = 2 pi f/10, next to which the ends are decimals.
  const Run plain = stickslip_program({"branch", "overshooting", "--chi", "0.2", "--eta", "4", "--us", "0.05",
                                       "--V", "1", "--p", "0.05", "--ur", "0.4585", "--omega",
                                       "0.622035345410779..0.634601716025138", "--json"});
  REQUIRE(plain.code == exit_decided);
  const Json dimensionless = Json::parse(plain.out);
  const std::vector<double> here = changes_of(list), there = changes_of(dimensionless);
  REQUIRE(here.size() == there.size());
  REQUIRE(!here.empty());
  for (std::size_t k = 0; k < here.size(); ++k) {
    CHECK(here[k] == doctest::Approx(there[k] * 10 / 6.283185307179586).epsilon(1e-9));
  }
  // A time of 1 is 0.1 s, a length 1 mm, a velocity 0.01 m/s.
  const Json& one = list["branches"][0]["samples"][0];
  const Json& same = dimensionless["branches"][0]["samples"][0];
  CHECK(one["tau"].get<double>() == doctest::Approx(0.1 * same["tau"].get<double>()).epsilon(1e-3));
  CHECK(one["x20"].get<double>() == doctest::Approx(1e-3 * same["x20"].get<double>()).epsilon(1e-3));
  CHECK(one["xdot10"].get<double>() == doctest::Approx(1e-2 * same["xdot10"].get<double>()).epsilon(1e-3));
  const std::string html = content(page / "index.html");
  CHECK(html.find("load_frequency in Hz") != std::string::npos);
  CHECK(html.find("--along load_frequency 0.99..1.01") != std::string::npos);
  CHECK(content(page / "branches.csv").starts_with("load_frequency,branch"));
  const Run text = run_with(machine, asked);
  CHECK(text.out.find("load_frequency in Hz from 0.99 to 1.01") != std::string::npos);
}

TEST_CASE("branch: a mass moves several data of a machine, and the branch follows their path") {
  const Run json = run_with(machine_O, along_machine("m1", "3.98..4.02", {"--json"}));
  CAPTURE(json.err);
  REQUIRE(json.code == exit_decided);
  const Json list = Json::parse(json.out);
  CHECK(list["complete"] == true);
  REQUIRE(list["branches"].size() > 0);
  // The orbits of the machine with that mass: eta, V and omega are others.
  std::size_t compared = 0;
  for (const Json& branch : list["branches"]) {
    const Json& samples = branch["samples"];
    for (const Json& sample : {samples.front(), samples[samples.size() / 2], samples.back()}) {
      const std::string mass = sample["value"].dump();
      const Json there =
          Json::parse(run_with(with(machine_O, "m1", mass), {"orbits", "overshooting", "--json"}).out);
      const double Omega = std::sqrt(400 / sample["value"].get<double>());
      for (const Json& orbit : there["orbits"]) {
        const bool same =
            std::abs(middle_of(orbit["tau"]) / Omega / sample["tau"].get<double>() - 1) < 1e-9 &&
            std::abs(1e-3 * middle_of(orbit["x20"]) / sample["x20"].get<double>() - 1) < 1e-9;
        compared += same ? 1 : 0;
      }
    }
  }
  CHECK(compared == 3 * list["branches"].size());
  // A word at the friction at rest that the machine has, which k1 moves as all lengths.
  const Run word = run_with(machine_O, {"branch", "OTS", "--along", "k1", "318..322", "--all", "--json"});
  CAPTURE(word.err);
  CHECK(word.code == exit_decided);
  CHECK(Json::parse(word.out)["branches"].size() == 2);
}

TEST_CASE(
    "branch: an engineer's machine from 7 to 8 Hz, within a tolerance, and with masses and springs within 5 "
    "%") {
  const Machine machine{{"m1", "0.37"},
                        {"m2", "1.9"},
                        {"k1", "8300"},
                        {"k2", "2650.5"},
                        {"friction_force_at_rest", "21.7"},
                        {"friction_force_sliding", "13.1"},
                        {"belt_velocity", "0.213"},
                        {"load_amplitude", "44.4"},
                        {"load_frequency", "5.15"}};
  const TemporaryDirectory directory;
  const std::string csv = (directory.path() / "a.csv").string(), plot = (directory.path() / "a.svg").string();
  const auto branches = [&](const Machine& file, Words more) {
    const Run run = run_with(file, with({"branch", "symmetric", "--units", "si", "--json"}, more));
    CAPTURE(run.err);
    REQUIRE(run.code == exit_decided);
    Json list = Json::parse(run.out);
    CHECK(list["complete"] == true);
    CHECK(list["units"] == "si");
    REQUIRE(list["branches"].size() == 1);
    return list;
  };
  const Json wide = branches(machine, {"--along", "load_frequency", "7..8", "--csv", csv, "--plot", plot});
  CHECK(wide["parameter"] == "load_frequency");
  CHECK(wide["interval"] == Json{"7", "8"});
  CHECK(content(csv).starts_with("load_frequency,branch"));
  CHECK(content(plot).find("</svg>") != std::string::npos);
  Json narrow = branches(with(machine, "load_frequency", "\"7.5+-0.01\""), {});
  Json typed = branches(machine, {"--along", "load_frequency", "7.49..7.51"});
  narrow.erase("command");  // names the file
  typed.erase("command");
  CHECK(narrow == typed);
  for (const auto& [name, interval] :
       {std::pair("m1", Json{"0.3515", "0.3885"}), std::pair("m2", Json{"1.805", "1.995"}),
        std::pair("k1", Json{"7885", "8715"}), std::pair("k2", Json{"2517.975", "2783.025"})}) {
    const Json list = branches(with(machine, name, "\"" + machine.at(name) + "+-5%\""), {});
    CHECK(list["parameter"] == name);
    CHECK(list["interval"] == interval);
    // The orbit of the machine with that value.
    const Json& samples = list["branches"][0]["samples"];
    const Json& sample = samples[samples.size() / 2];
    const Json there = Json::parse(
        run_with(with(machine, name, sample["value"].dump()), {"orbits", "symmetric", "--json"}).out);
    REQUIRE(there["orbits"].size() == 1);
    for (const auto& [of, unit] :
         {std::pair("tau", "time"), std::pair("x20", "length"), std::pair("xdot10", "velocity")}) {
      CHECK(middle_of(there["orbits"][0][of]) * middle_of(there["machine"]["units"][unit]) ==
            doctest::Approx(sample[of].get<double>()).epsilon(1e-9));
    }
  }
}

TEST_CASE("branch: what may be along a value of a machine") {
  for (const auto& [arguments, code, text] :
       {std::tuple(along_machine("frequency", "1..2"), exit_usage, "load_frequency"),
        std::tuple(along_machine("load_phase", "0..1"), exit_usage, "load_phase"),
        std::tuple(along_machine("load_frequency", "2..1"), exit_usage, "does not rise"),
        std::tuple(along_machine("load_frequency", "1"), exit_usage, "not an interval A..B"),
        std::tuple(along_machine("load_frequency", "-1..1"), exit_domain, "load_frequency"),
        std::tuple(along_machine("friction_force_sliding", "0.01..0.02"), exit_usage, "does not go with"),
        std::tuple(along_machine("omega", "0.5..0.6"), exit_usage, "does not go with"),
        std::tuple(along_machine("load_frequency", "1..2", {"--example", "O"}), exit_usage, "--example")}) {
    const Run run = run_with(machine_O, arguments);
    CAPTURE(run.err);
    CHECK(run.code == code);
    CHECK(is_one_sentence(run.err, text));
  }
  check_refused({{along_machine("load_frequency", "1..2"), exit_usage, "--params"}});
}

TEST_CASE("branch: a range in the file is what it is along") {
  const Words asked{"branch", "overshooting", "--json"};
  const auto json = [](const Run& run) {
    INFO(run.err);
    REQUIRE(run.code == exit_decided);
    Json data = Json::parse(run.out);
    data.erase("command");  // names the file
    return data;
  };
  const Json typed = json(run_with(machine_O, along_machine("m1", "3.98..4.02", {"--json"})));
  for (const char * range : {"\"3.98..4.02\"", "\"4+-0.02\"", "\"4+-0.5%\""}) {
    CHECK(json(run_with(with(machine_O, "m1", range), asked)) == typed);
  }
  // What is typed replaces it; two are refused; so is what is no range.
  CHECK(json(run_with(with(machine_O, "m1", "\"1..2\""), along_machine("m1", "3.98..4.02", {"--json"}))) ==
        typed);
  const auto refused = [&](const Machine& machine, const Words& words, const char * text) {
    const Run run = run_with(machine, words);
    CHECK(run.code == exit_usage);
    INFO(run.err);
    CHECK(is_one_sentence(run.err, text));
  };
  refused(with(with(machine_O, "m1", "\"3..4\""), "k1", "\"320+-1\""), asked,
          "k1 and m1 are both intervals: a branch is along one");
  refused(with(machine_O, "k1", "\"320+-1\""), along_machine("m1", "3.98..4.02"), "both intervals");
  refused(with(machine_O, "m1", "\"4..3\""), asked, "m1");
  refused(machine_O, asked, "a branch needs one parameter as an interval");
  // Dimensionless data likewise.
  const Machine data{
      {"chi", "0.5"}, {"eta", "3.8"}, {"us", "0.02"}, {"V", "1"}, {"omega", "\"0.586..0.588\""},
      {"p", "0.05"}};
  const Words symmetric{"branch", "symmetric", "--json"};
  CHECK((json(run_with(data, symmetric)) ==
         json(stickslip_program(with(symmetric, {"--example", "S", "--omega", "0.586..0.588"})))));
  refused(with(data, "p", "\"0.1..0.2\""), symmetric, "omega and p are both intervals");
}
