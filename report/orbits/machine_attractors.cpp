#include "report/orbits/machine_attractors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/decimal.hpp"
#include "numeric/words/word.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::machines;
using namespace tools;
using attractors::Kind;

namespace {

constexpr std::size_t most_phases = 16;  // in a table
constexpr int digits = 10;

class Text {
 public:
  Text(const MachineAttractors& list, const Style& style, bool in_SI)
      : list_(list), o_(list.question.machine.oscillator), style_(style), in_SI_(in_SI) {}

  [[nodiscard]] std::string text() const {
    std::string text = columns_of({{{"What the machine does", bold(style_)}}}, style_.width) +
                       columns_of(machine(), style_.width) + "\n" + columns_of(attractors(), style_.width);
    for (std::size_t i = 0; i < list_.attractors.size(); ++i) {
      const MachineAttractor& a = list_.attractors[i];
      if (a.orbit && a.orbit->existence.truth == Truth::proved) {
        text += "\n" + orbit(i, *a.orbit);
      }
    }
    return text + "\n" +
           labelled(
               0, "share",
               "of the starts, with Wilson's interval of 95 %; what is said to be proved is, of the machine "
               "exactly as it is given; everything else is a check in floating point",
               style_.width) +
           labelled(
               0, "margin",
               fmt::format("the least distance from a violation, along a phase divided by the time to an end "
                           "where it is zero by itself{}",
                           in_SI_ ? "; N, m/s and s" : ""),
               style_.width);
  }

 private:
  [[nodiscard]] std::string unit(const char * name) const { return in_SI_ ? std::string(" in ") + name : ""; }
  [[nodiscard]] std::string with(const Rational& value, const char * name) const {
    return to_string(value) + (in_SI_ ? std::string(" ") + name : "");
  }

  [[nodiscard]] std::string law(const model::FrictionLaw<Rational>& law) const {
    std::vector<std::string> points;
    for (const model::SlidingPiece<Rational>& piece : law.sliding) {
      points.push_back(fmt::format("{} from {}", to_string(piece.force), to_string(piece.from)));
    }
    return fmt::format("{} at rest; sliding {}{}", with(law.at_rest, "N"), fmt::join(points, ", "),
                       in_SI_ ? " (N, m/s)" : "");
  }

  [[nodiscard]] std::vector<Row> machine() const {
    std::vector<std::string> masses;
    for (const Rational& m : o_.masses) {
      masses.push_back(with(m, "kg"));
    }
    bool damped = false;
    for (Eigen::Index i = 0; i < o_.damping.size(); ++i) {
      damped = damped || o_.damping.data()[i] != 0;
    }
    std::vector<Row> rows{
        {{"masses"}, {fmt::format("{}{}", fmt::join(masses, ", "), damped ? "; with dashpots" : "")}},
        {{"belt"}, {fmt::format("under mass {}, {}", o_.rubbing + 1, with(o_.V, "m/s"))}},
        {{"friction"}, {law(o_.forward)}}};
    if (law(o_.backward) != law(o_.forward)) {
      rows.push_back({{"  overshooting"}, {law(o_.backward)}});
    }
    for (const model::HarmonicForce<Rational>& load : o_.loads) {
      const std::string sine = load.sine == 0 ? "" : fmt::format(" and {} of sin", with(load.sine, "N"));
      rows.push_back(
          {{"load"},
           {load.k == 0 ? fmt::format("{} on mass {}", with(load.cosine, "N"), load.mass + 1)
                        : fmt::format("{}{} on mass {}, {} {}", with(load.cosine, "N"), sine, load.mass + 1,
                                      list_.question.machine.in_turns ? "frequency" : "angular frequency",
                                      with(Rational(load.k * o_.omega),
                                           list_.question.machine.in_turns ? "Hz" : "rad/s"))}});
    }
    rows.push_back({{"starts"},
                    {fmt::format("{} at random, seed {}, each followed until it has settled or for {} {}{}",
                                 list_.question.starts, list_.question.seed, list_.question.most_periods,
                                 o_.is_autonomous() ? "events" : "periods of the load",
                                 list_.interrupted ? "; interrupted: the shares say nothing" : "")}});
    return rows;
  }

  [[nodiscard]] std::string remark(const MachineAttractor& a) const {
    switch (a.kind) {
      case Kind::periodic:
        break;
      case Kind::slides:
        return "no contact with the belt any more, and no event";
      case Kind::stuck:
        return "does not leave the belt any more";
      default:
        return o_.is_autonomous() ? "within the events allowed" : "within the periods allowed";
    }
    if (!a.orbit || a.orbit->existence.truth != Truth::proved) {
      return "not proved" + (a.orbit ? ": " + a.orbit->existence.reason : std::string());
    }
    if (a.orbit->admissible.truth != Truth::proved) {
      return fmt::format("closes, proved; {}: {}", to_string(a.orbit->admissible.truth),
                         a.orbit->admissible.reason);
    }
    if (!a.orbit->stability) {
      return "proved";
    }
    const motion::Stability& s = *a.orbit->stability;
    const std::string radius = s.multipliers.empty() ? "" : fmt::format(", |mu| = {}", spectral_radius(s));
    return fmt::format("proved, {}{}{}", to_string(s.kind), s.reason.empty() ? "" : ": " + s.reason, radius);
  }

  [[nodiscard]] std::vector<Row> attractors() const {
    std::vector<Row> rows{{{"   "}, {"share"}, {"95 %"}, {"motion"}, {"period" + unit("s")}, {"word"}, {""}}};
    for (std::size_t i = 0; i < list_.attractors.size(); ++i) {
      const MachineAttractor& a = list_.attractors[i];
      const bool known = a.orbit && a.orbit->existence.truth == Truth::proved;
      rows.push_back({{std::to_string(i + 1)},
                      {fmt::format("{:.1f} %", 100 * a.share)},
                      {fmt::format("{:.1f}-{:.1f}", 100 * a.least, 100 * a.most)},
                      {to_string(a.kind)},
                      {known ? rounded(a.orbit->period, 8) : ""},
                      {shortened(a.word)},
                      {remark(a)}});
    }
    return rows;
  }

  // Beginning with the rotation that the word has.
  [[nodiscard]] std::string orbit(std::size_t i, const MachineOrbit& orbit) const {
    const Row heading{
        {fmt::format("Orbit {}:", i + 1), bold(style_)},
        {orbit.admissible.truth == Truth::proved ? "admissible" : to_string(orbit.admissible.truth),
         colour_of(orbit.admissible.truth, style_)}};
    std::vector<Row> rows{
        {{"  period"}, {rounded(orbit.period, list_.question.digits) + (in_SI_ ? " s" : "")}}};
    if (!o_.is_autonomous()) {
      const bool several =
          std::any_of(o_.loads.begin(), o_.loads.end(), [](const auto& load) { return load.k > 1; });
      rows.push_back({{""},
                      {fmt::format("{} {} of the load{}", orbit.periods,
                                   orbit.periods == 1 ? "period" : "periods", several ? "s together" : "")}});
    }
    if (orbit.stability) {
      rows.push_back({{"  stability"}, {to_string(orbit.stability->kind)}});
      for (const motion::ComplexBall& mu : orbit.stability->multipliers) {
        rows.push_back({{"  multiplier"}, {complex_text(mu, digits)}});
      }
    }
    return columns_of({heading}, style_.width) + columns_of(rows, style_.width) + "\n" + phases(orbit) +
           "\n" + condition_rows(worst(orbit.conditions), style_);
  }

  [[nodiscard]] std::string phases(const MachineOrbit& orbit) const {
    const std::size_t n = o_.size();
    std::vector<Row> rows{{{"  phase"}, {"begins at t" + unit("s")}, {"lasts" + unit("s")}}};
    for (const std::size_t mass : shown_masses()) {
      rows[0].push_back({fmt::format("x{}{}", mass + 1, unit("m"))});
      rows[0].push_back({fmt::format("x{}'{}", mass + 1, unit("m/s"))});
    }
    for (std::size_t k = 0; k < std::min(orbit.phases.size(), most_phases); ++k) {
      const MachinePhase& f = orbit.phases[k];
      const bool pieces = o_.law(f.piece.side()).sliding.size() > 1 && f.piece.side() != 0;
      Row row{{fmt::format("  {}{} {}", words::letter(f.piece.kind),
                           pieces ? std::to_string(f.piece.number + 1) : "", to_string(f.piece.kind))},
              {k == 0 ? "0" : rounded(f.start, digits)},
              {rounded(f.duration, digits)}};
      for (const std::size_t mass : shown_masses()) {
        row.push_back({rounded(f.state(static_cast<Eigen::Index>(mass)), digits)});
        row.push_back({rounded(f.state(static_cast<Eigen::Index>(n + mass)), digits)});
      }
      rows.push_back(row);
    }
    if (orbit.phases.size() > most_phases) {
      rows.push_back({{"  ..."}, {fmt::format("{} more", orbit.phases.size() - most_phases)}});
      rows.back().resize(rows[0].size(), {""});
    }
    return columns_of(rows, style_.width);
  }

  // The one on the belt, and the first other one.
  [[nodiscard]] std::vector<std::size_t> shown_masses() const {
    std::vector<std::size_t> masses{o_.rubbing};
    if (o_.size() > 1) {
      masses.push_back(o_.rubbing == 0 ? 1 : 0);
    }
    return masses;
  }

  const MachineAttractors& list_;
  const model::FrictionOscillator<Rational>& o_;
  const Style& style_;
  bool in_SI_;
};

}  // namespace

std::string terminal_report(const MachineAttractors& list, const Style& style, bool in_SI) {
  return Text(list, style, in_SI).text();
}

}  // namespace stickslip::report::orbits
