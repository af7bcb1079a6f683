#include "numeric/machines/phases/passage.hpp"

#include "numeric/machines/phases/smooth_phase.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using motion::PhaseKind;
using zeros::product;

Passage passage(const LinearPhases& phases, Piece piece, const Vector& w, const Ball& h,
                bool with_derivative) {
  const Eigen::Index states = 2 * phases.masses();
  if (phases.is_smooth(piece)) {
    const SmoothPhase phase(phases, piece.side(), w, h, false, with_derivative);
    Passage result;
    result.reached = phase.end();
    result.arrives = smooth_rate(phases, piece.side(), result.reached);
    if (with_derivative) {
      result.leaves = smooth_rate(phases, piece.side(), w);
      // A shift in time of motion and load is none of the state after h.
      result.derivative = phase.derivative();
      result.by_time = result.arrives.head(states) - product(result.derivative, result.leaves.head(states));
    }
    return result;
  }
  const Matrix& B = phases.drift(piece);
  Passage result;
  if (with_derivative) {
    result.leaves = sparse_product(B, w);
    const Matrix& flow = result.flow = phases.flow(piece, h);
    const Eigen::Index loads = flow.cols() - states;
    result.reached = sparse_product(flow, w);
    result.derivative = flow.topLeftCorner(states, states);
    result.by_time = product(flow.topRightCorner(states, loads), result.leaves.tail(loads));
  } else {
    result.reached = phases.after(piece, h, w);
  }
  result.arrives = sparse_product(B, result.reached);
  return result;
}

PassageInData passage(const LinearPhases& phases, Piece piece, const InData<Matrix>& w, const InData<Ball>& h,
                      bool with_derivative) {
  const Eigen::Index states = 2 * phases.masses();
  const auto top = [&](const Matrix& A) { return Matrix(A.topRows(states)); };
  if (phases.is_smooth(piece)) {
    const model::VectorX<InData<Ball>> begin = entries(w);
    const SmoothPhaseOf<InData<Ball>> phase(phases, piece.side(), begin, h, false, with_derivative);
    const model::VectorX<InData<Ball>> end = phase.end();
    PassageInData result{together(end), {}, {}, {}, {}};
    if (with_derivative) {
      result.leaves = together(smooth_rate(phases, piece.side(), begin));
      result.arrives = together(smooth_rate(phases, piece.side(), end));
      result.derivative = together(phase.derivative());
      result.by_time = mapped(result.arrives, top) - result.derivative * mapped(result.leaves, top);
    }
    return result;
  }
  const InData<Matrix> flow = phases.flow(piece, h);
  PassageInData result{flow * w, {}, {}, {}, {}};
  if (with_derivative) {
    const InData<Matrix>& B = phases.drift_in_data(piece);
    const Eigen::Index loads = w.c[0].rows() - states;
    result.leaves = product(B, w, sparse_product<Matrix>);
    result.arrives = product(B, result.reached, sparse_product<Matrix>);
    result.derivative =
        mapped(flow, [&](const Matrix& A) { return Matrix(A.topLeftCorner(states, states)); });
    result.by_time = mapped(flow, [&](const Matrix& A) { return Matrix(A.topRightCorner(states, loads)); }) *
                     mapped(result.leaves, [&](const Matrix& A) { return Matrix(A.bottomRows(loads)); });
  }
  return result;
}

bool may_follow(const Piece& before, const Piece& after) {
  return before.kind != after.kind ||
         (after.kind != PhaseKind::stick && std::abs(before.number - after.number) == 1);
}

Vector event_between(const LinearPhases& phases, const Piece& piece, const Piece& after, const Ball& speed) {
  const model::FrictionOscillator<Ball>& o = phases.oscillator();
  if (piece.kind != PhaseKind::stick) {
    return phases.speed() - phases.one() * speed;
  }
  const bool slips = after.kind == PhaseKind::slip;
  return phases.friction_at_rest() + phases.one() * (slips ? Ball(-o.forward.at_rest) : o.backward.at_rest);
}

Matrix after_duration(const Passage& passage, const Spread& from) {
  Matrix state = sparse_product(passage.derivative, from.state);
  for (Eigen::Index k = 0; k < state.cols(); ++k) {
    if (!is_zero(from.time(k))) {
      state.col(k) += passage.by_time * from.time(k);
    }
  }
  return state;
}

Spread at_event(const Passage& passage, const Vector& event, const Spread& from) {
  const Eigen::Index states = from.state.rows(), loads = event.size() - states;
  const Ball rate = dot(event, passage.arrives);
  const Ball of_loads = dot(event.tail(loads), passage.arrives.tail(loads));
  Spread to{from.time, after_duration(passage, from)};
  for (Eigen::Index k = 0; k < from.time.size(); ++k) {
    const Ball longer = -(dot(event.head(states), to.state.col(k)) + of_loads * from.time(k)) / rate;
    to.time(k) += longer;
    to.state.col(k) += passage.arrives.head(states) * longer;
  }
  return to;
}

Ball dot(const Vector& a, const Vector& b) {
  Ball sum(0);
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (!is_zero(a(i))) {
      add_product(sum, a(i), b(i));
    }
  }
  return sum;
}

}  // namespace stickslip::numeric::machines
