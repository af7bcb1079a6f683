#include "numeric/words/oscillator_chain.hpp"

#include "model/saltation.hpp"
#include "numeric/motion/monodromy.hpp"

namespace stickslip::numeric::words {

using namespace motion;
using model::Matrix4;
using model::Vector4;

// The state at the end of a phase, and the derivative of the flow.
struct OscillatorChain::Flow {
  Vector4<Ball> Z;
  Matrix4<Ball> tangent;
};

Node node(const Ball& t, const Ball& z1, const Ball& z2, const Ball& zdot1) {
  Node u(4);
  u << t, z1, z2, zdot1;
  return u;
}

ChainAt chain_at(const ChainQuestion& question) {
  return [question] { return std::make_unique<OscillatorChain>(question); };
}

OscillatorChain::OscillatorChain(const ChainQuestion& question)
    : phases_(question.phases),
      oscillator_(model::oscillator<Ball>(parameters_as<Ball>(question.data))),
      ur_(question.ur),
      turn_(Ball(2 * question.periods) * Ball::pi() / oscillator_.data.omega) {}

Node OscillatorChain::next(const Nodes& nodes, std::size_t i) const {
  if (i + 1 < nodes.size()) {
    return nodes[i + 1];
  }
  Node node = nodes.front();
  node(0) += turn_;
  return node;
}

// (2): x2'' = eta (u - r), and 0 on a stick.
Ball OscillatorChain::acceleration(PhaseKind kind, const Vector4<Ball>& Z, const Ball& psi) const {
  if (kind == PhaseKind::stick) {
    return Ball(0);
  }
  const model::Parameters<Ball>& a = oscillator_.data;
  const Ball r = model::friction_at<Ball>(a, Z, psi);
  return model::belt_acceleration<Ball>(a.eta, friction_on<Ball>(kind, a.us, r), r);
}

// H (Z - rest - F(0)) + F(h) + rest: (5) and (8) with the matrix that the linearisation needs too.
OscillatorChain::Flow OscillatorChain::flow(const Node& from, const Ball& until, PhaseKind kind) const {
  const model::Oscillator<Ball>& o = oscillator_;
  const Ball h = until - from(0);
  const Vector4<Ball> Z(from(1), from(2), from(3), o.data.V);
  if (kind == PhaseKind::stick) {
    const Matrix4<Ball> G = model::Gamma<Ball>(o.data.chi, h);
    return {G * Z, G};
  }
  const Matrix4<Ball> H = model::H<Ball>(o.modes, h);
  const Ball& omega = o.data.omega;
  Vector4<Ball> rest = Vector4<Ball>::Constant(Ball(0));
  if (kind == PhaseKind::overshoot) {
    rest.head<2>() = o.d0 * Ball(-2);
  }
  const Vector4<Ball> F0 = model::F<Ball>(o.Q, omega, Ball(omega * from(0))) + rest;
  const Vector4<Ball> F1 = model::F<Ball>(o.Q, omega, Ball(omega * until)) + rest;
  return {H * Vector4<Ball>(Z - F0) + F1, H};
}

Node OscillatorChain::conditions(const Nodes& nodes, std::size_t i) const {
  const Node to = next(nodes, i);
  const Vector4<Ball> end = flow(nodes[i], to(0), phases_[i]).Z;
  const model::Parameters<Ball>& a = oscillator_.data;
  Ball event = end(3) - a.V;
  if (phases_[i] == PhaseKind::stick) {
    const Ball r = model::friction_at<Ball>(a, end, Ball(a.omega * to(0)));
    event = phases_[(i + 1) % size()] == PhaseKind::slip ? Ball(r - ur_) : Ball(r + ur_);
  }
  return node(to(1) - end(0), to(2) - end(1), to(3) - end(2), event);
}

Link OscillatorChain::link(const Nodes& nodes, std::size_t i) const {
  const model::Parameters<Ball>& a = oscillator_.data;
  const PhaseKind kind = phases_[i];
  const Node& from = nodes[i];
  const Ball until = next(nodes, i)(0);
  const Flow end = flow(from, until, kind);
  const Ball psi = a.omega * until;
  const Vector4<Ball> start(from(1), from(2), from(3), a.V);
  const Vector4<Ball> leaves(from(3), a.V, a.chi * from(2) - from(1),
                             acceleration(kind, start, Ball(a.omega * from(0))));
  const Ball& zdot1 = end.Z(2);
  const Ball& zdot2 = end.Z(3);
  Link link;
  link.end_velocity = node(Ball(1), zdot1, zdot2, a.chi * end.Z(1) - end.Z(0));
  link.M.resize(4, 4);
  const bool sticks = kind == PhaseKind::stick;
  link.rate = sticks ? model::friction_rate<Ball>(a, end.Z, psi) : acceleration(kind, end.Z, psi);
  for (int k = 0; k < 4; ++k) {
    const Vector4<Ball> w =
        k == 0 ? Vector4<Ball>(end.tangent * -leaves) : Vector4<Ball>(end.tangent.col(k - 1));
    const Ball later = -(sticks ? Ball(a.chi * (w(1) - w(0))) : w(3)) / link.rate;
    link.M.col(k) = link.end_velocity * later;
    link.M.col(k).tail(3) += w.head<3>();
  }
  return link;
}

Motion OscillatorChain::motion(const Nodes& nodes) const {
  Motion motion{oscillator_, {}};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& u = nodes[i];
    const Ball start = i == 0 ? Ball(0) : Ball(u(0) - nodes.front()(0));
    motion.phases.push_back({phases_[i], start, next(nodes, i)(0) - u(0), oscillator_.data.omega * u(0),
                             Vector4<Ball>(u(1), u(2), u(3), oscillator_.data.V)});
  }
  return motion;
}

}  // namespace stickslip::numeric::words
