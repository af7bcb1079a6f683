// A zero of (23) at the data of Fig. 3 that is no orbit.

#include <fmt/format.h>

#include "model/appendix3.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "proofs/tactics/closed.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace kernel;
using namespace tactics;
using methods::Claim;
using methods::Outcome;
using methods::Prover;

namespace {

namespace even {

using namespace symbols::vocabulary;

// A state without z2' that is even about the middle of the stick, from the even rows of
// model/overshooting_closing.hpp: a = lambda_2 P'_1, D = omega_2^2 omega_1 sin(alpha_1), C = V = 0 solve
// even_1, and leave -omega_1 omega_2 times this determinant of even_2; alpha_j = omega_j (tau + tau_1)/2.
const symbols::Term alpha1 = omega1 * (tau + tau1) / 2, alpha2 = omega2 * (tau + tau1) / 2;
const symbols::Term determinant = (lambda2 - lambda1) * cos(T / 2) * sin(alpha1) * sin(alpha2) +
                                  sin(T / 2) * (lambda2 * omega1 * cos(alpha1) * sin(alpha2) -
                                                lambda1 * omega2 * cos(alpha2) * sin(alpha1));
const symbols::Term place = lambda2 * (omega1 * sin(alpha1) * cos(T / 2) + cos(alpha1) * sin(T / 2));
const symbols::Term swing = symbols::power(omega2, 2) * omega1 * sin(alpha1);
const symbols::Term state =
    symbols::column({chi * place + swing * cos(T / 2), place, -swing * sin(T / 2), 0});

}  // namespace even

using Coefficients = model::ClosingCoefficients<Symbolic>;
using Column = std::array<Symbolic, 5>;
using Three = std::array<Term, 3>;

const Variable tau{"tau"}, tau1{"tau1"}, T{"T"}, omega1{"omega1"}, omega2{"omega2"};

// a n1 + b n2 + c n3 in equation i + 1 of (21).
Term without_d(const Coefficients& k, std::size_t i, const Three& n) {
  return (k.a[i] * n[0] + k.b[i] * n[1] + k.c[i] * n[2]).term;
}
Formula line(const Coefficients& k, std::size_t i, const Three& z) {
  return equal((Symbolic(without_d(k, i, z)) + k.d[i]).term, 0);
}
// Entry j of the cross product of two columns' first three.
Symbolic cross(const Column& x, const Column& y, std::size_t j) {
  return x[(j + 1) % 3] * y[(j + 2) % 3] - x[(j + 2) % 3] * y[(j + 1) % 3];
}

// What holds whatever the coefficients are: in letters for these, for a state z, and for a state n that
// solves equations 1, 2, 3, 4 and 5 without their d.
struct InLetters {
  Coefficients k;
  Three n{Variable{"n1"}, Variable{"n2"}, Variable{"n3"}}, z{Variable{"z1"}, Variable{"z2"}, Variable{"z3"}};
  model::CramerDeterminants<Symbolic> delta;

  InLetters() {
    model::each_coefficient(k, [](char letter, int i, Symbolic& one) { one = named(letter, i); });
    delta = model::cramer<Symbolic>(k);
  }
  [[nodiscard]] static Variable named(char letter, int i) { return {fmt::format("{}{}", letter, i)}; }
  // With a state for n, and these coefficients.
  [[nodiscard]] static Theorem at(const Theorem& theorem, const Coefficients& of, const Three& state) {
    Substitution values{{{"n1"}, state[0]}, {{"n2"}, state[1]}, {{"n3"}, state[2]}};
    model::each_coefficient(
        of, [&](char letter, int i, const Symbolic& one) { values.emplace(named(letter, i), one.term); });
    return Theorem::instantiate(theorem, values);
  }

  [[nodiscard]] Multiple solves(std::size_t i, const Symbolic& factor) const {
    return {Theorem::assume(equal(without_d(k, i, n), 0)), factor.term};
  }
  // n2 != 0 ⊢ F_1 = 0 with i = 3, F_2 = 0 with i = 4; Delta = 0.
  [[nodiscard]] Theorem compatible(std::size_t i) const {
    std::vector<Multiple> because{solves(i, delta.Delta2 / n[1])};
    for (std::size_t j = 0; j < 3; ++j) {
      because.push_back(solves(
          j,
          (k.c[i] * cross(k.a, k.d, j) - k.a[i] * cross(k.c, k.d, j) + k.d[i] * cross(k.c, k.a, j)) / n[1]));
    }
    return Theorem::combination(equal(model::compatibility<Symbolic>(k)[i - 3].term, 0), because);
  }
  [[nodiscard]] Theorem singular() const {
    std::vector<Multiple> because;
    for (std::size_t j = 0; j < 3; ++j) {
      because.push_back(solves(j, cross(k.c, k.a, j) / n[1]));
    }
    return Theorem::combination(equal(delta.Delta.term, 0), because);
  }
  // Delta = 0 ⊢ Delta2 = 0 or z does not solve (21).
  [[nodiscard]] Theorem unsolvable() const {
    std::vector<Formula> lines;
    std::vector<Multiple> because{{Theorem::assume(equal(delta.Delta.term, 0)), z[1]}};
    for (std::size_t i = 0; i < 5; ++i) {
      lines.push_back(line(k, i, z));
      if (i < 3) {
        because.push_back({Theorem::assume(lines.back()), cross(k.a, k.c, i).term});
      }
    }
    const Theorem vanishes = cut_all(parts_of(Theorem::assume(all(lines))),
                                     Theorem::combination(equal(delta.Delta2.term, 0), because));
    const Formula none = negation(all(lines));
    return Theorem::consequence({Theorem::discharge(vanishes, all(lines))},
                                any({vanishes.conclusion(), none}));
  }
};

const methods::Example& example() {
  return example_named("O");
}
Term rest(const Term& slip, const Term& overshoot) {
  return Term(2) * pi() / Term(example().data.omega) - slip - overshoot;
}
Substitution with_data(Substitution times) {
  const numeric::motion::ExactParameters& a = example().data;
  times.merge(Substitution{
      {{"omega"}, a.omega}, {{"p"}, a.p}, {{"us"}, a.us}, {{"V"}, a.V}, {{"phi"}, *example().phi}});
  return times;
}
// The coefficients of (21), by their names.
Coefficients coefficients(const Substitution& values) {
  methods::Reader read;
  Coefficients result;
  model::each_coefficient(result, [&](char letter, int i, Symbolic& one) {
    one = substitute(read(symbols::coefficient(letter, i)), values);
  });
  return result;
}
// At the data of Fig. 3.
Coefficients coefficients(const Term& slip, const Term& overshoot, const Term& stick) {
  return coefficients(with_data({{tau, slip}, {tau1, overshoot}, {T, stick}}));
}

// Slip and overshoot last h each, and Delta is zero (22.square): the state of 22.null is then even about the
// end of the slip, too, so that it solves equation 4 without its d.
class Halved {
 public:
  explicit Halved(const orbits::Ranges& ranges) : ranges_(ranges) {
    const Term state = Reader()(even::state);
    for (int i = 0; i < 3; ++i) {
      state_.push_back(entry(state, i));
    }
  }

  // Ranges of omega1 and omega2 ⊢ there are tau and tau1 that solve (23), and no state that solves (21).
  [[nodiscard]] Theorem theorem() {
    const Variable h{"h"};
    const Definition determinant("even_determinant", {omega1, omega2, h}, at(determinant_, h));
    const orbits::AllZeros found = orbits::all_zeros(orbits::differentiable(determinant), {omega1, omega2}, h,
                                                     {4, Rational(81, 20)}, ranges_, {near_zero()});
    const orbits::EnclosedZero& zero = found.zeros.front();
    ranges_[zero.x] = zero.bounds;
    const Theorem there = Theorem::assume(zero.says);
    const Theorem result =
        at_zero(zero.x, Theorem::convert(part(there, 2), equal(at(determinant_, zero.x), 0), {determinant}));
    return Theorem::choose(zero.exists, zero.x, orbits::within_bounds(zero, result));
  }

 private:
  using Reader = methods::Reader;

  // Of terms in tau, tau1 and T.
  [[nodiscard]] static Term at(const Term& term, const Term& h) {
    return substitute(term, with_data({{tau, h}, {tau1, h}, {T, rest(h, h)}}));
  }
  [[nodiscard]] Theorem sign(const Formula& relation) const {
    return orbits::sign_by_parts(relation, ranges_);
  }
  // By halving in floating point.
  [[nodiscard]] Rational near_zero() const {
    const auto value = [&](const Rational& h) {
      Point known;
      for (const auto& [frequency, range] : ranges_) {
        known.emplace(frequency, (range.first + range.second) / 2);
      }
      return estimated(at(determinant_, h), known);
    };
    Rational lower(4), upper(81, 20);
    for (int step = 0; step < 40; ++step) {
      const Rational middle = (lower + upper) / 2;
      (value(middle) * value(lower) > 0 ? lower : upper) = middle;
    }
    return lower;
  }

  // det = 0 ⊢ row i + 1 of the state is zero: it is a multiple of det.
  [[nodiscard]] Theorem solves(std::size_t i, const Term& h, const Theorem& vanishes) const {
    namespace v = symbols::vocabulary;
    const symbols::Term angle = even::alpha2, gap = 2 * v::omega1 / (v::lambda1 - v::lambda2);
    const std::array<symbols::Term, 5> factors{gap * sin(angle), gap * v::lambda2 * sin(angle),
                                               gap * v::omega2 * cos(angle),
                                               v::lambda2 * v::omega1 * v::omega2 / (v::lambda1 - v::lambda2),
                                               gap * v::lambda2 * v::omega2 * cos(angle)};
    // In equation 4 tau is half of tau + tau1, as h is.
    const Substitution halved{{tau1, tau}};
    const Term row = substitute(without_d(coefficients({}), i, {state_[0], state_[1], state_[2]}), halved),
               factor = substitute(Reader()(factors[i]), halved),
               determinant = substitute(determinant_, halved);
    const Formula identity = equal(row, factor * determinant);
    Theorem multiple =
        Theorem::instantiate(Theorem::combination(identity, {}, methods::openings({identity}).all()),
                             with_data({{tau, h}, {T, rest(h, h)}}));
    const Variable a{"a"}, f{"f"}, e{"e"};
    const Theorem product = Theorem::combination(
        equal(a, 0), {{Theorem::assume(equal(a, Term(f) * e))}, {Theorem::assume(equal(e, 0)), f}});
    Theorem result =
        Theorem::instantiate(product, {{a, at(row, h)}, {f, at(factor, h)}, {e, at(determinant_, h)}});
    return Theorem::cut(vanishes, Theorem::cut(without_divisors(multiple), result));
  }
  [[nodiscard]] Theorem without_divisors(const Theorem& theorem) const {
    return settled_by(theorem, [&](const Formula& one) {
      return is_divisor(one) ? std::optional(sign(one)) : std::nullopt;
    });
  }

  [[nodiscard]] Theorem at_zero(const Term& h, const Theorem& vanishes) const {
    const InLetters letters;
    const Coefficients here = coefficients(h, h, rest(h, h));
    const Three state{at(state_[0], h), at(state_[1], h), at(state_[2], h)};
    const auto known = [&](Theorem theorem) {
      theorem = without_divisors(InLetters::at(theorem, here, state));
      for (std::size_t i = 0; i < 5; ++i) {
        theorem = Theorem::cut(solves(i, h, vanishes), theorem);
      }
      return theorem;
    };
    const Theorem singular = known(letters.singular());
    const Theorem either = Theorem::cut(singular, InLetters::at(letters.unsolvable(), here, state));
    Theorem none = Theorem::consequence({either, sign(negation(either.conclusion().parts()[0]))},
                                        either.conclusion().parts()[1]);
    for (auto z = letters.z.rbegin(); z != letters.z.rend(); ++z) {
      none = Theorem::generalize(none, {z->name()});
    }
    const Theorem lasts = sign(less(0, rest(h, h)));
    const Theorem of_h = both({sign(less(0, h)), sign(less(0, h)), lasts, known(letters.compatible(3)),
                               known(letters.compatible(4)), singular, none});
    // The same of tau and tau1, which are h.
    const Term stick = rest(tau, tau1);
    const Coefficients k = coefficients(tau, tau1, stick);
    const auto F = model::compatibility<Symbolic>(k);
    std::vector<Formula> lines;
    for (std::size_t i = 0; i < 5; ++i) {
      lines.push_back(line(k, i, letters.z));
    }
    Formula unsolved = negation(all(lines));
    for (auto z = letters.z.rbegin(); z != letters.z.rend(); ++z) {
      unsolved = for_all({z->name()}, unsolved);
    }
    return there_are({tau, tau1},
                     all({less(0, tau), less(0, tau1), less(0, stick), equal(F[0].term, 0),
                          equal(F[1].term, 0), equal(model::cramer<Symbolic>(k).Delta.term, 0), unsolved}),
                     {{tau, h}, {tau1, h}}, of_h);
  }

  orbits::Ranges ranges_;
  std::vector<Term> state_;  // in tau, tau1 and T, as the determinant
  Term determinant_ = Reader()(even::determinant);
};

}  // namespace

Proofs spurious_zero() {
  return {{"23.spurious", [](Prover&, const Claim&) {
             return proved_by(
                 at_the_data(
                     example(),
                     "where the square in $Delta$ changes sign, and with $tau = tau_1$, the state of 22.null "
                     "solves all of (21) without the $d_i$, so that $F_1 = F_2 = 0$; $Delta_2$ is not zero "
                     "there"),
                 {}, [] {
                   return at_frequencies(
                       example().data.chi, example().data.eta,
                       [](const orbits::Ranges& ranges) { return Halved(ranges).theorem(); });
                 });
           }}};
}

}  // namespace stickslip::proofs::pascal2012
