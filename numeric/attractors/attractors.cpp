#include "numeric/attractors/attractors.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/attractors/settle.hpp"
#include "numeric/attractors/starts.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/symmetric.hpp"
#include "numeric/machines/neighbourhood.hpp"
#include "numeric/simulation/agreement.hpp"
#include "numeric/words/growth.hpp"

namespace stickslip::numeric::attractors {

using namespace motion;
using families::NamedBall;
using model::Vector4;
using words::Guess;
using words::WordOrbit;

namespace {

// How near a motion comes to where it was before a proof is tried; nearer when the proof has said that the
// motion cannot stay there, but no nearer than rounding lets it.
constexpr double first_nearness = 1e-6;
constexpr double nearer = 1e-2;
constexpr double last_nearness = 1e-10;
// What a stable orbit needs at most; a motion that only seems to return is given up early.
constexpr long most_bits = 1024;
// Motions nearer to each other than this are on one orbit, if they go through one word in as many periods.
constexpr double same_orbit = 1e-3;

// Motions that return alike: one of them stands for all.
struct Group {
  Return seen;
  std::vector<std::size_t> members;  // which starts
  std::optional<WordOrbit> orbit;
};

bool same(const Return& a, const Return& b) {
  return a.guess.periods == b.guess.periods && a.word == b.word &&
         std::any_of(b.once.begin(), b.once.end(),
                     [&](const Vector4<double>& X) { return distance(a.once.front(), X) < same_orbit; });
}

bool overlap(const WordOrbit& a, const WordOrbit& b) {
  if (a.existence.truth != Truth::proved || b.existence.truth != Truth::proved || a.word != b.word ||
      a.periods != b.periods) {
    return false;
  }
  return std::all_of(a.orbit.values.begin(), a.orbit.values.end(),
                     [&](const NamedBall& value) { return value.value.overlaps(b.orbit.value(value.name)); });
}

// Whether the proved orbit is where the motion was seen.
bool is_there(const WordOrbit& found, const Return& seen) {
  const families::Orbit& o = found.orbit;
  const Vector4<double> begin(o.value("x10").approximate(), o.value("x20").approximate(),
                              o.value("xdot10").approximate(), 0);
  return std::any_of(seen.guess.events.begin(), seen.guess.events.end(), [&](const Guess::Event& e) {
    return distance({e.x1, e.x2, e.xdot1, 0}, begin) < same_orbit;
  });
}

double spectral_radius(const motion::Stability& stability) {
  double largest = 0;
  for (const ComplexBall& mu : stability.multipliers) {
    largest = std::max(largest, Ball(sqrt(mu.squared_modulus())).approximate());
  }
  return largest;
}

bool is_stable(const WordOrbit& found) {
  return found.existence.truth == Truth::proved && found.orbit.admissible.truth == Truth::proved &&
         found.orbit.stability->kind == StabilityKind::stable;
}

bool attracts(const Group& group) {
  return group.orbit && is_stable(*group.orbit) && is_there(*group.orbit, group.seen);
}

// A motion that comes back after fewer periods, too, through a part of its word: as a proof would have it.
Return shortest(Return seen) {
  const auto n = static_cast<std::size_t>(seen.guess.periods);
  for (std::size_t d = 1; d < n; ++d) {
    const std::string part = seen.word.substr(0, seen.word.size() * d / n);
    std::string repeated;
    for (std::size_t k = 0; k < n / d; ++k) {
      repeated += part;
    }
    if (n % d == 0 && repeated == seen.word && distance(seen.once[0], seen.once[d]) < same_orbit) {
      seen.once.resize(d);
      seen.word = part;
      seen.guess.periods = static_cast<long>(d);
      seen.guess.events.resize(part.size());
      return seen;
    }
  }
  return seen;
}

// The proofs of words make use of (7), the response to the load.
WordOrbit unproved_at_resonance(const Return& seen) {
  return {words::Word::parse(seen.word),
          seen.guess.periods,
          Verdict::undecided("$omega$ is a natural frequency, where (7) has a pole"),
          {},
          {}};
}

class Survey {
 public:
  Survey(const AttractorQuestion& question, const std::vector<Vector4<double>>& starts)
      : question_(question) {
    question_.starts = static_cast<long>(starts.size());
    question_.machine.most_bits = std::max(most_bits, 2 * scalars::bits_for(question.machine.digits));
    const auto data = parameters_as<double>(question.machine.data);
    const double ur = scalars::scalar<double>(question.machine.ur);
    for (const Vector4<double>& X : starts) {
      followers_.emplace_back(data, ur, X);
      open_.push_back(open_.size());
    }
  }

  void run() {
    for (double nearness = first_nearness; !open_.empty() && !interrupted();
         nearness = std::max(nearer * nearness, last_nearness)) {
      follow(nearness);
      prove();
    }
    place_what_nears();
    (void)parallel_map(followers_.size(), [&](std::size_t i) {
      if (!interrupted() && !is_placed(i)) {
        followers_[i].classify(question_.most_periods / 4);
      }
      return true;
    });
  }

  [[nodiscard]] AttractorList result() const;

 private:
  void follow(double nearness) {
    (void)parallel_map(open_.size(), [&](std::size_t i) {
      if (!interrupted()) {
        followers_[open_[i]].follow(question_.most_periods, nearness);
      }
      return true;
    });
  }

  // Motions that return are put together, each sort is proved, and those that cannot stay where they are are
  // open again.
  void prove();
  // Joins the group to the one of the same orbit.
  void add(const Group& group);
  // Motions that have not settled in their time, but go through the word of a proved stable orbit and come
  // nearer and nearer to it.
  void place_what_nears();
  [[nodiscard]] bool is_placed(std::size_t i) const {
    return std::ranges::any_of(groups_, [&](const Group& group) {
      return std::ranges::find(group.members, i) != group.members.end();
    });
  }
  // Motions that seem to return where no orbit is proved to hold them are followed on. At the end of their
  // time those have not settled whose orbit is proved not to hold them; the others are what is returned.
  [[nodiscard]] std::vector<std::size_t> left_after_sending_on(const Group& group);

  AttractorQuestion question_;
  std::vector<Follower> followers_;
  std::vector<std::size_t> open_;
  std::vector<Group> groups_;
};

std::vector<std::size_t> Survey::left_after_sending_on(const Group& group) {
  const bool unproved = !group.orbit || group.orbit->existence.truth != Truth::proved;
  std::vector<std::size_t> left;
  for (const std::size_t i : group.members) {
    if (2 * followers_[i].periods() < question_.most_periods) {
      open_.push_back(i);
    } else if (unproved) {
      left.push_back(i);
    } else {
      followers_[i].reject();
    }
  }
  return left;
}

void Survey::prove() {
  const bool resonant = is_resonant(question_.machine.data);
  const auto seen = parallel_map(open_.size(), [&](std::size_t i) {
    const std::optional<Return> one = followers_[open_[i]].returned();
    return one && resonant ? std::optional(shortest(*one)) : one;
  });
  std::vector<Group> fresh;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    if (!seen[i]) {
      continue;
    }
    const auto is_it = [&](const Group& group) { return same(*seen[i], group.seen); };
    auto known = std::find_if(groups_.begin(), groups_.end(), is_it);
    if (known == groups_.end()) {
      known = std::find_if(fresh.begin(), fresh.end(), is_it);
      if (known == fresh.end()) {
        fresh.push_back({*seen[i], {}, {}});
        known = fresh.end() - 1;
      }
    }
    known->members.push_back(open_[i]);
  }
  const bool provable = words::in_word_domain(question_.machine) && !interrupted();
  const auto orbits = parallel_map(fresh.size(), [&](std::size_t i) {
    return provable   ? std::optional(prove_word_orbit(question_.machine, fresh[i].seen.guess))
           : resonant ? std::optional(unproved_at_resonance(fresh[i].seen))
                      : std::nullopt;
  });
  open_.clear();
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    fresh[i].orbit = orbits[i];
    if (provable && !attracts(fresh[i])) {
      fresh[i].members = left_after_sending_on(fresh[i]);
    }
    if (fresh[i].members.empty()) {
      continue;
    }
    add(fresh[i]);
  }
}

void Survey::add(const Group& group) {
  const auto known = std::find_if(groups_.begin(), groups_.end(), [&](const Group& one) {
    return one.orbit && group.orbit && overlap(*one.orbit, *group.orbit);
  });
  if (known == groups_.end()) {
    groups_.push_back(group);
  } else {
    known->members.insert(known->members.end(), group.members.begin(), group.members.end());
  }
}

void Survey::place_what_nears() {
  if (!words::in_word_domain(question_.machine) || interrupted()) {
    return;
  }
  std::vector<std::size_t> slow;
  for (std::size_t i = 0; i < followers_.size(); ++i) {
    if (followers_[i].kind() == Kind::unsettled && !followers_[i].is_too_slow() && !is_placed(i)) {
      slow.push_back(i);
    }
  }
  const std::vector<std::optional<Return>> seen =
      parallel_map(slow.size(), [&](std::size_t i) { return steady_word(followers_[slow[i]].simulation()); });
  std::map<std::pair<std::string, long>, Group> of_word;  // one proof for all motions of a word
  for (const std::optional<Return>& one : seen) {
    if (one && !of_word.contains({one->word, one->guess.periods})) {
      of_word[{one->word, one->guess.periods}] = {*one, {}, prove_word_orbit(question_.machine, one->guess)};
    }
  }
  const auto on_its_way = parallel_map(slow.size(), [&](std::size_t i) {
    if (!seen[i] || interrupted()) {
      return false;
    }
    const WordOrbit& found = *of_word.at({seen[i]->word, seen[i]->guess.periods}).orbit;
    return is_stable(found) && found.word.letters() == seen[i]->word &&
           found.periods == seen[i]->guess.periods &&
           nears(followers_[slow[i]].simulation(), at_phase_0(simulation::start_of(found.orbit)),
                 spectral_radius(*found.orbit.stability), found.periods, question_.most_periods / 4);
  });
  for (std::size_t i = 0; i < slow.size(); ++i) {
    if (on_its_way[i]) {
      of_word.at({seen[i]->word, seen[i]->guess.periods}).members.push_back(slow[i]);
    }
  }
  for (auto& [word, group] : of_word) {
    if (!group.members.empty()) {
      group.seen.once.front() = at_phase_0(simulation::start_of(group.orbit->orbit));
      add(group);
    }
  }
}

Attractor periodic(const Group& group) {
  Attractor a;
  a.kind = Kind::periodic;
  a.members = group.members;
  a.count = static_cast<long>(group.members.size());
  a.orbit = group.orbit;
  const bool proved = group.orbit && group.orbit->existence.truth == Truth::proved;
  a.word = proved ? group.orbit->word.letters() : group.seen.word;
  a.periods = proved ? group.orbit->periods : group.seen.guess.periods;
  a.family = proved ? family_of(*group.orbit) : "";
  a.state = group.seen.once.front();
  return a;
}

AttractorList Survey::result() const {
  AttractorList list{question_, {}, 0, interrupted(), 0};
  std::vector<bool> placed(followers_.size());
  for (const Group& group : groups_) {
    list.attractors.push_back(periodic(group));
    for (const std::size_t i : group.members) {
      placed[i] = true;
    }
  }
  std::map<Kind, Attractor> others;
  for (std::size_t i = 0; i < followers_.size(); ++i) {
    const Follower& follower = followers_[i];
    list.simulated += follower.periods();
    if (!placed[i] && !follower.is_followed(question_.most_periods)) {
      continue;  // interrupted
    }
    ++list.followed;
    if (placed[i]) {
      continue;
    }
    // A return that no proof was tried for: interrupted, or no word. At resonance what slips goes on to grow
    // until it meets the belt.
    const bool goes_on = follower.kind() == Kind::periodic ||
                         (follower.kind() == Kind::slides && is_resonant(question_.machine.data));
    const Kind kind = goes_on ? Kind::unsettled : follower.kind();
    Attractor& a = others[kind];
    a.kind = kind;
    a.state = a.count == 0 ? follower.simulation().state() : a.state;
    if (follower.lyapunov()) {
      a.lyapunov = (a.lyapunov.value_or(0) * static_cast<double>(a.count) + *follower.lyapunov()) /
                   static_cast<double>(a.count + 1);
    }
    a.members.push_back(i);
    a.is_too_slow = a.is_too_slow || follower.is_too_slow();
    ++a.count;
  }
  for (const auto& [kind, attractor] : others) {
    list.attractors.push_back(attractor);
  }
  for (Attractor& a : list.attractors) {
    const Interval interval = wilson(a.count, list.followed);
    a.share = static_cast<double>(a.count) / static_cast<double>(list.followed);
    a.least = interval.least;
    a.most = interval.most;
  }
  std::stable_sort(list.attractors.begin(), list.attractors.end(),
                   [](const Attractor& a, const Attractor& b) { return a.count > b.count; });
  return list;
}

// Every motion grows beyond all bounds: none is simulated. The state is where the first one starts.
AttractorList all_grow(const AttractorQuestion& question, const std::vector<Vector4<double>>& starts) {
  AttractorList list{question, {Attractor{}}, 0, false, static_cast<long>(starts.size())};
  list.question.starts = list.followed;
  Attractor& all = list.attractors.front();
  all.kind = Kind::grows;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    all.members.push_back(i);
  }
  all.count = list.followed;
  all.share = all.least = all.most = 1;
  all.state = starts.front();
  return list;
}

// Z(tau) = E Z(0), (13), as far as the balls tell.
bool may_be_symmetric(const Motion& m) {
  const model::Vector4<Ball>& Z = m.phases[0].Z;
  const model::Vector4<Ball>& later = m.phases[1].Z;
  return later(0).overlaps(-Z(0)) && later(1).overlaps(-Z(1)) && later(2).overlaps(Z(2));
}

}  // namespace

std::string to_string(Kind kind) {
  switch (kind) {
    case Kind::periodic:
      return "periodic";
    case Kind::quasi_periodic:
      return "quasi-periodic";
    case Kind::irregular:
      return "irregular";
    case Kind::slides:
      return "slides";
    case Kind::stuck:
      return "stuck";
    case Kind::grows:
      return "grows without bound";
    case Kind::unsettled:
      return "unsettled";
  }
  throw InternalError("an attractor of no known kind");
}

Interval wilson(long count, long total) {
  constexpr double z = 1.959963984540054;  // the quantile of 97.5 % of the normal distribution
  const auto n = static_cast<double>(total);
  const double share = static_cast<double>(count) / n;
  const double middle = (share + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  // Nothing but rounding keeps the ends of the certain shares from being exact.
  return {count == 0 ? 0 : middle - half, count == total ? 1 : middle + half};
}

std::string family_of(const WordOrbit& orbit) {
  if (orbit.periods != 1 || orbit.existence.truth != Truth::proved) {
    return "";
  }
  const std::string& word = orbit.word.letters();
  if (word == "OTS") {
    return families::overshooting().name;
  }
  if (word == "OS") {
    return families::nonsticking().name;
  }
  return word == "ST" && may_be_symmetric(orbit.orbit.motion) ? families::symmetric().name : "";
}

AttractorList find_attractors_from(const AttractorQuestion& question,
                                   const std::vector<Vector4<double>>& starts) {
  motion::require_model_domain(question.machine.data);
  if (words::growth(question.machine.data, question.machine.ur).truth == Truth::proved) {
    return all_grow(question, starts);
  }
  words::require_simulated_domain(question.machine);
  Survey survey(question, starts);
  survey.run();
  return survey.result();
}

AttractorList find_attractors(const AttractorQuestion& question) {
  AttractorList list =
      find_attractors_from(question, random_starts(parameters_as<double>(question.machine.data),
                                                   static_cast<std::size_t>(question.starts), question.seed));
  for (Attractor& a : list.attractors) {
    if (question.neighbourhood && a.orbit) {
      surround(*a.orbit, question.machine);
    }
  }
  return list;
}

void surround(WordOrbit& orbit, const words::WordQuestion& machine) {
  if (families::is_stable(orbit.orbit) && !interrupted()) {
    orbit.orbit.neighbourhood = std::make_shared<machines::Neighbourhood>(
        machines::neighbourhood_of(machine, orbit.orbit, orbit.periods));
  }
}

Attractor find_attractor(const words::WordQuestion& machine, const Vector4<double>& X, long most_periods) {
  const AttractorQuestion question{machine, 1, 0, most_periods};
  if (words::growth(machine.data, machine.ur).truth == Truth::proved) {
    return all_grow(question, {X}).attractors.front();
  }
  Survey survey(question, {X});
  survey.run();
  return survey.result().attractors.front();
}

}  // namespace stickslip::numeric::attractors
