// What Coq said of the certificates: the record that `stickslip certify` and script/certify keep beside them,
// and what an audit reads there.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "proofs/certificates/certificates.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report::audit {

inline constexpr const char * certificate_record = "certificates.json";

// The record as it is before Coq is asked: program and version, and for each claim its file, theorems,
// imports, fingerprints of what is said and of the file, whether it was asked for, and "accepted": null, or
// what the record before says if since then nothing has changed in its file and in what it rests on; those
// without, and why.
[[nodiscard]] tools::Json record_of(const proofs::certificates::Certificates& certificates,
                                    const tools::Json& before = tools::Json::object());
// Throws InputOutputError if there is no record, or none that can be read.
[[nodiscard]] tools::Json read_record(const std::filesystem::path& path);

// The record after coqc: for each claim "accepted", "reason" if it is not, "seconds", "axioms". A claim is
// accepted if its file is the recorded one, coqc compiled it after the files that it imports and after the
// lemmas on which all stand, which are the recorded ones, all that it imports are accepted, and it rests on
// the allowed axioms only. Null where Coq was not asked, of it or of what it rests on. Throws
// InputOutputError as read_record.
[[nodiscard]] tools::Json checked(const std::filesystem::path& directory);
// A line for each claim that was asked for, or that one of these rests on; where there are others, how many
// theorems of all; and last "N of M theorems certified, K axioms", of those asked for.
[[nodiscard]] std::string text_of(const tools::Json& record);
// Of those asked for.
[[nodiscard]] bool all_accepted(const tools::Json& record);

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
[[nodiscard]] std::string name_of(Certified::State state);

struct Certification {
  std::map<std::string, Certified> claims;  // by id: all of the audit
  std::string line = {};                    // in a sentence or two, how many claims Coq certified
};

// Whether Coq certified what the audit says now: whether the record has a claim's fingerprint and this
// program's version, and the file beside the record is the one that was checked. Without a record (an empty
// path) nothing is certified. Throws InputOutputError if the record cannot be read.
[[nodiscard]] Certification certification(const proofs::methods::Audit& audit,
                                          const std::filesystem::path& record = {});

// {"state", "file", "words"}; of a claim of which nothing is known, unknown.
[[nodiscard]] tools::Json to_json(const Certification& certification, const std::string& claim);

}  // namespace stickslip::report::audit
