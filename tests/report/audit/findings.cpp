
#include <doctest/doctest.h>

#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/examples/examples.hpp"
#include "report/audit/page_data.hpp"
#include "report/audit/summary.hpp"
#include "tests/report/audit/sample.hpp"

using namespace stickslip;
using namespace stickslip::report;
using namespace stickslip::numeric;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::report::audit;
using proofs::methods::Audit;
using proofs::methods::Status;

namespace {

Audit with_status(Status status) {
  Audit audit = sample_audit();
  audit.records.resize(5);
  for (Record& record : audit.records) {
    record.status = record.claim.id == "5" ? status : Status::as_printed;
  }
  return audit;
}

}  // namespace

TEST_CASE("the verdict is that of the worst statement") {
  CHECK(verdict_lead({sample_paper(), with_status(Status::as_printed)}) == "The paper holds as printed.");
  CHECK(verdict_lead({sample_paper(), with_status(Status::needs_hypotheses)}).find("hypotheses") !=
        std::string::npos);
  CHECK(verdict_lead({sample_paper(), with_status(Status::misprint_corrected)}) ==
        "The paper holds, with corrections.");
  CHECK(verdict_lead({sample_paper(), with_status(Status::digits_off)}) ==
        "The paper holds, with corrections.");
  CHECK(verdict_lead({sample_paper(), with_status(Status::refuted)}) ==
        "The paper does not hold everywhere.");
  CHECK(verdict_lead({sample_paper(), with_status(Status::rests_on_unproved)}) ==
        "Not everything is decided.");
  // What is undecided there is no statement of the paper.
  CHECK(verdict_lead({sample_paper(), sample_audit()}) == "The paper holds, with corrections.");
}

TEST_CASE("the table of statuses stands in the order of the statuses, and names each once") {
  std::set<std::string> names;
  for (std::size_t i = 0; i < statuses().size(); ++i) {
    CHECK(statuses()[i].status == static_cast<Status>(i));
    CHECK(names.insert(statuses()[i].name).second);
    CHECK(is_status(statuses()[i].name) == statuses()[i].of_claims);
  }
  CHECK(statuses().back().status == Status::not_stated);
  CHECK_FALSE(is_status("on_one_reading"));
  CHECK_FALSE(is_status("correct"));
}

TEST_CASE("the verdict counts the paper's statements, each once, and what is not the paper's apart") {
  CHECK(
      verdict_sentence({sample_paper(), with_status(Status::refuted)}) ==
      "Of 5 statements of the paper, 3 are proved exactly as printed; 1 is refuted; 1 is stated by no claim "
      "of ours.");
  CHECK(verdict_sentence({{}, {}}).empty());
  CHECK(sentence_of_ours(sample_audit()) ==
        "Beside these 1 claim of our own is counted apart: 1 new result.");
  CHECK(sentence_of_ours({}).empty());
}

TEST_CASE("findings, refuted claims and statements are told apart in a sentence") {
  CHECK(sentence_of_findings({{}, {}}).empty());
  CHECK(
      sentence_of_findings({sample_paper(), with_status(Status::refuted)}) ==
      "A finding is a claim, not a statement: one claim may state several statements, and some claims state "
      "none; of 1 refuted claim 1 states 1 of the statements.");
}

TEST_CASE("a remark tells what a claim found, where the audit has it") {
  Audit audit;
  audit.records.push_back({});
  audit.records.front().claim.id = "S.list";
  audit.records.front().outcome.found = "4 orbits";
  CHECK(with_answers("there are {S.list}, and $Lambda^{-1}$", audit) ==
        "there are 4 orbits, and $Lambda^{-1}$");
  CHECK(with_answers("{O.list}: {S.list}", audit) == "see O.list: 4 orbits");
  audit.records.front().claim.words = "all orbits";
  CHECK(words_of(audit.records.front()) == "all orbits: 4 orbits");
}

TEST_CASE("what text books say is a statement of theirs, proved and never as printed") {
  Audit audit = with_status(Status::proved);
  for (Record& record : audit.records) {
    record.claim.origin = Origin::textbook;
    record.status = Status::proved;
  }
  CHECK(verdict_sentence({sample_paper(), audit}) ==
        "Of 5 statements of text books, 4 are proved; 1 is stated by no claim of ours.");
  CHECK(verdict_lead({sample_paper(), audit}) == "What is stated is proved.");
  CHECK(sentence_of_ours(audit).empty());
  CHECK(summary_line({sample_paper(), audit}).find("statements of text books: 4 proved") !=
        std::string::npos);
  // One printed statement, and it is a paper that is audited.
  audit.records.front().claim.origin = Origin::paper;
  CHECK(source_of(audit) == "the paper");
}

TEST_CASE("a hypothesis is shown once, at its origin, with the claims that inherit it") {
  Audit audit = sample_audit();
  audit.records[5].outcome.hypotheses = audit.records[2].outcome.hypotheses;
  const std::vector<HypothesisGroup> groups = hypothesis_groups(audit);
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].hypotheses.size() == 1);
  REQUIRE(groups[0].origins.size() == 1);
  CHECK(groups[0].origins[0]->claim.id == "5.where");
  CHECK(groups[0].inherited_by == std::set<std::string>{"17"});
}

TEST_CASE("the same hypothesis brought in twice is one group") {
  Audit audit = sample_audit();
  audit.records[5].outcome.hypotheses = audit.records[2].outcome.hypotheses;
  audit.records[5].outcome.hypotheses.back().origin = "17";
  const std::vector<HypothesisGroup> groups = hypothesis_groups(audit);
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].origins.size() == 2);
  CHECK(groups[0].inherited_by.empty());
}

TEST_CASE("a part says of each place how many of its claims the proofs of the part use, not of its own") {
  Audit audit = sample_audit();
  audit.records[5].outcome.uses = {"2", "5", "5.where", "44"};  // 17 and 44 are of A2
  const tools::Json parts = uses_of_places({sample_paper(), audit}).at("parts");
  const auto row = [&](const std::string& id) {
    const auto is_it = [&](const tools::Json& part) { return part.at("id") == id; };
    std::map<std::string, std::pair<std::string, int>> counts;
    for (const tools::Json& cell : std::find_if(parts.begin(), parts.end(), is_it)->at("row")) {
      counts[cell.at("short")] = {cell.at("count"), cell.at("weight")};
    }
    return counts;
  };
  CHECK(row("sec3").at("Section 2") == std::pair<std::string, int>{"1", 1});
  // 5.where, and 5 by 17 and by the corrected form of 44.
  CHECK(row("A2").at("Section 3") == std::pair<std::string, int>{"2", 2});
  CHECK(row("A2").at("A2") == std::pair<std::string, int>{"", 0});
  for (const auto& [place, cell] : row("sec2")) {
    CHECK(cell.first.empty());
  }
}

TEST_CASE("the orbit of a figure is the one with the printed numbers") {
  for (const Example& example : printed_examples()) {
    const ExampleOrbits& orbits = orbits_of(example);
    const std::optional<std::size_t> shown = printed_orbit(orbits);
    REQUIRE(shown);
    for (const NamedBall& value : orbits.list.orbits[*shown].values) {
      if (value.name == "Theta" || value.name == "zdot10" || value.name == "xdot10") {
        for (const PrintedResult& printed : example.results) {
          if (printed.name == value.name) {
            CAPTURE(example.name);
            CHECK(std::abs(std::abs(value.value.approximate()) - std::abs(printed.value.value.get_d())) <
                  0.01);
          }
        }
      }
    }
  }
  CHECK_FALSE(printed_orbit(ExampleOrbits{printed_examples().front(), {}}));
}
