// stickslip branch from outside: exit codes, sentences, JSON, tables.
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using Json = nlohmann::json;

TEST_CASE("branch: questions that are none are named") {
  check_refused({
      {{"branch"}, exit_usage, "family"},
      {{"branch", "asymmetric", "--example", "S", "--omega", "0.5..0.6"}, exit_usage, "'asymmetric'"},
      {{"branch", "symmetric", "--example", "S"}, exit_usage, "interval A..B"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5..0.6", "--p", "0..1"},
       exit_usage,
       "omega and p"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.6..0.5"}, exit_usage, "does not rise"},
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5.."}, exit_usage, "omega: ''"},
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
      {{"branch", "symmetric", "--example", "S", "--omega", "0.5..0.6", "--plot", "a.png"},
       exit_usage,
       "a.png"},
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

TEST_CASE("branch: of a word, and what is not looked for is said") {
  const Run json = stickslip_program(
      {"branch", "OTS", "--example", "O", "--ur", "0.4375..0.4385", "--at", "0.438", "--json"});
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
