#include "numeric/branches/changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "numeric/branches/crossing.hpp"

namespace stickslip::numeric::branches {

using namespace motion;
using zeros::ParameterJet;
using zeros::ParametricProof;

namespace {

// The undecided parts between two groups of decided ones.
struct Gap {
  std::size_t from, to;  // of Traced::parts
  const Part * before;   // the last decided part, the next one: nullptr at an end of the branch
  const Part * after;
  Ball at;
};

// The motions over the parts of a gap, as jets by each cell's driver, which rises along the branch if `ahead`
// is 1.
struct Over {
  MotionOf<ParameterJet> motion;
  Motion values;
  std::optional<ParameterJet> ur;
  std::vector<ParameterJet> multipliers;  // their polynomial
  int ahead;
};

std::optional<std::vector<Over>> over_gap(const Traced& t, const Gap& gap) {
  std::vector<Over> all;
  for (std::size_t k = gap.from; k < gap.to; ++k) {
    const Part& part = t.parts[k];
    const Cell& cell = t.cells[part.cell];
    const ParametricProof proof = proof_on(t.curve, cell, part.first, part.last);
    if (proof.verdict.truth != Truth::proved) {
      return std::nullopt;
    }
    const Driven f{&t.curve, cell.driver};
    const MotionOf<ParameterJet> jets = f.motion<ParameterJet>(proof.x, proof.p);
    all.push_back({jets, closed_over(proof, jets, f.motion<Ball>(proof.at_middle, proof.p0)).motion,
                   friction_jet(t.law, jets, f.value<ParameterJet>(proof.x, proof.p)),
                   multiplier_polynomial(jets), part.first < part.last ? 1 : -1});
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
  add(law.requirements, part.ur);
  add(law.at_us, part.motion.oscillator.data.us);
  return all.value_or(Trend::unknown);
}

// In the direction of the branch over the whole gap; 0 when it is not known to have one direction.
int direction(const std::vector<Over>& over, const std::function<Trend(const Over&)>& trend) {
  int all = 0;
  for (const Over& part : over) {
    const Trend here = trend(part);
    if (here == Trend::above) {
      continue;
    }
    const int sign = here == Trend::rising ? part.ahead : here == Trend::falling ? -part.ahead : 0;
    if (sign == 0 || (all != 0 && sign != all)) {
      return 0;
    }
    all = sign;
  }
  return all;
}

// Whether the function passes zero once over the whole gap, with a speed that is not zero.
bool passes_once(const std::vector<Over>& over, Exit exit) {
  int all = 0;
  for (const Over& part : over) {
    const Ball slope = exit_function(exit, part.multipliers).partial(0);
    const int sign = slope.is_positive() ? part.ahead : slope.is_negative() ? -part.ahead : 0;
    if (sign == 0 || (all != 0 && sign != all)) {
      return false;
    }
    all = sign;
  }
  return all != 0;
}

bool may_vanish(const std::vector<Over>& over, Exit exit) {
  return std::any_of(over.begin(), over.end(), [&](const Over& part) {
    const Ball value = exit_function(exit, part.multipliers).value;
    return value.contains_zero() || !value.is_finite();
  });
}

Verdict once(bool proved, const std::string& why) {
  return proved ? Verdict::proved() : Verdict::undecided(why);
}

constexpr const char * not_transversal =
    "that it is passed once, with a speed that is not zero, is not proved";

bool violated(const Part& part, const std::string& id) {
  return std::any_of(part.conditions.begin(), part.conditions.end(),
                     [&](const Condition& c) { return c.id == id && c.verdict.truth == Truth::refuted; });
}

// Whether the derivative of the parameter along the branch has one zero at most over the whole gap.
bool turns_once(const Law& law, const std::vector<Over>& over) {
  if (!law.phi_is_given) {
    return passes_once(over, Exit::plus_one);
  }
  const int all = direction(over, [](const Over& part) {
    const Ball slope = turn_at_given_phase<ParameterJet>(part.motion).partial(0);
    return slope.is_positive() ? Trend::rising : slope.is_negative() ? Trend::falling : Trend::unknown;
  });
  return all != 0;
}

Change fold(const Law& law, const Gap& gap, const std::optional<std::vector<Over>>& over) {
  const bool highest = gap.before->rises > 0;
  return {ChangeKind::fold,
          "",
          highest ? "two orbits meet here and none of them goes on above"
                  : "two orbits meet here and none of them goes on below",
          gap.at,
          {},
          // Where the parameter has an extremum along the branch, its derivative by the branch's own
          // parameter is a motion that returns with what is given. With the friction given, or for one that
          // never sticks, 1 is a multiplier then; so it is of symmetric orbits, of which another motion
          // returns in any case, and one combination of the two at the same friction. So a single zero of
          // det(I - M) leaves a single extremum.
          once(over && turns_once(law, *over),
               "that the branch turns only once here is not proved: det(I - M) may vanish twice")};
}

// Lost at a gap between an admissible and an inadmissible piece, or between a piece and none at all: the
// conditions that are open in the gap and violated beyond it.
std::vector<Change> lost(const Traced& t, const Gap& gap, const std::optional<std::vector<Over>>& over,
                         bool birth) {
  const bool before_holds = birth ? gap.before->state != State::absent : is_admissible(gap.before->state);
  const Part& beyond = before_holds ? *gap.after : *gap.before;
  std::vector<Change> changes;
  std::set<std::string> seen;
  for (std::size_t k = gap.from; k < gap.to; ++k) {
    for (const Condition& c : t.parts[k].conditions) {
      const bool is_duration =
          std::any_of(t.law.requirements.begin(), t.law.requirements.end(),
                      [&](const Requirement& q) { return q.id == c.id && q.quantity == Quantity::duration; });
      const bool beyond_says = birth ? is_duration : violated(beyond, c.id);
      if (c.verdict.truth == Truth::proved || !beyond_says || !seen.insert(c.id).second) {
        continue;
      }
      int goes = 0;
      if (over) {
        goes = direction(*over, [&](const Over& part) { return trend_of(t.law, c.id, part); });
      }
      const bool falls = before_holds;
      Change change{birth ? ChangeKind::birth : ChangeKind::condition, c.id, plain(c.statement), gap.at, c.at,
                    once(goes == (falls ? -1 : 1), not_transversal)};
      if (birth) {
        change.words = fmt::format("{} = 0: {}", c.id, falls ? "the branch ends" : "the branch begins");
        change.when.reset();
      } else {
        change.words = fmt::format("{}: {}", falls ? "lost" : "gained", change.words);
      }
      changes.push_back(std::move(change));
    }
  }
  return changes;
}

bool has_complex_pair_on_circle(const Over& part) {
  const std::vector<ComplexBall> all = decide_stability(part.values).multipliers;
  return std::any_of(all.begin(), all.end(), [](const ComplexBall& mu) {
    return mu.im.is_positive() && mu.squared_modulus().overlaps(Ball(1));
  });
}

std::vector<Change> stability_changes(const Gap& gap, const std::optional<std::vector<Over>>& over) {
  const bool before = gap.before->state == State::stable;
  const std::string words = before ? "stability is lost" : "stability is gained";
  std::vector<Change> changes;
  for (const Exit exit : exits) {
    if (!over || !may_vanish(*over, exit)) {
      continue;
    }
    const bool named = exit != Exit::pair || std::all_of(over->begin(), over->end(), [](const Over& part) {
                         return has_complex_pair_on_circle(part);
                       });
    if (named) {
      changes.push_back({ChangeKind::stability,
                         to_string(exit),
                         words,
                         gap.at,
                         {},
                         once(passes_once(*over, exit), not_transversal)});
    }
  }
  if (changes.size() > 1) {
    for (Change& change : changes) {
      change.verdict = Verdict::undecided("more than one multiplier may cross here");
    }
  }
  return changes;
}

class Description {
 public:
  Description(const Traced& traced, Branch& branch, std::vector<UnresolvedPart>& unresolved)
      : t_(traced), branch_(branch), unresolved_(unresolved) {}

  void run() {
    const std::vector<Part>& parts = t_.parts;
    const Part * before = nullptr;
    for (std::size_t k = 0; k < parts.size();) {
      const std::size_t next = end_of_gap(k);
      const Part * after = next < parts.size() ? &parts[next] : nullptr;
      if (next > k) {
        Gap gap{k, next, before, after, parts[k].value};
        for (std::size_t i = k; i < next; ++i) {
          gap.at = Ball::hull(gap.at, parts[i].value);
        }
        settle(gap);
      } else if (before != nullptr && may_adjoin(before->state, after->state)) {
        branch_.pieces.push_back({after->state, {}, after->value, after->value, {}});
      } else if (before != nullptr && (before->state != after->state || before->rises != after->rises)) {
        throw InternalError("two adjacent parts of a branch contradict each other");
      }
      if (after == nullptr) {
        break;
      }
      extend(*after, next > k || before == nullptr);
      before = after;
      k = next + 1;
    }
  }

 private:
  // The first decided part from k on that is not followed by another gap before twice the length of the gap
  // is decided: scraps between undecided parts tell nothing.
  [[nodiscard]] std::size_t end_of_gap(std::size_t k) const {
    const std::vector<Part>& parts = t_.parts;
    const auto first_decided = [&](std::size_t i) {
      while (i < parts.size() && !parts[i].decided()) {
        ++i;
      }
      return i;
    };
    std::size_t end = first_decided(k);
    const auto length = [&](std::size_t from, std::size_t to) {
      double sum = 0;
      for (std::size_t i = from; i < to; ++i) {
        sum += parts[i].value.radius().approximate();
      }
      return sum;
    };
    while (end > k) {
      std::size_t gap = end;
      while (gap < parts.size() && parts[gap].decided() && parts[gap].state == parts[end].state &&
             parts[gap].rises == parts[end].rises && length(end, gap) < 2 * length(k, end)) {
        ++gap;
      }
      if (gap == parts.size() || parts[gap].decided()) {
        break;
      }
      end = first_decided(gap);
    }
    return end;
  }

  // A piece of which the stability is not known, and one of which it is.
  [[nodiscard]] static bool may_adjoin(State a, State b) {
    return a != b && is_admissible(a) && is_admissible(b) &&
           (a == State::admissible || b == State::admissible);
  }

  void leave_open(const Gap& gap, const std::string& reason) {
    unresolved_.push_back({gap.at, {}, reason});
    const Part& first = t_.parts[gap.from];
    branch_.pieces.push_back({State::undecided, {}, first.value, t_.parts[gap.to - 1].value, {}});
  }

  // The name of the natural frequency that omega may have somewhere in the gap; empty if it has none.
  [[nodiscard]] std::string resonance(const Gap& gap) const {
    zeros::Vector p = t_.curve.data;
    p(t_.curve.place) = gap.at;
    const model::Modes<Ball> m = model::modes<Ball>(p(0), p(1));
    return m.omega1.overlaps(p(4)) ? "omega1" : m.omega2.overlaps(p(4)) ? "omega2" : "";
  }

  // Not a change of anything: a condition or a multiplier that comes as near as can be told and turns back.
  void settle(const Gap& gap) {
    const std::string& reason = t_.parts[gap.from].reason;
    if (gap.before == nullptr || gap.after == nullptr) {
      return leave_open(gap, reason);
    }
    const auto either = [&](State state) { return gap.before->state == state || gap.after->state == state; };
    const bool wide = (Ball(2) * gap.at.radius() - Ball(resolution)).is_positive();
    if (either(State::outside)) {
      return wide ? leave_open(gap, reason) : void();
    }
    if (const std::string frequency = resonance(gap); !frequency.empty() &&
                                                      gap.before->state == gap.after->state &&
                                                      gap.before->rises == gap.after->rises) {
      branch_.changes.push_back({ChangeKind::resonance,
                                 frequency,
                                 "omega = " + frequency + ", where the response (7) to the load is unbounded",
                                 gap.at,
                                 {},
                                 Verdict::undecided("beside a resonance: " + reason)});
      return;
    }
    if (wide) {
      return leave_open(gap, reason);
    }
    const std::optional<std::vector<Over>> over = over_gap(t_, gap);
    std::vector<Change> changes;
    // Beyond a birth the branch may turn as it likes.
    const bool turns = gap.before->rises != gap.after->rises && !either(State::absent);
    if (turns) {
      changes.push_back(fold(t_.law, gap, over));
    }
    const State a = gap.before->state, b = gap.after->state;
    if (may_adjoin(a, b)) {
      return leave_open(gap, reason);
    }
    if (a != b) {
      std::vector<Change> more = either(State::absent)                  ? lost(t_, gap, over, true)
                                 : is_admissible(a) != is_admissible(b) ? lost(t_, gap, over, false)
                                                                        : stability_changes(gap, over);
      // At a fold 1 is a multiplier: that it crosses is said already.
      std::erase_if(more, [&](const Change& c) { return turns && c.what == to_string(Exit::plus_one); });
      if (more.empty() && !turns) {
        return leave_open(gap, "what changes here could not be named: " + reason);
      }
      std::ranges::move(more, std::back_inserter(changes));
    }
    if (changes.empty()) {
      return leave_open(gap, reason);
    }
    if (either(State::absent)) {
      BranchEnd& end = a == State::absent ? branch_.first : branch_.last;
      end = {gap.at, changes.empty() ? "" : changes.back().words, true};
    }
    std::ranges::move(changes, std::back_inserter(branch_.changes));
  }

  void extend(const Part& part, bool begins) {
    if (part.state == State::absent || part.state == State::outside) {
      return;
    }
    if (begins || branch_.pieces.empty()) {
      branch_.pieces.push_back({part.state, {}, part.value, part.value, {}});
    }
    Piece& piece = branch_.pieces.back();
    const auto refuted = [&](const std::string& id) { return violated(part, id); };
    if (part.state == State::inadmissible) {
      if (piece.samples.empty()) {
        for (const Condition& c : part.conditions) {
          piece.condition = piece.condition.empty() && refuted(c.id) ? c.id : piece.condition;
        }
      } else if (!refuted(piece.condition)) {
        piece.condition.clear();
      }
    }
    piece.last = part.value;
    piece.samples.push_back({part.sample_value, part.sample});
  }

  const Traced& t_;
  Branch& branch_;
  std::vector<UnresolvedPart>& unresolved_;
};

// A piece begins where its first part does: at the lower end of the parameter there if it rises.
void sharpen_ends(Branch& branch) {
  for (Piece& piece : branch.pieces) {
    const bool rises = piece.first.approximate() <= piece.last.approximate();
    piece.first = rises ? piece.first.lower() : piece.first.upper();
    piece.last = rises ? piece.last.upper() : piece.last.lower();
  }
}

}  // namespace

void describe(const Traced& traced, Branch& branch, std::vector<UnresolvedPart>& unresolved) {
  Description(traced, branch, unresolved).run();
  sharpen_ends(branch);
  for (const Piece& piece : branch.pieces) {
    if (piece.state == State::admissible) {
      unresolved.push_back({Ball::hull(piece.first, piece.last), {}, "the stability is undecided"});
    }
  }
}

}  // namespace stickslip::numeric::branches
