#include "proofs/orbits/phases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/transformed.hpp"
#include "numeric/families/family.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using tactics::Symbolic;
using Wave = model::Wave<Symbolic>;

namespace {

Rational q(const Rational& numerator, const Rational& denominator) {
  return numerator / denominator;
}

// (7) at exact data: the amplitudes of the forced motion.
std::array<Rational, 2> forced(const model::Parameters<Rational>& a) {
  const Rational w = a.omega * a.omega;
  const Rational d = w * w - (1 + a.chi * a.eta) * w + a.chi * a.eta * (1 - a.chi);
  if (d == 0) {
    throw KernelError("omega is a natural frequency: there is no Q of (7)");
  }
  const Rational q1 = q(a.chi * a.p, d);
  return {q1, q(q1 * (1 - w), a.chi)};
}

bool sticks(PhaseKind kind) {
  return kind == PhaseKind::stick;
}

}  // namespace

Rational near(const Ball& ball) {
  constexpr int bits = 60;
  fmpz_t scaled;
  fmpz_init(scaled);
  arf_get_fmpz_fixed_si(scaled, arb_midref(ball.raw()), -bits);
  mpz_class integer;
  fmpz_get_mpz(integer.get_mpz_t(), scaled);
  fmpz_clear(scaled);
  Rational value(integer, mpz_class(1) << bits);
  value.canonicalize();
  return value;
}

Question question_of(const numeric::OrbitQuestion& question, const numeric::motion::Motion& nearly) {
  const numeric::Family& family = *question.family;
  Question result{
      model::mapped<Rational>(question.parameters, [](const Range& range) { return range.middle; }),
      family.phases, family.durations};
  result.phi = question.phi ? std::optional(question.phi->middle) : std::nullopt;
  result.ur = question.ur ? std::optional(question.ur->middle) : std::nullopt;
  if (!family.why_no_phi.empty() && !family.why_no_ur.empty()) {
    const numeric::motion::Phase& first = nearly.phases.front();
    const double turns =
        first.load.approximate() / std::numbers::pi +
        (result.data.omega.get_d() * first.duration.approximate() / std::numbers::pi - 1) / 2;
    result.lag = static_cast<int>(std::lround(turns));
  }
  return result;
}

Term start_of(const Question& question, std::size_t k) {
  Symbolic sum;
  for (std::size_t i = 0; i < k; ++i) {
    sum += Symbolic(Variable{question.durations.at(i)});
  }
  return sum.term;
}

Term value(const Wave& wave, const Term& t) {
  Symbolic sum = wave.constant + wave.slope * Symbolic(t);
  for (int k = 0; k < wave.count; ++k) {
    const auto& h = wave.harmonics.at(static_cast<std::size_t>(k));
    const Symbolic angle = h.nu * Symbolic(t);
    sum = sum + h.a * cos(angle) + h.b * sin(angle);
  }
  return sum.term;
}

Phases::Phases(Question question) : question_(std::move(question)), Q_(forced(question_.data)) {
  for (const char * name : {"omega1", "omega2"}) {
    unknown(name);
  }
  period_ = Term(2 * question_.period) * pi() / omega_;
  // Durations first: loads and waves depend on them.
  Term rest = *period_;
  for (std::size_t k = 0; k + 1 < count(); ++k) {
    durations_.push_back(unknown(question_.durations[k]));
    rest = rest - durations_.back();
  }
  durations_.push_back(rest);
  phi_ = question_.lag ? time_lag(*question_.lag) : question_.phi ? Term(*question_.phi) : unknown("phi");
  for (std::size_t k = 0; k < count(); ++k) {
    add_phase(k);
  }
  add_equations();
}

Term Phases::time_lag(int turns) const {
  const Term lag = Rational(1, 2) * (pi() - Term(omega_) * durations_.front());
  return turns == 0 ? lag : lag + Term(turns) * pi();
}

Term Phases::unknown(const std::string& name) {
  unknowns_.push_back({name, real_number});
  return unknowns_.back();
}

void Phases::add_phase(std::size_t k) {
  const model::Parameters<Rational>& a = question_.data;
  const Symbolic load = (Symbolic(omega_) * Symbolic(start(k)) + Symbolic(*phi_)).term;
  const Symbolic c = cos(load), s = sin(load);
  const auto letter = [&](const char * name) { return Symbolic(unknown(fmt::format("{}_{}", name, k + 1))); };
  const auto number = [](const Rational& value) { return Symbolic(Term(value)); };
  const auto add_load = [&](Wave& wave, const Rational& size) {
    if (size != 0) {
      wave.add(omega_, number(size) * c, number(-size) * s);
    }
  };
  Waves w;
  const Rational load_at_rest = -q(a.p, a.eta);
  if (sticks(question_.phases[k])) {
    w.x2.constant = letter("c");
    w.x2.slope = number(a.V);
    w.x1 = model::affine<Symbolic>(number(a.chi), w.x2, 0);
    const Symbolic A = letter("A"), B = letter("B");
    w.x1.add(1, A, B);
    const Rational stiffness = a.chi * (1 - a.chi);
    w.r = model::affine<Symbolic>(number(stiffness), w.x2, 0);
    w.r.add(1, number(-a.chi) * A, number(-a.chi) * B);
    add_load(w.r, load_at_rest);
  } else {
    const int sign = question_.phases[k] == PhaseKind::slip ? 1 : -1;
    const Rational d01 = q(sign * a.us, 1 - a.chi);
    w.x1.constant = number(d01);
    w.x2.constant = number(q(d01, a.chi));
    w.r.constant = number(sign * a.us);
    for (std::size_t j = 0; j < 2; ++j) {
      const Symbolic omega(unknowns_[j]);
      const Symbolic lambda = number(q(1, a.chi)) * (Symbolic(1) - Symbolic(power(unknowns_[j], 2)));
      const Symbolic A = letter(j == 0 ? "A1" : "A2"), B = letter(j == 0 ? "B1" : "B2");
      w.x1.add(omega, A, B);
      w.x2.add(omega, lambda * A, lambda * B);
      const Symbolic share = number(a.chi) * (lambda - Symbolic(1));
      w.r.add(omega, share * A, share * B);
    }
    add_load(w.x1, Q_[0]);
    add_load(w.x2, Q_[1]);
    add_load(w.r, a.chi * (Q_[1] - Q_[0]) + load_at_rest);
  }
  waves_.push_back(w);
}

Term Phases::state(std::size_t k, const Term& s) const {
  const Waves& w = waves_.at(k);
  return matrix(
      4, 1,
      {value(w.x1, s), value(w.x2, s), value(model::derivative(w.x1), s), value(model::derivative(w.x2), s)});
}

Term Phases::mode(std::size_t k, std::size_t j, const Term& s) const {
  Wave one;
  const auto& h = waves_.at(k).x1.harmonics.at(j);
  one.add(h.nu, h.a, h.b);
  return value(one, s);
}

Term Phases::load(std::size_t k, const Term& s) const {
  return cos(Term(omega_) * (start(k) + s) + *phi_);
}

Term Phases::characteristic(std::size_t j) const {
  const model::Parameters<Rational>& a = question_.data;
  const Term w = power(unknowns_.at(j), 2);
  return power(unknowns_.at(j), 4) - Term(Rational(1 + a.chi * a.eta)) * w +
         Term(Rational(a.chi * a.eta * (1 - a.chi)));
}

void Phases::add_equations() {
  const bool stick = std::ranges::find(question_.phases, PhaseKind::stick) != question_.phases.end();
  if (stick && question_.ur && (question_.phi || question_.lag)) {
    throw KernelError("where a stick ends at r = ur only one of phi and ur is a datum");
  }
  equations_ = {characteristic(0), characteristic(1)};
  const Term V(question_.data.V);
  for (std::size_t k = 0; k < count(); ++k) {
    const std::size_t next = (k + 1) % count();
    const Term end = state(k, durations_[k]), begin = state(next, 0);
    fitting_.push_back(equations_.size());
    for (std::size_t i = 0; i < 4; ++i) {
      equations_.push_back(end.parts()[i] - begin.parts()[i]);
    }
    crossing_.emplace_back();
    if (!sticks(question_.phases[k]) && !sticks(question_.phases[next])) {
      crossing_.back() = equations_.size();
      equations_.push_back(end.parts()[3] - V);
    }
    if (sticks(question_.phases[k]) && question_.ur) {
      const Term r = value(waves_[k].r, durations_[k]);
      equations_.push_back(question_.phases[next] == PhaseKind::slip ? r - Term(*question_.ur)
                                                                     : r + Term(*question_.ur));
    }
  }
  if (equations_.size() != unknowns_.size()) {
    throw KernelError(fmt::format("{} equations for {} unknowns: what is given does not fit these phases",
                                  equations_.size(), unknowns_.size()));
  }
}

std::vector<Rational> Phases::near(const numeric::motion::Motion& motion) const {
  const model::Oscillator<Ball>& o = motion.oscillator;
  std::vector<Ball> values{o.modes.omega1, o.modes.omega2};
  for (std::size_t k = 0; k + 1 < count(); ++k) {
    values.push_back(motion.phases.at(k).duration);
  }
  if (!question_.lag && !question_.phi) {
    values.push_back(motion.phases.front().load);
  }
  for (std::size_t k = 0; k < count(); ++k) {
    const model::PhaseWaves<Ball> w = numeric::motion::waves(motion, k);
    if (sticks(question_.phases[k])) {
      values.push_back(w.z2.constant + o.d0(1));
      values.insert(values.end(), {w.z1.harmonics[0].a, w.z1.harmonics[0].b});
    } else {
      for (std::size_t j = 0; j < 2; ++j) {
        values.insert(values.end(), {w.z1.harmonics.at(j).a, w.z1.harmonics.at(j).b});
      }
    }
  }
  return transformed(values, [](const Ball& ball) { return orbits::near(ball); });
}

}  // namespace stickslip::proofs::orbits
