#include "numeric/machines/orbits/chain.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using motion::PhaseKind;
using zeros::product;

namespace {

// On a smooth law rounding grows along a phase: so many bits more are kept there.
constexpr long more_bits = 64;

LinearPhases phases_of(const MachineQuestion& question) {
  if (question.machines) {
    return LinearPhases(*question.machines);
  }
  const WorkingPrecision scope(WorkingPrecision::bits() + more_bits);
  LinearPhases phases(oscillator_as<Ball>(question.machine));
  for (const Piece& piece : question.pieces) {
    if (phases.is_smooth(piece)) {
      (void)phases.drift(piece);  // kept, with these bits
    }
  }
  return phases;
}

}  // namespace

Node Link::response(const Node& F) const {
  const Eigen::Index last = F.size() - 1;
  Node d = end_velocity * Ball(-F(last) / rate);
  d.tail(last) -= F.head(last);
  return d;
}

Nodes midpoints(const Nodes& nodes) {
  Nodes result;
  std::transform(nodes.begin(), nodes.end(), std::back_inserter(result),
                 [](const Node& u) { return zeros::midpoints(u); });
  return result;
}

Chain::Chain(const MachineQuestion& question)
    : autonomous_(question.machine.oscillator.is_autonomous()),
      pieces_(question.pieces),
      phases_(phases_of(question)),
      others_(phases_.rows_but_speed()) {
  const model::FrictionOscillator<Ball>& o = phases_.oscillator();
  if (!autonomous_) {
    turn_ = Ball(2 * question.periods) * Ball::pi() / o.omega;
  }
  for (std::size_t i = 0; i < size(); ++i) {
    const Piece &before = pieces_[(i + size() - 1) % size()], &after = pieces_[i];
    if (question.machines) {
      speeds_in_data_.push_back(speed_between(question.machines->numbers, before, after));
      speeds_.push_back(speeds_in_data_.back().all());
    } else {
      speeds_.emplace_back(speed_between(question.machine.oscillator, before, after));
    }
  }
  if (question.machines && !autonomous_) {
    omega_in_data_ = phases_.number([](const auto& one) { return one.omega; });
    turn_in_data_ = reciprocal(omega_in_data_) * (Ball(2 * question.periods) * Ball::pi());
  }
}

Node Chain::next(const Nodes& nodes, std::size_t i) const {
  if (i + 1 < nodes.size()) {
    return nodes[i + 1];
  }
  Node node = nodes.front();
  if (!autonomous_) {
    node(0) += turn_;
  }
  return node;
}

Ball Chain::duration(const Nodes& nodes, std::size_t i) const {
  const Node to = next(nodes, i);
  return autonomous_ ? to(0) : Ball(to(0) - nodes[i](0));
}

Vector Chain::with(const Ball& speed, const Node& node) const {
  Vector state(node.size());
  state(others_) = node.tail(node.size() - 1);
  state(phases_.speed_row()) = speed;
  return state;
}

Vector Chain::state(const Nodes& nodes, std::size_t i) const {
  return with(speeds_[i], nodes[i]);
}

Vector Chain::beginning(const Nodes& nodes, std::size_t i) const {
  return phases_.whole(state(nodes, i), phases_.oscillator().omega * nodes[i](0));
}

Vector Chain::event(std::size_t i) const {
  const std::size_t following = (i + 1) % size();
  return event_between(phases_, pieces_[i], pieces_[following], speeds_[following]);
}

Passage Chain::course(const Nodes& nodes, std::size_t i, bool with_derivative) const {
  const Ball h = duration(nodes, i);
  if (phases_.is_smooth(pieces_[i]) && !with_derivative) {  // of a derivative less is asked
    const WorkingPrecision scope(WorkingPrecision::bits() + more_bits);
    return passage(phases_, pieces_[i], beginning(nodes, i), h, false);
  }
  return passage(phases_, pieces_[i], beginning(nodes, i), h, with_derivative);
}

Node Chain::conditions(const Nodes& nodes, std::size_t i) const {
  return conditions(nodes, i, course(nodes, i, false).reached);
}

Node Chain::conditions(const Nodes& nodes, std::size_t i, const Vector& reached) const {
  const Eigen::Index n = phases_.masses();
  Node F(2 * n);
  F.head(2 * n - 1) = next(nodes, i).tail(2 * n - 1) - without(reached);
  F(2 * n - 1) = dot(event(i), reached);
  return F;
}

Spread Chain::spread() const {
  const Eigen::Index n = phases_.masses();
  Spread node{Vector::Constant(2 * n, Ball(0)), Matrix::Constant(2 * n, 2 * n, Ball(0))};
  if (!autonomous_) {
    node.time(0) = Ball(1);
  }
  for (Eigen::Index k = 1; k < 2 * n; ++k) {
    node.state(others_[static_cast<std::size_t>(k - 1)], k) = Ball(1);
  }
  return node;
}

InData<Ball> Chain::duration(const NodesInData& nodes, std::size_t i) const {
  const auto time = [](const Matrix& node) { return node(0, 0); };
  InData<Ball> h = mapped(nodes[(i + 1) % size()], time);
  if (!autonomous_) {
    h += mapped(nodes[i], time) * Ball(-1);
    if (i + 1 == size()) {
      h += turn_in_data_;
    }
  }
  return h;
}

InData<Matrix> Chain::beginning(const NodesInData& nodes, std::size_t i) const {
  InData<Matrix> state = mapped(nodes[i], [&](const Matrix& node) { return Matrix(with(Ball(0), node)); });
  state += mapped(speeds_in_data_[i], [&](const Ball& speed) {
    return Matrix(with(speed, Node::Constant(2 * phases_.masses(), Ball(0))));
  });
  InData<Ball> theta(Ball(0));
  if (!autonomous_) {
    theta = omega_in_data_ * mapped(nodes[i], [](const Matrix& node) { return node(0, 0); });
  }
  return phases_.whole(state, theta);
}

InData<Matrix> Chain::event_in_data(std::size_t i) const {
  const std::size_t following = (i + 1) % size();
  const int side = pieces_[following].side();
  const auto at_rest = [&](const auto& o) { return o.law(side).at_rest * Ball(side); };
  const InData<Ball> bound =
      pieces_[i].kind == PhaseKind::stick ? phases_.number(at_rest) : speeds_in_data_[following];
  InData<Matrix> event = phases_.watched(pieces_[i]);
  event -= mapped(bound, [&](const Ball& x) { return Matrix((phases_.one() * x).transpose()); });
  return event;
}

PassageInData Chain::course(const NodesInData& nodes, std::size_t i, bool with_derivative) const {
  return passage(phases_, pieces_[i], beginning(nodes, i), duration(nodes, i), with_derivative);
}

InData<Matrix> Chain::conditions(const NodesInData& nodes, std::size_t i) const {
  return conditions(nodes, i, course(nodes, i, false).reached);
}

InData<Matrix> Chain::conditions(const NodesInData& nodes, std::size_t i,
                                 const InData<Matrix>& reached) const {
  const Eigen::Index n = phases_.masses();
  InData<Matrix> apart = mapped(reached, [&](const Matrix& w) { return Matrix(-without(w)); });
  apart +=
      mapped(nodes[(i + 1) % size()], [&](const Matrix& node) { return Matrix(node.bottomRows(2 * n - 1)); });
  InData<Matrix> F = mapped(apart, [&](const Matrix& x) { return placed(x, 0, 2 * n); });
  F += mapped(event_in_data(i) * reached, [&](const Matrix& x) { return placed(x, 2 * n - 1, 2 * n); });
  return F;
}

// As at_event.
Link Chain::link(const NodesInData& nodes, std::size_t i) const {
  const Eigen::Index states = 2 * phases_.masses();
  const auto top = [&](const Matrix& w) { return Matrix(w.topRows(states)); };
  const auto left = [&](const Matrix& row) { return Matrix(row.leftCols(states)); };
  const auto of_loads = [&](const Matrix& w) { return Matrix(w.bottomRows(w.rows() - states)); };
  const auto from_loads = [&](const Matrix& A) { return Matrix(A.rightCols(A.cols() - states)); };
  const PassageInData phase = course(nodes, i, true);
  const InData<Matrix>& arrives = phase.arrives;
  const InData<Matrix> event = event_in_data(i);
  const Spread node = spread();
  const Matrix time = node.time.transpose();
  const auto by_time = [&](const InData<Matrix>& x) {
    return mapped(x, [&](const Matrix& column) { return Matrix(zeros::product(column, time)); });
  };
  // (x, x') after the duration, by the node, and how much longer it takes to the event.
  InData<Matrix> state = mapped(phase.derivative, [&](const Matrix& derivative) {
    return Matrix(zeros::product(derivative, node.state));
  });
  state += by_time(phase.by_time);
  InData<Matrix> late = mapped(event, left) * state;
  late += by_time(mapped(event, from_loads) * mapped(arrives, of_loads));
  const InData<Ball> rate = mapped(event * arrives, [](const Matrix& x) { return x(0, 0); });
  const InData<Matrix> longer = product(
      late, reciprocal(rate), [](const Matrix& row, const Ball& x) { return Matrix(row * Ball(-x)); });
  state += mapped(arrives, top) * longer;
  InData<Matrix> times = longer;
  times += InData<Matrix>(time);
  Link link{mapped(times, [&](const Matrix& row) { return placed(row, 0, states); }), Node(states),
            rate.all(), conditions(nodes, i, phase.reached).all()};
  link.M += mapped(state, [&](const Matrix& A) { return placed(without(A), 1, states); });
  link.end_velocity << Ball(1), without(arrives.all());
  return link;
}

std::vector<double> Chain::changes(const NodesInData& nodes) const {
  const Vector units = phases_.units();
  std::vector<double> changes;
  for (std::size_t k = 1; k <= data(); ++k) {
    double sum = 0;
    const auto size = [&](const auto& f, const auto& of) {
      const std::size_t place = place_of(k);
      sum += place < f.c.size() && !is_none(f.c[place]) ? of(f.c[place]) : 0;
    };
    for (std::size_t i = 0; i < this->size(); ++i) {
      const double h = duration(nodes, i).c[0].approximate();
      const auto in_units = [&](const Matrix& B) { return size_in(units, B).approximate(); };
      const auto in_unit = [&](const Matrix& w) {
        return zeros::norm(Matrix(units.cwiseInverse().asDiagonal() * w)).approximate();
      };
      const InData<Matrix>& B = phases_.drift_in_data(pieces_[i]);
      size(B, [&](const Matrix& by_datum) { return std::abs(h) * in_units(by_datum); });
      size(duration(nodes, i), [&](const Ball& x) { return std::abs(x.approximate()) * in_units(B.c[0]); });
      size(beginning(nodes, i), in_unit);
    }
    changes.push_back(sum);
  }
  return changes;
}

Link Chain::link(const Nodes& nodes, std::size_t i) const {
  const Eigen::Index n = phases_.masses();
  const Passage course = this->course(nodes, i, true);
  const Vector D = event(i);
  const Spread reached = at_event(course, D, spread());
  Link link;
  link.end_velocity.resize(2 * n);
  link.end_velocity << Ball(1), without(course.arrives);
  link.rate = dot(D, course.arrives);
  link.conditions = conditions(nodes, i, course.reached);
  Matrix M(2 * n, 2 * n);
  M << reached.time.transpose(), without(reached.state);
  link.M = InData<Matrix>(M);
  return link;
}

}  // namespace stickslip::numeric::machines
