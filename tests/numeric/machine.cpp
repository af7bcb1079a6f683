// (3) against Newton's equations in SI units, which know no dimensionless quantity.
#include "numeric/machine_along.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "model/flows.hpp"

using namespace stickslip;
using namespace stickslip::numeric;

namespace {

Rational q(const char * text) {
  return parse_rational(text);
}

MachineInSI machine(const char * k1, const char * k2) {
  return {q("2.5"), q("0.8"), q(k1), q(k2), q("9"), q("13.5"), q("0.05"), q("12"), q("3.2")};
}

// Machines with an irrational and a rational Omega, and those with all lengths and forces changed.
std::vector<MachineInSI> machines() {
  std::vector<MachineInSI> all{machine("1200", "450"), machine("600", "400")};
  for (const char * scale : {"1e-7", "1e5"}) {
    MachineInSI m = machine("1200", "450");
    for (Rational * value :
         {&m.friction_sliding, &*m.friction_at_rest, &m.belt_velocity, &m.load_amplitude}) {
      *value *= q(scale);
    }
    all.push_back(m);
  }
  return all;
}

// Equal, but for the digits that are left out of omega and V.
bool agree(const Ball& a, const Ball& b) {
  const Ball relative = (a - b) / b;
  return Ball::from_interval(q("-1e-17"), q("1e-17")).contains(relative);
}

// det(K - w^2 M) of the machine.
Ball determinant(const MachineInSI& m, const Ball& w) {
  const Ball square = w * w;
  return (Ball(Rational(m.k1 + m.k2)) - Ball(m.m1) * square) * (Ball(m.k2) - Ball(m.m2) * square) -
         Ball(m.k2) * Ball(m.k2);
}

}  // namespace

TEST_CASE("the data taken move as the machine does") {
  const WorkingPrecision precision(200);
  for (const MachineInSI& m : machines()) {
    const DataTaken taken = data_taken(m);
    const motion::ExactParameters& a = taken.data;
    const model::Parameters<Ball> data = motion::parameters_as<Ball>(a);
    const model::Modes<Ball> modes = model::modes<Ball>(data.chi, data.eta);
    CHECK(determinant(m, modes.omega1 * taken.Omega()).contains_zero());
    CHECK(determinant(m, modes.omega2 * taken.Omega()).contains_zero());
    // At rest under the friction alone both springs carry it.
    const Ball rest = data.us / (data.chi * (Ball(1) - data.chi)) * taken.length();
    CHECK(agree(rest, Ball(Rational(m.friction_sliding / m.k1 + m.friction_sliding / m.k2))));
    // Forced motion: (K - w^2 M) x = (0, load).
    const Ball w = Ball(2) * Ball::pi() * Ball(m.load_frequency);
    const Ball forced =
        Ball(m.load_amplitude) * (Ball(Rational(m.k1 + m.k2)) - Ball(m.m1) * w * w) / determinant(m, w);
    CHECK(agree(model::Q<Ball>(data, modes)(1) * taken.length(), forced));
    CHECK(agree(data.V * taken.velocity(), Ball(m.belt_velocity)));
    CHECK(agree(data.omega * taken.frequency(), Ball(m.load_frequency)));
    CHECK(agree(Ball(*taken.ur) * taken.force(), Ball(*m.friction_at_rest)));
    CHECK(*taken.ur / a.us == q("1.5"));
  }
}

TEST_CASE("nothing is rounded that is rational, and the unit of length is of the machine's size") {
  const std::vector<MachineInSI> all = machines();
  CHECK(data_taken(all[0]).rounded_V);
  const DataTaken rational = data_taken(all[1]);
  CHECK_FALSE(rational.rounded_V);
  CHECK(rational.data.V == q("2.5"));
  CHECK(rational.thousands == -1);
  MachineInSI still = all[0];
  still.belt_velocity = 0;
  CHECK_FALSE(data_taken(still).rounded_V);
  CHECK(data_taken(still).data.V == 0);
  for (const MachineInSI& m : all) {
    CHECK(data_taken(m).data.chi == Rational(m.k2 / (m.k1 + m.k2)));
    CHECK(*data_taken(m).ur >= q("0.1"));
    CHECK(*data_taken(m).ur < 100);
  }
}

TEST_CASE("machines that are none are refused") {
  const auto refused = [](auto&& change) {
    MachineInSI m = machine("1200", "450");
    change(m);
    CHECK_THROWS_AS((void)data_taken(m), DomainError);
  };
  refused([](MachineInSI& m) { m.m1 = 0; });
  refused([](MachineInSI& m) { m.m2 = -1; });
  refused([](MachineInSI& m) { m.k1 = 0; });
  refused([](MachineInSI& m) { m.k2 = -3; });
  refused([](MachineInSI& m) { m.friction_sliding = 0; });
  refused([](MachineInSI& m) { m.friction_at_rest = m.friction_sliding; });
  refused([](MachineInSI& m) { m.belt_velocity = -1; });
  refused([](MachineInSI& m) { m.load_amplitude = -1; });
  refused([](MachineInSI& m) { m.load_frequency = 0; });
  refused([](MachineInSI& m) { m.k1 = q("1e51"); });
  refused([](MachineInSI& m) { m.load_amplitude = q("1e-9999"); });
}

TEST_CASE("along a value of a machine the data are those of the machine there, and their slopes") {
  const WorkingPrecision precision(128);
  for (Rational MachineInSI::*const member :
       {&MachineInSI::m1, &MachineInSI::m2, &MachineInSI::k1, &MachineInSI::k2,
        &MachineInSI::friction_sliding, &MachineInSI::belt_velocity, &MachineInSI::load_amplitude,
        &MachineInSI::load_frequency}) {
    const MachineInSI first = machine("1200", "450");
    MachineInSI last = first;
    last.*member *= q("1.3");
    const MachineAlong along{first, last, q("2"), q("5"), data_taken(first).thousands};
    const auto all = [](const auto& given) {
      const auto& a = given.data;
      return std::vector{a.chi, a.eta, a.us, a.V, a.omega, a.p, *given.ur};
    };
    const auto balls = [&](const Rational& value) { return all(along.at<Ball, Ball>(Ball(value))); };
    const Rational here = q("3.1");
    MachineInSI there = first;
    there.*member *= 1 + q("0.1") * (here - 2);
    const DataTaken taken = data_taken(there, along.thousands);
    CHECK(along.taken(here).data.omega == taken.data.omega);
    const std::vector<Ball> expected =
        all(motion::Given<Ball>{motion::parameters_as<Ball>(taken.data), {}, Ball(*taken.ur)});
    const std::vector<Ball> found = balls(here), later = balls(here + q("1e-9"));
    const auto jets =
        all(along.at<zeros::ParameterJet, Ball>(zeros::ParameterJet::variable(Ball(here), 0, 1)));
    for (std::size_t k = 0; k < found.size(); ++k) {
      CAPTURE(k);
      CHECK(agree(found[k], expected[k]));
      const Ball slope = (later[k] - found[k]) / Ball(q("1e-9"));
      CHECK(jets[k].partial(0).approximate() == doctest::Approx(slope.approximate()).epsilon(1e-6));
    }
  }
}
