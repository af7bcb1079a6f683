// Closing conditions as a system f(x, p) = 0 whose zeros are the closed motions of a kind, whatever its
// unknowns; and their existence, at exact data and over whole boxes of parameters.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/motion/domain.hpp"
#include "numeric/motion/motion.hpp"
#include "numeric/zeros/parametric.hpp"

namespace stickslip::numeric::motion {

// What is known of a problem: the data and, as far as they are given, the load's phase and the friction.
template <class S>
struct Given {
  model::Parameters<S> data;
  std::optional<S> phi = {};
  std::optional<S> ur = {};
};

// f of each that is given.
template <class T, class S, class F>
[[nodiscard]] Given<T> mapped(const Given<S>& given, const F& f) {
  const auto of = [&](const std::optional<S>& x) { return x ? std::optional<T>(f(*x)) : std::nullopt; };
  return {model::mapped<T>(given.data, f), of(given.phi), of(given.ur)};
}
// At the working precision.
[[nodiscard]] inline Given<Ball> rounded(const Given<Rational>& given) {
  return mapped<Ball>(given, [](const Rational& x) { return Ball(x); });
}

template <class T>
[[nodiscard]] model::Oscillator<T> oscillator_of(const zeros::VectorOf<T>& p) {
  return model::oscillator<T>({p(0), p(1), p(2), p(3), p(4), p(5)});
}

// The system over balls and over jets, for zeros/parametric.hpp. Made of any copyable F with, for both T,
//   VectorOf<T> closing<T>(x, p)  as many equations as unknowns, all zero exactly if the motion closes
//   MotionOf<T> motion<T>(x, p)   the motion that (x, p) stand for, whether it closes or not
//   Vector unknowns(motion)       x of a motion, nearly
//   bool takes_phi, takes_ur
// p: chi, eta, us, V, omega, p, and phi and ur where the system takes them.
class Closing {
 public:
  template <class F>
  requires(!std::is_same_v<F, Closing>) Closing(F f)  // NOLINT: any such F is one
      : takes_phi_(f.takes_phi),
        takes_ur_(f.takes_ur),
        unknowns_([f](const Motion& m) { return f.unknowns(m); }),
        balls_(over<Ball>(f)),
        jets_(over<zeros::ParameterJet>(f)) {}

  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    return at<T>().closing(x, p);
  }
  template <class T>
  [[nodiscard]] MotionOf<T> motion(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    return at<T>().motion(x, p);
  }
  [[nodiscard]] zeros::Vector unknowns(const Motion& motion) const { return unknowns_(motion); }

  // p, and the names of its members on the command line. Throws InternalError when a datum that is taken is
  // not given.
  template <class T = Ball>
  [[nodiscard]] zeros::VectorOf<T> parameters(const Given<T>& given) const;
  [[nodiscard]] std::vector<std::string> parameter_names() const;

 private:
  template <class T>
  struct Over {
    std::function<zeros::VectorOf<T>(const zeros::VectorOf<T>&, const zeros::VectorOf<T>&)> closing;
    std::function<MotionOf<T>(const zeros::VectorOf<T>&, const zeros::VectorOf<T>&)> motion;
  };
  template <class T, class F>
  [[nodiscard]] static Over<T> over(const F& f) {
    return {[f](const auto& x, const auto& p) { return f.template closing<T>(x, p); },
            [f](const auto& x, const auto& p) { return f.template motion<T>(x, p); }};
  }
  template <class T>
  [[nodiscard]] const Over<T>& at() const {
    if constexpr (std::is_same_v<T, Ball>) {
      return balls_;
    } else {
      return jets_;
    }
  }

  bool takes_phi_, takes_ur_;
  std::function<zeros::Vector(const Motion&)> unknowns_;
  Over<Ball> balls_;
  Over<zeros::ParameterJet> jets_;
};

// r of (4) when phase k begins, -r for an overshoot: ur where a stick ends, at least ur where a slip and an
// overshoot meet.
template <class S>
[[nodiscard]] S friction_ahead(const MotionOf<S>& motion, std::size_t k) {
  const PhaseOf<S>& phase = motion.phases[k];
  const S r = model::friction_at<S>(motion.oscillator.data, phase.Z, phase.load);
  return phase.kind == PhaseKind::overshoot ? S(-r) : r;
}

// Whether a motion closes near a guess, and that motion.
struct ClosedMotion {
  Verdict existence;  // "exactly one near the guess", for each member of the parameters
  // Contain the values for all members; meaningless unless proved.
  Motion motion;
  std::vector<model::PhaseWaves<Ball>> waves;  // of each phase
  std::vector<Ball> friction;                  // friction_ahead
};

// A motion with what is known of it from its phases; that it closes is the caller's word.
[[nodiscard]] ClosedMotion taken_as_closed(const Motion& motion);

// The motions that the proof speaks of, over the whole box: f's motion over the jets of the proof and at the
// middle, to first order (zeros/parametric.hpp). Assumes that the proof is one.
[[nodiscard]] ClosedMotion closed_over(const zeros::ParametricProof& proof,
                                       const MotionOf<zeros::ParameterJet>& jets, const Motion& middle);

// At exact data, to `digits` significant digits or more, at the working precision of these. Undecided when no
// box that Newton's method reaches from the guess passes Krawczyk's test.
[[nodiscard]] ClosedMotion prove_closed(const Closing& f, const Given<Rational>& given, const Motion& guess,
                                        int digits);

}  // namespace stickslip::numeric::motion
