#include "proofs/tactics/relations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "proofs/tactics/algebraic_numbers.hpp"
#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/cuts.hpp"
#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/sum_of_products.hpp"

namespace stickslip::proofs::tactics {

namespace {

using namespace kernel;
using kernel::Kind;
using Theorems = std::vector<Theorem>;

bool is_bent_along(const Term& term, const Variable& x) {
  return is_wave(term) || term.kind() == Kind::exponential
             ? term.variables().contains(x)
             : std::ranges::any_of(term.parts(), [&](const Term& part) { return is_bent_along(part, x); });
}

Formula is_positive(const Term& a, bool strictly) {
  return strictly ? less(0, a) : at_most(0, a);
}

// What is known of what the goal speaks of, and of what is said of that, as far as `spoken_of` says of what a
// formula speaks.
template <class SpokenOf>
Theorems of_use(const Formula& goal, const Theorems& known, const SpokenOf& spoken_of,
                std::size_t most = std::numeric_limits<std::size_t>::max()) {
  auto met = spoken_of(goal);
  Theorems result, rest = known;
  for (bool changed = true; changed && result.size() < most;) {
    changed = std::erase_if(rest, [&](const Theorem& one) {
                const auto in_it = spoken_of(one.conclusion());
                const bool taken = result.size() < most &&
                                   std::ranges::any_of(in_it, [&](const auto& x) { return met.contains(x); });
                if (taken) {
                  result.push_back(one);
                  met.insert(in_it.begin(), in_it.end());
                }
                return taken;
              }) > 0;
  }
  return result;
}

// The letters of both sides: nothing of what stands within their sines, cosines and exponentials alone.
std::set<Term> letters_of(const Formula& formula) {
  const std::vector<Term> all = Letters({gap_of(formula)}).terms();
  return {all.begin(), all.end()};
}

// Whether it is negative at a point where the inequalities that are known hold, as far as floating point can
// tell: then no proof need be looked for.
bool seems_negative(const Term& a, const Theorems& known) {
  Variables all = a.variables();
  for (const Theorem& one : known) {
    all.insert(one.conclusion().variables().begin(), one.conclusion().variables().end());
  }
  constexpr int most_points = 400, enough = 20;
  constexpr long double in_doubt = 1e-12L;
  std::minstd_rand random;
  for (int k = 0, met = 0; k < most_points && met < enough; ++k) {
    Point point;
    for (const Variable& x : all) {  // up to 1 or 6, every other time of both signs
      const long step = static_cast<long>(random() % 1024) - (k % 2 == 0 ? 0 : 512);
      point[x] = Rational(step) / (k % 3 == 0 ? 1024 : 160);
    }
    const auto holds = [&](const Theorem& one) {
      return is_inequality(one.conclusion()) && estimated(gap_of(one.conclusion()), point) > 0;
    };
    if (std::ranges::all_of(known, holds)) {
      ++met;
      if (estimated(a, point) < -in_doubt) {
        return true;
      }
    }
  }
  return false;
}

// ⊢ 0 < x and x < pi ⇒ 0 < sin x, and with ≤ everywhere.
Theorem sine_between(const Term& x, bool strictly) {
  const Theorem inside = Theorem::sine_is_positive(x);
  if (strictly) {
    return inside;
  }
  const Formula wanted = at_most(0, sin(x));
  std::vector<Theorem> cases{inside, Theorem::trichotomy(0, x), Theorem::trichotomy(x, pi()),
                             Theorem::trichotomy(0, sin(x))};
  for (const bool at_start : {true, false}) {
    const Formula at_end = at_start ? equal(0, x) : equal(x, pi());
    const Theorem end = at_start ? Theorem::assume(at_end) : symmetric(Theorem::assume(at_end));
    const Variable place = fresh(real_number, {x});
    const Theorem there = Theorem::order(at_most(0, sin(at_start ? Term(0) : pi())), {});
    cases.push_back(Theorem::discharge(Theorem::replace(end, place, at_most(0, sin(place)), there), at_end));
  }
  return Theorem::consequence(cases, implies(all({at_most(0, x), at_most(x, pi())}), wanted));
}

// ⊢ 0 ≤ 1 - w or 0 ≤ 1 + w, where w is sin(v) or cos(v).
const Theorem& distance_from_one(bool is_sine, bool above) {
  const auto lemma = [](bool of_sine, bool below_one) {
    const Variable v{"v"};
    const Term w = of_sine ? sin(v) : cos(v), other = of_sine ? cos(v) : sin(v),
               distance = below_one ? 1 - w : 1 + w;
    const Rational half(1, 2);
    return Theorem::order(at_most(0, distance), {Positive{{}, half, distance}, Positive{{}, half, other}});
  };
  static thread_local const std::array lemmas{lemma(false, false), lemma(false, true), lemma(true, false),
                                              lemma(true, true)};
  return lemmas.at((is_sine ? 2 : 0) + (above ? 1 : 0));
}

// u/v, where that is a number.
std::optional<Rational> ratio(const Term& u, const Term& v) {
  const auto quotient = attempt([&] { return Letters({u, v}).fraction(u / v); });
  return quotient && is_constant(quotient->above) && is_constant(quotient->below)
             ? std::optional(leading_coefficient(quotient->above) / leading_coefficient(quotient->below))
             : std::nullopt;
}

// Exponentials whose arguments are whole multiples of another's as powers of that.
Term in_powers(const Term& term) {
  constexpr long highest = 16;
  std::vector<Term> all = Letters({term}).terms();
  std::erase_if(all, [](const Term& letter) { return letter.kind() != Kind::exponential; });
  Term result = term;
  Terms gone;
  for (const Term& one : all) {
    for (const Term& other : all) {
      const auto times = other == one || gone.contains(one) || gone.contains(other)
                             ? std::nullopt
                             : ratio(other.parts()[0], one.parts()[0]);
      if (times && times->get_den() == 1 && *times != 0 && abs(*times) <= highest) {
        const long n = times->get_num().get_si();
        result = replaced(result, other, n > 0 ? power(one, n) : inverse(power(one, -n)));
        gone.insert(other);
      }
    }
  }
  return result;
}

// A number of few digits beside one that is positive.
Rational rounded(long double value, bool up) {
  constexpr int digits = 10;
  int exponent = 0;
  const long double whole = std::ldexp(std::frexp(value, &exponent), digits);
  if (!std::isfinite(value)) {
    throw KernelError("it is no number that floating point knows");
  }
  return std::ldexp(static_cast<double>(up ? std::floor(whole) + 1 : std::ceil(whole) - 1),
                    exponent - digits);
}

class Search {
  static constexpr int deepest = 4;

 public:
  // The inequality by its gap's numerator, and the sign of its denominator.
  Theorem decided(const Formula& goal, const Theorems& known, int depth = deepest) {
    const bool strictly = goal.kind() == Kind::less;
    const Term gap = in_powers(gap_of(goal));
    const Letters letters({gap});
    auto [above, below] = letters.fraction(gap);
    if (is_constant(below)) {
      const Theorem one = positive(above, letters, strictly, known, depth);
      return Theorem::order(goal, {Positive{{one}, 1 / leading_coefficient(below)}});
    }
    // From the sign of the numerator and of each factor of the denominator.
    const Factored divisors = factored(below, letters);
    Rational scale = leading_coefficient(below) / leading_coefficient(divisors.product);
    Positive quotient;
    Domain differ_from_0 = known;
    for (std::size_t k = 0; k < divisors.factors.size(); ++k) {
      const Term one = letters.term(divisors.factors[k]);
      const bool is_even = divisors.exponents[k] % 2 == 0;
      const auto sign = first_that_works(std::array{false, true}, [&](bool turned) {
        return is_even ? tactics::positive(power(one, 2), {}) : not_zero(one, turned, known, depth);
      });
      if (!sign) {
        throw KernelError("no sign is known of " + to_string(one));
      }
      const bool turned = !is_even && !(sign->conclusion().parts()[1] == one);
      scale *= turned ? -1 : 1;
      differ_from_0.push_back(different(turned ? Theorem::order(less(one, 0), {Positive{{*sign}}}) : *sign));
      for (int n = 0; n < divisors.exponents[k]; n += is_even ? 2 : 1) {
        quotient.inequalities.push_back(inverse_is_positive(*sign));
      }
    }
    above *= letters.ring().constant(sgn(scale));
    quotient.inequalities.push_back(positive(above, letters, strictly, known, depth));
    quotient.factor = 1 / abs(scale);
    return nonzero(Theorem::order(goal, {quotient}), differ_from_0);
  }

  // 0 < 0.
  Theorem contradiction(const Theorems& known) {
    Theorems facts = known;
    add_what_letters_say(0, known, 2, facts);
    return sum_of_products(less(0, 0), facts, work_);
  }

  // Where to cut the range of its one variable. Throws where it seems to be negative.
  static Cuts places(const Term& f, const Theorems& known) {
    if (f.variables().size() != 1) {
      return {};
    }
    const Variable x = *f.variables().begin();
    const auto number = [&](bool above) {
      const auto end = bound(x, above, known);
      return end ? std::optional<Rational>(end->conclusion().parts()[above ? 1 : 0].value()) : std::nullopt;
    };
    const Cuts result = cuts(f, x, number(false), number(true));
    const auto holds_there = [&](const Theorem& one) {
      return one.conclusion().variables() == f.variables() && is_inequality(one.conclusion()) &&
             estimated(gap_of(one.conclusion()), {{x, *result.below}}) > 0;
    };
    if (result.below && std::ranges::all_of(known, holds_there)) {
      throw KernelError("it does not hold");
    }
    return result;
  }

  // 0 < a or 0 ≤ a, of a polynomial in letters.
  Theorem positive(const Term& a, bool strictly, const Theorems& known, int depth) {
    const Formula goal = is_positive(a, strictly);
    if (a.variables().empty()) {
      return certainly(goal);
    }
    constexpr std::size_t most = 16;
    const Theorems here = of_use(
        goal, known, [](const Formula& one) { return one.variables(); }, most);
    return depth == deepest ? once(goal, here, [&] { return searched(goal, here, depth); })
                            : searched(goal, here, depth);
  }

 private:
  // What the work makes, unless it made nothing of the same before: a line is tried in many ways.
  template <class Work>
  Theorem once(const Formula& goal, const Theorems& known, const Work& work) const {
    static thread_local std::set<std::vector<Term>> failed;
    std::vector<Term> said{goal, Term(work_), Term(is_part_ ? 1 : 0)};
    std::ranges::transform(known, std::back_inserter(said), &Theorem::conclusion);
    if (failed.contains(said)) {
      throw KernelError("it was not found");
    }
    try {
      return work();
    } catch (const KernelError&) {
      constexpr std::size_t most = 1000;
      if (failed.size() < most) {
        failed.insert(said);
      }
      throw;
    }
  }

  Theorem searched(const Formula& goal, const Theorems& here, int depth) {
    const Term& a = goal.parts()[1];
    const bool strictly = goal.kind() == Kind::less;
    if (const auto theorem = attempt([&] { return in_balls(goal, here, depth); })) {
      return *theorem;
    }
    if (work_ < 0 || seems_negative(a, here)) {
      throw KernelError("it does not hold");
    }
    Theorems facts = here;
    add_what_letters_say(a, here, depth, facts);
    if (const auto theorem = attempt([&] { return sum_of_products(goal, facts, work_); })) {
      return *theorem;
    }
    if (depth <= 0) {
      throw KernelError("it is no sum of products of what is known");
    }
    const Cuts parts = depth == deepest && !is_part_ ? places(a, here) : Cuts{};
    const auto along =
        parts.has_valley ? std::nullopt : attempt([&] { return along_variables(a, strictly, here, depth); });
    return along ? *along : in_parts(a, strictly, parts.places, here);
  }

  // 0 < a or 0 ≤ a: of the whole, or from the signs of its factors.
  Theorem positive(const Polynomial& a, const Letters& letters, bool strictly, const Theorems& known,
                   int depth) {
    const Term whole = letters.term(a);
    if (const auto found = attempt([&] { return positive(whole, strictly, known, depth); })) {
      return *found;
    }
    const Factored product = factored(a, letters);
    if (product.factors.size() == 1 && product.exponents[0] == 1) {
      throw KernelError("no sign is known of " + to_string(whole));
    }
    Rational scale = leading_coefficient(a) / leading_coefficient(product.product);
    Positive signs;
    for (std::size_t k = 0; k < product.factors.size(); ++k) {
      const Term one = letters.term(product.factors[k]);
      for (int n = 0; n < product.exponents[k] / 2 && !strictly; ++n) {
        signs.square = signs.square * one;
      }
      const int left = strictly ? product.exponents[k] : product.exponents[k] % 2;
      if (left > 0) {
        const auto sign = first_that_works(
            std::array{one, -one}, [&](const Term& size) { return positive(size, strictly, known, depth); });
        if (!sign) {
          throw KernelError("no sign is known of " + to_string(one));
        }
        const bool turns = left % 2 != 0 && !(sign->conclusion().parts()[1] == one);
        scale *= turns ? -1 : 1;
        signs.inequalities.insert(signs.inequalities.end(), static_cast<std::size_t>(left), *sign);
      }
    }
    signs.factor = scale;
    return Theorem::order(is_positive(whole, strictly), {signs});
  }

  // 0 < a or 0 < -a, where a is not zero: that is a hypothesis, if no more than 0 ≤ a or a ≤ 0 is known.
  Theorem not_zero(const Term& a, bool turned, const Theorems& known, int depth) {
    const Term size = turned ? -a : a;
    if (const auto strictly = attempt([&] { return positive(size, true, known, depth); })) {
      return *strictly;
    }
    const Theorem sign = positive(size, false, known, depth);
    const Formula zero = equal(0, size);
    const Theorem same = Theorem::combination(equal(a, 0), {{Theorem::assume(zero), turned ? 1 : -1}});
    return Theorem::consequence(
        {sign, Theorem::assume(differ(a, 0)), Theorem::discharge(same, zero), Theorem::trichotomy(0, size)},
        less(0, size));
  }

  // The first digits of pi; that cosine and sine lie between -1 and 1; that the sine is positive where its
  // argument is known to lie between 0 and pi, and the cosine between -pi/2 and pi/2.
  void add_what_letters_say(const Term& a, const Theorems& known, int depth, Theorems& facts) {
    const Letters letters({a});
    for (const Term& letter : letters.terms()) {
      if (letter == pi()) {
        facts.push_back(Theorem::sign(less(3, pi())));
        facts.push_back(Theorem::sign(less(pi(), Rational(22, 7))));
      }
      if (letter.variables().empty() && letter != pi()) {
        add_bounds(letter, facts);
      }
      if (!is_wave(letter)) {
        continue;
      }
      const bool is_sine = letter.kind() == Kind::sine;
      const Term u = letter.parts()[0], shifted = is_sine ? u : u + pi() / 2;
      for (const bool above : {true, false}) {
        facts.push_back(Theorem::instantiate(distance_from_one(is_sine, above), {{Variable{"v"}, u}}));
      }
      const auto sine = depth <= 0 || known.empty() ? std::nullopt : of_sine(letter, shifted, known);
      if (sine) {
        facts.push_back(*sine);
      }
    }
    std::vector<Term> all{a};
    for (const Theorem& one : known) {
      all.push_back(gap_of(one.conclusion()));
    }
    std::vector<Term> exponents;
    const Letters all_letters(all);
    for (const Term& letter : all_letters.terms()) {
      if (letter.kind() == Kind::exponential) {
        exponents.push_back(letter.parts()[0]);
      }
    }
    add_exponentials(exponents, known, depth, facts);
  }

  // What a number that floating point knows lies between.
  static void add_bounds(const Term& number, Theorems& facts) {
    constexpr long double steps = 4096;
    const long double near = steps * estimated(number, {});
    if (std::abs(near) < static_cast<long double>(std::numeric_limits<int>::max())) {
      const auto end = [&](int beside) {
        const Rational value = Rational(std::lround(near) + beside) / static_cast<int>(steps);
        return Term(value);
      };
      for (const Formula& bound : {less(end(-1), number), less(number, end(1))}) {
        if (const auto theorem = attempt([&] { return Theorem::sign(bound); })) {
          facts.push_back(*theorem);
        }
      }
    }
  }

  // That they are positive, which are above or below 1, and which above which others: by the signs that are
  // known of these exponents and of their differences.
  void add_exponentials(const std::vector<Term>& exponents, const Theorems& known, int depth,
                        Theorems& facts) {
    for (const Term& u : exponents) {
      facts.push_back(exponential_is_positive(u));
      if (depth <= 1 || known.empty()) {
        continue;
      }
      for (const bool above : {true, false}) {
        if (const auto side = beside_one(u, above, known)) {
          facts.push_back(*side);
        }
        if (const auto side = is_part_ ? beside_end(u, above, known) : std::nullopt) {
          facts.push_back(*side);
        }
      }
      for (const Term& v : exponents) {
        const auto ratio = v == u ? std::nullopt : beside_one(u - v, true, known);
        if (ratio) {
          const bool strictly = ratio->conclusion().kind() == Kind::less;
          facts.push_back(Theorem::order(is_positive(exp(u) - exp(v), strictly),
                                         {Positive{{*ratio, exponential_is_positive(v)}}}));
        }
      }
    }
  }

  // 0 < exp(u) - 1 or 0 < 1 - exp(u), or with ≤, where the sign of u is known.
  std::optional<Theorem> beside_one(const Term& u, bool above, const Theorems& known) {
    return first_that_works(std::array{true, false}, [&](bool strictly) {
      const Theorem sign = decided(is_positive(above ? u : -u, strictly), known, 0);
      return detach(Theorem::instantiate(beside_one(above, strictly), {{Variable{"v"}, u}}), sign);
    });
  }

  // 0 < exp(u) - number or 0 < number - exp(u), where u is known to lie above or below what it is at an end
  // of its variable's range.
  std::optional<Theorem> beside_end(const Term& u, bool above, const Theorems& known) {
    if (u.variables().size() != 1) {
      return std::nullopt;
    }
    return first_that_works(std::array{false, true}, [&](bool is_upper) {
      const Variable x = *u.variables().begin();
      const auto end = bound(x, is_upper, known);
      const Term v = end ? substitute(u, {{x, end->conclusion().parts()[is_upper ? 1 : 0]}}) : u;
      const auto ratio = end ? beside_one(u - v, above, known) : std::nullopt;
      if (!ratio) {
        throw KernelError("it is not known to lie on that side");
      }
      constexpr long double least = 0x1p-20L;
      const Term number = rounded(std::max(estimated(exp(v), {}), least), !above);
      const Theorem beside = Theorem::sign(above ? less(number, exp(v)) : less(exp(v), number));
      return Theorem::order(less(0, above ? exp(u) - number : number - exp(u)),
                            {Positive{{*ratio, exponential_is_positive(v)}}, Positive{{beside}}});
    });
  }

  // ⊢ 0 < v ⇒ 0 < exp(v) - 1, or 0 < -v ⇒ 0 < 1 - exp(v), and with ≤.
  static const Theorem& beside_one(bool above, bool strictly) {
    const auto lemma = [](bool is_above, bool strict) {
      const Variable v{"v"};
      const Formula sign = is_positive(is_above ? Term(v) : -v, strict);
      const Formula side = is_above ? sign : strict ? less(v, 0) : at_most(v, 0);
      const Theorem known = Theorem::order(side, {Positive{{Theorem::assume(sign)}}});
      const Term away = is_above ? exp(v) - 1 : 1 - exp(v);
      return Theorem::discharge(Search().positive(away, strict, {known}, 1), sign);
    };
    static thread_local const std::array lemmas{lemma(false, false), lemma(false, true), lemma(true, false),
                                                lemma(true, true)};
    return lemmas.at((above ? 2 : 0) + (strictly ? 1 : 0));
  }

  // 0 < w or 0 ≤ w, where w is the sine of x.
  std::optional<Theorem> of_sine(const Term& w, const Term& x, const Theorems& known) {
    return first_that_works(std::array{true, false}, [&](bool strictly) {
      const Formula lower = strictly ? less(0, x) : at_most(0, x),
                    upper = strictly ? less(x, pi()) : at_most(x, pi());
      const Theorem sine =
          detach(sine_between(x, strictly), both({decided(lower, known, 0), decided(upper, known, 0)}));
      return Theorem::order(is_positive(w, strictly), {Positive{{sine}}});
    });
  }

  // First from where it is zero.
  Theorem along_variables(const Term& f, bool strictly, const Theorems& known, int depth) {
    for (const bool from_zero : {true, false}) {
      for (const Variable& x : f.variables()) {
        for (const Theorem& one : known) {
          const std::vector<Term>& sides = one.conclusion().parts();
          const bool is_left = sides[0] == Term(x);
          const Term& end = sides[is_left ? 1 : 0];
          if (!is_inequality(one.conclusion()) || !is_bent_along(f, x) || is_left == (sides[1] == Term(x)) ||
              end.variables().contains(x) || from_zero != seems_zero({substitute(f, {{x, end}})}, {})) {
            continue;
          }
          if (const auto theorem = attempt([&] { return from_end(x, f, one, strictly, known, depth - 1); })) {
            return *theorem;
          }
        }
      }
    }
    for (const Variable& x : depth == deepest && !is_part_ ? f.variables() : Variables()) {
      if (const auto theorem = attempt([&] { return between_ends(x, f, strictly, known, depth); })) {
        return *theorem;
      }
    }
    throw KernelError("there is no end from which it grows");
  }

  // 0 < f(x) or 0 ≤ f(x), from ends on both sides: where f does not fall at x it has grown from the lower,
  // else it falls on to the upper, as it does where its slope falls.
  Theorem between_ends(const Variable& x, const Term& f, bool strictly, const Theorems& known, int depth) {
    const auto end = [&](std::size_t side) {
      const auto found = std::ranges::find_if(known, [&](const Theorem& one) {
        const std::vector<Term>& sides = one.conclusion().parts();
        return is_inequality(one.conclusion()) && sides[side] == Term(x) &&
               !sides[1 - side].variables().contains(x);
      });
      return found != known.end() && is_bent_along(f, x) ? *found : throw KernelError("it has no such end");
    };
    const Term slope = rate(f, x);
    if (seems_negative(-rate(slope, x), known)) {
      throw KernelError("it does not bend down");
    }
    const auto from = [&](const Theorem& bound, const Formula& turn) {
      Theorems more = known;
      more.push_back(Theorem::assume(turn));
      Search longer;  // for there is much to be found
      longer.work_ *= 4;
      return Theorem::discharge(longer.from_end(x, f, bound, strictly, more, depth - 1), turn);
    };
    return Theorem::consequence(
        {from(end(1), at_most(0, slope)), from(end(0), at_most(slope, 0)), Theorem::trichotomy(0, slope)},
        is_positive(f, strictly));
  }

  // 0 < f(x) or 0 ≤ f(x), from x between that bound and where it is known: it is so at that end, and f grows
  // away from it.
  Theorem from_end(const Variable& x, const Term& f, const Theorem& bound, bool strictly,
                   const Theorems& known, int depth) {
    const Term left = bound.conclusion().parts()[0], right = bound.conclusion().parts()[1];
    const bool is_lower = right == Term(x);
    const Term there = substitute(f, {{x, is_lower ? left : right}});
    const auto strict_start =
        strictly ? attempt([&] { return decided(less(0, there), known, depth); }) : std::nullopt;
    const Theorem start = strict_start ? *strict_start : decided(at_most(0, there), known, depth);
    const bool grows_strictly = strictly && !strict_start;
    if (bound.conclusion().kind() == Kind::less) {
      return away_from(x, f, bound, start, grows_strictly, known, depth);
    }
    if (grows_strictly) {
      throw KernelError("it is zero at the end");
    }
    const Formula inside = less(left, right), at_end = equal(left, right), goal = is_positive(f, strictly);
    const Theorem same = is_lower ? Theorem::assume(at_end) : symmetric(Theorem::assume(at_end));
    const Theorem away = away_from(x, f, Theorem::assume(inside), start, false, known, depth);
    return Theorem::consequence(
        {Theorem::discharge(away, inside), Theorem::discharge(Theorem::replace(same, x, goal, start), at_end),
         Theorem::trichotomy(left, right), bound},
        goal);
  }

  // From left < x or x < right, and the start: f(x) is f at the end and a slope between them times the
  // distance.
  Theorem away_from(const Variable& x, const Term& f, const Theorem& apart, const Theorem& start,
                    bool grows_strictly, const Theorems& known, int depth) {
    const Term left = apart.conclusion().parts()[0], right = apart.conclusion().parts()[1];
    const bool is_lower = right == Term(x);
    std::vector<Term> avoid{f, left, right};
    for (const Theorem& one : known) {
      avoid.push_back(one.conclusion());
    }
    const Variable t = fresh(real_number, avoid);
    avoid.emplace_back(t);
    const Variable c = fresh(real_number, avoid);
    const Term function = lambda(t, substitute(f, {{x, t}}));
    const Theorem mean = Theorem::mean_value(
        Theorem::continuity(function, left, right),
        for_every(t, between(left, t, right), Theorem::differentiate(function, t)), apart);
    const Theorem between_them = Theorem::assume(opened(mean.conclusion(), c));
    Theorems more = known;
    for (const Theorem& one : parts_of(part(between_them, 0))) {
      more.push_back(one);
    }
    const Term slope = Theorem::differentiate(function, c).conclusion().parts()[2];
    const Theorem grows = decided(is_positive(is_lower ? slope : -slope, grows_strictly), more, depth);
    const bool strictly = grows_strictly || start.conclusion().kind() == Kind::less;
    return Theorem::choose(
        mean, c,
        Theorem::order(is_positive(f, strictly), {Positive{{start}}, Positive{{grows, apart}}},
                       {{part(between_them, 1), is_lower ? 1 : -1}}));
  }

  // ---- Cuts through the range of a variable

  // x ≤ number or number ≤ x, the best that is known: of x, or of what it is known to lie below or above.
  static std::optional<Theorem> bound(const Variable& x, bool above, const Theorems& known,
                                      int steps = deepest) {
    constexpr long double fine = 0x1p40L, largest = 0x1p20L;
    std::optional<Theorem> best;
    const auto number = [above](const Theorem& one) {
      return one.conclusion().parts()[above ? 1 : 0].value();
    };
    for (const Theorem& one : known) {
      const std::vector<Term>& sides = one.conclusion().parts();
      if (!is_inequality(one.conclusion()) || !(sides[above ? 0 : 1] == Term(x))) {
        continue;
      }
      const Term& end = sides[above ? 1 : 0];
      const auto found = attempt([&] {
        std::vector<Positive> sum{Positive{{one}}};
        Term value = end;
        if (end.kind() == Kind::variable) {
          const auto next =
              steps > 0 ? bound({end.name(), end.type()}, above, known, steps - 1) : std::nullopt;
          sum.push_back(Positive{{next ? *next : throw KernelError("it has no such bound")}});
          value = number(*next);
        } else if (end.kind() != Kind::number) {
          const long double near = estimated(end, {});
          if (!(std::abs(near) < largest)) {
            throw KernelError("it is no number that is known nearly");
          }
          const Rational beside(std::lround(fine * near) + (above ? 1 : -1));
          value = Term(Rational(beside / std::lround(fine)));
          sum.push_back(Positive{{Theorem::sign(above ? less(end, value) : less(value, end))}});
        }
        return Theorem::order(above ? at_most(x, value) : at_most(value, x), sum);
      });
      if (found && (!best || (above ? number(*found) < number(*best) : number(*found) > number(*best)))) {
        best = found;
      }
    }
    return best;
  }

  // In balls, where each variable is known to lie between numbers.
  Theorem in_balls(const Formula& goal, const Theorems& known, int depth) {
    const Term& f = goal.parts()[1];
    Ranges ranges;
    Theorems ends;
    Point low, middle, high;
    for (const Variable& x : f.variables()) {
      const auto lower = bound(x, false, known), upper = lower ? bound(x, true, known) : std::nullopt;
      if (!upper) {
        throw KernelError("it lies between no numbers");
      }
      ends.insert(ends.end(), {*lower, *upper});
      const Rational from = lower->conclusion().parts()[0].value(),
                     to = upper->conclusion().parts()[1].value();
      ranges.emplace(x, Interval{from, to});
      low[x] = from, middle[x] = (from + to) / 2, high[x] = to;
    }
    constexpr long double in_doubt = 1e-9L;
    for (const Point& place : {low, middle, high}) {
      if (!(estimated(f, place) > in_doubt)) {
        throw KernelError("it is zero at an end");
      }
    }
    int left = depth <= 0 ? 1 : 200;
    return cut_all(ends, Theorem::order(goal, {Positive{{on_pieces(f, ranges, left)}}}));
  }

  // 0 < f on these ranges: in balls, or from an end, or on both halves.
  Theorem on_pieces(const Term& f, const Ranges& ranges, int& left) {
    if (const auto theorem = attempt([&] { return Theorem::sign(less(0, f), ranges); })) {
      return *theorem;
    }
    auto widest = ranges.begin();
    const auto width = [](const auto& range) { return Rational(range->second.second - range->second.first); };
    Point place;
    for (auto one = ranges.begin(); one != ranges.end(); ++one) {
      widest = width(one) > width(widest) ? one : widest;
      place[one->first] = (one->second.first.value() + one->second.second.value()) / 2;
    }
    if (--left <= 0 || !(estimated(f, place) > 0)) {
      throw KernelError("it is not decided on so many pieces");
    }
    const auto& [x, range] = *widest;
    if (ranges.size() == 1) {
      const auto from = [&](bool is_lower) { return on_piece(f, widest->first, widest->second, is_lower); };
      if (const auto theorem = first_that_works(std::array{true, false}, from)) {
        return *theorem;
      }
    }
    Ranges before = ranges, after = ranges;
    before.at(x).second = place.at(x);
    after.at(x).first = place.at(x);
    const Theorem first = on_pieces(f, before, left);
    return either_side(first, on_pieces(f, after, left), x, place.at(x));
  }

  // From the end, where f does not fall from its value there to 0 on the way to the other.
  Theorem on_piece(const Term& f, const Variable& x, const Interval& range, bool is_lower) {
    const auto& [l, u] = range;
    const Rational here = is_lower ? l : u, there = is_lower ? u : l;
    const long double value = estimated(f, {{x, here}});
    if (!(value > 0)) {
      throw KernelError("it is not positive at the end");
    }
    const Rational fall = rounded(value, false) / (here - there);
    const Term slope = rate(f, x);
    static_cast<void>(Theorem::sign(is_lower ? less(fall, slope) : less(slope, fall), {{x, range}}));
    const Theorem lower = Theorem::assume(at_most(l, x)), upper = Theorem::assume(at_most(x, u));
    const Theorem above =
        from_end(x, f - fall * (x - there), is_lower ? lower : upper, true, {lower, upper}, 0);
    return Theorem::order(less(0, f), {Positive{{above}}, Positive{{is_lower ? upper : lower}, abs(fall)}});
  }

  // On each side of these.
  static Theorem in_parts(const Term& f, bool strictly, const std::vector<Rational>& places,
                          const Theorems& known) {
    if (places.empty()) {
      throw KernelError("there is no end from which it grows");
    }
    const Variable x = *f.variables().begin();
    std::optional<Theorem> all;
    for (std::size_t k = 0; k <= places.size(); ++k) {
      Theorems more = known;
      if (k > 0) {
        more.push_back(Theorem::assume(at_most(places[k - 1], x)));
      }
      if (k < places.size()) {
        more.push_back(Theorem::assume(at_most(x, places[k])));
      }
      Search search;
      search.is_part_ = true;
      search.work_ /= 4;
      const Theorem one = search.positive(f, strictly, more, deepest);
      all = all ? either_side(*all, one, x, places[k - 1]) : one;
    }
    return *all;
  }

  long work_ = 400000;
  bool is_part_ = false;  // of a range that was cut
};

// a < b or a ≤ b, since what is known contradicts the opposite.
Theorem by_contradiction(const Formula& goal, const Theorems& known) {
  const Term &a = sides_of(goal)[0], &b = sides_of(goal)[1];
  const Formula opposite = goal.kind() == Kind::less ? at_most(b, a) : less(b, a);
  constexpr std::size_t most = 16;
  Theorems more = of_use(
      goal, known, [](const Formula& one) { return one.variables(); }, most);
  more.push_back(Theorem::assume(opposite));
  return Theorem::consequence({impossible(opposite, Search().contradiction(more)), Theorem::trichotomy(a, b)},
                              goal);
}

// f = 0, from f ≤ 0 and 0 ≤ f.
Theorem by_both_sides(const Term& f, const Theorems& known) {
  const auto side = [&](const Formula& goal) {
    const auto found = attempt([&] { return Search().decided(goal, known); });
    return found ? *found : by_contradiction(goal, known);
  };
  return Theorem::consequence({side(at_most(f, 0)), side(at_most(0, f)), Theorem::trichotomy(f, 0)},
                              equal(f, 0));
}

// f = 0, where f² ≤ 0 is known.
Theorem by_square(const Term& f, const Theorems& known) {
  const Theorem square = Search().decided(at_most(power(f, 2), 0), known);
  const Theorem absurd = Theorem::order(at_most(1, 0), {Positive{{square}, 1, inverse(f)}});  // if f is not 0
  return Theorem::consequence(
      {Theorem::discharge(absurd, differ(f, 0)), Theorem::sign(less(0, 1)), Theorem::trichotomy(1, 0)},
      equal(f, 0));
}

// f = 0, where that is a factor of what is known to be zero, and the others have a sign.
Theorem by_factors(const Term& f, const Theorem& known, const Theorems& inequalities) {
  return zero_factor(f, known, [&](const Term& other) {
    const auto sign = first_that_works(std::array{less(0, other), less(other, 0)}, [&](const Formula& goal) {
      return Search().decided(goal, inequalities);
    });
    return sign ? different(*sign) : throw KernelError("no sign is known of " + to_string(other));
  });
}

}  // namespace

Theorem inequality(const Formula& inequality, const std::vector<Theorem>& known) {
  const std::set<Term> letters = letters_of(inequality);
  Theorems in_them;
  std::ranges::copy_if(known, std::back_inserter(in_them), [&](const Theorem& one) {
    return std::ranges::includes(letters, letters_of(one.conclusion()));
  });
  std::optional<std::size_t> tried;
  for (const Theorems& some : {in_them, of_use(inequality, known, letters_of), known}) {
    const bool is_new = !tried || some.size() > *tried;
    tried = some.size();
    if (const auto theorem =
            is_new ? attempt([&] { return Search().decided(inequality, some); }) : std::nullopt) {
      return *theorem;
    }
  }
  const bool is_cut =
      Search::places(gap_of(inequality),
                     of_use(inequality, known, [](const Formula& one) { return one.variables(); }))
          .has_valley;
  // On both sides of a number, for what grows away from there.
  Search search;
  for (const Variable& x : inequality.variables()) {
    for (const int middle : {0, 1, -1}) {
      const Formula before = at_most(x, middle), after = at_most(middle, x);
      const auto is_on = [&](const Formula& side) {
        return attempt([&] { return search.decided(side, known, 0); });
      };
      if (is_cut || !is_bent_along(inequality, x) || is_on(before) || is_on(after)) {
        continue;
      }
      const auto on_side = [&](const Formula& side) {
        Theorems more = known;
        more.push_back(Theorem::assume(side));
        return search.decided(inequality, more);
      };
      if (const auto theorem =
              attempt([&] { return either_side(on_side(before), on_side(after), x, middle); })) {
        return *theorem;
      }
    }
  }
  return by_contradiction(inequality, known);
}

Theorem equation(const Formula& equation, const std::vector<Theorem>& known) {
  const Term gap = gap_of(equation);
  Theorems equations, inequalities;
  for (const Theorem& one : known) {
    (is_inequality(one.conclusion()) ? inequalities : equations).push_back(one);
  }
  auto zero =
      first_that_works(equations, [&](const Theorem& one) { return by_factors(gap, one, inequalities); });
  if (!zero) {
    zero = attempt([&] { return by_both_sides(gap, known); });
  }
  if (!zero) {
    zero = attempt([&] { return by_square(gap, known); });
  }
  if (!zero) {
    throw KernelError("it is no factor of what is known to be zero");
  }
  return Theorem::combination(equation, {{*zero, -1}});
}

}  // namespace stickslip::proofs::tactics
