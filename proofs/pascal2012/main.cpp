// The identity-check program of one file of proofs/: proves its claims and prints a line each.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <set>
#include <string>

#include "core/error.hpp"
#include "proofs/pascal2012/paper.hpp"

namespace {

using namespace stickslip;

// 0 everything proved, or repaired, but the statements known to be refuted, and those are; 1 something else
// is refuted, or one of those is not; 2 something undecided.
int check(const std::string& source, const std::set<std::string>& known_to_be_refuted) {
  int code = exit_decided;
  for (const proofs::pascal2012::Place& place : proofs::pascal2012::places()) {
    if (place.source != source) {
      continue;
    }
    std::set<std::string> ids;
    for (const proofs::methods::Claim& claim : place.claims()) {
      ids.insert(claim.id);
    }
    for (const proofs::methods::Record& record :
         proofs::methods::audit(proofs::pascal2012::paper(), ids).records) {
      const std::string& reason = record.outcome.verdict.reason;
      fmt::print("{:12} {:20} {}{}{}\n", record.claim.id, to_string(record.status), record.claim.words,
                 reason.empty() ? "" : "\n             ", reason);
      const bool refuted = record.status == proofs::methods::Status::refuted;
      if (refuted != known_to_be_refuted.contains(record.claim.id)) {
        code = exit_refuted;
      } else if (code == exit_decided && (record.status == proofs::methods::Status::undecided ||
                                          record.status == proofs::methods::Status::rests_on_unproved)) {
        code = exit_undecided;
      }
    }
  }
  return code;
}

}  // namespace

int main(int argc, char ** argv) {
  try {
    return check(STICKSLIP_SECTION, std::set<std::string>(argv + 1, argv + argc));
  } catch (const Error& error) {
    fmt::print(stderr, "{}: {}\n", STICKSLIP_SECTION, error.what());
    return error.code();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: internal error: {}\n", STICKSLIP_SECTION, error.what());
    return exit_internal;
  }
}
