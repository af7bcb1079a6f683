// What the project keeps of the paper's text: the formulas as the source has them, with the glyphs that are
// put back marked, the data and values of the examples, and the passages that remarks quote: source.txt.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace stickslip::proofs::pascal2012 {

struct SourceLine {
  enum class Use {
    printed,    // a statement that the claim prints
    otherwise,  // in place of one: the claim says it in another form, or the text in none, and is empty
    beside,     // what else belongs to the claim
    numbers,    // data and values of an example
    passage,    // words
  };
  std::string of;  // id of the claim, name of the example
  Use use = Use::beside;
  std::string text;  // with marks: "H (τ⟨−⟩t )"
  // What the claim writes more, "+x", and less, "-x", for the same thing; "order": in another order; "again":
  // what is lost of it is said with another line.
  std::vector<std::string> otherwise = {};
};

// The file, which is a part of the program: its name and its text.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& source_text();

// All of it. Throws InternalError if a line of the file is none.
[[nodiscard]] const std::vector<SourceLine>& source_lines();

// The text as the source has it, "H (τt )", and as it is read, "H (τ−t )".
[[nodiscard]] std::string as_extracted(const std::string& marked);
[[nodiscard]] std::string as_read(const std::string& marked);

// Which glyphs of the claim's formulas the source has lost: "2 of 3 minus signs, the prime"; empty if none.
[[nodiscard]] std::string lost_in_source(const std::string& claim);

}  // namespace stickslip::proofs::pascal2012
