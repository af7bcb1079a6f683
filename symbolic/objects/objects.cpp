#include "symbolic/objects/objects.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "core/error.hpp"
#include "core/verdict.hpp"
#include "model/flows.hpp"
#include "symbolic/algebra/derive.hpp"
#include "symbolic/objects/object_lines.hpp"
#include "symbolic/typeset/latex.hpp"

namespace stickslip::symbolic::objects {

using namespace algebra;
using namespace typeset;

namespace {

using GiNaC::ex;
using Blocks = model::Blocks<ex>;
using Modes = model::Modes<ex>;
using Vector2 = model::Vector2<ex>;
using Vector4 = model::Vector4<ex>;

ex t() {
  return symbol("t");
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

// The paper's abbreviations s_j = sin(omega_j t), and c_j likewise.
struct Abbreviation {
  const char * name;
  std::string full;
};

const std::array<Abbreviation, 4>& wave_names() {
  static const std::array<Abbreviation, 4> all = [] {
    const Modes m = modes();
    return std::array{Abbreviation{"c_1", latex(GiNaC::cos(m.omega1 * t()))},
                      Abbreviation{"s_1", latex(GiNaC::sin(m.omega1 * t()))},
                      Abbreviation{"c_2", latex(GiNaC::cos(m.omega2 * t()))},
                      Abbreviation{"s_2", latex(GiNaC::sin(m.omega2 * t()))}};
  }();
  return all;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    const bool after_name = at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0;
    const std::string replacement = (after_name ? " " : "") + to;
    text.replace(at, from.size(), replacement);
    at += replacement.size();
  }
}

// The lines with the abbreviations of wave_names(), and a line that says what those that occur mean.
Lines abbreviated(Lines lines) {
  Lines meanings;
  for (const Abbreviation& wave : wave_names()) {
    bool used = false;
    for (Line& line : lines) {
      used = used || line.right.find(wave.full) != std::string::npos;
      replace_all(line.right, wave.full, wave.name);
    }
    if (used) {
      meanings.push_back({wave.name, wave.full});
    }
  }
  Line last = meanings.front();
  for (std::size_t i = 1; i < meanings.size(); ++i) {
    last.right += fmt::format(",\\quad {} = {}", meanings[i].left, meanings[i].right);
  }
  lines.push_back(last);
  return lines;
}

// In the frequencies alone a block of H with its factor is wider than a page: the matrix goes on a line of
// its own.
Lines fitted(Lines lines, Unknowns unknowns) {
  for (Line& line : lines) {
    const std::size_t matrix_at = line.right.find("\\begin{pmatrix}");
    if (unknowns == Unknowns::omega && matrix_at != std::string::npos && matrix_at > 0) {
      line.right.insert(matrix_at, "\\times{} \\\\\n");
    }
  }
  return abbreviated(std::move(lines));
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
  const std::string left = "D(s^2)=\\det(K-s^2I)";
  if (unknowns == Unknowns::omega) {
    return {scalar(left, D, unknowns)};
  }
  const ex sum = -D.coeff(s, 2);
  const ex product = D.coeff(s, 0);
  const ex root = GiNaC::sqrt((sum * sum - 4 * product).expand());
  return {{left, fmt::format("s^{{4}}-({})s^{{2}}+{}", latex(sum), latex(product)), {D}},
          scalar("\\omega_1^2", (sum - root) / 2, unknowns),
          scalar("\\omega_2^2", (sum + root) / 2, unknowns)};
}

Lines lambdas(Unknowns unknowns) {
  const Modes m = model::modes_of(chi(), modes().omega1, modes().omega2);
  return {scalar("\\lambda_1", m.lambda1, unknowns), scalar("\\lambda_2", m.lambda2, unknowns)};
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
    const ex lambda = k < 2 ? m.lambda1 : m.lambda2;
    coefficients.push_back(scalar(latex_name(names[k]), coefficient));
    combination[0] += symbol(names[k]) * waves[k];
    combination[1] += lambda * symbol(names[k]) * waves[k];
    rest[0] = (rest[0] - coefficient * waves[k]).expand();
    rest[1] = (rest[1] - lambda * coefficient * waves[k]).normal().expand();
  }
  Lines lines;
  for (std::size_t i = 0; i < 2; ++i) {
    lines.push_back(scalar(fmt::format("z_{}(t)", i + 1), combination[i] + rest[i].normal()));
  }
  lines.insert(lines.end(), coefficients.begin(), coefficients.end());
  if (unknowns == Unknowns::omega) {
    lines.push_back(scalar("\\lambda_1", m.lambda1, unknowns));
    lines.push_back(scalar("\\lambda_2", m.lambda2, unknowns));
  }
  return lines;
}

Lines slip(Unknowns unknowns) {
  const Vector4 Z = model::slip_flow<ex>(modes(), Q_symbols(), omega(), phi(), initial_state(), t());
  return abbreviated(modal(Z, unknowns));
}

Lines overshoot(Unknowns unknowns) {
  const Vector4 Z =
      model::overshoot_flow<ex>(modes(), Q_symbols(), d0_symbols(), omega(), phi(), initial_state(), t());
  return abbreviated(modal(Z, unknowns));
}

// In the frequencies alone chi stays as an abbreviation.
Lines stick(Unknowns unknowns) {
  const Vector4 Z = model::stick_flow<ex>(chi(), initial_state(), t());
  Lines lines;
  for (int i = 0; i < 4; ++i) {
    lines.push_back(scalar(fmt::format("{}z_{}(t)", i < 2 ? "" : "\\dot ", i % 2 + 1), Z(i)));
  }
  if (unknowns == Unknowns::omega) {
    lines.push_back(scalar("\\chi", chi(), unknowns));
  }
  return lines;
}

Lines chi_lines(Unknowns) {
  return {{"\\chi", latex(model::chi_from_frequencies<ex>(modes().omega1, modes().omega2))}};
}

Lines eta_lines(Unknowns) {
  return {{"\\eta", latex(model::eta_from_frequencies<ex>(modes().omega1, modes().omega2))}};
}

std::vector<Object> flow_objects() {
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
       [](Unknowns u) { return fitted(assembled("H", H_blocks(), u), u); }},
      {"H1", "(38)", "first block of $H$",
       [](Unknowns u) { return fitted({matrix("H_1(t)", H_blocks().first, u)}, u); }},
      {"H2", "(38)", "second block of $H$",
       [](Unknowns u) { return fitted({matrix("H_2(t)", H_blocks().second, u)}, u); }},
      {"H3", "(38)", "third block of $H$",
       [](Unknowns u) { return fitted({matrix("H_3(t)", H_blocks().third, u)}, u); }},
      {"L", "(8)", "what the reversed friction adds in an overshooting slip, per $2 d0$",
       [](Unknowns u) { return fitted({matrix("L(t)", model::L(modes(), t()), u)}, u); }},
      {"Sigma", "(41)", "matrix of the eigenvectors during stick",
       [](Unknowns u) { return Lines{matrix("\\Sigma", model::Sigma(chi()), u)}; }},
      {"gamma", "(41)", "the motions during stick as functions of time",
       [](Unknowns u) { return three("\\gamma", model::gamma(t()), u); }},
      {"Gamma", "(10)", "flow of the stick, by blocks",
       [](Unknowns u) { return assembled("\\Gamma", Gamma_blocks(), u); }},
      {"Gamma1", "(41)", "first block of $Gamma$",
       [](Unknowns u) { return Lines{matrix("\\Gamma_1(t)", Gamma_blocks().first, u)}; }},
      {"Gamma2", "(41)", "second block of $Gamma$",
       [](Unknowns u) { return Lines{matrix("\\Gamma_2(t)", Gamma_blocks().second, u)}; }},
      {"Gamma3", "(41)", "third block of $Gamma$",
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

std::string displayed(const Lines& lines) {
  constexpr std::ptrdiff_t page = 18;  // lines of one display, which does not break
  if (lines.size() == 1 && lines.front().right.find("\\\\\n{}") == std::string::npos) {
    return fmt::format("\\[\n{} = {}\n\\]\n", lines.front().left, lines.front().right);
  }
  std::string result;
  std::string display;
  const auto end_display = [&] {
    result += display.empty() ? "" : "\\begin{gather*}\n" + display + "\n\\end{gather*}\n";
    display.clear();
  };
  for (const Line& line : lines) {
    const std::string next = line.left + " = " + line.right;
    if (std::ranges::count(display + next, '\n') >= page) {
      end_display();
    }
    display += (display.empty() ? "" : " \\\\\n") + next;
  }
  end_display();
  return result;
}

std::string displayed(const Object& object, Unknowns unknowns) {
  return displayed(object.lines(unknowns));
}

std::string bare(const Object& object, Unknowns unknowns) {
  std::vector<std::string> lines;
  for (const Line& line : object.lines(unknowns)) {
    lines.push_back(line.left + " = " + line.right);
  }
  return fmt::format("{}", fmt::join(lines, " \\\\\n"));
}

const std::vector<Object>& objects() {
  static const std::vector<Object> all = [] {
    std::vector<Object> both = flow_objects();
    const std::vector<Object> orbits = orbit_objects();
    both.insert(both.end(), orbits.begin(), orbits.end());
    return both;
  }();
  return all;
}

const Object * find_object(const std::string& name) {
  const auto object = std::ranges::find(objects(), name, &Object::name);
  return object == objects().end() ? nullptr : &*object;
}

std::string meanings(Unknowns unknowns) {
  Lines lines;
  append_meanings(lines, unknowns);
  return displayed(lines);
}

std::string list_of_objects() {
  std::string result;
  for (const Object& object : objects()) {
    result += fmt::format("{:<11}  {:<4}  {}\n", object.name, object.number, stickslip::plain(object.title));
  }
  return result;
}

}  // namespace stickslip::symbolic::objects
