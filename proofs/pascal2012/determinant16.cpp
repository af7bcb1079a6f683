// (16) as linear equations for z1(0), z2(0) and z1'(0): where their determinant vanishes, and where that is
// an orbit.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/symmetric.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/symbols/point.hpp"
#include "proofs/symbols/sample.hpp"

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

// The determinant of the halves at the data of Fig. 2, as a function of tau in balls.
class Halves {
 public:
  explicit Halves(const numeric::motion::ExactParameters& a)
      : theta_(Rational(2) / a.omega),
        scalars_(nothing_given(),
                 at_point({{"chi", a.chi}, {"eta", a.eta}, {"V", a.V}, {"omega", a.omega}, {"p", a.p}})) {}

  [[nodiscard]] Ball frequency(const char * name) { return scalars_(name); }
  [[nodiscard]] Ball period() const { return Ball(theta_) * Ball::pi(); }
  [[nodiscard]] Ball at(const Ball& time) { return value(function(), time); }

  // How many zeros there are with from < tau/pi < to; nothing where some part of that is not decided.
  [[nodiscard]] std::optional<int> zeros(const Rational& from, const Rational& to, int depth) {
    const Ball all = Ball::hull(Ball(from), Ball(to)) * Ball::pi();
    if (at(all).is_nonzero()) {
      return 0;
    }
    const Ball at_first = at(Ball(from) * Ball::pi()), at_last = at(Ball(to) * Ball::pi());
    if (value(slope(), all).is_nonzero() && at_first.is_nonzero() && at_last.is_nonzero()) {
      return at_first.is_positive() == at_last.is_positive() ? 0 : 1;
    }
    if (depth == 0) {
      return std::nullopt;
    }
    const Rational middle = (from + to) / 2;
    const std::optional<int> below = zeros(from, middle, depth - 1), above = zeros(middle, to, depth - 1);
    const bool counted = below && above && at(Ball(middle) * Ball::pi()).is_nonzero();
    return counted ? std::optional(*below + *above) : std::nullopt;
  }
  [[nodiscard]] std::optional<int> zeros() { return zeros(0, theta_, 20); }

 private:
  static const Replacements& nothing_given() {
    static const Replacements none;
    return none;
  }
  static const Term& function() {
    static const Term f =
        substitute(determinant(of_halves), {{"tau", t}, {"T", 2 * symbols::pi() / omega - t}});
    return f;
  }
  static const Term& slope() {
    static const Term df = derivative(function());
    return df;
  }
  [[nodiscard]] Ball value(const Term& term, const Ball& time) {
    return evaluate<Ball>(term, [&](const std::string& name) { return name == "t" ? time : scalars_(name); })(
        0, 0);
  }

  Rational theta_;  // Theta/pi
  Sample<Ball> scalars_;
};

// The odd multiples of a time between 0 and the period, which is none of them.
std::optional<std::vector<Ball>> odd_multiples(const Ball& unit, const Ball& period) {
  std::vector<Ball> result;
  for (int k = 1;; k += 2) {
    const Ball rest = period - Ball(k) * unit;
    if (!rest.is_nonzero()) {
      return std::nullopt;
    }
    if (rest.is_negative()) {
      return result;
    }
    result.push_back(Ball(k) * unit);
  }
}

// Where one of the cosines of 16.det vanishes; nothing where two of these times may be one.
std::optional<std::vector<Ball>> zeros_of_cosines(Halves& halves) {
  const Ball period = halves.period();
  std::vector<Ball> result;
  for (const char * name : {"omega1", "omega2", "T"}) {
    const bool of_the_stick = std::string(name) == "T";
    const auto times = odd_multiples(of_the_stick ? Ball::pi() : Ball::pi() / halves.frequency(name), period);
    if (!times) {
      return std::nullopt;
    }
    for (const Ball& time : *times) {
      const Ball tau_there = of_the_stick ? period - time : time;
      for (const Ball& other : result) {
        if (other.overlaps(tau_there)) {
          return std::nullopt;
        }
      }
      result.push_back(tau_there);
    }
  }
  return result;
}

// The orbits with the time lag itself, not that and a half turn.
std::ptrdiff_t orbits_with_the_lag(const Example& example) {
  const Ball half = Ball(example.data.omega) / Ball(2);
  return std::ranges::count_if(orbits_of(example).list.orbits, [&](const numeric::Orbit& orbit) {
    return sin(orbit.phi() + half * orbit.tau()).is_positive();
  });
}

Claim at_the_data_of_S() {
  return {.id = "S.det",
          .kind = Kind::numbers,
          .origin = Origin::new_result,
          .words =
              "at the data of Fig. 2 the determinant of (16) vanishes at eight $tau$ between 0 and $Theta$; "
              "two are orbits, and at the six others a cosine is zero and there is no orbit",
          .prove = [](Prover&, const Claim&) {
            const Example& example = example_named("S");
            const WorkingPrecision precision(128);
            Outcome outcome = at_the_data(
                example,
                "the zeros of each factor counted in balls, by signs and slopes; the cosines vanish at");
            outcome.uses = {"16.det", "16.orbits", "S.list"};
            outcome.verdict = Verdict::undecided("the zeros are not all told apart");
            Halves halves(example.data);
            const auto of_cosines = zeros_of_cosines(halves);
            const std::optional<int> others = halves.zeros();
            if (!of_cosines || !others) {
              return outcome;
            }
            bool no_orbit = true;
            for (const Ball& time : *of_cosines) {
              no_orbit = no_orbit && halves.at(time).is_nonzero();
              outcome.route += fmt::format(" $tau = {}$;", shown(time));
            }
            outcome.route += " the other factor is not zero there";
            const auto orbits = orbits_with_the_lag(example);
            if (no_orbit && orbits_of(example).list.complete()) {
              outcome.verdict =
                  of_cosines->size() == 6 && *others == 2 && orbits == 2
                      ? Verdict::proved()
                      : Verdict::refuted(fmt::format("there are {} zeros of cosines, {} others and {} orbits",
                                                     of_cosines->size(), *others, orbits));
            }
            return outcome;
          }};
}

}  // namespace

std::vector<Claim> determinant_of_16() {
  return joined({factors(), necessity(), {at_the_data_of_S()}});
}

}  // namespace stickslip::proofs::pascal2012
