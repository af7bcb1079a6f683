#include "report/machines/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/decimal.hpp"
#include "numeric/words/word.hpp"
#include "report/orbits/machine.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::machines {

using namespace numeric;
using namespace numeric::machines;
using namespace tools;
using attractors::Kind;

namespace {

constexpr std::size_t most_phases = 16;  // in a table
constexpr int short_digits = 10;
constexpr int digits_in_change = 8;

std::string law(const Seen& seen, const model::FrictionLaw<Rational>& law) {
  if (law.smooth) {
    const model::SmoothFriction<Rational>& f = *law.smooth;
    const std::string viscous =
        f.viscous == 0 ? "" : ", and " + seen.with(f.viscous, "N s/m") + " of viscous friction";
    return fmt::format("{} at rest; sliding from {} to {}, {} over {}{}", seen.with(law.at_rest, "N"),
                       to_string(f.first), seen.with(f.last, "N"),
                       f.fall == model::Fall::exponential ? "exponentially" : "hyperbolically",
                       seen.with(f.scale, "m/s"), viscous);
  }
  return fmt::format("{} at rest; sliding {}{}", seen.with(law.at_rest, "N"),
                     enumerated(law.sliding,
                                [](const model::SlidingPiece<Rational>& piece) {
                                  return to_string(piece.force) + " from " + to_string(piece.from);
                                }),
                     seen.in_SI ? " (N, m/s)" : "");
}

}  // namespace

std::string Seen::unit(const char * name) const {
  return in_SI ? std::string(" in ") + name : "";
}

std::string Seen::with(const Rational& value, const char * name) const {
  return to_string(value) + (in_SI ? std::string(" ") + name : "");
}

std::string Seen::name(const Piece& piece) const {
  const bool several = piece.side() != 0 && oscillator().law(piece.side()).pieces() > 1;
  return words::letter(piece.kind) + (several ? std::to_string(piece.number + 1) : "");
}

std::vector<std::size_t> Seen::shown_masses() const {
  std::vector<std::size_t> masses{oscillator().rubbing};
  if (oscillator().size() > 1) {
    masses.push_back(oscillator().rubbing == 0 ? 1 : 0);
  }
  return masses;
}

std::vector<Row> machine_rows(const Seen& seen) {
  const model::FrictionOscillator<Rational>& o = seen.oscillator();
  const std::string masses = enumerated(o.masses, [&](const Rational& m) { return seen.with(m, "kg"); });
  const bool damped = (o.damping.array() != Rational(0)).any();
  std::vector<Row> rows{{{"masses"}, {fmt::format("{}{}", masses, damped ? "; with dashpots" : "")}},
                        {{"belt"}, {fmt::format("under mass {}, {}", o.rubbing + 1, seen.with(o.V, "m/s"))}},
                        {{"friction"}, {law(seen, o.forward)}}};
  if (law(seen, o.backward) != law(seen, o.forward)) {
    rows.push_back({{"  overshooting"}, {law(seen, o.backward)}});
  }
  const bool in_turns = seen.machine.in_turns;
  for (const model::HarmonicForce<Rational>& load : o.loads) {
    const std::string sine = load.sine == 0 ? "" : fmt::format(" and {} of sin", seen.with(load.sine, "N"));
    rows.push_back(
        {{"load"},
         {load.k == 0 ? fmt::format("{} on mass {}", seen.with(load.cosine, "N"), load.mass + 1)
                      : fmt::format("{}{} on mass {}, {} {}", seen.with(load.cosine, "N"), sine,
                                    load.mass + 1, in_turns ? "frequency" : "angular frequency",
                                    seen.with(Rational(load.k * o.omega), in_turns ? "Hz" : "rad/s"))}});
  }
  return rows;
}

std::string remark(const MachineOrbit& orbit) {
  return orbits::remark_on_periodic(orbit.existence, orbit.admissible,
                                    "closes, proved; " + to_string(orbit.admissible.truth), orbit.stability);
}

std::vector<orbits::ToldEnding> told(const std::vector<MachineAttractor>& all, const Seen& seen) {
  const bool has_load = !seen.oscillator().is_autonomous();
  std::vector<orbits::ToldEnding> endings;
  for (const MachineAttractor& a : all) {
    endings.push_back(
        {static_cast<const attractors::Ending&>(a), orbits::short_name(a, has_load), "", "", {}, {}});
    orbits::ToldEnding& one = endings.back();
    one.remark = a.orbit                    ? remark(*a.orbit)
                 : a.kind == Kind::periodic ? "not proved"
                                            : orbits::remark_on_others(a, has_load);
    if (a.orbit) {
      one.period = a.orbit->existence.truth == Truth::proved ? rounded(a.orbit->period, 8) : "";
      one.stability = a.orbit->stability;
      one.neighbourhood = a.orbit->neighbourhood;
    }
  }
  return endings;
}

namespace {

orbits::SeenOscillator oscillator_of(const Seen& seen, const Origin& origin) {
  return {machine_rows(seen),
          origin.file,
          coordinates_of(seen),
          seen.oscillator().rubbing,
          !seen.oscillator().is_autonomous(),
          "period" + seen.unit("s"),
          "periods"};
}

}  // namespace

orbits::ToldAlong told(const Diagram& result) {
  const MachineStarts& q = result.question;
  const Seen seen = seen_of(result);
  orbits::ToldAlong along{oscillator_of(seen, result.origin),
                          result.parameter,
                          parameter_of(result.parameter, result.origin),
                          result.from,
                          result.to,
                          result.values,
                          q.starts,
                          q.seed,
                          {},
                          result.interrupted};
  for (const auto& point : result.points) {
    along.points.push_back({point.value, point.outside, told(point.attractors, seen), point.once});
  }
  return along;
}

orbits::ToldPlane told(const Basins& b) {
  const Seen seen = seen_of(b);
  return {oscillator_of(seen, b.origin),
          b.across,
          b.pixels,
          b.starts,
          told(b.attractors, seen),
          b.ends,
          b.prove ? std::optional(b.proved) : std::nullopt,
          proved_share(b),
          b.interrupted};
}

std::string name_of(const MachineOrbit& orbit, bool autonomous) {
  const std::string word = orbits::shortened(word_of(orbit.pieces));
  return autonomous ? word : fmt::format("{}, period {}", word, orbit.periods);
}

std::vector<Row> orbit_rows(const MachineOrbit& orbit, const Seen& seen, int digits) {
  const model::FrictionOscillator<Rational>& o = seen.oscillator();
  std::vector<Row> rows{{{"  period"}, {rounded(orbit.period, digits) + (seen.in_SI ? " s" : "")}}};
  if (!o.is_autonomous()) {
    const bool several =
        std::any_of(o.loads.begin(), o.loads.end(), [](const auto& load) { return load.k > 1; });
    rows.push_back({{""},
                    {fmt::format("{} {} of the load{}", orbit.periods,
                                 orbit.periods == 1 ? "period" : "periods", several ? "s together" : "")}});
  }
  if (orbit.stability) {
    rows.push_back({{"  stability"}, {to_string(orbit.stability->kind)}});
    for (const motion::ComplexBall& mu : orbit.stability->multipliers) {
      rows.push_back({{"  multiplier"}, {orbits::complex_text(mu, short_digits)}});
    }
  }
  return rows;
}

std::vector<Row> phase_rows(const MachineOrbit& orbit, const Seen& seen) {
  const model::FrictionOscillator<Rational>& o = seen.oscillator();
  const std::vector<std::size_t> masses = seen.shown_masses();
  std::vector<Row> rows{{{"  phase"}, {"begins at t" + seen.unit("s")}, {"lasts" + seen.unit("s")}}};
  for (const std::size_t mass : masses) {
    rows[0].push_back({fmt::format("x{}{}", mass + 1, seen.unit("m"))});
    rows[0].push_back({fmt::format("x{}'{}", mass + 1, seen.unit("m/s"))});
  }
  for (std::size_t k = 0; k < std::min(orbit.phases.size(), most_phases); ++k) {
    const MachinePhase& f = orbit.phases[k];
    Row row{{fmt::format("  {} {}", seen.name(f.piece), to_string(f.piece.kind))},
            {k == 0 ? "0" : rounded(f.start, short_digits)},
            {rounded(f.duration, short_digits)}};
    for (const std::size_t mass : masses) {
      row.push_back({rounded(f.state(static_cast<Eigen::Index>(mass)), short_digits)});
      row.push_back({rounded(f.state(static_cast<Eigen::Index>(o.size() + mass)), short_digits)});
    }
    rows.push_back(row);
  }
  if (orbit.phases.size() > most_phases) {
    rows.push_back({{"  ..."}, {fmt::format("{} more", orbit.phases.size() - most_phases)}});
    rows.back().resize(rows[0].size(), {""});
  }
  return rows;
}

std::vector<orbits::Coordinate> coordinates_of(const Seen& seen) {
  std::vector<orbits::Coordinate> coordinates;
  const std::size_t n = seen.oscillator().size();
  for (std::size_t k = 0; k < 2 * n; ++k) {
    coordinates.push_back(
        {fmt::format("x{}{}", k % n + 1, k < n ? "" : "'"), seen.in_SI ? (k < n ? "m" : "m/s") : ""});
  }
  return coordinates;
}

std::array<std::string, 2> plane_of(const Basins& b) {
  const std::vector<orbits::Coordinate> all = coordinates_of(seen_of(b));
  return {all.at(static_cast<std::size_t>(b.across[0])).name,
          all.at(static_cast<std::size_t>(b.across[1])).name};
}

std::string command_of(const Diagram& result) {
  const MachineStarts& q = result.question;
  return fmt::format(
      "stickslip attractors {} --along {} {}..{} --values {} --starts {} --seed {} --most-periods {} "
      "--digits {}",
      result.origin.options, result.parameter, to_string(result.from), to_string(result.to), result.values,
      q.starts, q.seed, q.most_periods, q.digits);
}

std::string command_of(const Basins& b) {
  const auto [across, up] = plane_of(b);
  return fmt::format(
      "stickslip attractors {} --plane \"{},{}\" --pixels {}{}{} --most-periods {} --digits {}{}",
      b.origin.options, across, up, b.pixels[0],
      b.through ? " --through=" + orbits::comma_separated(*b.through) : "",
      b.half ? fmt::format(" --window={:.17g},{:.17g}", (*b.half)[0], (*b.half)[1]) : "",
      b.question.most_periods, b.question.digits, b.prove ? " --neighbourhood" : "");
}

std::string command_of(const Attractors& result) {
  const MachineStarts& q = result.question;
  const bool with_neighbourhoods = std::ranges::any_of(
      result.attractors, [](const auto& a) { return a.orbit && a.orbit->neighbourhood != nullptr; });
  return fmt::format("stickslip attractors --params {} --starts {} --seed {} --most-periods {} --digits {}{}",
                     result.origin.file, q.starts, q.seed, q.most_periods, q.digits,
                     with_neighbourhoods ? " --neighbourhood" : "");
}

namespace {

// The word, the machine and what else says which of its orbits are meant.
std::string of_word(const auto& result) {
  const MachineWord& q = result.question;
  return q.word.letters() + " " + result.origin.options +
         (q.periods ? fmt::format(" --period {}", *q.periods) : "") +
         (q.near ? " --near=" + orbits::comma_separated(*q.near) : "");
}

std::string along(const Varied& v) {
  return fmt::format(" --along {} {}..{}", v.path, to_string(v.from), to_string(v.to));
}

std::string which(const FromOrbits& result) {
  return (result.orbit ? fmt::format(" --orbit {}", *result.orbit) : "") + (result.all ? " --all" : "");
}

}  // namespace

std::string command_of(const WordOrbits& result) {
  const bool with_neighbourhoods =
      std::ranges::any_of(result.orbits, [](const auto& orbit) { return orbit.neighbourhood != nullptr; });
  return fmt::format("stickslip orbits {} --digits {}{}", of_word(result), result.question.digits,
                     with_neighbourhoods ? " --neighbourhood" : "");
}

std::string command_of(const Branches& result) {
  return fmt::format("stickslip branch {}{} --at {}{}{}", of_word(result), along(result.varied),
                     to_string(result.varied.start), which(result),
                     result.without_gaps ? " --without-gaps" : "");
}

std::string command_of(const OverBox& result) {
  return fmt::format("stickslip branch {}{}{} --parts {}", of_word(result),
                     enumerated(result.data, along, ""), which(result), result.most_parts);
}

std::string command_of(const Motion& result) {
  const MotionQuestion& q = result.question;
  return fmt::format("stickslip simulate --params {} --state={}{} --time={:.17g}{}", result.origin.file,
                     orbits::comma_separated(q.start),
                     q.theta == 0 ? "" : fmt::format(" --phi={:.17g}", q.theta), q.duration,
                     q.every ? fmt::format(" --every={:.17g}", *q.every) : "");
}

std::string command_of(const SetMotion& result) {
  const SetAfterQuestion& q = result.question;
  return fmt::format("stickslip simulate {} --state={} --set={}{} --time={:.17g}", result.origin.options,
                     orbits::comma_separated(q.middle), orbits::comma_separated(q.half),
                     q.theta == 0 ? "" : fmt::format(" --phi={:.17g}", q.theta), q.time);
}

namespace {

std::string short_number(const Rational& x) {
  return rounded(Ball(x), short_digits);
}

// What is proved of the values between those of the samples.
std::string gaps_of(const MachineBranch& branch) {
  std::string gaps;
  for (std::size_t k = 0; k < branch.joints.size(); ++k) {
    const Verdict& verdict = branch.joints[k].existence;
    if (verdict.truth == Truth::proved) {
      continue;
    }
    const std::size_t first = k;
    while (k + 1 < branch.joints.size() && branch.joints[k + 1].existence.reason == verdict.reason) {
      ++k;
    }
    gaps += fmt::format("{} between {} and {} ({})", gaps.empty() ? "" : ",",
                        short_number(branch.samples[first].value), short_number(branch.samples[k + 1].value),
                        verdict.reason);
  }
  return branch.joints.empty() ? ""
         : gaps.empty()
             ? " At each value between there is exactly one such motion, too: a curve without a gap."
             : " At each value between there is exactly one such motion, too, but this is not proved" + gaps +
                   ".";
}

// Of the samples from one to another.
std::string between(const MachineBranch& branch, std::ptrdiff_t first, std::ptrdiff_t last) {
  if (branch.joints.empty() || first == last) {
    return "";
  }
  const auto begin = branch.joints.begin();
  const auto open = std::count_if(begin + first, begin + last,
                                  [](const Joint& joint) { return joint.state.truth != Truth::proved; });
  return open == 0 ? ", and at all values between"
                   : fmt::format(", and between {} of {} neighbours", last - first - open, last - first);
}

}  // namespace

orbits::BranchRows rows_of(const MachineBranch& branch) {
  orbits::BranchRows rows{
      fmt::format("From {}, {}, to {}, {}: {} motions on the way, each proved on its own.{}",
                  short_number(branch.first.at), branch.first.words, short_number(branch.last.at),
                  branch.last.words, branch.samples.size(), gaps_of(branch)),
      {},
      {}};
  const auto begin = branch.samples.begin();
  for (auto now = branch.samples.begin(); now != branch.samples.end();) {
    const auto next = std::find_if(now, branch.samples.end(),
                                   [&](const MachineSample& s) { return s.state != now->state; });
    rows.pieces.push_back({{short_number(now->value)},
                           {short_number(std::prev(next)->value)},
                           {std::to_string(next - now)},
                           {to_string(now->state) + between(branch, now - begin, next - begin - 1)}});
    now = next;
  }
  for (const MachineChange& change : branch.changes) {
    rows.changes.push_back({{rounded(Ball::from_interval(std::min(change.first, change.last),
                                                         std::max(change.first, change.last)),
                                     digits_in_change)},
                            {to_string(change.kind)},
                            {change.words}});
  }
  return rows;
}

namespace {

// Parts of which the same is known.
struct KindOfPart {
  Rational volume = 0;
  long parts = 0;
  Values low, high;  // of all of them

  // Returns its volume.
  Rational add(const PartOfBox& part) {
    Rational its = 1;
    for (std::size_t k = 0; k < part.low.size(); ++k) {
      its *= part.high[k] - part.low[k];
    }
    volume += its;
    if (++parts == 1) {
      low = part.low;
      high = part.high;
    }
    for (std::size_t k = 0; k < low.size(); ++k) {
      low[k] = std::min(low[k], part.low[k]);
      high[k] = std::max(high[k], part.high[k]);
    }
    return its;
  }
};

// Less than all is less than 100 %.
std::string percent(const Rational& share) {
  constexpr int digits = 4;
  return share == 1 ? "100 %" : below(Rational(100 * share).get_d(), digits) + " %";
}

std::string in_words(const PartOfBox& part) {
  if (part.existence.truth != Truth::proved) {
    return "undecided: " + part.existence.reason;
  }
  const auto& [state, names] = part.motions;
  return state == branches::State::undecided ? "there, but what they are is undecided: " + names
         : names.empty()                     ? to_string(state)
         : is_decided(state)                 ? fmt::format("{}: {} {} violated", to_string(state), names,
                                           names.find(',') == std::string::npos ? "is" : "are")
                                             : fmt::format("{}, {} undecided", to_string(state), names);
}

}  // namespace

BoxRows rows_of(const OverBox& result, const OverBox::Family& family) {
  Rational whole = 0, exists = 0, decided = 0;
  std::map<std::string, KindOfPart> kinds;
  for (const PartOfBox& part : family.parts) {
    const Rational its = kinds[in_words(part)].add(part);
    const bool is_there = part.existence.truth == Truth::proved;
    whole += its;
    exists += is_there ? its : Rational(0);
    decided += is_there && is_decided(part.motions.state) ? its : Rational(0);
  }
  BoxRows rows{
      exists == 0
          ? "Nothing is proved of this box."
          : fmt::format(
                "At all data in {} there is exactly one such motion near, and "
                "it changes continuously with them. Of {} it is proved what the "
                "motions are.",
                exists == whole ? "the box" : percent(Rational(exists / whole)) + " of the box",
                decided == exists ? "all of them" : percent(Rational(decided / whole)) + " of the box"),
      decided == whole,
      {}};
  for (const auto& [words, kind] : largest_first(kinds, &KindOfPart::volume)) {
    std::string where;
    for (std::size_t k = 0; k < result.data.size(); ++k) {
      const auto& [path, from, to, start] = result.data[k];
      if (kind.low[k] != from || kind.high[k] != to) {
        where += fmt::format("{}{} from {} to {}", where.empty() ? "; " : ", ", path,
                             short_number(kind.low[k]), short_number(kind.high[k]));
      }
    }
    rows.kinds.push_back(
        {{percent(Rational(kind.volume / whole))}, {std::to_string(kind.parts)}, {words + where}});
  }
  return rows;
}

std::string range_of(const Varied& v, const Origin& origin) {
  return fmt::format("{} from {} to {}", parameter_of(v.path, origin), to_string(v.from), to_string(v.to));
}

std::string start_of(const Varied& v) {
  return fmt::format("{} = {}", v.path, to_string(v.start));
}

std::string box_of(const OverBox& result) {
  return enumerated(result.data, [&](const Varied& varied) { return range_of(varied, result.origin); });
}

std::string start_of(const OverBox& result) {
  return enumerated(result.data, [](const Varied& varied) { return start_of(varied); });
}

std::string parameter_of(const std::string& path, const Origin& origin) {
  const std::string last = path.substr(path.rfind('.') + 1);
  const char * unit = last == "m"                                  ? "kg"
                      : last == "k"                                ? "N/m"
                      : last == "c"                                ? "N s/m"
                      : last == "velocity"                         ? "m/s"
                      : last == "frequency"                        ? "Hz"
                      : last == "angular_frequency"                ? "rad/s"
                      : last == "over"                             ? "m/s"
                      : last == "viscous"                          ? "N s/m"
                      : path.find("sliding.") != std::string::npos ? (last == "1" ? "m/s" : "N")
                                                                   : "N";
  const std::string known = orbits::in_unit_of(path);
  return !origin.in_SI ? path : known.empty() ? path + " in " + unit : path + known;
}

namespace {

std::string basin_option(const Rectangle& r) {
  return fmt::format(" --basin={}..{},{}..{}", to_string(r.x_from), to_string(r.x_to), to_string(r.y_from),
                     to_string(r.y_to));
}

std::string others_text(const Verdict& others) {
  return others.truth == Truth::proved
             ? "proved to end on one cycle that sticks"
             : fmt::format("{} to end on one cycle that sticks: {}", to_string(others.truth), others.reason);
}

}  // namespace

std::string command_of(const Steady& result) {
  return fmt::format("stickslip orbits S --params {} --digits {}{}", result.origin.file,
                     result.question.digits, result.basin ? basin_option(result.basin->starts) : "");
}

std::string command_of(const SteadyBranch& result) {
  return fmt::format("stickslip branch S --params {}{}{}", result.origin.file, along(result.varied),
                     result.basins ? basin_option(result.basins->starts) : "");
}

std::vector<Row> rows_of(const SteadySliding& state, const Seen& seen, int digits) {
  if (state.existence.truth != Truth::proved) {
    return {{{"steady sliding"},
             {fmt::format("{}: {}", state.existence.truth == Truth::refuted ? "none" : "undecided",
                          state.existence.reason)}}};
  }
  std::vector<Row> rows{{{"steady sliding"}, {fmt::format("{}, proved", seen.name(state.piece))}},
                        {{"  friction"}, {rounded(state.friction, digits) + (seen.in_SI ? " N" : "")}}};
  for (Eigen::Index i = 0; i < state.x.size(); ++i) {
    rows.push_back({{fmt::format("  x{}", i + 1)}, {rounded(state.x(i), digits) + (seen.in_SI ? " m" : "")}});
  }
  rows.push_back(
      {{"  stability"}, {to_string(state.stability) + (state.reason.empty() ? "" : ": " + state.reason)}});
  for (const motion::ComplexBall& mu : state.eigenvalues) {
    rows.push_back(
        {{"  eigenvalue"}, {orbits::complex_text(mu, short_digits) + (seen.in_SI ? " per s" : "")}});
  }
  return rows;
}

std::vector<Row> rows_of(const SteadyAlong& along, const Seen& seen) {
  std::vector<Row> rows;
  for (const SteadyAlong::Change& change : along.changes) {
    std::string words = change.is_lost ? "stability is lost" : "stability is gained";
    if (change.is_corner) {
      words += ", where two pieces of the friction law meet";
    } else if (change.frequency) {
      words += fmt::format(": a pair of eigenvalues crosses the imaginary axis near {}i{}",
                           rounded(*change.frequency, 6), seen.in_SI ? " per s" : "");
    }
    rows.push_back({{rounded(Ball::from_interval(change.first, change.last), short_digits)}, {words}});
  }
  return rows;
}

std::vector<Row> rows_of(const SteadyBasin& result, const Seen& seen, int digits) {
  const PlanarBasin& basin = result.basin;
  const Rectangle& r = result.starts;
  const std::string starts = fmt::format("x1 from {} to {} and x1' from {} to {}", to_string(r.x_from),
                                         to_string(r.x_to), to_string(r.y_from), to_string(r.y_to));
  if (basin.verdict.truth != Truth::proved) {
    return {{{"basin"},
             {fmt::format("{}: {}", basin.verdict.truth == Truth::refuted ? "none" : "undecided",
                          basin.verdict.reason)}}};
  }
  const auto in = [&](const Ball& x, const char * unit) { return rounded(x, digits) + seen.unit(unit); };
  return {{{"basin"}, {"the inside of one closed motion below the belt, proved"}},
          {{"  share"}, {fmt::format("{} of {}", rounded(basin.share, digits), starts)}},
          {{"  all others"}, {others_text(basin.others)}},
          {{"closed motion"}, {"unstable, the only one below the belt"}},
          {{"  from x1"}, {in(basin.x, "m") + ", at velocity 0"}},
          {{"  period"}, {in(basin.period, "s")}},
          {{"  multiplier"}, {rounded(basin.multiplier, digits)}},
          {{"  area"}, {in(basin.area, "m^2/s")}}};
}

std::vector<Row> rows_of(const SteadyBasins& basins, const std::string& parameter) {
  constexpr int digits_of_share = 12;
  std::vector<Row> rows{{{parameter}, {"share of the starts"}, {"all others"}}};
  const auto& samples = basins.along.samples;
  for (auto now = samples.begin(); now != samples.end();) {
    const Verdict& verdict = now->basin.verdict;
    if (verdict.truth == Truth::proved) {
      rows.push_back(
          {{to_string(now->value)},
           {rounded(now->basin.share, digits_of_share)},
           {now->basin.others.truth == Truth::proved ? "stick" : to_string(now->basin.others.truth)}});
      ++now;
      continue;
    }
    const auto next = std::find_if(now, samples.end(),
                                   [&](const auto& s) { return s.basin.verdict.reason != verdict.reason; });
    rows.push_back({{next - now == 1
                         ? to_string(now->value)
                         : fmt::format("{} to {}", to_string(now->value), to_string(std::prev(next)->value))},
                    {verdict.truth == Truth::refuted ? "none" : "undecided"},
                    {verdict.reason}});
    now = next;
  }
  return rows;
}

std::vector<Row> end_rows(const SteadyBasins& basins) {
  constexpr int digits_of_end = 12;
  std::vector<Row> rows;
  for (const PlanarBasinAlong::End& end : basins.along.ends) {
    rows.push_back({{rounded(Ball::from_interval(end.first, end.last), digits_of_end)},
                    {fmt::format("the basin of steady sliding is {}: {}", end.is_gained ? "gained" : "lost",
                                 end.at_belt ? "the closed motion around it touches the belt"
                                             : "the closed motion around it shrinks to it")}});
  }
  return rows;
}

}  // namespace stickslip::report::machines
