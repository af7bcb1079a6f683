#include "tests/proofs/wrong.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "proofs/deciding.hpp"
#include "proofs/edits.hpp"
#include "proofs/methods.hpp"
#include "proofs/point.hpp"
#include "proofs/prover.hpp"
#include "proofs/repair.hpp"

namespace stickslip::proofs {
namespace {

// The point with the claim's substitutions; symbols it does not name get any value.
Lookup<Ball> values_under(const Given& given, const std::vector<Coordinate>& point) {
  std::vector<Coordinate> whole = point;
  for (const Coordinate& other : std::vector<Coordinate>{{"omega1", Rational(1, 2)},
                                                         {"omega2", Rational(2)},
                                                         {"omega", Rational(13, 10)},
                                                         {"us", Rational(1, 5)},
                                                         {"p", Rational(3, 10)},
                                                         {"phi", Rational(2, 5)},
                                                         {"tau", Rational(7, 10)},
                                                         {"tau1", Rational(6, 5)},
                                                         {"z10", 1},
                                                         {"z20", 2},
                                                         {"zdot10", 3},
                                                         {"zdot20", 4}}) {
    if (std::none_of(whole.begin(), whole.end(), [&](const Coordinate& c) { return c.name == other.name; })) {
      whole.push_back(other);
    }
  }
  return [&given, known = at_point(whole), whole](const std::string& name) {
    const auto found = given.values.find(name);
    return found == given.values.end() ? known(name)
                                       : evaluate<Ball>(found->second, values_under(given, whole))(0, 0);
  };
}

bool confirmed(const Claim& claim, const Statement& statement, const Witness& witness) {
  const WorkingPrecision precision(256);
  const Given given(claim);
  const Lookup<Ball> here = values_under(given, witness.point);
  const Value<Ball> left = evaluate<Ball>(statement.left, here);
  const Value<Ball> right = statement.right.is_zero()
                                ? Value<Ball>(Value<Ball>::Zero(left.rows(), left.cols()))
                                : evaluate<Ball>(statement.right, here);
  for (Eigen::Index i = 0; i < left.size(); ++i) {
    if (!left(i).overlaps(right(i))) {
      return true;
    }
  }
  return false;
}

}  // namespace

const Claim& claim_named(const std::vector<Claim>& claims, const std::string& id) {
  const auto found = std::find_if(claims.begin(), claims.end(), [&](const Claim& c) { return c.id == id; });
  if (found == claims.end()) {
    throw InternalError("no claim " + id);
  }
  return *found;
}

Mutants decide_mutants(const std::vector<Claim>& claims, const std::vector<std::string>& ids) {
  Mutants result;
  Prover nothing_else({});
  for (const std::string& id : ids) {
    for (const Statement& statement : claim_named(claims, id).printed) {
      for (const Edit& edit : edits(statement)) {
        Claim mutant = claim_named(claims, id);
        mutant.printed = {edit.statement};
        Verdict verdict;
        try {
          verdict = by_normal_form()(nothing_else, mutant).verdict;
        } catch (const GiNaC::pole_error&) {
          continue;  // the edit leaves a division by zero, no statement
        }
        if (verdict.truth == Truth::proved) {
          result.survivors.push_back(id + ": " + text(edit.statement));
        } else if (verdict.witness && confirmed(mutant, edit.statement, *verdict.witness)) {
          ++result.refuted;
        } else {
          result.open.push_back(id + ": " + text(edit.statement) + ": " + verdict.reason);
        }
      }
    }
  }
  return result;
}

Mutants decide_mutants(const std::vector<Claim>& claims, const std::string& id, const Proof& how,
                       const std::vector<Assumption>& more) {
  Mutants result;
  Prover prover(claims);
  for (const Statement& statement : claim_named(claims, id).printed) {
    for (const Edit& edit : edits(statement)) {
      Claim mutant = claim_named(claims, id);
      mutant.printed = {edit.statement};
      mutant.assumptions.insert(mutant.assumptions.end(), more.begin(), more.end());
      const Verdict verdict = how(prover, mutant).verdict;
      if (verdict.truth == Truth::refuted && verdict.witness) {
        ++result.refuted;
      } else {
        (verdict.truth == Truth::proved ? result.survivors : result.open)
            .push_back(id + ": " + text(edit.statement));
      }
    }
  }
  return result;
}

std::vector<std::string> proved_mutants(const std::vector<Claim>& claims, const std::vector<std::string>& ids,
                                        int& tried) {
  std::vector<std::string> survivors;
  Prover prover(claims);
  for (const std::string& id : ids) {
    const Claim& claim = claim_named(claims, id);
    for (std::size_t i = 0; i < claim.printed.size(); ++i) {
      for (const Edit& edit : edits(claim.printed[i])) {
        Claim mutant = claim;
        mutant.printed[i] = edit.statement;
        ++tried;
        if (claim.prove(prover, mutant).verdict.truth == Truth::proved) {
          survivors.push_back(id + ": " + text(edit.statement));
        }
      }
    }
  }
  return survivors;
}

}  // namespace stickslip::proofs
