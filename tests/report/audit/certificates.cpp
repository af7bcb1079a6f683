// What an audit makes of a record of what Coq said, and of one that was changed. What Coq is asked for that:
// ask_coq.cpp.
#include "report/audit/certificate_record.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>

#include "core/error.hpp"
#include "proofs/methods/prover.hpp"
#include "report/audit/json.hpp"
#include "report/audit/table.hpp"
#include "tests/report/audit/sample.hpp"
#include "tests/report/audit/three_claims.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::report;
using namespace stickslip::report::audit;
using stickslip::report::tools::Json;

namespace {

using State = Certified::State;
namespace fs = std::filesystem;

// The three claims, certified, it seems: all that Coq would have left, but no Coq.
class Accepted {
 public:
  Accepted() {
    write_certificates(path);
    edit([&](Json& record) {
      for (Json& one : record["foundations"]) {
        one["compiled"] = compiled(one.at("file"));
      }
      for (Json& one : record["claims"]) {
        one["accepted"] = true;
        one["reason"] = "";
        one["seconds"] = "1.250";
        one["again"] = "accepted";
        one["compiled"] = compiled(one.at("file"));
      }
      record["coq"] = {{"version", "8"},
                       {"axioms", {{"Classical_Prop.classic", "forall P : Prop, P \\/ ~ P"}}}};
    });
  }

  // Changes the record, and seals it.
  template <typename Edit>
  void edit(const Edit& change) const {
    Json record = read_record(path / certificate_record);
    change(record);
    write(path / certificate_record, report::tools::to_text(sealed(record)));
  }
  // As after certify --out once more: of claims of which the first has this definition.
  void write_again(bool with_cosine) const {
    const Json before = read_record(path / certificate_record);
    write(path / certificate_record,
          report::tools::to_text(record_of(certificates::certificates(three_claims(with_cosine)), before)));
  }
  [[nodiscard]] Json record() const { return read_record(path / certificate_record); }
  [[nodiscard]] Certified of(const std::string& id, bool with_cosine = true) const {
    return certification(methods::audit(three_claims(with_cosine)), path / certificate_record).claims.at(id);
  }
  [[nodiscard]] State state(const std::string& id, bool with_cosine = true) const {
    return of(id, with_cosine).state;
  }

 private:
  [[nodiscard]] std::string compiled(const std::string& file) const {
    const fs::path vo = (path / file).replace_extension(".vo");
    write(vo, "compiled of " + file);
    return certificates::fingerprint(text_in(vo));
  }
  TemporaryDirectory temporary_;

 public:
  fs::path path = temporary_.path();
};

}  // namespace

TEST_CASE("a claim is certified if Coq accepted what it says now, and nothing has changed since") {
  const Accepted accepted;
  for (const char * id : {"1", "2", "3"}) {
    CAPTURE(id);
    CHECK(accepted.of(id).words == "1 theorem on 1 axiom");
    CHECK(accepted.state(id) == State::certified);
  }
  CHECK(accepted.of("1").file == "Claim_1.v");
  CHECK(all_accepted(accepted.record()));
  CHECK(text_of(accepted.record())
            .ends_with("0 of them by a definition or an assumption alone; coqchk accepts 3\n3 of 3 theorems "
                       "certified, 1 axioms\n"));
  methods::Audit audit = methods::audit(three_claims());
  methods::Record check;
  check.claim.id = "4";
  check.claim.kind = methods::Kind::check;
  audit.records.push_back(check);
  const Certification all = certification(audit, accepted.path / certificate_record);
  CHECK(all.line.starts_with(
      "Certified by Coq: 3 of 3 claims that have theorems of the kernel, with 3 theorems."));
  CHECK(all.claims.at("4").state == State::none);
}

TEST_CASE("what stands beside the record must be what Coq was asked about") {
  // After each change none of these claims counts; the others do.
  const auto stale = [](const std::vector<std::string>& claims, const auto& change) {
    const Accepted accepted;
    change(accepted);
    for (const char * id : {"1", "2", "3"}) {
      CAPTURE(id);
      CHECK(accepted.state(id) == (std::ranges::count(claims, id) > 0 ? State::stale : State::certified));
    }
  };
  const std::vector<std::string> all{"1", "2", "3"};
  const auto changed = [](const char * file) {
    return [file](const Accepted& accepted) { write(accepted.path / file, "something else"); };
  };
  stale(all, changed("Definitions.v"));
  stale(all, changed("Statements.v"));
  stale(all, changed("Calculus.v"));
  stale(all, changed("Auxiliary.v"));
  stale(all, changed("Calculus.vo"));
  stale({"1"}, changed("Claim_1.v"));
  stale({"1"}, changed("Claim_1.vo"));
  stale({"2", "3"}, changed("Claim_2.v"));  // 3 imports it
  stale({"2", "3"}, changed("Claim_2.vo"));
  stale({"2", "3"}, [](const Accepted& accepted) { fs::remove(accepted.path / "Claim_2.vo"); });
  // Which make does not leave there.
  stale({}, [](const Accepted& accepted) { fs::remove(accepted.path / "Statements.vo"); });
  // A text and its fingerprint: what the program would write is another.
  for (const char * name : {"Definitions.v", "Statements.v", "Calculus.v"}) {
    stale(all, [&](const Accepted& accepted) {
      const std::string text = text_in(accepted.path / name) + "(* more *)\n";
      write(accepted.path / name, text);
      accepted.edit([&](Json& record) {
        for (Json& one : record["foundations"]) {
          one["text"] = one.at("file") == name ? Json(certificates::fingerprint(text)) : one.at("text");
        }
      });
    });
  }
}

TEST_CASE("many short claims share files, and stand or fall with these") {
  const TemporaryDirectory temporary;
  write_certificates(temporary.path(), true, 120);
  const Json record = read_record(temporary.path() / certificate_record);
  std::map<std::string, std::set<std::string>> files;  // of the claims, by file
  for (const Json& claim : record.at("claims")) {
    files[claim.at("file")].insert(claim.at("claim"));
  }
  CHECK(files.size() < 10);
  const std::string first = claim_in(record, "2").at("file"), second = claim_in(record, "3").at("file");
  CHECK(first != second);
  CHECK(claim_in(record, "3").at("imports") == Json{first.substr(0, first.size() - 2)});
  CHECK(claim_in(record, "1").at("imports").empty());
  const std::string text = text_in(temporary.path() / first);
  for (const std::string& claim : files.at(first)) {
    CHECK(text.find("\nTheorem claim_" + claim + "_1 :") != std::string::npos);
  }
  const std::string makefile = text_in(temporary.path() / "Makefile");
  CHECK(makefile.find(" " + first.substr(0, first.size() - 2) + " ") != std::string::npos);
  // Each file once.
  const std::string rule = "\n" + first + "o:";
  CHECK(makefile.find(rule) != std::string::npos);
  CHECK(makefile.find(rule) == makefile.rfind(rule));
}

TEST_CASE("a record that was changed, is of another version or rests on something else says nothing") {
  const auto words = [](const auto& change) {
    const Accepted accepted;
    change(accepted);
    CHECK(accepted.state("1") == State::stale);
    return accepted.of("1").words;
  };
  CHECK(words([](const Accepted& accepted) {
          Json record = accepted.record();
          record["claims"][1]["seconds"] = "0.1";
          write(accepted.path / certificate_record, report::tools::to_text(record));
        }) == "the record is not as it was made");
  CHECK(words([](const Accepted& accepted) {
          accepted.edit([](Json& record) { record["program"]["version"] = "0.0"; });
        }) == "Coq certified it for another version of the program");
  CHECK(words([](const Accepted& accepted) {
          accepted.edit([](Json& record) { record["coq"]["axioms"]["Claim_1.evil"] = "False"; });
        }) == "it rests on Claim_1.evil");
  // By name and by what it says.
  CHECK(words([](const Accepted& accepted) {
          accepted.edit([](Json& record) { record["coq"]["axioms"]["Classical_Prop.classic"] = "False"; });
        }) == "it rests on Classical_Prop.classic");
  CHECK(words([](const Accepted& accepted) {
          accepted.edit([](Json& record) { record["foundations"].erase(0); });
        }).ends_with("is not what the program writes"));
}

TEST_CASE("another statement is not the one that was certified") {
  const Accepted accepted;
  for (const char * id : {"1", "2", "3"}) {
    CHECK(accepted.of(id, false).words == "what Coq certified is another statement than this one");
  }
}

TEST_CASE("what Coq said stays when certificates are written again, unless something has changed") {
  const Accepted same;
  same.write_again(true);
  CHECK(same.state("3") == State::certified);
  const Accepted changed, unsealed;
  changed.write_again(false);
  Json record = unsealed.record();
  record["seal"] = "";
  write(unsealed.path / certificate_record, report::tools::to_text(record));
  unsealed.write_again(true);
  for (const char * id : {"1", "2", "3"}) {
    CHECK(claim_in(changed.record(), id).at("accepted").is_null());
    CHECK(changed.state(id, false) == State::unknown);
    CHECK(claim_in(unsealed.record(), id).at("accepted").is_null());
  }
}

TEST_CASE("of a record that was edited no reason is repeated") {
  const Accepted accepted;
  Json record = accepted.record();
  record["without"].push_back({{"claim", "2"}, {"reason", "says a forger"}});
  record["claims"].erase(1);
  record["claims"][0]["accepted"] = false;
  record["claims"][0]["reason"] = "says a forger";
  for (const bool with_seal : {false, true}) {
    write(accepted.path / certificate_record, report::tools::to_text(with_seal ? sealed(record) : record));
    for (const char * id : {"1", "2"}) {
      CHECK(accepted.of(id).words == (with_seal ? "says a forger" : "the record is not as it was made"));
      CHECK((accepted.state(id) == State::unknown) != with_seal);
    }
  }
}

TEST_CASE("without a record nothing is certified, a wrong one is refused") {
  const methods::Audit audit = methods::audit(three_claims());
  const Certification none = certification(audit);
  CHECK(none.claims.at("1").state == State::unknown);
  CHECK(none.line.find("Coq was not asked about the 3 claims") != std::string::npos);
  const TemporaryDirectory temporary;
  CHECK_THROWS_AS((void)certification(audit, temporary.path() / certificate_record), InputOutputError);
  write(temporary.path() / certificate_record, "{]");
  CHECK_THROWS_AS((void)certification(audit, temporary.path() / certificate_record), InputOutputError);
}

TEST_CASE("all that Coq prints of assumptions is read, and only the allowed axioms are allowed") {
  const auto axioms = axioms_in(
      "Claim_1.claim_1_1 : Statements.claim_1_1\n     : Statements.claim_1_1\nAxioms:\n"
      "ClassicalDedekindReals.sig_forall_dec\n  : forall P : nat -> Prop,\n    (forall n : nat, {P n} + {~ P "
      "n}) ->"
      "\n    {n : nat | ~ P n} + {forall n : nat, P n}\nClassical_Prop.classic : forall P : Prop, P \\/ ~ P\n"
      "Claim_2.f is assumed to be guarded.\nevil : False\n");
  CHECK(axioms.size() == 4);
  for (const char * name : {"ClassicalDedekindReals.sig_forall_dec", "Classical_Prop.classic"}) {
    CHECK(axioms.at(name) == allowed_axioms().at(name));
  }
  CHECK(axioms.at("Claim_2.f") == "is assumed to be guarded.");
  CHECK(axioms.at("evil") == "False");
  CHECK(allowed_axioms().size() == 4);
  CHECK(axioms_in("Closed under the global context\n").empty());
}

TEST_CASE("reports carry it") {
  Certification certified;
  certified.claims["44"] = {State::certified, "Claim_44.v", "2 theorems on 4 axioms"};
  certified.claims["5"] = {State::refused, "Claim_5.v", "Coq does not accept it: see Claim_5.log"};
  certified.line = "Certified by Coq: one.";
  const Json json =
      to_json({report::sample_paper(), report::sample_audit()}, "stickslip audit", {}, {}, certified);
  CHECK(json.at("summary").at("certificates") == certified.line);
  int found = 0;
  for (const Json& place : json.at("places")) {
    for (const Json& claim : place.at("claims")) {
      const std::string state = claim.at("certificate").at("state");
      CHECK(state == (claim.at("id") == "44" ? "certified" : claim.at("id") == "5" ? "refused" : "unknown"));
      ++found;
    }
  }
  CHECK(found > 2);
  const std::string text =
      terminal_report({report::sample_paper(), report::sample_audit()}, {.width = 80}, certified);
  CHECK(text.find("Not certified, Coq does not accept it: see Claim_5.log: 5.\n") != std::string::npos);
  CHECK(text.ends_with("Certified by Coq: one.\n"));
}
