// What the files for Coq say, without Coq.
#include "proofs/certificates/certificates.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "proofs/certificates/script.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"

using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;
using certificates::Script;

namespace {

const std::vector<methods::Claim>& claims() {
  return pascal2012::paper().claims;
}

std::string text_of(const certificates::Certificates& all, const std::string& name) {
  const auto found =
      std::find_if(all.files.begin(), all.files.end(), [&](const auto& file) { return file.name == name; });
  REQUIRE(found != all.files.end());
  return found->text;
}

}  // namespace

TEST_CASE("a theorem states the kernel's sequent in full") {
  const Variable x{"x"}, y{"y"};
  const Theorem theorem = Theorem::combination(equal(Term(x) * inverse(x) * y, y));
  certificates::Library library;
  Script script("file", library);
  script.add("name", theorem);
  CHECK(script.text().find("Theorem name :\n  forall (x y : R),\n  x <> 0 ->\n  x / x * y = y.\nProof.") !=
        std::string::npos);
}

TEST_CASE("a file imports what another one has proved, and does not prove it again") {
  const Variable x{"x"};
  const Theorem lemma = Theorem::combination(equal(Term(x) + x, Term(2) * x));
  certificates::Library library;
  Script first("first", library), second("second", library);
  first.add("known", lemma);
  second.add("instance", Theorem::instantiate(lemma, {{x, 3}}));
  CHECK(second.imports() == std::set<std::string>{"first"});
  CHECK(second.text().find("known 3") != std::string::npos);
}

TEST_CASE("nothing is admitted, nothing is an axiom, and every theorem says what it rests on") {
  const certificates::Certificates all = certificates::certificates(claims(), {"40", "44.H", "47.c"});
  CHECK(all.certificates.size() >= 3);
  for (const certificates::File& file : all.files) {
    CAPTURE(file.name);
    for (const char * word :
         {"Admitted", "admit.", "Axiom", "Parameter ", "Hypothesis", "Variable ", "Conjecture", "Unset "}) {
      CHECK(file.text.find(word) == std::string::npos);
    }
  }
  for (const certificates::Certificate& one : all.certificates) {
    const std::string text = text_of(all, one.name + ".v");
    const std::size_t at = text.find("Definition theorems := (");
    REQUIRE(at != std::string::npos);
    const std::string bundle = text.substr(at);
    for (const std::string& theorem : one.theorems) {
      CHECK(text.find(" *)\nTheorem " + theorem + " :\n") != std::string::npos);
      CHECK(bundle.find(theorem) != std::string::npos);
    }
    CHECK(text.ends_with("Print Assumptions theorems.\n"));
  }
  CHECK(std::any_of(all.uncertified.begin(), all.uncertified.end(),
                    [](const auto& one) { return one.claim == "S.tau"; }) == false);
}

TEST_CASE("every theorem of a claim stands in its file, letter by letter") {
  methods::Prover prover(claims());
  for (const char * id : {"40", "5", "A5.falls"}) {
    const certificates::Certificates all = certificates::certificates(claims(), {id});
    const std::string text = text_of(all, certificates::file_name(id) + ".v");
    for (const Theorem& theorem : prover.prove(id).outcome.theorems) {
      CHECK(text.find(" :\n" + certificates::stated(theorem).text + ".\nProof.") != std::string::npos);
    }
  }
}

TEST_CASE("claims have files of different names") {
  std::set<std::string> names;
  for (const methods::Claim& claim : claims()) {
    CHECK(names.insert(certificates::file_name(claim.id)).second);
  }
}
