// The derivative of the return map of a periodic motion, over any scalar.
#pragma once

#include "core/error.hpp"
#include "model/saltation.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::motion {

// The derivative of the flow of one phase: H of (5), (8), Gamma of (10).
template <class S>
[[nodiscard]] model::Matrix4<S> tangent_flow(const model::Oscillator<S>& o, const PhaseOf<S>& phase) {
  return phase.kind == PhaseKind::stick ? model::Gamma<S>(o.data.chi, phase.duration)
                                        : model::H<S>(o.modes, phase.duration);
}

// The friction force on a phase at the friction at rest r (4): us, -us, or r.
template <class S>
[[nodiscard]] S friction_on(PhaseKind kind, const S& us, const S& r) {
  return kind == PhaseKind::slip ? us : (kind == PhaseKind::overshoot ? S(-us) : r);
}

// The saltation matrix where `next` begins after a phase of the kind `before`. Its entries are not finite
// where the event is not transversal. Throws InternalError when both are of one kind.
template <class S>
[[nodiscard]] model::Matrix4<S> saltation_between(const model::Oscillator<S>& o, PhaseKind before,
                                                  const PhaseOf<S>& next) {
  if (before == next.kind) {
    throw InternalError("two phases of one kind after each other");
  }
  if (next.kind == PhaseKind::stick) {
    return model::landing<S>();
  }
  const model::Parameters<S>& a = o.data;
  const S r = model::friction_at<S>(a, next.Z, next.load);
  const auto acceleration = [&](PhaseKind kind) {
    return model::belt_acceleration<S>(a.eta, friction_on<S>(kind, a.us, r), r);
  };
  if (before == PhaseKind::stick) {
    return model::break_away<S>(a.chi, acceleration(next.kind),
                                model::friction_rate<S>(a, next.Z, next.load));
  }
  return model::crossing<S>(acceleration(before), acceleration(next.kind));
}

// The derivative of the map from the state where phase `first` begins to the state one period later, the
// load's phase being what it was: the product of the flows' and the events' derivatives. Assumes that the
// motion closes and obeys the friction law with every event transversal; at least one phase.
template <class S>
[[nodiscard]] model::Matrix4<S> monodromy(const MotionOf<S>& motion, std::size_t first = 0) {
  const std::size_t count = motion.phases.size();
  model::Matrix4<S> M = tangent_flow<S>(motion.oscillator, motion.phases.at(first));
  for (std::size_t k = 1; k <= count; ++k) {
    const PhaseOf<S>& before = motion.phases[(first + k - 1) % count];
    const PhaseOf<S>& next = motion.phases[(first + k) % count];
    M = saltation_between<S>(motion.oscillator, before.kind, next) * M;
    if (k < count) {
      M = tangent_flow<S>(motion.oscillator, next) * M;
    }
  }
  return M;
}

}  // namespace stickslip::numeric::motion
