// (16) as linear equations for z1(0), z2(0) and z1'(0): where their determinant vanishes, and where that is
// an orbit.
#include <fmt/format.h>

#include <optional>

#include "proofs/methods/implications.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/frequencies.hpp"
#include "proofs/pascal2012/symmetric.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace symmetric;

Term diagonal(const Term& a, const Term& b) {
  return block(2, {a, 0, 0, b});
}

const Term alpha1 = omega1 * tau / 2, alpha2 = omega2 * tau / 2, half_T = T / 2;
const Term first = column({1, 0}), belt = column({0, V});
// What stands beside the unknowns and alone: each equation is (a row) (z1(0), z2(0), z1'(0), 1) = 0.
Term rows(const Term& of_place, const Term& of_speed, const Term& load_place, const Term& load_speed) {
  return block(1, {of_place, of_speed * first, of_speed * (belt + load_speed) - of_place * load_place});
}
const Term slip_load = Q * sin(omega * tau / 2), slip_load_speed = Q * omega * cos(omega * tau / 2);
const Term of_16 = block(2, {rows(H1(tau) + I2, H2(tau), slip_load, slip_load_speed),
                             rows(Gamma1(T) + I2, -Gamma2(T), zero(2, 1), zero(2, 1))});

// The halves that are left when the cosines are divided out.
const Term of_halves =
    block(2, {rows(diagonal(omega1 * cos(alpha1), omega2 * cos(alpha2)) * inverse(Lambda),
                   diagonal(sin(alpha1), sin(alpha2)) * inverse(Lambda), slip_load, slip_load_speed),
              rows(diagonal(cos(half_T), 2) * inverse(Sigma), -diagonal(sin(half_T), T) * inverse(Sigma),
                   zero(2, 1), zero(2, 1))});
Term entry_of(const Term& matrix, int row, int column) {
  const auto unit = [](int which) {
    std::vector<Term> entries(4, Term(0));
    entries[static_cast<std::size_t>(which)] = 1;
    return entries;
  };
  return block(1, unit(row)) * matrix * symbols::column(unit(column));
}
const Term unknowns = column({z10, z20, zdot10, 1});

std::vector<Claim> factors() {
  const Term cosines = block(2, {Lambda * diagonal(2 * cos(alpha1) / omega1, 2 * cos(alpha2) / omega2),
                                 zero(2, 2), zero(2, 2), Sigma * diagonal(2 * cos(half_T), 1)});
  const Term common = 8 * (lambda2 - lambda1) / (omega1 * omega2) * cos(alpha1) * cos(alpha2) * cos(half_T);
  return {
      {.id = "16.rows",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(of_16, cosines * of_halves)},
       .words = "each equation of (16), mode by mode, has a cosine for a factor",
       .prove = by_normal_form()},
      {.id = "16.det",
       .kind = Kind::theorem,
       .origin = Origin::new_result,
       .printed = {equation(determinant(of_16), common * determinant(of_halves))},
       .words =
           "the determinant of (16), as equations for $z_1(0)$, $z_2(0)$, $z_1'(0)$, vanishes with each of "
           "$cos(omega_1 tau/2)$, $cos(omega_2 tau/2)$ and $cos(T/2)$, whatever the load, and otherwise "
           "with that of the equations without these factors",
       .prove = by_normal_form()},
  };
}

// The cofactors of the last column: with the unknowns' 1 in the last place they make the determinant.
Term cofactors(const Term& matrix) {
  std::vector<Term> row;
  for (int left_out = 0; left_out < 4; ++left_out) {
    std::vector<Term> entries;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; i != left_out && j < 3; ++j) {
        entries.push_back(entry_of(matrix, i, j));
      }
    }
    const Term minor = determinant(block(3, entries));
    row.push_back(left_out % 2 == 0 ? -minor : minor);
  }
  return block(1, row);
}

std::vector<Claim> necessity() {
  const Term slip = diagonal(omega1 * cos(alpha1) / 2, omega2 * cos(alpha2) / 2) * inverse(Lambda),
             slip_speed = -diagonal(sin(alpha1) / 2, sin(alpha2) / 2) * inverse(Lambda),
             stick = -diagonal(cos(half_T) / 2, 1) * inverse(Sigma),
             stick_speed = diagonal(sin(half_T) / 2, 0) * inverse(Sigma), nothing = zero(2, 2);
  const Assumption slip16{
      "16.slip",
      equation((H1(tau) + I2) * (z0 - slip_load) + H2(tau) * (zdot0 + slip_load_speed), zero(2, 1))},
      stick16{"16.stick", equation((Gamma1(T) + I2) * z0 - Gamma2(T) * zdot0, zero(2, 1))};
  const std::vector<Assumption> orbit{time_lag,  slips_below,      begins,    slip_takes_time,
                                      slip_ends, starts_with_belt, stick_ends};
  return {
      {.id = "16.zeros",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(determinant(of_16), 0)},
       .words = "(16) has solutions only where its determinant vanishes",
       .assumptions = {starts_with_belt, slip16, stick16},
       .prove = by_combination({{{assuming("16.slip"), 0, cofactors(of_16) * column({I2, zero(2, 2)})},
                                 {assuming("16.stick"), 0, cofactors(of_16) * column({zero(2, 2), I2})}}})},
      {.id = "16.halves",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(of_halves * unknowns, zero(4, 1))},
       .words = "(13) and (15) give the equations (16) without the cosines",
       .assumptions = orbit,
       .prove = by_combination({{{from("13.slip"), 0, block(2, {slip, slip_speed, nothing, nothing})},
                                 {assuming("15"), 0, block(2, {nothing, nothing, stick, stick_speed})}}})},
      {.id = "16.orbits",
       .kind = Kind::theorem,
       .origin = Origin::new_result,
       .printed = {equation(determinant(of_halves), 0)},
       .words = "so an orbit needs a zero of the last factor of 16.det: where only a cosine is zero, the "
                "determinant of (16) vanishes and there is no orbit",
       .assumptions = orbit,
       .prove = by_combination({{{from("16.halves"), 0, cofactors(of_halves)}}})},
  };
}

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

Claim at_the_data_of_S() {
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

}  // namespace

std::vector<Claim> determinant_of_16() {
  return joined({factors(), necessity(), {at_the_data_of_S()}});
}

}  // namespace stickslip::proofs::pascal2012
