#include "report/audit/certificates.hpp"

#include <doctest/doctest.h>

#include <fstream>

#include "core/error.hpp"
#include "report/audit/json.hpp"
#include "report/audit/table.hpp"
#include "tests/report/audit/sample.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::report::audit;
using stickslip::report::tools::Json;

namespace {

using State = Certified::State;
namespace fs = std::filesystem;

methods::Record proved(const std::string& id, const kernel::Theorem& theorem) {
  methods::Record record;
  record.claim.id = id;
  record.outcome.theorems = {theorem};
  record.outcome.verdict.truth = Truth::proved;
  return record;
}

const kernel::Term x = kernel::Variable{"x"};

// Claim 1, claim 2 that uses it, and one without theorem.
methods::Audit audit_of(const kernel::Theorem& first) {
  methods::Audit audit;
  audit.records = {proved("1", first), proved("2", kernel::Theorem::reflexive(kernel::power(x, 2))), {}};
  audit.records[2].claim.id = "3";
  audit.records[2].claim.kind = methods::Kind::check;
  return audit;
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

// As after certify --out and make: all accepted.
class Checked {
 public:
  Checked() {
    certificates::Certificates all;
    for (const methods::Record& record : {audit.records[0], audit.records[1]}) {
      const std::string name = certificates::file_name(record.claim.id);
      all.certificates.push_back({record.claim.id, name, {"claim"}, {}, certificates::fingerprint(record)});
      all.files.push_back({name + ".v", "text of " + name});
      write(path / (name + ".v"), all.files.back().text);
      write(path / (name + ".log"), "seconds 1.250\n");
      write(path / (name + ".vo"), "compiled");
    }
    write(path / "Axioms.v",
          "apply (Matrices.and_also Claim_1.theorems).\napply (Matrices.and_also Claim_2.theorems).\n");
    write(path / "Axioms.log", "Axioms:\nclassic : forall P : Prop,\n  P \\/ ~ P\n");
    all.certificates[1].imports = {"Claim_1"};
    all.uncertified = {{"3", "a check"}};
    write(path / certificate_record, report::tools::to_text(report::audit::record_of(all)));
  }

  // As after certify --out once more, for claim 2 alone: claim 1 is kept, and its file has this text.
  void write_again(const std::string& first_text) const {
    certificates::Certificates all;
    for (const methods::Record& record : {audit.records[0], audit.records[1]}) {
      const std::string name = certificates::file_name(record.claim.id);
      all.certificates.push_back({record.claim.id, name, {"claim"}, {}, certificates::fingerprint(record)});
      all.files.push_back({name + ".v", "text of " + name});
    }
    all.certificates[0].asked = false;
    all.certificates[1].imports = {"Claim_1"};
    all.files[0].text = first_text;
    const Json before = Json::parse(std::ifstream(path / certificate_record));
    write(path / certificate_record, report::tools::to_text(report::audit::record_of(all, before)));
  }

  [[nodiscard]] Json look() const {
    const Json json = checked(path);
    write(path / certificate_record, report::tools::to_text(json));
    return json;
  }
  [[nodiscard]] State state(const std::string& id, const methods::Audit& now) const {
    return certification(now, path / certificate_record).claims.at(id).state;
  }

  methods::Audit audit = audit_of(kernel::Theorem::reflexive(x));

 private:
  TemporaryDirectory temporary_;

 public:
  fs::path path = temporary_.path();
};

}  // namespace

TEST_CASE("a claim is certified if Coq accepted what it says now") {
  const Checked checked;
  CHECK(checked.state("1", checked.audit) == State::unknown);
  const Json json = checked.look();
  CHECK(all_accepted(json));
  CHECK(text_of(json).ends_with("\n2 of 2 theorems certified, 1 axioms\n"));
  CHECK(checked.state("1", checked.audit) == State::certified);
  CHECK(checked.state("2", checked.audit) == State::certified);
  CHECK(checked.state("3", checked.audit) == State::none);
  const Certification all = certification(checked.audit, checked.path / certificate_record);
  CHECK(all.line.starts_with(
      "Certified by Coq: 2 of 2 claims that have theorems of the kernel, with 2 theorems."));
  CHECK(all.claims.at("1").words == "1 theorem on 1 axiom");
  CHECK(all.claims.at("1").file == "Claim_1.v");
}

TEST_CASE("a certificate is stale when the statement, the file or the version is another") {
  const Checked checked;
  (void)checked.look();
  const methods::Audit other = audit_of(kernel::Theorem::reflexive(-x));
  CHECK(checked.state("1", other) == State::stale);
  CHECK(checked.state("2", other) == State::certified);
  write(checked.path / "Claim_2.v", "another text");
  CHECK(checked.state("2", checked.audit) == State::stale);
  Json json = Json::parse(std::ifstream(checked.path / certificate_record));
  json["program"]["version"] = "0.0";
  write(checked.path / certificate_record, json.dump());
  CHECK(checked.state("1", checked.audit) == State::stale);
}

TEST_CASE("what Coq does not accept is refused, and with it what rests on it") {
  const auto refused = [](const auto& spoil, const std::string& reason) {
    const Checked checked;
    spoil(checked.path);
    const Json json = checked.look();
    CHECK_FALSE(all_accepted(json));
    CHECK(json.at("claims").at(0).at("reason").get<std::string>() == reason);
    CHECK(json.at("claims").at(1).at("reason") == "it rests on Claim_1, which is not accepted");
    CHECK(checked.state("1", checked.audit) == State::refused);
    CHECK(text_of(json).ends_with("0 of 2 theorems certified, 0 axioms\n"));
  };
  refused([](const fs::path& path) { fs::remove(path / "Claim_1.vo"); },
          "Coq does not accept it: see Claim_1.log");
  refused([](const fs::path& path) { write(path / "Claim_1.v", "changed"); },
          "its file is not the one that was written");
  refused([](const fs::path& path) { write(path / "Axioms.log", "Axioms:\nevil : False\n"); },
          "it, or another of those that Axioms.v names, rests on evil");
  const char * const unsaid = "Coq did not say what its theorems rest on";
  refused([](const fs::path& path) { write(path / "Axioms.log", ""); }, unsaid);
  refused([](const fs::path& path) { fs::remove(path / "Axioms.v"); }, unsaid);
  refused(
      [](const fs::path& path) {
        write(path / "Axioms.v", "apply (Matrices.and_also Claim_2.theorems).\n");
        write(path / "Axioms.log", "Axioms:\n");
      },
      unsaid);
  refused(
      [](const fs::path& path) {
        fs::last_write_time(path / "Axioms.log", fs::file_time_type::clock::now() - std::chrono::hours(1));
      },
      unsaid);
}

TEST_CASE("where Coq was not asked nothing is refused") {
  const Checked checked;
  fs::remove(checked.path / "Claim_1.vo");
  fs::remove(checked.path / "Claim_1.log");
  const Json json = checked.look();
  CHECK_FALSE(all_accepted(json));
  CHECK(json.at("claims").at(0).at("reason") == "Coq was not asked");
  CHECK(json.at("claims").at(1).at("reason") == "it rests on Claim_1, of which Coq was not asked");
  CHECK(checked.state("1", checked.audit) == State::unknown);
  CHECK(checked.state("2", checked.audit) == State::unknown);
}

TEST_CASE("a log from before the file was changed says nothing of it, and one without end says so") {
  const auto reason = [](const char * log, int hours) {
    const Checked checked;
    fs::remove(checked.path / "Claim_1.vo");
    write(checked.path / "Claim_1.log", log);
    fs::last_write_time(checked.path / "Claim_1.log",
                        fs::file_time_type::clock::now() + std::chrono::hours(hours));
    return checked.look().at("claims").at(0).at("reason").get<std::string>();
  };
  CHECK(reason("Error: no", -1) == "Coq was not asked");
  CHECK(reason("Error: no", 1) == "Coq does not accept it: see Claim_1.log");
  CHECK(reason("no end within 600 seconds", 1) == "Coq did not come to an end in time: see Claim_1.log");
}

TEST_CASE("asking for one claim keeps what Coq said of the others, unless something has changed") {
  const Checked same;
  (void)same.look();
  same.write_again("text of Claim_1");
  CHECK(same.state("1", same.audit) == State::certified);
  CHECK(same.state("2", same.audit) == State::certified);
  const std::string said = text_of(same.look());
  CHECK(said.starts_with("2 "));
  CHECK(said.ends_with("with all that the directory holds: 2 of 2\n1 of 1 theorems certified, 1 axioms\n"));

  const Checked changed;
  (void)changed.look();
  changed.write_again("another text");
  CHECK(changed.state("1", changed.audit) == State::unknown);
  CHECK(changed.state("2", changed.audit) == State::unknown);  // it rests on 1
}

TEST_CASE("a file compiled before what all stand on, or on another text of that, is not accepted") {
  const auto after = [](const auto& spoil) {
    const Checked checked;
    write(checked.path / "Matrices.v", "lemmas");
    Json json = Json::parse(std::ifstream(checked.path / certificate_record));
    json["foundations"] = {{{"file", "Matrices.v"}, {"text", certificates::fingerprint("lemmas")}}};
    write(checked.path / certificate_record, json.dump());
    const auto at = [&](const char * name, int hours) {
      fs::last_write_time(checked.path / name, fs::file_time_type::clock::now() + std::chrono::hours(hours));
    };
    write(checked.path / "Matrices.vo", "compiled");
    at("Matrices.v", -3);
    at("Matrices.vo", -2);
    spoil(checked.path, at);
    return checked.look().at("claims").at(0);
  };
  CHECK(after([](const auto&, const auto&) {}).at("accepted") == true);
  const Json older = after([](const auto&, const auto& at) { at("Matrices.vo", 1); });
  CHECK(older.at("accepted").is_null());
  CHECK(older.at("reason") == "Coq was not asked since the lemmas below it have changed");
  const Json other =
      after([](const fs::path& path, const auto&) { write(path / "Matrices.v", "other lemmas"); });
  CHECK(other.at("accepted") == false);
  CHECK(other.at("reason") == "Matrices.v is not the one that was written");
}

TEST_CASE("a file compiled before the one that it imports is not accepted") {
  const Checked checked;
  for (const char * later : {"Claim_1.vo", "Axioms.log"}) {
    fs::last_write_time(checked.path / later, fs::file_time_type::clock::now() + std::chrono::hours(1));
  }
  const Json json = checked.look();
  CHECK(json.at("claims").at(0).at("accepted") == true);
  CHECK(json.at("claims").at(1).at("reason") == "it was compiled before Claim_1");
}

TEST_CASE("without a record nothing is certified, a wrong one is refused") {
  const methods::Audit audit = audit_of(kernel::Theorem::reflexive(x));
  const Certification none = certification(audit);
  CHECK(none.claims.at("1").state == State::unknown);
  CHECK(none.line.find("Coq was not asked about the 2 claims") != std::string::npos);
  const TemporaryDirectory temporary;
  CHECK_THROWS_AS((void)checked(temporary.path()), InputOutputError);
  write(temporary.path() / certificate_record, "{]");
  CHECK_THROWS_AS((void)certification(audit, temporary.path() / certificate_record), InputOutputError);
}

TEST_CASE("reports carry it") {
  Certification certified;
  certified.claims["44"] = {State::certified, "Claim_44.v", "2 theorems on 4 axioms"};
  certified.claims["5"] = {State::refused, "Claim_5.v", "Coq does not accept it: see Claim_5.log"};
  certified.line = "Certified by Coq: one.";
  const Json json =
      to_json(report::sample_paper(), report::sample_audit(), "stickslip audit", {}, {}, certified);
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
      terminal_report(report::sample_paper(), report::sample_audit(), {.width = 80}, certified);
  CHECK(text.find("Not certified, Coq does not accept it: see Claim_5.log: 5.\n") != std::string::npos);
  CHECK(text.ends_with("Certified by Coq: one.\n"));
}
