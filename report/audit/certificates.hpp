// Which claims of an audit Coq has certified, by the record of what it said (certificate_record.hpp).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "proofs/methods/claim.hpp"
#include "report/audit/certificate_record.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::audit {

// What Coq said of a claim's theorems.
struct Certified {
  enum class State {
    unknown,    // it was not asked
    certified,  // it accepts them
    stale,      // it accepted what is no longer said
    refused,    // it does not accept them
    none,       // there is nothing to ask
  };
  State state = State::unknown;
  std::string file = {};   // "Claim_44_H.v"
  std::string words = {};  // how many theorems on how many axioms; else why not
};
[[nodiscard]] std::string to_string(Certified::State state);

struct Certification {
  std::map<std::string, Certified> claims;  // by id: all of the audit
  std::string line = {};                    // in a sentence or two, how many claims Coq certified
};

// Whether Coq certified what the audit says now. A claim counts only if all of this was compared, and is so:
// the record is as it was made, by this version of the program; the prelude, Definitions.v and Statements.v
// beside it are what the program would write for the audit's own theorems, with these abbreviations; these,
// the claim's file and all that it imports, texts and what was compiled of them, are those that Coq was asked
// about; and the axioms are among the allowed ones, by name and by what they say. Without a record (an empty
// path) nothing is certified. Throws InputOutputError if the record cannot be read.
[[nodiscard]] Certification certification(const proofs::methods::Audit& audit,
                                          const std::filesystem::path& record = {},
                                          const std::vector<proofs::kernel::Definition>& abbreviations = {});

// What is known of a claim's certificate; of one that is not among them, nothing.
void write_certificate(tools::Object& json, const Certification& certification, const std::string& claim);

}  // namespace stickslip::report::audit
