// Changed certificates: Coq refuses them, or what they state is seen to be something else.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <regex>

#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "tests/proofs/certificates/coq.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using namespace stickslip::proofs;

namespace {

// A theorem or lemma of a file.
struct Proved {
  std::string name, statement, proof;
};

std::vector<Proved> theorems_of(const std::string& text) {
  static const std::regex theorem(R"((?:^|\n)(?:Lemma|Theorem) (\S+) :\n([^]*?)\.\nProof\.\n([^]*?)\nQed\.)");
  std::vector<Proved> all;
  for (std::sregex_iterator one(text.begin(), text.end(), theorem), end; one != end; ++one) {
    all.push_back({(*one)[1], (*one)[2], (*one)[3]});
  }
  return all;
}

struct Edit {
  const char * kind;
  std::regex what;
  const char * by;
};

const std::vector<Edit> edits{
    {"sign", std::regex(R"( \+ (?!0\b))"), " - "},
    {"sign", std::regex(R"( - (?!0\b))"), " + "},
    {"sign", std::regex(R"( -m )"), " +m "},
    {"sign", std::regex(R"(\(-1\))"), "1"},
    {"bound", std::regex(R"( < )"), " <= "},
    {"bound", std::regex(R"( <= )"), " < "},
    {"bound", std::regex(R"(0 < )"), "1 < "},
    {"range", std::regex(R"(0 <(=?) (\w+) <(=?) (\w+) ->)"), "0 <$1 $2 <$3 2 * $4 ->"},
    {"range", std::regex(R"(continuous_on_m X 0 (\w+))"), "continuous_on_m X 1 $1"},
    {"index", std::regex(R"(\bomega1\b)"), "omega2"},
    {"index", std::regex(R"(\bH1\b)"), "H2"},
    {"index", std::regex(R"(\bent 0 0\b)"), "ent 0 1"},
    {"number", std::regex(R"(([^^]) 2 (?=[*+/-]))"), "$1 3 "},
    {"number", std::regex(R"(\b1 (?=[*+/^-]))"), "2 "},
    {"number", std::regex(R"(= 0\b)"), "= 1"},
    {"cos and sin", std::regex(R"(\bcos\b)"), "sin"},
    {"cos and sin", std::regex(R"(\bsin\b)"), "cos"},
};

struct Mutant {
  std::string kind, of;
  Asked asked;
  bool states_the_same = false;
};

// Every edit at its first places between two offsets.
void edited(const std::string& text, std::size_t from, std::size_t to, int places,
            const std::function<void(const char * kind, const std::string& other)>& take) {
  for (const Edit& edit : edits) {
    const std::string part = text.substr(from, to - from);
    std::sregex_iterator one(part.begin(), part.end(), edit.what), end;
    for (int count = 0; count < places && one != end; ++count, ++one) {
      const std::string head = text.substr(0, from + static_cast<std::size_t>(one->position()));
      const std::string tail = one->suffix().str() + text.substr(std::min(to, text.size()));
      if (const std::string other = head + one->format(edit.by) + tail; other != text) {
        take(edit.kind, other);
      }
    }
  }
}

// The name that the proof gives to a premise is no longer there.
std::optional<Asked> without_premise(const Proved& proved, std::size_t which) {
  std::size_t at = proved.statement.find(",\n");
  for (std::size_t k = 0; at != std::string::npos && k <= which; ++k) {
    const std::size_t begin = proved.statement.find('\n', k == 0 ? at : at + 1);
    const std::size_t end = proved.statement.find(" ->\n", begin);
    if (begin == std::string::npos || end == std::string::npos) {
      return std::nullopt;
    }
    if (k == which) {
      std::string proof = proved.proof;
      const std::string name = " hyp" + std::to_string(which + 1);
      const std::size_t dot = proof.find('.'), place = proof.find(name);
      if (place == std::string::npos || place > dot) {
        return std::nullopt;
      }
      return Asked{std::string(proved.statement).erase(begin, end + 3 - begin),
                   proof.erase(place, name.size())};
    }
    at = end + 2;
  }
  return std::nullopt;
}

std::vector<Mutant> mutants_of(const Proved& proved, int places) {
  std::vector<Mutant> all;
  const std::size_t after_binders = proved.statement.find(",\n");
  edited(
      proved.statement, after_binders == std::string::npos ? 0 : after_binders, std::string::npos, places,
      [&](const char * kind, const std::string& other) {
        all.push_back({std::string(kind) + ", in what is stated", proved.name, {other, proved.proof}, false});
      });
  // What the kernel's step was given: the combination.
  if (const std::size_t at = proved.proof.find("  apply (by_"); at != std::string::npos) {
    edited(proved.proof, at, proved.proof.find('\n', at), places,
           [&](const char * kind, const std::string& other) {
             all.push_back(
                 {std::string(kind) + ", in the derivation", proved.name, {proved.statement, other}, true});
           });
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (const std::optional<Asked> asked = without_premise(proved, k)) {
      all.push_back({"a hypothesis dropped", proved.name, *asked, false});
    }
  }
  return all;
}

std::string content_of(const certificates::Certificates& all, const std::string& name) {
  for (const certificates::File& file : all.files) {
    if (file.name == name) {
      return file.text;
    }
  }
  return "";
}

}  // namespace

TEST_CASE("Coq accepts the certificates, rests on nothing foreign, and no changed one stands" *
          doctest::timeout(3600)) {
  const char * const asked_for = std::getenv("STICKSLIP_CERTIFICATE_MUTANTS");
  const bool all = asked_for != nullptr && std::string(asked_for) == "all";
  // An identity, signs in balls, a motion with all that it rests on, numbers; and more of each.
  const std::set<std::string> few{"38.init", "40", "3.domain", "10"},
      many{"38.init", "40",       "3.domain", "10", "41.group", "44.H",           "44.F",
           "5",       "A5.falls", "12",       "39", "6.H",      "39.frequencies", "4.lag.needed"};
  const TemporaryDirectory temporary;
  const certificates::Certificates certificates = compiled(temporary.path(), all ? many : few);
  methods::Prover prover(pascal2012::paper().claims);
  std::ifstream log(temporary.path() / "Final.log");
  const std::string said{std::istreambuf_iterator<char>(log), {}};
  CHECK(said.find("Axioms:") != std::string::npos);
  CHECK(said.find("Int63") == std::string::npos);
  CHECK(said.find("admit") == std::string::npos);
  std::map<std::string, std::array<int, 4>> counts;  // made, refused by Coq, seen to differ, neither
  int made = 0;
  for (const certificates::Certificate& certificate : certificates.certificates) {
    if (!(all ? many : few).contains(certificate.claim)) {
      continue;
    }
    CAPTURE(certificate.name);
    std::vector<Proved> proved = theorems_of(content_of(certificates, certificate.name + ".v"));
    std::vector<Mutant> mutants;
    std::vector<Asked> asked;
    int lemmas = 0;
    for (const Proved& one : proved) {
      const bool is_claim = one.name == certificate.theorems.front();
      // A truth table says the same of other letters; a step of the derivation may be any truth.
      if (is_claim || (one.proof.find("by_") != std::string::npos && ++lemmas <= (all ? 4 : 1))) {
        asked.push_back({one.statement, one.proof});  // as it is
        mutants.push_back({"as it is", one.name, asked.back(), true});
        for (const Mutant& mutant : mutants_of(one, all ? 2 : 1)) {
          mutants.push_back(mutant);
          asked.push_back(mutant.asked);
        }
      }
    }
    std::set<std::string> imports = certificate.imports;
    imports.insert(certificate.name);
    const std::vector<bool> answers = accepted(temporary.path(), imports, asked);
    // What the claim says, as it would be written now.
    std::set<std::string> says;
    for (const certificates::NamedTheorem& one :
         certificates::named_theorems(prover.prove(certificate.claim))) {
      says.insert(certificates::stated(one.theorem).text);
    }
    for (std::size_t i = 0; i < mutants.size(); ++i) {
      CAPTURE(mutants[i].of);
      CAPTURE(mutants[i].kind);
      CAPTURE(mutants[i].asked.statement);
      CAPTURE(mutants[i].asked.proof);
      if (mutants[i].kind == "as it is") {
        CHECK(answers[i]);
        continue;
      }
      // A truth that is not the claim's, or a lemma that is another one, which the theorem after it cannot
      // use.
      const bool differs = !mutants[i].states_the_same && !says.contains(mutants[i].asked.statement);
      auto& count = counts[mutants[i].kind];
      ++made;
      ++count[0];
      ++count[!answers[i] ? 1U : differs ? 2U : 3U];
      CHECK((!answers[i] || differs));
    }
  }
  CHECK(made >= (all ? 400 : 60));
  for (const auto& [kind, count] : counts) {
    std::cout << fmt::format(
        "{:<32} {:>4} made, {:>4} refused by Coq, {:>3} true and seen to differ, {} stand\n", kind, count[0],
        count[1], count[2], count[3]);
  }
}
