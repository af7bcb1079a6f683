#include "proofs/pascal2012/examples/symmetric_list.hpp"

#include <fmt/format.h>

#include "core/transformed.hpp"
#include "model/symmetric.hpp"
#include "model/waves.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace kernel;
using namespace tactics;

namespace {

model::SymmetricData<Symbolic> data_of(const SymmetricEquations& e) {
  const model::Parameters<Symbolic> a = Printed<Symbolic>{e.example}.data();
  return {{a, model::modes_of<Symbolic>(a.chi, e.omega1, e.omega2), Symbolic(2) * Symbolic(pi()) / a.omega},
          e.sigma};
}

// A row, left C = B + k T with the load's transfer T, and times D = omega_j^2 - omega^2 without a divisor:
// D left C = D B + k N, as D T = N.
struct Row {
  Term left, B, k, T, D, N;

  [[nodiscard]] Term scaled_left() const { return D * left; }
  [[nodiscard]] Term scaled_right() const { return D * B + k * N; }
  [[nodiscard]] Row at(const Substitution& values) const {
    const auto here = [&](const Term& term) { return substitute(term, values); };
    return {here(left), here(B), here(k), here(T), here(D), here(N)};
  }
  [[nodiscard]] Formula formula(const Term& C) const { return equal(left * C - (B + k * T), 0); }
  [[nodiscard]] Formula scaled(const Term& C) const { return equal(scaled_left() * C - scaled_right(), 0); }
};

std::vector<Row> rows_of(const SymmetricEquations& e) {
  const model::SymmetricData<Symbolic> data = data_of(e);
  const Symbolic tau = e.tau, omega = data.omega;
  const auto rows = model::symmetric_rows<Symbolic>(data, tau);
  std::vector<Row> result;
  for (const int j : {0, 1}) {
    const Symbolic omega_j = j == 0 ? e.omega1 : e.omega2, beta = omega * tau / 2, alpha = omega_j * tau / 2;
    const Term right = rows.right(j).term;
    result.push_back({rows.left(j).term, right.parts().at(0), right.parts().at(1).parts().at(0),
                      right.parts().at(1).parts().at(1), (omega_j * omega_j - omega * omega).term,
                      (omega * cos(beta) * sin(alpha) - omega_j * sin(beta) * cos(alpha)).term});
    const Row& row = result.back();
    if (row.B + row.k * row.T != right) {
      throw KernelError("the reduced equations have another form");
    }
  }
  return result;
}

// What holds of all numbers, in letters: no step is longer than they are.
struct InLetters {
  Variable left{"left"}, B{"B"}, k{"k"}, T{"T"}, D{"D"}, N{"N"}, C{"C"}, L{"L"}, R{"R"}, L_{"L_"}, R_{"R_"};

  [[nodiscard]] Row row() const { return {left, B, k, T, D, N}; }
  [[nodiscard]] Substitution values(const Row& row, const Term& at_C) const {
    return {{left, row.left}, {B, row.B}, {k, row.k}, {T, row.T}, {D, row.D}, {N, row.N}, {C, at_C}};
  }
  [[nodiscard]] Formula transfer() const { return equal(Term(D) * T, N); }
  // A row and its transfer give it scaled, and back where D is not zero.
  [[nodiscard]] Theorem scaled(const Row& at, const Term& at_C) const {
    const Theorem generic = Theorem::combination(
        row().scaled(C), {{Theorem::assume(row().formula(C)), D}, {Theorem::assume(transfer()), k}});
    return Theorem::instantiate(generic, values(at, at_C));
  }
  [[nodiscard]] Theorem unscaled(const Row& at, const Term& at_C) const {
    const Theorem generic = Theorem::combination(
        row().formula(C),
        {{Theorem::assume(row().scaled(C)), Term(1) / D}, {Theorem::assume(transfer()), -(Term(k) / D)}});
    return Theorem::instantiate(generic, values(at, at_C));
  }

  [[nodiscard]] Theorem instance(const Theorem& generic, const Row& one, const Row& other,
                                 const Term& at_C) const {
    return Theorem::instantiate(generic, {{L, one.scaled_left()},
                                          {R, one.scaled_right()},
                                          {L_, other.scaled_left()},
                                          {R_, other.scaled_right()},
                                          {C, at_C}});
  }
  [[nodiscard]] Formula holds(const Term& of_L, const Term& of_R, const Term& at) const {
    return equal(of_L * at - of_R, 0);
  }
  // Both rows scaled give L_ R - L R_ = 0.
  [[nodiscard]] Theorem eliminated(const Row& one, const Row& other, const Term& at_C) const {
    return instance(Theorem::combination(equal(Term(L_) * R - Term(L) * R_, 0),
                                         {{Theorem::assume(holds(L, R, C)), -Term(L_)},
                                          {Theorem::assume(holds(L_, R_, C)), L}}),
                    one, other, at_C);
  }
  // L ≠ 0 ⊢ the row is solved by R/L; L ≠ 0, L_ R - L R_ = 0 ⊢ so is the other; L ≠ 0, L C - R = 0 ⊢ C = R/L.
  [[nodiscard]] Theorem solves(const Row& one, const Row& other) const {
    return instance(Theorem::combination(holds(L, R, Term(R) / L)), one, other, 0);
  }
  [[nodiscard]] Theorem solves_other(const Row& one, const Row& other) const {
    return instance(
        Theorem::combination(holds(L_, R_, Term(R) / L),
                             {{Theorem::assume(equal(Term(L_) * R - Term(L) * R_, 0)), Term(1) / L}}),
        one, other, 0);
  }
  [[nodiscard]] Theorem is_solution(const Row& one, const Row& other, const Term& at_C) const {
    return instance(
        Theorem::combination(equal(C, Term(R) / L), {{Theorem::assume(holds(L, R, C)), Term(1) / L}}), one,
        other, at_C);
  }
};

class List {
 public:
  List(const SymmetricEquations& e, int phase, const orbits::Ranges& ranges)
      : e_(e),
        phase_(phase),
        ranges_(ranges),
        eliminant_("symmetric_eliminant", {e.omega1, e.omega2, e.sigma, e.tau}, eliminant(rows_of(e))),
        arguments_{e.omega1, e.omega2, phase} {
    Domain domain{above(0, e.tau)};
    for (const Variable& omega_j : {e.omega1, e.omega2}) {
      domain.push_back(
          orbits::sign(less(orbits::rounded_down(ranges.at(omega_j).first, 4096), omega_j), ranges));
    }
    for (const Row& row : rows_of(e)) {
      transfers_.push_back(nonzero(Theorem::combination(equal(row.D * row.T, row.N)), domain));
      rows_.push_back(row.at({{e.sigma, phase}}));
    }
  }

  SymmetricList operator()(const std::vector<Rational>& nearly) {
    const Rational last = orbits::above(e_.Theta, ranges_);
    const orbits::AllZeros found =
        orbits::all_zeros(orbits::differentiable(eliminant_), arguments_, e_.tau, {0, last}, ranges_, nearly);
    SymmetricList result{{}, {}, {}, found.only};
    std::vector<Term> amplitudes;
    std::vector<Theorem> parts, same;
    for (const orbits::EnclosedZero& zero : found.zeros) {
      const Variable C{fmt::format("{}_{}", e_.C.name, result.tau.size() + 1)};
      const Solution solution = at(zero);
      result.tau.push_back(zero.x);
      result.C.push_back(C);
      amplitudes.push_back(solution.C);
      parts.push_back(solution.says);
      result.says.push_back(replaced(solution.says.conclusion(), solution.C, C));
      same.push_back(solution.is_it);
    }
    parts.push_back(all_are(found, amplitudes, same));
    // There are all these.
    std::vector<Formula> said = result.says;
    said.push_back(conclusion(result));
    std::vector<Variable> names;
    Substitution values;
    for (std::size_t k = 0; k < amplitudes.size(); ++k) {
      names.insert(names.end(), {result.tau[k], result.C[k]});
      values.emplace(result.C[k], amplitudes[k]);
    }
    result.theorem = there_are(names, all(said), values, both(parts));
    for (const orbits::EnclosedZero& zero : found.zeros) {
      result.theorem = Theorem::choose(zero.exists, zero.x, result.theorem);
    }
    return result;
  }

 private:
  struct Solution {
    Term C;
    Theorem says;   // from what is said of tau's zero: where tau and C lie, and the rows
    Theorem is_it;  // the rows at this tau ⊢ the C is that
  };

  [[nodiscard]] static Term eliminant(const std::vector<Row>& rows) {
    return rows[1].scaled_left() * rows[0].scaled_right() - rows[0].scaled_left() * rows[1].scaled_right();
  }
  [[nodiscard]] Formula vanishes(const Term& tau) const {
    std::vector<Term> arguments = arguments_;
    arguments.push_back(tau);
    return equal(eliminant_(arguments), 0);
  }
  [[nodiscard]] Formula rows_hold(const Term& tau, const Term& C) const { return e_.hold(phase_, tau, C); }
  // 0 < tau ⊢ D T = N.
  [[nodiscard]] Theorem transfer(std::size_t j, const Term& tau) const {
    return Theorem::instantiate(transfers_[j], {{e_.tau, tau}});
  }
  // 0 < tau, rows at tau ⊢ the row scaled.
  [[nodiscard]] Theorem scaled(std::size_t j, const Term& tau, const Term& C) const {
    const Row row = rows_[j].at({{e_.tau, tau}});
    const Theorem holds =
        Theorem::convert(part(Theorem::assume(rows_hold(tau, C)), j), row.formula(C), {e_.rows[j]});
    return Theorem::cut(transfer(j, tau), Theorem::cut(holds, letters_.scaled(row, C)));
  }

  [[nodiscard]] Solution at(const orbits::EnclosedZero& zero) const {
    orbits::Ranges here = ranges_;
    here[zero.x] = zero.bounds;
    const std::vector<Row> rows{rows_[0].at({{e_.tau, zero.x}}), rows_[1].at({{e_.tau, zero.x}})};
    const auto differs = [&](const Term& term) { return orbits::sign(differ(term, 0), here); };
    for (const std::size_t j : {0, 1}) {
      const Term left = rows[j].scaled_left();
      try {
        const Theorem divides = differs(left);
        const Term C = rows[j].scaled_right() / left;
        const orbits::Known known = orbits::bounded(C, here, 20);
        return {C, says(zero, rows, j, known, divides),
                Theorem::cut(divides, Theorem::cut(scaled(j, zero.x, e_.C),
                                                   letters_.is_solution(rows[j], rows[1 - j], e_.C)))};
      } catch (const KernelError&) {
        if (j == 1) {
          throw;
        }
      }
    }
    throw KernelError("no row gives C");
  }

  [[nodiscard]] Theorem says(const orbits::EnclosedZero& zero, const std::vector<Row>& rows, std::size_t j,
                             const orbits::Known& known, const Theorem& divides) const {
    const Theorem there = Theorem::assume(zero.says);
    // That the eliminant is zero, written out as that of these two rows.
    const Theorem eliminated = part(there, 2);
    const Term cross = rows[1 - j].scaled_left() * rows[j].scaled_right() -
                       rows[j].scaled_left() * rows[1 - j].scaled_right();
    Theorem crossed = Theorem::convert(eliminated, equal(eliminant(rows), 0), {eliminant_});
    if (j == 1) {
      const Variable a{"a"}, b{"b"};
      crossed = Theorem::cut(
          crossed, Theorem::instantiate(Theorem::combination(equal(Term(b) - a, 0),
                                                             {{Theorem::assume(equal(Term(a) - b, 0)), -1}}),
                                        {{a, rows[1].scaled_left() * rows[0].scaled_right()},
                                         {b, rows[0].scaled_left() * rows[1].scaled_right()}}));
    }
    if (crossed.conclusion() != equal(cross, 0)) {
      throw KernelError("the eliminant has another form");
    }
    std::vector<Theorem> solved(2, divides);
    solved[j] = letters_.solves(rows[j], rows[1 - j]);
    solved[1 - j] = Theorem::cut(crossed, letters_.solves_other(rows[j], rows[1 - j]));
    std::vector<Theorem> parts{part(there, 0), part(there, 1), known.lower, known.upper};
    for (std::size_t i = 0; i < 2; ++i) {
      const Theorem row = cut_all({Theorem::cut(divides, solved[i]),
                                   orbits::sign(differ(rows[i].D, 0), ranges_), transfer(i, zero.x)},
                                  letters_.unscaled(rows[i], known.value));
      parts.push_back(Theorem::convert(row, rows_hold(zero.x, known.value).parts()[i], {e_.rows[i]}));
    }
    return within_bounds(zero, both(parts));
  }

  // What is said of the zero in place of its bounds, and 0 < tau.
  [[nodiscard]] static Theorem within_bounds(const orbits::EnclosedZero& zero, const Theorem& theorem) {
    const Theorem there = Theorem::assume(zero.says);
    return Theorem::cut(
        Theorem::order(less(0, zero.x), {{{part(there, 0)}}, Positive{{}, zero.bounds.first}}),
        orbits::within_bounds(zero, theorem));
  }

  [[nodiscard]] Formula every(const Formula& goal) const {
    return for_all(
        e_.tau, implies(between(0, e_.tau, e_.Theta), for_all(e_.C, implies(rows_hold(e_.tau, e_.C), goal))));
  }
  [[nodiscard]] Formula goal(const std::vector<Term>& tau, const std::vector<Term>& C) const {
    std::vector<Formula> cases;
    for (std::size_t k = 0; k < tau.size(); ++k) {
      cases.push_back(all({equal(e_.tau, tau[k]), equal(e_.C, C[k])}));
    }
    return cases.size() == 1 ? cases.front() : any(cases);
  }
  [[nodiscard]] Formula conclusion(const SymmetricList& list) const {
    return every(goal({list.tau.begin(), list.tau.end()}, {list.C.begin(), list.C.end()}));
  }

  // From what is said of the zeros: for all tau, C ….
  [[nodiscard]] Theorem all_are(const orbits::AllZeros& found, const std::vector<Term>& amplitudes,
                                const std::vector<Theorem>& same) const {
    const Formula during = between(0, e_.tau, e_.Theta), holds = rows_hold(e_.tau, e_.C);
    const Theorem solved = Theorem::assume(holds), inside = Theorem::assume(during);
    std::vector<Term> taus;
    std::vector<Theorem> because;
    const Theorem zero = cut_all(
        {scaled(0, e_.tau, e_.C), scaled(1, e_.tau, e_.C)},
        Theorem::convert(letters_.eliminated(rows_[0], rows_[1], e_.C), vanishes(e_.tau), {eliminant_}));
    because.push_back(Theorem::cut(zero, found.only));
    for (std::size_t k = 0; k < same.size(); ++k) {
      const Variable& x = found.zeros[k].x;
      taus.emplace_back(x);
      // tau = tau_k ⇒ C = C_k.
      const Theorem equation = Theorem::assume(equal(e_.tau, x));
      const Variable place{"place"};
      const Theorem moved = Theorem::replace(equation, place, rows_hold(place, e_.C), solved);
      because.push_back(Theorem::discharge(within_bounds(found.zeros[k], Theorem::cut(moved, same[k])),
                                           equation.conclusion()));
    }
    const Rational last = orbits::above(e_.Theta, ranges_);
    const Theorem result =
        cut_all({part(inside, 0), Theorem::order(at_most(0, e_.tau), {{{part(inside, 0)}}}),
                 Theorem::order(at_most(e_.tau, last),
                                {{{part(inside, 1)}}, {{Theorem::sign(less(e_.Theta, last))}}})},
                Theorem::consequence(because, goal(taus, amplitudes)));
    return for_every(e_.tau, during, for_every(e_.C, holds, result));
  }

  const SymmetricEquations& e_;
  int phase_;
  const orbits::Ranges& ranges_;
  Definition eliminant_;
  std::vector<Term> arguments_;  // of the eliminant, but for tau
  InLetters letters_;
  std::vector<Row> rows_;
  std::vector<Theorem> transfers_;
};

}  // namespace

SymmetricEquations::SymmetricEquations(const methods::Example& of) : example(of) {
  const model::SymmetricData<Symbolic> data = data_of(*this);
  Theta = data.Theta.term;
  for (const Row& row : rows_of(*this)) {
    rows.emplace_back(fmt::format("symmetric_row_{}", rows.size() + 1),
                      std::vector<Variable>{omega1, omega2, sigma, tau, C}, row.formula(C).parts()[0]);
  }
  ur = model::friction_at<Symbolic>(Printed<Symbolic>{example}.data(),
                                    model::symmetric_start<Symbolic>(data, tau, C),
                                    model::symmetric_phase<Symbolic>(data, pi(), tau))
           .term;
}

Formula SymmetricEquations::hold(int phase, const Term& at_tau, const Term& at_C) const {
  return all(transformed(rows, [&](const Definition& row) {
    return equal(row({omega1, omega2, phase, at_tau, at_C}), 0);
  }));
}

SymmetricList symmetric_list(const SymmetricEquations& equations, int phase,
                             const orbits::Ranges& frequencies, const std::vector<Rational>& nearly) {
  return List(equations, phase, frequencies)(nearly);
}

}  // namespace stickslip::proofs::pascal2012
