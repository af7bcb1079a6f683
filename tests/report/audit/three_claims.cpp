#include "tests/report/audit/three_claims.hpp"

#include <fstream>
#include <sstream>

#include "proofs/methods/prover.hpp"
#include "report/audit/certificate_record.hpp"

namespace stickslip::report {

using namespace proofs;
using kernel::Theorem;
namespace fs = std::filesystem;

std::vector<methods::Claim> three_claims(bool with_cosine, int more) {
  const kernel::Variable t{"t"}, x{"x"}, y{"y"};
  const kernel::Definition f("f", {t}, with_cosine ? kernel::cos(t) : kernel::sin(t) + 1);
  const Theorem at_zero = Theorem::combination(kernel::equal(f({kernel::Term(0)}), 1), {}, {f});
  const Theorem rate = Theorem::differentiate(kernel::lambda(t, f({t})), x);
  const auto claim = [](const char * id, const std::set<std::string>& uses, const auto& theorem) {
    methods::Claim result;
    result.id = id;
    result.kind = methods::Kind::theorem;
    result.words = "one of three";
    result.prove = [=](methods::Prover& prover, const methods::Claim&) {
      methods::Outcome outcome;
      outcome.theorems = {theorem(prover)};
      outcome.by_kernel = true;
      outcome.uses = uses;
      outcome.verdict = Verdict::proved();
      return outcome;
    };
    return result;
  };
  std::vector<methods::Claim> claims{claim("1", {}, [=](methods::Prover&) { return at_zero; }),
                                     claim("2", {}, [=](methods::Prover&) { return rate; }),
                                     claim("3", {"2"}, [=](methods::Prover& prover) {
                                       return Theorem::instantiate(prover.theorem("2"), {{x, y * y}});
                                     })};
  for (int k = 4; k < 4 + more; ++k) {
    const Theorem theorem =
        Theorem::combination(kernel::equal(f({kernel::Term(0)}) + kernel::Term(k), k + 1), {}, {f});
    claims.push_back(claim(std::to_string(k).c_str(), {}, [=](methods::Prover&) { return theorem; }));
  }
  return claims;
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

std::string text_in(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void write_certificates(const fs::path& directory, bool with_cosine, int more) {
  const certificates::Certificates all = certificates::certificates(three_claims(with_cosine, more));
  for (const certificates::File& file : all.files) {
    write(directory / file.name, file.text);
  }
  write(directory / audit::certificate_record, tools::to_text(audit::record_of(all)));
}

tools::Json claim_in(const tools::Json& record, const std::string& id) {
  for (const tools::Json& one : record.at("claims")) {
    if (one.at("claim") == id) {
      return one;
    }
  }
  return {};
}

}  // namespace stickslip::report
