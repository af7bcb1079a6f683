#include "numeric/machines/basins/planar_slip.hpp"

#include <cmath>

namespace stickslip::numeric::machines {

SlipGuess::SlipGuess(const Machine& machine)
    : o_(oscillator_as<double>(machine)),
      law_(*o_.forward.smooth),
      m_(o_.masses[0]),
      c_(o_.damping(0, 0)),
      k_(o_.stiffness(0, 0)),
      V_(o_.V),
      steady_(law_.force(V_) / k_) {
  const double fastest = (c_ + std::abs(law_.viscous) + (law_.first - law_.last) / law_.scale) / m_;
  h_ = 1 / (steps_in_radian * std::sqrt(k_ / m_) + fastest);
}

std::optional<std::array<double, 2>> SlipGuess::cycle() const {
  constexpr int halvings = 60, most_doublings = 100;
  double inside = 0x1p-30 * V_ * std::sqrt(m_ / k_), outside = inside;
  for (int i = 0; !leads_out(outside); ++i, outside *= 2) {
    if (i == most_doublings) {
      return std::nullopt;
    }
    inside = outside;
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle = (inside + outside) / 2;
    (leads_out(middle) ? outside : inside) = middle;
  }
  const auto end = turn(inside);
  return end ? std::optional(std::array<double, 2>{steady_ - inside, end->time}) : std::nullopt;
}

double SlipGuess::damped_up_to() const {
  constexpr int most_halvings = 200;
  double y = V_;
  for (int i = 0; i < most_halvings && c_ * y - law_.force(V_ - y) + law_.force(V_) <= 0; ++i) {
    y /= 2;
  }
  return y;
}

std::optional<double> SlipGuess::telling_time() const {
  const double above = law_.scale / 16, calm = m_ * damped_up_to() * damped_up_to() / 2;
  State s{(law_.first - c_ * V_) / k_, V_};
  double time = 0;
  bool rises = false;
  for (long i = 0; i < most_steps; ++i) {
    const State next = step(s, h_);
    time += h_;
    const double rate = acceleration(next), x = next.x - steady_;
    if (next.y > V_ + above || k_ * x * x + m_ * next.y * next.y < calm) {
      return time;
    }
    if (rises && rate <= 0) {
      const double before = acceleration(s);
      return time - h_ * rate / (rate - before);
    }
    rises = rate > 0;
    s = next;
  }
  return std::nullopt;
}

std::optional<double> SlipGuess::back_at_belt(double x) const {
  State s{x, V_};
  bool below = false;
  for (long i = 0; i < most_steps; ++i) {
    const State next = step(s, h_);
    if (below && next.y > V_) {
      return (static_cast<double>(i) + (V_ - s.y) / (next.y - s.y)) * h_;
    }
    below = below || next.y < V_;
    s = next;
  }
  return std::nullopt;
}

double SlipGuess::acceleration(const State& s) const {
  return (law_.force(V_ - s.y) - c_ * s.y - k_ * s.x) / m_;
}

SlipGuess::State SlipGuess::step(const State& s, double h) const {
  const auto rate = [&](const State& at) { return State{at.y, acceleration(at)}; };
  const auto go = [&](const State& d, double t) { return State{s.x + d.x * t, s.y + d.y * t}; };
  const State a = rate(s), b = rate(go(a, h / 2)), c = rate(go(b, h / 2)), d = rate(go(c, h));
  return {s.x + h / 6 * (a.x + 2 * b.x + 2 * c.x + d.x), s.y + h / 6 * (a.y + 2 * b.y + 2 * c.y + d.y)};
}

std::optional<SlipGuess::End> SlipGuess::turn(double behind) const {
  State s{steady_ - behind, 0};
  double time = 0;
  for (long i = 0; i < most_steps; ++i) {
    const State next = step(s, h_);
    if (next.y > V_) {
      return std::nullopt;
    }
    if (i > 0 && s.y < 0 && next.y >= 0) {
      double part = h_ * s.y / (s.y - next.y);
      for (int k = 0; k < 4; ++k) {
        const State there = step(s, part);
        part -= there.y / acceleration(there);
      }
      return End{steady_ - step(s, part).x, time + part};
    }
    s = next;
    time += h_;
  }
  return End{0, time};
}

bool SlipGuess::leads_out(double behind) const {
  const std::optional<End> end = turn(behind);
  return !end || end->behind > behind;
}

Ball value(const SmoothPhase::Step& step, Eigen::Index row, int derivative, const Ball& s) {
  Ball sum(0);
  for (auto k = static_cast<long>(step.w.size()); k-- > derivative;) {
    Ball term = step.w[static_cast<std::size_t>(k)](row);
    for (long i = 0; i < derivative; ++i) {
      term *= Ball(k - i);
    }
    sum = sum * s + term;
  }
  return sum;
}

PlanarSlip::PlanarSlip(const Machine& machine)
    : machine_(machine), phases_(oscillator_as<Ball>(machine)), law_(*phases_.oscillator().forward.smooth) {
  (void)phases_.drift(Piece::sliding(1));  // kept with the bits of now
}

Verdict PlanarSlip::steady_sliding_is_stable() const {
  const Ball damping = o().damping(0, 0) + law_.slope(o().V);
  return damping.is_positive()   ? Verdict::proved()
         : damping.is_negative() ? Verdict::refuted("steady sliding is unstable")
                                 : Verdict::undecided("steady sliding may be about to lose its stability");
}

Verdict PlanarSlip::cycle_exists() const {
  constexpr double more = 1 + 0x1p-10;
  if (Ball(o().damping(0, 0) + law_.slope(Ball(0))).is_positive()) {
    return Verdict::refuted(
        "no closed motion is below the belt: damping exceeds the fall of friction at all "
        "velocities");
  }
  const SlipGuess guess(machine_);
  const std::optional<double> time = guess.telling_time();
  if (!time) {
    return Verdict::undecided("the slip that begins at the belt was not seen to turn");
  }
  if (Ball(o().V - from_belt(Ball(*time)).end()(velocity)).is_negative()) {
    return Verdict::proved();
  }
  if (stays_away(Ball(*time * more), Ball(guess.damped_up_to()))) {
    return Verdict::refuted(
        "no closed motion is below the belt: the slip that begins there, at the "
        "acceleration 0, comes back closer to steady sliding");
  }
  return Verdict::undecided("the closed motion may touch the belt");
}

bool PlanarSlip::is_turn_below_belt(const SmoothPhase& phase, const Ball& T) const {
  static constexpr std::array<std::pair<int, int>, 5> parts{{{1, 1}, {0, 1}, {1, -1}, {0, -1}, {1, 1}}};
  std::size_t part = 0;
  return takes_all(phase, T, [&](const Stretch& s) {
    if (!Ball(o().V - s.over(velocity)).is_positive()) {
      return false;
    }
    for (std::size_t i = part; i < std::min(part + 2, parts.size()); ++i) {
      if (Ball(Ball(parts[i].second) * s.over(velocity, parts[i].first)).is_positive()) {
        part = i;
        return true;
      }
    }
    return false;
  });
}

SmoothPhase PlanarSlip::follow(const Ball& x, const Ball& y, const Ball& T, bool with_derivative) const {
  Vector state(2);
  state << x, y;
  return {phases_, 1, phases_.whole(state, Ball(0)), T, false, with_derivative};
}

SmoothPhase PlanarSlip::from_belt(const Ball& time) const {
  return follow((law_.first - o().damping(0, 0) * o().V) / o().stiffness(0, 0), o().V, time, false);
}

bool PlanarSlip::stays_away(const Ball& time, const Ball& damped_up_to) const {
  const SmoothPhase phase = from_belt(time);
  if (!stays_below(phase, time, 2, [](const Stretch&, bool is_below) { return is_below; })) {
    return false;
  }
  const Vector end = phase.end();
  const bool turns = std::ranges::any_of(
                         phase.steps(), [](const auto& step) { return step.w[1](velocity).is_positive(); }) &&
                     acceleration(end).is_negative();
  const Ball h = o().damping(0, 0) * damped_up_to - law_.force(o().V - damped_up_to) + law_.force(o().V);
  const Ball x = end(position) - steady(), y = end(velocity), &m = o().masses[0];
  const Ball less = m * damped_up_to * damped_up_to - o().stiffness(0, 0) * x * x - m * y * y;
  return turns || (h.is_positive() && less.is_positive());
}

}  // namespace stickslip::numeric::machines
