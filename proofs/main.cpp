// The identity-check program of one file of proofs/: proves its claims and prints a line each.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "core/error.hpp"
#include "proofs/paper.hpp"

namespace {

using namespace stickslip;

// 0 everything proved, or repaired; 1 something refuted; 2 something undecided.
int check(const std::string& source) {
  int code = exit_decided;
  for (const proofs::Place& place : proofs::places()) {
    if (place.source != source) {
      continue;
    }
    std::set<std::string> ids;
    for (const proofs::Claim& claim : place.claims()) {
      ids.insert(claim.id);
    }
    for (const proofs::Record& record : proofs::audit(proofs::paper(), ids).records) {
      const std::string& reason = record.outcome.verdict.reason;
      fmt::print("{:12} {:20} {}{}{}\n", record.claim.id, to_string(record.status), record.claim.words,
                 reason.empty() ? "" : "\n             ", reason);
      if (record.status == proofs::Status::refuted) {
        code = exit_refuted;
      } else if (code == exit_decided && (record.status == proofs::Status::undecided ||
                                          record.status == proofs::Status::rests_on_unproved)) {
        code = exit_undecided;
      }
    }
  }
  return code;
}

}  // namespace

int main() {
  try {
    return check(STICKSLIP_SECTION);
  } catch (const Error& error) {
    fmt::print(stderr, "{}: {}\n", STICKSLIP_SECTION, error.what());
    return error.code();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: internal error: {}\n", STICKSLIP_SECTION, error.what());
    return exit_internal;
  }
}
