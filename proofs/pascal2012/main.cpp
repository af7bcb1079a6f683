// The identity checks: proves the claims of sections of the paper and prints a line each.
//
//   pascal2012 [SECTION…] [ID…]
//
// SECTION names a file beside this one, section3 or appendix2; without one, all are checked. A link to this
// program that bears the name of a section checks that section. ID: a statement that is known to be refuted.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <set>
#include <string>

#include "core/error.hpp"
#include "proofs/pascal2012/paper.hpp"

namespace {

using namespace stickslip;
using namespace proofs::methods;

struct Wanted {
  std::set<std::string> places, known_to_be_refuted;
};

// Takes what names a section, else, for an argument, a claim. Throws UsageError for any other.
Wanted wanted(const Paper& paper, const std::string& called, const std::vector<std::string>& arguments) {
  Wanted result;
  const auto is_section = [&](const std::string& word) {
    const auto found = std::ranges::find(paper.sections, word, &Section::program);
    return found != paper.sections.end() && (result.places.insert(found->id), true);
  };
  (void)is_section(called);
  for (const std::string& word : arguments) {
    if (!is_section(word)) {
      result.known_to_be_refuted.merge(ids_named(paper.claims, word));
    }
  }
  return result;
}

// 0 everything proved, or repaired, but the statements known to be refuted, and those are; 1 something else
// is refuted, or one of those is not; 2 something undecided.
int check(const Paper& paper, const Wanted& wanted) {
  std::set<std::string> ids;
  for (const Claim& claim : paper.claims) {
    if (wanted.places.empty() || wanted.places.contains(claim.place)) {
      ids.insert(claim.id);
    }
  }
  int code = exit_decided;
  for (const Record& record : audit(paper.claims, ids).records) {
    const std::string reason = plain(record.outcome.verdict.reason);
    fmt::print("{:12} {:20} {}{}{}\n", record.claim.id, to_string(record.status), plain(words_of(record)),
               reason.empty() ? "" : "\n             ", reason);
    const bool refuted = record.status == Status::refuted;
    if (refuted != wanted.known_to_be_refuted.contains(record.claim.id)) {
      code = exit_refuted;
    } else if (code == exit_decided && !facts(record.status).decided) {
      code = exit_undecided;
    }
  }
  return code;
}

}  // namespace

int main(int argc, char ** argv) {
  const std::string called = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "pascal2012";
  try {
    const Paper& paper = proofs::pascal2012::paper();
    return check(paper, wanted(paper, called, {argv + std::min(argc, 1), argv + argc}));
  } catch (const Error& error) {
    fmt::print(stderr, "{}: {}\n", called, error.what());
    return error.code();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: internal error: {}\n", called, error.what());
    return exit_internal;
  }
}
