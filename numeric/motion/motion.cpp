#include "numeric/motion/motion.hpp"

#include "core/error.hpp"
#include "core/names.hpp"

namespace stickslip::numeric::motion {

using model::Vector4;

std::string to_string(PhaseKind kind) {
  return name_of<PhaseKind::stick>(kind, "slip", "overshoot", "stick");
}

namespace {

const Phase& phase(const Motion& motion, std::size_t k) {
  if (k >= motion.phases.size()) {
    throw InternalError("phase " + std::to_string(k) + " of a motion with " +
                        std::to_string(motion.phases.size()));
  }
  return motion.phases[k];
}

}  // namespace

template Vector4<Ball> flow<Ball>(const model::Oscillator<Ball>&, PhaseKind, const Ball&,
                                  const Vector4<Ball>&, const Ball&);
template Vector4<double> flow<double>(const model::Oscillator<double>&, PhaseKind, const double&,
                                      const Vector4<double>&, const double&);

Motion compose(const model::Oscillator<Ball>& oscillator, const Ball& phi, const Vector4<Ball>& Z0,
               const std::vector<Leg>& legs) {
  return compose_motion<Ball>(oscillator, phi, Z0, legs);
}

Vector4<Ball> state(const Motion& motion, std::size_t k, const Ball& t) {
  const Phase& f = phase(motion, k);
  return flow<Ball>(motion.oscillator, f.kind, f.load, f.Z, t);
}

Ball friction(const Motion& motion, std::size_t k, const Ball& t) {
  const Ball psi = phase(motion, k).load + motion.oscillator.data.omega * t;
  return model::friction_at<Ball>(motion.oscillator.data, state(motion, k, t), psi);
}

model::PhaseWaves<Ball> waves(const Motion& motion, std::size_t k) {
  return waves_of<Ball>(motion.oscillator, phase(motion, k));
}

Ball period(const Motion& motion) {
  Ball sum(0);
  for (const Phase& f : motion.phases) {
    sum += f.duration;
  }
  return sum;
}

MotionOf<double> in_double(const Motion& motion) {
  const auto middle = [](const Ball& x) { return x.approximate(); };
  MotionOf<double> result{model::oscillator<double>(model::mapped<double>(motion.oscillator.data, middle)),
                          {}};
  for (const Phase& phase : motion.phases) {
    result.phases.push_back({phase.kind, phase.start.approximate(), phase.duration.approximate(),
                             phase.load.approximate(), phase.Z.unaryExpr(middle)});
  }
  return result;
}

std::vector<model::PhaseWaves<Ball>> all_waves(const Motion& motion) {
  std::vector<model::PhaseWaves<Ball>> result;
  result.reserve(motion.phases.size());
  for (std::size_t k = 0; k < motion.phases.size(); ++k) {
    result.push_back(waves(motion, k));
  }
  return result;
}

std::vector<Vector4<Ball>> gaps(const Motion& motion, const std::vector<model::PhaseWaves<Ball>>& all_waves) {
  std::vector<Vector4<Ball>> result;
  result.reserve(motion.phases.size());
  for (std::size_t k = 0; k < motion.phases.size(); ++k) {
    const Ball& T = motion.phases[k].duration;
    const auto [z1, zdot1] = model::value_and_slope(all_waves[k].z1, T);
    const auto [z2, zdot2] = model::value_and_slope(all_waves[k].z2, T);
    const Vector4<Ball>& next = motion.phases[(k + 1) % motion.phases.size()].Z;
    result.emplace_back(Vector4<Ball>(z1, z2, zdot1, zdot2) - next);
  }
  return result;
}

std::vector<Vector4<Ball>> gaps(const Motion& motion) {
  return gaps(motion, all_waves(motion));
}

}  // namespace stickslip::numeric::motion
