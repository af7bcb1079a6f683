#include "numeric/machines/orbits/motions_over_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "core/domain.hpp"
#include "core/interruption.hpp"
#include "core/parallel.hpp"

namespace stickslip::numeric::machines {

using branches::State;
using motion::Condition;
using motion::StabilityKind;

State state_of(const MachineOrbit& orbit) {
  if (orbit.existence.truth != Truth::proved) {
    return State::undecided;
  }
  if (std::ranges::any_of(orbit.conditions, [](const Condition& c) {
        return c.id == "duration" && c.verdict.truth == Truth::refuted;
      })) {
    return State::absent;
  }
  if (orbit.admissible.truth != Truth::proved) {
    return orbit.admissible.truth == Truth::refuted ? State::inadmissible : State::undecided;
  }
  const StabilityKind kind = orbit.stability ? orbit.stability->kind : StabilityKind::undecided;
  return kind == StabilityKind::stable     ? State::stable
         : kind == StabilityKind::unstable ? State::unstable
         : kind == StabilityKind::marginal ? State::marginal
                                           : State::admissible;
}

bool is_decided(State state) {
  return state != State::undecided && state != State::admissible;
}

namespace {

constexpr long bits = 64;
// Of the way between two motions, for Newton's method.
constexpr int most_halvings_of_way = 6;
// How much wider than the last part that was proved one may be to be looked at.
constexpr double most_growth = 2.5;
// Parts that are looked at before what comes of them counts for others.
constexpr std::size_t at_once = 16;

// "stick.upper, slip": of conditions that are so, each name once.
std::string names_of(const std::vector<Condition>& conditions, Truth truth) {
  std::set<std::string> names;
  for (const Condition& c : conditions) {
    if (c.verdict.truth == truth) {
      names.insert(c.id);
    }
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

// What motions are that exist, all at once.
Judged judged(const MachineOrbit& orbit) {
  const State state = state_of(orbit);
  const bool holds = orbit.admissible.truth == Truth::proved;
  return {state, is_decided(state) ? holds ? "" : names_of(orbit.conditions, Truth::refuted)
                 : !holds ? names_of(orbit.conditions, Truth::undecided)
                                   : "stability"};
}

Rational volume_of(const Values& edges) {
  Rational volume = 1;
  for (const Rational& edge : edges) {
    volume *= edge;
  }
  return volume;
}

constexpr auto none = std::numeric_limits<std::size_t>::max();

// A part in which the motions exist, and the places of the closed chains that are known of them.
struct Whole {
  Judged motions;
  std::vector<std::size_t> known;
  std::size_t of = none;  // the place of the whole of which it is a part
};

// A part of the box.
struct Part : ValuesInBox {
  std::vector<int> halvings;
  std::vector<std::size_t> known = {};  // places of the closed chains that are known in it
  std::size_t near = 0;                 // and of one that may lie beside it
  std::size_t whole = none;             // the place of that of which it is a part
  double away = 0;                      // from a given motion

  [[nodiscard]] bool contains(const Values& values) const {
    return std::ranges::all_of(s_of(values), [](const Rational& s) { return abs(s) <= 1; });
  }
  [[nodiscard]] std::pair<Part, Part> halved(std::size_t k) const {
    Part low = *this;
    low.half[k] /= 2;
    ++low.halvings[k];
    Part high = low;
    low.middle[k] -= low.half[k];
    high.middle[k] += low.half[k];
    return {low, high};
  }
};

class Search {
 public:
  Search(const DataBox& box, const std::vector<MotionAt>& motions, const Effort& effort)
      : box_(box),
        numbers_(box.at, box.low, box.high),
        effort_(effort),
        periods_(motions.front().guess.periods),
        pieces_(motions.front().guess.pieces()),
        why_(numbers_.why_not()),
        whole_{ValuesInBox::between(box.low, box.high), std::vector<int>(box.low.size(), 0)} {
    if (!why_.empty()) {
      return;
    }
    known_ = parallel_map(motions.size(), [&](std::size_t i) {
      const MotionAt& motion = motions[i];
      const Machine machine = box_.at(motion.values);
      return Known{motion.values, prove_chain({machine, pieces_, periods_}, nodes_of(motion.guess, machine),
                                              bits, 8 * bits)};
    });
    for (const Known& one : known_) {
      why_ = one.proof.verdict.truth == Truth::proved ? why_ : one.proof.verdict.reason;
    }
    given_ = known_.size();
  }

  [[nodiscard]] std::vector<PartOfBox> run() {
    if (!why_.empty()) {
      const auto open = Verdict::undecided(why_);
      return {{box_.low, box_.high, open, {}}};
    }
    whole_.known.resize(given_);
    std::iota(whole_.known.begin(), whole_.known.end(), 0);
    whole_.near = given_ / 2;
    if (const Verdict found = find_width(); found.truth != Truth::proved) {
      return {{box_.low, box_.high, found, {}}};
    }
    std::vector<Part> now{whole_};
    while (!now.empty()) {
      // Where not all can be looked at those are that have the shortest way to a given motion.
      std::ranges::stable_sort(now, {}, &Part::away);
      std::vector<Part> halves;
      double ahead = 0;  // parts to be looked at that those before are halved to
      for (std::size_t first = 0; first < now.size(); first += at_once) {
        const std::span<const Part> batch =
            std::span(now).subspan(first, std::min(at_once, now.size() - first));
        auto left = static_cast<double>(effort_.most_parts - looked_at_);
        long most = 0;
        for (const Part& part : batch) {
          most += ahead < left ? 1 : 0;
          const bool is_wide = is_too_wide(part);
          ahead += is_wide ? count_narrow(part) : 0;
          left -= is_wide ? 0 : 1;
        }
        look_at(batch, most, halves);
      }
      now = halves;
    }
    return joined();
  }

 private:
  struct Found {
    Verdict existence;
    Judged motions = {};
    bool looked = false;
    bool is_of_whole = false;               // as they exist there
    std::optional<ChainProof> middle = {};  // the closed chain in the middle
    std::vector<double> changes = {};       // with each datum
  };
  struct Done {
    Part part;
    Found found;
  };

  // At so many of the parts; those that are not done are halved.
  void look_at(std::span<const Part> parts, long most, std::vector<Part>& halves) {
    const auto is_left_out = [&](std::size_t i) { return interrupted() || static_cast<long>(i) >= most; };
    const auto all = parallel_map(parts.size(), [&](std::size_t i) {
      const char * const why = interrupted() ? "interrupted" : "more parts than were to be looked at";
      Found found = is_left_out(i) ? Found{Verdict::undecided(why)} : look(parts[i]);
      if (parts[i].whole != none && found.existence.truth != Truth::proved) {
        found.existence = Verdict::proved();
        found.motions = wholes_[parts[i].whole].motions;
        found.is_of_whole = true;
        found.middle.reset();  // it is not known to be one of those
      }
      return found;
    });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Part& part = parts[i];
      const bool exists = all[i].existence.truth == Truth::proved;
      const bool is_done = exists && (is_decided(all[i].motions.state) || !effort_.with_state);
      const auto datum = is_left_out(i) || is_done ? std::nullopt : to_halve(part, all[i]);
      if (all[i].looked) {
        ++looked_at_;
        tried_[part.halvings].add(is_done, datum);
      }
      width_ = is_done && volume_of(part.half) > volume_of(width_) ? part.half : width_;
      if (datum) {
        halve(part, *datum, all[i], halves);
      } else {
        done_.push_back({part, all[i]});
      }
    }
  }

  // From the nearest of the given motions, in parts of the box.
  [[nodiscard]] double distance(const Part& part) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < given_; ++i) {
      double most = 0;
      for (std::size_t k = 0; k < part.middle.size(); ++k) {
        const Rational away = abs(Rational(part.middle[k] - known_[i].s[k])) / whole_.half[k];
        most = std::max(most, away.get_d());
      }
      least = std::min(least, most);
    }
    return least;
  }

  // How wide a part with the motion in the middle may be; undecided when none is narrow enough.
  [[nodiscard]] Verdict find_width() {
    Part part = whole_;
    for (long looked_at = 0; looked_at < effort_.most_parts && !interrupted(); ++looked_at) {
      const Found found = look(part);
      const bool exists = found.existence.truth == Truth::proved;
      if (exists && (width_.empty() || is_decided(found.motions.state))) {
        width_ = part.half;
      }
      const auto datum = to_halve(part, found);
      if (!datum || is_decided(found.motions.state) || (exists && !effort_.with_state)) {
        return width_.empty() ? found.existence : Verdict::proved();
      }
      const auto [low, high] = part.halved(*datum);
      part = low.contains(known_[part.near].s) ? low : high;
      std::erase_if(part.known, [&](std::size_t i) { return !part.contains(known_[i].s); });
    }
    return width_.empty() ? Verdict::undecided("no part is narrow enough") : Verdict::proved();
  }

  [[nodiscard]] MachineQuestion question_at(const Values& values) const {
    return {box_.at(values), pieces_, periods_};
  }
  // From a closed chain to the one there.
  [[nodiscard]] std::optional<Nodes> reach(const Values& from, const Nodes& nodes, const Values& to,
                                           int halvings) const {
    if (const auto found = approximate_chain(question_at(to), nodes); found || halvings == 0) {
      return found;
    }
    const Values half = ValuesInBox::between(from, to).middle;
    const auto between = reach(from, nodes, half, halvings - 1);
    return between ? reach(half, *between, to, halvings - 1) : std::nullopt;
  }

  // Parts of one shape, which is given by how often it was halved.
  struct Tried {
    int failed = 0;
    bool passed = false;
    std::size_t datum = 0;  // with which most changes

    void add(bool passes, std::optional<std::size_t> to_halve) {
      passed = passed || passes;
      failed += passes ? 0 : 1;
      datum = to_halve.value_or(datum);
    }
  };
  // Those that failed next to the given motions, if none passed.
  [[nodiscard]] const Tried * failed(const Part& part) const {
    constexpr int enough = 4;
    const auto found = tried_.find(part.halvings);
    return found != tried_.end() && !found->second.passed && found->second.failed >= enough ? &found->second
                                                                                            : nullptr;
  }

  // Into how many parts that are not too wide one that is has to be cut, as far as is known.
  [[nodiscard]] double count_narrow(const Part& part) const {
    double count = 1;
    for (std::size_t k = 0; k < width_.size(); ++k) {
      const double wider = Rational(part.half[k] / (width_[k] * Rational(most_growth))).get_d();
      count *= wider > 1 ? std::exp2(std::ceil(std::log2(wider))) : 1;
    }
    return std::max(count, 2.0);
  }

  [[nodiscard]] bool is_too_wide(const Part& part) const {
    if (failed(part) != nullptr) {
      return true;
    }
    for (std::size_t k = 0; k < width_.size(); ++k) {
      if (part.half[k] > width_[k] * Rational(most_growth)) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] Found look(const Part& part) const {
    const WorkingPrecision scope(bits);
    const auto open = [](const std::string& why) { return Found{Verdict::undecided(why), {}, true}; };
    const Known& near = known_[part.near];
    const auto middle = reach(near.s, near.proof.nodes, part.middle, most_halvings_of_way);
    if (!middle) {
      return open("Newton's method leads to no closed motion from there");
    }
    Found found = open("no polynomial goes near the closed motions");
    found.middle = prove_chain(question_at(part.middle), *middle, bits, 8 * bits);
    if (found.middle->verdict.truth != Truth::proved) {
      return open(found.middle->verdict.reason);
    }
    if (is_too_wide(part)) {
      found.existence = Verdict::undecided("wider than what is proved near it");
      found.looked = false;
      return found;
    }
    MachineQuestion question = question_at(part.middle);
    question.machines = numbers_.over(part);
    const Chain chain(question);
    const auto nodes = approximate_chains(chain, Chain(question_at(part.middle)), found.middle->nodes);
    if (!nodes) {
      return found;
    }
    std::vector<Known> known;
    for (const std::size_t i : part.known) {
      known.push_back({part.s_of(known_[i].s), known_[i].proof});
    }
    known.push_back({Values(part.middle.size()), *found.middle});
    const ChainProof proof = prove_chains(chain, *nodes, known);
    found.existence = proof.verdict;
    if (proof.verdict.truth == Truth::proved && effort_.with_state) {
      found.motions = judged(decided(question, proof));
    }
    if (!is_decided(found.motions.state)) {
      found.changes = chain.changes(*nodes);
    }
    return found;
  }

  // The datum with which most changes, of those that may still be halved.
  [[nodiscard]] std::optional<std::size_t> to_halve(const Part& part, const Found& found) const {
    const Tried * const same = found.looked ? nullptr : failed(part);
    if (same != nullptr && part.halvings[same->datum] < effort_.most_halvings) {
      return same->datum;
    }
    std::optional<std::size_t> best;
    double most = 0;
    for (std::size_t k = 0; k < part.half.size(); ++k) {
      const double size = !found.looked            ? Rational(part.half[k] / width_[k]).get_d()
                          : !found.changes.empty() ? found.changes[k]
                                                   : std::exp2(-part.halvings[k]);
      if (part.halvings[k] < effort_.most_halvings && (!best || size > most)) {
        best = k;
        most = size;
      }
    }
    return best;
  }

  // Both halves have the closed chain in the middle.
  void halve(const Part& part, std::size_t datum, const Found& found, std::vector<Part>& into) {
    auto [low, high] = part.halved(datum);
    if (found.middle) {
      known_.push_back({part.middle, *found.middle});
    }
    const bool is_whole = found.existence.truth == Truth::proved && found.middle;
    if (is_whole) {
      wholes_.push_back({found.motions, part.known, part.whole});
      wholes_.back().known.push_back(known_.size() - 1);
    }
    for (Part * half : {&low, &high}) {
      half->away = distance(*half);
      if (is_whole) {
        half->whole = wholes_.size() - 1;
      }
      std::erase_if(half->known, [&](std::size_t i) { return !half->contains(known_[i].s); });
      if (found.middle) {
        half->near = known_.size() - 1;
        half->known.push_back(half->near);
      }
      into.push_back(*half);
    }
  }

  // Parts of one family have a way from one to the other through closed chains that are known in both of two
  // on it. Those that have none to a given motion are what a whole is that has one; without, undecided.
  [[nodiscard]] std::vector<PartOfBox> joined() const {
    std::vector<std::size_t> family(known_.size());  // of each known one: the first one that it is joined to
    std::iota(family.begin(), family.end(), 0);
    const auto join = [&](const std::vector<std::size_t>& known) {
      std::vector<std::size_t> these;
      std::ranges::transform(known, std::back_inserter(these), [&](std::size_t k) { return family[k]; });
      for (std::size_t& one : family) {
        one = std::ranges::find(these, one) != these.end() ? std::ranges::min(these) : one;
      }
    };
    const auto is_itself_proved = [](const Found& found) {
      return found.existence.truth == Truth::proved && !found.is_of_whole;
    };
    for (const Whole& whole : wholes_) {
      join(whole.known);
    }
    for (const auto& [part, found] : done_) {
      if (is_itself_proved(found)) {
        join(part.known);
      }
    }
    const auto family_of = [&](const std::vector<std::size_t>& known) {
      return known.empty() || family[known.front()] >= given_ ? none : family[known.front()];
    };
    std::vector<PartOfBox> parts;
    for (const auto& [part, found] : done_) {
      const std::size_t own = is_itself_proved(found) ? family_of(part.known) : none;
      std::size_t whole = own == none ? part.whole : none;
      while (whole != none && family_of(wholes_[whole].known) == none) {
        whole = wholes_[whole].of;
      }
      const std::size_t data = part.middle.size();
      PartOfBox& one = parts.emplace_back(PartOfBox{part.at(Values(data, -1)), part.at(Values(data, 1)),
                                                    found.existence, found.motions, own});
      if (whole != none) {
        one.existence = Verdict::proved();
        one.motions = wholes_[whole].motions;
        one.family = family_of(wholes_[whole].known);
      } else if (found.existence.truth == Truth::proved && own == none) {
        one.existence =
            Verdict::undecided("no way through parts that are proved leads there from the motion");
        one.motions = {};
      }
    }
    return parts;
  }

  const DataBox& box_;
  NumbersInData numbers_;
  Effort effort_;
  long periods_;
  std::vector<Piece> pieces_;
  std::string why_;  // not
  Part whole_;
  std::vector<Known> known_;  // s being the values
  std::size_t given_ = 0;
  std::vector<Whole> wholes_;
  Values width_;  // half of that of the largest part that was proved
  std::map<std::vector<int>, Tried> tried_;
  std::vector<Done> done_;
  long looked_at_ = 0;
};

}  // namespace

std::vector<PartOfBox> motions_over(const DataBox& box, const std::vector<MotionAt>& motions,
                                    const Effort& effort) {
  const std::size_t data = box.low.size();
  for (const MotionAt& motion : motions) {
    for (std::size_t k = 0; k < data; ++k) {
      require(motion.values[k] >= box.low[k] && motion.values[k] <= box.high[k], "a motion's datum",
              motion.values[k],
              fmt::format("in the box, {} to {}", to_string(box.low[k]), to_string(box.high[k])));
    }
  }
  for (const MotionAt& motion : motions) {
    if (!std::ranges::equal(motion.guess.events, motions.front().guess.events, {},
                            &MachineGuess::Event::begins, &MachineGuess::Event::begins)) {
      return {{box.low, box.high, Verdict::undecided("the motions are not through the same phases"), {}}};
    }
  }
  return Search(box, motions, effort).run();
}

std::vector<Joint> joints_between(const std::function<Machine(const Rational&)>& at,
                                  const std::vector<MotionAt>& motions, std::optional<State> state) {
  constexpr int most_halvings_of_shortest = 12;
  constexpr long most_parts_at_all = 2048;
  const bool rises = motions.front().values < motions.back().values;
  const MotionAt &first = rises ? motions.front() : motions.back(),
                 &last = rises ? motions.back() : motions.front();
  const DataBox box{[&](const Values& values) { return at(values.front()); }, first.values, last.values};
  Rational shortest = last.values[0] - first.values[0];
  const Rational whole = shortest;
  for (std::size_t k = 0; k + 1 < motions.size(); ++k) {
    shortest = std::min(shortest, Rational(abs(Rational(motions[k + 1].values[0] - motions[k].values[0]))));
  }
  const int halvings = static_cast<int>(std::ceil(std::log2(Rational(whole / shortest).get_d())));
  const std::vector<PartOfBox> parts = motions_over(box, motions,
                                                    {.most_halvings = halvings + most_halvings_of_shortest,
                                                     .most_parts = most_parts_at_all,
                                                     .with_state = state.has_value()});
  std::vector<Joint> joints;
  for (std::size_t k = 0; k + 1 < motions.size(); ++k) {
    const auto [low, high] = std::minmax(motions[k].values[0], motions[k + 1].values[0]);
    Joint& joint = joints.emplace_back(Joint{Verdict::proved(), Verdict::proved()});
    std::optional<std::size_t> family;
    for (const PartOfBox& part : parts) {
      if (part.high[0] <= low || part.low[0] >= high || joint.existence.truth != Truth::proved) {
        continue;
      }
      if (part.existence.truth != Truth::proved) {
        joint = {part.existence, part.existence};
        continue;
      }
      if (part.family != family.value_or(part.family)) {
        const auto apart = Verdict::undecided("two parts have no closed motion in common that is known");
        joint = {apart, apart};
        continue;
      }
      family = part.family;
      if (!state || part.motions.state != *state) {
        joint.state = Verdict::undecided("a condition or the stability is not decided");
      }
    }
  }
  return joints;
}

}  // namespace stickslip::numeric::machines
