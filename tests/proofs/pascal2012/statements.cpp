// The paper's statements and the claims that state them: nothing can be left out, or counted as the paper's
// that it does not say.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/pascal2012/paper.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;

namespace {

std::map<std::string, Origin> origins_of_claims() {
  std::map<std::string, Origin> result;
  for (const Claim& claim : paper().claims) {
    result[claim.id] = claim.origin;
  }
  return result;
}

Record with_status(const std::string& id, Status status) {
  Record record;
  record.claim.id = id;
  record.status = status;
  return record;
}

const PrintedStatement two_claims{"S001", "(1)", Kind::step, "it holds", {"a", "b"}};

}  // namespace

TEST_CASE("every statement of the paper has its claims, or the reason why it has none") {
  const std::map<std::string, Origin> known = origins_of_claims();
  std::size_t number = 0;
  for (const PrintedStatement& statement : paper().statements) {
    CAPTURE(statement.id);
    CHECK(statement.id == fmt::format("S{:03}", ++number));
    CHECK_FALSE(statement.section.empty());
    CHECK_FALSE(statement.place.empty());
    CHECK_FALSE(statement.words.empty());
    CHECK((statement.claims.empty() ? !statement.missing.empty() : true));
    for (const std::vector<std::string>& ids : {stating(statement), statement.see}) {
      CHECK(std::set<std::string>(ids.begin(), ids.end()).size() == ids.size());
      for (const std::string& id : ids) {
        CAPTURE(id);
        CHECK(known.contains(id));
      }
    }
  }
  CHECK(number == 180);
}

TEST_CASE("a claim is the paper's exactly if a statement of the paper names it") {
  for (const auto& [id, origin] : origins_of_claims()) {
    CAPTURE(id);
    CHECK((origin == Origin::paper) == is_stated(paper(), id));
  }
}

TEST_CASE("what the paper does not print is not counted as printed") {
  const std::map<std::string, Origin> known = origins_of_claims();
  for (const char * id : {"S.stability", "O.stability", "P.stability", "S.list", "A5.unique", "A5.symmetry",
                          "37.sharp", "23.spurious"}) {
    CHECK(known.at(id) == Origin::new_result);
  }
  for (const char * id : {"12.back", "16.back", "33.back"}) {
    CHECK(known.at(id) == Origin::converse);
  }
  // That (4) gives one friction in each state is not said in the paper.
  for (const char * id : {"4.defined", "4.unique"}) {
    CHECK(known.at(id) == Origin::reading);
  }
  for (const char * id : {"S.from.T", "16.reduced", "38.group", "S.raw"}) {
    CHECK(known.at(id) == Origin::auxiliary);
  }
}

TEST_CASE("a statement stands as its worst claim does") {
  for (const Status worst : {Status::as_printed, Status::needs_hypotheses, Status::digits_off,
                             Status::refuted, Status::rests_on_unproved, Status::undecided}) {
    const Audit audit{{with_status("a", Status::as_printed), with_status("b", worst)}};
    CHECK(status_of({}, two_claims, audit) == worst);
  }
  CHECK(status_of({}, two_claims, {{with_status("a", Status::as_printed)}}) == Status::undecided);
}

TEST_CASE("refuted is what both readings refute, and on one reading what one refutes and the other proves") {
  PrintedStatement read_twice = two_claims;
  read_twice.claims = {"a"};
  read_twice.or_read = {"b"};
  const auto status = [&](Status a, Status b) {
    return status_of({}, read_twice, {{with_status("a", a), with_status("b", b)}});
  };
  for (const Status holds : {Status::as_printed, Status::where_defined, Status::misprint_corrected}) {
    CHECK(status(holds, Status::refuted) == Status::on_one_reading);
    CHECK(status(Status::refuted, holds) == Status::on_one_reading);
  }
  CHECK(status(Status::refuted, Status::refuted) == Status::refuted);
  CHECK(status(Status::undecided, Status::refuted) == Status::undecided);
  CHECK(status(Status::as_printed, Status::undecided) == Status::undecided);
}

TEST_CASE("a premise counts for a condition or alone, and a definition holds wherever it is defined") {
  PrintedStatement statement = two_claims;
  const auto status = [&](Kind kind, Status a, Status b) {
    statement.kind = kind;
    return status_of({}, statement, {{with_status("a", a), with_status("b", b)}});
  };
  CHECK(status(Kind::condition, Status::as_printed, Status::premise) == Status::premise);
  CHECK(status(Kind::identity, Status::as_printed, Status::premise) == Status::as_printed);
  CHECK(status(Kind::identity, Status::premise, Status::premise) == Status::premise);
  CHECK(status(Kind::definition, Status::as_printed, Status::where_defined) == Status::as_printed);
  CHECK(status(Kind::definition, Status::as_printed, Status::needs_hypotheses) == Status::needs_hypotheses);
  CHECK(status(Kind::step, Status::as_printed, Status::where_defined) == Status::where_defined);
}

TEST_CASE("what is said at the data of an example needs nothing that holds there") {
  PrintedStatement there = two_claims;
  there.claims = {"a"};
  there.example = "S";
  Record record = with_status("a", Status::needs_hypotheses);
  const auto status = [&](const proofs::kernel::Term& nonzero) {
    record.outcome.hypotheses = {hypothesis(nonzero, "a")};
    return status_of(paper(), there, {{record}});
  };
  const proofs::kernel::Term omega = proofs::kernel::Variable{"omega"}, tau = proofs::kernel::Variable{"tau"};
  CHECK(status(omega - Rational(1, 2)) == Status::as_printed);
  CHECK(status(omega - Rational(3, 5)) == Status::needs_hypotheses);
  CHECK(status(sin(tau)) == Status::needs_hypotheses);
}

TEST_CASE("what is stated in part is not proved, and a fault in that part is not hidden") {
  PrintedStatement in_part = two_claims;
  in_part.missing = "for one orbit only";
  const auto status = [&](Status b) {
    return status_of({}, in_part, {{with_status("a", Status::as_printed), with_status("b", b)}});
  };
  CHECK(status(Status::as_printed) == Status::in_part);
  CHECK(status(Status::needs_hypotheses) == Status::in_part);
  CHECK(status(Status::misprint_corrected) == Status::misprint_corrected);
  CHECK(status(Status::refuted) == Status::refuted);
  in_part.claims.clear();
  CHECK(status_of({}, in_part, {}) == Status::not_stated);
}

TEST_CASE("an audit of some claims answers the statements that have no other") {
  Paper two;
  two.claims = {{.id = "a"}, {.id = "b"}, {.id = "c"}};
  two.statements = {two_claims,
                    {"S002", "(2)", Kind::step, "it holds", {"c"}},
                    {"S003", "Fig. 1", Kind::figure, "it is drawn", {}, "a drawing"}};
  const Record a = with_status("a", Status::as_printed), b = with_status("b", Status::as_printed),
               c = with_status("c", Status::as_printed);
  CHECK(statements_in(two, {{a, b, c}}).size() == 3);
  CHECK(is_whole(two, {{a, b, c}}));
  CHECK_FALSE(is_whole(two, {{a, c}}));
  const std::vector<const PrintedStatement *> some = statements_in(two, {{a, c}});
  REQUIRE(some.size() == 1);
  CHECK(some.front()->id == "S002");
}

TEST_CASE("remarks and results name claims that there are, and commands of the program") {
  const std::map<std::string, Origin> known = origins_of_claims();
  const std::regex id("[0-9A-Z]+\\.[a-z][a-z0-9.]*");  // 16.back, S.from.ur
  std::vector<std::string> texts, commands;
  std::set<std::string> remarked, results;
  for (const Remark& remark : paper().remarks) {
    CHECK(known.contains(remark.claim));
    CHECK(remarked.insert(remark.claim).second);
    texts.insert(texts.end(), {remark.says, remark.fact, remark.because});
    commands.push_back(remark.see);
  }
  for (const Result& result : paper().results) {
    CHECK(results.insert(result.id).second);
    for (const std::string& claim : result.claims) {
      CAPTURE(claim);
      CHECK(known.contains(claim));
    }
    texts.insert(texts.end(), {result.title, result.theorem, result.idea});
    commands.push_back(result.see);
  }
  for (const std::string& text : texts) {
    CHECK_FALSE(text.empty());
    for (std::sregex_iterator found(text.begin(), text.end(), id), end; found != end; ++found) {
      CAPTURE(found->str());
      CHECK(known.contains(found->str()));
    }
  }
  for (const std::string& command : commands) {
    CAPTURE(command);
    CHECK(command.starts_with("stickslip "));
  }
}

TEST_CASE("every symbol of a formula has a LaTeX name") {
  const auto is_set = [](const proofs::symbols::Statement& statement) {
    return proofs::symbols::latex(statement).find("\\mathrm") == std::string::npos;
  };
  for (const Claim& claim : paper().claims) {
    CAPTURE(claim.id);
    for (const auto& form : {claim.printed, claim.corrected}) {
      CHECK(std::ranges::all_of(form, is_set));
    }
    for (const Assumption& assumption : claim.assumptions) {
      CAPTURE(assumption.id);
      CHECK(is_set(assumption.statement));
    }
  }
}

TEST_CASE("claims are named by their origin") {
  const std::set<std::string> converses = ids_named(paper().claims, "converse");
  CHECK(converses.contains("12.back"));
  CHECK_FALSE(converses.contains("12"));
  CHECK(ids_named(paper().claims, "new").contains("A5.unique"));
  // A printed paper has no claims of text books.
  CHECK_THROWS_AS((void)ids_named(paper().claims, "textbook"), UsageError);
  std::size_t all = 0;
  for (const OriginFacts& origin : origins()) {
    all += origin.origin == Origin::textbook ? 0 : ids_named(paper().claims, origin.name).size();
  }
  CHECK(all == paper().claims.size());
}
