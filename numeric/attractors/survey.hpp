// What many starts end on, of any oscillator: each motion is followed, those that return are put together and
// each sort is proved, and whose orbit does not hold it is followed on.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/attractors/follower.hpp"
#include "numeric/motion/stability.hpp"

namespace stickslip::numeric::attractors {

// How near a motion comes to where it was before a proof is tried; nearer when the proof has said that the
// motion cannot stay there, but no nearer than rounding lets it.
inline constexpr double first_nearness = 1e-6;
inline constexpr double nearer = 1e-2;
inline constexpr double last_nearness = 1e-10;
// What a stable orbit needs at most; a motion that only seems to return is given up early.
inline constexpr long most_bits_of_stable = 1024;
// Motions nearer to each other than this are on one orbit, if they go through one word in as many periods.
inline constexpr double same_orbit = 1e-3;

// `Proofs` says what is proved of the oscillator:
//   Attractor                        an Ending with `orbit`, `state` and what else is known
//   Omega()                          for distances (follower.hpp)
//   provable()                       whether orbits can be proved at all
//   tidied(seen)                     the return as it is to be proved
//   prove(seen)                      the orbit near it; nothing where no verdict on it is to be had
//   judged(orbit), word(orbit)       what has its `admissible` and `stability`; its letters
//   begins_at(orbit), at_phase_0(orbit)   states on it: where its first phase begins, and with the load there
//   overlap(one, other)              whether two proved orbits may be one
//   completed(attractor)             with what else is known of it
//   kind(seen)                       of what seems to do this, and is on no orbit
template <class Proofs>
class Survey {
 public:
  using Attractor = typename Proofs::Attractor;
  using Orbit = typename decltype(Attractor::orbit)::value_type;

  Survey(const Proofs& proofs, long most_periods, std::vector<std::unique_ptr<AnyFollower>> followers)
      : proofs_(proofs), most_periods_(most_periods), followers_(std::move(followers)) {
    for (std::size_t i = 0; i < followers_.size(); ++i) {
      open_.push_back(i);
    }
  }

  [[nodiscard]] Endings<Attractor> endings() {
    for (double nearness = first_nearness; !open_.empty() && !interrupted();
         nearness = std::max(nearer * nearness, last_nearness)) {
      (void)parallel_map(open_.size(), [&](std::size_t i) {
        if (!interrupted()) {
          followers_[open_[i]]->follow(most_periods_, nearness);
        }
        return true;
      });
      prove();
    }
    place_what_nears();
    (void)parallel_map(followers_.size(), [&](std::size_t i) {
      if (!interrupted() && !is_placed(i)) {
        followers_[i]->classify(most_periods_ / 4);
      }
      return true;
    });
    return result();
  }

 private:
  // Motions that return alike: one of them stands for all.
  struct Group {
    Return seen;
    std::vector<std::size_t> members;  // which starts
    std::optional<Orbit> orbit;
  };

  [[nodiscard]] bool near(const Eigen::VectorXd& X, const Eigen::VectorXd& Y) const {
    return distance(X, Y, proofs_.Omega()) < same_orbit;
  }
  [[nodiscard]] bool same(const Return& a, const Return& b) const {
    return a.guess.periods == b.guess.periods && a.guess.events.size() == b.guess.events.size() &&
           a.word == b.word &&
           std::ranges::any_of(b.once, [&](const auto& X) { return near(a.once.front(), X); });
  }
  [[nodiscard]] static bool exists(const Group& group) {
    return group.orbit && group.orbit->existence.truth == Truth::proved;
  }
  // That it exists and obeys the law, and that all that begins near it ends on it.
  [[nodiscard]] Truth is_stable(const Orbit& orbit) const {
    const auto& judged = proofs_.judged(orbit);
    if (orbit.existence.truth != Truth::proved || judged.admissible.truth != Truth::proved) {
      return orbit.existence.truth != Truth::proved ? Truth::undecided : judged.admissible.truth;
    }
    const auto kind = judged.stability ? judged.stability->kind : motion::StabilityKind::undecided;
    return kind == motion::StabilityKind::stable     ? Truth::proved
           : kind == motion::StabilityKind::unstable ? Truth::refuted
                                                     : Truth::undecided;
  }
  // And that the motion was seen there.
  [[nodiscard]] Truth attracts(const Group& group) const {
    if (!exists(group)) {
      return Truth::undecided;
    }
    const bool is_there = std::ranges::any_of(group.seen.guess.events, [&](const auto& event) {
      return near(event.X, proofs_.begins_at(*group.orbit));
    });
    return is_there ? is_stable(*group.orbit) : Truth::refuted;
  }

  [[nodiscard]] static double spectral_radius(const motion::Stability& stability) {
    double largest = 0;
    for (const motion::ComplexBall& mu : stability.multipliers) {
      largest = std::max(largest, Ball(sqrt(mu.squared_modulus())).approximate());
    }
    return largest;
  }

  // Motions that return are put together, each sort is proved, and those that cannot stay where they are are
  // open again.
  void prove() {
    const auto seen = parallel_map(open_.size(), [&](std::size_t i) {
      const std::optional<Return> one = followers_[open_[i]]->returned();
      return one ? std::optional(proofs_.tidied(*one)) : std::nullopt;
    });
    std::vector<Group> fresh;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (!seen[i]) {
        continue;
      }
      const auto is_it = [&](const Group& group) { return same(*seen[i], group.seen); };
      auto known = std::ranges::find_if(groups_, is_it);
      if (known == groups_.end()) {
        known = std::ranges::find_if(fresh, is_it);
        if (known == fresh.end()) {
          fresh.push_back({*seen[i], {}, {}});
          known = fresh.end() - 1;
        }
      }
      known->members.push_back(open_[i]);
    }
    const bool stopped = interrupted();
    const auto orbits = parallel_map(fresh.size(), [&](std::size_t i) -> std::optional<Orbit> {
      return stopped && proofs_.provable() ? std::nullopt : proofs_.prove(fresh[i].seen);
    });
    open_.clear();
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      fresh[i].orbit = orbits[i];
      if (proofs_.provable() && !stopped && attracts(fresh[i]) != Truth::proved) {
        fresh[i].members = left_after_sending_on(fresh[i]);
      }
      if (!fresh[i].members.empty()) {
        add(fresh[i]);
      }
    }
  }
  // Joins the group to the one of the same orbit.
  void add(const Group& group) {
    const auto known = std::ranges::find_if(groups_, [&](const Group& one) {
      return exists(one) && exists(group) && proofs_.overlap(*one.orbit, *group.orbit);
    });
    if (known == groups_.end()) {
      groups_.push_back(group);
    } else {
      known->members.insert(known->members.end(), group.members.begin(), group.members.end());
    }
  }
  // Motions that have not settled in their time, but go through the word of a proved stable orbit and come
  // nearer and nearer to it.
  void place_what_nears() {
    if (!proofs_.provable() || interrupted()) {
      return;
    }
    std::vector<std::size_t> slow;
    for (std::size_t i = 0; i < followers_.size(); ++i) {
      if (followers_[i]->kind() == Kind::unsettled && !followers_[i]->is_too_slow() && !is_placed(i)) {
        slow.push_back(i);
      }
    }
    const std::vector<std::optional<Return>> seen =
        parallel_map(slow.size(), [&](std::size_t i) { return followers_[slow[i]]->steady_word(); });
    std::map<std::pair<std::string, long>, Group> of_word;  // one proof for all motions of a word
    for (const std::optional<Return>& one : seen) {
      if (one && !of_word.contains({one->word, one->guess.periods})) {
        of_word[{one->word, one->guess.periods}] = {*one, {}, proofs_.prove(proofs_.tidied(*one))};
      }
    }
    const auto on_its_way = parallel_map(slow.size(), [&](std::size_t i) {
      if (!seen[i] || interrupted()) {
        return false;
      }
      const Orbit& found = *of_word.at({seen[i]->word, seen[i]->guess.periods}).orbit;
      return is_stable(found) == Truth::proved && found.periods == seen[i]->guess.periods &&
             proofs_.word(found) == seen[i]->word &&
             followers_[slow[i]]->nears(proofs_.at_phase_0(found),
                                        spectral_radius(*proofs_.judged(found).stability), found.periods,
                                        most_periods_ / 4);
    });
    for (std::size_t i = 0; i < slow.size(); ++i) {
      if (on_its_way[i]) {
        of_word.at({seen[i]->word, seen[i]->guess.periods}).members.push_back(slow[i]);
      }
    }
    for (auto& [word, group] : of_word) {
      if (!group.members.empty()) {
        group.seen.once.front() = proofs_.at_phase_0(*group.orbit);
        add(group);
      }
    }
  }
  [[nodiscard]] bool is_placed(std::size_t i) const {
    return std::ranges::any_of(groups_, [&](const Group& group) {
      return std::ranges::find(group.members, i) != group.members.end();
    });
  }
  // Motions that seem to return where no orbit is proved to hold them are followed on. At the end of their
  // time those have not settled whose orbit is proved not to hold them; the others are what is returned.
  [[nodiscard]] std::vector<std::size_t> left_after_sending_on(const Group& group) {
    std::vector<std::size_t> left;
    for (const std::size_t i : group.members) {
      if (2 * followers_[i]->periods() < most_periods_) {
        open_.push_back(i);
      } else if (attracts(group) != Truth::refuted) {
        left.push_back(i);
      } else {
        followers_[i]->reject();
      }
    }
    return left;
  }
  [[nodiscard]] Endings<Attractor> result() const {
    Endings<Attractor> all{{}, 0, interrupted(), 0};
    for (const Group& group : groups_) {
      Attractor a;
      a.kind = Kind::periodic;
      a.members = group.members;
      a.count = static_cast<long>(group.members.size());
      a.word = exists(group) ? proofs_.word(*group.orbit) : group.seen.word;
      a.periods = exists(group) ? group.orbit->periods : group.seen.guess.periods;
      a.orbit = group.orbit;
      a.state = group.seen.once.front();
      all.attractors.push_back(proofs_.completed(std::move(a)));
    }
    std::map<Kind, Attractor> others;
    for (std::size_t i = 0; i < followers_.size(); ++i) {
      const AnyFollower& follower = *followers_[i];
      all.simulated += follower.periods();
      const bool placed = is_placed(i);
      all.followed += placed || follower.is_followed(most_periods_) ? 1 : 0;  // else interrupted
      if (placed || !follower.is_followed(most_periods_)) {
        continue;
      }
      const Kind kind = proofs_.kind(follower.kind());
      Attractor& a = others[kind];
      a.kind = kind;
      a.state = a.count == 0 ? follower.state() : Eigen::VectorXd(a.state);
      if (follower.lyapunov()) {
        a.lyapunov = (a.lyapunov.value_or(0) * static_cast<double>(a.count) + *follower.lyapunov()) /
                     static_cast<double>(a.count + 1);
      }
      a.members.push_back(i);
      a.is_too_slow = a.is_too_slow || follower.is_too_slow();
      ++a.count;
    }
    for (const auto& [kind, attractor] : others) {
      all.attractors.push_back(attractor);
    }
    for (Attractor& a : all.attractors) {
      const Interval interval = wilson(a.count, all.followed);
      a.share = static_cast<double>(a.count) / static_cast<double>(all.followed);
      a.least = interval.least;
      a.most = interval.most;
    }
    std::ranges::stable_sort(all.attractors,
                             [](const Attractor& a, const Attractor& b) { return a.count > b.count; });
    return all;
  }

  Proofs proofs_;
  long most_periods_;
  std::vector<std::unique_ptr<AnyFollower>> followers_;
  std::vector<std::size_t> open_;
  std::vector<Group> groups_;
};

}  // namespace stickslip::numeric::attractors
