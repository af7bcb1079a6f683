// A paper as a value: what is printed, and the claims that are made of it. Provers, reports and the command
// line are handed one and know no other.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/decimal.hpp"
#include "numeric/families/orbit.hpp"
#include "numeric/motion/domain.hpp"
#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::symbols {
class Vocabulary;
}

namespace stickslip::proofs::methods {

struct Bibliography {
  std::string author, title, journal, doi;
  std::string text = {};  // which text of it was read, and what that lacks: a sentence for its errata
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
using Examples = std::vector<Example>;

// A hypothesis that the paper does not state, judged: what is true where it fails.
struct Judgement {
  std::string origin;              // id of the claim whose proof divides by it
  bool matters = true;             // the paper's result is lost where it fails
  std::string words;               // what is true there, or which proof does without it
  std::set<std::string> shown_by;  // ids of the claims that show that
};

// A statement of the paper in our own words, and the claims that state it. A numbered equation is one
// statement, whatever its parts; a part of another kind, or with an argument of its own, is another.
struct PrintedStatement {
  std::string id;     // "S047": permanent
  std::string place;  // "after (12)", "Fig. 2 caption"
  Kind kind = Kind::step;
  std::string words;
  std::vector<std::string> claims = {};  // ids; they say all of it if nothing is missing
  std::string missing = {};              // what they leave unsaid; without claims, why there is none
  std::vector<std::string> see = {};     // ids of claims that touch it, and say something else
  std::string section = {};              // "Section 4"
  // Ids of claims that say it on another fair reading, and the example at whose data alone it speaks: "S".
  std::vector<std::string> or_read = {};
  std::string example = {};
};

// What there is to say about a claim of the paper that does not hold as it stands: the statement apart from
// its denial.
struct Remark {
  std::string claim;       // id
  std::string place;       // "line after (37)": for who has the paper before her
  std::string says;        // what the paper says
  std::string fact;        // what is so
  std::string because;     // why; may be empty
  std::string see = {};    // a command that shows it; may be empty
  std::string quote = {};  // the paper's own words, literally; empty where it has none for it
  std::string note = {};   // what a reader of the printed page should look at; may be empty
};

// A result of the audit, to be cited.
struct Result {
  std::string id;                   // "uniqueness": permanent
  std::string title;                // "Orbits that never stick are unique"
  std::string setting = {};         // what it speaks of, for who does not have the paper
  std::string theorem;              // with all hypotheses
  std::string idea;                 // of the proof
  std::string see;                  // the command that checks it
  std::vector<std::string> claims;  // ids; the first is the theorem
  bool lists = false;               // what the claims found is a part of the theorem
};

struct Paper {
  Bibliography bibliography;
  std::vector<Section> sections;                  // in the paper's order
  std::vector<Claim> claims;                      // section by section
  Examples examples;                              // in the paper's order
  std::vector<Judgement> judgements;              // one for each claim that brings in hypotheses
  std::vector<PrintedStatement> statements = {};  // in the paper's order
  std::vector<Remark> remarks = {};               // the weightiest first
  std::vector<Result> results = {};               // the strongest first
  // For certificates: names of what is long in many statements, each after those that it uses.
  std::vector<kernel::Definition> abbreviations = {};
  // What its symbols mean; null for the oscillator's.
  std::shared_ptr<const symbols::Vocabulary> vocabulary = {};
};

// Whether every claim of the paper is in the audit.
[[nodiscard]] bool is_whole(const Paper& paper, const Audit& audit);

// Whether one of its statements names the claim as stating it.
[[nodiscard]] bool is_stated(const Paper& paper, const std::string& claim);

// The claims that state it, on whichever reading.
[[nodiscard]] std::vector<std::string> stating(const PrintedStatement& statement);

// The data of an example, phi and u_r among them as far as they are data.
[[nodiscard]] std::vector<Coordinate> data_of(const Example& example);

// The statements that the audit answers: all if it is whole, else those whose claims all are in it.
[[nodiscard]] std::vector<const PrintedStatement *> statements_in(const Paper& paper, const Audit& audit);

// The worst status of the claims that state it, one that is not in the audit being undecided, where
// - a premise counts beside others only if the statement is a condition;
// - a definition holds wherever it is defined;
// - hypotheses that hold at the data of the statement's example do not count;
// on_one_reading if those of one reading are refuted and those of the other stand, else the worse of two
// readings; in_part if something is missing, and nothing worse is known than a hypothesis;
// not_stated without claims.
[[nodiscard]] Status status_of(const Paper& paper, const PrintedStatement& statement, const Audit& audit);

// What there is to say about the claim, or null.
[[nodiscard]] const Remark * remark_on(const Paper& paper, const std::string& claim);

// The ids that a word names: a claim (47.c1), an equation with all its parts (47), a place (sec4, A3), a
// kind, an origin (paper, new). Throws UsageError naming the word and what there is.
[[nodiscard]] std::set<std::string> ids_named(const std::vector<Claim>& claims, const std::string& word);

// The first id of a claim about a part of an equation, to show what such ids look like: "44.H". Empty if
// there is none.
[[nodiscard]] std::string id_of_a_part(const std::vector<Claim>& claims);

// Throws UsageError naming the known ones when there is no example of that name.
[[nodiscard]] const Example& example_named(const Examples& examples, const std::string& name);

// "S, O or P".
[[nodiscard]] std::string names_of(const Examples& examples);

}  // namespace stickslip::proofs::methods
