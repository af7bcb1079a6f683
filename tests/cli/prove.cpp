// stickslip prove: a line that a user types.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "tests/cli/program.hpp"

using namespace stickslip;

TEST_CASE("a statement is proved, refuted or left open, and the exit code says so") {
  const Run proved = stickslip_program({"prove", "ω₁² < ω₂²"});
  CHECK(proved.code == exit_decided);
  CHECK(proved.out.starts_with("proved  omega1^2 < omega2^2\n"));
  const Run refuted = stickslip_program({"prove", "H1(t)^2 + I = H2(t) H3(t)"});
  CHECK(refuted.code == exit_refuted);
  CHECK(refuted.out.find("true is     H1^2(t) - I = H2(t)*H3(t) (sign of I)") != std::string::npos);
  const Run open = stickslip_program({"prove", "d/dt[1/t] = -1/t^2"});
  CHECK(open.code == exit_undecided);
  CHECK(open.out.starts_with("undecided  d/dt[1/t] = -1/t^2\n    why         "));
  // From assumptions, of which those used are named.
  const Run given = stickslip_program({"prove", "cos(omega Theta) = 1", "omega Theta = 2 pi", "T < tau"});
  CHECK(given.code == exit_decided);
  CHECK(given.out.find("if          omega*Theta = 2*pi\n") != std::string::npos);
  CHECK(given.out.find("T < tau") == std::string::npos);
  // Of one's own symbols; a minus sign in front is no option.
  CHECK(stickslip_program({"prove", "-a^2 <= 2 a b + b^2", "--symbols", "a,b"}).code == exit_decided);
  CHECK(stickslip_program({"prove", "--symbols", "a,b", "--", "-a^2 < b"}).code == exit_refuted);
}

TEST_CASE("a counterexample says what all symbols are, a repair what it needs") {
  const Run point = stickslip_program({"prove", "x^2 z^2 > 0", "z > 0", "--symbols", "x,z"});
  CHECK(point.code == exit_refuted);
  CHECK(point.out.find("at z = 1, x = 0\n") != std::string::npos);
  const Run needs = stickslip_program({"prove", "x^2 cos(2 y)^2/z^2 > 0", "z > 0", "--symbols", "x,y,z"});
  CHECK(needs.out.find("(without the factor x^2, where cos(2*y) != 0)") != std::string::npos);
  CHECK(stickslip_program({"prove", "x^2 > 0", "--symbols", "x"}).out.find("is 0 at x = 0\n") !=
        std::string::npos);
}

TEST_CASE("a symbol may be given two values, or values in a circle") {
  const Run two = stickslip_program({"prove", "0 = 1", "a = 1", "a = 2", "--symbols", "a"});
  CHECK(two.code == exit_undecided);
  CHECK(two.out.find("vacuous: what is assumed contradicts itself") != std::string::npos);
  const auto in_a_circle = [](const std::string& statement) {
    return stickslip_program({"prove", statement, "a = b + 1", "b = a - 1", "--symbols", "a,b"}).code;
  };
  CHECK(in_a_circle("a > b") == exit_decided);
  CHECK(in_a_circle("a = 2 b") == exit_refuted);
  CHECK(in_a_circle("a < 1") == exit_refuted);
}

TEST_CASE("what is known of a statement of one's own is said as for claims") {
  const Run explained = stickslip_program({"prove", "Q = [q1; q2]", "--explain"});
  CHECK(explained.code == exit_decided);
  CHECK(explained.out.find("    theorem     ") != std::string::npos);
  const Run json = stickslip_program({"prove", "a + b = b + a", "--symbols", "a,b", "--json"});
  CHECK(json.code == exit_decided);
  const auto claims = nlohmann::json::parse(json.out).at("places").at(0).at("claims");
  REQUIRE(claims.size() == 1);
  CHECK(claims[0].at("id") == "own");
  CHECK(claims[0].at("status") == "proved");
}

TEST_CASE("a proof of a statement of one's own is written for Coq") {
  const std::filesystem::path directory = std::filesystem::temp_directory_path() / "stickslip-own-proof";
  std::filesystem::remove_all(directory);
  const Run run = stickslip_program({"prove", "H(2 t) = H(t)^2", "--certificate", directory.string()});
  CHECK(run.code == exit_decided);
  CHECK(content(directory / "Claim_own.v").find("Theorem claim_own_1") != std::string::npos);
  std::filesystem::remove_all(directory);
  CHECK(stickslip_program({"prove", "H(2 t) = H(t)", "--certificate", directory.string()}).code ==
        exit_refuted);
  CHECK(content(directory / "Claim_own.v").find("own, which is refuted") != std::string::npos);
  std::filesystem::remove_all(directory);
  const Run open = stickslip_program({"prove", "d/dt[1/t] = -1/t^2", "--certificate", directory.string()});
  CHECK(open.code == exit_undecided);
  CHECK(open.err.find("what is not decided has no certificate") != std::string::npos);
  CHECK(!std::filesystem::exists(directory));
}

TEST_CASE("a line that cannot be read is pointed into") {
  const Run run = stickslip_program({"prove", "H1(t)^2 - I = H9(t)"});
  CHECK(run.code == exit_usage);
  CHECK(run.err ==
        "stickslip: column 15: no symbol 'H9'; there are H, H1, H2, H3, H11, H12; one of your own is named "
        "by --symbols H9.\n"
        "  H1(t)^2 - I = H9(t)\n"
        "                ^\n");
  CHECK(run.out.empty());
  check_refused({{{"prove"}, exit_usage, "STATEMENT"},
                 {{"prove", "a = 1", "--symbols", "a b"}, exit_usage, "'a b' is no name for a symbol"},
                 {{"prove", "omega = 1", "--symbols", "omega"}, exit_usage, "'omega' has a meaning already"},
                 {{"prove", "I = 1", "--symbols", "I"}, exit_usage, "'I' has a meaning already"},
                 {{"prove", "α = 1", "--symbols", "α"}, exit_usage, "as alpha for α"},
                 {{"prove", "chi = 1", "--json", "--explain"}, exit_usage, "--explain"}});
}
