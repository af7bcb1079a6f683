// Motions of all machines over a box of data: polynomials, flows, conditions and links against single
// machines in it, the linear chain against single ones, and families of motions.
#include "numeric/machines/orbits/motions_over_data.hpp"

#include <doctest/doctest.h>

#include <random>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/machines/orbits/judge.hpp"
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
};
std::vector<Datum> data() {
  return {
      {"frequency", Rational("18/5"), [](auto& o, const Rational& x) { o.omega = x; }},
      {"belt", Rational("1/20"), [](auto& o, const Rational& x) { o.V = x; }},
      {"spring", Rational(450),
       [](auto& o, const Rational& x) { o.stiffness << Rational(1200 + x), Rational(-x), Rational(-x), x; }},
      {"dashpot", Rational("3/5"), [](auto& o, const Rational& x) { o.damping(0, 0) = x; }},
      {"mass", Rational("4/5"), [](auto& o, const Rational& x) { o.masses[1] = x; }},
      {"at rest", Rational("27/2"),
       [](auto& o, const Rational& x) { o.forward.at_rest = o.backward.at_rest = x; }},
      {"load", Rational(12), [](auto& o, const Rational& x) { o.loads[0].cosine = x; }},
      {"sliding friction", Rational("15/2"),
       [](auto& o, const Rational& x) {
         for (auto * law : {&o.forward, &o.backward}) {
           law->sliding[0].slope = Rational((x - 9) * 20);
           law->sliding[1].force = x;
           law->sliding[1].slope = Rational((6 - x) * 4);
         }
       }},
      {"where a piece of the friction begins", Rational("1/20"),
       [](auto& o, const Rational& x) {
         for (auto * law : {&o.forward, &o.backward}) {
           law->sliding[1].from = x;
           law->sliding[0].slope = Rational(Rational("-3/2") / x);
           law->sliding[1].slope = Rational(Rational("-3/2") / (Rational("3/10") - x));
         }
       }},
      {"a mass by its inverse, and a spring", Rational("18/5"), [](auto& o, const Rational& x) {
         o.masses[0] = Rational(9 / x);
         o.stiffness(0, 0) = Rational(1650 * x * 5 / 18);
       }}};
}

// Of the machine in the middle.
Chain in_middle(const MachineQuestion& question) {
  return Chain({question.machine, question.pieces, question.periods});
}

Machine with(const Datum& datum, const Rational& value) {
  Machine machine = engineers();
  datum.set(machine.oscillator, value);
  return machine;
}

// Data, each half as wide as a share of its value.
struct Box {
  std::vector<Datum> of;
  Rational share;

  [[nodiscard]] Machine at(const std::vector<Rational>& s) const {
    Machine machine = engineers();
    for (std::size_t k = 0; k < of.size(); ++k) {
      of[k].set(machine.oscillator, Rational(of[k].value * (1 + share * s[k])));
    }
    return machine;
  }
  [[nodiscard]] MachineQuestion question(const std::vector<Piece>& pieces, long periods) const {
    const Values middle(of.size(), Rational(0)), half(of.size(), Rational(1)), low(of.size(), Rational(-1));
    const NumbersInData numbers([&](const Values& s) { return at(s); }, low, half);
    REQUIRE(numbers.why_not().empty());
    return {at(middle), pieces, periods, numbers.over({middle, half})};
  }
  [[nodiscard]] std::vector<std::vector<Rational>> some_inside() const {
    return of.size() == 1
               ? std::vector<std::vector<Rational>>{{-1}, {Rational("-7/11")}, {0}, {Rational("1/5")}, {1}}
               : std::vector<std::vector<Rational>>{
                     {-1, 1}, {Rational("-7/11"), Rational("1/3")}, {1, -1}, {-1, -1}, {0, Rational("1/5")}};
  }
};
// One by one, and some two of them.
std::vector<Box> boxes(const char * share) {
  std::vector<Box> all;
  for (const Datum& datum : data()) {
    all.push_back({{datum}, parse_rational(share)});
  }
  for (const auto& [i, k] : {std::pair{1, 4}, {2, 4}, {0, 7}, {3, 5}, {1, 8}, {4, 9}}) {
    all.push_back(
        {{data()[static_cast<std::size_t>(i)], data()[static_cast<std::size_t>(k)]}, parse_rational(share)});
  }
  return all;
}

template <class M>
InData<M> of_coefficients(const std::vector<M>& c) {
  InData<M> f;
  f.c = c;
  return f;
}

std::vector<Ball> balls(const std::vector<Rational>& s) {
  return {s.begin(), s.end()};
}

MachineOrbit orbit_of(const Machine& machine) {
  Eigen::VectorXd start(4);
  start << 0.0, 0.0, 0.0, 0.0;
  return prove_machine_orbit(machine, settle(machine, start).guess);
}

Nodes at(const NodesInData& nodes, const std::vector<Rational>& s) {
  Nodes result;
  std::ranges::transform(nodes, std::back_inserter(result),
                         [&](const auto& node) { return Node(node.at(balls(s))); });
  return result;
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

TEST_CASE("polynomials in data contain the functions, and leave out what is of the fourth order") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const std::size_t count = 1 + static_cast<std::size_t>(round) % 3;
    const double size = std::exp2(-round % 8 - 2);
    const auto some = [&](std::size_t data) {
      std::vector<Ball> c(monomials(data));
      for (Ball& coefficient : c) {
        coefficient = Ball(size * number(random));
      }
      c[0] = Ball(3 + number(random));
      return of_coefficients(c);
    };
    // One of fewer data is one of more.
    const InData<Ball> f = some(count), g = some(round % 2 == 0 ? 1 : count), product = f * g;
    const auto [sine, cosine] = sin_cos(f);
    const InData<Ball> inverse = reciprocal(f);
    for (int point = 0; point < 12; ++point) {
      std::vector<Ball> s;
      for (std::size_t k = 0; k < count; ++k) {
        s.emplace_back(point < 8 ? ((point >> k) % 2 == 0 ? -1.0 : 1.0) : number(random));
      }
      const Ball x = f.at(s);
      const auto [sine_there, cosine_there] = sin_cos(x);
      CHECK(sine.at(s).overlaps(sine_there));
      CHECK(cosine.at(s).overlaps(cosine_there));
      CHECK(product.at(s).overlaps(Ball(x * g.at(s))));
      CHECK(inverse.at(s).overlaps(Ball(Ball(1) / x)));
      CHECK(f.all().contains(x));
      CHECK(sine.all().overlaps(sine_there));
    }
    std::vector<Ball> line(monomials(count), Ball(0));
    line[0] = Ball(3);
    line[1] = Ball(size);
    const InData<Ball> x = of_coefficients(line);
    for (const InData<Ball>& one : {x * x * x * x, sin_cos(x).first, sin_cos(x).second, reciprocal(x)}) {
      CHECK(one.rest.radius().approximate() <= 16 * std::pow(size, 4));
    }
    CHECK((x * x * x).rest.radius().approximate() <= 1e-17);
  }
  CHECK_FALSE(reciprocal(of_coefficients<Ball>({Ball(1), Ball(-1), Ball(0), Ball(0)})).rest.is_finite());
}

TEST_CASE("flows in data contain each one's, and leave out what is of the fourth order") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 12; ++round) {
    const double size = std::exp2(-3 * (round % 4));
    const auto some = [&](double most) {
      Matrix A(5, 5);
      for (Ball& entry : A.reshaped()) {
        entry = Ball(most * number(random));
      }
      return A;
    };
    const Ball t(round % 3 == 0 ? -1.5 : 4.0 / (1 + round));
    const Matrix B0 = some(1), B1 = some(size), B2 = some(size);
    const auto flow = [&](double share) {
      std::vector<Matrix> c(monomials(2));
      c[0] = B0 * t;
      c[place_of(1)] = B1 * Ball(t * Ball(share));
      c[place_of(2)] = B2 * Ball(t * Ball(share));
      return exponential(of_coefficients(c), balance(B0).cwiseInverse());
    };
    const InData<Matrix> E = flow(1);
    for (const auto& [a, b] : {std::pair{-1.0, -1.0}, {-0.6, 1.0}, {0.0, 0.0}, {1.0, 0.3}, {1.0, -1.0}}) {
      const Matrix one = exponential(Matrix(Matrix(B0 + B1 * Ball(a) + B2 * Ball(b)) * t));
      check_contains(E.at({Ball(a), Ball(b)}), one);
      check_contains(E.all(), one);
    }
    CHECK(widest(E.c[0]) < 1e-15);
    CHECK(widest(flow(0.125).rest) < widest(E.rest) / 1500);
  }
}

TEST_CASE("what machines do over data contains what each of them does") {
  const MachineOrbit orbit = orbit_of(engineers());
  REQUIRE(orbit.existence.truth == Truth::proved);
  const Nodes m = midpoints(nodes_of(guess_of(orbit, engineers()), engineers()));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const Box& box : boxes("1/4096")) {
    CAPTURE(std::string(box.of.front().name));
    CAPTURE(std::string(box.of.back().name));
    const Chain all(box.question(orbit.pieces, orbit.periods));
    NodesInData nodes;
    for (const Node& u : m) {
      nodes.emplace_back(Matrix(u));
      for (std::size_t i = 1; i < monomials(box.of.size()); ++i) {
        nodes.back().c.emplace_back(
            u.unaryExpr([&](const Ball& x) { return Ball(Ball(0x1p-14 * number(random)) * abs(x)); }));
      }
    }
    NodesInData wide = nodes;
    for (InData<Matrix>& node : wide) {
      node.rest = Matrix::Constant(4, 1, Ball::hull(Ball(-0x1p-20), Ball(0x1p-20)));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const InData<Matrix> conditions = all.conditions(nodes, i);
      const Link link = all.link(nodes, i), of_wide = all.link(wide, i);
      for (const std::vector<Rational>& s : box.some_inside()) {
        const Chain one({box.at(s), orbit.pieces, orbit.periods});
        const Nodes there = at(nodes, s);
        Nodes beside = there;
        for (Node& u : beside) {
          u = u.unaryExpr([&](const Ball& x) { return Ball(x + Ball(0x1p-20 * number(random))); });
        }
        check_contains(conditions.at(balls(s)), one.conditions(there, i));
        const Link single = one.link(there, i);
        check_contains(link.M.at(balls(s)), single.M.c[0]);
        check_contains(link.M.all(), single.M.c[0]);
        check_contains(of_wide.M.at(balls(s)), one.link(beside, i).M.c[0]);
        check_contains(link.end_velocity, single.end_velocity);
        // What ends the phase, at times of it, and its distance to a number that changes.
        const auto& phases = one.phases();
        const InData<Matrix> begin = all.beginning(nodes, i);
        const Ball T = one.duration(there, i);
        const Watched watched(all.phases(), orbit.pieces[i], begin, T, false),
            of_one(phases, orbit.pieces[i], InData<Matrix>(Matrix(one.beginning(there, i))), T, false);
        const auto bound = [](const auto& o) { return o.forward.at_rest + o.V; };
        const AffineCourse distance(watched, -1, all.phases().number(bound)),
            distance_of_one(of_one, -1, phases.number(bound));
        for (const double share : {0x1p-20, 0.3, 0.9}) {
          const double t = share * T.approximate();
          for (std::size_t d = 0; d < 4; ++d) {
            CHECK(watched.at(Ball(t))[d].overlaps(of_one.at(Ball(t))[d]));
            CHECK(distance.at(t)[d].overlaps(distance_of_one.at(t)[d]));
          }
        }
        CHECK(link.rate.overlaps(single.rate));
      }
      // What is left is smaller than what changes.
      CHECK(widest(link.M.rest) < 0.2 * widest(Matrix(link.M.all() - link.M.c[0])));
    }
  }
}

TEST_CASE("a linear chain whose links change contains those of single links") {
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
      link.M.c.resize(monomials(2));
      link.M.c[0] = matrix(1);
      link.M.c[place_of(1)] = matrix(1e-3);
      link.M.c[place_of(2)] = matrix(1e-3);
      g.push_back(Node(matrix(1).col(0)));
    }
    const auto found = LinearChain::of(links);
    REQUIRE(found);
    const Nodes deviations = found->deviations(g);
    for (const auto& [a, b] : {std::pair{-1.0, 1.0}, {-0.4, -1.0}, {0.2, 0.0}, {1.0, 1.0}}) {
      std::vector<Link> one = links;
      for (Link& link : one) {
        link.M = InData<Matrix>(link.M.at({Ball(a), Ball(b)}));
      }
      const auto single = LinearChain::of(one);
      REQUIRE(single);
      const Nodes of_one = single->deviations(g);
      for (std::size_t i = 0; i < links.size(); ++i) {
        check_contains(deviations[i], of_one[i]);
      }
    }
  }
}

TEST_CASE("powers of s in a product of links are in its return map") {
  Link link;
  link.M.c = {Matrix::Constant(1, 1, Ball(2)), Matrix::Constant(1, 1, Ball(0.25)), {}, {}};
  const auto found = LinearChain::of(std::vector<Link>(4, link));
  REQUIRE(found);
  CHECK(found->return_map()(0, 0).overlaps(Ball(2.25 * 2.25 * 2.25 * 2.25)));
  CHECK(found->return_map()(0, 0).overlaps(Ball(1.75 * 1.75 * 1.75 * 1.75)));
  CHECK_FALSE(found->return_map()(0, 0).overlaps(Ball(28)));
}

TEST_CASE("motions of machines over data lie among those that are proved") {
  const MachineOrbit orbit = orbit_of(engineers());
  REQUIRE(orbit.admissible.truth == Truth::proved);
  for (const Box& box : boxes("1/50000")) {
    CAPTURE(std::string(box.of.front().name));
    CAPTURE(std::string(box.of.back().name));
    const auto proof_at = [&](const Machine& machine) {
      return prove_chain({machine, orbit.pieces, orbit.periods}, nodes_of(guess_of(orbit, machine), machine),
                         128, 512);
    };
    const std::vector<Rational> corner(box.of.size(), Rational(-1));
    Known known{corner, proof_at(box.at(corner))};
    const Nodes middle = proof_at(box.at(Values(box.of.size()))).nodes;
    const WorkingPrecision scope(64);
    const MachineQuestion question = box.question(orbit.pieces, orbit.periods);
    const auto nodes = approximate_chains(Chain(question), in_middle(question), middle);
    REQUIRE(nodes);
    const ChainProof all = prove_chains(Chain(question), *nodes, {known});
    CAPTURE(all.verdict.reason);
    REQUIRE(all.verdict.truth == Truth::proved);
    for (const std::vector<Rational>& s : box.some_inside()) {
      const ChainProof one = proof_at(box.at(s));
      REQUIRE(one.verdict.truth == Truth::proved);
      for (std::size_t i = 0; i < one.nodes.size(); ++i) {
        check_contains(all.nodes[i], one.nodes[i]);
      }
      const Ball trace = all.return_map.trace(), of_one = one.return_map.trace();
      CHECK(trace.overlaps(of_one));
      CHECK(trace.radius().approximate() < 0.05);
    }
    CHECK(state_of(decided(question, all)) == branches::State::stable);
    // A closed chain that is known elsewhere is not one of them.
    known.s.front() = Rational("1/2");
    CHECK(prove_chains(Chain(question), *nodes, {known}).verdict.truth == Truth::undecided);
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
  const auto at = [&](const Values& V) {
    Machine other = brake;
    other.oscillator.V = V[0];
    return other;
  };
  const auto proof_of = [&](const Machine& machine) {
    return prove_chain({machine, orbit.pieces, orbit.periods}, nodes_of(guess_of(orbit, machine), machine),
                       64, 512);
  };
  const ChainProof middle = proof_of(brake);
  const WorkingPrecision scope(64);
  const NumbersInData numbers(at, {parse_rational("0.11996")}, {parse_rational("0.12004")});
  const MachineQuestion question{brake, orbit.pieces, orbit.periods,
                                 numbers.over({{parse_rational("0.12")}, {parse_rational("0.00004")}})};
  const auto nodes = approximate_chains(Chain(question), in_middle(question), middle.nodes);
  REQUIRE(nodes);
  const ChainProof curve = prove_chains(Chain(question), *nodes, {});
  REQUIRE(curve.verdict.truth == Truth::proved);
  CHECK(state_of(decided(question, curve)) == branches::State::stable);
}

TEST_CASE("a state that is lost between is not said of all, nor is what is no quotient joined") {
  const MachineOrbit orbit = orbit_of(engineers());
  const Machine machine = engineers();
  const auto joint = [&](const auto& at, const Rational& a, const Rational& b) {
    const auto end = [&](const Rational& x) {
      return MotionAt{{x}, guess_of(prove_machine_orbit(at(x), guess_of(orbit, machine)), at(x))};
    };
    return joints_between(at, {end(a), end(b)}, branches::State::stable).front();
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
  const char * const no_quotient = "no quotient of linear functions";
  refused(
      "a square", [&](const Rational& x) { return frequency(Rational(x * x * 5 / 18)); }, low, high,
      no_quotient);
  refused(
      "another multiple of the load",
      [&](const Rational& x) {
        Machine other = engineers();
        other.oscillator.loads.push_back({0, x > Rational("18/5") ? 3 : 2, Rational(0), Rational(0)});
        return other;
      },
      low, high, "changes its shape");
}

TEST_CASE("a box of two data is proved in parts that make it up, and is what single machines say") {
  const MachineOrbit orbit = orbit_of(engineers());
  const MachineGuess guess = guess_of(orbit, engineers());
  const Datum belt = data()[1], mass = data()[4];
  const auto at = [&](const Values& values) {
    Machine machine = with(belt, values[0]);
    mass.set(machine.oscillator, values[1]);
    return machine;
  };
  const auto about = [](const Rational& value, const char * share) {
    const Rational half = value * parse_rational(share);
    return std::pair(Rational(value - half), Rational(value + half));
  };
  const auto [low_belt, high_belt] = about(belt.value, "4e-2");
  const auto [low_mass, high_mass] = about(mass.value, "4e-3");
  const DataBox box{at, {low_belt, low_mass}, {high_belt, high_mass}};
  const std::vector<MotionAt> motions{{{belt.value, mass.value}, guess}};
  const auto parts = motions_over(box, motions, {12, 1000});
  CHECK(parts.size() > 1);
  Rational area = 0;
  std::mt19937 random(3);
  std::uniform_int_distribution<long> number(0, 1000);
  for (const PartOfBox& part : parts) {
    CAPTURE(part.existence.reason);
    CHECK(part.existence.truth == Truth::proved);
    CHECK(part.motions.state == branches::State::stable);
    area += (part.high[0] - part.low[0]) * (part.high[1] - part.low[1]);
    Values inside = part.low;
    for (std::size_t k = 0; k < 2; ++k) {
      inside[k] += (part.high[k] - part.low[k]) * number(random) / 1000;
    }
    CHECK(state_of(prove_machine_orbit(at(inside), guess)) == branches::State::stable);
  }
  CHECK(area == (high_belt - low_belt) * (high_mass - low_mass));

  // Not where the effort ends before, nor what is not asked for.
  for (const PartOfBox& part : motions_over(box, motions, {12, 0})) {
    CHECK(part.existence.truth == Truth::undecided);
  }
  for (const PartOfBox& part : motions_over(box, motions, {1, 100})) {
    CHECK(part.motions.state == branches::State::undecided);
  }
  for (const PartOfBox& part : motions_over(box, motions, {12, 1000, false})) {
    CHECK(part.existence.truth == Truth::proved);
    CHECK(part.motions.state == branches::State::undecided);
  }
}

TEST_CASE("motions that are not of one family are not joined") {
  const MachineOrbit orbit = orbit_of(engineers());
  const Datum belt = data()[1];
  const auto end = [&](const char * factor) {
    const Rational value = belt.value * parse_rational(factor);
    const Machine machine = with(belt, value);
    return MotionAt{{value}, guess_of(prove_machine_orbit(machine, guess_of(orbit, engineers())), machine)};
  };
  const auto at = [&](const Rational& x) { return with(belt, x); };
  std::vector<MotionAt> motions{end("0.999"), end("1"), end("1.001")};
  for (const Joint& joint : joints_between(at, motions, branches::State::stable)) {
    CHECK(joint.state.truth == Truth::proved);
  }
  // Begun all periods of the load later: another chain, though the same motion.
  for (MachineGuess::Event& event : motions[2].guess.events) {
    event.t += motions[2].guess.duration;
  }
  const auto joints = joints_between(at, motions, branches::State::stable);
  CHECK(joints[0].state.truth == Truth::proved);
  CHECK(joints[1].existence.truth == Truth::undecided);
  CHECK(joints[1].state.truth == Truth::undecided);
}

TEST_CASE("a datum that changes nothing is one of a box all the same") {
  const MachineOrbit orbit = orbit_of(engineers());
  const Datum belt = data()[1];
  const DataBox box{[&](const Values& values) { return with(belt, values[0]); },
                    {parse_rational("0.048"), Rational(0)},
                    {parse_rational("0.052"), Rational(1)}};
  const auto parts =
      motions_over(box, {{{belt.value, Rational(1)}, guess_of(orbit, engineers())}}, {12, 100});
  CHECK(parts.size() < 50);
  for (const PartOfBox& part : parts) {
    CHECK(part.motions.state == branches::State::stable);
    CHECK(part.high[1] - part.low[1] == 1);
  }
}

TEST_CASE("a box with a machine that is none is refused") {
  const MachineGuess guess = guess_of(orbit_of(engineers()), engineers());
  const Datum mass = data()[4];
  const DataBox box{
      [&](const Values& values) { return with(mass, values[0]); }, {Rational(0)}, {Rational(1)}};
  CHECK_THROWS_AS((void)motions_over(box, {{{mass.value}, guess}}, {12, 10}), DomainError);
  CHECK_THROWS_AS((void)motions_over({box.at, {}, {}}, {{{}, guess}}, {12, 10}), DomainError);
  CHECK_THROWS_AS(
      (void)motions_over({box.at, {Rational(1)}, {Rational(2)}}, {{{mass.value}, guess}}, {12, 10}),
      DomainError);
}

TEST_CASE("a box of data is divided by what the motion is") {
  const MachineOrbit orbit = orbit_of(engineers());
  const Datum frequency = data()[0], dashpot = data()[3];
  const auto at = [&](const Values& values) {
    Machine machine = with(frequency, values[0]);
    dashpot.set(machine.oscillator, values[1]);
    return machine;
  };
  // Below 3.5878224, where the dashpot is as it is, r reaches ur while it sticks.
  const Values start{parse_rational("3.588"), dashpot.value};
  const DataBox box{at,
                    {parse_rational("3.5876"), Rational(dashpot.value * Rational("999/1000"))},
                    {parse_rational("3.5882"), Rational(dashpot.value * Rational("1001/1000"))}};
  const MachineOrbit there = prove_machine_orbit(at(start), guess_of(orbit, engineers()));
  REQUIRE(state_of(there) == branches::State::stable);
  const auto parts = motions_over(box, {{start, guess_of(there, at(start))}}, {4, 60});
  Rational stable = 0, inadmissible = 0, whole = 0;
  for (const PartOfBox& part : parts) {
    const Rational area = (part.high[0] - part.low[0]) * (part.high[1] - part.low[1]);
    whole += area;
    CAPTURE(part.existence.reason);
    CHECK(part.existence.truth == Truth::proved);
    if (part.motions.state == branches::State::stable) {
      stable += area;
      CHECK(part.low[0] > parse_rational("3.5877"));
    } else if (part.motions.state == branches::State::inadmissible) {
      inadmissible += area;
      CHECK(part.high[0] < parse_rational("3.5879"));
      CHECK(part.motions.names == "stick.upper");
    } else {
      CHECK(part.motions.names.find("stick.upper") != std::string::npos);
    }
  }
  CHECK(stable > whole / 2);
  CHECK(inadmissible > whole / 4);
  CHECK(stable + inadmissible > whole * Rational("17/20"));

  // Where parts are no longer looked at, what is known of one that they are half of.
  const auto few = motions_over(box, {{start, guess_of(there, at(start))}}, {12, 3});
  CHECK(few.size() > 1);
  for (const PartOfBox& part : few) {
    CAPTURE(part.existence.reason);
    CHECK(part.existence.truth == Truth::proved);
    const bool is_across = part.low[0] < parse_rational("3.5878") && part.high[0] >= parse_rational("3.5879");
    CHECK_FALSE((is_across && is_decided(part.motions.state)));
  }
}
