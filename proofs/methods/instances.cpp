#include <algorithm>

#include "proofs/methods/derivation.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/tactics/almost_always.hpp"

namespace stickslip::proofs::methods {

using namespace tactics;
using kernel::Formulas;
using kernel::KernelError;
using Theorems = std::vector<Theorem>;

namespace {

// Whether a sum of such equations, each taken once or not, with a sign, is the formula.
std::optional<Theorem> sum_of(const Formula& formula, const Theorems& equations) {
  std::vector<std::vector<kernel::Multiple>> sums{{}};
  for (const Theorem& equation : equations) {
    const auto count = sums.size();
    for (std::size_t i = 0; i < count; ++i) {
      for (const int sign : {1, -1}) {
        sums.push_back(sums[i]);
        sums.back().push_back({equation, sign});
      }
    }
  }
  for (const std::vector<kernel::Multiple>& sum : sums) {
    try {
      return Theorem::combination(formula, sum);
    } catch (const KernelError&) {
      continue;
    }
  }
  return std::nullopt;
}

// What is assumed of almost all times of an interval, of one within.
std::optional<Theorem> of_shorter(Derivation& derivation, const Formula& formula, const Formula& assumed) {
  try {
    const AlmostAlways known = read_as_almost_always(Theorem::assume(assumed)),
                       wanted = read_as_almost_always(Theorem::assume(formula));
    if (!known.continuity || !wanted.continuity ||
        !(known.continuity->conclusion().parts()[0] == wanted.continuity->conclusion().parts()[0])) {
      return std::nullopt;
    }
    const auto [a, b] = interval(known.few.conclusion());
    const auto [c, d] = interval(wanted.few.conclusion());
    const Theorem lower = derivation.follows(at_most(a, c)), upper = derivation.follows(at_most(d, b));
    const Theorem all = both({Theorem::continuous_within(*known.continuity, lower, upper),
                              but_finitely_often_within(known.few, lower, upper)});
    return all.conclusion() == formula ? std::optional(all) : std::nullopt;
  } catch (const KernelError&) {
    return std::nullopt;
  }
}

// The theorem less what it supposes and the claim does not, as far as that is found.
Theorem supplied_with(Derivation& derivation, Theorem theorem, const Formulas& assumed,
                      const Theorems& supplied) {
  Theorems equations;
  for (const Formula& one : assumed) {
    if (one.kind() == kernel::Kind::equal) {
      equations.push_back(Theorem::assume(one));
    }
  }
  return derivation.settled(settled_by(theorem, [&](const Formula& one) -> std::optional<Theorem> {
    const auto said = std::ranges::find_if(supplied, [&](const Theorem& s) { return s.conclusion() == one; });
    if (said != supplied.end()) {
      return *said;
    }
    if (assumed.contains(one)) {
      return std::nullopt;
    }
    if (one.kind() == kernel::Kind::equal) {
      Theorems alike;
      std::ranges::copy_if(equations, std::back_inserter(alike), [&](const Theorem& e) {
        return e.conclusion().parts()[0].type() == one.parts()[0].type();
      });
      return sum_of(one, alike);
    }
    std::optional<Theorem> lemma;
    for (const Formula& longer : assumed) {
      lemma = lemma ? lemma : of_shorter(derivation, one, longer);
    }
    return lemma;
  }));
}

}  // namespace

Proof by_instances(std::vector<Instance> instances) {
  const auto derive = [instances = std::move(instances)](Derivation& derivation, std::size_t which) {
    const symbols::Statement& printed = derivation.claim().printed[which];
    const Variable time{"t"};
    const Formulas assumed = derivation.assumed();
    std::vector<kernel::Multiple> sum;
    for (const Instance& one : instances) {
      kernel::Substitution functions;
      for (const auto& [name, value] : one.functions) {
        const kernel::Term at_time = derivation.read(value);
        functions.emplace(
            Variable{name, kernel::function_of_time(at_time.type().rows, at_time.type().columns)},
            lambda(time, at_time));
      }
      Theorems supplied;
      for (const Premise& premise : one.supplied) {
        supplied.push_back(supplied_with(derivation, derivation.premise(premise), assumed, {}));
      }
      const Theorem here = Theorem::instantiate(derivation.premise(one.premise), functions);
      sum.push_back({supplied_with(derivation, here, assumed, supplied), derivation.read(one.left)});
    }
    return derivation.combination(derivation.read(printed), sum);
  };
  return by_kernel("a sum of the premises, of these motions and times", derive);
}

}  // namespace stickslip::proofs::methods
