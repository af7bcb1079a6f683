#include "report/audit/mutants.hpp"

#include <doctest/doctest.h>

using namespace stickslip;
using namespace stickslip::report::tools;
using namespace stickslip::proofs::checks;
using namespace stickslip::report::audit;
using proofs::checks::EditKind;
using proofs::checks::Fate;

namespace {

proofs::checks::Gate sample_of_edits() {
  return {{7, 20},
          {{"40", "A1", EditKind::sign, "a = b", Fate::refuted, "it fails"},
           {"40", "A1", EditKind::index, "a = c", Fate::unproved, "no"},
           {"64", "A5", EditKind::index, "P*X2 = 0", Fate::survived, "proved"},
           {"64", "A5", EditKind::index, "X = Y", Fate::survived, "proved"},
           {"64", "A5", EditKind::index, "X = 1/0", Fate::stillborn, "void"},
           {"64", "A5", EditKind::sign, "X = X", Fate::equivalent, "true"}},
          {{"40", "A1", EditKind::sign, "a = -(-b)", Verdict::proved()},
           {"64", "A5", EditKind::index, "X = Y + (X - Y)", Verdict::undecided("word for word")}}};
}

}  // namespace

TEST_CASE("what is void or true is neither killed nor alive") {
  const GateRow all = row_of_all(sample_of_edits());
  CHECK(all.mutants() == 6);
  CHECK(all.wrong() == 4);
  CHECK(all.kill_rate() == "50 %");
  CHECK(all.twins == 2);
  CHECK(all.twins_proved == 1);
  CHECK(row_of_all({}).kill_rate() == "-");
}

TEST_CASE("rows by kind and by place add up to all") {
  for (const auto& rows : {rows_by_kind(sample_of_edits()), rows_by_place(sample_of_edits())}) {
    CHECK(rows.size() == 2);
    CHECK(rows[0].mutants() + rows[1].mutants() == 6);
    CHECK(rows[0].twins + rows[1].twins == 2);
  }
  CHECK(rows_by_place(sample_of_edits()).front().kill_rate() == "100 %");
}

TEST_CASE("what is proved is shown with its reason, on the terminal only what should not be") {
  const std::string text = terminal_mutants(sample_of_edits(), {});
  CHECK(text.find("one in 20, seed 7") != std::string::npos);
  CHECK(text.find("P*X2 = 0") != std::string::npos);
  CHECK(text.find("X = X") == std::string::npos);
  const Json json = written(sample_of_edits(), write_gate);
  REQUIRE(json.at("proved").size() == 3);
  CHECK(json.at("proved")[0].at("fate") == "survived");
  CHECK(json.at("proved")[2].at("reason") == "true");
  CHECK(json.at("all").at("survived") == 2);
}
