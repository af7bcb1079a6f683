#include "numeric/branches/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <set>
#include <tuple>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/names.hpp"
#include "numeric/branches/law.hpp"
#include "numeric/branches/setting.hpp"
#include "numeric/families/through_phases/isolate.hpp"

namespace stickslip::numeric::branches {

using namespace families;
using namespace motion;

namespace {

// So many times the size of others a motion is not followed.
constexpr double far_away = 0x1p5;

// How long the sides are of cells that are left open by the first search of a strip, and by those of what it
// leaves. From `fine` on a part that stays as long as it was is given up.
constexpr std::array lengths{0x1p-7, 0x1p-12, 0x1p-18, 0x1p-24, 0x1p-30, 0x1p-36};
constexpr double fine = 0x1p-18;
constexpr long most_cells = 400000;
constexpr long most_cells_in_all = 4 * most_cells;
// At so many values more, after each search and in all, orbits are looked for.
constexpr int more_values = 8;
constexpr std::size_t most_values = 50;
// Radius of boxes in which motions that are too large are not told apart any more.
constexpr double small = 0x1p-10;

std::string words_of(const Path& path) {
  return name_of<End::stopped>(path.end, "the end of the interval", "a phase lasts no time",
                               "the branch is a closed curve", "the motion grows beyond all bounds",
                               "followed no further: " + path.reason);
}

BranchEnd end_of(const Path& path, const BranchQuestion& question) {
  BranchEnd end{path.last.value, words_of(path), path.end};
  if (path.end == End::stopped) {
    const std::string resonance = resonance_near(path.last.value, question);
    end.words += resonance;
    end.resonance = !resonance.empty();
  }
  const Ball at = path.limit.value_or(path.last.value);
  if (path.end == End::infinite) {
    end.at = at;
  }
  if (path.end == End::interval) {
    const bool above = (at - Ball((question.from + question.to) / 2)).is_positive();
    end.at = Ball(above ? question.to : question.from);
  }
  return end;
}

bool passes(const Followed& branch, const Point& point, int angle) {
  return for_some_turn(angle, point, [&](const Point& turned) {
    return std::any_of(branch.cells.begin(), branch.cells.end(),
                       [&](const Cell& cell) { return is_on(cell, turned); });
  });
}

// The cells of a closed branch, the last of them cut where the branch is back; none where what remains of
// that is not proved.
std::vector<Cell> once_round(const Curve& curve, const Path& path) {
  std::vector<Cell> cells = path.cells;
  cells.resize(path.once_round);
  const Cell& whole = path.cells[path.once_round - 1];
  const auto [low, high] = scalars::ends(path.back);
  Cell& last = cells.back();
  last.last =
      whole.first < whole.last ? std::min(Rational(high), whole.last) : std::max(Rational(low), whole.last);
  last.range = between(last.first, last.last);
  last.proof = proof_on(curve, whole, last.first, last.last);
  return last.proof.verdict.truth == Truth::proved ? cells : std::vector<Cell>{};
}

// Whether all motions within the bounds are on branches. That in whose place there is a reciprocal is
// positive or negative.
bool hold_large(const Sheet& sheet, const LargeBounds& large, const Bounds& parameter) {
  const auto holds_sign = [&](int sign) {
    const auto turned = [&](const Bounds& x) { return sign > 0 ? x : Bounds{-x.second, -x.first}; };
    std::vector<Bounds> x = large.x;
    for (const int k : large.growing) {
      x[static_cast<std::size_t>(k)] = turned(x[static_cast<std::size_t>(k)]);
    }
    Bounds& e = x[static_cast<std::size_t>(large.place)];
    if (e.second <= 0) {
      return true;
    }
    e.first = std::max(e.first, 0.0);
    return std::any_of(sheet.branches.begin(), sheet.branches.end(), [&](const Followed& branch) {
      return branch.tubes.hold(Units{large.place, sign, large.growing}, x, parameter);
    });
  };
  return holds_sign(1) && holds_sign(-1);
}

class Search {
 public:
  explicit Search(const BranchQuestion& question) : question_(question) {}

  AllFollowed run();

 private:
  void follow_from(const Rational& value);
  // False, with the reason in `why`, when no motion is proved there.
  [[nodiscard]] bool add(const Candidate& candidate, const Rational& value, std::string& why);
  // The sheet of that system; null if nothing was found on it.
  [[nodiscard]] Sheet * known_sheet(int system);
  [[nodiscard]] Sheet& sheet_of(const Candidate& candidate);
  void exhaust();
  [[nodiscard]] std::vector<zeros::UnresolvedBox<3>> rest_of(const Strip& strip, const zeros::Cell<3>& cell,
                                                             double smallest);
  void separate();

  const BranchQuestion& question_;
  AllFollowed all_;
  int found_ = 0;
  bool again_ = false;  // what was searched counts no more
  // Where motions may close that are too large to be followed.
  std::optional<Bounds> far_;
  std::mutex far_mutex_;
};

Sheet * Search::known_sheet(int system) {
  const auto found = std::ranges::find(all_.sheets, system, &Sheet::system);
  return found == all_.sheets.end() ? nullptr : &*found;
}

Sheet& Search::sheet_of(const Candidate& candidate) {
  if (Sheet * const known = known_sheet(candidate.system)) {
    return *known;
  }
  Sheet& sheet =
      all_.sheets.emplace_back(Sheet{candidate.system, curve_of(question_, candidate.equations), {}});
  sheet.curve.angle = candidate.angle;
  return sheet;
}

bool Search::add(const Candidate& candidate, const Rational& value, std::string& why) {
  Sheet& sheet = sheet_of(candidate);
  const ProvedPoint start = prove_at(sheet.curve, value, candidate.equations.unknowns(candidate.guess));
  if (start.verdict.truth != Truth::proved) {
    why = start.verdict.reason;
    return false;
  }
  const Driven f{&sheet.curve, by_parameter};
  if (!candidate.is_same(f.motion<Ball>(start.point.x, zeros::Vector::Constant(1, start.point.value)))) {
    why = may_be_another;
    return false;
  }
  if (sheet.branches.empty()) {
    // Of what is met first, and of 1.
    sheet.curve.far = far_away;
    for (const Ball& x : start.point.x) {
      sheet.curve.far = std::max(sheet.curve.far, far_away * std::abs(x.approximate()));
    }
  }
  const auto same = [&](const Followed& known) { return passes(known, start.point, sheet.curve.angle); };
  if (std::any_of(sheet.branches.begin(), sheet.branches.end(), same)) {
    return true;
  }
  Path up = follow(sheet.curve, value, start.point, 1);
  const bool closed = up.end == End::closed;
  std::vector<Cell> round = closed ? once_round(sheet.curve, up) : std::vector<Cell>{};
  if (closed && round.empty()) {
    why = "where the branch closes the last part of it is not proved";
    return false;
  }
  Path down = closed ? Path{} : follow(sheet.curve, value, start.point, -1);
  Followed found{start.point,
                 {},
                 end_of(closed ? up : down, question_),
                 end_of(up, question_),
                 {closed ? up.last : down.last, up.last},
                 closed,
                 {}};
  found.cells = reversed(std::move(down.cells));
  std::ranges::move(up.cells, std::back_inserter(found.cells));
  // One that was followed less far before, on one side: on the other it may have been followed farther, and
  // what its tubes held there has to be searched again.
  again_ = std::erase_if(
               sheet.branches,
               [&](const Followed& known) { return passes(found, known.start, sheet.curve.angle); }) > 0 ||
           again_;
  if (!question_.at) {
    found.tubes = Tubes(sheet.curve, found.cells);
  }
  if (closed) {
    found.cells = std::move(round);
  }
  sheet.branches.push_back(std::move(found));
  ++found_;
  return true;
}

// All orbits at that value: those that are on no branch yet are followed. What is left open here matters when
// nothing else is asked for only: else it is open in the strip, too.
void Search::follow_from(const Rational& value) {
  std::vector<UnresolvedPart> open;
  try {
    const Found found = question_.word ? Found{word_candidates(*question_.word), {}}
                                       : question_.orbits.family->search(data_at(question_, value));
    for (const Unresolved& one : found.unresolved) {
      open.push_back({Ball(value), one.where, one.reason});
    }
    if (question_.word && found.candidates.empty()) {
      open.push_back({Ball(value),
                      {},
                      question_.word->not_admissible > 0
                          ? "the orbits of the word that are known here are not admissible"
                          : "no orbit of the word is known here"});
    }
    for (const Candidate& candidate : found.candidates) {
      std::string why;
      if (!add(candidate, value, why)) {
        open.push_back({Ball(value), candidate.where, why});
      }
    }
  } catch (const DomainError& error) {  // a resonance at this very value
    open.push_back({Ball(value), {}, error.what(), true});
  }
  if (question_.at) {
    all_.unresolved = std::move(open);
  }
}

// The boxes of the cell that may hold closed motions on no branch.
std::vector<zeros::UnresolvedBox<3>> Search::rest_of(const Strip& strip, const zeros::Cell<3>& cell,
                                                     double smallest) {
  const Sheet * const sheet = known_sheet(strip.system);
  const auto is_known = [&](const Strip::View& view) {
    return sheet != nullptr &&
           (std::any_of(sheet->branches.begin(), sheet->branches.end(),
                        [&](const Followed& branch) { return branch.tubes.hold(view.x, view.parameter); }) ||
            std::any_of(view.large.begin(), view.large.end(),
                        [&](const LargeBounds& large) { return hold_large(*sheet, large, view.parameter); }));
  };
  const double far = sheet == nullptr ? HUGE_VAL : sheet->curve.far;
  const auto are_far = [&](const Strip::View& view) {
    return std::any_of(view.x.begin(), view.x.end(),
                       [&](const Bounds& side) { return side.first > far || side.second < -far; }) ||
           std::any_of(view.large.begin(), view.large.end(), [&](const LargeBounds& large) {
             const Bounds& e = large.x[static_cast<std::size_t>(large.place)];
             return std::max(-e.first, e.second) * far < 1;
           });
  };
  // Else no branch is known to go there.
  const bool to_infinity =
      sheet != nullptr &&
      std::any_of(sheet->branches.begin(), sheet->branches.end(), [](const Followed& branch) {
        return branch.first.kind == End::infinite || branch.last.kind == End::infinite;
      });
  const auto is_small = [](const StripBox& X) {
    return std::all_of(X.begin(), X.end(),
                       [](const Ball& side) { return side.radius().approximate() < small; });
  };
  const auto contract = [&](const StripBox& X) -> std::optional<StripBox> {
    const std::optional<Strip::View> view = strip.look(X);
    if (!view || is_known(*view)) {
      return std::nullopt;
    }
    if (are_far(*view) && is_small(X) && (view->large.empty() || !to_infinity)) {
      const std::lock_guard lock(far_mutex_);
      far_ = far_ ? Bounds{std::min(far_->first, view->parameter.first),
                           std::max(far_->second, view->parameter.second)}
                  : view->parameter;
      return std::nullopt;
    }
    return view->rest;
  };
  const auto decide = [](const StripBox& X) {
    return zeros::ZeroProof<3>{Verdict::undecided("the search went to the end of its accuracy"), X, X};
  };
  zeros::SearchResult<3> searched = zeros::search<3>(cell, contract, decide, {smallest, most_cells});
  all_.cells += searched.cells;
  return searched.unresolved;
}

// Coarse cells first: where they leave something open there may be a branch that is not known yet, so all
// orbits at a value there are looked for.
void Search::exhaust() {
  struct Open {
    const Strip * strip;
    zeros::Cell<3> cell;
    std::string reason;
    bool given_up;

    [[nodiscard]] double length() const { return cell.upper[2] - cell.lower[2]; }
  };
  const std::vector<Strip> strips = question_.orbits.family->strips(strip_question(question_));
  const auto everything = [&] {
    std::vector<Open> all;
    for (const Strip& strip : strips) {
      all.push_back({&strip, strip.domain, "", false});
    }
    return all;
  };
  std::vector<Open> open = everything();
  again_ = false;
  const double unit = strips.front().domain.upper[2];
  const auto value_at = [&](double share) {
    return Rational(question_.from + (question_.to - question_.from) * Rational(share / unit));
  };
  const zeros::Limit limit(most_cells_in_all);
  std::set<Rational> looked;
  const auto look_for_more = [&] {
    const int before = found_;
    int values = 0;
    for (const Open& one : open) {
      const Rational value = value_at((one.cell.lower[2] + one.cell.upper[2]) / 2);
      if (!interrupted() && looked.size() < most_values && values < more_values &&
          looked.insert(value).second) {
        ++values;
        follow_from(value);
      }
    }
    return found_ > before;
  };
  for (const double smallest : lengths) {
    for (bool again = true; again && !open.empty();) {
      std::vector<Open> rest;
      for (const Open& one : open) {
        if (one.given_up) {
          rest.push_back(one);
          continue;
        }
        if (const std::optional<const char *> reached = limit.reached(all_.cells)) {
          rest.push_back(one);
          rest.back().reason = *reached;
          continue;
        }
        for (const zeros::UnresolvedBox<3>& box : rest_of(*one.strip, one.cell, smallest)) {
          rest.push_back({one.strip, zeros::clip<3>(one.strip->domain, box.box).value_or(one.strip->domain),
                          box.reason, false});
          rest.back().given_up = smallest <= fine && rest.back().length() > one.length() / 2;
        }
      }
      open = std::move(rest);
      again = look_for_more();
      if (again_) {
        again_ = false;
        open = everything();
      } else if (again) {
        for (Open& one : open) {
          one.given_up = false;
        }
      }
    }
  }
  // What overlaps along the parameter is one part, for each reason; what was not looked at any more is one in
  // any case.
  std::sort(open.begin(), open.end(), [](const Open& a, const Open& b) {
    return std::tie(a.reason, a.cell.lower[2]) < std::tie(b.reason, b.cell.lower[2]);
  });
  for (std::size_t k = 0; k < open.size();) {
    const double from = open[k].cell.lower[2];
    double to = from;
    const std::string& reason = open[k].reason;
    const bool cut_short = reason == zeros::was_interrupted;
    for (; k < open.size() && open[k].reason == reason && (cut_short || open[k].cell.lower[2] <= to); ++k) {
      to = std::max(to, open[k].cell.upper[2]);
    }
    all_.unresolved.push_back(
        {between(value_at(from), value_at(to)), {}, "there may be orbits that are on no branch: " + reason});
  }
  if (far_) {
    all_.unresolved.push_back({between(std::clamp(Rational(far_->first), question_.from, question_.to),
                                       std::clamp(Rational(far_->second), question_.from, question_.to)),
                               {},
                               "there may be orbits more than thirty times as large as others"});
  }
  all_.complete = open.empty() && !far_;
}

// Two branches that overlap would be counted twice: then one of them ends on the other.
void Search::separate() {
  const auto apart = [](const Followed& branch, const Point& end, int angle) {
    return !for_some_turn(angle, end, [&](const Point& turned) {
      return std::any_of(branch.cells.begin(), branch.cells.end(),
                         [&](const Cell& cell) { return may_meet(cell, turned); });
    });
  };
  for (const Sheet& sheet : all_.sheets) {
    for (const Followed& one : sheet.branches) {
      for (const Followed& other : sheet.branches) {
        for (const Point& end : one.ends) {
          if (&one != &other && !apart(other, end, sheet.curve.angle)) {
            all_.unresolved.push_back({end.value, {}, "a branch that ends here may be part of another one"});
            all_.complete = false;
          }
        }
      }
    }
  }
}

AllFollowed Search::run() {
  if (question_.at) {
    follow_from(*question_.at);
    separate();
    return std::move(all_);
  }
  follow_from(question_.from);
  follow_from(question_.to);
  exhaust();
  separate();
  return std::move(all_);
}

}  // namespace

AllFollowed follow_all(const BranchQuestion& question) {
  return Search(question).run();
}

}  // namespace stickslip::numeric::branches
