#include "numeric/machines/curve.hpp"

#include <algorithm>
#include <string>

#include "core/interruption.hpp"

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

namespace {

constexpr long curve_bits = 64;
constexpr long most_steps = 1L << 12;  // on the whole way, if all were as long
constexpr int steps_before_longer = 6;

std::vector<Rational> numbers_of(const model::FrictionOscillator<Rational>& o) {
  std::vector<Rational> numbers;
  (void)model::mapped<Rational>(o, [&](const Rational& x) { return numbers.emplace_back(x); });
  return numbers;
}

// All but the masses, of which the inverses; slopes of the laws; velocities at which they are compared.
struct Numbers {
  std::vector<Rational> masses, rest, slopes, velocities;
};
Numbers parts_of(model::FrictionOscillator<Rational> o) {
  Numbers parts;
  for (Rational& m : o.masses) {
    parts.masses.push_back(1 / m);
    m = 0;
  }
  parts.rest = numbers_of(o);
  parts.velocities = {o.V};
  for (const model::FrictionLaw<Rational> * law : {&o.forward, &o.backward}) {
    for (const model::SlidingPiece<Rational>& piece : law->sliding) {
      parts.slopes.push_back(piece.slope);
      parts.velocities.push_back(piece.from);
    }
  }
  return parts;
}

bool is_between(const std::vector<Rational>& low, const std::vector<Rational>& middle,
                const std::vector<Rational>& high) {
  bool is = low.size() == high.size() && low.size() == middle.size();
  for (std::size_t k = 0; k < low.size() && is; ++k) {
    is = low[k] + high[k] == 2 * middle[k];
  }
  return is;
}

bool has_smooth_law(const model::FrictionOscillator<Rational>& o) {
  return o.forward.smooth || o.backward.smooth;
}

// Whether the loads are the same but for their sizes.
bool have_same_loads(const model::FrictionOscillator<Rational>& a,
                     const model::FrictionOscillator<Rational>& b) {
  return std::ranges::equal(a.loads, b.loads, [](const auto& one, const auto& other) {
    return one.mass == other.mass && one.k == other.k;
  });
}

// Whether friction at rest and the first one when sliding are equal, at both sides.
std::pair<bool, bool> drops(const model::FrictionOscillator<Rational>& o) {
  const auto drops = [](const model::FrictionLaw<Rational>& law) {
    return law.sliding.front().force != law.at_rest;
  };
  return {drops(o.forward), drops(o.backward)};
}

// Why the numbers of the drift and of the events are not known to be linear between the ends. Each number of
// a machine is a linear function of what stands in its file, or a quotient of two (a slope); such a one that
// agrees with a linear function at three values is that function. A load's multiple that is the same at three
// values is so at all, for then its frequency is the only one that varies, or all do.
std::string why_not_linear(const Machine& low, const Machine& middle, const Machine& high) {
  const auto &a = low.oscillator, &m = middle.oscillator, &b = high.oscillator;
  if (has_smooth_law(a)) {
    return "a smooth law of friction";
  }
  const Numbers of_low = parts_of(a), of_middle = parts_of(m), of_high = parts_of(b);
  const bool is_linear = is_between(of_low.masses, of_middle.masses, of_high.masses) &&
                         is_between(of_low.rest, of_middle.rest, of_high.rest) && have_same_loads(a, m) &&
                         have_same_loads(m, b);
  const bool has_products = (of_low.masses != of_high.masses && of_low.rest != of_high.rest) ||
                            (of_low.slopes != of_high.slopes && of_low.velocities != of_high.velocities);
  const bool changes_kind = drops(a) != drops(m) || drops(b) != drops(m);
  return is_linear && !has_products && !changes_kind
             ? ""
             : "the machine's numbers do not change linearly with the datum";
}

// The value at which the machine is in the middle: of the data, or of their inverses for a mass.
std::optional<Rational> middle_of(const std::function<Machine(const Rational&)>& at, const Rational& low,
                                  const Rational& high, std::string& why) {
  for (const bool inverse : {false, true}) {
    if (inverse && low * high <= 0) {
      break;
    }
    const Rational middle = inverse ? Rational(2 * low * high / (low + high)) : Rational((low + high) / 2);
    why = why_not_linear(at(low), at(middle), at(high));
    if (why.empty()) {
      return middle;
    }
  }
  return std::nullopt;
}

MachineGuess between(const MotionAt& a, const MotionAt& b, const Rational& value) {
  const double share = Rational((value - a.value) / (b.value - a.value)).get_d();
  MachineGuess guess = a.guess;
  for (std::size_t i = 0; i < guess.events.size(); ++i) {
    guess.events[i].t += share * (b.guess.events[i].t - a.guess.events[i].t);
    guess.events[i].X += share * (b.guess.events[i].X - a.guess.events[i].X);
  }
  guess.duration += share * (b.guess.duration - a.guess.duration);
  return guess;
}

class Way {
 public:
  Way(const std::function<Machine(const Rational&)>& at, const MotionAt& a, const MotionAt& b)
      : at_(at), a_(a), b_(b) {
    for (const MachineGuess::Event& event : a.guess.events) {
      pieces_.push_back(event.begins);
    }
  }

  [[nodiscard]] Joint follow(State state) const {
    Joint joint{Verdict::undecided("interrupted"), Verdict::proved()};
    Rational here = a_.value, step = b_.value - a_.value;
    const Rational shortest = abs(Rational(step / most_steps));
    ChainProof at_here = thin(here);
    int successes = steps_before_longer;
    while (here != b_.value && !interrupted()) {
      const Rational next = abs(Rational(b_.value - here)) < abs(step) ? b_.value : Rational(here + step);
      const ChainProof at_next = thin(next);
      const Joint found = stretch(here, at_here, next, at_next, state);
      const bool with_state = joint.state.truth == Truth::proved;
      if (found.existence.truth == Truth::proved && (!with_state || found.state.truth == Truth::proved)) {
        here = next;
        at_here = at_next;
        if (++successes >= steps_before_longer) {
          step = 2 * step;
        }
        continue;
      }
      successes = 0;
      step = step / 2;
      if (abs(step) >= shortest) {
        continue;
      }
      if (!with_state || found.existence.truth != Truth::proved) {
        return {found.existence, with_state ? found.existence : joint.state};
      }
      joint.state = found.state;  // only the curve is left
      successes = steps_before_longer;
      step = 4 * step;
    }
    if (here == b_.value) {
      joint.existence = Verdict::proved();
    } else {
      joint.state = joint.existence;
    }
    return joint;
  }

 private:
  [[nodiscard]] ChainProof thin(const Rational& value) const {
    const Machine machine = at_(value);
    return prove_chain({machine, pieces_, a_.guess.periods}, nodes_of(between(a_, b_, value), machine),
                       curve_bits, 8 * curve_bits);
  }

  [[nodiscard]] Joint stretch(const Rational& from, const ChainProof& at_from, const Rational& to,
                              const ChainProof& at_to, State state) const {
    const auto open = [](const Verdict& why) { return Joint{why, why}; };
    for (const ChainProof * end : {&at_from, &at_to}) {
      if (end->verdict.truth != Truth::proved) {
        return open(end->verdict);
      }
    }
    std::string why;
    const auto middle = middle_of(at_, from, to, why);
    if (!middle) {
      return open(Verdict::undecided(why));
    }
    const MachineQuestion question{at_(*middle), pieces_, a_.guess.periods, {{at_(from), at_(to)}}};
    const ChainProof proof = prove_curve(question, at_from, at_to, curve_bits);
    if (proof.verdict.truth != Truth::proved) {
      return open(proof.verdict);
    }
    const bool is_so = state_of(decided(question, proof)) == state;
    return {Verdict::proved(),
            is_so ? Verdict::proved() : Verdict::undecided("a condition or the stability is not decided")};
  }

  const std::function<Machine(const Rational&)>& at_;
  const MotionAt &a_, &b_;
  std::vector<Piece> pieces_;
};

}  // namespace

Joint joint_between(const std::function<Machine(const Rational&)>& at, const MotionAt& a, const MotionAt& b,
                    State state) {
  const bool go_together = std::ranges::equal(a.guess.events, b.guess.events, {},
                                              &MachineGuess::Event::begins, &MachineGuess::Event::begins);
  const auto other = Verdict::undecided("the motion at one end is not through the same phases");
  return go_together ? Way(at, a, b).follow(state) : Joint{other, other};
}

}  // namespace stickslip::numeric::machines
