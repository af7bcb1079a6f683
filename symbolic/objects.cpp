#include "symbolic/objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "model/flows.hpp"
#include "symbolic/derive.hpp"
#include "symbolic/latex.hpp"
#include "symbolic/symbols.hpp"

namespace stickslip::symbolic {
namespace {

using GiNaC::ex;
using Blocks = model::Blocks<ex>;
using Modes = model::Modes<ex>;
using Vector2 = model::Vector2<ex>;
using Vector4 = model::Vector4<ex>;
using Lines = std::vector<Line>;

ex chi() {
  return symbol("chi");
}
ex eta() {
  return symbol("eta");
}
ex omega() {
  return symbol("omega");
}
ex phi() {
  return symbol("phi");
}
ex t() {
  return symbol("t");
}
Modes modes() {
  return {symbol("omega1"), symbol("omega2"), symbol("lambda1"), symbol("lambda2")};
}
// As abbreviations: "Q" says what they are.
Vector2 Q_symbols() {
  return {symbol("q1"), symbol("q2")};
}
Vector2 d0_symbols() {
  return {symbol("d01"), symbol("d02")};
}

ex written_in(const ex& value, Unknowns unknowns) {
  return unknowns == Unknowns::omega ? in_frequencies(value) : value;
}

Line scalar(const std::string& left, const ex& value, Unknowns unknowns) {
  return {left, latex(written_in(value, unknowns))};
}

template <class Derived>
Line matrix(const std::string& left, const Eigen::MatrixBase<Derived>& value, Unknowns unknowns) {
  return {left, latex(value.unaryExpr([unknowns](const ex& entry) { return written_in(entry, unknowns); }))};
}

// Name_1(t), Name_2(t), Name_3(t).
Lines three(const std::string& name, const Blocks& blocks, Unknowns unknowns) {
  return {matrix(name + "_1(t)", blocks.first, unknowns), matrix(name + "_2(t)", blocks.second, unknowns),
          matrix(name + "_3(t)", blocks.third, unknowns)};
}

// (6), (10): the 4×4 matrix by its blocks, and then these.
Lines assembled(const std::string& name, const Blocks& blocks, Unknowns unknowns) {
  Lines lines = three(name, blocks, unknowns);
  lines.insert(lines.begin(), {name + "(t)", fmt::format("\\begin{{pmatrix}}\n{0}_1(t) & {0}_2(t) \\\\\n"
                                                         "{0}_3(t) & {0}_1(t)\n\\end{{pmatrix}}",
                                                         name)});
  return lines;
}

Blocks H_blocks() {
  return model::H_blocks(modes(), t());
}
Blocks Gamma_blocks() {
  return model::Gamma_blocks(chi(), t());
}

// (39): the roots of the characteristic polynomial, a quadratic in s².
Lines natural_frequencies(Unknowns unknowns) {
  const ex s = symbol("s");
  const ex D = characteristic_polynomial(model::stiffness<ex>(chi(), eta()), s);
  Lines lines = {scalar("D(s^2)=\\det(K-s^2I)", D, unknowns)};
  if (unknowns == Unknowns::chi) {
    const ex sum = -D.coeff(s, 2);
    const ex root = GiNaC::sqrt((sum * sum - 4 * D.coeff(s, 0)).expand());
    lines.push_back(scalar("\\omega_1^2", (sum - root) / 2, unknowns));
    lines.push_back(scalar("\\omega_2^2", (sum + root) / 2, unknowns));
  }
  return lines;
}

Lines lambdas(Unknowns unknowns) {
  const Modes m = model::modes_of(chi(), modes().omega1, modes().omega2);
  return {scalar("\\lambda_1", m.lambda1, unknowns), scalar("\\lambda_2", m.lambda2, unknowns)};
}

model::Parameters<ex> parameters() {
  return {chi(), eta(), symbol("us"), symbol("V"), omega(), symbol("p")};
}

Vector4 response() {
  return model::F<ex>(Q_symbols(), omega(), omega() * t() + phi());
}

Vector4 initial_state() {
  return {symbol("z10"), symbol("z20"), symbol("zdot10"), symbol("zdot20")};
}

// z(t) as a combination of the modes: z_1 = Σ (a_j cos + b_j sin)(omega_j t) + forced part, the same a_j, b_j
// times lambda_j in z_2, and what a_j and b_j are.
Lines modal(const Vector4& Z, Unknowns unknowns) {
  const Modes m = modes();
  const std::array names = {"a1", "b1", "a2", "b2"};
  const std::array<ex, 4> waves = {GiNaC::cos(m.omega1 * t()), GiNaC::sin(m.omega1 * t()),
                                   GiNaC::cos(m.omega2 * t()), GiNaC::sin(m.omega2 * t())};
  Lines coefficients;
  std::array<ex, 2> rest = {Z(0).expand(), Z(1).expand()};
  std::array<ex, 2> combination = {0, 0};
  for (std::size_t k = 0; k < waves.size(); ++k) {
    const ex coefficient = rest[0].coeff(waves[k]);
    coefficients.push_back(scalar(latex_name(names[k]), coefficient, unknowns));
    combination[0] += symbol(names[k]) * waves[k];
    combination[1] += (k < 2 ? m.lambda1 : m.lambda2) * symbol(names[k]) * waves[k];
    rest[0] = (rest[0] - coefficient * waves[k]).expand();
    rest[1] = (rest[1] - rest[1].coeff(waves[k]) * waves[k]).expand();
  }
  Lines lines;
  for (std::size_t i = 0; i < 2; ++i) {
    lines.push_back(scalar(fmt::format("z_{}(t)", i + 1), combination[i] + rest[i].normal(), unknowns));
  }
  lines.insert(lines.end(), coefficients.begin(), coefficients.end());
  return lines;
}

Lines slip(Unknowns unknowns) {
  return modal(model::slip_flow<ex>(modes(), Q_symbols(), omega(), phi(), initial_state(), t()), unknowns);
}

Lines overshoot(Unknowns unknowns) {
  return modal(
      model::overshoot_flow<ex>(modes(), Q_symbols(), d0_symbols(), omega(), phi(), initial_state(), t()),
      unknowns);
}

Lines stick(Unknowns unknowns) {
  const Vector4 Z = model::stick_flow<ex>(chi(), initial_state(), t());
  return {scalar("z_1(t)", Z(0), unknowns), scalar("z_2(t)", Z(1), unknowns),
          scalar("\\dot z_1(t)", Z(2), unknowns), scalar("\\dot z_2(t)", Z(3), unknowns)};
}

Lines chi_lines(Unknowns) {
  return {{"\\chi", latex(model::chi_from_frequencies<ex>(modes().omega1, modes().omega2))}};
}

Lines eta_lines(Unknowns) {
  return {{"\\eta", latex(model::eta_from_frequencies<ex>(modes().omega1, modes().omega2))}};
}

std::vector<Object> make_objects() {
  return {
      {"K", "(39)", "stiffness matrix",
       [](Unknowns u) { return Lines{matrix("K", model::stiffness<ex>(chi(), eta()), u)}; }},
      {"omega", "(39)", "natural frequencies and the polynomial whose roots they are", natural_frequencies},
      {"lambda", "(39)", "second components of the eigenvectors", lambdas},
      {"chi", "(39)", "stiffness ratio in terms of the natural frequencies", chi_lines},
      {"eta", "(39)", "mass ratio in terms of the natural frequencies", eta_lines},
      {"Lambda", "(38)", "matrix of the eigenvectors",
       [](Unknowns u) { return Lines{matrix("\\Lambda", model::Lambda(modes()), u)}; }},
      {"B", "(38)", "the modes as functions of time",
       [](Unknowns u) { return three("B", model::B(modes(), t()), u); }},
      {"H", "(6)", "flow of the slip without load, by blocks",
       [](Unknowns u) { return assembled("H", H_blocks(), u); }},
      {"H1", "(38)", "first block of H",
       [](Unknowns u) { return Lines{matrix("H_1(t)", H_blocks().first, u)}; }},
      {"H2", "(38)", "second block of H",
       [](Unknowns u) { return Lines{matrix("H_2(t)", H_blocks().second, u)}; }},
      {"H3", "(38)", "third block of H",
       [](Unknowns u) { return Lines{matrix("H_3(t)", H_blocks().third, u)}; }},
      {"L", "(8)", "what the reversed friction adds in an overshooting slip, per 2 d_0",
       [](Unknowns u) { return Lines{matrix("L(t)", model::L(modes(), t()), u)}; }},
      {"Sigma", "(41)", "matrix of the eigenvectors during stick",
       [](Unknowns u) { return Lines{matrix("\\Sigma", model::Sigma(chi()), u)}; }},
      {"gamma", "(41)", "the motions during stick as functions of time",
       [](Unknowns u) { return three("\\gamma", model::gamma(t()), u); }},
      {"Gamma", "(10)", "flow of the stick, by blocks",
       [](Unknowns u) { return assembled("\\Gamma", Gamma_blocks(), u); }},
      {"Gamma1", "(41)", "first block of Gamma",
       [](Unknowns u) { return Lines{matrix("\\Gamma_1(t)", Gamma_blocks().first, u)}; }},
      {"Gamma2", "(41)", "second block of Gamma",
       [](Unknowns u) { return Lines{matrix("\\Gamma_2(t)", Gamma_blocks().second, u)}; }},
      {"Gamma3", "(41)", "third block of Gamma",
       [](Unknowns u) { return Lines{matrix("\\Gamma_3(t)", Gamma_blocks().third, u)}; }},
      {"d0", "(6)", "equilibrium under the slipping friction",
       [](Unknowns u) { return Lines{matrix("d_0", model::d0(chi(), parameters().us), u)}; }},
      {"Q", "(7)", "amplitudes of the forced motion",
       [](Unknowns u) { return Lines{matrix("Q", model::Q(parameters(), modes()), u)}; }},
      {"R", "(5)", "forced motion",
       [](Unknowns u) { return Lines{matrix("R(t)", Vector2(response().head<2>()), u)}; }},
      {"F", "(5)", "forced motion with its velocities",
       [](Unknowns u) { return Lines{matrix("F(t)", response(), u)}; }},
      {"slip", "(5)", "motion during a slip from any state", slip},
      {"overshoot", "(8)", "motion during an overshooting slip from any state", overshoot},
      {"stick", "(10)", "motion during stick from any state", stick},
  };
}

}  // namespace

const std::vector<Object>& objects() {
  static const std::vector<Object> all = make_objects();
  return all;
}

const Object& object_named(const std::string& name) {
  const auto object = std::ranges::find(objects(), name, &Object::name);
  if (object == objects().end()) {
    throw UsageError(
        fmt::format("there is no derived expression {}: stickslip latex --list names them", name));
  }
  return *object;
}

std::string displayed(const Object& object, Unknowns unknowns) {
  const Lines lines = object.lines(unknowns);
  const bool single = lines.size() == 1;
  std::string result = single ? "\\[\n" : "\\begin{gather*}\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    result += fmt::format("{} = {}{}\n", lines[i].left, lines[i].right, i + 1 < lines.size() ? " \\\\" : "");
  }
  return result + (single ? "\\]\n" : "\\end{gather*}\n");
}

std::string list_of_objects() {
  std::string result;
  for (const Object& object : objects()) {
    result += fmt::format("{:<9}  {:<4}  {}\n", object.name, object.number, object.title);
  }
  return result;
}

}  // namespace stickslip::symbolic
