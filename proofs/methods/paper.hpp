// A paper as a value: what is printed, and the claims that are made of it. Provers, reports and the command
// line are handed one and know no other.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/decimal.hpp"
#include "numeric/families/family.hpp"
#include "numeric/motion/domain.hpp"
#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

struct Bibliography {
  std::string author, title, journal, doi;
};

struct Section {
  std::string id;       // "sec3", "A1": the place of its claims
  std::string title;    // "Section 3: closed-form phases"
  std::string program;  // "section3": the name under which its identity checks run
};

// A printed result. Where the sign is not legible in the source, only the digits are a printed fact.
struct PrintedResult {
  std::string name;
  Decimal value;
  bool sign_lost = false;
};

// The data of a printed orbit, and the numbers that are printed for it.
struct Example {
  std::string name;    // "S"
  std::string figure;  // "Fig. 2"
  const numeric::families::Family * family = nullptr;
  numeric::motion::ExactParameters data;
  std::optional<Rational> phi, ur;  // as far as they are data of the family
  std::vector<PrintedResult> results;

  // Throws InternalError when there is no result of that name.
  [[nodiscard]] const PrintedResult& result(const std::string& result_name) const;
};

// A hypothesis that the paper does not state, judged: what is true where it fails.
struct Judgement {
  std::string origin;              // id of the claim whose proof divides by it
  bool matters = true;             // the paper's result is lost where it fails
  std::string words;               // what is true there, or which proof does without it
  std::set<std::string> shown_by;  // ids of the claims that show that
};

struct Paper {
  Bibliography bibliography;
  std::vector<Section> sections;      // in the paper's order
  std::vector<Claim> claims;          // section by section
  std::vector<Example> examples;      // in the paper's order
  std::vector<Judgement> judgements;  // one for each claim that brings in hypotheses
};

// The ids that a word names: a claim (47.c1), an equation with all its parts (47), a place (sec4, A3), a
// kind. Throws UsageError naming the word and what there is.
[[nodiscard]] std::set<std::string> ids_named(const std::vector<Claim>& claims, const std::string& word);

// The first id of a claim about a part of an equation, to show what such ids look like: "44.H". Empty if
// there is none.
[[nodiscard]] std::string id_of_a_part(const std::vector<Claim>& claims);

// Throws UsageError naming the known ones when there is no example of that name.
[[nodiscard]] const Example& example_named(const std::vector<Example>& examples, const std::string& name);

// "S, O or P".
[[nodiscard]] std::string names_of(const std::vector<Example>& examples);

}  // namespace stickslip::proofs::methods
