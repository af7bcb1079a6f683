#include <algorithm>

#include "core/error.hpp"
#include "numeric/branches/changes.hpp"

namespace stickslip::numeric::branches {

namespace {

class Description {
 public:
  Description(const Traced& traced, Branch& branch, std::vector<UnresolvedPart>& unresolved)
      : t_(traced), branch_(branch), unresolved_(unresolved), path_end_(branch.last) {}

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
      } else if (before != nullptr && !may_adjoin(before->state, after->state) &&
                 (before->state != after->state || before->rises != after->rises)) {
        throw InternalError("two adjacent parts of a branch contradict each other");
      }
      if (after == nullptr) {
        break;
      }
      extend(*after, next > k || before == nullptr || before->state != after->state);
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
    const auto length = [&](std::size_t from, std::size_t to) {
      double sum = 0;
      for (std::size_t i = from; i < to; ++i) {
        sum += parts[i].value.radius().approximate();
      }
      return sum;
    };
    std::size_t end = first_decided(k);
    while (end > k && end < parts.size()) {
      std::size_t next = end;
      while (next < parts.size() && parts[next].decided() && parts[next].state == parts[end].state &&
             parts[next].rises == parts[end].rises) {
        ++next;
      }
      if (next == parts.size() || parts[next].decided() || length(end, next) >= 2 * length(k, end)) {
        break;
      }
      end = first_decided(next);
    }
    return end;
  }

  // Whether the parameter may turn.
  [[nodiscard]] bool turns(const Gap& gap) const {
    const int rises = t_.parts[gap.from].rises;
    return rises == 0 || std::any_of(t_.parts.begin() + static_cast<std::ptrdiff_t>(gap.from),
                                     t_.parts.begin() + static_cast<std::ptrdiff_t>(gap.to),
                                     [&](const Part& part) { return part.rises != rises; });
  }

  // A piece of which nothing is known but that the motions close; of the gap's own.
  void add_open_piece(const Gap& gap) {
    const int rises = t_.parts[gap.from].rises;
    const Ball low = gap.at.lower(), high = gap.at.upper();
    branch_.pieces.push_back(
        {State::undecided, {}, rises < 0 ? high : low, rises < 0 ? low : high, {}, turns(gap)});
  }

  void leave_open(const Gap& gap) {
    unresolved_.push_back({gap.at, {}, t_.parts[gap.from].reason});
    add_open_piece(gap);
  }

  // The name of the natural frequency that omega may have somewhere in the gap; empty if it has none.
  [[nodiscard]] std::string resonance(const Gap& gap) const {
    const zeros::Vector p = t_.curve.data_at(gap.at);
    const model::Modes<Ball> m = model::modes<Ball>(p(0), p(1));
    return m.omega1.overlaps(p(4)) ? "omega1" : m.omega2.overlaps(p(4)) ? "omega2" : "";
  }

  // A gap without a change is left open: a condition or a multiplier comes as near as can be told and turns
  // back.
  void settle(const Gap& gap) {
    const bool wide = (Ball(2) * gap.at.radius() - Ball(resolution)).is_positive();
    if (gap.before == nullptr || gap.after == nullptr) {
      BranchEnd& end = gap.before == nullptr ? branch_.first : branch_.last;
      if (end.kind == End::infinite && !wide && !turns(gap)) {
        end.at = gap.at;  // conditions that the infinite motion just fails to meet, or just meets
        return;
      }
      return leave_open(gap);
    }
    const State a = gap.before->state, b = gap.after->state;
    if (a == State::outside || b == State::outside) {
      return wide ? leave_open(gap) : void();
    }
    const bool same = a == b && gap.before->rises == gap.after->rises;
    if (const std::string frequency = resonance(gap); same && !frequency.empty()) {
      branch_.changes.push_back({ChangeKind::resonance,
                                 frequency,
                                 "omega = " + frequency + ", where the response (7) to the load is unbounded",
                                 gap.at,
                                 {},
                                 Verdict::undecided("beside a resonance: " + t_.parts[gap.from].reason)});
      return add_open_piece(gap);
    }
    std::vector<Change> changes;
    if (!wide && !may_adjoin(a, b)) {
      changes = changes_at(t_, gap);
    }
    if (changes.empty()) {
      return leave_open(gap);
    }
    if (a == State::absent && branch_.pieces.empty()) {
      branch_.first = {gap.at, changes.back().words, End::absent};
    } else if (a == State::absent) {
      branch_.last = path_end_;
    } else if (b == State::absent) {
      branch_.last = {gap.at, changes.back().words, End::absent};
    }
    std::ranges::move(changes, std::back_inserter(branch_.changes));
  }

  void extend(const Part& part, bool begins) {
    if (part.state == State::absent || part.state == State::outside) {
      return;
    }
    const Ball low = part.value.lower(), high = part.value.upper();
    const bool is_new = begins || branch_.pieces.empty();
    if (is_new) {
      branch_.pieces.push_back({part.state, {}, part.rises < 0 ? high : low, {}, {}});
    }
    Piece& piece = branch_.pieces.back();
    if (part.state == State::inadmissible) {
      if (is_new) {
        const auto first =
            std::find_if(part.conditions.begin(), part.conditions.end(),
                         [](const motion::Condition& c) { return c.verdict.truth == Truth::refuted; });
        piece.condition = first == part.conditions.end() ? "" : first->id;
      } else if (!part.refutes(piece.condition)) {
        piece.condition.clear();
      }
    }
    piece.last = part.rises < 0 ? low : high;
    if (!part.in_units) {
      piece.samples.push_back({part.sample_value, part.sample});
    }
  }

  const Traced& t_;
  Branch& branch_;
  std::vector<UnresolvedPart>& unresolved_;
  BranchEnd path_end_;
};

// Whether the value lies between the end of a piece and the beginning of the next: both may hold one motion
// there, as the first and the last of a closed branch do, which overlap.
bool gives_way(const Branch& branch, const Ball& value) {
  const std::vector<Piece>& pieces = branch.pieces;
  for (std::size_t k = branch.closed ? 0 : 1; k < pieces.size(); ++k) {
    const Piece& before = k == 0 ? pieces.back() : pieces[k - 1];
    if (Ball::hull(before.last, pieces[k].first).contains(value)) {
      return true;
    }
  }
  return false;
}

}  // namespace

void describe(const Traced& traced, Branch& branch, std::vector<UnresolvedPart>& unresolved) {
  Description(traced, branch, unresolved).run();
  for (const Piece& piece : branch.pieces) {
    if (piece.state == State::admissible) {
      unresolved.push_back({Ball::hull(piece.first, piece.last), {}, "the stability is undecided"});
    }
  }
}

std::vector<Count> counts_of(const BranchQuestion& question, const std::vector<Branch>& branches,
                             const std::vector<UnresolvedPart>& open) {
  std::vector<Count> counts;
  std::vector<Ball> ends{Ball(question.from), Ball(question.to)};
  const auto add = [&](const Ball& low, const Ball& high) {
    ends.push_back(low);
    ends.push_back(high);
  };
  for (const Branch& branch : branches) {
    for (const Piece& piece : branch.pieces) {
      add(piece.first, piece.last);
    }
  }
  for (const UnresolvedPart& part : open) {
    add(part.value.lower(), part.value.upper());
  }
  std::sort(ends.begin(), ends.end(), [](const Ball& a, const Ball& b) {
    return arf_cmp(arb_midref(a.raw()), arb_midref(b.raw())) < 0;
  });
  // Where all branches are looked for, what is open says where one that stops may go on.
  const bool goes_on = question.at && std::any_of(branches.begin(), branches.end(), [](const Branch& branch) {
                         return !branch.first.resolved() || !branch.last.resolved();
                       });
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    if (!(ends[k + 1] - ends[k] - Ball(resolution)).is_positive()) {
      continue;
    }
    const Ball middle = ((ends[k] + ends[k + 1]) / Ball(2)).midpoint();
    Count count{ends[k], ends[k + 1]};
    bool known = true;
    for (const Branch& branch : branches) {
      known = known && !gives_way(branch, middle);
      for (const Piece& piece : branch.pieces) {
        if (Ball::hull(piece.first, piece.last).contains(middle)) {
          known = known && !piece.may_turn;
          if (piece.state == State::undecided) {
            ++count.undecided;
            continue;
          }
          ++count.orbits;
          count.unsettled += piece.state == State::admissible ? 1 : 0;
          count.admissible += is_admissible(piece.state) ? 1 : 0;
          count.stable += piece.state == State::stable ? 1 : 0;
        }
      }
    }
    count.more = goes_on || std::any_of(open.begin(), open.end(), [&](const UnresolvedPart& part) {
                   return part.value.contains(middle);
                 });
    if (known) {
      counts.push_back(count);
    }
  }
  return counts;
}

}  // namespace stickslip::numeric::branches
