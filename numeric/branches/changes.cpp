#include "numeric/branches/changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/parallel.hpp"

namespace stickslip::numeric::branches {

using namespace motion;
using zeros::ParameterJet;
using zeros::ParametricProof;

namespace {

// The motions over a stretch of a cell, as jets by its driver, which rises along the branch if `ahead` is 1.
struct Over {
  MotionOf<ParameterJet> motion;
  ParameterJet value, unit;  // of the parameter, and of the lengths
  int ahead;
};

// Nothing where they are not known.
std::optional<Over> over_stretch(const Traced& t, std::size_t k, const Rational& first,
                                 const Rational& last) {
  const Cell& cell = t.cells[k];
  const ParametricProof proof = proof_on(t.curve, cell, first, last);
  if (proof.verdict.truth != Truth::proved) {
    return std::nullopt;
  }
  const Driven f{&cell.on(t.curve), cell.driver};
  return Over{f.motion<ParameterJet>(proof.x, proof.p), f.value<ParameterJet>(proof.x, proof.p),
              f.unit<ParameterJet>(proof.x, proof.p), first < last ? 1 : -1};
}

// Over its parts; nothing where they are not all known.
std::vector<Over> over_gap(const Traced& t, const Gap& gap) {
  std::vector<Over> all;
  for (std::size_t k = gap.from; k < gap.to; ++k) {
    const std::optional<Over> part = over_stretch(t, t.parts[k].cell, t.parts[k].first, t.parts[k].last);
    if (!part) {
      return {};
    }
    all.push_back(*part);
  }
  return all;
}

// Of the condition of that id; unknown where the law has no requirement for it.
Trend trend_of(const Law& law, const std::string& id, const Over& part) {
  std::optional<Trend> all;
  const auto add = [&](const Requirements& requirements, const std::optional<ParameterJet>& ur) {
    for (const Requirement& q : requirements) {
      if (q.id == id) {
        const Trend one = branches::trend_of(q, part.motion, ur);
        all = all ? joined(*all, one) : one;
      }
    }
  };
  add(law.requirements, friction_jet(law, part.motion, part.value, part.unit));
  add(law.at_us, part.motion.oscillator.data.us);
  return all.value_or(Trend::unknown);
}

// In the direction of the branch over the whole gap, on whose parts these are the trends; 0 when it is not
// known to have one direction.
int direction(const std::vector<Over>& over, const std::vector<Trend>& trends) {
  int all = 0;
  for (std::size_t k = 0; k < over.size(); ++k) {
    if (trends[k] == Trend::above) {
      continue;
    }
    const int sign = trends[k] == Trend::rising    ? over[k].ahead
                     : trends[k] == Trend::falling ? -over[k].ahead
                                                   : 0;
    if (sign == 0 || (all != 0 && sign != all)) {
      return 0;
    }
    all = sign;
  }
  return all;
}

Verdict once(bool proved, const std::string& why) {
  return proved ? Verdict::proved() : Verdict::undecided(why);
}

constexpr const char * not_transversal =
    "that it is passed once, with a speed that is not zero, is not proved";

// A stretch of a cell in a gap: whether the parameter may turn there, and which way the quantity goes along
// the branch, 1 or -1, or 0 where that is not known.
struct Stretch {
  std::size_t cell;
  Rational first, last;
  bool may_turn = true;
  int goes = 0;
};

Stretch look_at_turn(const Traced& t, Stretch s) {
  const std::optional<Over> here = over_stretch(t, s.cell, s.first, s.last);
  if (!here) {
    return s;
  }
  const ParameterJet quantity = t.law.phi_is_given
                                    ? turn_at_given_phase<ParameterJet>(here->motion)
                                    : exit_factors(here->motion, t.law.is_symmetric).product(Exit::plus_one);
  s.may_turn = !here->value.partial(0).is_nonzero();
  s.goes = scalars::sign_of(quantity.partial(0)) * here->ahead;
  return s;
}

// Whether the quantity, which vanishes where the parameter turns, goes one way from the first to the last
// place in the gap where it may: then it turns once at most. Stretches where that is open are halved.
bool turns_once(const Traced& t, const Gap& gap) {
  constexpr int most_rounds = 20;
  constexpr std::size_t most_open = 2000;
  std::vector<Stretch> stretches;
  for (std::size_t k = gap.from; k < gap.to; ++k) {
    stretches.push_back(look_at_turn(t, {t.parts[k].cell, t.parts[k].first, t.parts[k].last}));
  }
  const auto is_open = [](const Stretch& s) { return s.may_turn && s.goes == 0; };
  for (int round = 0; round < most_rounds; ++round) {
    if (static_cast<std::size_t>(std::count_if(stretches.begin(), stretches.end(), is_open)) > most_open) {
      return false;
    }
    std::vector<Stretch> finer;
    for (const Stretch& s : stretches) {
      const Rational middle = (s.first + s.last) / 2;
      if (is_open(s)) {
        finer.push_back({s.cell, s.first, middle});
        finer.push_back({s.cell, middle, s.last});
      } else {
        finer.push_back(s);
      }
    }
    if (finer.size() == stretches.size()) {
      break;
    }
    stretches = parallel_map(finer.size(), [&](std::size_t k) {
      return is_open(finer[k]) ? look_at_turn(t, finer[k]) : finer[k];
    });
  }
  // Without those before and after it where it may.
  const auto cannot_turn = [](const Stretch& s) { return !s.may_turn; };
  stretches.erase(stretches.begin(), std::find_if_not(stretches.begin(), stretches.end(), cannot_turn));
  while (!stretches.empty() && cannot_turn(stretches.back())) {
    stretches.pop_back();
  }
  return std::all_of(stretches.begin(), stretches.end(),
                     [&](const Stretch& s) { return s.goes != 0 && s.goes == stretches.front().goes; });
}

// Where the parameter has an extremum along the branch, its derivative by the branch's own parameter is a
// motion that returns with what is given. With the friction given, or for one that never sticks, 1 is a
// multiplier then; so it is of symmetric orbits, of which another motion returns in any case, and one
// combination of the two at the same friction. So a single zero of det(I - M) leaves a single extremum.
Change fold(const Traced& t, const Gap& gap) {
  const bool highest = gap.before->rises > 0;
  return {ChangeKind::fold,
          "",
          highest ? "two orbits meet here and none of them goes on above"
                  : "two orbits meet here and none of them goes on below",
          gap.at,
          {},
          once(turns_once(t, gap),
               "that the branch turns only once here is not proved: det(I - M) may vanish twice")};
}

// At a gap between an admissible and an inadmissible piece, or between a piece and none at all: what is open
// in the gap and refuted beyond it. Before it all of that holds, so each is lost somewhere in the gap.
std::vector<Change> lost(const Traced& t, const Gap& gap, const std::vector<Over>& over, bool birth) {
  const bool falls = birth ? gap.before->state != State::absent : is_admissible(gap.before->state);
  const Part& beyond = falls ? *gap.after : *gap.before;
  std::vector<Change> changes;
  std::set<std::string> seen;
  for (std::size_t k = gap.from; k < gap.to; ++k) {
    for (const Condition& c : t.parts[k].conditions) {
      if (c.verdict.truth == Truth::proved || !beyond.refutes(c.id) || !seen.insert(c.id).second) {
        continue;
      }
      std::vector<Trend> trends;
      for (const Over& part : over) {
        trends.push_back(trend_of(t.law, c.id, part));
      }
      const int goes = direction(over, trends);
      Change change{birth ? ChangeKind::birth : ChangeKind::condition, c.id, "", gap.at, c.at,
                    once(goes == (falls ? -1 : 1), not_transversal)};
      if (birth) {
        change.words = fmt::format("{} = 0: {}", c.id, falls ? "the branch ends" : "the branch begins");
        change.when.reset();
      } else {
        change.words = fmt::format("{}: {}", falls ? "lost" : "gained", plain(c.statement));
      }
      changes.push_back(std::move(change));
    }
  }
  return changes;
}

Crossings crossings(const Law& law, const std::vector<Over>& over) {
  std::vector<ExitFactors<ParameterJet>> factors;
  for (const Over& part : over) {
    factors.push_back(exit_factors(part.motion, law.is_symmetric));
  }
  Crossings result;
  for (const Exit exit : exits) {
    bool may_vanish = over.empty();
    std::vector<Trend> trends;
    for (const ExitFactors<ParameterJet>& part : factors) {
      const ParameterJet quantity = part.product(exit);
      may_vanish = may_vanish || quantity.value.contains_zero() || !quantity.value.is_finite();
      trends.push_back(by_slope(quantity));
    }
    if (may_vanish) {
      result.possible.push_back(exit);
    }
    if (direction(over, trends) != 0) {  // with a speed that is not zero
      result.once.push_back(exit);
    }
  }
  return result;
}

}  // namespace

bool may_adjoin(State a, State b) {
  return a != b && is_admissible(a) && is_admissible(b) && (a == State::admissible || b == State::admissible);
}

// All multipliers are inside the unit circle on one side, one is outside on the other: somewhere between an
// exit function vanishes. If that can be one only, its name is certain, and where it is that of a pair, the
// pair is a complex one: coming from the stable side, at the first zero mu_i mu_j = 1 with |mu_i|, |mu_j| <=
// 1, so they are conjugate, or both are 1 or both -1, where another exit function vanishes.
std::vector<Change> stability_changes(const Crossings& crossings, bool is_lost, const Ball& at) {
  std::vector<Change> changes;
  for (const Exit exit : crossings.possible) {
    const bool passes = std::find(crossings.once.begin(), crossings.once.end(), exit) != crossings.once.end();
    changes.push_back({ChangeKind::stability,
                       to_string(exit),
                       is_lost ? "stability is lost" : "stability is gained",
                       at,
                       {},
                       crossings.possible.size() > 1
                           ? Verdict::undecided("more than one multiplier may cross here")
                           : once(passes, not_transversal)});
  }
  return changes;
}

std::vector<Change> changes_at(const Traced& t, const Gap& gap) {
  const State a = gap.before->state, b = gap.after->state;
  const std::vector<Over> over = over_gap(t, gap);
  if (a == State::absent || b == State::absent) {
    return a == b ? std::vector<Change>{} : lost(t, gap, over, true);  // beyond, it may turn as it likes
  }
  std::vector<Change> changes;
  const bool turns = gap.before->rises != gap.after->rises;
  if (turns) {
    changes.push_back(fold(t, gap));
  }
  if (a == b || may_adjoin(a, b)) {
    return changes;
  }
  std::vector<Change> more = is_admissible(a) != is_admissible(b)
                                 ? lost(t, gap, over, false)
                                 : stability_changes(crossings(t.law, over), b == State::unstable, gap.at);
  // Where 1 is a multiplier at a fold, that it crosses is said already.
  std::erase_if(more, [&](const Change& c) {
    return turns && !t.law.phi_is_given && c.what == to_string(Exit::plus_one);
  });
  std::ranges::move(more, std::back_inserter(changes));
  return changes;
}

}  // namespace stickslip::numeric::branches
