#include "proofs/pascal2012/examples/symmetric_list.hpp"

#include "model/flows.hpp"
#include "model/nonsticking.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/tactics/closed.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace kernel;
using namespace tactics;

namespace {

const Variable delta{"delta"}, mu{"mu"}, omega1{"omega1"}, omega2{"omega2"}, kappa{"kappa"};

class List {
 public:
  List(const methods::Example& example, const orbits::Ranges& ranges)
      : ranges_(ranges),
        data_(Printed<Symbolic>{example}.data()),
        modes_(model::modes_of<Symbolic>(data_.chi, omega1, omega2)),
        rest_(model::modal_rest<Symbolic>(modes_, model::d0<Symbolic>(data_.chi, data_.us))),
        q2_(model::Q<Symbolic>(data_, modes_)(1)),
        A_((q2_ * data_.omega).term),
        speed_(model::friction_speed<Symbolic>(modes_, rest_, data_.omega, pi(), delta).term) {
    if (example.data.V != 0) {
      throw KernelError("only at V = 0 the first equation is a product");
    }
    const model::Vector2<Symbolic> rows =
        model::two_slips<Symbolic>(data_, modes_, q2_, rest_, pi(), delta, mu);
    for (const int j : {0, 1}) {
      rows_.emplace_back(j == 0 ? "two_slips_row_1" : "two_slips_row_2",
                         std::vector<Variable>{omega1, omega2, delta, mu}, rows(j).term);
    }
  }

  // Ranges of omega1 and omega2 ⊢ there are mu_1, mu_2, …, at which both equations hold with delta = pi/2,
  // and they hold for no other 0 < delta < pi, -pi <= mu <= pi. From numbers near mu.
  Theorem operator()(const std::vector<Rational>& nearly) const {
    const Term quarter = Term(Rational(1, 2)) * pi();
    const orbits::AllZeros found =
        orbits::all_zeros(orbits::differentiable(rows_[1]), {omega1, omega2, quarter}, mu,
                          {Rational(-16, 5), Rational(16, 5)}, ranges_, nearly);
    std::vector<Theorem> parts;
    std::vector<Formula> cases;
    for (const orbits::EnclosedZero& zero : found.zeros) {
      const Formula first = row(0, quarter, zero.x);
      parts.push_back(both({Theorem::assume(zero.says),
                            Theorem::convert(discharged(Theorem::combination(unfold(first, {rows_[0]}))),
                                             first, {rows_[0]})}));
      cases.push_back(equal(mu, zero.x));
    }
    const Formula hold = all({row(0, delta, mu), row(1, delta, mu)}), inside = between(0, delta, pi()),
                  turn = within(-pi(), mu, pi());
    const Theorem holds = Theorem::assume(hold), during = Theorem::assume(inside),
                  where = Theorem::assume(turn);
    // delta = pi/2: and then mu is one of them.
    const Theorem middle = delta_is(quarter, holds, during);
    const Variable place{"place"};
    const auto bounded = [&](const Rational& last, const Theorem& half) {
      return Theorem::order(
          half.conclusion().parts()[0] == Term(mu) ? at_most(mu, last) : at_most(Rational(-last), mu),
          {{{half}}, {{Theorem::sign(less(pi(), last))}}});
    };
    const Theorem only =
        cut_all({Theorem::replace(middle, place, row(1, place, mu), part(holds, 1)),
                 bounded(Rational(16, 5), part(where, 0)), bounded(Rational(16, 5), part(where, 1))},
                found.only);
    const Theorem all_are =
        for_every(delta, inside, for_every(mu, turn, Theorem::discharge(both({middle, only}), hold)));
    parts.push_back(all_are);
    return orbits::there_are(found.zeros, both(parts));
  }

 private:
  [[nodiscard]] Formula row(std::size_t j, const Term& at_delta, const Term& at_mu) const {
    return equal(rows_[j]({omega1, omega2, at_delta, at_mu}), 0);
  }
  [[nodiscard]] Theorem opened_row(std::size_t j, const Theorem& holds) const {
    return Theorem::convert(part(holds, j), unfold(row(j, delta, mu), {rows_[j]}), {rows_[j]});
  }
  [[nodiscard]] Theorem sign(const Formula& relation) const { return orbits::sign(relation, ranges_); }
  [[nodiscard]] Theorem discharged(const Theorem& theorem) const {
    return orbits::without_divisors(theorem, ranges_);
  }

  // The friction's speed at the ends of a phase, times sin(delta), and the load's largest at cos(mu) = kappa.
  [[nodiscard]] Term friction_part() const {
    Symbolic sum;
    for (const int j : {0, 1}) {
      const Symbolic omega_j = j == 0 ? omega1 : omega2, ratio = omega_j / data_.omega;
      const Symbolic lambda_j = j == 0 ? modes_.lambda1 : modes_.lambda2;
      sum += Symbolic(-2) * lambda_j * rest_(j) * omega_j * sin(ratio * delta) *
             sin(ratio * (Symbolic(pi()) - delta)) / sin(ratio * pi());
    }
    return sum.term;
  }
  [[nodiscard]] Term side() const { return friction_part() + Term(kappa) * A_ * kernel::sin(delta); }

  // 0 < delta < pi ⊢ the friction's speed, as the equation has it, times sin(delta).
  [[nodiscard]] Theorem speed_is(const Theorem& during) const {
    const Term sine = kernel::sin(delta), rest = kernel::sin(pi() - delta);
    const Theorem mirrored = Theorem::combination(equal(rest, sine));
    Theorem same = Theorem::reflexive(speed_);  // speed = speed with sin(delta) for sin(pi - delta)
    const Variable place{"place"};
    same = Theorem::replace(mirrored, place, equal(speed_, replaced(speed_, rest, place)), same);
    // In letters: none of the sines need be looked into.
    Term speed = same.conclusion().parts()[1], friction = friction_part();
    Substitution values;
    const auto letter = [&](const Term& value) {
      const Variable name{"s" + std::to_string(values.size() + 1)};
      speed = replaced(speed, value, name);
      friction = replaced(friction, value, name);
      values.emplace(name, value);
      return name;
    };
    const Variable s = letter(sine);
    for (const Variable& omega_j : {omega1, omega2}) {
      const Symbolic ratio = Symbolic(omega_j) / data_.omega;
      for (const Symbolic& angle : {ratio * delta, ratio * (Symbolic(pi()) - delta), ratio * pi()}) {
        static_cast<void>(letter(sin(angle).term));
      }
    }
    const Theorem in_letters = Theorem::combination(equal(speed * s, friction));
    Theorem result = Theorem::instantiate(in_letters, values);
    Domain domain{part(during, 0), part(during, 1),
                  different(detach(Theorem::sine_is_positive(delta), during))};
    for (const Variable& omega_j : {omega1, omega2}) {
      const Rational below = orbits::rounded_down(ranges_.at(omega_j).first, 4096),
                     above = below + Rational(1, 1024);
      domain.push_back(sign(less(below, omega_j)));
      domain.push_back(sign(less(omega_j, above)));
      domain.push_back(sign(differ((sin(Symbolic(omega_j) / data_.omega * pi())).term, 0)));
    }
    result = nonzero(result, domain);
    const Variable other{"speed"};
    return Theorem::replace(symmetric(same), other, equal(Term(other) * sine, friction_part()), result);
  }

  // 0 < delta < pi, both rows ⊢ delta = pi/2.
  [[nodiscard]] Theorem delta_is(const Term& quarter, const Theorem& holds, const Theorem& during) const {
    const Term c = kernel::cos(delta), s = kernel::sin(mu);
    // A is not zero: one of these is.
    const Theorem product =
        discharged(Theorem::combination(equal(s * c, 0), {{opened_row(0, holds), Term(1) / A_}}));
    const Theorem one = detach(zero_product(s, c), product);
    const Theorem vanishes = Theorem::assume(equal(c, 0));
    const Theorem here =
        Theorem::zeros_between(vanishes, Theorem::order(less(Term(0) * pi(), delta), {{{part(during, 0)}}}),
                               Theorem::order(less(delta, Term(1) * pi()), {{{part(during, 1)}}}));
    const Theorem middle =
        Theorem::discharge(Theorem::consequence({here}, equal(delta, quarter)), equal(c, 0));
    // sin(mu) = 0, cos(mu) = 1 or -1: never.
    const Term turned = kernel::cos(mu);
    const Theorem level = Theorem::assume(equal(s, 0));
    const Theorem squares = Theorem::combination(equal((turned - 1) * (turned + 1), 0), {{level, -s}});
    const Theorem sides = detach(zero_product(turned - 1, turned + 1), squares);
    std::vector<Theorem> cases{sides};
    for (const int k : {1, -1}) {
      const Formula at_side = equal(k > 0 ? turned - 1 : turned + 1, 0);
      cases.push_back(Theorem::discharge(vanishes_at(k, at_side, holds, during), at_side));
      cases.push_back(never(k, during));
    }
    const Formula goal = equal(delta, quarter);
    const Theorem otherwise = Theorem::discharge(Theorem::consequence(cases, goal), equal(s, 0));
    return Theorem::consequence({one, middle, otherwise}, goal);
  }

  [[nodiscard]] Definition side_definition() const {
    return {"two_slips_side", {omega1, omega2, kappa, delta}, side()};
  }
  [[nodiscard]] Formula side_vanishes(int k, const Term& at) const {
    return equal(side_definition()({omega1, omega2, k, at}), 0);
  }

  // cos(mu) = k, 0 < delta < pi, the second row ⊢ the side is zero.
  [[nodiscard]] Theorem vanishes_at(int k, const Formula& at_side, const Theorem& holds,
                                    const Theorem& during) const {
    const Variable A{"A"}, c{"c"}, s{"s"}, speed{"speed"}, friction{"friction"};
    const auto assumed = [](const Term& a, const Term& b) { return Theorem::assume(equal(a, b)); };
    const Theorem generic = Theorem::combination(
        equal(Term(friction) + Term(k) * A * s, 0),
        {{assumed(Term(speed) + Term(A) * c, 0), s},
         {assumed(Term(speed) * s, friction), -1},
         {Theorem::assume(equal(k > 0 ? Term(c) - 1 : Term(c) + 1, 0)), -(Term(A) * s)}});
    Theorem result = Theorem::instantiate(generic, {{A, A_},
                                                    {c, kernel::cos(mu)},
                                                    {s, kernel::sin(delta)},
                                                    {speed, speed_},
                                                    {friction, friction_part()}});
    result = cut_all({opened_row(1, holds), speed_is(during), Theorem::assume(at_side)}, result);
    return Theorem::convert(result, side_vanishes(k, delta), {side_definition()});
  }

  // 0 < delta < pi ⊢ the side is not zero: its zeros between -1/8 and 16/5 are 0 and pi.
  [[nodiscard]] Theorem never(int k, const Theorem& during) const {
    const Rational first(-1, 8), last(16, 5);
    const Definition definition = side_definition();
    const orbits::AllZeros found =
        orbits::all_zeros(orbits::differentiable(definition), {omega1, omega2, k}, delta, {first, last},
                          ranges_, {0, orbits::near(Ball::pi())});
    const Variable &x = found.zeros[0].x, &y = found.zeros[1].x;
    const auto is_one_of = [&](const Term& end) {
      const Formula vanishes = side_vanishes(k, end);
      const Theorem zero = Theorem::convert(discharged(Theorem::combination(unfold(vanishes, {definition}))),
                                            vanishes, {definition});
      return cut_all({certainly(at_most(first, end)), certainly(at_most(end, last)), zero},
                     Theorem::instantiate(found.only, {{delta, end}}));
    };
    const Theorem start = Theorem::assume(found.zeros[0].says), end = Theorem::assume(found.zeros[1].says);
    const Theorem positive = part(during, 0), below = part(during, 1);
    const Theorem later =
        Theorem::order(less(0, y), {{{part(end, 0)}}, Positive{{}, found.zeros[1].bounds.first}});
    const Theorem before = Theorem::order(
        less(x, pi()), {{{part(start, 1)}}, {{Theorem::sign(less(found.zeros[0].bounds.second, pi()))}}});
    const Theorem at_start =
        Theorem::consequence({is_one_of(0), Theorem::trichotomy(0, y), later}, equal(0, x));
    const Theorem at_end =
        Theorem::consequence({is_one_of(pi()), Theorem::trichotomy(pi(), x), before}, equal(pi(), y));
    const auto same = [&](const Term& zero, const Formula& conclusion, const Theorem& known) {
      const Formula equation = equal(delta, zero);
      const int turn = conclusion.parts()[0] == Term(delta) ? 1 : -1;
      return Theorem::discharge(
          Theorem::combination(conclusion, {{Theorem::assume(equation), turn}, {known, -turn}}), equation);
    };
    const Theorem only =
        cut_all({Theorem::order(at_most(first, delta), {{{positive}}, Positive{{}, -first}}),
                 Theorem::order(at_most(delta, last), {{{below}}, {{Theorem::sign(less(pi(), last))}}})},
                found.only);
    const Formula vanishes = side_vanishes(k, delta);
    Theorem result =
        Theorem::consequence({Theorem::discharge(only, vanishes), same(x, equal(0, delta), at_start),
                              same(y, equal(delta, pi()), at_end), Theorem::trichotomy(0, delta), positive,
                              Theorem::trichotomy(delta, pi()), below},
                             negation(vanishes));
    for (const orbits::EnclosedZero& zero : found.zeros) {
      result = Theorem::choose(zero.exists, zero.x, result);
    }
    return result;
  }

  const orbits::Ranges& ranges_;
  model::Parameters<Symbolic> data_;
  model::Modes<Symbolic> modes_;
  model::Vector2<Symbolic> rest_;
  Symbolic q2_;
  Term A_, speed_;
  std::vector<Definition> rows_;
};

}  // namespace

ListTheorem list_of_P() {
  return {
      [](const numeric::OrbitList& list) {
        const methods::Example& example = example_named("P");
        std::vector<Rational> nearly;
        for (const numeric::Orbit& orbit : list.orbits) {
          Ball middle = orbit.phi() + Ball(example.data.omega) * orbit.value("tau") / Ball(2);
          if ((middle - Ball::pi()).is_positive()) {
            middle -= Ball(2) * Ball::pi();
          }
          nearly.push_back(orbits::near(middle));
        }
        return at_frequencies(example.data.chi, example.data.eta,
                              [&](const orbits::Ranges& ranges) { return List(example, ranges)(nearly); });
      },
      {"28.reduced", "28.unique"},
      "the two reduced equations (28.reduced) have exactly two solutions $delta = omega tau/2$, $mu$ with "
      "$0 < delta < pi$, $-pi <= mu <= pi$, both at $delta = pi/2$, at frequencies that give the $chi$ "
      "and $eta$ of Fig. 4"};
}

}  // namespace stickslip::proofs::pascal2012
