// What random starts end on at the data of the figures: a check in floating point, with shares.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "numeric/attractors/attractors.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/example_orbit.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using numeric::attractors::Attractor;
using numeric::attractors::AttractorList;
using numeric::attractors::AttractorQuestion;

namespace {

// u_r, where it is a result, to the digits of a double.
Rational friction_of(const Example& example) {
  return example.ur ? *example.ur : parse_rational(to_text(printed_orbit(example).ur(), 17).mid);
}

std::string shown(const Attractor& one) {
  const std::string share =
      fmt::format("{:.0f} % ({:.0f} to {:.0f})", 100 * one.share, 100 * one.least, 100 * one.most);
  if (one.kind != numeric::attractors::Kind::periodic) {
    return share + " " + to_string(one.kind);
  }
  const std::string proved = one.orbit && one.orbit->existence.truth == Truth::proved ? ", proved" : "";
  return fmt::format("{} period {}{}{}", share, one.periods, proved,
                     one.family.empty() ? "" : ", of the paper's families");
}

Claim attractors_of(const Example& example, long starts, bool attracts) {
  return {
      .id = example.name + ".attractors",
      .kind = methods::Kind::check,
      .origin = Origin::new_result,
      .words = fmt::format(
          "of {} random starts at the data of {} {}; shares, with 95 % of confidence", starts, example.figure,
          attracts ? "more end on its orbit than on any other motion" : "none ends on its orbit"),
      .prove = [&example, starts, attracts](Prover&, const Claim&) {
        Outcome outcome = of_its_orbit(example,
                                       "simulation of the law (4) in floating point, of which "
                                       "periodic motions are proved");
        AttractorQuestion question;
        question.machine = {.data = example.data, .ur = friction_of(example), .digits = 10};
        question.starts = starts;
        const AttractorList list = numeric::attractors::find_attractors(question);
        std::vector<std::string> found;
        for (const Attractor& one : list.attractors) {
          found.push_back(shown(one));
        }
        outcome.found = fmt::format("{}", fmt::join(found, "; "));
        const auto is_of_family = [](const Attractor& one) { return !one.family.empty(); };
        const bool so = attracts ? is_of_family(list.attractors.front())
                                 : std::ranges::none_of(list.attractors, is_of_family);
        outcome.verdict = list.interrupted ? Verdict::undecided("interrupted")
                          : so             ? Verdict::checked("they end on these motions")
                                           : Verdict::undecided("they end on other motions");
        return outcome;
      }};
}

}  // namespace

std::vector<Claim> attractors() {
  return {attractors_of(example_named("S"), 40, false), attractors_of(example_named("O"), 10, true),
          attractors_of(example_named("P"), 500, false)};
}

}  // namespace stickslip::proofs::pascal2012
