#include "report/orbits/attractors.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/decimal.hpp"
#include "numeric/words/pure_stick.hpp"
#include "report/orbits/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace numeric::motion;
using namespace tools;
using words::WordOrbit;

namespace {

// What is proved of a periodic motion.
std::string proved(const std::optional<WordOrbit>& orbit) {
  if (!orbit || orbit->existence.truth != Truth::proved) {
    return "not proved" + (orbit ? ": " + plain(orbit->existence.reason) : std::string());
  }
  const families::Orbit& o = orbit->orbit;
  if (o.admissible.truth != Truth::proved) {
    return fmt::format("{}: {}", verdict_on(o), plain(o.admissible.reason));
  }
  const std::string radius =
      o.stability->multipliers.empty() ? "" : fmt::format(", |mu| = {}", spectral_radius(*o.stability));
  const std::string why = o.stability->reason.empty() ? "" : ": " + o.stability->reason;
  return fmt::format("proved, {}{}{}", to_string(o.stability->kind), why, radius);
}

}  // namespace

std::string spectral_radius(const Stability& s) {
  Ball largest(0);
  for (const ComplexBall& mu : s.multipliers) {
    const Ball modulus = sqrt(mu.squared_modulus().upper());
    arb_max(largest.raw(), largest.raw(), modulus.raw(), WorkingPrecision::bits());
  }
  const double radius = largest.upper().approximate();
  std::string text = "1";
  for (int digits = 4; text == "1" && digits <= 17; ++digits) {
    text = fmt::format("{:.{}g}", radius, digits);
  }
  return text;
}

std::vector<Condition> worst(const std::vector<Condition>& conditions) {
  const auto badness = [](const Condition& c) {
    return c.verdict.truth == Truth::refuted ? 2 : c.verdict.truth == Truth::proved ? 0 : 1;
  };
  const auto is_worse = [&](const Condition& a, const Condition& b) {
    if (badness(a) != badness(b)) {
      return badness(a) > badness(b);
    }
    return a.margin && b.margin && (*b.margin - *a.margin).is_positive();
  };
  std::vector<Condition> result;
  for (const Condition& c : conditions) {
    const auto same =
        std::find_if(result.begin(), result.end(), [&](const Condition& r) { return r.id == c.id; });
    if (same == result.end()) {
      result.push_back(c);
    } else if (is_worse(c, *same)) {
      *same = c;
    }
  }
  return result;
}

std::string remark(const Attractor& a) {
  switch (a.kind) {
    case Kind::periodic:
      return proved(a.orbit) + (a.family.empty() ? "" : ", " + a.family);
    case Kind::irregular:
    case Kind::quasi_periodic:
      return fmt::format("Lyapunov exponent {:.2g} per period of the load", a.lyapunov.value_or(0));
    case Kind::slides:
      return "no contact with the belt any more";
    case Kind::stuck:
      return "does not leave the belt any more";
    case Kind::grows:
      return "proved: omega is a natural frequency, and pi p > 4 eta ur";
    case Kind::unsettled:
      return a.is_too_slow
                 ? "a period of the load takes more than two million steps of simulation: too slow to be "
                   "followed"
                 : "within the periods allowed";
  }
  return "";
}

std::string state_of(const model::Vector4<double>& X) {
  return fmt::format("{:.10g},{:.10g},{:.10g},{:.10g}", X(0), X(1), X(2), X(3));
}

std::string shortened(const std::string& word) {
  constexpr std::size_t most = 18;
  return word.size() <= most ? word : fmt::format("{}... ({})", word.substr(0, most), word.size());
}

std::string in_words(const Attractor& a) {
  if (a.kind != Kind::periodic) {
    return fmt::format("{}: {}", to_string(a.kind), remark(a));
  }
  return fmt::format("{} with the period {}: {}", shortened(a.word), a.periods, remark(a));
}

std::vector<Row> rows_of(const AttractorList& list) {
  const AttractorQuestion& q = list.question;
  std::vector<Row> head{
      {{"parameters"}, {parameter_list(q.machine)}},
      {{"starts"},
       {fmt::format("{} at random, seed {}, each followed until it has settled or for {} "
                    "periods of the load; {} periods in all{}",
                    q.starts, q.seed, q.most_periods, list.simulated,
                    list.interrupted ? fmt::format("; interrupted when {} of them were done, of which "
                                                   "the shares are",
                                                   list.followed)
                                     : "")}}};
  if (const words::PureSlip slip = words::pure_slip(q.machine.data); slip.exists.truth == Truth::proved) {
    head.push_back(
        {{"pure slip"},
         {fmt::format("proved: motions never touch the belt if the amplitudes of the two free oscillations "
                      "of x2' add up to less than V - |q2| omega = {}; they are neutral, not stable",
                      rounded(Ball(q.machine.data.V) - slip.forced, 4))}});
  }
  if (words::pure_stick(q.machine.data, q.machine.ur).truth == Truth::proved) {
    head.push_back(
        {{"pure stick"},
         {fmt::format("proved: mass 2 rests on the belt for ever where chi (1 - chi) |x2| + chi a < "
                      "ur - p/eta = {}, a the amplitude of x1 - chi x2",
                      to_string(Rational(q.machine.ur - q.machine.data.p / q.machine.data.eta)))}});
  }
  return head;
}

std::string terminal_report(const AttractorList& list, const Style& style, const Units& units) {
  std::string text = columns_of({{{"What the machine does", bold(style)}}}, style.width) +
                     columns_of(rows_of(list), style.width);
  std::vector<Row> rows{{{"   "}, {"share"}, {"95 %"}, {"motion"}, {"period"}, {"word"}, {""}}};
  for (std::size_t i = 0; i < list.attractors.size(); ++i) {
    const Attractor& a = list.attractors[i];
    const bool periodic = a.kind == Kind::periodic;
    rows.push_back({{std::to_string(i + 1)},
                    {fmt::format("{:.1f} %", 100 * a.share)},
                    {fmt::format("{:.1f}-{:.1f}", 100 * a.least, 100 * a.most)},
                    {to_string(a.kind)},
                    {periodic ? std::to_string(a.periods) : ""},
                    {periodic ? shortened(a.word) : ""},
                    {remark(a)}});
  }
  text += "\n" + columns_of(rows, style.width);
  bool any = false;
  for (std::size_t i = 0; i < list.attractors.size(); ++i) {
    const auto& orbit = list.attractors[i].orbit;
    const std::string rows_of_it = orbit ? neighbourhood_text(orbit->orbit, style, units) : "";
    text += rows_of_it.empty()
                ? ""
                : fmt::format("\n{} {}\n{}", i + 1, shortened(orbit->word.letters()), rows_of_it);
    any = any || !rows_of_it.empty();
  }
  const std::string meaning = any ? labelled(0, "recovers", meaning_of_neighbourhood(), style.width) : "";
  rows = {{{"   "}, {fmt::format("x1,x2,x1',x2'{} at load phase 0", units.are_SI() ? " in m and m/s" : "")}}};
  for (std::size_t i = 0; i < list.attractors.size(); ++i) {
    rows.push_back({{std::to_string(i + 1)}, {state_of(units.state(list.attractors[i].state))}});
  }
  return text + "\n" + columns_of(rows, style.width) + "\n" +
         labelled(0, "share",
                  "of the starts, with Wilson's interval of 95 %; what is said to be proved is; everything "
                  "else is "
                  "a check in floating point",
                  style.width) +
         meaning;
}

}  // namespace stickslip::report::orbits
