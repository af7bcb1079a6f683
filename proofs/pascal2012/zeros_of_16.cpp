// Where the determinant of (16) vanishes at the data of Fig. 2, and where that is an orbit.
#include <fmt/format.h>

#include <optional>

#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/determinant16.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/frequencies.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace determinant16;

// A x = 0 has the solution (x1, x2, x3, 1) where det A = 0, from the cofactors of the last row.
struct Solution {
  std::vector<kernel::Term> x;
  kernel::Theorem solves;  // det A = 0, the last cofactor is not zero ⊢ A x = 0
};
// Of a matrix of four rows, written entry by entry.
Solution solution(const kernel::Term& A) {
  using kernel::Theorem;
  std::vector<kernel::Term> letters, x, unit(4, 0);
  kernel::Substitution values;
  for (const kernel::Term& one : A.parts()) {
    letters.push_back(kernel::Variable{fmt::format("A{}", letters.size())});
    values.emplace(kernel::Variable{letters.back().name()}, one);
  }
  const kernel::Term any = kernel::matrix(4, 4, letters), adjugate = kernel::adjugate(any),
                     last = entry(adjugate, 3, 3);
  for (int k = 0; k < 3; ++k) {
    x.push_back(entry(adjugate, k, 3) / last);
  }
  x.emplace_back(1);
  unit.back() = kernel::Term(1) / last;
  const Theorem generic =
      Theorem::combination(equal(any * kernel::matrix(4, 1, x), zero(kernel::real_matrix(4, 1))),
                           {{Theorem::assume(equal(determinant(any), 0)), kernel::matrix(4, 1, unit)}});
  for (kernel::Term& one : x) {
    one = substitute(one, values);
  }
  return {x, Theorem::instantiate(generic, values)};
}

// The determinants at the data of Fig. 2, T = Theta - tau, from ranges of omega1 and omega2.
class AtTheData {
 public:
  using Formula = kernel::Formula;
  using Theorem = kernel::Theorem;

  AtTheData(const Example& example, const orbits::Ranges& ranges)
      : Theta_(kernel::Term(2) * kernel::pi() / kernel::Term(example.data.omega)),
        data_{{{"T"}, Theta_ - tau_},
              {{"omega"}, example.data.omega},
              {{"p"}, example.data.p},
              {{"V"}, example.data.V}},
        ranges_(ranges) {
    for (const auto& [name, term] : {std::pair{"slip_cosine_1", cos(alpha1)},
                                     {"slip_cosine_2", cos(alpha2)},
                                     {"stick_cosine", cos(half_T)},
                                     {"determinant_without_cosines", determinant(of_halves)},
                                     {"rows_without_cosines", of_halves},
                                     {"determinant_of_16", determinant(of_16)}}) {
      (factors_.size() < 4 ? factors_ : wholes_)
          .emplace_back(name, std::vector<kernel::Variable>{omega_1_, omega_2_, tau_}, read(term));
    }
  }

  // ⊢ there are times at which the determinant of (16) is zero, and it is at no other between 0 and Theta: by
  // 16.det, from numbers near the zeros of each factor. Where a cosine is zero the last factor is not; where
  // that is zero the equations without the cosines have a solution.
  [[nodiscard]] Theorem theorem(const Theorem& factorized, const std::vector<std::vector<Rational>>& nearly) {
    factorized_ = given(Theorem::instantiate(factorized, data_));
    const kernel::Number last(Rational(
        mpz_class(orbits::enclosure(Theta_, {}, Rational(1, 1024)).second.value() * 1024 + 1), 1024));
    std::vector<orbits::EnclosedZero> zeros;
    std::vector<Theorem> parts, cases{one_factor_vanishes()};
    std::vector<Formula> those;
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      const kernel::Variable t{std::string("tau_") + "abcd"[k]};
      const orbits::AllZeros found = orbits::all_zeros(
          orbits::differentiable(factors_[k]), {omega_1_, omega_2_}, t, {0, last}, ranges_, nearly.at(k));
      const Theorem only = Theorem::instantiate(found.only, {{t, tau_}});
      cases.push_back(Theorem::discharge(only, equal(at(factors_[k], tau_), 0)));
      for (const orbits::EnclosedZero& zero : found.zeros) {
        zeros.push_back(zero);
        those.push_back(equal(tau_, zero.x));
        parts.push_back(at_zero(k, zero));
      }
    }
    const Formula during = kernel::between(0, tau_, Theta_), vanishes = determinant_vanishes(tau_);
    const Theorem inside = Theorem::assume(during);
    Theorem all = Theorem::consequence(cases, kernel::any(those));
    all = Theorem::cut(Theorem::order(at_most(0, tau_), {{{tactics::part(inside, 0)}}}), all);
    all = Theorem::cut(Theorem::order(at_most(tau_, last),
                                      {{{tactics::part(inside, 1)}}, {{Theorem::sign(less(Theta_, last))}}}),
                       all);
    parts.push_back(tactics::for_every(tau_, during, Theorem::discharge(all, vanishes)));
    Theorem result = tactics::both(parts);
    for (auto zero = zeros.rbegin(); zero != zeros.rend(); ++zero) {
      result = Theorem::witness(result, exists(zero->x, result.conclusion()), zero->x);
    }
    for (const orbits::EnclosedZero& zero : zeros) {
      result = Theorem::choose(zero.exists, zero.x, result);
    }
    return result;
  }

 private:
  [[nodiscard]] kernel::Term read(const Term& term) const { return substitute(Reader()(term), data_); }
  [[nodiscard]] kernel::Term at(const kernel::Definition& factor, const kernel::Term& tau) const {
    return factor({omega_1_, omega_2_, tau});
  }
  [[nodiscard]] Formula determinant_vanishes(const kernel::Term& tau) const {
    return equal(at(wholes_.back(), tau), 0);
  }
  [[nodiscard]] Theorem sign(const Formula& relation, const orbits::Ranges& ranges) const {
    return Theorem::sign(relation, orbits::ranges_in(relation, ranges));
  }
  // The theorem less what it assumes of the frequencies and of divisors.
  [[nodiscard]] Theorem given(Theorem theorem) const {
    const kernel::Formulas hypotheses = theorem.hypotheses();
    for (const Formula& one : hypotheses) {
      if (tactics::is_divisor(one) || one.kind() == kernel::Kind::less) {
        theorem = Theorem::cut(sign(one, ranges_), theorem);
      }
    }
    return theorem;
  }
  // 16.det in the names of its factors: the determinant is that number times their product.
  struct Factorized {
    kernel::Term number;
    Theorem theorem;
  };
  [[nodiscard]] Factorized in_names(const kernel::Term& tau) const {
    const Theorem here = Theorem::instantiate(*factorized_, {{tau_, tau}});
    const kernel::Term number = read(8 * (lambda2 - lambda1) / (omega1 * omega2));
    kernel::Term product = number;
    for (const kernel::Definition& factor : factors_) {
      product = product * at(factor, tau);
    }
    kernel::Definitions names(factors_.begin(), factors_.end());
    names.insert(wholes_.back());
    return {number, Theorem::convert(here, equal(at(wholes_.back(), tau), product), names)};
  }
  // The determinant is zero ⊢ one of the factors is.
  [[nodiscard]] Theorem one_factor_vanishes() const {
    const Factorized whole = in_names(tau_);
    std::vector<kernel::Term> rest{at(factors_.back(), tau_)};
    for (std::size_t k = factors_.size() - 1; k-- > 0;) {
      rest.push_back(at(factors_[k], tau_) * rest.back());
    }
    std::vector<Theorem> because{given(Theorem::combination(
        equal(rest.back(), 0),
        {{whole.theorem, -(kernel::Term(1) / whole.number)},
         {Theorem::assume(determinant_vanishes(tau_)), kernel::Term(1) / whole.number}}))};
    std::vector<Formula> one;
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      one.push_back(equal(at(factors_[k], tau_), 0));
      if (k + 1 < factors_.size()) {
        because.push_back(tactics::zero_product(at(factors_[k], tau_), rest[factors_.size() - 2 - k]));
      }
    }
    return Theorem::consequence(because, kernel::any(one));
  }

  // What is said of the zero of a factor ⊢ that, that the determinant is zero, and whether it is an orbit's.
  [[nodiscard]] Theorem at_zero(std::size_t factor, const orbits::EnclosedZero& zero) const {
    const Theorem there = Theorem::assume(zero.says), vanishes = tactics::part(there, 2);
    const Factorized whole = in_names(zero.x);
    kernel::Term others = whole.number;
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      others = k == factor ? others : others * at(factors_[k], zero.x);
    }
    const Theorem zero_too =
        given(Theorem::combination(determinant_vanishes(zero.x), {{whole.theorem}, {vanishes, others}}));
    return tactics::both(
        {there, zero_too, factor + 1 < factors_.size() ? no_orbit(zero) : solved(zero, vanishes)});
  }
  [[nodiscard]] orbits::Ranges ranges_with(const orbits::EnclosedZero& zero) const {
    orbits::Ranges here = ranges_;
    here[zero.x] = zero.bounds;
    return here;
  }
  [[nodiscard]] Theorem no_orbit(const orbits::EnclosedZero& zero) const {
    return orbits::within_bounds(zero, sign(differ(at(factors_.back(), zero.x), 0), ranges_with(zero)));
  }
  // There are z1(0), z2(0), z1'(0) that solve the equations without the cosines.
  [[nodiscard]] Theorem solved(const orbits::EnclosedZero& zero, const Theorem& vanishes) const {
    const kernel::Definition& matrix = wholes_.front();
    const kernel::Term nothing = kernel::zero(kernel::real_matrix(4, 1));
    const kernel::Term rows = matrix.unfolded({omega_1_, omega_2_, zero.x});
    const Solution found = solution(rows);
    Theorem result = Theorem::cut(
        Theorem::convert(vanishes, equal(kernel::determinant(rows), 0), {factors_.back()}), found.solves);
    result = Theorem::convert(result, equal(at(matrix, zero.x) * kernel::matrix(4, 1, found.x), nothing),
                              {matrix});
    const kernel::Formulas hypotheses = result.hypotheses();
    for (const Formula& one : hypotheses) {
      if (tactics::is_divisor(one)) {
        result = Theorem::cut(orbits::within_bounds(zero, sign(one, ranges_with(zero))), result);
      }
    }
    const std::vector<kernel::Variable> z{{"z10"}, {"z20"}, {"zdot10"}};
    Formula says = equal(at(matrix, zero.x) * kernel::matrix(4, 1, {z[0], z[1], z[2], 1}), nothing);
    for (std::size_t k = z.size(); k-- > 0;) {
      says = exists(z[k], says);
      kernel::Substitution values;
      for (std::size_t i = 0; i < k; ++i) {
        values.emplace(z[i], found.x[i]);
      }
      result = Theorem::witness(result, substitute(says, values), found.x[k]);
    }
    return result;
  }
  const kernel::Variable tau_{"tau"}, omega_1_{"omega1"}, omega_2_{"omega2"};
  kernel::Term Theta_;
  kernel::Substitution data_;
  const orbits::Ranges& ranges_;
  std::vector<kernel::Definition> factors_, wholes_;  // of the determinant; the rows, and the determinant
  std::optional<Theorem> factorized_;
};

// Odd multiples of a time, between 0 and the period.
std::vector<Ball> odd_multiples(const Ball& unit, const Ball& period) {
  std::vector<Ball> result;
  for (Ball time = unit; (period - time).is_positive(); time += Ball(2) * unit) {
    result.push_back(time);
  }
  return result;
}
// Where each factor vanishes, nearly; the last at the orbits with the time lag itself, not that and a half
// turn.
std::vector<std::vector<Ball>> near_zeros(const Example& example) {
  const model::Modes<Ball> modes = model::modes<Ball>(Ball(example.data.chi), Ball(example.data.eta));
  const Ball period = Ball(2) * Ball::pi() / Ball(example.data.omega),
             half = Ball(example.data.omega) / Ball(2);
  std::vector<std::vector<Ball>> result{odd_multiples(Ball::pi() / modes.omega1, period),
                                        odd_multiples(Ball::pi() / modes.omega2, period),
                                        odd_multiples(Ball::pi(), period),
                                        {}};
  for (Ball& time : result[2]) {
    time = period - time;
  }
  for (const numeric::Orbit& orbit : orbits_of(example).list.orbits) {
    if (sin(orbit.phi() + half * orbit.tau()).is_positive()) {
      result.back().push_back(orbit.tau());
    }
  }
  return result;
}

}  // namespace

Claim zeros_of_16_at_S() {
  return {.id = "S.det",
          .kind = Kind::numbers,
          .origin = Origin::new_result,
          .words =
              "at the data of Fig. 2 the determinant of (16) vanishes at eight $tau$ between 0 and $Theta$; "
              "two are orbits, and at the six others a cosine is zero and there is no orbit",
          .prove = [](Prover& prover, const Claim&) {
            const Example& example = example_named("S");
            const WorkingPrecision precision(128);
            Outcome outcome = at_the_data(
                example, "all zeros of each factor, by signs and slopes in balls; the cosines vanish at");
            outcome.uses = {"16.det", "16.orbits", "S.list"};
            std::vector<std::vector<Rational>> nearly;
            std::size_t all = 0;
            for (const std::vector<Ball>& times : near_zeros(example)) {
              all += times.size();
              nearly.emplace_back();
              for (const Ball& time : times) {
                nearly.back().push_back(orbits::near(time));
                outcome.route += nearly.size() < 4 ? fmt::format(" $tau = {}$;", shown(time)) : "";
              }
            }
            outcome.route += " the other factor is not zero there";
            outcome.verdict = all == 8 && nearly.back().size() == 2
                                  ? Verdict::proved()
                                  : Verdict::undecided(fmt::format("{} zeros are near, {} of them of orbits",
                                                                   all, nearly.back().size()));
            if (outcome.verdict.truth == Truth::proved) {
              prove(outcome, [&] {
                return at_frequencies(example.data.chi, example.data.eta, [&](const orbits::Ranges& ranges) {
                  return AtTheData(example, ranges).theorem(prover.theorem("16.det"), nearly);
                });
              });
            }
            return outcome;
          }};
}

}  // namespace stickslip::proofs::pascal2012
