// The record that `stickslip certify` and script/certify keep beside certificates: what was written, and what
// Coq said of it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "proofs/certificates/certificates.hpp"
#include "proofs/methods/claim.hpp"
#include "report/tools/json.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::audit {

inline constexpr const char * certificate_record = "certificates.json";

// The record as it is before Coq is asked: program and version; "foundations", the files that all stand on,
// and for each claim its file, theorems, imports, fingerprints of what is said and of the file, whether it
// was asked for, and "accepted": null, or what the record before says if that is sealed and nothing at all
// has changed in what it rests on; those without, and why.
[[nodiscard]] tools::Json record_of(const proofs::certificates::Certificates& certificates,
                                    const tools::Json& recorded_before = tools::Json::object());

// Throws InputOutputError if there is no record, or none that can be read.
[[nodiscard]] tools::Json read_record(const std::filesystem::path& path);

// With a fingerprint of all that it holds; and whether it has that of what it holds. This finds what was
// changed by accident: whoever wants to forge a record can. What it says can be had again from Coq.
[[nodiscard]] tools::Json sealed(tools::Json record);
[[nodiscard]] bool is_sealed(const tools::Json& record);

// The record in the directory after Coq was asked, here and now: for each claim "accepted", "reason" if it is
// not, "seconds", "compiled" (the fingerprint of its .vo), "again" (what coqchk says); "coq": its version and
// the axioms of all.
//
// A claim is accepted if its file is the recorded one, all that it imports is accepted, and its .vo, after
// those files that all stand on, which are compiled anew from the recorded texts, holds theorems of the types
// of Statements.v that rest on the allowed axioms only. Null where coqc was not asked of it, or of what it
// rests on. Nothing but the record says which files these are: what they say is for the audit to compare.
//
// coqchk is asked of what was accepted and was not seen by it before, as the record says; not where
// interval arithmetic takes long: it has no virtual machine. Throws InputOutputError as read_record,
// where the record is not sealed, and where there is no Coq.
[[nodiscard]] tools::Json checked(const std::filesystem::path& directory);

// A line for each claim that was asked for, or that one of these rests on; where there are others, how many
// theorems of all; how many coqchk was asked of; and last "N of M theorems certified, K axioms", of those
// asked for.
[[nodiscard]] std::string text_of(const tools::Json& record);
// Of those asked for.
[[nodiscard]] bool all_accepted(const tools::Json& record);

// What Coq, its compiler and `time` write, read.

// The axioms of Coq's real numbers and of classical logic, and what each says, as Coq prints it in one line:
// what a theorem may rest on; whether an axiom is among them, by its name and by what it says.
[[nodiscard]] const std::map<std::string, std::string>& allowed_axioms();
[[nodiscard]] bool is_allowed(const std::string& axiom, const std::string& says);

// What Coq prints for "Print Assumptions": names and what they say, each in one line. Whatever else it prints
// there, as of checks that were switched off, stands among the names.
[[nodiscard]] std::map<std::string, std::string> axioms_in(const std::string& printed);

// The seconds that a file took, from its log; empty without one.
[[nodiscard]] std::string seconds_in(const std::filesystem::path& log);
// "… line 12, …": the number, or 0.
[[nodiscard]] std::size_t line_in(const std::string& complaint);
// What stands after "Error:", in one line of moderate length.
[[nodiscard]] std::string error_in(const std::string& complaint);
// What a file requires of its own library.
[[nodiscard]] std::vector<std::string> required_by(const std::string& text);

// Which claims of an audit Coq has certified, by the record of what it said (certificate_record.hpp).

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
