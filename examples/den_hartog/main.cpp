// Proves the claims on Den Hartog's motion and prints them, each with its verdict and the hypotheses of its
// theorems. Exit code 0: all are proved.
//
//   den_hartog [DIR]      DIR, which is there: also writes the proofs for the proof assistant Coq; make in
//   DIR
//                         has it check them
#include <fstream>
#include <iostream>

#include <stickslip/proofs/certificates/certificates.hpp>

#include "den_hartog.hpp"

namespace certificates = stickslip::proofs::certificates;

int main(int argc, char ** argv) {
  using namespace den_hartog;
  std::vector<methods::Claim> claims;
  for (const auto& part : {motion(), closing(), numbers()}) {
    claims.insert(claims.end(), part.begin(), part.end());
  }
  bool all = true;
  for (const methods::Record& record : methods::audit(claims).records) {
    all = all && record.outcome.verdict.truth == stickslip::Truth::proved;
    std::cout << record.claim.id << ": " << to_string(record.outcome.verdict.truth) << ", "
              << record.claim.words << '\n';
    for (const Theorem& theorem : record.outcome.theorems) {
      for (const Formula& hypothesis : theorem.hypotheses()) {
        std::cout << "    if " << kernel::to_string(hypothesis) << '\n';
      }
    }
  }
  if (argc > 1) {
    const certificates::Certificates made = certificates::certificates(claims);
    for (const certificates::File& file : made.files) {
      std::ofstream(std::string(argv[1]) + '/' + file.name) << file.text;
    }
    for (const certificates::Uncertified& none : made.uncertified) {
      std::cout << "no certificate for " << none.claim << ": " << none.reason << '\n';
    }
    all = all && made.uncertified.empty();
  }
  return all ? 0 : 1;
}
