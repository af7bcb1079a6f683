// Where the determinant of (16) vanishes at the data of Fig. 2, and where that is an orbit.
#include <fmt/format.h>

#include <optional>

#include "core/transformed.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/examples/symmetric_list.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace symbols::vocabulary;

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

// The last factor without matrices, short for Coq: z2(0) = T V/2, and the slip's equations are scaled by
// lambda2 - lambda1. Its rows are (z1(0), z1'(0), 1) as they stand here.
struct Row {
  Term place, speed, alone;
};
struct LastFactor {
  Row first, second, stick;
  Term value = stick.place * (first.speed * second.alone - second.speed * first.alone) -
               stick.speed * (first.place * second.alone - second.place * first.alone) +
               stick.alone * (first.place * second.speed - second.place * first.speed);
  // The first slip's equation and the stick's give z1(0) and z1'(0), if this is not zero.
  Term divisor = stick.place * first.speed - stick.speed * first.place;
  Term z1 = (first.alone * stick.speed - stick.alone * first.speed) / divisor,
       zdot1 = (stick.alone * first.place - first.alone * stick.place) / divisor;
};
LastFactor last_factor() {
  const Term sine = sin(omega * tau / 2), cosine = cos(omega * tau / 2), way = T * V / 2;
  const Term load1 = lambda2 * q1 - q2, load2 = q2 - lambda1 * q1;
  const Term place1 = omega1 * cos(alpha1), place2 = omega2 * cos(alpha2);
  return {.first = {place1 * lambda2, sin(alpha1) * lambda2,
                    sin(alpha1) * (omega * cosine * load1 - V) - place1 * (sine * load1 + way)},
          .second = {-(place2 * lambda1), -(sin(alpha2) * lambda1),
                     sin(alpha2) * (omega * cosine * load2 + V) - place2 * (sine * load2 - way)},
          .stick = {cos(half_T), -sin(half_T), chi * (V * sin(half_T) - cos(half_T) * way)}};
}

// Those that stand in the term itself.
kernel::Definitions definitions_in(const kernel::Term& term) {
  if (term.kind() == kernel::Kind::defined) {
    return {term.definition()};
  }
  kernel::Definitions found;
  for (const kernel::Term& part : term.parts()) {
    found.merge(definitions_in(part));
  }
  return found;
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
                                     {"last_factor", last_.value},
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
    factorized_ = given(Theorem::instantiate(with_last_factor(factorized), data_));
    const Rational last = orbits::above(Theta_, {});
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
    const Theorem all = tactics::cut_all(
        {Theorem::order(at_most(0, tau_), {{{tactics::part(inside, 0)}}}),
         Theorem::order(at_most(tau_, last),
                        {{{tactics::part(inside, 1)}}, {{Theorem::sign(less(Theta_, last))}}})},
        Theorem::consequence(cases, kernel::any(those)));
    parts.push_back(tactics::for_every(tau_, during, Theorem::discharge(all, vanishes)));
    return orbits::there_are(zeros, tactics::both(parts));
  }

 private:
  [[nodiscard]] kernel::Term read(const Term& term) const { return substitute(Reader()(term), data_); }
  [[nodiscard]] kernel::Term at(const kernel::Definition& factor, const kernel::Term& tau) const {
    return factor({omega_1_, omega_2_, tau});
  }
  [[nodiscard]] Formula determinant_vanishes(const kernel::Term& tau) const {
    return equal(at(wholes_.back(), tau), 0);
  }
  // The theorem less what it assumes of the frequencies and of divisors.
  [[nodiscard]] Theorem given(const Theorem& theorem) const {
    return tactics::settled_by(theorem, [&](const Formula& one) {
      return tactics::is_divisor(one) || one.kind() == kernel::Kind::less
                 ? std::optional(orbits::sign(one, ranges_))
                 : std::nullopt;
    });
  }
  // The determinant by its last factor without matrices.
  [[nodiscard]] Theorem with_last_factor(const Theorem& factorized) const {
    const kernel::Variable whole{"a"}, cosines{"b"}, halves{"c"}, last{"d"};
    const Theorem generic =
        Theorem::combination(equal(whole, kernel::Term(cosines) * last),
                             {{Theorem::assume(equal(whole, kernel::Term(cosines) * halves))},
                              {Theorem::assume(equal(halves, last)), cosines}});
    const kernel::Term product = factorized.conclusion().parts()[1];
    const Theorem shorter = Theorem::combination(
        equal(product.parts()[1], Reader()(scale_) * Reader()(last_.value)), {}, opened_);
    return Theorem::cut(
        shorter,
        Theorem::cut(factorized, Theorem::instantiate(generic, {{whole, factorized.conclusion().parts()[0]},
                                                                {cosines, product.parts()[0]},
                                                                {halves, product.parts()[1]},
                                                                {last, shorter.conclusion().parts()[1]}})));
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
    for (std::size_t k = 0; k + 1 < factors_.size(); ++k) {
      product = product * at(factors_[k], tau);
    }
    const kernel::Term scale = read(scale_);
    product = product * (scale * at(factors_.back(), tau));
    kernel::Definitions names(factors_.begin(), factors_.end());
    names.insert(wholes_.back());
    return {number * scale, Theorem::convert(here, equal(at(wholes_.back(), tau), product), names)};
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
    return orbits::within_bounds(zero,
                                 orbits::sign(differ(at(factors_.back(), zero.x), 0), ranges_with(zero)));
  }
  // There are z1(0), z2(0), z1'(0) that solve the equations without the cosines.
  [[nodiscard]] Theorem solved(const orbits::EnclosedZero& zero, const Theorem& vanishes) const {
    const kernel::Definition& matrix = wholes_.front();
    const kernel::Term nothing = kernel::zero(kernel::real_matrix(4, 1));
    const auto here = [&](const Term& term) { return substitute(read(term), {{tau_, zero.x}}); };
    const kernel::Term unit = kernel::matrix(4, 1, {0, Reader()(1 / (delta_ * last_.divisor)), 0, 0});
    const std::vector<Term> solution{last_.z1, T * V / 2, last_.zdot1};
    const Theorem generic = Theorem::combination(
        equal(Reader()(of_halves * column({solution[0], solution[1], solution[2], 1})), nothing),
        {{Theorem::assume(equal(Reader()(last_.value), 0)), unit}}, opened_);
    Theorem result = Theorem::instantiate(Theorem::instantiate(generic, data_), {{tau_, zero.x}});
    result = Theorem::cut(Theorem::convert(vanishes, equal(here(last_.value), 0), {factors_.back()}), result);
    const std::vector<kernel::Term> x = transformed(solution, here);
    result = Theorem::convert(
        result, equal(at(matrix, zero.x) * kernel::matrix(4, 1, {x[0], x[1], x[2], 1}), nothing), {matrix});
    result = tactics::settled_by(result, [&](const Formula& one) {
      return tactics::is_divisor(one)
                 ? std::optional(orbits::within_bounds(zero, orbits::sign(one, ranges_with(zero))))
                 : std::nullopt;
    });
    const std::vector<kernel::Variable> z{{"z10"}, {"z20"}, {"zdot10"}};
    const Formula says = equal(at(matrix, zero.x) * kernel::matrix(4, 1, {z[0], z[1], z[2], 1}), nothing);
    return tactics::there_are(z, says, {{z[0], x[0]}, {z[1], x[1]}, {z[2], x[2]}}, result);
  }
  const LastFactor last_ = last_factor();
  // Of the determinant without cosines, in parts of that factor.
  const Term delta_ = lambda2 - lambda1, scale_ = 2 / power(delta_, 2);
  // These are looked into where that is seen.
  const kernel::Definitions opened_ = definitions_in(Reader()(of_halves));
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
  const Ball period = Ball(2) * Ball::pi() / Ball(example.data.omega);
  std::vector<std::vector<Ball>> result{odd_multiples(Ball::pi() / modes.omega1, period),
                                        odd_multiples(Ball::pi() / modes.omega2, period),
                                        odd_multiples(Ball::pi(), period),
                                        {}};
  for (Ball& time : result[2]) {
    time = period - time;
  }
  for (const numeric::Orbit& orbit : orbits_of(example).list.orbits) {
    if (!has_the_other_phase(orbit)) {
      result.back().push_back(orbit.tau());
    }
  }
  return result;
}

Outcome zeros_of_the_determinant(Prover& prover, const Claim&) {
  const Example& example = example_named("S");
  const WorkingPrecision precision(128);
  Outcome outcome =
      at_the_data(example, "all zeros of each factor, by signs and slopes in balls; the cosines vanish at");
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
                        : Verdict::undecided(fmt::format("{} zeros are near, {} of them of orbits", all,
                                                         nearly.back().size()));
  prove(outcome, [&] {
    return at_frequencies(example.data.chi, example.data.eta, [&](const orbits::Ranges& ranges) {
      return AtTheData(example, ranges).theorem(prover.theorem("16.det"), nearly);
    });
  });
  return outcome;
}

}  // namespace

Proofs zeros_of_16_at_S() {
  return {{"S.det", zeros_of_the_determinant}};
}

}  // namespace stickslip::proofs::pascal2012
