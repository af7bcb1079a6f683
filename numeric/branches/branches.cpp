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
  return {{a.chi.middle, a.eta.middle, a.us.middle, a.V.middle, a.omega.middle, a.p.middle},
          of(q.phi),
          of(q.ur)};
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
  for (const Range& range : {question.orbits.parameters.chi, question.orbits.parameters.eta,
                             question.orbits.parameters.us, question.orbits.parameters.V,
                             question.orbits.parameters.omega, question.orbits.parameters.p,
                             question.orbits.phi.value_or(Range{}), question.orbits.ur.value_or(Range{})}) {
    if (range.radius != 0) {
      throw UsageError("a branch is along one interval A..B: all other parameters are exact");
    }
  }
  require_answerable(
      with(question, {(question.from + question.to) / 2, (question.to - question.from) / 2}));
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
  law.conditions = [&family](const ClosedMotion& closed, const std::optional<Ball>& ur) {
    return families::conditions(family, closed, ur);
  };
  return law;
}

// One system of closing conditions of the family, and the branches found on it.
struct Sheet {
  int system = 0;
  Curve curve;
  std::vector<std::vector<Cell>> branches;
};

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
// among them, where it is very near: why a branch cannot be followed, most likely.
std::string resonance_near(const Point& point, const Curve& curve) {
  zeros::Vector p = curve.data;
  p(curve.place) = point.value;
  const model::Modes<double> m = model::modes<double>(p(0).approximate(), p(1).approximate());
  const double omega = p(4).approximate();
  for (const auto& [frequency, name] :
       {std::pair(m.omega1, "omega1"), std::pair(1.0, "1"), std::pair(m.omega2, "omega2")}) {
    const double k = std::round(frequency / omega);
    if (k >= 1 && std::abs(k * omega - frequency) < 1e-3 * frequency) {
      return fmt::format(", next to the resonance {} omega = {}", k == 1 ? "" : fmt::format("{:.0f}", k), name);
    }
  }
  return "";
}

BranchEnd end_of(const Path& path, const Sheet& sheet, const BranchQuestion& question) {
  BranchEnd end{path.last.value, words_of(path, question), path.end != End::stopped};
  if (path.end == End::stopped) {
    end.words += resonance_near(path.last, sheet.curve);
  }
  if (path.end == End::interval) {
    const bool above = (path.last.value - Ball((question.from + question.to) / 2)).is_positive();
    end.at = Ball(above ? question.to : question.from);
  }
  return end;
}

// Whether the motion at the point is on a branch of the sheet, seen with its angle as it is or turned.
bool is_known(const Sheet& sheet, const Point& point, int angle) {
  for (int turn = angle < 0 ? 0 : -2; turn <= (angle < 0 ? 0 : 2); ++turn) {
    Point turned = point;
    if (turn != 0) {
      turned.x(angle) += Ball(2 * turn) * Ball::pi();
    }
    for (const std::vector<Cell>& branch : sheet.branches) {
      if (std::any_of(branch.begin(), branch.end(), [&](const Cell& c) { return is_on(c, turned); })) {
        return true;
      }
    }
  }
  return false;
}

class Search {
 public:
  explicit Search(const BranchQuestion& question) : question_(question), law_(law_of(question)) {
    list_.question = question;
  }

  BranchList run();

 private:
  void follow_from(const Rational& value);
  void add(const Candidate& candidate, const Rational& value);
  [[nodiscard]] Sheet& sheet_of(const Candidate& candidate);
  void trace(const Sheet& sheet, const Path& down, const Path& up, std::vector<Cell> cells);
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
  sheets_.push_back({candidate.system, curve_of(question_, candidate.equations), {}});
  return sheets_.back();
}

void Search::trace(const Sheet& sheet, const Path& down, const Path& up, std::vector<Cell> cells) {
  Branch branch;
  branch.cells = cells.size();
  branch.closed = up.end == End::closed;
  branch.first = end_of(branch.closed ? up : down, sheet, question_);
  branch.last = end_of(up, sheet, question_);
  const std::vector<Part> parts = parts_of(sheet.curve, law_, cells, resolution / 8);
  describe({sheet.curve, law_, cells, parts}, branch, list_.unresolved);
  for (const BranchEnd * end : {&branch.first, &branch.last}) {
    if (!end->resolved) {
      list_.unresolved.push_back({end->at, {}, end->words});
    }
  }
  if (!branch.pieces.empty()) {
    list_.branches.push_back(std::move(branch));
  }
}

void Search::add(const Candidate& candidate, const Rational& value) {
  Sheet& sheet = sheet_of(candidate);
  const ProvedPoint start =
      prove_at(sheet.curve, value, candidate.equations.unknowns(candidate.guess));
  const auto report = [&](const std::string& reason) {
    list_.unresolved.push_back({Ball(value), candidate.where, reason});
  };
  if (start.verdict.truth != Truth::proved) {
    return report(start.verdict.reason);
  }
  const Driven f{&sheet.curve, by_parameter};
  if (!candidate.is_same(f.motion<Ball>(start.point.x, zeros::Vector::Constant(1, start.point.value)))) {
    return report("the motion that was proved near a zero may be another one");
  }
  if (is_known(sheet, start.point, candidate.angle)) {
    return;
  }
  Path up = follow(sheet.curve, value, start.point, 1);
  Path down = up.end == End::closed ? Path{} : follow(sheet.curve, value, start.point, -1);
  std::vector<Cell> cells = reversed(std::move(down.cells));
  std::ranges::move(up.cells, std::back_inserter(cells));
  sheet.branches.push_back(cells);
  trace(sheet, down, up, std::move(cells));
}

void Search::follow_from(const Rational& value) {
  const Found found = question_.orbits.family->search(exact(with(question_, {value})));
  for (const Unresolved& open : found.unresolved) {
    list_.unresolved.push_back({Ball(value), open.where, open.reason});
  }
  for (const Candidate& candidate : found.candidates) {
    add(candidate, value);
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
  std::sort(ends.begin(), ends.end(),
            [](const Ball& a, const Ball& b) { return arf_cmp(arb_midref(a.raw()), arb_midref(b.raw())) < 0; });
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
  const Rational value = question_.at.value_or((question_.from + question_.to) / 2);
  list_.followed_from = value;
  list_.why_not_searched = fmt::format(
      "followed from the orbits at {} = {}: branches that do not reach this value are not looked for",
      question_.parameter, stickslip::to_string(value));
  follow_from(value);
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
  }
  throw InternalError("a change of no known kind");
}

BranchList list_branches(const BranchQuestion& question) {
  require_question(question);
  return Search(question).run();
}

}  // namespace stickslip::numeric::branches
