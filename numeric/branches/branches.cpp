#include "numeric/branches/branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "numeric/branches/changes.hpp"
#include "numeric/families/family.hpp"

namespace stickslip::numeric::branches {

using namespace families;
using namespace motion;

namespace {

// Between the values at which all orbits are looked for, when none is given.
constexpr int intervals = 8;

constexpr std::array parameters{"chi", "eta", "us", "V", "omega", "p", "phi", "ur"};

// The datum of that name in a question; nothing where it is not one of the family's.
Range * datum(OrbitQuestion& q, const std::string& name) {
  model::Parameters<Range>& a = q.parameters;
  const std::array<Range *, 6> all{&a.chi, &a.eta, &a.us, &a.V, &a.omega, &a.p};
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (name == parameters[k]) {
      return all[k];
    }
  }
  std::optional<Range>& other = name == "phi" ? q.phi : q.ur;
  if (!other) {
    other = Range{};
  }
  return &*other;
}

// The question with the free parameter in this range.
OrbitQuestion with(const BranchQuestion& question, const Range& range) {
  OrbitQuestion q = question.orbits;
  *datum(q, question.parameter) = range;
  return q;
}

Given<Rational> exact(const OrbitQuestion& q) {
  const model::Parameters<Range>& a = q.parameters;
  const auto of = [](const std::optional<Range>& range) {
    return range ? std::optional(range->middle) : std::nullopt;
  };
  return {
      {a.chi.middle, a.eta.middle, a.us.middle, a.V.middle, a.omega.middle, a.p.middle}, of(q.phi), of(q.ur)};
}

void require_question(const BranchQuestion& question) {
  if (std::find(parameters.begin(), parameters.end(), question.parameter) == parameters.end()) {
    throw UsageError(fmt::format("'{}' is none of {}, which a branch can be along", question.parameter,
                                 "chi, eta, us, V, omega, p, phi and ur"));
  }
  if (question.from >= question.to) {
    throw UsageError(fmt::format("{}: {}..{} does not rise: A..B needs A < B", question.parameter,
                                 stickslip::to_string(question.from), stickslip::to_string(question.to)));
  }
  if (question.at && (*question.at < question.from || *question.at > question.to)) {
    throw UsageError(fmt::format("at: {} = {} is not in the interval {}..{}", question.parameter,
                                 stickslip::to_string(*question.at), stickslip::to_string(question.from),
                                 stickslip::to_string(question.to)));
  }
  for (const Range& range :
       {question.orbits.parameters.chi, question.orbits.parameters.eta, question.orbits.parameters.us,
        question.orbits.parameters.V, question.orbits.parameters.omega, question.orbits.parameters.p,
        question.orbits.phi.value_or(Range{}), question.orbits.ur.value_or(Range{})}) {
    if (range.radius != 0) {
      throw UsageError("a branch is along one interval A..B: all other parameters are exact");
    }
  }
  require_answerable(with(question, {(question.from + question.to) / 2, (question.to - question.from) / 2}));
}

Law law_of(const BranchQuestion& question) {
  const Family& family = *question.orbits.family;
  const OrbitQuestion& q = question.orbits;
  Law law;
  law.ur_is_result = has_stick(family);
  law.ur_is_free = !law.ur_is_result && question.parameter == "ur";
  if (!law.ur_is_result && !law.ur_is_free && q.ur) {
    law.ur = q.ur->middle;
  }
  law.requirements = requirements(family, law.ur_is_result || law.ur_is_free || law.ur);
  if (!law.ur_is_result && !law.ur_is_free && !law.ur) {
    for (Requirement requirement : family.requirements) {
      if (needs_ur(requirement.quantity) && requirement.quantity != Quantity::friction_step) {
        requirement.id = "ur_max";
        law.at_us.push_back(requirement);
      }
    }
  }
  law.conditions = [&family](const ClosedMotion& closed, const std::optional<Ball>& ur) {
    return families::conditions(family, closed, ur);
  };
  return law;
}

// A branch that was followed from a motion both ways.
struct Followed {
  Point start;
  std::vector<Cell> cells;
  BranchEnd first, last;
  bool closed;
};

// One system of closing conditions of the family, and the branches found on it.
struct Sheet {
  int system = 0;
  int angle = -1;  // see Candidate
  Curve curve;
  std::vector<Followed> branches;
};

// The point with its angle turned by all numbers of full turns that matter.
template <class Predicate>
bool for_some_turn(int angle, const zeros::Vector& x, const Predicate& predicate) {
  for (int turn = angle < 0 ? 0 : -2; turn <= (angle < 0 ? 0 : 2); ++turn) {
    zeros::Vector turned = x;
    if (turn != 0) {
      turned(angle) += Ball(2 * turn) * Ball::pi();
    }
    if (predicate(turned)) {
      return true;
    }
  }
  return false;
}

Curve curve_of(const BranchQuestion& question, const Closing& equations) {
  const Given<Rational> given = exact(with(question, {question.from}));
  Given<Ball> balls{parameters_as<Ball>(given.data), {}, {}};
  balls.phi = given.phi ? std::optional(Ball(*given.phi)) : std::nullopt;
  balls.ur = given.ur ? std::optional(Ball(*given.ur)) : std::nullopt;
  Curve curve{equations, equations.parameters(balls), 0, question.from, question.to};
  const std::vector<std::string> names = equations.parameter_names();
  const auto found = std::find(names.begin(), names.end(), question.parameter);
  curve.place = static_cast<int>(found - names.begin());
  if (found == names.end()) {
    // The equations do not depend on it.
    curve.data.conservativeResize(curve.data.size() + 1);
    curve.data(curve.place) = Ball(question.from);
  }
  return curve;
}

std::string words_of(const Path& path, const BranchQuestion& question) {
  switch (path.end) {
    case End::interval:
      return "the end of the interval";
    case End::absent:
      return "a phase lasts no time";
    case End::closed:
      return "the branch is a closed curve";
    case End::stopped:
      return fmt::format("followed no further: {}", path.reason);
  }
  throw InternalError("a branch that ends in no known way at " + question.parameter);
}

// The integer multiple of the load's frequency that is nearest to a natural frequency, 1 (that of a stick)
// among them, where it is next to it: why nothing more is known there.
std::string resonance_near(const Ball& value, const BranchQuestion& question) {
  const Given<Rational> given = exact(with(question, {question.from}));
  model::Parameters<double> a = parameters_as<double>(given.data);
  const std::array<double *, 6> all{&a.chi, &a.eta, &a.us, &a.V, &a.omega, &a.p};
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (question.parameter == parameters[k]) {
      *all[k] = value.approximate();
    }
  }
  const model::Modes<double> m = model::modes<double>(a.chi, a.eta);
  for (const auto& [frequency, name] :
       {std::pair(m.omega1, "omega1"), std::pair(1.0, "1"), std::pair(m.omega2, "omega2")}) {
    const double k = std::round(frequency / a.omega);
    if (k >= 1 && std::abs(k * a.omega - frequency) < 1e-6 * frequency) {
      return fmt::format(", next to the resonance {}omega = {}", k == 1 ? "" : fmt::format("{:.0f} ", k),
                         name);
    }
  }
  return "";
}

BranchEnd end_of(const Path& path, const BranchQuestion& question) {
  BranchEnd end{path.last.value, words_of(path, question), path.end != End::stopped};
  if (path.end == End::stopped) {
    const std::string resonance = resonance_near(path.last.value, question);
    end.words += resonance;
    end.resonance = !resonance.empty();
  }
  if (path.end == End::interval) {
    const bool above = (path.last.value - Ball((question.from + question.to) / 2)).is_positive();
    end.at = Ball(above ? question.to : question.from);
  }
  return end;
}

bool passes(const Followed& branch, const Point& point, int angle) {
  return for_some_turn(angle, point.x, [&](const zeros::Vector& x) {
    return std::any_of(branch.cells.begin(), branch.cells.end(), [&](const Cell& cell) {
      return is_on(cell, {x, point.value});
    });
  });
}

class Search {
 public:
  explicit Search(const BranchQuestion& question) : question_(question), law_(law_of(question)) {
    list_.question = question;
  }

  BranchList run();

 private:
  void follow_from(const Rational& value);
  // False, with the reason in `why`, when no motion is proved there.
  [[nodiscard]] bool add(const Candidate& candidate, const Rational& value, std::string& why);
  [[nodiscard]] Sheet& sheet_of(const Candidate& candidate);
  void trace(const Sheet& sheet, const Followed& branch);
  void count();

  const BranchQuestion& question_;
  Law law_;
  std::vector<Sheet> sheets_;
  BranchList list_;
};

Sheet& Search::sheet_of(const Candidate& candidate) {
  const auto found = std::find_if(sheets_.begin(), sheets_.end(),
                                  [&](const Sheet& sheet) { return sheet.system == candidate.system; });
  if (found != sheets_.end()) {
    return *found;
  }
  sheets_.push_back({candidate.system, candidate.angle, curve_of(question_, candidate.equations), {}});
  return sheets_.back();
}

void Search::trace(const Sheet& sheet, const Followed& followed) {
  Branch branch;
  branch.cells = followed.cells.size();
  branch.closed = followed.closed;
  branch.first = followed.first;
  branch.last = followed.last;
  const std::vector<Part> parts = parts_of(sheet.curve, law_, followed.cells, resolution / 8);
  describe({sheet.curve, law_, followed.cells, parts}, branch, list_.unresolved);
  // A part that begins or ends with the interval is enclosed a little beyond it.
  for (Piece& piece : branch.pieces) {
    for (Ball * end : {&piece.first, &piece.last}) {
      if (!(*end - Ball(question_.to)).is_negative()) {
        *end = Ball(question_.to);
      } else if (!(*end - Ball(question_.from)).is_positive()) {
        *end = Ball(question_.from);
      }
    }
  }
  for (const BranchEnd * end : {&branch.first, &branch.last}) {
    if (!end->resolved) {
      list_.unresolved.push_back({end->at, {}, end->words, end->resonance});
    }
  }
  if (!branch.pieces.empty()) {
    list_.branches.push_back(std::move(branch));
  }
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
    why = "the motion that was proved near a zero may be another one";
    return false;
  }
  const auto same = [&](const Followed& known) { return passes(known, start.point, sheet.angle); };
  if (std::any_of(sheet.branches.begin(), sheet.branches.end(), same)) {
    return true;
  }
  Path up = follow(sheet.curve, value, start.point, 1);
  const bool closed = up.end == End::closed;
  Path down = closed ? Path{} : follow(sheet.curve, value, start.point, -1);
  Followed found{start.point, {}, end_of(closed ? up : down, question_), end_of(up, question_), closed};
  found.cells = reversed(std::move(down.cells));
  std::ranges::move(up.cells, std::back_inserter(found.cells));
  // One that was followed less far before.
  std::erase_if(sheet.branches,
                [&](const Followed& known) { return passes(found, known.start, sheet.angle); });
  sheet.branches.push_back(std::move(found));
  return true;
}

// All orbits at that value: those that are on no branch yet are followed.
void Search::follow_from(const Rational& value) {
  try {
    const Found found = question_.orbits.family->search(exact(with(question_, {value})));
    for (const Unresolved& open : found.unresolved) {
      list_.unresolved.push_back({Ball(value), open.where, open.reason});
    }
    for (const Candidate& candidate : found.candidates) {
      std::string why;
      if (!add(candidate, value, why)) {
        list_.unresolved.push_back({Ball(value), candidate.where, why});
      }
    }
  } catch (const DomainError& error) {  // a resonance at this very value
    list_.unresolved.push_back({Ball(value), {}, error.what(), true});
  }
}

// Between two neighbouring values at which a piece begins or ends nothing changes.
void Search::count() {
  std::vector<Ball> ends{Ball(question_.from), Ball(question_.to)};
  for (const Branch& branch : list_.branches) {
    for (const Piece& piece : branch.pieces) {
      ends.push_back(piece.first);
      ends.push_back(piece.last);
    }
  }
  std::sort(ends.begin(), ends.end(), [](const Ball& a, const Ball& b) {
    return arf_cmp(arb_midref(a.raw()), arb_midref(b.raw())) < 0;
  });
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    if (!(ends[k + 1] - ends[k] - Ball(resolution)).is_positive()) {
      continue;
    }
    const Ball middle = ((ends[k] + ends[k + 1]) / Ball(2)).midpoint();
    Count count{ends[k], ends[k + 1]};
    for (const Branch& branch : list_.branches) {
      for (const Piece& piece : branch.pieces) {
        if (Ball::hull(piece.first, piece.last).contains(middle)) {
          ++count.orbits;
          count.admissible += is_admissible(piece.state) ? 1 : 0;
          count.stable += piece.state == State::stable ? 1 : 0;
        }
      }
    }
    list_.counts.push_back(count);
  }
}

BranchList Search::run() {
  if (question_.at) {
    list_.values = {*question_.at};
  } else {
    for (int k = 0; k <= intervals; ++k) {
      Rational share(k, intervals);
      share.canonicalize();
      list_.values.push_back(question_.from + (question_.to - question_.from) * share);
    }
  }
  for (const Rational& value : list_.values) {
    follow_from(value);
  }
  for (const Sheet& sheet : sheets_) {
    for (const Followed& branch : sheet.branches) {
      trace(sheet, branch);
    }
  }
  count();
  list_.interrupted = interrupted();
  return std::move(list_);
}

}  // namespace

std::string to_string(State state) {
  switch (state) {
    case State::outside:
      return "outside";
    case State::absent:
      return "absent";
    case State::inadmissible:
      return "not admissible";
    case State::stable:
      return "stable";
    case State::unstable:
      return "unstable";
    case State::marginal:
      return "marginal";
    case State::undecided:
      return "undecided";
  }
  throw InternalError("a state of no known kind");
}

bool is_admissible(State state) {
  return state == State::stable || state == State::unstable || state == State::marginal;
}

std::string to_string(ChangeKind kind) {
  switch (kind) {
    case ChangeKind::fold:
      return "fold";
    case ChangeKind::condition:
      return "condition";
    case ChangeKind::stability:
      return "stability";
    case ChangeKind::birth:
      return "birth";
    case ChangeKind::resonance:
      return "resonance";
  }
  throw InternalError("a change of no known kind");
}

BranchList list_branches(const BranchQuestion& question) {
  require_question(question);
  return Search(question).run();
}

}  // namespace stickslip::numeric::branches
