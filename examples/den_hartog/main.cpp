// Proves the claims on Den Hartog's motion and prints them, each with its verdict and the hypotheses of its
// theorems. Exit code 0: all are proved.
//
//   den_hartog [DIR]      also writes into DIR the report, which begins with index.html, and the proofs for
//                         the proof assistant Coq: make in DIR has it check them
#include <fstream>
#include <iostream>

#include <stickslip/proofs/certificates/certificates.hpp>
#include <stickslip/report/audit/write_report.hpp>

#include "den_hartog.hpp"

namespace certificates = stickslip::proofs::certificates;
using namespace den_hartog;

namespace {

methods::Paper text_book() {
  methods::Paper paper;
  paper.bibliography = {"J. P. Den Hartog",
                        "Forced vibrations with Coulomb friction, as text books have them",
                        "after Trans. ASME 53 (1931) APM-53-9", ""};
  const auto add = [&](const char * id, const char * title, std::vector<methods::Claim> claims) {
    paper.sections.push_back({id, title, id});
    for (methods::Claim& claim : claims) {
      claim.place = id;
      if (claim.origin == methods::Origin::textbook) {
        const std::string number = std::to_string(1001 + paper.statements.size()).substr(1);
        paper.statements.push_back({.id = "S" + number,
                                    .place = claim.id,
                                    .kind = claim.kind,
                                    .words = claim.words,
                                    .claims = {claim.id},
                                    .section = title});
      }
      paper.claims.push_back(std::move(claim));
    }
  };
  add("motion", "Between two turns", motion());
  add("closing", "Symmetric motions: amplitude and lag", closing());
  add("numbers", "The limit of motion without stops; figures", numbers());
  return paper;
}

// Returns whether every claim has a certificate.
bool write(const methods::Paper& paper, const methods::Audit& audit, const std::string& directory) {
  std::cout << stickslip::report::audit::write_report(paper, audit, directory, "den_hartog " + directory);
  const certificates::Certificates made = certificates::certificates(paper.claims);
  for (const certificates::File& file : made.files) {
    std::ofstream(directory + '/' + file.name) << file.text;
  }
  for (const certificates::Uncertified& none : made.uncertified) {
    std::cout << "no certificate for " << none.claim << ": " << none.reason << '\n';
  }
  return made.uncertified.empty();
}

}  // namespace

int main(int argc, char ** argv) {
  const methods::Paper paper = text_book();
  const methods::Audit audit = methods::audit(paper.claims);
  bool all = true;
  for (const methods::Record& record : audit.records) {
    all = all && record.outcome.verdict.truth == stickslip::Truth::proved;
    std::cout << record.claim.id << ": " << to_string(record.outcome.verdict.truth) << ", "
              << stickslip::plain(record.claim.words) << '\n';
    for (const Theorem& theorem : record.outcome.theorems) {
      for (const Formula& hypothesis : theorem.hypotheses()) {
        std::cout << "    if " << kernel::to_string(hypothesis) << '\n';
      }
    }
  }
  return (argc < 2 || write(paper, audit, argv[1])) && all ? 0 : 1;
}
