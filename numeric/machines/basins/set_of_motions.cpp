#include "numeric/machines/basins/set_of_motions.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/machines/orbits/chain_proof.hpp"
#include "numeric/machines/orbits/judge.hpp"
#include "numeric/zeros/krawczyk.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using motion::PhaseKind;
using scalars::within;
using zeros::in_double;

namespace {

// Of Newton's method for the middle motion, and for the durations of all.
constexpr int most_newton_steps = 40;
constexpr int most_widenings = 3;

void narrow(Ball& x, const Ball& other) {
  x = zeros::intersection(x, other).value_or(other);
}

const Machine& required(const Machine& machine) {
  require_machine(machine);
  return machine;
}

// What a phase makes of a set, and how its duration depends on e.
struct After {
  Dependence u;
  Vector longer;
  Matrix longer_by;  // column l: the derivative of that by e_l
  Matrix by_u;       // u at the end by u at the beginning
};

// Its first axes span what the first columns do.
Frame frame_of(const Eigen::MatrixXd& columns, const Vector& units) {
  const Eigen::VectorXd in = in_double(units);
  const Matrix Q = orthogonal(in.cwiseInverse().asDiagonal() * columns);
  Frame frame{Q, Q.transpose()};
  for (Eigen::Index i = 0; i < units.size(); ++i) {
    frame.axes.row(i) *= units(i);
    frame.back.col(i) /= units(i);
  }
  return frame;
}

// The longest come first.
Eigen::MatrixXd by_length(const Eigen::MatrixXd& columns, const Vector& units) {
  std::vector<std::pair<double, Eigen::Index>> sizes;
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    sizes.emplace_back(-columns.col(k).cwiseQuotient(in_double(units)).norm(), k);
  }
  std::ranges::sort(sizes);
  Eigen::MatrixXd sorted = columns;
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    sorted.col(k) = columns.col(sizes[static_cast<std::size_t>(k)].second);
  }
  return sorted;
}

// u(0) after a phase that takes exact to y.
void move_offset(SetOfMotions& to, const SetOfMotions& from, const Matrix& by_u, const Vector& y,
                 const Vector& units) {
  Eigen::MatrixXd columns = in_double(by_u) * in_double(from.frame.axes);
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    columns.col(k) *= abs(from.offset(k)).upper().approximate() + 1e-300;
  }
  to.exact = zeros::midpoints(y);
  to.frame = frame_of(by_length(columns, units), units);
  const Matrix& back = to.frame.back;
  to.offset = sparse_product(sparse_product(back, sparse_product(by_u, from.frame.axes)), from.offset) +
              sparse_product(back, Vector(y - to.exact));
  const Vector here = to.exact + sparse_product(to.frame.axes, to.offset);
  for (Eigen::Index i = 0; i < here.size(); ++i) {
    narrow(to.middle.value(i), here(i));
    // The way from exact to u(0) lies in what derivatives are looked at over.
    to.middle.value(i) = Ball::hull(to.middle.value(i), to.exact(i));
  }
}

// The phase ends at the zero of the row `event`; without one, at a time that all have in common. `known`: a
// row of u that does not depend on e.
After after(const Passage& passage, const Matrix& drift, const Dependence& u, Eigen::Index known,
            const Vector * event, const Vector& units) {
  const Eigen::Index rows = u.value.size(), states = rows - 1, loads = drift.rows() - states;
  const Vector& v = passage.arrives;
  const Ball rate = event == nullptr ? Ball(1) : dot(*event, v);
  // By u: w after the same duration for all, the duration, and u at the end.
  Matrix unit = Matrix::Identity(rows, rows);
  unit(known, known) = Ball(0);
  const Vector time = unit.row(0).transpose();
  Matrix P(drift.rows(), rows);
  P.topRows(states) = after_duration(passage, {time, unit.bottomRows(states)});
  P.bottomRows(loads) = v.tail(loads) * time.transpose();
  Vector h = -time;
  for (Eigen::Index k = 0; event != nullptr && k < rows; ++k) {
    h(k) = -dot(*event, P.col(k)) / rate;
  }
  Matrix M(rows, rows);
  M.row(0) = (time + h).transpose();
  M.bottomRows(states) = P.topRows(states) + Matrix(v.head(states) * h.transpose());

  const Eigen::Index parameters = u.first.cols();
  After result{
      {Vector(rows), sparse_product(M, u.first), {}, {}, {}}, sparse_product(u.first.transpose(), h), {}, M};
  result.u.value.tail(states) = passage.reached.head(states);
  const bool to_second = !u.second.empty() && passage.flow.size() != 0;
  if (u.along.size() == 0 && !to_second) {
    return result;
  }
  // What is longest lies along the frame's first axes.
  result.u.frame = frame_of(in_double(M) * in_double(u.frame.axes), units);
  const Matrix& back = result.u.frame.back;
  const Matrix along = sparse_product(back, sparse_product(M, u.frame.axes));
  if (u.along.size() != 0) {
    result.u.along = sparse_product(along, u.along);
    const Matrix first = sparse_product(result.u.frame.axes, result.u.along);
    for (Eigen::Index i = 1; i < rows; ++i) {
      for (Eigen::Index k = 0; k < parameters; ++k) {
        narrow(result.u.first(i, k), first(i, k));
      }
    }
  }
  if (!to_second) {
    return result;
  }
  const Vector h_along = sparse_product(u.frame.axes.transpose(), h);
  Vector turns = Vector::Constant(drift.rows(), Ball(0));
  turns.tail(loads) = sparse_product(drift, passage.leaves).tail(loads);
  turns = sparse_product(passage.flow, turns);
  const Vector a = sparse_product(drift, v);
  const Matrix change = sparse_product(drift, sparse_product(P, u.first));
  const Vector& longer = result.longer;
  result.longer_by = Matrix::Constant(parameters, parameters, Ball(0));
  result.u.second.assign(static_cast<std::size_t>(parameters), Matrix(rows, parameters));
  for (Eigen::Index k = 0; k < parameters; ++k) {
    const auto at_k = static_cast<std::size_t>(k);
    const Matrix linear = sparse_product(along, u.second[at_k]);
    const Vector of_h = sparse_product(u.second[at_k].transpose(), h_along);
    for (Eigen::Index l = k; l < parameters; ++l) {
      Vector y = change.col(k) * longer(l) + change.col(l) * longer(k) + a * Ball(longer(k) * longer(l));
      if (!is_zero(u.first(0, k)) && !is_zero(u.first(0, l))) {
        y += turns * Ball(u.first(0, k) * u.first(0, l));
      }
      Vector more(rows);
      more(0) = event == nullptr ? Ball(0) : Ball(-dot(*event, y) / rate);
      more.tail(states) = y.head(states) + v.head(states) * more(0);
      result.longer_by(k, l) = result.longer_by(l, k) = of_h(l) + more(0);
      const Vector second = linear.col(l) + sparse_product(back, more);
      result.u.second[at_k].col(l) = second;
      result.u.second[static_cast<std::size_t>(l)].col(k) = second;
    }
  }
  return result;
}

}  // namespace

Matrix Dependence::derivative_of_first(std::size_t k) const {
  return sparse_product(frame.axes, second[k]);
}

Ball SetOfMotions::reach(const Vector& row) const {
  Ball sum(0);
  for (const Ball& x : row) {
    const Ball size = abs(x).upper();
    sum += round ? Ball(size * size) : size;
  }
  return within(round ? Ball(sqrt(sum)) : sum);
}

SetOfMotions set_at(const Ball& time, const Piece& piece, const Vector& middle, const Matrix& S, bool round) {
  const Eigen::Index rows = S.rows() + 1, parameters = S.cols();
  SetOfMotions set{{}, piece, {}, round, false, {}, {}, {}, {}, {}};
  set.middle.value.resize(rows);
  set.middle.value << time, middle;
  set.middle.first.resize(rows, parameters);
  set.middle.first << Matrix::Constant(1, parameters, Ball(0)), S;
  set.all = set.middle;
  for (Eigen::Index i = 1; i < rows; ++i) {
    set.all.value(i) += set.reach(set.all.first.row(i).transpose());
  }
  set.all.second.assign(static_cast<std::size_t>(parameters), Matrix::Constant(rows, parameters, Ball(0)));
  set.all.frame = set.middle.frame = set.frame = {Matrix::Identity(rows, rows), Matrix::Identity(rows, rows)};
  set.middle.along = set.middle.first;
  set.exact = zeros::midpoints(set.middle.value);
  set.offset = set.middle.value - set.exact;
  return set;
}

SetFlow::SetFlow(const Machine& machine)
    : machine_(required(machine)),
      phases_(oscillator_as<Ball>(machine)),
      in_double_(oscillator_as<double>(machine)),
      simulation_(in_double_, 0,
                  Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * machine.oscillator.size()))) {
  const Vector& w = phases_.units();
  const Eigen::Index states = 2 * phases_.masses();
  units_.resize(1 + states);
  units_ << w(0) / w(states - 1), w.head(states);
}

Vector SetFlow::whole(const Vector& u) const {
  return phases_.whole(u.tail(u.size() - 1), phases_.oscillator().omega * u(0));
}

std::optional<Piece> SetFlow::piece_of(const Vector& states, const Ball& time) const {
  const model::FrictionOscillator<Ball>& o = phases_.oscillator();
  const Ball relative = o.V - states(phases_.speed_row());
  if (is_zero(relative)) {
    const Ball r = dot(phases_.friction_at_rest(), phases_.whole(states, o.omega * time));
    const bool sticks = (o.forward.at_rest - r).is_positive() && (o.backward.at_rest + r).is_positive();
    return sticks ? std::optional(Piece{}) : std::nullopt;
  }
  if (!relative.is_positive() && !relative.is_negative()) {
    return std::nullopt;
  }
  const int side = relative.is_positive() ? 1 : -1;
  const model::FrictionLaw<Ball>& law = o.law(side);
  Piece piece = Piece::sliding(side);
  for (std::size_t k = 1; k < law.pieces(); ++k) {
    const Ball above = Ball(side) * relative - law.sliding[k].from;
    if (above.is_positive()) {
      piece.number = static_cast<int>(k);
    } else if (!above.is_negative()) {
      return std::nullopt;
    }
  }
  return piece;
}

// At a time, the time, at an event x_j'.
Eigen::Index SetFlow::known_row(const SetOfMotions& set) const {
  return set.before ? 1 + phases_.speed_row() : 0;
}

Verdict SetFlow::judge(const SetOfMotions& set, const Ball& duration, const std::optional<Piece>& after,
                       const SetOfMotions& end) const {
  std::vector<motion::Condition> conditions;
  judge_phase(conditions, phases_, machine_.oscillator,
              {set.before, set.piece, after, set.time(), duration,
               InData<Matrix>(Matrix(whole(set.all.value))), InData<Matrix>(Matrix(whole(end.all.value)))});
  for (const motion::Condition& condition : conditions) {
    if (condition.verdict.truth != Truth::proved) {
      return Verdict::undecided(condition.statement + ": " + condition.verdict.reason);
    }
  }
  return Verdict::proved();
}

namespace {

// Where the exact one, the middle one and all of them are.
SetOfMotions reached(const SetOfMotions& set, const Vector& exact, const After& middle, const After& all,
                     const Vector& units) {
  SetOfMotions end{set.before, set.piece, set.passed, set.round, set.timeless, middle.u, all.u, {}, {}, {}};
  move_offset(end, set, all.by_u, exact, units);
  for (std::size_t k = 0; k < end.all.second.size(); ++k) {
    const Matrix second = end.all.derivative_of_first(k);
    for (Eigen::Index i = 0; i < second.rows(); ++i) {
      const auto column = static_cast<Eigen::Index>(k);
      narrow(end.all.first(i, column), end.middle.first(i, column) + end.reach(second.row(i).transpose()));
    }
  }
  for (Eigen::Index i = 0; i < end.middle.value.size(); ++i) {
    narrow(end.all.value(i), end.middle.value(i) + end.reach(end.all.first.row(i).transpose()));
    end.all.value(i) = Ball::hull(end.all.value(i), end.exact(i));
  }
  return end;
}

// A number that all have in common.
void fix(SetOfMotions& set, Eigen::Index row, const Ball& value) {
  for (Dependence * one : {&set.middle, &set.all}) {
    one->value(row) = value;
    one->first.row(row).setConstant(Ball(0));
  }
  set.exact(row) = value.midpoint();
}

}  // namespace

Verdict SetFlow::to_event(SetOfMotions& set, const Piece& after_it, double about) const {
  const Ball speed(speed_between(machine_.oscillator, set.piece, after_it));
  const Vector event = event_between(phases_, set.piece, after_it, speed);
  const Matrix& drift = phases_.drift(set.piece);
  const Eigen::Index known = known_row(set);
  // The middle one.
  const Vector w = whole(set.exact);
  const double enough = std::exp2(-0.55 * static_cast<double>(WorkingPrecision::bits()));
  Ball h(about), distance, step;
  for (int k = 0; k < most_newton_steps; ++k) {
    const Passage there = passage(phases_, set.piece, w, h, false);
    distance = dot(event, there.reached);
    step = -distance / dot(event, there.arrives);
    if (!(abs(step).upper().approximate() > enough * std::abs(h.approximate()))) {
      break;
    }
    h = Ball(h + step).midpoint();
  }
  if (!step.is_finite() || !h.is_positive()) {
    return Verdict::undecided("the event of the middle motion is not found");
  }
  const Vector w_middle = whole(set.middle.value);
  const Passage at_middle = passage(phases_, set.piece, w_middle, h, false);
  const Ball off = dot(event, at_middle.reached);
  const Ball width = within(Ball(off / dot(event, at_middle.arrives)) * Ball(4)) + within(step * Ball(4));
  const Ball near = h + width;
  const Ball rate = dot(event, passage(phases_, set.piece, w_middle, near, false).arrives);
  const Ball taken = h - off / rate;
  if (!taken.is_interior_to(near)) {
    return Verdict::undecided("the end of a phase of the middle motion cannot be enclosed");
  }
  const Ball exactly = h - distance / rate;
  Vector exact(set.exact.size());
  exact << set.exact(0) + exactly,
      passage(phases_, set.piece, w, exactly, false).reached.head(set.exact.size() - 1);
  After middle =
      after(passage(phases_, set.piece, w_middle, taken, true), drift, set.middle, known, &event, units_);
  middle.u.value(0) = set.time() + taken;
  // All of them: the derivative of the duration is looked at so far around.
  Ball around = set.reach(middle.longer) * Ball(Rational(9, 8)) + width;
  for (int k = 0;; ++k) {
    const Ball ample = taken + around;
    After all = after(passage(phases_, set.piece, whole(set.all.value), ample, true), drift, set.all, known,
                      &event, units_);
    for (Eigen::Index i = 0; i < all.longer_by.rows(); ++i) {
      narrow(all.longer(i), middle.longer(i) + set.reach(all.longer_by.row(i).transpose()));
    }
    const Ball durations = taken + set.reach(all.longer);
    if (!durations.is_interior_to(ample)) {
      if (k == most_widenings || !durations.is_finite()) {
        return Verdict::undecided("the ends of a phase cannot be enclosed");
      }
      around = (durations - taken) * Ball(Rational(5, 4)) + width;
      continue;
    }
    all.u.value(0) = set.all.value(0) + durations;
    SetOfMotions end = reached(set, exact, middle, all, units_);
    end.before = set.piece;
    end.piece = after_it;
    end.passed.push_back(after_it);
    fix(end, 1 + phases_.speed_row(), speed);
    Verdict verdict = judge(set, durations, after_it, end);
    if (set.timeless) {
      fix(end, 0, end.time());
    }
    set = end;
    return verdict;
  }
}

Verdict SetFlow::to_time(SetOfMotions& set, const Ball& time) const {
  const Ball durations = time - set.all.value(0);
  if (!durations.is_positive()) {
    return Verdict::undecided("a motion has passed the time already");
  }
  const Matrix& drift = phases_.drift(set.piece);
  const Eigen::Index known = known_row(set);
  const auto ends = [&](const Dependence& u, const Ball& duration) {
    After end =
        after(passage(phases_, set.piece, whole(u.value), duration, true), drift, u, known, nullptr, units_);
    end.u.value(0) = time;
    return end;
  };
  Vector exact(set.exact.size());
  exact << time, passage(phases_, set.piece, whole(set.exact), time - set.exact(0), false)
                     .reached.head(set.exact.size() - 1);
  SetOfMotions end =
      reached(set, exact, ends(set.middle, time - set.time()), ends(set.all, durations), units_);
  fix(end, 0, time);
  end.before.reset();
  if (set.piece.kind == PhaseKind::stick) {
    fix(end, 1 + phases_.speed_row(), phases_.oscillator().V);
  }
  Verdict verdict = judge(set, durations, {}, end);
  set = end;
  return verdict;
}

std::vector<MachineGuess::Event> SetFlow::events(const SetOfMotions& set, double duration) const {
  const double begin = set.time().approximate();
  const Vector X = set.middle.value.tail(set.middle.value.size() - 1);
  simulation_.restart(in_double_.omega * begin, in_double(X));
  std::vector<simulation::AnySimulation::Transition> log;
  simulation_.advance(duration, &log);
  return events_of(in_double_, log, -begin);
}

Verdict SetFlow::follow(SetOfMotions& set, const Ball& time) const {
  for (const MachineGuess::Event& event : events(set, Ball(time - set.time()).approximate())) {
    const Verdict verdict = to_event(set, event.begins, event.t - set.time().approximate());
    if (verdict.truth != Truth::proved) {
      return verdict;
    }
  }
  return to_time(set, time);
}

}  // namespace stickslip::numeric::machines
