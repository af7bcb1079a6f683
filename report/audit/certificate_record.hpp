// The record that `stickslip certify` and script/certify keep beside certificates: what was written, and what
// Coq said of it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "proofs/certificates/certificates.hpp"
#include "report/tools/json.hpp"

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

// A line for each claim that was asked for, or that one of these rests on; where there are others, how many
// theorems of all; how many coqchk was asked of; and last "N of M theorems certified, K axioms", of those
// asked for.
[[nodiscard]] std::string text_of(const tools::Json& record);
// Of those asked for.
[[nodiscard]] bool all_accepted(const tools::Json& record);

// What Coq, its compiler and `time` write, read.

// The axioms of Coq's real numbers and of classical logic, and what each says, as Coq prints it in one line:
// what a theorem may rest on.
[[nodiscard]] const std::map<std::string, std::string>& allowed_axioms();

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

}  // namespace stickslip::report::audit
