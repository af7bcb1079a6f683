// Statements of one's own, for all values of their symbols: one is proved, one refuted.
#include <iostream>

#include <stickslip/proofs/methods/automatic.hpp>
#include <stickslip/proofs/pascal2012/paper.hpp>

int main() {
  using namespace stickslip::proofs;
  const auto decide = [](const std::string& statement) {
    methods::Paper with_own = pascal2012::paper();
    with_own.claims.push_back(methods::own_claim({.statement = statement}));
    const methods::Audit audit = methods::audit(with_own.claims, {methods::own_id});
    const stickslip::Verdict& verdict = audit.records.front().outcome.verdict;
    std::cout << statement << ": " << to_string(verdict.truth) << '\n';
    if (verdict.witness) {
      for (const stickslip::Coordinate& coordinate : verdict.witness->point) {
        std::cout << "  at " << coordinate.name << " = " << coordinate.value << '\n';
      }
    }
  };
  // The product of the squared natural frequencies of (39).
  decide("omega1^2 omega2^2 = chi eta (1 - chi)");
  decide("omega1^2 omega2^2 = chi eta");
}
