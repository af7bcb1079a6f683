// What is stated to Coq, apart from why it is so: the theorems of a claim under their names.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proofs/kernel/theorem.hpp"
#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::certificates {

// A sequent as Coq has it: in which order it takes values for its variables, and proofs of its hypotheses.
struct Stated {
  std::vector<kernel::Variable> variables;
  std::vector<kernel::Formula> hypotheses;
  std::string text;  // "  forall (x : R),\n  0 < x ->\n  …": the sequent in full
};
// Each hypothesis as `premise` says it, in full unless asked otherwise.
[[nodiscard]] Stated stated(const kernel::Theorem& theorem,
                            const std::function<std::string(const kernel::Formula&)>& premise = {});

// All definitions that it speaks of, each after those it needs, added to those found before. Throws
// KernelError if a variable would hide one of them.
void collect_definitions(const kernel::Theorem& theorem, std::vector<kernel::Definition>& found);

struct NamedTheorem {
  std::string name;   // "claim_44_H_1"; "corrected_…" of the corrected form, "converse_…"
  std::string about;  // "44.H, Section 3, part 1 of 2: …": the claim's place and words
  kernel::Theorem theorem;
};
// Whether it says no more than a definition does, or what it assumes: its conclusion is among its hypotheses,
// or both sides are one term once all definitions are unfolded.
[[nodiscard]] bool is_immediate(const kernel::Theorem& theorem);
// In the order of what the claim prints; then of the corrected form, then of the converse.
[[nodiscard]] std::vector<NamedTheorem> named_theorems(const methods::Record& record);

// Why a claim without theorems has none.
[[nodiscard]] std::string without_theorem(const methods::Record& record);

// The same for the same text, and for no other that one meets: the name-based UUID of RFC 4122, by SHA-1.
[[nodiscard]] std::string fingerprint(const std::string& text);
// Of all that the claim's theorems say: statements, definitions, and what prelude/ defines.
[[nodiscard]] std::string fingerprint(const methods::Record& record);

// The name of a claim's file: "Claim_44_H". Different ids have different names.
[[nodiscard]] std::string file_name(const std::string& id);

}  // namespace stickslip::proofs::certificates
