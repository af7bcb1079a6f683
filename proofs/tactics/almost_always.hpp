// What holds at all times of an interval but finitely many: "finite t: a < t < b and not A(t)".
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

// The A(t) of such a theorem. Throws KernelError unless it is of that form.
[[nodiscard]] Formula usual(const Formula& almost_always, const Term& t);

// A theorem of that form, alone or with the continuity of the function whose rate it gives: continuous(f, a,
// b) and finite t: ….
struct AlmostAlways {
  std::optional<Theorem> continuity;
  Theorem few;
};
[[nodiscard]] AlmostAlways read_as_almost_always(const Theorem& theorem);
// The a, b of finite t: a < t < b and not A(t).
[[nodiscard]] std::pair<Term, Term> interval(const Formula& few);

// finite t: a < t < b and not A(t), by finite t: a < t < b and not Ai(t) and a derivation at a time t that no
// hypothesis has: from a < t < b and Ai(t) to A(t). At least one premise.
using AtOneTime = std::function<Theorem(const Theorem& inside, const std::vector<Theorem>& premises)>;
[[nodiscard]] Theorem but_finitely_often(const std::vector<Theorem>& premises, const Term& a, const Term& b,
                                         const Variable& t, const AtOneTime& derive);
// The same for an interval within the premise's: a ≤ c, d ≤ b.
[[nodiscard]] Theorem but_finitely_often_within(const Theorem& premise, const Theorem& lower,
                                                const Theorem& upper);
// finite t: c < t < d and not A(t + s), by the premise on (a, b) and a ≤ c + s, d + s ≤ b.
[[nodiscard]] Theorem but_finitely_often_later(const Theorem& premise, const Term& c, const Term& d,
                                               const Term& s, const Theorem& lower, const Theorem& upper);

// The goal from formulas of which each is made of literals by "and" and "or": in each case that they leave,
// from its literals. A case whose literals exclude each other (0 < a and a < 0; 1 = -1) is none.
using InCase = std::function<Theorem(const std::vector<Theorem>& literals)>;
[[nodiscard]] Theorem by_cases(const std::vector<Theorem>& premises, const Formula& goal,
                               const InCase& derive);
// The literals of each case in which the formula holds.
[[nodiscard]] std::vector<std::vector<Formula>> alternatives(const Formula& formula);
// That they exclude each other, if they do.
[[nodiscard]] std::optional<Theorem> absurd(const std::vector<Theorem>& literals);

// continuous(f, a, b), finite t: a < t < b and not there is v: derivative(f, t, v) and v ≤ 0, and a ≤ b give
// f(b) ≤ f(a).
[[nodiscard]] Theorem decreases(const Theorem& continuity, const Theorem& never_grows, const Theorem& lasts);
// The first two and f(b) = f(a) give for all t: a ≤ t ≤ b ⇒ f(t) = f(a).
[[nodiscard]] Theorem never_changes(const Theorem& continuity, const Theorem& never_grows,
                                    const Theorem& returns);
// There is v: derivative(f, t, v) and v ≤ 0.
[[nodiscard]] Formula does_not_grow(const Term& f, const Term& t);

}  // namespace stickslip::proofs::tactics
