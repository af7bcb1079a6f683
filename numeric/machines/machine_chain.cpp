#include "numeric/machines/machine_chain.hpp"

#include "core/error.hpp"
#include "numeric/machines/smooth_phase.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using motion::PhaseKind;
using words::Link;
using words::Node;
using words::Nodes;
using zeros::product;

namespace {

Ball dot(const Vector& a, const Vector& b) {
  Ball sum(0);
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (!is_zero(a(i))) {
      add_product(sum, a(i), b(i));
    }
  }
  return sum;
}

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

MachineChain::MachineChain(const MachineQuestion& question)
    : autonomous_(question.machine.oscillator.is_autonomous()),
      pieces_(question.pieces),
      phases_(phases_of(question)) {
  const model::FrictionOscillator<Ball>& o = phases_.oscillator();
  if (!autonomous_) {
    turn_ = Ball(2 * question.periods) * Ball::pi() / o.omega;
  }
  for (std::size_t i = 0; i < size(); ++i) {
    const Piece& piece = pieces_[i];
    const Piece& before = pieces_[(i + size() - 1) % size()];
    if (before.kind != piece.kind) {
      speeds_.push_back(o.V);
      continue;
    }
    const int upper = std::max(before.number, piece.number);
    if (piece.kind == PhaseKind::stick || std::min(before.number, piece.number) + 1 != upper) {
      throw InternalError("two phases after each other that no event separates");
    }
    const model::FrictionOscillator<Rational>& exact = question.machine.oscillator;
    const Rational& from = exact.law(piece.side()).sliding.at(static_cast<std::size_t>(upper)).from;
    speeds_.emplace_back(Rational(exact.V - piece.side() * from));
  }
}

Node MachineChain::next(const Nodes& nodes, std::size_t i) const {
  if (i + 1 < nodes.size()) {
    return nodes[i + 1];
  }
  Node node = nodes.front();
  if (!autonomous_) {
    node(0) += turn_;
  }
  return node;
}

Ball MachineChain::duration(const Nodes& nodes, std::size_t i) const {
  const Node to = next(nodes, i);
  return autonomous_ ? to(0) : Ball(to(0) - nodes[i](0));
}

Vector MachineChain::state(const Nodes& nodes, std::size_t i) const {
  const Eigen::Index n = phases_.masses();
  const Eigen::Index j = n + phases_.rubbing();
  Vector state(2 * n);
  state.head(j) = nodes[i].segment(1, j);
  state(j) = speeds_[i];
  state.tail(2 * n - 1 - j) = nodes[i].tail(2 * n - 1 - j);
  return state;
}

Vector MachineChain::without(const Vector& state) const {
  const Eigen::Index j = phases_.masses() + phases_.rubbing();
  const Eigen::Index rest = 2 * phases_.masses() - 1 - j;
  Vector result(j + rest);
  result.head(j) = state.head(j);
  result.tail(rest) = state.segment(j + 1, rest);
  return result;
}

Vector MachineChain::beginning(const Nodes& nodes, std::size_t i) const {
  return phases_.whole(state(nodes, i), phases_.oscillator().omega * nodes[i](0));
}

Vector MachineChain::end(const Nodes& nodes, std::size_t i) const {
  return beginning(nodes, (i + 1) % size());
}

Vector MachineChain::event(std::size_t i) const {
  const std::size_t following = (i + 1) % size();
  const model::FrictionOscillator<Ball>& o = phases_.oscillator();
  if (pieces_[i].kind != PhaseKind::stick) {
    return phases_.speed() - phases_.one() * speeds_[following];
  }
  const bool slips = pieces_[following].kind == PhaseKind::slip;
  return phases_.friction_at_rest() + phases_.one() * (slips ? Ball(-o.forward.at_rest) : o.backward.at_rest);
}

MachineChain::Course MachineChain::course(const Nodes& nodes, std::size_t i, bool with_derivative) const {
  const Eigen::Index states = 2 * phases_.masses();
  const Ball h = duration(nodes, i);
  if (phases_.is_smooth(pieces_[i])) {
    // Of a derivative Newton's method does not ask that much.
    const WorkingPrecision scope(WorkingPrecision::bits() + (with_derivative ? 0 : more_bits));
    const Vector start = beginning(nodes, i);
    const int side = pieces_[i].side();
    const SmoothPhase phase(phases_, side, start, h, false, with_derivative);
    const Vector reached = phase.end();
    return {reached, smooth_rate(phases_, side, start), smooth_rate(phases_, side, reached),
            with_derivative ? phase.derivative() : Matrix()};
  }
  const Vector start = beginning(nodes, i);
  const Matrix& B = phases_.drift(pieces_[i]);
  const Matrix flow = phases_.flow(pieces_[i], h);
  const Vector reached = product(flow, start);
  return {reached, product(B, start), product(B, reached), flow.topLeftCorner(states, states)};
}

Node MachineChain::conditions(const Nodes& nodes, std::size_t i) const {
  const Eigen::Index n = phases_.masses();
  const Vector reached = course(nodes, i, false).reached;
  Node F(2 * n);
  F.head(2 * n - 1) = next(nodes, i).tail(2 * n - 1) - without(reached);
  F(2 * n - 1) = dot(event(i), reached);
  return F;
}

Link MachineChain::link(const Nodes& nodes, std::size_t i) const {
  const Eigen::Index n = phases_.masses();
  const Eigen::Index j = n + phases_.rubbing();
  const auto [reached, leaves, arrives, H] = course(nodes, i, true);
  const Vector D = event(i);
  Link link;
  link.end_velocity.resize(2 * n);
  link.end_velocity(0) = Ball(1);
  link.end_velocity.tail(2 * n - 1) = without(arrives);
  link.rate = dot(D, arrives);
  link.M = Matrix::Constant(2 * n, 2 * n, Ball(0));
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    if (k == 0 && autonomous_) {
      continue;
    }
    const Eigen::Index column = k - 1 < j ? k - 1 : k;
    const Vector w = k == 0 ? Vector(-product(H, leaves.head(2 * n))) : Vector(H.col(column));
    link.M.col(k) = link.end_velocity * Ball(-dot(D.head(2 * n), w) / link.rate);
    link.M.col(k).tail(2 * n - 1) += without(w);
  }
  return link;
}

words::ChainAt chain_at(const MachineQuestion& question) {
  return [question] { return std::make_unique<MachineChain>(question); };
}

}  // namespace stickslip::numeric::machines
