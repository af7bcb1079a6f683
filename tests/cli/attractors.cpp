// stickslip attractors and stickslip orbits WORD from outside: exit codes, sentences, JSON.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using Json = nlohmann::json;

TEST_CASE("words that are none, and options that do not go with them, are named") {
  check_refused({
      {{"orbits", "SOS", "--example", "O"}, exit_usage, "S follows S from its end to its start"},
      {{"orbits", "TT", "--example", "O"}, exit_usage, "T follows T"},
      {{"orbits", "S", "--example", "O", "--period", "2"}, exit_usage, "--period"},
      {{"orbits", "T", "--example", "O", "--near", "0,0,0,0"}, exit_usage, "--near"},
      {{"orbits", "T", "--example", "O", "--chi", "2"}, exit_domain, "chi = 2"},
      {{"orbits", "TS", "--example", "O", "--near", "0,0,0,0", "--phi", "x"}, exit_usage, "phi: 'x'"},
      {{"orbits", "OTX", "--example", "O"}, exit_usage, "'OTX'"},
      {{"orbits", "OTS", "--example", "O", "--period", "0"}, exit_usage, "period: '0'"},
      {{"orbits", "OTS", "--example", "O", "--period", "two"}, exit_usage, "period: 'two'"},
      {{"orbits", "OTS", "--example", "O", "--near", "1,2,3"}, exit_usage, "near: '1,2,3'"},
      {{"orbits", "OTS", "--example", "O", "--near", ""}, exit_usage, "near: ''"},
      {{"orbits", "OTS", "--example", "O", "--phi", "0"}, exit_usage, "phi"},
      {{"orbits", "OTS", "--example", "O", "--chi", "0.2+-1e-5"}, exit_usage, "interval"},
      {{"orbits", "S", "--example", "O", "--plot", "a.svg"}, exit_usage, "--plot"},
      {{"orbits", "OTS"}, exit_usage, "--chi"},
      {{"orbits", "symmetric", "--example", "S", "--period", "2"}, exit_usage, "'symmetric'"},
      {{"orbits", "OTS", "--example", "O", "--ur", "0.01"}, exit_domain, "ur = 0.01"},
      {{"orbits", "OTS", "--example", "O", "--p", "0", "--ur", "1"}, exit_domain, "p = 0"},
      {{"orbits", "OTS", "--example", "O", "--near", "1e200,0,0,0"}, exit_domain, "1e+200"},
      {{"attractors"}, exit_usage, "--chi"},
      {{"attractors", "--example", "O", "--starts", "0"}, exit_usage, "starts: '0'"},
      {{"attractors", "--example", "O", "--starts", "-3"}, exit_usage, "starts: '-3'"},
      {{"attractors", "--example", "O", "--starts", "100001"}, exit_usage, "from 1 to 100000"},
      {{"attractors", "--example", "O", "--seed", "east"}, exit_usage, "seed: 'east'"},
      {{"attractors", "--example", "O", "--most-periods", "1e3"}, exit_usage, "most-periods: '1e3'"},
      {{"attractors", "--example", "O", "--chi", "1"}, exit_domain, "chi = 1"},
      {{"attractors", "--example", "O", "--us", "0"}, exit_domain, "us = 0"},
      {{"orbits", "ST", "--chi", "0.375", "--eta", "4/3", "--us", "0.1", "--V", "1", "--omega", "0.5", "--p",
        "0.1", "--ur", "0.2"},
       exit_domain,
       "omega = 0.5"},
  });
}

TEST_CASE(
    "a load at a natural frequency that the friction cannot hold drives all motions beyond all bounds") {
  const Run run = stickslip_program({"attractors", "--chi", "0.375", "--eta", "4/3", "--us", "0.1", "--V",
                                     "1", "--omega", "0.5", "--p", "1", "--ur", "0.2"});
  CHECK(run.code == exit_decided);
  CHECK(run.out.find("grows without bound") != std::string::npos);
}

TEST_CASE("attractors in JSON: all starts are placed, and what is periodic is proved") {
  const Words question{"attractors", "--example", "P", "--starts", "40"};
  Words as_json = question;
  as_json.emplace_back("--json");
  const Run result = stickslip_program(as_json);
  CHECK(result.code == exit_decided);
  CHECK(result.err.empty());
  const Json json = Json::parse(result.out);
  CHECK(json.at("starts") == 40);
  CHECK(json.at("seed") == 1);
  CHECK(json.at("parameters").at("ur") == "0.2996");
  int count = 0;
  for (const Json& a : json.at("attractors")) {
    count += a.at("count").get<int>();
    CHECK(a.at("state").size() == 4);
    if (a.at("kind") == "periodic") {
      CHECK(a.at("verdict") == "proved");
      CHECK(a.at("stability") == "stable");
      CHECK(a.at("durations").size() == a.at("word").get<std::string>().size());
      CHECK(a.at("multipliers").size() == 4);
    }
  }
  CHECK(count == 40);
  CHECK(json.at("attractors").at(0).at("word") == "OSOTSOST");
  CHECK(json.at("attractors").at(0).at("period") == 3);
  const Run text = stickslip_program(question);
  CHECK(text.code == exit_decided);
  CHECK(text.out.find("OSOTSOST") != std::string::npos);
  as_json.insert(as_json.end(), {"--jobs", "1"});
  CHECK(stickslip_program(as_json).out == result.out);
}

TEST_CASE("an orbit of a word in JSON, any rotation of the word, and the command that gives it again") {
  const Run result = stickslip_program({"orbits", "TSO", "--example", "O", "--json"});
  CHECK(result.code == exit_decided);
  const Json json = Json::parse(result.out);
  CHECK(json.at("word") == "OTS");
  CHECK(json.at("complete") == true);
  REQUIRE(json.at("orbits").size() == 2);
  CHECK(json.at("orbits").at(0).at("admissible") == false);
  const Json& orbit = json.at("orbits").at(1);
  CHECK(orbit.at("period") == 1);
  CHECK(orbit.at("durations").size() == 3);
  CHECK(orbit.at("admissible") == true);
  CHECK(orbit.at("stability") == "stable");
  for (const char * key : {"Theta", "phi", "z10", "z20", "zdot10", "x10", "x20", "xdot10", "ur"}) {
    CHECK(orbit.at(key).contains("mid"));
  }
  CHECK(orbit.at("conditions").at(0).contains("phase"));
}

TEST_CASE(
    "motions of one phase: some slip at S, none overshoots, some stick at P, and none on a moving belt") {
  const auto asked = [](const char * word, const char * example) {
    const Run result = stickslip_program({"orbits", word, "--example", example, "--json"});
    CHECK(result.code == exit_decided);
    return Json::parse(result.out);
  };
  const Json slip = asked("S", "S");
  CHECK(slip.at("verdict") == "proved");
  CHECK(slip.at("stability") == "neutral");
  CHECK(std::stod(slip.at("forced").at("mid").get<std::string>()) == doctest::Approx(0.54).epsilon(0.01));
  CHECK(std::stod(slip.at("room").at("mid").get<std::string>()) == doctest::Approx(0.46).epsilon(0.01));
  CHECK(asked("O", "S").at("verdict") == "refuted");
  CHECK(asked("T", "S").at("verdict") == "refuted");
  const Json stick = asked("T", "P");
  CHECK(stick.at("verdict") == "proved");
  CHECK(std::stod(stick.at("room").at("mid").get<std::string>()) == 0.0496);
  const Run text = stickslip_program({"orbits", "T", "--example", "P"});
  CHECK(text.out.find("neutral, not stable") != std::string::npos);
  // p/eta = ur
  CHECK(stickslip_program({"orbits", "T", "--example", "P", "--ur", "0.25"}).code == exit_undecided);
}

TEST_CASE("a start on an unstable orbit, at the phase of the load there, leads to that orbit") {
  const Json list = Json::parse(stickslip_program({"orbits", "ST", "--example", "S", "--json"}).out);
  const auto unstable = std::find_if(list.at("orbits").begin(), list.at("orbits").end(),
                                     [](const Json& o) { return o.value("stability", "") == "unstable"; });
  REQUIRE(unstable != list.at("orbits").end());
  const auto text = [&](const char * key) { return unstable->at(key).at("mid").get<std::string>(); };
  const std::string state = text("x10") + "," + text("x20") + "," + text("xdot10") + ",1";
  const auto near = [&](const std::string& phi) {
    const Run run =
        stickslip_program({"orbits", "ST", "--example", "S", "--near", state, "--phi", phi, "--json"});
    return Json::parse(run.out).at("orbits");
  };
  // Before a time of load phase 0, and after one.
  for (const double turn : {0.0, 2 * std::acos(-1.0)}) {
    const Json found = near(fmt::format("{:.17g}", std::stod(text("phi")) + turn));
    REQUIRE(found.size() == 1);
    CHECK(found.at(0).at("z10") == unstable->at("z10"));
  }
}

TEST_CASE(
    "the page of attractors has their pictures, the basins and the data, that of a diagram the diagram") {
  const TemporaryDirectory directory;
  const auto page = directory.path() / "page";
  const Words at_P{"attractors", "--example", "P", "--starts", "10"};
  CHECK(stickslip_program(with(at_P, {"--out", page})).code == exit_decided);
  const std::string html = content(page / "index.html");
  CHECK(html.ends_with("</html>\n"));
  CHECK(html.find("OSOTSOST") != std::string::npos);
  CHECK(html.find("<tex>") == std::string::npos);
  for (const char * file : {"portrait-1.svg", "portrait-1-narrow.svg", "basins.svg"}) {
    CHECK(html.find(std::string("\"") + file + "\"") != std::string::npos);
    CHECK(content(page / file).find("</svg>") != std::string::npos);
  }
  Words as_json = with(at_P, {"--json"});
  CHECK(content(page / "attractors.json") == stickslip_program(as_json).out);
  const auto along = directory.path() / "along";
  CHECK(stickslip_program(with(at_P, {"--along", "ur", "0.28..0.3", "--values", "3", "--out", along})).code ==
        exit_decided);
  CHECK(content(along / "index.html").find("\"diagram.svg\"") != std::string::npos);
  CHECK(content(along / "diagram.svg").find("</svg>") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(along / "attractors.json"));
  const Run nowhere = stickslip_program(with(at_P, {"--out", "/no/such/place"}));
  CHECK(nowhere.code == exit_io);
}

TEST_CASE("orbits of a word that are not admissible stand in a line each, unless all are asked for in full") {
  const Run brief = stickslip_program({"orbits", "OTS", "--example", "O"});
  CHECK(brief.code == exit_decided);
  CHECK(brief.out.find("Orbit 2 of 2:  admissible\n") != std::string::npos);
  CHECK(brief.out.find("Orbit 1 of 2") == std::string::npos);
  CHECK(brief.out.find("Formal solutions, not admissible  (--all says all about them)\n"
                       "  orbit  O        T        S        phi          violates\n"
                       "  1      2.55481  2.53789  4.89805  1.68138 rad  crossing\n") != std::string::npos);
  const Run all = stickslip_program({"orbits", "OTS", "--example", "O", "--all"});
  CHECK(all.out.find("Orbit 1 of 2:  not admissible: crossing\n") >
        all.out.find("Orbit 2 of 2:  admissible\n"));
  CHECK(all.out.find("Formal solutions") == std::string::npos);
}

TEST_CASE("the orbits of a word have a picture and pages as those of a family") {
  const TemporaryDirectory directory;
  const auto page = directory.path() / "page";
  const Words at_O{"orbits", "OTS", "--example", "O"};
  const std::string file = directory.path() / "a.svg";
  CHECK(stickslip_program(with(at_O, {"--plot", file, "--out", page})).code == exit_decided);
  CHECK(content(file).find("OTS orbit 2 of 2, admissible") != std::string::npos);
  const std::string html = content(page / "index.html");
  CHECK(html.find("Orbits through OTS in 1 period of the load") != std::string::npos);
  CHECK(html.find("complete: 2 orbits, 1 admissible") != std::string::npos);
  CHECK(html.find("\"figure.svg\"") != std::string::npos);
  CHECK(content(page / "orbits.json") == stickslip_program(with(at_O, {"--json"})).out);
}

TEST_CASE("a word without an orbit is exit code 2, with what was met instead") {
  const Run result = stickslip_program({"orbits", "OSOSOT", "--example", "P", "--ur", "0.25"});
  CHECK(result.code == exit_undecided);
  CHECK(result.err.empty());
  CHECK(result.out.find("OS with the period 1") != std::string::npos);
}

TEST_CASE("a complete list of a word is an answer, also where no motion goes through it") {
  const Run none = stickslip_program({"orbits", "ST", "--example", "P"});
  CHECK(none.code == exit_decided);
  CHECK(none.out.find("complete: no orbit: x2' <= V <= 0 all along") != std::string::npos);
  const Run three = stickslip_program({"orbits", "SOT", "--example", "O", "--ur", "0.45899365993320057"});
  CHECK(three.code == exit_decided);
  CHECK(three.out.find("complete: 2 orbits, 1 admissible") != std::string::npos);
  const Run two = stickslip_program({"orbits", "OS", "--example", "P", "--period", "2"});
  CHECK(two.code == exit_decided);
  CHECK(two.out.find("a motion that never sticks") != std::string::npos);
}

TEST_CASE("--cells and --time say how long a search goes on") {
  const std::vector<std::string> asked{"orbits", "SOT", "--example", "O"};
  const auto with = [&](const char * name, const char * value) {
    std::vector<std::string> all = asked;
    all.insert(all.end(), {name, value});
    return stickslip_program(all);
  };
  const Run few = with("--cells", "100");
  CHECK(few.code == exit_undecided);
  CHECK(few.out.find("not complete") != std::string::npos);
  CHECK(with("--time", "60").code == exit_decided);
  for (const auto& [name, value] : {std::pair("--cells", "0"), std::pair("--cells", "many"),
                                    std::pair("--time", "-1"), std::pair("--time", "x")}) {
    const Run wrong = with(name, value);
    CHECK(wrong.code == exit_usage);
    CHECK(wrong.err.find(std::string(name).substr(2)) != std::string::npos);
  }
}

TEST_CASE("attractors along a parameter and in a plane: table, CSV, JSON") {
  const TemporaryDirectory directory;
  const std::string csv = (directory.path() / "t.csv").string();
  const Run along = stickslip_program({"attractors", "--example", "P", "--along", "ur", "0.25..0.3",
                                       "--values", "3", "--starts", "5", "--json", "--csv", csv});
  CHECK(along.code == exit_decided);
  const Json json = Json::parse(along.out);
  REQUIRE(json.at("points").size() == 3);
  CHECK(json.at("points").at(1).at("value") == "0.275");
  CHECK(json.at("points").at(0).at("attractors").at(0).at("word") == "OS");
  CHECK(json.at("points").at(2).at("attractors").at(0).at("once").size() == 3);
  std::ifstream file(csv);
  const std::string table(std::istreambuf_iterator<char>(file), {});
  CHECK(table.starts_with(
      "ur,attractor,share,kind,period,word,stable,x1,x2,x1',x2'\n0.25,1,1,periodic,1,OS,yes,"));
  const Run plane =
      stickslip_program({"attractors", "--example", "P", "--plane", "x2,x1'", "--pixels", "3", "--json"});
  CHECK(plane.code == exit_decided);
  const Json basins = Json::parse(plane.out);
  REQUIRE(basins.at("at").size() == 3);
  CHECK(basins.at("at").at(2).size() == 3);
  CHECK(basins.at("plane").at(1) == "x1'");
}

TEST_CASE("what makes no sense with --along and --plane is named") {
  const auto at_P = [](const Words& options) {
    Words all{"attractors", "--example", "P"};
    all.insert(all.end(), options.begin(), options.end());
    return all;
  };
  check_refused({
      {at_P({"--along", "ur", "3"}), exit_usage, "A..B"},
      {at_P({"--along", "ur", "0.5..0.1"}), exit_usage, "does not rise"},
      {at_P({"--along", "ur", "0.5.."}), exit_usage, "'0.5..' is not an interval A..B"},
      {at_P({"--along", "tau", "1..2"}), exit_usage, "'tau' is none of chi, eta, us, V, omega, p, phi, ur"},
      {at_P({"--along", "phi", "1..2"}), exit_usage, "'phi' is none of chi, eta, us, V, omega, p and ur"},
      {at_P({"--along", "load_frequency", "1..2"}), exit_usage, "give its file by --params"},
      {at_P({"--along", "ur", "0.2..0.3", "--values", "1"}), exit_usage, "values"},
      {at_P({"--along", "ur", "0.2..0.3", "--pixels", "9"}), exit_usage, "--pixels"},
      {at_P({"--along", "ur", "0.2..0.3", "--plane", "x1,x2"}), exit_usage, "--plane"},
      {at_P({"--along", "ur", "0.01..0.05"}), exit_domain, "ur > us"},
      {at_P({"--plane", "x1,x3"}), exit_usage, "x1,x3"},
      {at_P({"--plane", "x1,x1"}), exit_usage, "twice"},
      {at_P({"--plane", "x1,x2", "--pixels", "1"}), exit_usage, "pixels"},
      {at_P({"--plane", "x1,x2", "--seed", "3"}), exit_usage, "--seed"},
      {at_P({"--plane", "x1,x2", "--plot", "a.jpg"}), exit_usage, "a.jpg"},
      {at_P({"--plane", "x1,x2", "--csv", "/no/such/place/a.csv"}), exit_io, "/no/such/place"},
      {at_P({"--csv", "a.csv"}), exit_usage, "--csv"},
  });
}

TEST_CASE("simulate ends with what the motion settles on") {
  const Run orbit = stickslip_program({"simulate", "--example", "O", "--perturb", "0.01,0,0,0"});
  CHECK(orbit.code == exit_decided);
  CHECK(orbit.out.find("settles    OTS with the period 1: proved, stable") != std::string::npos);
  // It begins on an unstable orbit, to the last digit, and does not stay there.
  const Run left = stickslip_program({"simulate", "--example", "S", "--periods", "1"});
  CHECK(left.out.find("settles") != std::string::npos);
  CHECK(left.out.find("proved, unstable") == std::string::npos);
  const Run stuck = stickslip_program({"simulate", "--example", "P", "--state", "0,0,0,0", "--phi", "2"});
  CHECK(stuck.out.find("settles    stuck") != std::string::npos);
  // Without load no orbit is alone: nothing is proved, and nothing is claimed.
  const Run free = stickslip_program({"simulate", "--example", "O", "--p", "0", "--state", "0,0,0,0"});
  CHECK(free.code == exit_decided);
  CHECK(free.out.find("proved, stable") == std::string::npos);
}
