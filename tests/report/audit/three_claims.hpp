// Small claims and their certificates, one of which rests on another.
#pragma once

#include <filesystem>
#include <string>

#include "proofs/certificates/certificates.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report {

// 1: f(0) = 1, 2: the derivative of f, 3: 2 at y y; f is the cosine, or the sine and 1. Beside them as many
// as wanted, 4, 5, …: f(0) + 4 = 5, ….
[[nodiscard]] std::vector<proofs::methods::Claim> three_claims(bool with_cosine = true, int more = 0);

void write(const std::filesystem::path& path, const std::string& text);
[[nodiscard]] std::string text_in(const std::filesystem::path& path);

// Their certificates and the record of these in the directory, as `stickslip certify --out` leaves them.
void write_certificates(const std::filesystem::path& directory, bool with_cosine = true, int more = 0);
[[nodiscard]] tools::Json claim_in(const tools::Json& record, const std::string& id);

}  // namespace stickslip::report
