#include "report/orbits/attractors.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/decimal.hpp"
#include "numeric/words/pure_stick.hpp"
#include "report/orbits/diagram.hpp"
#include "report/orbits/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace numeric::motion;
using namespace tools;

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
  if (a.kind != Kind::periodic) {
    return remark_on_others(a);
  }
  if (!a.orbit) {
    return "not proved";
  }
  const families::Orbit& o = a.orbit->orbit;
  return remark_on_periodic(a.orbit->existence, o.admissible, verdict_on(o), o.stability) +
         (a.family.empty() ? "" : ", " + a.family);
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
       {fmt::format("{}; {} periods in all{}", starts_in_words(q.starts, q.seed, q.most_periods, true),
                    list.simulated, interruption_in_words(list.interrupted, list.followed))}}};
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
  const std::vector<ToldEnding> all = told(list.attractors);
  const std::string recover = neighbourhoods_of(all, coordinates_in(units), style);
  text += "\n" + table_of(all, "period", WithInterval::yes, style) + recover;
  std::vector<Row> rows{
      {{"   "}, {fmt::format("x1,x2,x1',x2'{} at load phase 0", units.are_SI() ? " in m and m/s" : "")}}};
  for (std::size_t i = 0; i < list.attractors.size(); ++i) {
    rows.push_back({{std::to_string(i + 1)}, {state_of(units.state(list.attractors[i].state))}});
  }
  return text + "\n" + columns_of(rows, style.width) + "\n" +
         labelled(0, "share",
                  "of the starts, with Wilson's interval of 95 %; what is said to be proved is; everything "
                  "else is "
                  "a check in floating point",
                  style.width) +
         (recover.empty() ? "" : labelled(0, "recovers", meaning_of_neighbourhood(), style.width));
}

}  // namespace stickslip::report::orbits
