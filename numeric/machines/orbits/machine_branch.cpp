#include "numeric/machines/orbits/machine_branch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/parallel.hpp"

namespace stickslip::numeric::machines {

using branches::ChangeKind;
using branches::End;
using branches::State;
using motion::Condition;
using motion::StabilityKind;

namespace {

// Steps are powers of two in parts of the interval: values stay short numbers.
constexpr int longest_step = 7;
constexpr int shortest_step = 30;
constexpr std::size_t most_samples = 5000;
// At a fold the branch is a parabola through three motions at least so far from it, and from each other, as
// powers of two in parts of the interval.
constexpr std::array fold_distances{16, 19};
constexpr int most_folds = 8;

std::string violated(const MachineOrbit& orbit) {
  const auto found = std::ranges::find_if(
      orbit.conditions, [](const Condition& c) { return c.verdict.truth == Truth::refuted; });
  return found == orbit.conditions.end() ? "" : found->id;
}

// The load's frequency, per time.
double frequency(const Machine& machine) {
  return machine.oscillator.is_autonomous() ? 1 : oscillator_as<double>(machine).omega;
}

// b + share (b - a), with times in units of the load's.
MachineGuess beyond(const MachineGuess& a, double omega_a, const MachineGuess& b, double omega_b,
                    double share, double omega) {
  MachineGuess guess = b;
  const auto time = [&](double before, double now) {
    return (now * omega_b + share * (now * omega_b - before * omega_a)) / omega;
  };
  for (std::size_t i = 0; i < guess.events.size(); ++i) {
    guess.events[i].t = time(a.events[i].t, b.events[i].t);
    guess.events[i].X += share * (b.events[i].X - a.events[i].X);
  }
  guess.duration = time(a.duration, b.duration);
  return guess;
}

// f of each number of a guess.
template <class Guess, class F>
void for_numbers_of(Guess& guess, const F& f) {
  f(guess.duration);
  for (auto& event : guess.events) {
    f(event.t);
    std::for_each(event.X.begin(), event.X.end(), f);
  }
}

bool is_fold(const MachineSample& a, const MachineSample& b) {
  return (a.before_fold && b.after_fold) || (a.after_fold && b.before_fold);
}

class Walk {
 public:
  Walk(const MachineBranchQuestion& question, const MachineSample& start)
      : q_(question), unit_(q_.to - q_.from), start_(start) {}

  struct Way {
    std::vector<MachineSample> samples;  // from the start, which is the first
    MachineBranchEnd end;
  };

  // Upwards (1) or downwards (-1) at first.
  [[nodiscard]] Way follow(int direction) const {
    Way way{{start_}, {}};
    std::vector<MachineSample>& all = way.samples;
    std::size_t since_fold = 0;  // the first sample after the last one
    int folds = 0, step = longest_step, successes = 0;
    const auto ended = [&](End kind, const std::string& words) {
      way.end = {all.back().value, kind, words};
      return way;
    };
    while (true) {
      const MachineSample& here = all.back();
      const Rational& limit = direction > 0 ? q_.to : q_.from;
      if (here.value == limit) {
        return ended(End::interval, "the end of the interval");
      }
      if (here.state == State::absent) {
        return ended(End::absent, "a phase lasts no time, and a negative one beyond");
      }
      if (interrupted() || all.size() >= most_samples) {
        return ended(End::stopped, interrupted() ? "interrupted" : "more values are needed than are allowed");
      }
      Rational next = here.value + direction * unit_ / (1L << step);
      next = direction > 0 ? std::min(next, limit) : std::max(next, limit);
      // Round a fold it may come back to where it began.
      const bool passes =
          folds > 0 && (start_.value - here.value) * (start_.value - next) <= 0 && start_.value != here.value;
      next = passes ? start_.value : next;
      if (const auto found = sample(next, all.size() > since_fold + 1 ? all[all.size() - 2] : here, here)) {
        all.push_back(*found);
        if (passes && is_same(found->orbit, start_.orbit)) {
          return ended(End::closed, "where it began");
        }
        if (++successes >= 2 && step > longest_step) {
          --step;
          successes = 0;
        }
        continue;
      }
      successes = 0;
      if (++step <= shortest_step) {
        continue;
      }
      const auto beyond_fold =
          folds < most_folds ? turned({all.begin() + static_cast<std::ptrdiff_t>(since_fold), all.end()})
                             : std::nullopt;
      if (!beyond_fold) {
        return ended(End::stopped, why_no_further(here));
      }
      // Beyond, it is what it was, begun later: at this end that is no other motion.
      const auto before = std::ranges::find(all, beyond_fold->value, &MachineSample::value);
      if (before != all.end() && is_same_begun_later(before->orbit, beyond_fold->orbit)) {
        return ended(End::absent, "a shorter motion taken several times, whose period multiplies there");
      }
      all.back().before_fold = true;
      all.push_back(*beyond_fold);
      since_fold = all.size() - 1;
      direction = -direction;
      step = fold_distances[1];
      ++folds;
    }
  }

  // Samples between two that differ, until they are close, in their order, without these two.
  [[nodiscard]] std::vector<MachineSample> between(MachineSample a, MachineSample b) const {
    std::vector<MachineSample> found;
    if (is_fold(a, b)) {
      return found;
    }
    const bool rises = a.value < b.value;
    while (a.state != b.state && abs(b.value - a.value) > unit_ * Rational(branch_resolution) &&
           !interrupted()) {
      const std::optional<MachineSample> m = sample((a.value + b.value) / 2, a, b);
      if (!m) {
        break;
      }
      found.push_back(*m);
      (m->state == a.state ? a : b) = *m;
    }
    std::ranges::sort(found, [rises](const MachineSample& one, const MachineSample& other) {
      return rises ? one.value < other.value : other.value < one.value;
    });
    return found;
  }

 private:
  // The motion at the value, near where it is expected by two others.
  [[nodiscard]] std::optional<MachineSample> sample(const Rational& value, const MachineSample& a,
                                                    const MachineSample& b) const {
    const Machine machine = q_.at(value), at_a = q_.at(a.value), at_b = q_.at(b.value);
    const double share = a.value == b.value ? 0 : Rational((value - b.value) / (b.value - a.value)).get_d();
    const MachineGuess guess = beyond(guess_of(a.orbit, at_a), frequency(at_a), guess_of(b.orbit, at_b),
                                      frequency(at_b), share, frequency(machine));
    return proved_near(value, machine, guess);
  }
  [[nodiscard]] std::optional<MachineSample> proved_near(const Rational& value, const Machine& machine,
                                                         const MachineGuess& guess) const {
    const MachineOrbit orbit = prove_machine_orbit(machine, guess, q_.digits);
    if (orbit.existence.truth != Truth::proved || distance(guess_of(orbit, machine), guess) > most_astray) {
      return std::nullopt;
    }
    return MachineSample{value, state_of(orbit), orbit};
  }
  // The motion at an earlier value of these, on the other side of the fold that they approach: the value and
  // all numbers of the motion are parabolas in that number which changes most.
  [[nodiscard]] std::optional<MachineSample> turned(const std::vector<MachineSample>& before) const {
    std::array<const MachineSample *, 3> three{&before.back(), nullptr, nullptr};
    for (std::size_t i = 0; i < fold_distances.size(); ++i) {
      for (const MachineSample& s : before) {
        if (abs(s.value - before.back().value) >= unit_ / (1L << fold_distances.at(i))) {
          three.at(2 - i) = &s;
        }
      }
      if (three.at(2 - i) == nullptr) {
        return std::nullopt;
      }
    }
    std::array<std::vector<double>, 3> y;
    std::size_t k = 0;  // of the number that changes most
    for (std::size_t i = 0; i < 3; ++i) {
      const MachineGuess guess = guess_of(three.at(i)->orbit, q_.at(three.at(i)->value));
      for_numbers_of(guess, [&](double x) { y.at(i).push_back(x); });
    }
    const auto change = [&](std::size_t i) {
      return std::abs(y[2][i] - y[0][i]) / (std::abs(y[0][i]) + 1e-9);
    };
    for (std::size_t i = 1; i < y[0].size(); ++i) {
      k = change(i) > change(k) ? i : k;
    }
    const std::array<double, 3> x{y[0][k], y[1][k], y[2][k]};
    const auto datum = [&](std::size_t i) {
      return Rational(three.at(i)->value - before.back().value).get_d();
    };
    // The value is a parabola with the vertex at the fold; the same value is taken as far beyond it.
    const double slope01 = (datum(1) - datum(0)) / (x[1] - x[0]),
                 slope12 = (datum(2) - datum(1)) / (x[2] - x[1]);
    const double curvature = (slope12 - slope01) / (x[2] - x[0]);
    const double fold = (x[0] + x[1]) / 2 - slope01 / (2 * curvature);
    const double place = 2 * fold - x[2];
    const double l0 = (place - x[1]) * (place - x[2]) / ((x[0] - x[1]) * (x[0] - x[2]));
    const double l1 = (place - x[0]) * (place - x[2]) / ((x[1] - x[0]) * (x[1] - x[2]));
    const Machine machine = q_.at(three[2]->value);
    MachineGuess guess = guess_of(three[2]->orbit, machine);
    std::size_t number = 0;
    bool finite = true;
    for_numbers_of(guess, [&](double& one) {
      one = y[0][number] * l0 + y[1][number] * l1 + y[2][number] * (1 - l0 - l1);
      finite = finite && std::isfinite(one);
      ++number;
    });
    if (!finite || !(std::abs(fold - x[0]) < std::abs(x[0] - x[2]) / 2)) {
      return std::nullopt;
    }
    std::optional<MachineSample> found = proved_near(three[2]->value, machine, guess);
    if (!found || is_same(found->orbit, three[2]->orbit)) {
      return std::nullopt;
    }
    found->after_fold = true;
    return found;
  }

  // As far as their durations tell; `shift`: begun with so many phases later.
  [[nodiscard]] static bool is_same(const MachineOrbit& a, const MachineOrbit& b, std::size_t shift = 0) {
    for (std::size_t i = 0; i < a.phases.size(); ++i) {
      const MachinePhase& other = b.phases[(i + shift) % b.phases.size()];
      if (a.phases[i].piece != other.piece || !a.phases[i].duration.overlaps(other.duration)) {
        return false;
      }
    }
    return true;
  }
  [[nodiscard]] static bool is_same_begun_later(const MachineOrbit& a, const MachineOrbit& b) {
    for (std::size_t shift = 1; shift < a.phases.size(); ++shift) {
      if (is_same(a, b, shift)) {
        return true;
      }
    }
    return false;
  }

  // With the multiplier nearest to 1, which a fold has.
  [[nodiscard]] static std::string why_no_further(const MachineSample& here) {
    std::string text = "no further step was possible: the branch may turn here";
    if (here.orbit.stability && !here.orbit.stability->multipliers.empty()) {
      const auto off = [](const motion::ComplexBall& mu) {
        return std::hypot(mu.re.approximate() - 1, mu.im.approximate());
      };
      const motion::ComplexBall& mu = *std::ranges::min_element(here.orbit.stability->multipliers, {}, off);
      text += fmt::format("; the multiplier nearest to 1 is {:.4g}", mu.re.approximate());
      text += mu.im.approximate() == 0 ? "" : fmt::format(" +- {:.4g}i", mu.im.approximate());
    }
    return text;
  }

  const MachineBranchQuestion& q_;
  Rational unit_;
  const MachineSample& start_;
};

// What a multiplier has done where a stable motion has become an unstable one, by those of the unstable one.
std::string which_multiplier(const motion::Stability& unstable) {
  std::vector<motion::ComplexBall> outside;
  std::ranges::copy_if(unstable.multipliers, std::back_inserter(outside),
                       [](const motion::ComplexBall& mu) { return mu.squared_modulus().approximate() > 1; });
  return outside.size() == 1 ? fmt::format("beyond, a multiplier is {}",
                                           outside[0].re.approximate() > 0 ? "above 1" : "below -1")
         : outside.size() == 2 && outside[0].im.approximate() != 0
             ? "beyond, a pair of complex multipliers is outside of the unit circle"
             : "beyond, multipliers are outside of the unit circle";
}

// Of each sample and the next: all of one state after each other at once.
std::vector<Joint> joints_of(const MachineBranchQuestion& q, const std::vector<MachineSample>& samples) {
  struct Run {
    std::size_t first, last;
  };
  std::vector<Run> runs;
  const auto goes_on = [&](std::size_t k) {  // from sample k to the next as to it
    const MachineSample &before = samples[k - 1], &here = samples[k], &next = samples[k + 1];
    return before.state == here.state && here.state == next.state && !is_fold(before, here) &&
           !is_fold(here, next) && (before.value < here.value) == (here.value < next.value);
  };
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
    if (k > 0 && goes_on(k)) {
      runs.back().last = k + 1;
    } else {
      runs.push_back({k, k + 1});
    }
  }
  const auto found = parallel_map(runs.size(), [&](std::size_t r) {
    const std::size_t first = runs[r].first, last = runs[r].last;
    const MachineSample& a = samples[first];
    const auto all = [&](const char * why) {
      const auto verdict = Verdict::undecided(why);
      return std::vector<Joint>(last - first, {verdict, verdict});
    };
    if (is_fold(a, samples[last])) {
      return all("the branch turns back");
    }
    std::vector<MotionAt> motions;
    for (std::size_t k = first; k <= last; ++k) {
      const Machine machine = q.at(samples[k].value);
      motions.push_back({{samples[k].value}, guess_of(samples[k].orbit, machine)});
      if (k > first && !machine.oscillator.is_autonomous()) {
        // With the times of one load's phase, which may have passed 0.
        MachineGuess& guess = motions.back().guess;
        const double turn = guess.duration / static_cast<double>(guess.periods);
        const double turns =
            std::round((guess.events[0].t - motions[motions.size() - 2].guess.events[0].t) / turn);
        for (MachineGuess::Event& event : guess.events) {
          event.t -= turns * turn;
        }
      }
    }
    const bool has_state = a.state == samples[last].state && is_decided(a.state);
    std::vector<Joint> joints =
        joints_between(q.at, motions, has_state ? std::optional(a.state) : std::nullopt);
    for (Joint& joint : joints) {
      if (!has_state) {
        joint.state = Verdict::undecided(a.state == samples[last].state ? "the state is not decided"
                                                                        : "the state changes");
      }
    }
    return joints;
  });
  std::vector<Joint> joints;
  for (const std::vector<Joint>& run : found) {
    joints.insert(joints.end(), run.begin(), run.end());
  }
  return joints;
}

// What changes between two neighbours, by what is proved of both; nothing that could be named.
std::optional<MachineChange> change_between(const MachineSample& a, const MachineSample& b) {
  const bool first = branches::is_admissible(a.state), second = branches::is_admissible(b.state);
  const auto change = [&](ChangeKind kind, const std::string& words) {
    return MachineChange{kind, a.value, b.value, words};
  };
  if (is_fold(a, b)) {
    const Rational& at = a.before_fold ? a.value : b.value;
    const std::string sides = a.state == b.state ? ""
                                                 : fmt::format(": {} on one side, {} on the other",
                                                               to_string(a.state), to_string(b.state));
    return MachineChange{ChangeKind::fold, at, at, "the branch turns back" + sides};
  }
  if (a.state == b.state || a.state == State::undecided || b.state == State::undecided) {
    return std::nullopt;
  }
  if (a.state == State::absent || b.state == State::absent) {
    return change(ChangeKind::birth, "a phase lasts no time");
  }
  if (first != second) {
    return change(
        ChangeKind::condition,
        fmt::format("the condition {} is {}", violated((first ? b : a).orbit), first ? "lost" : "gained"));
  }
  if (is_decided(a.state) && is_decided(b.state)) {
    const bool lost = a.state == State::stable;
    return change(ChangeKind::stability, fmt::format("stability is {}: {}", lost ? "lost" : "gained",
                                                     which_multiplier(*(lost ? b : a).orbit.stability)));
  }
  return std::nullopt;
}

}  // namespace

bool MachineBranch::resolved() const {
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const MachineSample &a = samples[k], &b = samples[k + 1];
    if (!is_fold(a, b) && (joints[k].existence.truth != Truth::proved ||
                           (a.state == b.state && joints[k].state.truth != Truth::proved))) {
      return false;
    }
  }
  return existence.truth == Truth::proved && !interrupted && first.kind != End::stopped &&
         last.kind != End::stopped &&
         std::ranges::all_of(samples, [](const MachineSample& s) { return is_decided(s.state); });
}

MachineBranch follow_machine_branch(const MachineBranchQuestion& question) {
  if (question.from >= question.to || question.start < question.from || question.start > question.to) {
    throw UsageError(fmt::format(
        "a branch is followed from A to B, A < B, and from a value in between: not {}..{} from {}",
        to_string(question.from), to_string(question.to), to_string(question.start)));
  }
  for (const Rational& end : {question.from, question.to}) {
    require_machine(question.at(end));
  }
  MachineBranch branch;
  const MachineOrbit orbit =
      prove_machine_orbit(question.at(question.start), question.guess, question.digits);
  branch.existence = orbit.existence;
  if (orbit.existence.truth != Truth::proved) {
    return branch;
  }
  const MachineSample start{question.start, state_of(orbit), orbit};
  const Walk walk(question, start);
  auto ways = parallel_map(2, [&](std::size_t k) { return walk.follow(k == 0 ? -1 : 1); });
  if (ways[1].end.kind == End::closed) {
    ways[0] = {{start}, ways[1].end};
  }
  branch.first = ways[0].end;
  branch.last = ways[1].end;
  std::ranges::reverse(ways[0].samples);
  std::vector<MachineSample> all = std::move(ways[0].samples);
  all.back().before_fold = all.back().before_fold || ways[1].samples.front().before_fold;
  all.insert(all.end(), ways[1].samples.begin() + 1, ways[1].samples.end());
  const auto more =
      parallel_map(all.size() - 1, [&](std::size_t k) { return walk.between(all[k], all[k + 1]); });
  for (std::size_t k = 0; k < all.size(); ++k) {
    branch.samples.push_back(all[k]);
    if (k < more.size()) {
      branch.samples.insert(branch.samples.end(), more[k].begin(), more[k].end());
    }
  }
  for (std::size_t k = 0; k + 1 < branch.samples.size(); ++k) {
    if (const auto change = change_between(branch.samples[k], branch.samples[k + 1])) {
      branch.changes.push_back(*change);
    }
  }
  if (question.without_gaps) {
    branch.joints = joints_of(question, branch.samples);
  }
  branch.interrupted = interrupted();
  return branch;
}

}  // namespace stickslip::numeric::machines
