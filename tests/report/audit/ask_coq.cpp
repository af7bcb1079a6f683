// Manipulated certificates, put to `certify --record`: none may be called accepted. What is changed
// afterwards, an audit finds (certificates.cpp).
#include "report/audit/certificate_record.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "proofs/certificates/certificates.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/audit/three_claims.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using namespace stickslip::report;
using namespace stickslip::report::audit;
using stickslip::report::tools::Json;
namespace fs = std::filesystem;

namespace {

void sh(const fs::path& directory, const std::string& command) {
  const Run made = run("/bin/sh", {"-c", fmt::format("cd '{}' && {}", directory.string(), command)});
  CAPTURE(made.out);
  CAPTURE(made.err);
  CHECK(made.code == 0);
}

void compile(const fs::path& directory, const std::string& files) {
  sh(directory, "for file in " + files + "; do coqc -w none -Q . Stickslip $file.v || exit 1; done");
}

// The claims 1 to 6, compiled and recorded, all accepted. A copy for each test.
const fs::path& recorded() {
  static const TemporaryDirectory once;
  static const bool made = [] {
    write_certificates(once.path(), true, 3);
    sh(once.path(), "make --silent --jobs=2");
    const Json record = checked(once.path());
    CHECK(all_accepted(record));
    CHECK(text_of(record).find("\n6 of 6 theorems certified, ") != std::string::npos);
    for (const Json& claim : record.at("claims")) {
      CHECK(claim.at("again") == "accepted");
    }
    write(once.path() / certificate_record, report::tools::to_text(record));
    return true;
  }();
  CHECK(made);
  return once.path();
}

struct Copy {
  TemporaryDirectory temporary;
  fs::path path = temporary.path();
  Copy() { fs::copy(recorded(), path, fs::copy_options::recursive | fs::copy_options::overwrite_existing); }

  // Compiles the claim's file with this text, and puts the text that was recorded back.
  void compile_instead(const std::string& name, const std::string& text) const {
    const std::string before = text_in(path / (name + ".v"));
    write(path / (name + ".v"),
          "From Stickslip Require Import Algebra Calculus Definitions Auxiliary.\nOpen Scope R_scope.\n" +
              text);
    compile(path, name);
    write(path / (name + ".v"), before);
  }
};

std::string reason_of(const Json& record, const std::string& id) {
  const Json claim = claim_in(record, id);
  CHECK(claim.at("accepted") == false);
  return claim.at("reason");
}

}  // namespace

// One test, so that what all of them begin with is compiled and recorded once.
TEST_CASE("manipulated certificates are not accepted") {
  SUBCASE("the theorems of a claim are all that the statements have of it, under no other name") {
    for (const auto& [key, value] :
         {std::pair("theorems", Json::array()), std::pair("claim", Json("other"))}) {
      const Copy copy;
      Json record = read_record(copy.path / certificate_record);
      Json& claim = record.at("claims").at(0);
      claim[key] = value;
      write(copy.path / certificate_record, report::tools::to_text(sealed(record)));
      CHECK(reason_of(checked(copy.path), claim.at("claim")) ==
            "its theorems are not those that Statements.v has of it");
    }
  }
  SUBCASE("what a claim rests on is what its file imports") {
    const Copy copy;
    Json record = read_record(copy.path / certificate_record);
    for (Json& claim : record.at("claims")) {
      claim["imports"] = Json::array();
    }
    write(copy.path / certificate_record, report::tools::to_text(sealed(record)));
    record = checked(copy.path);
    CHECK(reason_of(record, "3") == "what it rests on is not what its file imports");
    CHECK(claim_in(record, "2").at("accepted") == true);
  }
  SUBCASE("a record that was edited is not looked at, whatever it says of its claims") {
    for (const auto& [key, value] : {std::pair("asked", Json(false)), std::pair("immediate", Json(0)),
                                     std::pair("intervals", Json(true))}) {
      const Copy copy;
      Json record = read_record(copy.path / certificate_record);
      record.at("claims").at(1)[key] = record.at("claims").at(1)[key] == value ? Json("other") : value;
      write(copy.path / certificate_record, report::tools::to_text(record));
      CHECK_THROWS_WITH_AS(checked(copy.path), doctest::Contains("is not as it was made"), InputOutputError);
    }
  }
  SUBCASE("what was compiled has to be what the statement says, whatever stands beside it") {
    const Copy copy;
    write(copy.path / "Claim_1.vo", "");
    fs::remove(copy.path / "Claim_2.vo");
    fs::remove(copy.path / "Claim_2.log");
    write(copy.path / "Final.log", "Axioms:\n");
    write(copy.path / "Axioms.log", "Axioms:\n");
    copy.compile_instead("Claim_4", "Theorem claim_4_1 : True.\nProof. exact I. Qed.\n");
    // The statement's own words, with another meaning.
    copy.compile_instead(
        "Claim_5",
        "Definition f (t : R) : R := 1.\nTheorem claim_5_1 : f 0 + 5 = 6.\nProof. unfold f; ring. "
        "Qed.\n");
    write(copy.path / "Claim_6.v", text_in(copy.path / "Claim_6.v") + "\n");
    const Json record = checked(copy.path);
    CHECK(reason_of(record, "1").starts_with("Coq says of what was compiled: "));
    CHECK(claim_in(record, "2").at("accepted").is_null());
    CHECK(claim_in(record, "3").at("reason") == "it rests on Claim_2, of which Coq was not asked");
    CHECK(reason_of(record, "4").starts_with("Coq says of what was compiled: "));
    CHECK(reason_of(record, "5").starts_with("Coq says of what was compiled: "));
    CHECK(reason_of(record, "6") == "its file is not the one that was written");
    CHECK(text_of(record).ends_with("0 of 6 theorems certified, 0 axioms\n"));
  }
  SUBCASE("what is admitted, or proved with a check switched off, is not accepted") {
    const auto reason = [](const std::string& before, const std::string& proof) {
      const Copy copy;
      copy.compile_instead("Claim_1", before + "Theorem claim_1_1 : f 0 = 1.\nProof. " + proof + "\n");
      return reason_of(checked(copy.path), "1");
    };
    CHECK(reason("", "Admitted.").find("rests on ") != std::string::npos);
    CHECK(reason("Axiom classic : False.\n", "destruct classic. Qed.").ends_with("classic : False"));
    CHECK(reason("Unset Guard Checking.\nFixpoint evil (n : nat) : False := evil n.\nSet Guard Checking.\n",
                 "destruct (evil O). Qed.")
              .find("is assumed to be guarded") != std::string::npos);
  }
  SUBCASE("definitions and lemmas that were others when the claims were compiled are found") {
    const auto none_accepted = [](const fs::path& path) {
      CHECK(text_of(checked(path)).find("\n0 of ") != std::string::npos);
    };
    // Theorems of f(t) = sin(t) + 1, under the texts for f(t) = cos(t).
    const TemporaryDirectory other;
    write_certificates(other.path(), false);
    sh(other.path(), "make --silent --jobs=2");
    write_certificates(other.path());
    none_accepted(other.path());
    // A prelude that says more than its text does.
    const Copy copy;
    const std::string before = text_in(copy.path / "Calculus.v"), word = "Definition derivative ";
    write(copy.path / "Calculus.v",
          std::string(before).insert(before.find(word), "Definition more : True := I.\n"));
    compile(copy.path, "Calculus Definitions Auxiliary Claim_1 Claim_2 Claim_3 Claim_4 Claim_5 Claim_6");
    write(copy.path / "Calculus.v", before);
    none_accepted(copy.path);
  }
  SUBCASE("what another claim's file was compiled to before is not what is imported now") {
    const Copy copy;
    const std::string before = text_in(copy.path / "Claim_2.v");
    write(copy.path / "Claim_2.v", before + "Lemma more : True.\nProof. exact I. Qed.\n");
    compile(copy.path, "Claim_2");
    write(copy.path / "Claim_2.v", before);
    const Json record = checked(copy.path);
    CHECK(claim_in(record, "1").at("accepted") == true);
    CHECK(claim_in(record, "3").at("accepted") == false);
  }
  SUBCASE("claims of one file are accepted together, or none of them, nor what imports it") {
    const TemporaryDirectory many;
    write_certificates(many.path(), true, 120);
    sh(many.path(), "make --silent --jobs=2");
    Json record = checked(many.path());
    CHECK(text_of(record).find("\n123 of 123 theorems certified, ") != std::string::npos);
    const std::string file = claim_in(record, "2").at("file"), before = text_in(many.path() / file);
    const std::string word = "f 0 + 5 = 6.";
    REQUIRE(before.find(word) != std::string::npos);
    write(many.path() / file,
          std::string(before).replace(before.find(word), word.size(), "f 0 + 5 = 1 * 6."));
    compile(many.path(), file.substr(0, file.size() - 2));
    write(many.path() / file, before);
    record = checked(many.path());
    for (const Json& claim : record.at("claims")) {
      const bool rests_on_it = claim.at("file") == file || claim.at("claim") == "3";
      CHECK(claim.at("accepted") == Json(!rests_on_it));
    }
  }
  SUBCASE("lemmas other than those that were written are not looked at") {
    const Copy copy;
    write(copy.path / "Calculus.v", text_in(copy.path / "Calculus.v") + "\n");
    CHECK(reason_of(checked(copy.path), "1") == "Calculus.v is not the one that was written");
  }
  SUBCASE("a log from before the file was changed says nothing of it, and one without end says so") {
    const auto reason = [](const char * log, int hours) {
      const Copy copy;
      for (int k = 1; k <= 6; ++k) {
        fs::remove(copy.path / fmt::format("Claim_{}.vo", k));
      }
      write(copy.path / "Claim_1.log", log);
      fs::last_write_time(copy.path / "Claim_1.log",
                          fs::file_time_type::clock::now() + std::chrono::hours(hours));
      return claim_in(checked(copy.path), "1").at("reason").get<std::string>();
    };
    CHECK(reason("Error: no", -1) == "Coq was not asked");
    CHECK(reason("Error: no", 1) == "Coq does not accept it: see Claim_1.log");
    CHECK(reason("no end within 600 seconds", 1) == "Coq did not come to an end in time: see Claim_1.log");
  }
}
