// Section 4, example S: u_r = 0.1607 is printed among the data of Fig. 2. For a symmetric orbit it is a
// result and another number; at all the printed data there are orbits of slip and stick that do not obey
// (13).
#include <fmt/format.h>

#include <algorithm>

#include "model/symmetric_closing.hpp"
#include "model/waves.hpp"
#include "numeric/words/complete_list.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/frequencies.hpp"
#include "proofs/pascal2012/symmetric.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::motion;
using namespace methods;
namespace words = numeric::words;

namespace {

const Example& printed() {
  return example_named("S");
}

// Where 13.slip leaves the load's phase free (4.lag.needed) the balance of both modes is zero. Of the mode
// j it is a wave in tau.
kernel::Term balance_of(const kernel::Variable& frequency) {
  Reader read;
  const std::map<std::string, symbols::Term> letters{{"omega1", symmetric::omega1},
                                                     {"omega2", symmetric::omega2}};
  return substitute(read(symmetric::balance(letters.at(frequency.name))),
                    {{kernel::Variable{"omega"}, printed().data.omega}});
}
model::Wave<tactics::Symbolic> wave_of(const kernel::Variable& frequency) {
  const tactics::Symbolic omega = kernel::Term(printed().data.omega), omega_j = frequency;
  model::Wave<tactics::Symbolic> wave;
  wave.add((omega_j + omega) / 2, 0, (omega_j - omega) / 2);
  wave.add((omega_j - omega) / 2, 0, (omega_j + omega) / 2);
  return wave;
}

// For all 0 < tau < Theta not both are zero, from the ranges of omega1 and omega2: near 0 the second is
// positive, as it rises from zero; later one of both has a sign in each piece.
kernel::Theorem phase_is_fixed(const orbits::Ranges& ranges) {
  using namespace kernel;
  const Variable tau{"tau"}, omega1{"omega1"}, omega2{"omega2"};
  const Term first = balance_of(omega1), second = balance_of(omega2);
  const Term Theta = Term(2) * pi() / Term(printed().data.omega);
  const Formula goal = negation(all({equal(first, 0), equal(second, 0)}));
  const auto from_sign = [&](const Theorem& inequality) {
    return Theorem::consequence({tactics::different(inequality)}, goal);
  };
  const Rational soon(1, 8), last(11);

  const model::Wave<tactics::Symbolic> falls = model::affine<tactics::Symbolic>(-1, wave_of(omega2), 0);
  const Theorem near_zero = orbits::stays_below(
      {falls, 0, soon, Theorem::combination(equal(orbits::value(falls, 0), 0)), {}}, tau, ranges);
  const Theorem early =
      from_sign(Theorem::order(less(0, second), {Positive{{near_zero}}}));  // 0 < tau, tau <= soon

  orbits::Ranges later = ranges;
  later[tau] = {soon, last};
  const Theorem late = orbits::in_pieces(tau, later, [&](const orbits::Ranges& here) {
    for (const Term& balance : {first, second}) {
      for (const Formula& relation : {less(0, balance), less(balance, 0)}) {
        try {
          return from_sign(Theorem::sign(relation, orbits::ranges_in(balance, here)));
        } catch (const KernelError&) {
          continue;
        }
      }
    }
    throw KernelError("both may be zero at one time");
  });

  const Formula during = between(0, tau, Theta);
  const Theorem before_last = Theorem::order(
      at_most(tau, last),
      {Positive{{tactics::part(Theorem::assume(during), 1)}}, Positive{{Theorem::sign(less(Theta, last))}}});
  const Theorem at_all =
      Theorem::consequence({Theorem::discharge(early, at_most(tau, soon)),
                            Theorem::discharge(late, at_most(soon, tau)), Theorem::trichotomy(tau, soon)},
                           goal);
  return tactics::for_every(
      tau, during,
      Theorem::cut(tactics::part(Theorem::assume(during), 0), Theorem::cut(before_last, at_all)));
}

Claim lag_claim() {
  return {.id = "S.lag",
          .kind = Kind::numbers,
          .origin = Origin::auxiliary,
          .words =
              "at the data of Fig. 2 there is no slip, however long in the period, that leaves the load's "
              "phase free (4.lag.needed): the list of orbits, which has both phases of the time lag, is "
              "that of all orbits that obey (13)",
          .prove = [](Prover&, const Claim&) {
            Outcome outcome = at_the_data(
                printed(),
                "at each time up to $Theta$, $omega_j tan(omega_j tau/2)$ is not $omega tan(omega tau/2)$ "
                "for one of the two $j$, by signs in balls; the load acts on both modes, by 7.modal");
            outcome.uses = {"4.lag.needed", "7.modal"};
            outcome.verdict = Verdict::proved();
            prove(outcome,
                  [] { return at_frequencies(printed().data.chi, printed().data.eta, phase_is_fixed); });
            return outcome;
          }};
}

// The reduced equations (model/symmetric_closing.hpp) have no solution with the printed u_r, for a phase of
// the load, sigma: where their eliminant is not zero there is none, and elsewhere what they say of C bounds
// u_r.
class OtherFriction {
 public:
  OtherFriction(const orbits::Ranges& ranges, int sigma) : ranges_(ranges) {
    using namespace kernel;
    const model::Parameters<Rational>& a = printed().data;
    const auto number = [](const Rational& value) { return Symbolic(Term(value)); };
    const Symbolic chi = number(a.chi), omega = number(a.omega), Theta = Symbolic(2) * Symbolic(pi()) / omega;
    const model::SymmetricData<Symbolic> data{
        chi, model::modes_of<Symbolic>(chi, omega1_, omega2_), number(a.V), omega, number(a.p), Theta, sigma};
    Theta_ = Theta.term;
    const auto Z = model::symmetric_start<Symbolic>(data, tau_, C_);
    ur_ = model::friction_at<Symbolic>({chi, number(a.eta), number(a.us), number(a.V), omega, number(a.p)}, Z,
                                       model::symmetric_phase<Symbolic>(data, pi(), tau_))
              .term;

    // The rows, regular at tau = 0, too: without sin(x)/x.
    domain_ = {tactics::above(0, tau_)};
    for (const Variable& omega_j : {omega1_, omega2_}) {
      Rational below(mpz_class(ranges.at(omega_j).first * 4096), 4096);
      below.canonicalize();
      domain_.push_back(Theorem::sign(less(below, omega_j), {{omega_j, ranges.at(omega_j)}}));
    }
    const auto rows = model::symmetric_rows<Symbolic>(data, tau_);
    for (int j = 0; j < 2; ++j) {
      const Symbolic omega_j = j == 0 ? omega1_ : omega2_;
      const Symbolic beta = omega * tau_ / 2, alpha = omega_j * tau_ / 2;
      const Symbolic regular = (omega * cos(beta) * sin(alpha) - omega_j * sin(beta) * cos(alpha)) /
                               (omega_j * omega_j - omega * omega);
      const Term transfer = model::load_transfer<Symbolic>(omega_j, omega, tau_).term;
      const Theorem same = discharged(Theorem::combination(equal(transfer, regular.term)));
      equations_.push_back(equal((rows.left(j) * C_ - rows.right(j)).term, 0));
      rows_.push_back(tactics::by_rewriting(Theorem::assume(equations_.back()), same));
      left_.push_back(rows.left(j).term);
      right_.push_back(replaced(rows.right(j).term, transfer, regular.term));
    }
    eliminant_ = left_[1] * right_[0] - left_[0] * right_[1];
    vanishes_.push_back(discharged(
        Theorem::combination(equal(eliminant_, 0), {{rows_[0], -left_[1]}, {rows_[1], left_[0]}})));
    const Term slope = (-chi * sin((Theta - tau_) / 2)).term;
    for (std::size_t j = 0; j < 2; ++j) {
      const Term value = substitute(ur_, {{C_, right_[j] / left_[j]}});
      values_.push_back(
          tactics::nonzero(Theorem::combination(equal(ur_, value), {{rows_[j], slope / left_[j]}}), domain_,
                           {differ(left_[j], 0)}));
    }
  }

  // For all 0 < tau < Theta and all C that solve the equations u_r is not in the printed interval.
  [[nodiscard]] kernel::Theorem operator()() const {
    using namespace kernel;
    const Rational last(10472, 1000);  // just beyond Theta
    orbits::Ranges whole = ranges_;
    whole[tau_] = {0, last};
    Theorem result =
        orbits::in_pieces(tau_, whole, [&](const orbits::Ranges& here) { return decided(here); });
    const Formula during = between(0, tau_, Theta_), solved = all(equations_);
    const Theorem since = tactics::part(Theorem::assume(during), 0),
                  until = tactics::part(Theorem::assume(during), 1);
    const std::vector<Theorem> known{
        since, Theorem::order(at_most(0, tau_), {Positive{{since}}}),
        Theorem::order(at_most(tau_, last),
                       {Positive{{until}}, Positive{{Theorem::sign(less(Theta_, last))}}}),
        tactics::part(Theorem::assume(solved), 0), tactics::part(Theorem::assume(solved), 1)};
    for (const Theorem& one : known) {
      result = Theorem::cut(one, result);
    }
    return tactics::for_every(tau_, during, tactics::for_every(C_, solved, result));
  }

 private:
  using Symbolic = tactics::Symbolic;

  [[nodiscard]] kernel::Theorem discharged(const kernel::Theorem& theorem) const {
    return tactics::nonzero(theorem, domain_);
  }
  [[nodiscard]] static std::optional<kernel::Theorem> sign(const kernel::Formula& relation,
                                                           const orbits::Ranges& here) {
    try {
      return kernel::Theorem::sign(relation, orbits::ranges_in(relation, here));
    } catch (const kernel::KernelError&) {
      return std::nullopt;
    }
  }

  // In ranges that are small enough.
  [[nodiscard]] kernel::Theorem decided(const orbits::Ranges& here) const {
    using namespace kernel;
    const Decimal given = printed().result("ur").value;
    const Formula below = less(ur_, given.lower()), above = less(given.upper(), ur_),
                  goal = any({below, above});
    for (const Formula& relation : {less(0, eliminant_), less(eliminant_, 0)}) {
      if (const auto known = sign(relation, here)) {
        return Theorem::consequence({tactics::different(*known), vanishes_[0]}, goal);
      }
    }
    for (std::size_t j = 0; j < 2; ++j) {
      const auto divides = sign(differ(left_[j], 0), here);
      const Term value = values_[j].conclusion().parts()[1];
      for (const Formula& side : {below, above}) {
        const auto known = divides ? sign(replaced(side, ur_, value), here) : std::nullopt;
        if (known) {
          const Rational turn = side == below ? -1 : 1;
          const Theorem bounded =
              tactics::nonzero(Theorem::order(side, {Positive{{*known}}}, {{values_[j], Term(turn)}}),
                               domain_, {differ(left_[j], 0)});
          return Theorem::consequence({Theorem::cut(*divides, bounded)}, goal);
        }
      }
    }
    throw KernelError(fmt::format("some orbit may have this u_r, where tau is between {} and {}",
                                  here.at(tau_).first.get_d(), here.at(tau_).second.get_d()));
  }

  orbits::Ranges ranges_;
  kernel::Variable tau_{"tau"}, C_{"C"}, omega1_{"omega1"}, omega2_{"omega2"};
  kernel::Term Theta_ = 0, ur_ = 0, eliminant_ = 0;
  tactics::Domain domain_;
  std::vector<kernel::Formula> equations_;
  std::vector<kernel::Theorem> rows_, vanishes_, values_;
  std::vector<kernel::Term> left_, right_;
};

kernel::Theorem no_orbit_has_the_printed_friction() {
  return at_frequencies(printed().data.chi, printed().data.eta, [](const orbits::Ranges& ranges) {
    return tactics::both({OtherFriction(ranges, 1)(), OtherFriction(ranges, -1)()});
  });
}

// Fig. 2 gives u_r as a datum, beside the others.
Claim friction_claim() {
  return {.id = "S.data",
          .kind = Kind::theorem,
          .words = "Fig. 2: $u_r = 0.1607$ belongs to the data of a symmetric orbit",
          .prove = [](Prover&, const Claim&) {
            const OrbitList& list = orbits_of(printed()).list;
            const Decimal given = printed().result("ur").value;
            Outcome outcome =
                at_the_data(printed(), "the $u_r$ of each orbit in the complete list, in balls");
            outcome.uses = {"S.list", "S.lag"};
            outcome.verdict = Verdict::undecided("the list is not complete");
            if (!list.complete() || list.orbits.empty()) {
              return outcome;
            }
            const Ball stated = Ball::hull(Ball(given.lower()), Ball(given.upper()));
            if (std::ranges::any_of(list.orbits,
                                    [&](const Orbit& orbit) { return orbit.ur().overlaps(stated); })) {
              outcome.verdict = Verdict::undecided("some orbit may have this u_r");
              return outcome;
            }
            outcome.verdict = Verdict::refuted(Witness{outcome.at,
                                                       {},
                                                       value_of(printed_orbit(printed()), "ur"),
                                                       Ball(given.value),
                                                       "$u_r$ of the orbit",
                                                       "the printed one"});
            prove(outcome, no_orbit_has_the_printed_friction);
            return outcome;
          }};
}

// Z(tau) is not E Z_0.
Verdict not_symmetric(const Motion& motion) {
  const bool slip_first = motion.phases[0].kind == PhaseKind::slip;
  const Phase &slip = motion.phases[slip_first ? 0 : 1], &stick = motion.phases[slip_first ? 1 : 0];
  return (slip.Z(0) + stick.Z(0)).is_nonzero() || (slip.Z(1) + stick.Z(1)).is_nonzero()
             ? Verdict::proved()
             : Verdict::undecided("the places at both ends of the slip may be opposite");
}

Claim asymmetric_claim() {
  return {
      .id = "S.asymmetric",
      .kind = Kind::theorem,
      .origin = Origin::new_result,
      .words =
          "at the data of Fig. 2, $u_r = 0.1607$ included, exactly two orbits of one slip and one stick in "
          "a period of the load exist; they obey every condition, and are not symmetric",
      .prove = [](Prover&, const Claim&) {
        const Rational ur = printed().result("ur").value.value;
        const words::WordList list =
            words::all_orbits({.data = printed().data, .ur = ur, .digits = 20}, words::Word::parse("ST"), 1);
        Outcome outcome = at_the_data(printed(), "exhaustive search in balls; the slips last");
        outcome.at.push_back({"ur", ur});
        std::vector<Verdict> each;
        for (const words::WordOrbit& found : list.orbits) {
          const Motion& motion = found.orbit.motion;
          const auto slip = std::ranges::find(motion.phases, PhaseKind::slip,
                                              [](const Phase& phase) { return phase.kind; });
          outcome.route += (each.empty() ? " " : " and ") + shown(slip->duration);
          each.insert(each.end(), {found.existence, found.orbit.admissible, not_symmetric(motion)});
        }
        outcome.verdict = !list.unresolved.empty() ? Verdict::undecided("the list is not complete")
                          : list.orbits.size() != 2
                              ? Verdict::refuted(fmt::format("there are {}", list.orbits.size()))
                              : all_of(each);
        return outcome;
      }};
}

}  // namespace

std::vector<Claim> data_of_S() {
  return {lag_claim(), friction_claim(), asymmetric_claim()};
}

}  // namespace stickslip::proofs::pascal2012
