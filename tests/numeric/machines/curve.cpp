// Motions of all machines between two: flows, conditions and links against single machines between them, the
// sweep against single ones, and curves of motions.
#include "numeric/machines/curve.hpp"

#include <doctest/doctest.h>

#include <random>

#include "core/decimal.hpp"
#include "numeric/zeros/linear_solve.hpp"
#include "tests/numeric/machines/neighbourhoods.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::machines;

namespace {

// Two masses with dashpots, friction that falls in three pieces, and a load: SI units.
Machine engineers() {
  Machine machine;
  auto& o = machine.oscillator;
  o.masses = {Rational("5/2"), Rational("4/5")};
  o.stiffness.resize(2, 2);
  o.stiffness << Rational(1650), Rational(-450), Rational(-450), Rational(450);
  o.damping = model::MatrixX<Rational>::Constant(2, 2, Rational(0));
  o.damping(0, 0) = Rational("3/5");
  o.rubbing = 1;
  o.V = Rational("1/20");
  o.forward = {Rational("27/2"),
               {{Rational(0), Rational(9), Rational(-30)},
                {Rational("1/20"), Rational("15/2"), Rational(-6)},
                {Rational("3/10"), Rational(6), Rational(0)}}};
  o.backward = o.forward;
  o.loads = {{1, 1, Rational(12), Rational(0)}};
  o.omega = Rational("18/5");
  machine.in_turns = true;
  return machine;
}

// A number of a machine, set.
struct Datum {
  const char * name;
  Rational value;
  std::function<void(model::FrictionOscillator<Rational>&, const Rational&)> set;
  bool has_linear_inverse = false;
};
std::vector<Datum> data() {
  return {
      {"frequency", Rational("18/5"), [](auto& o, const Rational& x) { o.omega = x; }},
      {"belt", Rational("1/20"), [](auto& o, const Rational& x) { o.V = x; }},
      {"spring", Rational(450),
       [](auto& o, const Rational& x) { o.stiffness << Rational(1200 + x), Rational(-x), Rational(-x), x; }},
      {"dashpot", Rational("3/5"), [](auto& o, const Rational& x) { o.damping(0, 0) = x; }},
      {"mass", Rational("4/5"), [](auto& o, const Rational& x) { o.masses[1] = x; }, true},
      {"at rest", Rational("27/2"),
       [](auto& o, const Rational& x) { o.forward.at_rest = o.backward.at_rest = x; }},
      {"load", Rational(12), [](auto& o, const Rational& x) { o.loads[0].cosine = x; }},
      {"sliding friction", Rational("15/2"), [](auto& o, const Rational& x) {
         for (auto * law : {&o.forward, &o.backward}) {
           law->sliding[0].slope = Rational((x - 9) * 20);
           law->sliding[1].force = x;
           law->sliding[1].slope = Rational((6 - x) * 4);
         }
       }}};
}

Machine with(const Datum& datum, const Rational& value) {
  Machine machine = engineers();
  datum.set(machine.oscillator, value);
  return machine;
}

// The machine at s between two values of the datum, as a curve takes it.
Machine at_s(const Datum& datum, const Rational& low, const Rational& high, const Rational& s) {
  const auto between = [&](const Rational& a, const Rational& b) {
    return Rational(((1 - s) * a + (1 + s) * b) / 2);
  };
  return with(datum,
              datum.has_linear_inverse ? Rational(1 / between(1 / low, 1 / high)) : between(low, high));
}

MachineOrbit orbit_of(const Machine& machine) {
  Eigen::VectorXd start(4);
  start << 0.0, 0.0, 0.0, 0.0;
  return prove_machine_orbit(machine, settle(machine, start).guess);
}

Nodes at(const Curve& curve, const Ball& s) {
  Nodes nodes = curve.m;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i] += (curve.tangent[i] + curve.bend[i] * s) * s;
  }
  return nodes;
}

Matrix value(const InDatum<Matrix>& f, double s) {
  return f.c[0] + f.c[1] * Ball(s) + f.c[2] * Ball(s * s) + f.c[3] * Ball(s * s * s);
}

void check_contains(const Matrix& all, const Matrix& one) {
  for (Eigen::Index i = 0; i < one.size(); ++i) {
    CHECK(all.data()[i].is_finite());
    CHECK(all.data()[i].overlaps(one.data()[i]));
  }
}

double widest(const Matrix& A) {
  double most = 0;
  for (Eigen::Index i = 0; i < A.size(); ++i) {
    most = std::max(most, A.data()[i].radius().approximate());
  }
  return most;
}

}  // namespace

TEST_CASE("flows between two matrices contain each one's, and are narrow to the third order") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 12; ++round) {
    Matrix B0(5, 5), B1(5, 5);
    const double size = std::exp2(-3 * (round % 4));
    for (Eigen::Index i = 0; i < B0.size(); ++i) {
      B0.data()[i] = Ball(number(random));
      B1.data()[i] = Ball(size * number(random));
    }
    const Ball t(round % 3 == 0 ? -1.5 : 4.0 / (1 + round));
    const FlowsBetween flows = flows_between(B0, B1, t, balance(B0));
    const InDatum<Matrix> polynomial = flows.in_datum();
    const Matrix all = polynomial.all(), by_s = flows.by_s();
    const auto at = [&](double s) { return exponential(Matrix(Matrix(B0 + B1 * Ball(s)) * t)); };
    for (const double s : {-1.0, -0.6, 0.0, 0.3, 1.0}) {
      check_contains(all, at(s));
      check_contains(value(polynomial, s), at(s));
      if (s < 1) {  // a mean value of the derivative
        const double h = 0.125;
        check_contains(by_s, Matrix((at(s + h) - at(s)) / Ball(h)));
      }
    }
    // At s = 0 the polynomial is the flow itself.
    check_contains(flows.E[0], at(0));
    CHECK(widest(flows.E[0]) < 1e-20);
    const Ball rest = flows_between(B0, Matrix(B1 * Ball(0.125)), t, balance(B0)).rest;
    CHECK(rest.approximate() < flows.rest.approximate() / 400);
  }
}

TEST_CASE("polynomials in a datum contain the functions, and are narrow to the fourth order") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto value = [](const InDatum<Ball>& f, const Ball& s) {
    return Ball(f.c[0] + s * (f.c[1] + s * (f.c[2] + s * f.c[3])));
  };
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    const double size = std::exp2(-round % 8);
    const auto some = [&] {
      return InDatum<Ball>{{Ball(3 * number(random)), Ball(size * number(random)),
                            Ball(size * number(random)), Ball(size * number(random))}};
    };
    const InDatum<Ball> f = some(), g = some(), product = f * g;
    const auto [sine, cosine] = sin_cos(f);
    // Without powers that are so much of the third, only the rests are left.
    const InDatum<Ball> line{{f.c[0], f.c[1], Ball(0), Ball(0)}};
    const auto [sine_on_line, cosine_on_line] = sin_cos(line);
    const Ball a(2 + number(random)), b(size * number(random) * 0.9);
    const InDatum<Ball> inverse = reciprocal(a, b);
    for (const double at : {-1.0, -0.7, 0.0, 0.2, 1.0}) {
      const Ball s(at), x = value(f, s);
      const auto [sine_there, cosine_there] = sin_cos(x);
      CHECK(value(sine, s).overlaps(sine_there));
      CHECK(value(cosine, s).overlaps(cosine_there));
      const auto [sine_of_line, cosine_of_line] = sin_cos(value(line, s));
      CHECK(value(sine_on_line, s).overlaps(sine_of_line));
      CHECK(value(cosine_on_line, s).overlaps(cosine_of_line));
      CHECK(value(product, s).overlaps(Ball(x * value(g, s))));
      CHECK(value(inverse, s).overlaps(Ball(Ball(1) / (a + b * s))));
      CHECK(f.all().overlaps(x));
      CHECK(value(product, s).radius().approximate() <= 8 * std::abs(std::pow(at, 3)) * size * size + 1e-30);
      CHECK(value(inverse, s).radius().approximate() <=
            std::abs(std::pow(at, 3)) * std::pow(size, 4) + 1e-30);
    }
  }
  CHECK_FALSE(reciprocal(Ball(1), Ball(-1)).c[3].is_finite());
}

TEST_CASE("what is reached in a datum, at a time beside one that is kept") {
  const Datum spring = data()[2];
  const Rational width = parse_rational("1e-3");
  const auto low = oscillator_as<Ball>(with(spring, spring.value - width)),
             high = oscillator_as<Ball>(with(spring, spring.value + width));
  const LinearPhases all(low, high);
  const InDatum<Vector> w{{Vector::Constant(7, Ball(0.5)), Vector::Constant(7, Ball(0x1p-8)),
                           Vector::Constant(7, Ball(-0x1p-9)), Vector::Constant(7, Ball(0x1p-7))}};
  for (const Piece& piece : {Piece{motion::PhaseKind::slip, 1}, Piece{motion::PhaseKind::stick}}) {
    for (const double t : {0.25, 0.25 + 0x1p-17, 0.25 - 0x1p-18}) {
      const InDatum<Ball> h{{Ball(t), Ball(0x1p-11), Ball(-0x1p-12), Ball(0x1p-13)}};
      const InDatum<Vector> reached = all.after(piece, h, w);
      for (const double s : {-1.0, -0.5, 0.0, 1.0}) {
        const auto value = [&](const auto& f) {
          return f.c[0] + (f.c[1] + (f.c[2] + f.c[3] * Ball(s)) * Ball(s)) * Ball(s);
        };
        const LinearPhases one(
            oscillator_as<Ball>(with(spring, Rational(spring.value + width * Rational(s)))));
        check_contains(Vector(value(reached)), one.after(piece, Ball(value(h)), Vector(value(w))));
      }
    }
  }
}

TEST_CASE("what changes along a curve of machines contains the differences between its ends") {
  const MachineOrbit orbit = orbit_of(engineers());
  REQUIRE(orbit.existence.truth == Truth::proved);
  const Nodes m = midpoints(nodes_of(guess_of(orbit, engineers()), engineers()));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const Datum& datum : data()) {
    CAPTURE(datum.name);
    const Rational low = datum.value * parse_rational("4095/4096"),
                   high = datum.value * parse_rational("4097/4096");
    const MachineQuestion question{
        at_s(datum, low, high, 0), orbit.pieces, orbit.periods, {{with(datum, low), with(datum, high)}}};
    const Chain all(question);
    const Chain first({question.ends->first, orbit.pieces, orbit.periods});
    const Chain last({question.ends->second, orbit.pieces, orbit.periods});
    const auto some = [&](double size) {
      Nodes nodes = m;
      for (Node& u : nodes) {
        u = u.unaryExpr([&](const Ball& x) { return Ball(Ball(size * number(random)) * abs(x)); });
      }
      return nodes;
    };
    const Curve curve{m, some(0x1p-14), some(0x1p-14)};
    const Nodes nodes = curve.all();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Node conditions = all.conditions(curve, i);
      for (const int s : {-1, 0, 1}) {
        const Chain one({at_s(datum, low, high, s), orbit.pieces, orbit.periods});
        check_contains(conditions, one.conditions(at(curve, Ball(s)), i));
      }
      const Matrix of_link =
          (last.link(at(curve, Ball(1)), i).M - first.link(at(curve, Ball(-1)), i).M) * Ball(0.5);
      const Matrix by_datum = all.link_by_datum(nodes, curve.rates(), i);
      check_contains(by_datum, of_link);
      const Chain middle({question.machine, orbit.pieces, orbit.periods});
      check_contains(by_datum, Matrix(last.link(at(curve, Ball(1)), i).M - middle.link(m, i).M));
      check_contains(all.link(nodes, i).M, last.link(at(curve, Ball(1)), i).M);
      check_contains(all.conditions(nodes, i), first.conditions(at(curve, Ball(-1)), i));
    }
  }
}

TEST_CASE("the derivative of a flow by a datum, at a time beside one that is kept") {
  const Datum spring = data()[2];
  const Rational width = parse_rational("1e-9");
  const auto low = oscillator_as<Ball>(with(spring, spring.value - width)),
             high = oscillator_as<Ball>(with(spring, spring.value + width));
  const LinearPhases all(low, high), first(low), last(high);
  for (const Piece& piece : {Piece{motion::PhaseKind::slip, 1}, Piece{motion::PhaseKind::stick}}) {
    for (const double t : {0.25, 0.25 + 0x1p-17, 0.25 - 0x1p-18}) {
      const Matrix change = (last.flow(piece, Ball(t)) - first.flow(piece, Ball(t))) * Ball(0.5);
      const Matrix derivative = all.flow_by_datum(piece, Ball(t));
      check_contains(derivative, change);
      CHECK(widest(derivative) < 1e-2 * widest(Matrix(change.cwiseProduct(
                                            Matrix::Constant(7, 7, Ball::hull(Ball(-1), Ball(1)))))));
    }
  }
}

TEST_CASE("a sweep whose links change contains those of single links") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 10; ++round) {
    std::vector<Link> links(3 + static_cast<std::size_t>(round));
    Nodes g;
    const auto matrix = [&](double size) {
      return Matrix(Matrix::Constant(4, 4, Ball(0)).unaryExpr([&](const Ball&) {
        return Ball(size * number(random));
      }));
    };
    for (Link& link : links) {
      link.M = matrix(1);
      link.M_rate = matrix(1e-3);
      g.push_back(Node(matrix(1).col(0)));
    }
    const auto found = sweep(links, g);
    REQUIRE(found);
    for (const double s : {-1.0, -0.4, 0.2, 1.0}) {
      std::vector<Link> one = links;
      for (Link& link : one) {
        link.M += link.M_rate * Ball(s);
        link.M_rate.resize(0, 0);
      }
      const auto single = sweep(one, g);
      REQUIRE(single);
      for (std::size_t i = 0; i < links.size(); ++i) {
        check_contains(found->deviations[i], single->deviations[i]);
      }
    }
  }
}

TEST_CASE("the cube of s in a product of links is in its return map") {
  Link link;
  link.M = Matrix::Constant(1, 1, Ball(2));
  link.M_rate = Matrix::Constant(1, 1, Ball(0.5));
  const auto found = sweep(std::vector<Link>(3, link), Nodes(3, Node::Constant(1, Ball(1))));
  REQUIRE(found);
  CHECK(found->return_map(0, 0).overlaps(Ball(2.5 * 2.5 * 2.5)));
  CHECK(found->return_map(0, 0).overlaps(Ball(1.5 * 1.5 * 1.5)));
  CHECK_FALSE(found->return_map(0, 0).overlaps(Ball(18)));
}

TEST_CASE("motions between two machines lie on the curve that is proved, for each datum") {
  const MachineOrbit orbit = orbit_of(engineers());
  REQUIRE(orbit.admissible.truth == Truth::proved);
  for (const Datum& datum : data()) {
    CAPTURE(datum.name);
    const Rational low = datum.value * parse_rational("49999/50000"),
                   high = datum.value * parse_rational("50001/50000");
    const auto proof_at = [&](const Machine& machine) {
      return prove_chain({machine, orbit.pieces, orbit.periods}, nodes_of(guess_of(orbit, machine), machine),
                         128, 512);
    };
    const MachineQuestion question{
        at_s(datum, low, high, 0), orbit.pieces, orbit.periods, {{with(datum, low), with(datum, high)}}};
    const ChainProof at_low = proof_at(with(datum, low)), at_high = proof_at(with(datum, high));
    const ChainProof curve = prove_curve(question, at_low, at_high, 64);
    CAPTURE(curve.verdict.reason);
    REQUIRE(curve.verdict.truth == Truth::proved);
    for (const char * s : {"-1", "-7/11", "1/5", "1"}) {
      const ChainProof one = proof_at(at_s(datum, low, high, Rational(s)));
      REQUIRE(one.verdict.truth == Truth::proved);
      for (std::size_t i = 0; i < one.nodes.size(); ++i) {
        check_contains(curve.nodes[i], one.nodes[i]);
      }
      const Ball trace = curve.return_map.trace(), of_one = one.return_map.trace();
      CHECK(trace.overlaps(of_one));
      CHECK(trace.radius().approximate() < 0.05);
    }
    CHECK(state_of(decided(question, curve)) == branches::State::stable);
    const auto joint = joint_between([&](const Rational& x) { return with(datum, x); },
                                     {low, guess_of(orbit, with(datum, low))},
                                     {high, guess_of(orbit, with(datum, high))}, branches::State::stable);
    CAPTURE(joint.state.reason);
    CHECK(joint.existence.truth == Truth::proved);
    CHECK(joint.state.truth == Truth::proved);
  }
}

TEST_CASE("without a load a state is decided on as long a curve as is proved") {
  Machine brake = engineers();
  auto& o = brake.oscillator;
  o.masses = {Rational("3/5"), Rational("9/5")};
  o.stiffness << Rational(2400000), Rational(-2400000), Rational(-2400000), Rational(7400000);
  o.damping << Rational(200), Rational(-200), Rational(-200), Rational(600);
  o.rubbing = 0;
  o.V = Rational("3/25");
  o.forward = {Rational(1500),
               {{Rational(0), Rational(1400), Rational(-4000)},
                {Rational("1/20"), Rational(1200), Rational(-1000)},
                {Rational("1/5"), Rational(1050), Rational(-125)},
                {Rational("3/5"), Rational(1000), Rational(0)}}};
  o.backward = o.forward;
  o.loads.clear();
  const MachineOrbit orbit = orbit_of(brake);
  REQUIRE(orbit.stability);
  CHECK(orbit.stability->kind == motion::StabilityKind::stable);
  const auto at = [&](const char * V) {
    Machine other = brake;
    other.oscillator.V = parse_rational(V);
    return other;
  };
  const auto proof_of = [&](const Machine& machine) {
    return prove_chain({machine, orbit.pieces, orbit.periods}, nodes_of(guess_of(orbit, machine), machine),
                       64, 512);
  };
  const MachineQuestion question{brake, orbit.pieces, orbit.periods, {{at("0.11996"), at("0.12004")}}};
  const ChainProof curve =
      prove_curve(question, proof_of(question.ends->first), proof_of(question.ends->second), 64);
  REQUIRE(curve.verdict.truth == Truth::proved);
  CHECK(state_of(decided(question, curve)) == branches::State::stable);
}

TEST_CASE("a state that is lost between is not said of all, nor is what is not linear joined") {
  const MachineOrbit orbit = orbit_of(engineers());
  const Machine machine = engineers();
  const auto joint = [&](const auto& at, const Rational& a, const Rational& b) {
    const auto end = [&](const Rational& x) {
      return MotionAt{x, guess_of(prove_machine_orbit(at(x), guess_of(orbit, machine)), at(x))};
    };
    return joint_between(at, end(a), end(b), branches::State::stable);
  };
  const auto frequency = [](const Rational& x) {
    Machine other = engineers();
    other.oscillator.omega = x;
    return other;
  };
  // Below 3.5878224 r reaches ur while it sticks: the closed motion is still there.
  const Joint across = joint(frequency, parse_rational("3587822/1000000"), parse_rational("3587823/1000000"));
  CAPTURE(across.existence.reason);
  CHECK(across.existence.truth == Truth::proved);
  CHECK(across.state.truth == Truth::undecided);
  const Joint inside = joint(frequency, parse_rational("3587823/1000000"), parse_rational("3587824/1000000"));
  CAPTURE(inside.existence.reason);
  CHECK(inside.existence.truth == Truth::proved);
  CHECK(inside.state.truth == Truth::proved);

  const auto refused = [&](const char * what, const auto& at, const Rational& a, const Rational& b,
                           const char * why) {
    CAPTURE(what);
    const Joint found = joint(at, a, b);
    CHECK(found.existence.truth == Truth::undecided);
    CHECK(found.existence.reason.find(why) != std::string::npos);
    CHECK(found.state.truth == Truth::undecided);
  };
  const Rational low = parse_rational("3.59999"), high = parse_rational("3.60001");
  refused(
      "a square", [&](const Rational& x) { return frequency(Rational(x * x * 5 / 18)); }, low, high,
      "do not change linearly");
  refused(
      "the velocity at which a piece begins",
      [&](const Rational& x) {
        Machine other = engineers();
        for (auto * law : {&other.oscillator.forward, &other.oscillator.backward}) {
          law->sliding[1].from = Rational(x / 72);
          law->sliding[0].slope = Rational(Rational("-3/2") * 72 / x);
          law->sliding[1].slope = Rational(Rational("-3/2") / (Rational("3/10") - x / 72));
        }
        return other;
      },
      low, high, "do not change linearly");
  refused(
      "a mass and a spring",
      [&](const Rational& x) {
        Machine other = engineers();
        other.oscillator.masses[0] = Rational(9 / x);
        other.oscillator.stiffness(0, 0) = Rational(1650 * x * 5 / 18);
        return other;
      },
      low, high, "do not change linearly");
  refused(
      "another multiple of the load",
      [&](const Rational& x) {
        Machine other = engineers();
        other.oscillator.loads.push_back({0, x > Rational("18/5") ? 3 : 2, Rational(0), Rational(0)});
        return other;
      },
      low, high, "do not change linearly");
}
