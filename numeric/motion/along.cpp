#include "numeric/motion/along.hpp"

#include <fmt/format.h>

#include <array>

#include "core/error.hpp"
#include "numeric/motion/requirements.hpp"

namespace stickslip::numeric::motion {
namespace {

using model::Wave;

constexpr int shown_digits = 10;

// Collects what deviates.
class Deviation {
 public:
  // A component's deviation over 0 <= t <= T, and with it that of its speed.
  void add(const std::string& name, const Wave<Ball>& w, const Ball& T) {
    Ball size = abs(w.constant) + abs(w.slope) * T;
    Ball speed = abs(w.slope);
    expect_zero(name + ": the constant part", w.constant);
    expect_zero(name + ": the slope", w.slope);
    for (int k = 0; k < w.count; ++k) {
      const model::Harmonic<Ball>& h = w.harmonics[static_cast<unsigned>(k)];
      const std::string part = fmt::format("{}: the part of frequency {}", name, to_string(h.nu, 5));
      expect_zero(part + " (cosine)", h.a);
      expect_zero(part + " (sine)", h.b);
      size += abs(h.a) + abs(h.b);
      speed += abs(h.nu) * (abs(h.a) + abs(h.b));
    }
    grow(size);
    grow(speed);
  }
  void expect_zero(const std::string& what, const Ball& value) {
    if (value.is_nonzero() && reason_.empty()) {
      reason_ = fmt::format("{} is {} instead of 0", what, to_string(value, shown_digits));
    }
  }

  [[nodiscard]] SymmetryAlong result() const {
    return {bound_, reason_.empty() ? Verdict::undecided("it holds to within " + to_string(bound_, 3) +
                                                         " at all times; balls prove no equality")
                                    : Verdict::refuted(reason_)};
  }

 private:
  void grow(const Ball& size) {
    arb_max(bound_.raw(), bound_.raw(), size.upper().raw(), WorkingPrecision::bits());
    bound_ = bound_.upper();
  }

  Ball bound_;
  std::string reason_;
};

// v + w for waves with the same frequencies in the same order.
Wave<Ball> sum(const Wave<Ball>& v, const Wave<Ball>& w) {
  Wave<Ball> result;
  result.constant = v.constant + w.constant;
  result.slope = v.slope + w.slope;
  for (int k = 0; k < v.count; ++k) {
    const model::Harmonic<Ball>& x = v.harmonics[static_cast<unsigned>(k)];
    const model::Harmonic<Ball>& y = w.harmonics[static_cast<unsigned>(k)];
    result.add(x.nu, x.a + y.a, x.b + y.b);
  }
  return result;
}

void require_phases(const Motion& motion, Family family) {
  const std::vector<PhaseKind> kinds = phase_kinds(family);
  bool same = kinds.size() == motion.phases.size();
  for (std::size_t k = 0; same && k < kinds.size(); ++k) {
    same = kinds[k] == motion.phases[k].kind;
  }
  if (!same) {
    throw InternalError("a symmetry is asked of a motion of another family");
  }
}

}  // namespace

SymmetryAlong symmetry_17(const Motion& motion) {
  require_phases(motion, Family::symmetric);
  Deviation deviation;
  for (std::size_t k = 0; k < 2; ++k) {
    const Ball& T = motion.phases[k].duration;
    const model::PhaseWaves<Ball> w = waves(motion, k);
    const std::string phase = k == 0 ? "slip, " : "stick, ";
    deviation.add(phase + "z1(t) + z1(tau - t)", sum(w.z1, reversed(w.z1, T)), T);
    deviation.add(phase + "z2(t) + z2(tau - t)", sum(w.z2, reversed(w.z2, T)), T);
  }
  return deviation.result();
}

SymmetryAlong symmetry_54(const Motion& motion) {
  require_phases(motion, Family::nonsticking);
  Deviation deviation;
  const Ball& T = motion.phases[0].duration;
  deviation.expect_zero("tau - tau1", T - motion.phases[1].duration);
  const model::PhaseWaves<Ball> slip = waves(motion, 0);
  const model::PhaseWaves<Ball> over = waves(motion, 1);
  const model::Vector2<Ball> twice_d0 = motion.oscillator.d0 * Ball(2);
  deviation.add("x1(t) + x1(t + tau)", model::affine<Ball>(Ball(1), sum(slip.z1, over.z1), twice_d0(0)), T);
  deviation.add("x2(t) + x2(t + tau)", model::affine<Ball>(Ball(1), sum(slip.z2, over.z2), twice_d0(1)), T);
  return deviation.result();
}

}  // namespace stickslip::numeric::motion
