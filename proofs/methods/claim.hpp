// Claims are data; verdicts are computed by their proofs, statuses from verdicts.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/verdict.hpp"
#include "proofs/kernel/theorem.hpp"
#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::methods {

// The paper's kinds of statement, of which claims in words and figures are no claims of ours; and a check in
// floating point, which proves nothing.
enum class Kind { definition, model, identity, step, theorem, condition, numbers, words, figure, check };

[[nodiscard]] std::string to_string(Kind kind);

// Whose statement a claim is.
enum class Origin {
  paper,       // printed: a statement of the paper names it (PrintedStatement in paper.hpp)
  textbook,    // as text books give it: the original is not at hand, and nothing is "as printed"
  reading,     // what the paper means or takes for granted, and does not print
  converse,    // the other direction of something printed, which the paper does not assert
  new_result,  // a result of the audit
  auxiliary,   // a step of ours on the way to others, or a check of our own
};

// All that is known about an origin.
struct OriginFacts {
  Origin origin;
  const char * name;     // "new": in data, on the command line
  const char * one;      // "new result"
  const char * many;     // "new results"
  const char * meaning;  // in half a sentence
  const char * says;     // of what does not hold: "The paper says"
  // Whose statements they are that it states: "the paper"; null of claims of our own.
  const char * source = nullptr;
};

// In the order of the enumeration.
[[nodiscard]] const std::vector<OriginFacts>& origins();
[[nodiscard]] const OriginFacts& facts(Origin origin);
[[nodiscard]] std::string to_string(Origin origin);

// Something that is taken for granted by the statement itself: "(13)" and its equation.
struct Assumption {
  std::string id;
  symbols::Statement statement;
};

// Something that a proof divided by: it holds where this is not zero.
struct Hypothesis {
  symbols::Term nonzero;  // what must not vanish: a polynomial in symbols, cosines and sines
  std::string text;       // "omega - omega1 != 0"
  std::string latex;      // the same
  std::string origin;     // the id of the claim whose proof divided by it
  // Whether who reads the formulas sees it (is_seen). Filled in by the Prover.
  bool visible = false;
};

// One printed value against the proved one.
struct Comparison {
  std::string name;     // "tau"
  std::string latex;    // its LaTeX name
  std::string printed;  // as printed
  Ball proved;
  Ball units_off;   // (proved - printed) in units of the last place
  Verdict verdict;  // proved: the printed value is the correctly rounded one
};

// An equation that is proved, or refuted, as the claim is, or an inequality that is refuted: as printed, with
// what the claim assumes to be "symbol = value" put in, or of two terms that its proof derived.
struct Decided {
  std::optional<symbols::Statement> statement = {};
  kernel::Term left = 0, right = 0;
};

// How two further engines looked at a verdict (cross_check.hpp).
struct CrossCheck {
  int formulas = 0;        // that were evaluated
  int exact_points = 0;    // rational points at which each of them agrees exactly
  int ball_points = 0;     // real points at which each of them agrees in balls
  int premise_points = 0;  // real points where what the claim rests on holds, and what it prints, in balls
  std::string unchecked = {};  // why there is nothing to evaluate
  bool identity = false;       // what is printed holds for all values of the symbols that have no value given
};

// Whether there are values with which all that a claim assumes holds: else its theorem may be about nothing.
enum class Obeyed {
  none_needed,       // it assumes nothing
  theorem,           // a theorem of the kernel says so
  balls,             // a point is known at which all of it holds, in balls
  unknown,           // none is known
  by_contradiction,  // there is none, and that is what the claim says: 0 < 0
};
[[nodiscard]] std::string to_string(Obeyed obeyed);  // "theorem": in data
// For a reader, by what all that is assumed can be obeyed: "by something, says a theorem"; empty where
// nothing is assumed.
[[nodiscard]] std::string sentence(Obeyed obeyed);

// What a proof found out.
struct Outcome {
  Verdict verdict = {};
  std::string found = {};                   // the answer, where the words of the claim only ask: "stable"
  std::string route = {};                   // how, in one sentence
  std::vector<Hypothesis> hypotheses = {};  // beyond those the paper states
  std::set<std::string> uses = {};          // ids of the claims that the proof took as premises
  std::set<std::string> assumed = {};       // ids of the claim's own assumptions that the proof needed
  std::vector<std::string> free = {};       // symbols (plain names) for all of whose values it was proved
  std::vector<Coordinate> at = {};          // the data at which it was proved; empty: for all
  std::vector<Comparison> comparisons = {};
  std::vector<Decided> decided = {};             // in the order in which the proof asked
  std::vector<symbols::Statement> doubted = {};  // where it is undecided: equations that may have a witness
  std::vector<kernel::Theorem> theorems = {};    // of the kernel: what is printed, in its order
  bool by_kernel = false;                        // whether the verdict is that of theorems alone
  Obeyed obeyed = Obeyed::none_needed;           // filled in by the Prover
  CrossCheck cross_check = {};                   // filled in by the Prover
};

class Prover;
struct Claim;
using Proof = std::function<Outcome(Prover&, const Claim&)>;

struct Claim {
  std::string id;          // "44.H": permanent
  std::string place = {};  // "sec3", "A1": that of the section in which it stands
  Kind kind = Kind::step;
  Origin origin = Origin::paper;
  std::vector<symbols::Statement> printed = {};  // as printed: all of them are claimed
  std::string words = {};                        // one plain sentence: what it says
  std::vector<Assumption> assumptions = {};      // "if", as the paper states it
  Proof prove = {};  // none for a model equation; of several claims at a time, each in a thread of its own
  // Nobody names its proof: what it assumes to be equal may be put in from either side.
  bool is_searched = false;
  // The other direction, where the paper presents what it deduces as equivalent: the premises from the
  // printed.
  Proof prove_converse = {};
  // What the source has lost of the printed form, which is then a reading that the proof has to justify:
  // which glyphs, and how many of those that are there.
  std::string illegible = {};
  // If the printed form fails: the reading that the derivation supports, and its proof.
  std::vector<symbols::Statement> corrected = {};
  Proof prove_corrected = {};
  // What each of its theorems says, where the words are not those of each: in the order as printed,
  // corrected, converse. Empty, or one sentence for each theorem.
  std::vector<std::string> parts = {};
  // The name of the status that it is to have; empty where nobody says.
  std::string expected = {};
  // Ids of claims of which its theorem says that there is something which obeys all that they assume.
  std::vector<std::string> meets = {};
};

// Computed, never typed; from the best to the worst.
enum class Status {
  as_printed,                // proved as it stands in the paper
  proved,                    // proved as it stands, and no one printed it
  decided_in_balls,          // so by a search in balls outside the kernel: no theorem says it
  model,                     // an equation of the model: taken as given
  premise,                   // says no more than it assumes: a condition imposed
  checked,                   // a check in floating point that agrees
  where_defined,             // proved where nothing is zero that printed formulas divide by
  needs_hypotheses,          // proved where something nonzero that the paper does not mention is nonzero
  digits_off,                // a printed number is not the correctly rounded one
  misprint_corrected,        // refuted as printed, the corrected form proved
  necessary_not_sufficient,  // follows, but does not give back what it was deduced from
  on_one_reading,            // of a statement alone: one fair reading of it is proved, another refuted
  refuted,                   // of a statement: on every fair reading
  rests_on_unproved,         // proved, but something that it uses is not
  undecided,
  in_part,     // of a statement alone: its claims say less than it does
  not_stated,  // of a statement alone: no claim says it
};

// How a terminal shows a status.
enum class Tone { quiet, good, notable, bad };

// All that is known about a status. The words are those that reports say.
struct StatusFacts {
  Status status;
  std::string name;          // "as_printed": in data, on the command line, as a class on pages
  std::string meaning = {};  // "proved as printed"
  std::string one = {};      // of one statement: "is proved exactly as printed"
  std::string many = {};     // of several
  std::string lead = {};     // what a paper comes to in which nothing is worse
  Tone tone;
  bool stands;               // others may rest on it
  bool of_claims;            // a claim can have it, and not a statement of the paper alone
  bool decided;              // the question about the statement is answered, one way or the other
  bool finding;              // worth a reader's attention
  bool fails;                // refuted (printed digits included) without a corrected form that is proved
  std::string heading = {};  // of the findings of this status; empty where they have none
  std::string explanation = {};
};

// From the best to the worst: statuses.txt, which is a part of the program, as pairs of a name and a text.
// There "NAME: TONE, FLAG, ..." stands before meaning, one, many, lead, heading and explanation, each in a
// line.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& statuses_text();
[[nodiscard]] const std::vector<StatusFacts>& statuses();
[[nodiscard]] const StatusFacts& facts(Status status);
[[nodiscard]] std::string to_string(Status status);
// Whether the word is the name of a status that a claim can have.
[[nodiscard]] bool is_status(const std::string& word);

// The status of what is proved under these hypotheses, of which there is one at least.
[[nodiscard]] Status needing(const std::vector<Hypothesis>& hypotheses);

// An edit of a refuted statement that makes it a theorem.
struct Repair {
  std::string what;  // "sign of H2(t)*H3(t)"
  symbols::Statement statement;
};

struct Record {
  Claim claim;                       // where no corrected form was given, the one found
  Outcome outcome;                   // of the statement as printed
  std::optional<Outcome> corrected;  // of the corrected form, where there is one and it was needed
  Status status = Status::undecided;
  std::set<std::string> used_by;
  std::optional<Outcome> converse = {};
  std::vector<Repair> repairs = {};  // all single edits that are proved
};

// Whether it is proved under hypotheses of its own or inherited, visible or not, and nothing else is wrong.
[[nodiscard]] bool needs_something(const Record& record);

// What the claim says, with the answer where its words only ask: "the stability of the orbit: stable".
[[nodiscard]] std::string words_of(const Record& record);

// Records in the paper's order.
struct Audit {
  std::vector<Record> records;
};

[[nodiscard]] std::vector<Claim> joined(const std::vector<std::vector<Claim>>& lists);

// Proves the claims with these ids (all of them if `ids` is empty) and whatever they use; the records are of
// the ids asked for, in the paper's order. Throws InternalError if a proof uses itself or an unknown id.
[[nodiscard]] Audit audit(const std::vector<Claim>& claims, const std::set<std::string>& ids = {});

}  // namespace stickslip::proofs::methods
