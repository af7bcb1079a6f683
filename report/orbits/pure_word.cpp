#include "report/orbits/pure_word.hpp"

#include <fmt/format.h>

#include "numeric/words/pure.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::motion;
using namespace numeric::words;
using namespace tools;

namespace {

constexpr int short_digits = 10;

bool sticks(const PureWord& word) {
  return word.kind == PhaseKind::stick;
}

// What the amplitudes of free oscillations are to stay below.
Ball room(const PureWord& word) {
  const ExactParameters& a = word.machine.data;
  return sticks(word) ? Ball(Rational(word.machine.ur - a.p / a.eta)) : pure_slip(a, word.kind).room;
}

std::string verb(PhaseKind kind) {
  return kind == PhaseKind::stick ? "stick" : kind == PhaseKind::slip ? "slip" : "overshoot";
}

std::string result(const PureWord& word) {
  const Verdict verdict = exists(word);
  const std::string why = verdict.reason.empty() ? "" : ": " + verdict.reason;
  switch (verdict.truth) {
    case Truth::proved:
      return "proved: some motions do";
    case Truth::refuted:
      return "proved: no motion does" + why;
    default:
      return "undecided" + why;
  }
}

std::vector<Row> which(const PureWord& word, const Units& units) {
  const bool stick = sticks(word);
  const std::string bound = stick ? rounded(units.force(room(word)), short_digits) + units.unit(" N")
                                  : rounded(units.velocity(room(word)), short_digits) + units.unit(" m/s");
  if (stick) {
    return {{{"which"},
             {"those that begin at rest on the belt with $chi (1 - chi) |x2| + chi a < ur - p/eta$ = " +
              bound + ", $a$ = sqrt((x1 - chi x2)² + x1'²) the amplitude of $x1 - chi x2$"}},
            {{"stability"},
             {"neutral, not stable: $x1 - chi x2$ oscillates for ever as it began, and $x2$ stays where it "
              "is"}}};
  }
  return {
      {{"which"},
       {fmt::format("those with alpha1 + alpha2 < {}V - |q2| omega = {}: the amplitudes of the free "
                    "oscillations of $x2'$, alpha_j = |lambda_j| sqrt(omega_j² y_j² + y_j'²), y_j the modal "
                    "coordinates of what the motion differs from the forced one by; and, unless omega, "
                    "omega1, omega2 are rationally dependent, no others",
                    word.kind == PhaseKind::slip ? "" : "-", bound)}},
      {{"stability"}, {"neutral, not stable: free oscillations neither grow nor decay"}}};
}

void write_pure(Object& json, const PureWord& word, const Units& units) {
  const WordQuestion& q = word.machine;
  const std::string letter(1, words::letter(word.kind));
  const Verdict verdict = exists(word);
  write_origin(json, fmt::format("stickslip orbits {}{} --digits {}", letter, options_of(q), q.digits));
  json.has("word", letter, with(one_of({"S", "O", "T"}), "S slip, O overshoot, T stick."));
  write_parameters(json, q);
  json.has("verdict", verdict.truth,
           with(names_through(Truth::undecided), "On: some motions stay in this phase for ever."));
  json.has("reason", if_any(verdict.reason));
  const auto if_so = [&](bool so, const auto& value) {
    return so ? std::optional(ball_text(value(), q.digits)) : std::nullopt;
  };
  const bool proved = verdict.truth == Truth::proved;
  json.has("forced",
           if_so(!sticks(word), [&] { return units.velocity(pure_slip(q.data, word.kind).forced); }),
           "|q2| omega, the amplitude of the speed that the load forces; not of a stick.");
  json.has(
      "room",
      if_so(proved, [&] { return sticks(word) ? units.force(room(word)) : units.velocity(room(word)); }),
      "Where there are such motions: those whose free amplitudes add up to less. V - |q2| omega for a slip, "
      "-V - |q2| omega for an overshoot, ur - p/eta for a stick.");
  json.has("stability", proved ? std::optional("neutral") : std::nullopt, one_of({"neutral"}));
}

}  // namespace

Verdict exists(const PureWord& word) {
  return sticks(word) ? pure_stick(word.machine.data, word.machine.ur)
                      : pure_slip(word.machine.data, word.kind).exists;
}

std::string terminal_report(const PureWord& word, const Style& style, const Units& units) {
  std::vector<Row> rows{{{"parameters"}, {parameter_list(word.machine)}}, {{"result"}, {result(word)}}};
  if (!sticks(word)) {
    rows.push_back(
        {{"forced"},
         {fmt::format("|q2| omega = {}{}, the speed of mass 2 that the load forces",
                      rounded(units.velocity(pure_slip(word.machine.data, word.kind).forced), short_digits),
                      units.unit(" m/s"))}});
  }
  if (exists(word).truth == Truth::proved) {
    const std::vector<Row> more = which(word, units);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return headed(fmt::format("Motions that {} for ever", verb(word.kind)), rows, style);
}

Json to_json(const PureWord& word, const Units& units) {
  return written(word, in_units(write_pure, units));
}

File pure_schema() {
  const PureWord sample{SampleOf<WordQuestion>::made(), PhaseKind::slip};
  return schema_file("pure", "stickslip orbits S, O or T: motions of one phase, for ever",
                     schema_by(sample, in_units(write_pure)));
}

}  // namespace stickslip::report::orbits
