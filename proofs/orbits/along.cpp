#include "proofs/orbits/along.hpp"

#include <algorithm>

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;
using Wave = model::Wave<Symbolic>;

namespace {

constexpr long few_bits = 64;
constexpr int most_halvings = 24;

// The theorem without the hypothesis, which is what the lemma says.
Theorem given(const Theorem& lemma, const Theorem& theorem) {
  return theorem.hypotheses().contains(lemma.conclusion()) ? Theorem::cut(lemma, theorem) : theorem;
}

Theorem halved(const Variable& x, Ranges ranges, const std::function<Theorem(const Ranges&)>& decide,
               int depth) {
  if (depth == 0) {
    return decide(ranges);
  }
  if (const auto decided = attempt([&] { return decide(ranges); })) {
    return *decided;
  }
  const Interval whole = ranges.at(x);
  const Rational middle = (whole.first + whole.second) / 2;
  ranges[x] = {whole.first, middle};
  const Theorem left = halved(x, ranges, decide, depth - 1);
  ranges[x] = {middle, whole.second};
  const Theorem right = halved(x, ranges, decide, depth - 1);
  return either_side(left, right, x, middle);
}

// f(b) - f(a) = f'(c) (b - a) for some a < c < b, f being the wave: gives the goal from a < c < b and that.
template <class Use>
Theorem by_mean_value(const Wave& wave, const Term& a, const Term& b, const Theorem& order, const Use& use) {
  const Variable t{"t"}, c{"c"};
  const Term f = lambda(t, value(wave, t));
  const Term slope = value(model::derivative(wave), t);
  const Theorem found = Theorem::differentiate(f, t);
  const Theorem same = Theorem::combination(equal(found.conclusion().parts()[2], slope));
  const Theorem rate = tactics::by_rewriting(found, same);
  const Formula inside = between(a, t, b);
  const Theorem mean = Theorem::mean_value(Theorem::continuity(f, a, b), for_every(t, inside, rate), order);
  const Theorem there = Theorem::assume(opened(mean.conclusion(), c));
  return Theorem::choose(mean, c, use(Term(c), part(there, 0), part(there, 1)));
}

class Along {
 public:
  Along(const Below& question, const Variable& s, const Ranges& ranges)
      : q_(question),
        s_(s),
        ranges_(ranges),
        length_(enclosure(question.duration, ranges, Rational(1, 1048576))) {}

  Theorem operator()() {
    // Where one of the ends is near, the slope decides; between them, the value.
    const Rational whole = rounded_down(length_.first, 4096);
    const Rational from = q_.meets_at_start ? found([&](const Rational&d) { return rising(-1, 0, d); }, whole)
                                            : Rational(0),
                   to =
                       q_.meets_at_end
                           ? whole -
                                 found([&](const Rational&d) { return rising(1, whole - d, length_.second); },
                                       whole)
                           : length_.second;
    Ranges here = ranges_;
    here[s_] = {from, to};
    Theorem result = in_pieces(goal(), s_, here);  // from <= s <= to
    if (q_.meets_at_start) {
      result = either_side(near_start(from), result, s_, from);
    }
    result = q_.meets_at_end ? either_side(result, near_end(to), s_, to) : given(before_end(to), result);
    return result;
  }

 private:
  [[nodiscard]] Formula goal() const { return less(value(q_.wave, s_), q_.bound); }
  // s <= u from s <= duration.
  [[nodiscard]] Theorem before_end(const Rational& to) const {
    return Theorem::order(at_most(s_, to), {{{Theorem::assume(at_most(s_, q_.duration))}},
                                            {{sign(less(q_.duration, to), ranges_, few_bits)}}});
  }

  // The slope has this sign in the range.
  [[nodiscard]] Theorem rising(int direction, const Rational& from, const Rational& to) const {
    Ranges here = ranges_;
    const Variable c{"c"};
    here[c] = {from, to};
    const Term slope = value(model::derivative(q_.wave), c);
    return in_pieces(direction < 0 ? less(slope, 0) : less(0, slope), c, here);
  }

  // The largest of the durations whole/2, whole/4, … for which it works.
  template <class Try>
  [[nodiscard]] static Rational found(const Try& attempt, const Rational& whole) {
    Rational duration = rounded_down(whole / 4, 4096);
    for (;;) {
      try {
        static_cast<void>(attempt(duration));
        return duration;
      } catch (const KernelError&) {
        duration = duration / 2;
        if (duration < Rational(1, 1000000)) {
          throw;
        }
      }
    }
  }

  // 0 < s, s <= d ⊢ wave(s) < bound, as it falls from the bound.
  [[nodiscard]] Theorem near_start(const Rational& d) const {
    const Theorem positive = Theorem::assume(less(0, s_)), early = Theorem::assume(at_most(s_, d));
    return by_mean_value(
        q_.wave, 0, s_, positive, [&](const Term& c, const Theorem& where, const Theorem& mean) {
          Theorem falls = rising(-1, 0, d);
          falls = given(Theorem::order(at_most(0, c), {{{part(where, 0)}}}), falls);
          falls = given(Theorem::order(at_most(c, d), {{{part(where, 1)}}, {{early}}}), falls);
          return Theorem::order(goal(), {{{falls, positive}}}, {{mean, -1}, {*q_.meets_at_start, -1}});
        });
  }
  // d <= s, s < duration ⊢ wave(s) < bound, as it rises to the bound.
  [[nodiscard]] Theorem near_end(const Rational& d) const {
    const Theorem before = Theorem::assume(less(s_, q_.duration)), late = Theorem::assume(at_most(d, s_));
    return by_mean_value(
        q_.wave, s_, q_.duration, before, [&](const Term& c, const Theorem& where, const Theorem& mean) {
          Theorem rises = rising(1, d, length_.second);
          rises = given(Theorem::order(at_most(d, c), {{{part(where, 0)}}, {{late}}}), rises);
          rises = given(Theorem::order(at_most(c, length_.second),
                                       {{{part(where, 1)}},
                                        {{sign(less(q_.duration, length_.second), ranges_, few_bits)}}}),
                        rises);
          return Theorem::order(goal(), {{{rises, before}}}, {{mean}, {*q_.meets_at_end, -1}});
        });
  }

  const Below& q_;
  const Variable& s_;
  const Ranges& ranges_;
  Interval length_;  // of the duration
};

}  // namespace

Ranges ranges_in(const Term& term, const Ranges& ranges) {
  Ranges result;
  for (const Variable& variable : term.variables()) {
    if (const auto known = ranges.find(variable); known != ranges.end()) {
      result.insert(*known);
    }
  }
  return result;
}

bool is_range(const Formula& formula, const Ranges& ranges) {
  return std::ranges::any_of(ranges, [&](const auto& one) {
    return formula == at_most(one.second.first, one.first) ||
           formula == at_most(one.first, one.second.second);
  });
}

Theorem sign(const Formula& relation, const Ranges& ranges, long bits) {
  return Theorem::sign(relation, ranges_in(relation, ranges), bits);
}

bool holds(const Formula& relation, const Ranges& ranges, long bits) {
  return attempt([&] { return sign(relation, ranges, bits); }).has_value();
}

Theorem without_divisors(const Theorem& theorem, const Ranges& ranges) {
  return settled_by(theorem, [&](const Formula& one) {
    return is_divisor(one) ? std::optional(sign(one, ranges)) : std::nullopt;
  });
}

Rational rounded_down(const Rational& value, const mpz_class& unit) {
  mpz_class whole;
  const Rational scaled = value * unit;
  mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  Rational result(whole, unit);
  result.canonicalize();
  return result;
}

Interval enclosure(const Term& term, const Ranges& ranges, const Rational& width) {
  const auto is_less = [&](const Term& a, const Term& b) { return holds(less(a, b), ranges, few_bits); };
  Rational low = -1, high = 1;
  const auto widened = [&](Rational& bound, const auto& is_bound) {
    while (!is_bound()) {
      bound *= 2;
      if (abs(bound) > 1L << 40) {
        throw KernelError("there are no bounds of " + to_string(term));
      }
    }
  };
  widened(high, [&] { return is_less(term, high); });
  widened(low, [&] { return is_less(low, term); });
  while (high - low > width) {
    const Rational apart = high - low, lower = low + apart * Rational(3, 8),
                   upper = low + apart * Rational(5, 8);
    if (is_less(term, upper)) {
      high = upper;
    } else if (is_less(lower, term)) {
      low = lower;
    } else {
      break;
    }
  }
  return {low, high};
}

Rational above(const Term& term, const Ranges& ranges) {
  const Rational least(1, 1024);
  return rounded_down(enclosure(term, ranges_in(term, ranges), least).second, 1024) + least;
}

Theorem in_pieces(const Formula& inequality, const Variable& x, const Ranges& ranges) {
  return in_pieces(x, ranges, [&](const Ranges& here) { return sign(inequality, here, few_bits); });
}

Theorem in_pieces(const Variable& x, const Ranges& ranges,
                  const std::function<Theorem(const Ranges&)>& decide) {
  return halved(x, ranges, decide, most_halvings);
}

Theorem stays_below(const Below& question, const Variable& s, const Ranges& ranges) {
  return Along(question, s, ranges)();
}

}  // namespace stickslip::proofs::orbits
