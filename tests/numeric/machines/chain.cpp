// Chains of events: their conditions against motions composed by the flows, their links against differences,
// and the linear chain against its own equations.
#include "numeric/machines/orbits/chain_proof.hpp"

#include <doctest/doctest.h>

#include <random>

#include "core/decimal.hpp"
#include "numeric/zeros/linear_solve.hpp"
#include "tests/numeric/machines/neighbourhoods.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::machines;
using motion::PhaseKind;

namespace {

Node node(const Ball& t, const Ball& x1, const Ball& x2, const Ball& xdot1) {
  Node u(4);
  u << t, x1, x2, xdot1;
  return u;
}

// A motion of the paper's oscillator through these phases by its closed forms, closed or not, as nodes in
// balls.
Nodes composed_nodes(const model::Oscillator<Ball>& o, const std::vector<PhaseKind>& kinds) {
  const model::Vector4<Ball> Z0(Ball(0.3), Ball(-0.7), Ball(0.11), o.data.V);
  std::vector<Leg> legs;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    legs.push_back({kinds[k], Ball(0.7 + 0.3 * static_cast<double>(k))});
  }
  const Ball t0(0.4);
  const Motion m = compose(o, o.data.omega * t0, Z0, legs);
  Nodes nodes;
  for (const Phase& phase : m.phases) {
    nodes.push_back(node(t0 + phase.start, phase.Z(0) + o.d0(0), phase.Z(1) + o.d0(1), phase.Z(2)));
  }
  return nodes;
}

model::Oscillator<Ball> oscillator_at(const ExactParameters& data) {
  return model::oscillator<Ball>(motion::parameters_as<Ball>(data));
}

MachineQuestion through(const ExactParameters& data, const std::vector<PhaseKind>& kinds) {
  MachineQuestion question{with_damping(data, Rational(1, 2)), {}, 1};
  for (const PhaseKind kind : kinds) {
    question.pieces.push_back({kind});
  }
  return question;
}

const std::vector<PhaseKind> all_kinds{PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick};

double difference(const Node& a, const Node& b) {
  double largest = 0;
  for (int i = 0; i < 4; ++i) {
    largest = std::max(largest, std::abs(Ball(a(i) - b(i)).approximate()));
  }
  return largest;
}

}  // namespace

TEST_CASE("nodes from the flows meet the three conditions of the state, and the fourth is the event") {
  for (const ExactParameters& data : {S(), O(), P("0.1")}) {
    const Chain chain(through(data, all_kinds));
    const model::Oscillator<Ball> o = oscillator_at(data);
    const Nodes nodes = composed_nodes(o, all_kinds);
    // The flows compose with x2' = V at the first node only: the state of the second is met from the first.
    const Node F = chain.conditions(nodes, 0);
    for (int i = 0; i < 3; ++i) {
      CHECK(F(i).contains_zero());
      CHECK((abs(F(i)) - Ball(1e-25)).is_negative());
    }
    const Motion m = compose(o, o.data.omega * nodes[0](0),
                             {nodes[0](1) - o.d0(0), nodes[0](2) - o.d0(1), nodes[0](3), o.data.V},
                             {{PhaseKind::slip, nodes[1](0) - nodes[0](0)}, {PhaseKind::stick, Ball(1)}});
    CHECK(F(3).overlaps(m.phases[1].Z(3) - o.data.V));
    CHECK(F(3).is_nonzero());
  }
}

TEST_CASE("a link is the derivative of the next node by this one: against differences, every kind of phase") {
  const WorkingPrecision scope(512);
  const Ball step(Rational("1/1000000000000000000000000000000"));
  for (const ExactParameters& data : {S(), O(), P("0.1")}) {
    for (const std::vector<PhaseKind>& kinds :
         {all_kinds, std::vector{PhaseKind::stick, PhaseKind::overshoot, PhaseKind::slip}}) {
      const Chain chain(through(data, kinds));
      const Nodes nodes = composed_nodes(oscillator_at(data), kinds);
      for (std::size_t i = 0; i + 1 < kinds.size(); ++i) {
        const Link link = chain.link(nodes, i);
        // F(u + d, u+ + M d) differs from F(u, u+) by something quadratic in d, and by F of the flow's own
        // end when u+ is not on the flow: so u+ is put there first.
        Nodes at = nodes;
        const Node F = chain.conditions(at, i);
        at[i + 1].tail(3) -= F.head(3);
        const Link there = chain.link(at, i);
        const Node F0 = chain.conditions(at, i);
        for (int k = 0; k < 4; ++k) {
          Nodes moved = at;
          moved[i](k) += step;
          moved[i + 1] += there.M.c[0].col(k) * step;
          const Node F1 = chain.conditions(moved, i);
          CHECK(difference(F1, F0) < 1e-55);
        }
        for (int k = 0; k < 4; ++k) {
          Nodes moved = at;
          Node change = Node::Constant(4, Ball(0));
          change(k) = step;
          moved[i + 1] += there.response(change);
          CHECK(difference(chain.conditions(moved, i), F0 - change) < 1e-55);
        }
      }
    }
  }
}

TEST_CASE("a linear chain solves its equations, and its return map has the eigenvalues of the product") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 20; ++round) {
    const std::size_t count = 2 + static_cast<std::size_t>(round);
    std::vector<Link> links(count);
    Nodes g;
    model::Matrix4<Ball> product = model::Matrix4<Ball>::Identity();
    for (Link& link : links) {
      Matrix M(4, 4);
      M = M.unaryExpr([&](const Ball&) { return Ball(number(random)); });
      if (round % 3 == 0) {
        M.col(1) = M.col(0) * Ball(2);  // collapses a direction
      }
      link.M = InData<Matrix>(M);
      g.push_back(
          node(Ball(number(random)), Ball(number(random)), Ball(number(random)), Ball(number(random))));
      product = model::Matrix4<Ball>(M) * product;
    }
    const auto found = LinearChain::of(links);
    REQUIRE(found);
    const Nodes deviations = found->deviations(g);
    Ball trace(0);
    Ball trace_of_product(0);
    for (int i = 0; i < 4; ++i) {
      trace += found->return_map()(i, i);
      trace_of_product += product(i, i);
    }
    CHECK(trace.overlaps(trace_of_product));
    CHECK((trace.radius() - Ball(1e-25)).is_negative());
    for (std::size_t i = 0; i < count; ++i) {
      const Node next = zeros::product(links[i].M.c[0], deviations[i]) + g[i];
      for (int j = 0; j < 4; ++j) {
        CHECK(next(j).overlaps(deviations[(i + 1) % count](j)));
        CHECK((next(j).radius() - Ball(1e-20)).is_negative());
      }
    }
  }
}

TEST_CASE("a linear chain of uncertain links has the deviations of all of them") {
  Link link;
  link.M = InData<Matrix>(Matrix::Constant(1, 1, Ball::from_interval(Rational(3, 8), Rational(5, 8))));
  const auto found = LinearChain::of({link});
  REQUIRE(found);
  const Ball deviation = found->deviations({Node::Constant(1, Ball(1))})[0](0);
  for (const Rational& M : {Rational(3, 8), Rational(1, 2), Rational(5, 8)}) {  // d = M d + 1
    CHECK(deviation.contains(Rational(1 / (1 - M))));
  }
  link.M.c[0](0, 0) = Ball::from_interval(Rational(1, 2), Rational(1));
  CHECK_FALSE(LinearChain::of({link}));
}

TEST_CASE("a linear chain with the multiplier 1 is not solved") {
  std::vector<Link> links(3);
  for (Link& link : links) {
    link.M = InData<Matrix>(Matrix::Identity(4, 4));
  }
  CHECK_FALSE(LinearChain::of(links));
}

TEST_CASE("the enclosed inverse contains the inverse, and a singular matrix has none") {
  model::MatrixX<Ball> A = model::MatrixX<Ball>::Identity(4, 4);
  A(0, 1) = Ball(Rational(1, 3));
  const auto inverse = enclosed_inverse(A, model::MatrixX<Ball>::Identity(4, 4));
  REQUIRE(inverse);
  CHECK((*inverse)(0, 1).contains(Rational(-1, 3)));
  A(3, 3) = Ball(0);
  CHECK_FALSE(enclosed_inverse(A, model::MatrixX<Ball>::Identity(4, 4)));
}
