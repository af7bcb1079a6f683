// Functions made of others, and what they inherit.
#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {

Theorem Theorem::piecewise(const Term& before, const Term& after, const Term& c) {
  require(before.type().sort == Sort::function && before.type() == after.type(),
          "the pieces are no functions of one shape");
  require(before.is_closed() && after.is_closed() && c.is_closed() && c.type().is_scalar(),
          "the pieces meet at a number");
  const Variable X = fresh(before.type(), {before, after, c});
  const Variable t = fresh(real_number, {before, after, c, X});
  return {{.rule = "piecewise", .data = {before, after, c}},
          exists(X, for_all(t, all({implies(less(t, c), equal(apply(X, t), apply(before, t))),
                                    implies(at_most(c, t), equal(apply(X, t), apply(after, t)))})))};
}

Theorem Theorem::periodic(const Term& function, const Theorem& positive) {
  const auto [nothing, period] = sides(positive, Kind::less);
  require(nothing == Term(0), "the period is not known to be positive");
  require(function.type().sort == Sort::function && function.is_closed(), "only a function is continued");
  const Variable X = fresh(function.type(), {function, period});
  const Variable t = fresh(real_number, {function, period, X});
  return {{.rule = "periodic", .premises = {positive}, .data = {function}},
          exists(X, all({for_all(t, implies(all({at_most(0, t), less(t, period)}),
                                            equal(apply(X, t), apply(function, t)))),
                         for_all(t, equal(apply(X, Term(t) + period), apply(X, t)))}))};
}

Theorem Theorem::same_continuity(const Theorem& continuity, const Theorem& agreement) {
  const Formula &known = continuity.conclusion(), &claim = agreement.conclusion();
  require(known.kind() == Kind::continuous, "the first premise is no continuity");
  const Term &f = known.parts()[0], &a = known.parts()[1], &b = known.parts()[2];
  const Variable t = fresh(real_number, {claim, known});
  require(claim.kind() == Kind::for_all && claim.binds() == real_number, "the functions agree at all times");
  const Formula body = opened(claim, t);
  require(body.kind() == Kind::implication && body.parts()[0] == within(a, t, b) &&
              body.parts()[1].kind() == Kind::equal && body.parts()[1].parts()[0] == apply(f, t),
          "the functions do not agree on this interval, the known one on the left");
  return {{.rule = "same_continuity", .premises = {continuity, agreement}},
          continuous(lambda(t, body.parts()[1].parts()[1]), a, b)};
}

Theorem Theorem::continuous_union(const Theorem& before, const Theorem& after) {
  const Formula &one = before.conclusion(), &other = after.conclusion();
  require(one.kind() == Kind::continuous && other.kind() == Kind::continuous, "a premise is no continuity");
  require(one.parts()[0] == other.parts()[0] && one.parts()[2] == other.parts()[1],
          "these are not one function's on intervals that share an end");
  return {{.rule = "continuous_union", .premises = {before, after}},
          continuous(one.parts()[0], one.parts()[1], other.parts()[2])};
}

Theorem Theorem::finite_point(const Term& a) {
  require(a.is_closed() && a.type().is_scalar(), "a time is a number");
  const Variable t = fresh(real_number, {a});
  return {{.rule = "finite_point", .data = {a}}, kernel::finite(t, equal(t, a))};
}

}  // namespace stickslip::proofs::kernel
