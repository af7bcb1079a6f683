// The record that `stickslip certify` and script/certify keep beside certificates: what was written, and what
// Coq said of it.
#pragma once

#include <filesystem>
#include <string>

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

}  // namespace stickslip::report::audit
