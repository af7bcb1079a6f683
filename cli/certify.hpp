// Directories of certificates, for the commands that write them.
#pragma once

#include <filesystem>

#include "proofs/certificates/certificates.hpp"

namespace stickslip::cli {

// Throws UsageError if the directory holds other things.
void require_certificates_only(const std::filesystem::path& directory);

// Only what differs, so that Coq need not look again at what it has seen; what is left of statements that are
// not among these goes.
void write_certificates(const std::filesystem::path& directory,
                        const proofs::certificates::Certificates& certificates);

}  // namespace stickslip::cli
