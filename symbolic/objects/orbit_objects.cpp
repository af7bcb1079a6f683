// The equations that orbits are found by, Sections 4-6, and what Appendices 3 and 5 derive from them.
#include <fmt/format.h>

#include <array>

#include "model/appendix3.hpp"
#include "model/nonsticking.hpp"
#include "model/symmetric.hpp"
#include "model/waves.hpp"
#include "symbolic/objects/object_lines.hpp"
#include "symbolic/typeset/latex.hpp"

namespace stickslip::symbolic::objects {

using namespace algebra;
using namespace typeset;

namespace {

using GiNaC::ex;
using Vector2 = model::Vector2<ex>;
using Vector4 = model::Vector4<ex>;

ex tau() {
  return symbol("tau");
}
ex tau1() {
  return symbol("tau1");
}

Lines symmetric() {
  const Vector4 residual =
      model::symmetric_residual<ex>(chi(), modes(), Q_symbols(), omega(), symbol("Theta"), tau(),
                                    {symbol("z10"), symbol("z20")}, {symbol("zdot10"), symbol("V")});
  Lines lines;
  for (const ex& equation : residual) {
    lines.push_back(sum("0", equation));
  }
  return lines;
}

Lines friction_at_rest() {
  const ex ur = model::friction_at<ex>(parameters(), model::Vector2<ex>(symbol("z10"), symbol("z20")), phi());
  return {scalar("u_r", ur)};
}

// a_i, b_i, c_i, d_i, in the paper's order.
Lines closing_coefficients() {
  const auto k = model::appendix3<ex>(model::appendix3_letters<ex>(
      chi(), modes(), Q_symbols(), d0_symbols(), omega(), symbol("V"), phi(), tau(), tau1(), symbol("T")));
  Lines lines;
  for (std::size_t i = 0; i < 5; ++i) {
    for (const auto& [letter, values] : {std::pair{'a', &k.a}, {'b', &k.b}, {'c', &k.c}, {'d', &k.d}}) {
      lines.push_back(sum(fmt::format("{}_{}", letter, i + 1), (*values)[i]));
    }
  }
  return lines;
}

// left = a determinant of (22), with these columns of the coefficients, in rows 1, 2, 3.
Line determinant(const std::string& left, const std::string& sign,
                 const std::array<const char *, 3>& columns) {
  GiNaC::matrix entries(3, 3);
  std::string rows;
  for (unsigned i = 0; i < 3; ++i) {
    for (unsigned j = 0; j < 3; ++j) {
      entries(i, j) = symbol(columns[j] + std::to_string(i + 1));
      rows += latex(ex(entries(i, j))) + (j < 2 ? " & " : i < 2 ? " \\\\\n" : "\n");
    }
  }
  const ex value = entries.determinant();
  return {left,
          fmt::format("{}\\begin{{vmatrix}}\n{}\\end{{vmatrix}}", sign, rows),
          {sign.empty() ? value : -value}};
}

// model::cramer() in the coefficients, whatever these are written in.
Lines cramer(Unknowns) {
  return {determinant("\\Delta", "", {"a", "b", "c"}), determinant("\\Delta_1", "-", {"d", "b", "c"}),
          determinant("\\Delta_2", "", {"d", "a", "c"}), determinant("\\Delta_3", "", {"d", "b", "a"})};
}

model::HalfPeriod<ex> half_period() {
  return model::half_period<ex>(chi(), modes(), d0_symbols(), omega(), GiNaC::Pi);
}

// With a_i, b_i and phi_i as abbreviations.
model::HalfPeriod<ex> half_period_letters() {
  const Vector2 d0 = d0_symbols();
  const ex b1 = symbol("b1");
  const ex b2 = symbol("b2");
  return {symbol("phi1"),         symbol("phi2"), symbol("d"), symbol("a1"), symbol("a2"), b1, b2,
          b1 * d0(0) + b2 * d0(1)};
}

// (34) with a_i; x_B = -x_0 and z_B' = -z_0', (33).
Lines nonsticking_states() {
  const Vector4 Z0 = model::half_period_start<ex>(half_period_letters(), Q_symbols(), d0_symbols(), omega(),
                                                  GiNaC::cos(phi()), GiNaC::sin(phi()));
  const Vector2 d0 = d0_symbols();
  const model::HalfPeriod<ex> h = half_period();
  return {sum("z_{10}", Z0(0)),
          sum("z_{20}", Z0(1)),
          sum("\\dot z_{10}", Z0(2)),
          sum("z_{1B}", -Z0(0).expand() - 2 * d0(0)),
          sum("z_{2B}", -Z0(1).expand() - 2 * d0(1)),
          sum("\\dot z_{1B}", -Z0(2).expand()),
          sum("a_1", h.a1),
          sum("a_2", h.a2)};
}

Lines nonsticking_phase() {
  const model::HalfPeriod<ex> h = half_period();
  return {scalar("\\sin\\varphi", -half_period_letters().friction_speed / (symbol("q2") * omega())),
          sum("b_1", h.b1), sum("b_2", h.b2)};
}

Lines least_load() {
  const model::HalfPeriod<ex> h = half_period();
  const ex square = model::least_load_squared<ex>(parameters(), modes(), half_period_letters(), symbol("ur"));
  return {scalar("p^2 > p_{\\min}^2", square), sum("b_1", h.b1), sum("b_2", h.b2)};
}

Lines eigenvalues() {
  return {scalar("\\rho_1", model::rho<ex>(modes().omega1, tau(), tau1())),
          scalar("\\rho_2", model::rho<ex>(modes().omega2, tau(), tau1()))};
}

Lines symmetry_matrix() {
  const model::Matrix2<ex> Lambda = model::Lambda<ex>(modes());
  const model::Matrix2<ex> P =
      Lambda * model::diagonal<ex>(symbol("rho1"), symbol("rho2")) * model::inverse<ex>(Lambda);
  Lines lines = eigenvalues();
  lines.insert(lines.begin(), matrix("P", P));
  return lines;
}

// The lines, and what their abbreviations stand for.
template <Lines (*lines)()>
Lines explained(Unknowns unknowns) {
  Lines all = lines();
  append_meanings(all, unknowns);
  return all;
}

}  // namespace

std::vector<Object> orbit_objects() {
  return {
      {"symmetric", "(16)", "closing equations of the symmetric orbit", explained<symmetric>},
      {"friction", "(24)", "friction at rest of an orbit", explained<friction_at_rest>},
      {"closing", "(47)", "coefficients (47)-(51) of the closing equations (21), with the right sign in $c1$",
       explained<closing_coefficients>},
      {"cramer", "(22)", "determinants that give the initial state of an overshooting orbit", cramer},
      {"nonsticking", "(34)", "states of the non-sticking orbit, by (31) and (33)",
       explained<nonsticking_states>},
      {"phase", "(35)", "phase of the load at a non-sticking orbit", explained<nonsticking_phase>},
      {"load", "(37)", "sharp bound for the load of a non-sticking orbit", explained<least_load>},
      {"P", "(64)", "matrix that decides whether a non-sticking orbit is symmetric",
       explained<symmetry_matrix>},
      {"rho", "(70)", "eigenvalues of $P$", [](Unknowns) { return eigenvalues(); }},
  };
}

}  // namespace stickslip::symbolic::objects
