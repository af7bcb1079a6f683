#include "numeric/machines/chain.hpp"

#include <algorithm>
#include <iterator>

#include "core/error.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using motion::PhaseKind;
using zeros::product;

namespace {

// On a smooth law rounding grows along a phase: so many bits more are kept there.
constexpr long more_bits = 64;

LinearPhases phases_of(const MachineQuestion& question) {
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

Node midpoint(const Node& u) {
  return u.unaryExpr([](const Ball& x) { return x.midpoint(); });
}

Nodes midpoints(const Nodes& nodes) {
  Nodes result;
  std::transform(nodes.begin(), nodes.end(), std::back_inserter(result), midpoint);
  return result;
}

Chain::Chain(const MachineQuestion& question)
    : autonomous_(question.machine.oscillator.is_autonomous()),
      pieces_(question.pieces),
      phases_(phases_of(question)) {
  const model::FrictionOscillator<Ball>& o = phases_.oscillator();
  if (!autonomous_) {
    turn_ = Ball(2 * question.periods) * Ball::pi() / o.omega;
  }
  for (std::size_t i = 0; i < size(); ++i) {
    speeds_.push_back(
        speed_between(question.machine.oscillator, pieces_[(i + size() - 1) % size()], pieces_[i]));
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

Vector Chain::state(const Nodes& nodes, std::size_t i) const {
  const Eigen::Index n = phases_.masses();
  const Eigen::Index j = n + phases_.rubbing();
  Vector state(2 * n);
  state.head(j) = nodes[i].segment(1, j);
  state(j) = speeds_[i];
  state.tail(2 * n - 1 - j) = nodes[i].tail(2 * n - 1 - j);
  return state;
}

Vector Chain::without(const Vector& state) const {
  const Eigen::Index j = phases_.masses() + phases_.rubbing();
  const Eigen::Index rest = 2 * phases_.masses() - 1 - j;
  Vector result(j + rest);
  result.head(j) = state.head(j);
  result.tail(rest) = state.segment(j + 1, rest);
  return result;
}

Vector Chain::beginning(const Nodes& nodes, std::size_t i) const {
  return phases_.whole(state(nodes, i), phases_.oscillator().omega * nodes[i](0));
}

Vector Chain::end(const Nodes& nodes, std::size_t i) const {
  return beginning(nodes, (i + 1) % size());
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
  const Eigen::Index n = phases_.masses();
  const Vector reached = course(nodes, i, false).reached;
  Node F(2 * n);
  F.head(2 * n - 1) = next(nodes, i).tail(2 * n - 1) - without(reached);
  F(2 * n - 1) = dot(event(i), reached);
  return F;
}

Link Chain::link(const Nodes& nodes, std::size_t i) const {
  const Eigen::Index n = phases_.masses();
  const Eigen::Index j = n + phases_.rubbing();
  const Passage course = this->course(nodes, i, true);
  const Vector D = event(i);
  Spread node{Vector::Constant(2 * n, Ball(0)), Matrix::Constant(2 * n, 2 * n, Ball(0))};
  if (!autonomous_) {
    node.time(0) = Ball(1);
  }
  for (Eigen::Index k = 1; k < 2 * n; ++k) {
    node.state(k - 1 < j ? k - 1 : k, k) = Ball(1);
  }
  const Spread reached = at_event(course, D, node);
  Link link;
  link.end_velocity.resize(2 * n);
  link.end_velocity(0) = Ball(1);
  link.end_velocity.tail(2 * n - 1) = without(course.arrives);
  link.rate = dot(D, course.arrives);
  link.M.resize(2 * n, 2 * n);
  link.M.row(0) = reached.time.transpose();
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    link.M.col(k).tail(2 * n - 1) = without(reached.state.col(k));
  }
  return link;
}

}  // namespace stickslip::numeric::machines
