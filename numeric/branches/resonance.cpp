#include "numeric/branches/resonance.hpp"

#include <cmath>

#include "numeric/atlas/symmetric_orbit.hpp"

namespace stickslip::numeric::branches {

using namespace motion;
using namespace zeros;

namespace {

// A time is the first variable, the branch's parameter the second.
using Form = scalars::Form<Ball, 2>;
using Orbit = atlas::SymmetricOrbit<Form>;

// How short pieces of a phase are looked at, as shares of it.
constexpr double least_piece = 0x1p-12;

std::optional<Orbit> orbit_of(const ParametricProof& proof, const MotionOf<ParameterJet>& jets,
                              const Motion& middle) {
  const Ball radius = abs(proof.spread(0)).upper();
  const auto form = [&](const ParameterJet& g, const Ball& at_middle) {
    Form x;
    x.at = at_middle;
    x.over = proof.over_box(g, at_middle);
    x.slopes[1] = g.partial(0) * radius;
    return x;
  };
  const model::Parameters<ParameterJet>& a = jets.oscillator.data;
  const model::Parameters<Ball>& b = middle.oscillator.data;
  const model::Parameters<Form> data{form(a.chi, b.chi), form(a.eta, b.eta),     form(a.us, b.us),
                                     form(a.V, b.V),     form(a.omega, b.omega), form(a.p, b.p)};
  const Form pi(Ball::pi());
  const Form tau = form(jets.phases[0].duration, middle.phases[0].duration);
  const Ball at_half = middle.phases[0].load + b.omega * middle.phases[0].duration / Ball(2);
  const int sign = sin(at_half).is_positive() ? 1 : -1;
  return Orbit::at({atlas::Sheet::Kind::symmetric, sign}, atlas::setting_of<Form>(data, pi),
                   Form(tau * data.omega / Form(Form(2) * pi)), {});
}

}  // namespace

bool is_near_resonance(const Motion& motion) {
  const model::Modes<Ball>& m = motion.oscillator.modes;
  const double omega = motion.oscillator.data.omega.approximate();
  return std::abs(m.omega1.approximate() / omega - 1) < 0.01 ||
         std::abs(m.omega2.approximate() / omega - 1) < 0.01;
}

void decide_without_response(const ParametricProof& proof, const MotionOf<ParameterJet>& jets,
                             const Motion& middle, const Requirements& requirements,
                             std::vector<Condition>& conditions) {
  const std::optional<Orbit> orbit = orbit_of(proof, jets, middle);
  if (!orbit || conditions.size() != requirements.size()) {
    return;
  }
  std::vector<Condition> decided = conditions;
  bool all = true;
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    if (conditions[k].verdict.truth != Truth::undecided) {
      continue;
    }
    atlas::Times open{{0, 1}};
    const Truth truth = orbit->holds(requirements[k], least_piece, open).truth;
    if (truth == Truth::refuted) {
      conditions[k].verdict = Verdict::refuted("some time has a negative distance");
      return;
    }
    all = all && truth == Truth::proved;
    decided[k].verdict = Verdict::proved();  // perhaps because it follows from the others
  }
  if (all) {
    conditions = decided;
  }
}

}  // namespace stickslip::numeric::branches
