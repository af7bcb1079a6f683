// Coq, asked what it says of a directory of certificates.
#pragma once

#include <filesystem>

#include "report/tools/json.hpp"

namespace stickslip::report::audit {

// The record (certificate_record.hpp) after Coq was asked, here and now: for each claim "accepted", "reason"
// if it is not, "seconds", "compiled" (the fingerprint of its .vo), "again" (what coqchk says); "coq": its
// version and the axioms of all.
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

}  // namespace stickslip::report::audit
