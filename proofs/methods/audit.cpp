// Proves all claims of a list, or those asked for.
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "proofs/methods/progress.hpp"
#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::methods {

namespace {

Audit prove_all(Prover& prover, const std::vector<std::string>& ids, const Progress& progress) {
  Audit result;
  for (const std::string& id : ids) {
    progress(id, result.records.size(), ids.size());
    try {
      const Record& record = prover.prove(id);
      if (interrupted()) {
        break;  // what this claim rests on may have been cut short
      }
      result.records.push_back(record);
    } catch (const Error&) {
      if (!interrupted()) {
        throw;
      }
      break;
    }
  }
  for (Record& record : result.records) {
    for (const Record& other : result.records) {
      if (other.outcome.uses.contains(record.claim.id) ||
          (other.corrected && other.corrected->uses.contains(record.claim.id)) ||
          (other.converse && other.converse->uses.contains(record.claim.id))) {
        record.used_by.insert(other.claim.id);
      }
    }
  }
  return result;
}

}  // namespace

Audit audit(const std::vector<Claim>& claims, const std::set<std::string>& ids, const Progress& progress) {
  Prover prover(claims);
  for (const std::string& id : ids) {
    (void)prover.claim(id);
  }
  std::vector<std::string> asked;
  for (const Claim& claim : claims) {
    if (ids.empty() || ids.contains(claim.id)) {
      asked.push_back(claim.id);
    }
  }
  prover.begin(asked);
  return prove_all(prover, asked, progress);
}

Audit audit(const std::vector<Claim>& claims, const std::set<std::string>& ids) {
  return audit(claims, ids, [](const std::string&, std::size_t, std::size_t) {});
}

}  // namespace stickslip::proofs::methods
