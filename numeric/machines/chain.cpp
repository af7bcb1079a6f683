#include "numeric/machines/chain.hpp"

#include <algorithm>
#include <array>
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
  if (question.ends) {
    return {oscillator_as<Ball>(question.ends->first), oscillator_as<Ball>(question.ends->second)};
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

// Between the values at -1 and 1.
template <class M>
InDatum<M> linear(const M& low, const M& high) {
  const M none = low * Ball(0);
  return {{M((high + low) * Ball(0.5)), M((high - low) * Ball(0.5)), none, none}};
}

}  // namespace

Node Link::response(const Node& F) const {
  const Eigen::Index last = F.size() - 1;
  Node d = end_velocity * Ball(-F(last) / rate);
  d.tail(last) -= F.head(last);
  return d;
}

namespace {

Nodes sum(const Nodes& a, const Nodes& b, const Ball& factor) {
  Nodes sum = a;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] += b[i] * factor;
  }
  return sum;
}

}  // namespace

Nodes Curve::all() const {
  return sum(sum(m, tangent, Ball::hull(Ball(-1), Ball(1))), bend, Ball::hull(Ball(0), Ball(1)));
}

Nodes Curve::rates() const {
  return sum(tangent, bend, Ball::hull(Ball(-2), Ball(2)));
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
  const auto speeds_of = [&](const Machine& machine) {
    std::vector<Ball> speeds;
    for (std::size_t i = 0; i < size(); ++i) {
      speeds.push_back(speed_between(machine.oscillator, pieces_[(i + size() - 1) % size()], pieces_[i]));
    }
    return speeds;
  };
  if (!question.ends) {
    speeds_ = speeds_of(question.machine);
    return;
  }
  speeds_low_ = speeds_of(question.ends->first);
  speeds_high_ = speeds_of(question.ends->second);
  for (std::size_t i = 0; i < size(); ++i) {
    speeds_.push_back(Ball::hull(speeds_low_[i], speeds_high_[i]));
    speeds_in_datum_.push_back(linear(speeds_low_[i], speeds_high_[i]));
  }
  if (!autonomous_) {
    omega_in_datum_ = linear(phases_.low()->oscillator().omega, phases_.high()->oscillator().omega);
    turn_in_datum_ = reciprocal(omega_in_datum_.c[0], omega_in_datum_.c[1]);
    for (Ball& coefficient : turn_in_datum_.c) {
      coefficient *= Ball(2 * question.periods) * Ball::pi();
    }
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
  const Eigen::Index n = phases_.masses();
  const Eigen::Index j = n + phases_.rubbing();
  Vector state(2 * n);
  state.head(j) = node.segment(1, j);
  state(j) = speed;
  state.tail(2 * n - 1 - j) = node.tail(2 * n - 1 - j);
  return state;
}

Vector Chain::state(const Nodes& nodes, std::size_t i) const {
  return with(speeds_[i], nodes[i]);
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

Spread Chain::spread() const {
  const Eigen::Index n = phases_.masses();
  const Eigen::Index j = n + phases_.rubbing();
  Spread node{Vector::Constant(2 * n, Ball(0)), Matrix::Constant(2 * n, 2 * n, Ball(0))};
  if (!autonomous_) {
    node.time(0) = Ball(1);
  }
  for (Eigen::Index k = 1; k < 2 * n; ++k) {
    node.state(k - 1 < j ? k - 1 : k, k) = Ball(1);
  }
  return node;
}

Node Chain::conditions(const Curve& curve, std::size_t i) const {
  const Eigen::Index n = phases_.masses();
  const std::size_t next = (i + 1) % size();
  const Ball zero(0);
  const auto state_at = [&](std::size_t k) {
    const std::array<Ball, 4>& speed = speeds_in_datum_[k].c;
    return InDatum<Vector>{{with(speed[0], curve.m[k]), with(speed[1], curve.tangent[k]),
                            with(speed[2], curve.bend[k]), Vector::Constant(2 * n, zero)}};
  };
  const auto time_at = [&](std::size_t k) {
    return InDatum<Ball>{{curve.m[k](0), curve.tangent[k](0), curve.bend[k](0), zero}};
  };
  InDatum<Ball> theta{}, h = time_at(next);
  if (!autonomous_) {
    theta = omega_in_datum_ * time_at(i);
    h -= time_at(i);
    if (next == 0) {
      h += turn_in_datum_;
    }
  }
  const InDatum<Vector> reached = phases_.after(pieces_[i], h, phases_.whole(state_at(i), theta));
  InDatum<Vector> apart = state_at(next);
  for (std::size_t k = 0; k < 4; ++k) {
    apart.c[k] -= reached.c[k].head(2 * n);
  }
  const auto event_of = [&](const LinearPhases& phases, const Ball& speed) {
    return event_between(phases, pieces_[i], pieces_[next], speed);
  };
  const InDatum<Vector> D =
      linear(event_of(*phases_.low(), speeds_low_[next]), event_of(*phases_.high(), speeds_high_[next]));
  Node F(2 * n);
  F.head(2 * n - 1) = without(apart.all());
  F(2 * n - 1) = product(D, reached, dot).all();
  return F;
}

// The derivatives of what a link is made of, one after the other, by the rules for products.
Matrix Chain::link_by_datum(const Nodes& nodes, const Nodes& rates, std::size_t i) const {
  const Eigen::Index states = 2 * phases_.masses();
  const std::size_t next = (i + 1) % size();
  const Piece piece = pieces_[i];
  const Passage course = this->course(nodes, i, true);
  const Matrix &B = phases_.drift(piece), B_rate = phases_.drift_by_datum(piece);
  const Vector w = beginning(nodes, i);
  const Eigen::Index loads = w.size() - states;
  // Of w where the phase begins; what turns does so with theta.
  Vector w_rate = course.leaves;
  if (!autonomous_) {
    w_rate *= omega_in_datum_.c[1] * nodes[i](0) / phases_.oscillator().omega + rates[i](0);
  }
  w_rate(states) = Ball(0);
  w_rate.head(states) = with(speeds_in_datum_[i].c[1], rates[i]);
  Ball longer = rates[next](0);
  if (!autonomous_) {
    longer -= rates[i](0);
    if (next == 0) {
      longer -= turn_ * omega_in_datum_.c[1] / phases_.oscillator().omega;
    }
  }
  const Matrix flow_rate =
      phases_.flow_by_datum(piece, duration(nodes, i)) + Matrix(sparse_product(B, course.flow) * longer);
  const Vector leaves_rate = sparse_product(B_rate, w) + sparse_product(B, w_rate);
  const Vector reached_rate = sparse_product(flow_rate, w) + sparse_product(course.flow, w_rate);
  const Vector arrives_rate = sparse_product(B_rate, course.reached) + sparse_product(B, reached_rate);
  const Passage rate{reached_rate,
                     leaves_rate,
                     arrives_rate,
                     flow_rate.topLeftCorner(states, states),
                     Vector(product(flow_rate.topRightCorner(states, loads), course.leaves.tail(loads))) +
                         Vector(product(course.flow.topRightCorner(states, loads), leaves_rate.tail(loads))),
                     {}};
  const Vector D = event(i);
  const Vector D_rate = (event_between(*phases_.high(), piece, pieces_[next], speeds_high_[next]) -
                         event_between(*phases_.low(), piece, pieces_[next], speeds_low_[next])) *
                        Ball(0.5);
  Matrix M_rate(states, states);
  // As in at_event, column by column.
  const Spread node = spread(), at_end{node.time, after_duration(course, node)};
  const Matrix end_rate = after_duration(rate, node);
  const Ball speed = dot(D, course.arrives), speed_rate = dot(D_rate, course.arrives) + dot(D, arrives_rate);
  const Ball of_loads = dot(D.tail(loads), course.arrives.tail(loads)),
             of_loads_rate = dot(D_rate.tail(loads), course.arrives.tail(loads)) +
                             dot(D.tail(loads), arrives_rate.tail(loads));
  for (Eigen::Index k = 0; k < states; ++k) {
    const Ball later = -(dot(D.head(states), at_end.state.col(k)) + of_loads * node.time(k)) / speed;
    const Ball later_rate =
        -(dot(D_rate.head(states), at_end.state.col(k)) + dot(D.head(states), end_rate.col(k)) +
          of_loads_rate * node.time(k) + later * speed_rate) /
        speed;
    M_rate(0, k) = later_rate;
    M_rate.col(k).tail(states - 1) =
        without(Vector(end_rate.col(k) + Vector(arrives_rate.head(states) * later) +
                       Vector(course.arrives.head(states) * later_rate)));
  }
  return M_rate;
}

Link Chain::link(const Nodes& nodes, std::size_t i) const {
  const Eigen::Index n = phases_.masses();
  const Passage course = this->course(nodes, i, true);
  const Vector D = event(i);
  const Spread reached = at_event(course, D, spread());
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
