// Proves a statement of the paper, and says what the proof needs.
#include <iostream>

#include <stickslip/proofs/pascal2012/paper.hpp>

int main() {
  using namespace stickslip::proofs;
  for (const methods::Record& record : methods::audit(pascal2012::paper().claims, {"16"}).records) {
    std::cout << record.claim.id << ": " << methods::to_string(record.status) << '\n';
    for (const methods::Hypothesis& hypothesis : record.outcome.hypotheses) {
      std::cout << "  where " << hypothesis.text << '\n';
    }
  }
}
