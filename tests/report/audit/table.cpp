#include "report/audit/table.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "report/audit/summary.hpp"
#include "report/tools/prose.hpp"
#include "tests/report/audit/sample.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;
using namespace stickslip::report;
using namespace stickslip::report::audit;
using namespace stickslip::report::tools;

namespace {

std::size_t widest_line(const std::string& text) {
  std::istringstream stream(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(stream, line);) {
    widest = std::max(widest, columns(line));
  }
  return widest;
}

std::ptrdiff_t lines_of(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

}  // namespace

TEST_CASE("the table fits a terminal of eighty columns") {
  const proofs::methods::Audit audit = sample_audit();
  CHECK(widest_line(terminal_report({sample_paper(), audit}, {})) <= 80);
  CHECK(widest_line(terminal_explanations({sample_paper(), audit}, {})) <= 80);
}

TEST_CASE("the report names every statement, every finding and every printed number") {
  const std::string text = terminal_report({sample_paper(), sample_audit()}, {});
  for (const std::string& part : std::vector<std::string>{
           "2 ", "5.where", "misprint corrected", "it runs to -t", "omega - omega1 != 0",
           "the search ran out of its budget", "7.749", "-1.3", "H(-t)",
           "5 statements of the paper: 1 model, 1 needs hypotheses, 1 digits off, 1 misprint\ncorrected, 1 "
           "not stated. Beside them 1 new result: 1 undecided."}) {
    CAPTURE(part);
    CHECK(mentions(text, part));
  }
}

TEST_CASE("colour only where it is asked for") {
  const proofs::methods::Audit audit = sample_audit();
  CHECK_FALSE(mentions(terminal_report({sample_paper(), audit}, {}), "\x1b"));
  CHECK_FALSE(mentions(terminal_lines({sample_paper(), audit}, {}), "\x1b"));
  CHECK(mentions(terminal_report({sample_paper(), audit}, {.colour = true}), "\x1b[31mmisprint corrected"));
}

TEST_CASE("a line for each statement and one for all") {
  const std::string text = terminal_lines({sample_paper(), sample_audit()}, {});
  CHECK(lines_of(text) == 7);
  CHECK(mentions(text, "undecided"));
}

TEST_CASE("an explanation shows formula, proof and uses, also of the corrected form") {
  const std::string text = terminal_explanations({sample_paper(), sample_audit()}, {});
  for (const char * part :
       {"by substitution", "omega1, t", "corrected", "uses        5", "used by     44", "if "}) {
    CAPTURE(part);
    CHECK(mentions(text, part));
  }
}

TEST_CASE("what an audit comes to") {
  proofs::methods::Audit audit = sample_audit();
  CHECK_FALSE(all_decided(audit));
  CHECK(any_refuted(audit));
  audit.records.resize(3);
  CHECK(all_decided(audit));
  CHECK_FALSE(any_refuted(audit));
  CHECK(is_finding(audit.records[2]));
  audit.records[2].outcome.hypotheses.back().origin = "5";  // inherited: said once, at its origin
  CHECK_FALSE(is_finding(audit.records[2]));
  CHECK(inheriting(audit, audit.records[1]) == std::set<std::string>{"5.where"});
  CHECK(summary_line({{}, {}}) == "0 statements of the paper.");
  Paper other = sample_paper();
  other.claims = {{.id = "not asked for"}};
  CHECK(summary_line({other, audit}) == "3 claims of the paper: 1 as printed, 1 model, 1 needs hypotheses.");
  CHECK(summary_line({other, {}}) == "no claims.");
  CHECK(by_place({sample_paper(), sample_audit()}).size() == 4);
}

TEST_CASE("a line says how many engines agree, or why none was asked") {
  CHECK(cross_check_line({.formulas = 3, .exact_points = 2, .ball_points = 1}) ==
        "3 formulas agree exactly at 2 rational points and in balls at 1 real point");
  CHECK(cross_check_line({.formulas = 1, .ball_points = 2, .unchecked = "an odd angle"}) ==
        "1 formula agrees in balls at 2 real points; an odd angle");
  CHECK(cross_check_line({.formulas = 1, .premise_points = 2}) ==
        "1 formula agrees in balls at 2 real points where all that the claim rests on holds");
  CHECK(cross_check_line({.unchecked = "it introduces names"}) ==
        "by no further engine: it introduces names");
  CHECK(cross_check_line({}) == "");
}
