// What the files for Coq say, without Coq.
#include "proofs/certificates/certificates.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <iostream>

#include "core/error.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/tactics/tactics.hpp"
#include "tests/proofs/kernel/refuses.hpp"

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

TEST_CASE("values of several variables are given at once, without a lemma for each") {
  const Variable x{"x"}, y{"y"};
  const Formula inside = less(x, y);
  const Theorem one = Theorem::sign(less(1, 2));
  const Theorem both =
      Theorem::witness(Theorem::witness(one, exists(y, less(1, y)), 2), exists(x, exists(y, inside)), 1);
  certificates::Library library;
  Script script("file", library);
  script.add("name", both);
  CHECK(script.text().find("refine (ex_intro _ 1 (ex_intro _ 2 _)).") != std::string::npos);
  CHECK(script.text().find("Lemma") == std::string::npos);
}

namespace {

std::size_t places_of(const std::string& word, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("a number that is bounded on both sides is enclosed once") {
  const Variable x{"x"};
  const auto bounded = [&](const Formula& one) {
    return Theorem::sign(one, {{x, {1, stickslip::Rational(3, 2)}}});
  };
  const Term square = Term(x) * x;
  certificates::Library library;
  Script script("file", library);
  script.add("both", tactics::both(
                         {bounded(at_most(stickslip::Rational(1, 2), square)), bounded(at_most(square, 5))}));
  CHECK(places_of("by_enclosure", script.text()) == 1);
  CHECK(places_of("(proj1 (file_between", script.text()) == 1);
  CHECK(places_of("(proj2 (file_between", script.text()) == 1);
  // Not where one side is strict and the other is not, nor of different numbers.
  for (const Formula& other : {less(square, 6), at_most(square * x, 12)}) {
    certificates::Library empty;
    Script apart("apart", empty);
    apart.add("apart", tactics::both({bounded(at_most(stickslip::Rational(1, 4), square)), bounded(other)}));
    CHECK(places_of("by_enclosure", apart.text()) == 2);
    CHECK(places_of("between", apart.text()) == 0);
  }
}

TEST_CASE("a bound of many letters that many steps assume stands in full in the theorem and once before it") {
  const Variable x{"x"};
  const stickslip::Rational low(1'000'000'000'000'000'001, 1'000'000'000'000'000'000);
  std::vector<Theorem> parts;
  for (int k = 2; k < 7; ++k) {
    parts.push_back(Theorem::sign(less(0, power(Term(x), k)), {{x, {low, stickslip::Rational(5, 4)}}}));
  }
  certificates::Library library;
  Script script("file", library);
  script.add("all", tactics::both(parts));
  const std::string bound = "1000000000000000001 / 1000000000000000000 <= x";
  CHECK(places_of(bound, script.text()) == 2);
  CHECK(script.text().find(bound) > script.text().find("Definition file_said"));
  CHECK(script.text().rfind(bound) > script.text().find("Theorem all"));
}

TEST_CASE("a matrix of which the inverse stands in an identity is one letter where it may be any") {
  const Variable A{"A", real_matrix(4, 4)}, B{"B", real_matrix(4, 4)}, x{"x", real_matrix(4, 1)};
  const auto text_of_inverse = [&](const Term& M, const Term& right) {
    certificates::Library library;
    Script script("file", library);
    script.add("name", Theorem::combination(equal(inverse(M) * (M * x), right)));
    return script.text();
  };
  const Term M = Term(A) * B + Term(B) * A;
  CHECK(text_of_inverse(M, x).find("generalize (A ** B +m B ** A); intros v_letter_20_0.") !=
        std::string::npos);
  CHECK(text_of_inverse(A, x).find("letter") == std::string::npos);
}

TEST_CASE("a long number of which several signs are found is read once") {
  const Variable x{"x"};
  Term number = x;
  for (int k = 0; k < 60; ++k) {
    number = cos(number) + 2;
  }
  const auto text_of_signs = [&](const Term& of, int pieces) {
    std::vector<Theorem> signs;
    for (int k = 0; k < pieces; ++k) {
      signs.push_back(Theorem::sign(less(0, of), {{x, {k, k + 1}}}));
    }
    certificates::Library library;
    Script script("file", library);
    script.add("all", tactics::both(signs));
    return script.text();
  };
  const std::string text = text_of_signs(number, 4);
  CHECK(places_of("number_read", text) == 1);
  CHECK(places_of("exact_no_check (eq_refl", text) == 1);
  CHECK(places_of("by_known_enclosure", text) == 4);
  CHECK(places_of("reduce_matrices; by_enclosure", text) == 0);
  // Not for two signs, nor for a short number.
  for (const std::string& other : {text_of_signs(number, 2), text_of_signs(cos(x) + 2, 4)}) {
    CHECK(places_of("number_read", other) == 0);
    CHECK(places_of("by_known_enclosure", other) == 0);
  }
}

TEST_CASE("what follows from what says the same is not stated again") {
  const Variable x{"x"}, y{"y"};
  const Theorem one = Theorem::combination(equal(Term(x) + x, Term(2) * x)),
                same = Theorem::instantiate(Theorem::instantiate(one, {{x, y}}), {{y, x}});
  certificates::Library library;
  Script script("file", library);
  script.add("name", tactics::both({same, Theorem::reflexive(x)}));
  CHECK(places_of("by_fractions", script.text()) == 1);
  CHECK(places_of("Lemma", script.text()) <= 3);
}

TEST_CASE("a long number that stands in a sign again and again is a letter between bounds") {
  Term number = pi();
  for (int k = 0; k < 20; ++k) {
    number = cos(number) + 2;
  }
  certificates::Library library;
  Script script("file", library);
  script.add("long", Theorem::sign(less(0, number * number + number)));
  const std::string text = script.text();
  CHECK(text.find("apply by_distance.") != std::string::npos);
  std::size_t letters = 0;
  for (std::size_t at = text.find("generalize "); at != std::string::npos;
       at = text.find("generalize ", at + 1)) {
    ++letters;
  }
  CHECK(letters == 1);
  Script other("other", library);
  other.add("short", Theorem::sign(less(0, cos(pi()) + 2)));
  CHECK(other.text().find("generalize") == std::string::npos);
}

TEST_CASE("a part of a long conjunction is taken by its place, within the part that holds it") {
  std::vector<Formula> parts;
  for (int k = 0; k < 6; ++k) {
    parts.push_back(less(Variable{"x"}, k));
  }
  parts[4] = kernel::all({less(0, 1), equal(Variable{"x"}, 2)});
  const auto proof_of = [&](const Formula& part) {
    certificates::Library library;
    Script script("file", library);
    script.add("name", Theorem::consequence({Theorem::assume(kernel::all(parts))}, part));
    return script.text();
  };
  CHECK(proof_of(parts[4].parts()[1]).find("exact_part ((4%nat, true) :: (1%nat, false) :: nil) hyp1.") !=
        std::string::npos);
  CHECK(proof_of(parts[5]).find("exact_part ((5%nat, false) :: nil) hyp1.") != std::string::npos);
  CHECK(places_of("proj2", proof_of(parts[5])) == 0);
}

TEST_CASE("cosines and sines stay where they stand: Coq reads them as letters") {
  const Variable x{"x"}, y{"y"};
  certificates::Library library;
  Script script("file", library);
  script.add("name", Theorem::combination(equal(sin(Term(x) + y) * inverse(Term(x)),
                                                (sin(x) * cos(y) + cos(x) * sin(y)) * inverse(Term(x)))));
  CHECK(places_of("generalize", script.text()) == 0);
  CHECK(script.text().find("revert n'0 C'0 S'0 K'0 K'1.\n  forget.\n  reduce_matrices; intros n'0 C'0 S'0 "
                           "K'0 K'1; split_factors; by_fractions.") != std::string::npos);
}

TEST_CASE("whether coqchk is asked depends on what a file holds, not on how long it took") {
  const certificates::Certificates all = certificates::certificates(claims(), {"S.det", "45", "40"});
  const auto of = [&](const std::string& claim) {
    return std::ranges::find_if(all.certificates, [&](const auto& one) { return one.claim == claim; });
  };
  CHECK(of("S.det")->many_enclosures);
  CHECK_FALSE(of("45")->many_enclosures);
  CHECK_FALSE(of("40")->many_enclosures);
}

TEST_CASE("a file that loads interval arithmetic is not loaded for a few steps") {
  const Variable x{"x"};
  const Theorem lemma = Theorem::combination(equal(Term(x) + x, Term(2) * x));
  certificates::Library library;
  Script first("first", library), second("second", library);
  first.add("known", lemma);
  library.slow.insert("first");
  second.add("instance", Theorem::instantiate(lemma, {{x, 3}}));
  CHECK(second.imports().empty());
  CHECK(second.text().find("known") == std::string::npos);
}

TEST_CASE("a long assumption of many steps is written once, and in full where it is the theorem's") {
  const certificates::Certificates all = certificates::certificates(claims(), {"S.orbit"});
  const std::string text = text_of(all, "Claim_S_orbit.v");
  const auto count = [&](const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
      ++found;
    }
    return found;
  };
  const std::size_t definitions = count("Definition Claim_S_orbit_said");
  CHECK(definitions > 0);
  CHECK(count("Claim_S_orbit_said") > 3 * definitions);
  std::size_t theorems = 0;
  for (std::size_t at = text.find("\nTheorem "); at != std::string::npos;
       at = text.find("\nTheorem ", at + 1)) {
    CHECK(text.substr(at, text.find("Proof.", at) - at).find("_said") == std::string::npos);
    ++theorems;
  }
  CHECK(theorems > 0);
}

TEST_CASE("nothing is admitted, nothing is an axiom, and every theorem is asked what it rests on") {
  const certificates::Certificates all = certificates::certificates(claims(), {"40", "44.H", "47.c"});
  CHECK(all.certificates.size() >= 3);
  for (const certificates::File& file : all.files) {
    CAPTURE(file.name);
    if (file.name == "Makefile") {
      continue;
    }
    for (const char * word :
         {"Admitted", "admit.", "Axiom", "Parameter ", "Hypothesis", "Variable ", "Conjecture", "Unset "}) {
      CHECK(file.text.find(word) == std::string::npos);
    }
  }
  for (const certificates::Certificate& one : all.certificates) {
    const std::string text = text_of(all, one.name + ".v");
    for (const std::string& theorem : one.theorems) {
      CHECK(text.find(" *)\nTheorem " + theorem + " :\n") != std::string::npos);
      const std::string typed =
          "(Stickslip." + one.name + "." + theorem + " : Stickslip.Statements." + theorem + ")";
      for (const std::string& line : {"\nCheck " + typed + ".\n", "and_also " + typed + ").\n"}) {
        CHECK((text_of(all, "Final.v").find(line) != std::string::npos) == one.asked);
      }
      CHECK(text_of(all, "Statements.v").find(" *)\nDefinition " + theorem + " : Prop :=\n") !=
            std::string::npos);
    }
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

TEST_CASE("a long statement whose parts have names has a certificate, which speaks of these") {
  const certificates::Certificates all = certificates::certificates(claims(), {"O.23"});
  CHECK(all.uncertified.empty());
  const std::string text = text_of(all, "Claim_O_23.v"), said = text_of(all, "Statements.v");
  CHECK(text.size() < 3'000'000);
  const std::size_t from = said.find("Definition claim_O_23_1 : Prop :=");
  REQUIRE(from != std::string::npos);
  CHECK(said.size() - from < 8000);
  CHECK(said.find("9817 / 2000 <= tau <= 9819 / 2000", from) != std::string::npos);
  CHECK(said.find("O_a_4 omega1 omega2 tau", from) != std::string::npos);
  CHECK(said.find("Definition O_Htilde13_is") < from);
}

TEST_CASE("an unknown id is no silence") {
  CHECK_THROWS_AS((void)certificates::certificates(claims(), {"40", "no such claim"}),
                  stickslip::InternalError);
}

TEST_CASE("what is kept is written too, and made only when asked") {
  const certificates::Certificates alone = certificates::certificates(claims(), {"40"}),
                                   both = certificates::certificates(claims(), {"40"}, {"42"});
  const auto is_asked = [](const certificates::Certificates& all, const std::string& claim) {
    const auto found =
        std::ranges::find_if(all.certificates, [&](const auto& one) { return one.claim == claim; });
    REQUIRE(found != all.certificates.end());
    return found->asked;
  };
  CHECK(is_asked(alone, "40"));
  CHECK(is_asked(both, "40"));
  CHECK_FALSE(is_asked(both, "42"));
  const auto goal = [](const certificates::Certificates& all) {
    const std::string text = text_of(all, "Makefile");
    const std::size_t at = text.find("ASKED =");
    return text.substr(at, text.find('\n', at) - at) + " ";
  };
  CHECK(goal(both).find(" Claim_40 ") != std::string::npos);
  CHECK(goal(both).find(" Claim_42 ") == std::string::npos);
  CHECK(text_of(both, "Final.v").find("Claim_42.") == std::string::npos);
  CHECK(text_of(both, "Claim_42.v").find("Theorem claim_42_1") != std::string::npos);
  // Whatever an asked claim imports is asked for too.
  for (const certificates::Certificate& one : both.certificates) {
    for (const std::string& import : one.imports) {
      const auto found =
          std::ranges::find_if(both.certificates, [&](const auto& other) { return other.name == import; });
      REQUIRE(found != both.certificates.end());
      CHECK((!one.asked || found->asked));
    }
  }
}

// Theorems of the kernel that say something else than the claim: less, of less, or of other things. The
// kernel makes them, so Coq would accept their export; only the comparison of what is said tells them apart.
TEST_CASE("what an audit records is another thing for every theorem that is not the claim's") {
  methods::Prover prover(claims());
  std::map<std::string, int> made;
  for (const char * id : {"38.init", "40", "42", "44.H", "3.domain", "6.H", "10", "12", "5", "A5.falls"}) {
    const methods::Record& record = prover.prove(id);
    CAPTURE(id);
    const std::string said = certificates::fingerprint(record);
    const auto differs = [&](const char * kind, std::size_t which, const Theorem& theorem) {
      methods::Record other = record;
      other.outcome.theorems[which] = theorem;
      CAPTURE(kind);
      CHECK(certificates::fingerprint(other) != said);
      ++made[kind];
    };
    for (std::size_t which = 0; which < record.outcome.theorems.size(); ++which) {
      const Theorem& theorem = record.outcome.theorems[which];
      differs("a hypothesis added", which, kernel::weakened(theorem, {less(Variable{"another"}, 0)}));
      for (const Formula& hypothesis : theorem.hypotheses()) {
        differs("a hypothesis moved", which, Theorem::discharge(theorem, hypothesis));
      }
      Variables variables = theorem.conclusion().variables();
      for (const Variable& variable : variables) {
        if (variable.type == real_number) {
          differs("a variable made a number", which, Theorem::instantiate(theorem, {{variable, 2}}));
          differs("a variable made its opposite", which,
                  Theorem::instantiate(theorem, {{variable, Term(-1) * variable}}));
        }
      }
      if (theorem.conclusion().kind() == Kind::conjunction) {
        differs("a part alone", which, Theorem::consequence({theorem}, theorem.conclusion().parts().front()));
      }
    }
    if (record.outcome.theorems.size() > 1) {
      methods::Record fewer = record;
      fewer.outcome.theorems.pop_back();
      CHECK(certificates::fingerprint(fewer) != said);
      ++made["a part left out"];
    }
  }
  int all = 0;
  for (const auto& [kind, count] : made) {
    std::cout << count << ' ' << kind << ", seen to differ\n";
    all += count;
  }
  CHECK(all >= 100);
}

TEST_CASE("claims have files of different names") {
  std::set<std::string> names;
  for (const methods::Claim& claim : claims()) {
    CHECK(names.insert(certificates::file_name(claim.id)).second);
  }
}
