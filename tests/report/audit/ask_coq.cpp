// Manipulated certificates, put to `certify --record`: none may be called accepted. What is changed
// afterwards, an audit finds (certificates.cpp).
#include "report/audit/ask_coq.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "proofs/certificates/certificates.hpp"
#include "report/audit/certificate_record.hpp"
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

// The three claims, compiled and recorded, all accepted. A copy for each test.
const fs::path& recorded() {
  static const TemporaryDirectory once;
  static const bool made = [] {
    write_certificates(once.path());
    sh(once.path(), "make --silent --jobs=2");
    const Json record = checked(once.path());
    CHECK(all_accepted(record));
    CHECK(text_of(record).find("\n3 of 3 theorems certified, ") != std::string::npos);
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
};

const char * const head =
    "From Stickslip Require Import Algebra Calculus Definitions Auxiliary.\nOpen Scope R_scope.\n";

// What Coq says of claim 1 when its file was this, compiled, before the text that was recorded was put back.
Json with_other_text(const std::string& text) {
  const Copy copy;
  const std::string before = text_in(copy.path / "Claim_1.v");
  write(copy.path / "Claim_1.v", head + text);
  compile(copy.path, "Claim_1");
  write(copy.path / "Claim_1.v", before);
  const Json record = checked(copy.path);
  CHECK_FALSE(all_accepted(record));
  return claim_in(record, "1");
}

}  // namespace

TEST_CASE("a compiled file that is empty, or none, is not accepted, whatever logs say") {
  const Copy copy;
  write(copy.path / "Claim_1.vo", "");
  fs::remove(copy.path / "Claim_2.vo");
  fs::remove(copy.path / "Claim_2.log");
  write(copy.path / "Final.log", "Axioms:\n");
  write(copy.path / "Axioms.log", "Axioms:\n");
  const Json record = checked(copy.path);
  CHECK(claim_in(record, "1").at("accepted") == false);
  CHECK(claim_in(record, "2").at("accepted").is_null());
  CHECK(claim_in(record, "3").at("reason") == "it rests on Claim_2, of which Coq was not asked");
  CHECK(text_of(record).ends_with("0 of 3 theorems certified, 0 axioms\n"));
}

TEST_CASE("a file that was compiled from another text is not what its statement says") {
  CHECK(with_other_text("Theorem claim_1_1 : True.\nProof. exact I. Qed.\n").at("accepted") == false);
  const Json other = with_other_text("Theorem claim_1_1 : f 0 = 1 \\/ True.\nProof. right; exact I. Qed.\n");
  CHECK(other.at("reason").get<std::string>().starts_with("Coq says of what was compiled: "));
  // The statement's own words, with other meanings.
  CHECK(with_other_text(
            "Definition f (t : R) : R := 1.\nTheorem claim_1_1 : f 0 = 1.\nProof. reflexivity. Qed.\n")
            .at("accepted") == false);
}

TEST_CASE("what is admitted, or proved with a check switched off, is not accepted") {
  const char * const said = "Theorem claim_1_1 : f 0 = 1.\nProof. ";
  CHECK(
      with_other_text(fmt::format("{}Admitted.\n", said)).at("reason").get<std::string>().find("rests on") !=
      std::string::npos);
  CHECK(with_other_text(fmt::format("Axiom classic : False.\n{}destruct classic. Qed.\n", said))
            .at("reason")
            .get<std::string>()
            .ends_with(": False"));
  CHECK(with_other_text(fmt::format("Unset Guard Checking.\nFixpoint evil (n : nat) : False := evil n.\nSet "
                                    "Guard Checking.\n{}destruct (evil O). Qed.\n",
                                    said))
            .at("accepted") == false);
}

TEST_CASE("definitions and lemmas that were others when the claims were compiled are found") {
  const auto none_accepted = [](const fs::path& path) {
    CHECK(text_of(checked(path)).ends_with("0 of 3 theorems certified, 0 axioms\n"));
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
  compile(copy.path, "Calculus Definitions Auxiliary Claim_1 Claim_2 Claim_3");
  write(copy.path / "Calculus.v", before);
  none_accepted(copy.path);
}

TEST_CASE("what another claim's file was compiled to before is not what is imported now") {
  const Copy copy;
  const std::string before = text_in(copy.path / "Claim_2.v");
  write(copy.path / "Claim_2.v", before + "Lemma more : True.\nProof. exact I. Qed.\n");
  compile(copy.path, "Claim_2");
  write(copy.path / "Claim_2.v", before);
  const Json record = checked(copy.path);
  CHECK(claim_in(record, "1").at("accepted") == true);
  CHECK(claim_in(record, "3").at("accepted") == false);
}

TEST_CASE("texts other than those that were written are not looked at") {
  const Copy claim;
  write(claim.path / "Claim_1.v", text_in(claim.path / "Claim_1.v") + "\n");
  const Json record = checked(claim.path);
  CHECK(claim_in(record, "1").at("reason") == "its file is not the one that was written");
  CHECK(claim_in(record, "3").at("accepted") == true);
  const Copy lemmas;
  write(lemmas.path / "Calculus.v", text_in(lemmas.path / "Calculus.v") + "\n");
  CHECK(claim_in(checked(lemmas.path), "1").at("reason") == "Calculus.v is not the one that was written");
}

TEST_CASE("a log from before the file was changed says nothing of it, and one without end says so") {
  const auto reason = [](const char * log, int hours) {
    const Copy copy;
    for (const char * one : {"1", "2", "3"}) {
      fs::remove(copy.path / (std::string("Claim_") + one + ".vo"));
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
