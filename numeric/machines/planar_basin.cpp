#include "numeric/machines/planar_basin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "numeric/machines/smooth_phase.hpp"
#include "numeric/zeros/krawczyk.hpp"

namespace stickslip::numeric::machines {

namespace {

using stickslip::to_string;

constexpr std::size_t values_along = 65;
constexpr double resolution_along = 0x1p-40;
constexpr int more_precisions = 2;
constexpr long bits_of_others = 64;

using Box = zeros::Box<2>;  // x, and the time of a turn

void require_planar(const Machine& machine) {
  require_machine(machine);
  const model::FrictionOscillator<Rational>& o = machine.oscillator;
  if (o.size() != 1) {
    throw DomainError("the number of masses", fmt::format("{}", o.size()),
                      "1: the basin of steady sliding is proved for one mass without a load");
  }
  if (!o.loads.empty()) {
    throw DomainError("the number of loads", fmt::format("{}", o.loads.size()),
                      "0: the basin of steady sliding is proved for one mass without a load");
  }
  if (o.stiffness(0, 0) <= 0 || o.damping(0, 0) < 0) {
    throw DomainError("the stiffness", to_string(o.stiffness(0, 0)),
                      "> 0: without a spring there is no steady sliding");
  }
  const std::optional<model::SmoothFriction<Rational>>& law = o.law(o.V < 0 ? -1 : 1).smooth;
  if (!law) {
    throw DomainError("the sliding friction", "in pieces",
                      "a smooth law: the basin of steady sliding is proved for those alone");
  }
  if (law->first <= law->last) {
    throw DomainError("the sliding friction at 0", to_string(law->first),
                      fmt::format("> {}, to which it falls", to_string(law->last)));
  }
}

void require_rectangle(const Rectangle& r) {
  if (r.x_from >= r.x_to) {
    throw DomainError("the starts' positions", to_string(r.x_from) + ".." + to_string(r.x_to), "A..B, A < B");
  }
  if (r.y_from >= r.y_to) {
    throw DomainError("the starts' velocities", to_string(r.y_from) + ".." + to_string(r.y_to),
                      "A..B, A < B");
  }
}

// Seen in a mirror where the belt runs backwards: then it is the slip in which the belt is the faster one.
Machine with_belt_forward(Machine machine) {
  model::FrictionOscillator<Rational>& o = machine.oscillator;
  if (o.V < 0) {
    o.V = -o.V;
    std::swap(o.forward, o.backward);
  }
  return machine;
}
Rectangle mirrored(const Rectangle& r) {
  return {-r.x_to, -r.x_from, -r.y_to, -r.y_from};
}

// ---- floating point, for guesses

class Guess {
 public:
  explicit Guess(const Machine& machine)
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

  // Where K is at velocity 0, behind steady sliding, and how long it takes. Nothing when it is not found.
  [[nodiscard]] std::optional<std::array<double, 2>> cycle() const {
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

  // A velocity at which h of the header is positive: so it is between 0 and there, for it is concave.
  [[nodiscard]] double damped_up_to() const {
    constexpr int most_halvings = 200;
    double y = V_;
    for (int i = 0; i < most_halvings && c_ * y - law_.force(V_ - y) + law_.force(V_) <= 0; ++i) {
      y /= 2;
    }
    return y;
  }

  // From T, of the motion in the belt's direction: the time at which it is fastest after a turn, or clearly
  // faster than the belt, or has clearly less energy about steady sliding than m/2 times the square of the
  // velocity above. Nothing when that takes long.
  [[nodiscard]] std::optional<double> telling_time() const {
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

  // From the belt at x, until it is met again.
  [[nodiscard]] std::optional<double> back_at_belt(double x) const {
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

 private:
  static constexpr double steps_in_radian = 300;
  static constexpr long most_steps = 200000;
  struct State {
    double x, y;
  };
  struct End {
    double behind, time;
  };

  [[nodiscard]] double acceleration(const State& s) const {
    return (law_.force(V_ - s.y) - c_ * s.y - k_ * s.x) / m_;
  }
  [[nodiscard]] State step(const State& s, double h) const {
    const auto rate = [&](const State& at) { return State{at.y, acceleration(at)}; };
    const auto go = [&](const State& d, double t) { return State{s.x + d.x * t, s.y + d.y * t}; };
    const State a = rate(s), b = rate(go(a, h / 2)), c = rate(go(b, h / 2)), d = rate(go(c, h));
    return {s.x + h / 6 * (a.x + 2 * b.x + 2 * c.x + d.x), s.y + h / 6 * (a.y + 2 * b.y + 2 * c.y + d.y)};
  }
  // From so far behind steady sliding, at velocity 0, to there again.
  [[nodiscard]] std::optional<End> turn(double behind) const {
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
  [[nodiscard]] bool leads_out(double behind) const {
    const std::optional<End> end = turn(behind);
    return !end || end->behind > behind;
  }

  model::FrictionOscillator<double> o_;
  model::SmoothFriction<double> law_;
  double m_, c_, k_, V_, steady_, h_ = 0;
};

// ---- stretches of a slip

constexpr Eigen::Index position = 0, velocity = 1;

// A derivative of x or y at a time since the step's beginning.
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

struct Stretch {
  const SmoothPhase::Step& step;
  Ball from, to;  // times since its beginning

  [[nodiscard]] Ball over(Eigen::Index row, int derivative = 0) const {
    const Ball all = Ball::hull(from, to), middle = all.midpoint();
    return value(step, row, derivative, middle) + value(step, row, derivative + 1, all) * (all - middle);
  }
};

// The stretches of the phase up to T in their order, halved until `take` takes them; whether it took all.
template <class Take>
bool takes_all(const Stretch& stretch, const Take& take, int depth = 0) {
  if (take(stretch)) {
    return true;
  }
  if (depth == WorkingPrecision::bits()) {
    return false;
  }
  const Ball middle = Ball::hull(stretch.from, stretch.to).midpoint();
  return takes_all(Stretch{stretch.step, stretch.from, middle}, take, depth + 1) &&
         takes_all(Stretch{stretch.step, middle, stretch.to}, take, depth + 1);
}
template <class Take>
bool takes_all(const SmoothPhase& phase, const Ball& T, const Take& take) {
  for (const SmoothPhase::Step& step : phase.steps()) {
    const bool last = &step == &phase.steps().back();
    if (!takes_all(Stretch{step, Ball(0), last ? T - Ball(step.start) : Ball(step.length)}, take)) {
      return false;
    }
  }
  return !phase.steps().empty();
}

// ---- the slip, with the belt running forward

class Slip {
 public:
  explicit Slip(const Machine& machine)
      : machine_(machine), phases_(oscillator_as<Ball>(machine)), law_(*phases_.oscillator().forward.smooth) {
    (void)phases_.drift({motion::PhaseKind::slip, 0});  // kept with the bits of now
  }

  // Of "steady sliding is asymptotically stable".
  [[nodiscard]] Verdict steady_sliding_is_stable() const {
    const Ball damping = o().damping(0, 0) + law_.slope(o().V);
    return damping.is_positive()   ? Verdict::proved()
           : damping.is_negative() ? Verdict::refuted("steady sliding is unstable")
                                   : Verdict::undecided("steady sliding may be about to lose its stability");
  }

  // Of "K exists", by 3, where steady sliding is stable.
  [[nodiscard]] Verdict cycle_exists() const {
    constexpr double more = 1 + 0x1p-10;
    if (Ball(o().damping(0, 0) + law_.slope(Ball(0))).is_positive()) {
      return Verdict::refuted(
          "no closed motion is below the belt: damping exceeds the fall of friction at all "
          "velocities");
    }
    const Guess guess(machine_);
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

  // The parts of a turn of K from velocity 0, each with what is so along it: y' > 0, y > 0, y' < 0, y < 0 and
  // y' > 0; so it is one turn only. And it stays below the belt.
  [[nodiscard]] bool is_turn_below_belt(const SmoothPhase& phase, const Ball& T) const {
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

  // From the belt at x, right of where it could stick: where the belt is met again, first; nothing where that
  // is not enclosed. `take` is handed all stretches before.
  template <class Take>
  [[nodiscard]] std::optional<Ball> back_at_belt(const Ball& x, const Take& take) const {
    constexpr double near = 0x1p-16;
    const std::optional<double> guess = Guess(machine_).back_at_belt(x.approximate());
    if (!guess) {
      return std::nullopt;
    }
    const Ball T(*guess * (1 + near));
    const double from = *guess * (1 - near);
    const SmoothPhase phase = follow(x, o().V, T, false);
    std::optional<Ball> where;
    const bool done = stays_below(phase, T, 1, [&](const Stretch& s, bool is_below) {
      if (!is_below && s.step.start + s.from.approximate() >= from && s.over(velocity).is_positive()) {
        where = where ? Ball::hull(*where, s.over(position)) : s.over(position);
        is_below = true;
      }
      return is_below && take(s);
    });
    return done && Ball(phase.end()(velocity) - o().V).is_positive() ? where : std::nullopt;
  }

  [[nodiscard]] SmoothPhase follow(const Ball& x, const Ball& y, const Ball& T, bool with_derivative) const {
    Vector state(2);
    state << x, y;
    return {phases_, 1, phases_.whole(state, Ball(0)), T, false, with_derivative};
  }
  [[nodiscard]] Ball acceleration(const Vector& w) const { return smooth_rate(phases_, 1, w)(velocity); }
  [[nodiscard]] Ball steady() const { return law_.force(o().V) / o().stiffness(0, 0); }

  [[nodiscard]] const model::FrictionOscillator<Ball>& o() const { return phases_.oscillator(); }

 private:
  [[nodiscard]] SmoothPhase from_belt(const Ball& T) const {
    return follow((law_.first - o().damping(0, 0) * o().V) / o().stiffness(0, 0), o().V, T, false);
  }
  // Whether the motion from the belt is below it from then on up to T. So it is at first, where a derivative
  // of y is negative and those before are 0 or negative at the belt. `take` decides on each stretch, knowing
  // whether it is below.
  template <class Take>
  [[nodiscard]] bool stays_below(const SmoothPhase& phase, const Ball& T, int derivative,
                                 const Take& take) const {
    bool begins = true;
    return takes_all(phase, T, [&](const Stretch& s) {
      const bool taken = take(s, begins ? s.over(velocity, derivative).is_negative()
                                        : Ball(o().V - s.over(velocity)).is_positive());
      begins = begins && !taken;
      return taken;
    });
  }
  // Whether the motion from T is below the belt until the time, and then it is clear that it stays there.
  // Either it speeds up and at last slows down again: then it has passed from y' > 0 to y' < 0 below the
  // belt, which it does between the belt and steady sliding. Or its energy about steady sliding, which
  // changes by -y h(y), falls from there on.
  [[nodiscard]] bool stays_away(const Ball& time, const Ball& damped_up_to) const {
    const SmoothPhase phase = from_belt(time);
    if (!stays_below(phase, time, 2, [](const Stretch&, bool is_below) { return is_below; })) {
      return false;
    }
    const Vector end = phase.end();
    const bool turns =
        std::ranges::any_of(phase.steps(),
                            [](const auto& step) { return step.w[1](velocity).is_positive(); }) &&
        acceleration(end).is_negative();
    const Ball h = o().damping(0, 0) * damped_up_to - law_.force(o().V - damped_up_to) + law_.force(o().V);
    const Ball x = end(position) - steady(), y = end(velocity), &m = o().masses[0];
    const Ball less = m * damped_up_to * damped_up_to - o().stiffness(0, 0) * x * x - m * y * y;
    return turns || (h.is_positive() && less.is_positive());
  }

  Machine machine_;
  LinearPhases phases_;
  const model::SmoothFriction<Ball>& law_;
};

// ---- K

struct Cycle {
  Box box;  // x and the period
  Ball multiplier;
};

struct Closing {
  Box value;
  zeros::BallMatrix<2> slope;
  Ball multiplier;
};
// (x, y) after T from (x, 0), less (x, 0), and its derivatives.
Closing closing(const Slip& slip, const Box& u) {
  const SmoothPhase phase = slip.follow(u(0), Ball(0), u(1), true);
  const Vector end = phase.end();
  const Matrix D = phase.derivative();
  Closing c;
  c.value << end(position) - u(0), end(velocity);
  c.slope << D(0, 0) - Ball(1), end(velocity), D(1, 0), slip.acceleration(end);
  c.multiplier = D(0, 0) * D(1, 1) - D(0, 1) * D(1, 0);
  return c;
}

bool is_finite(const Box& u) {
  return u(0).is_finite() && u(1).is_finite();
}

// Newton's method, and Krawczyk's test around where it leads.
std::optional<Cycle> proved_cycle(const Slip& slip, const std::array<double, 2>& guess) {
  constexpr int steps = 12;
  constexpr long first_bits = 64;
  constexpr double wider = 64;
  const double small = std::exp2(-static_cast<double>(WorkingPrecision::bits()) / 2);
  Box u{Ball(guess[0]), Ball(guess[1])};
  double last = 1;
  for (int i = 0; i < steps; ++i) {
    const WorkingPrecision scope(std::min(WorkingPrecision::bits(), first_bits << i));
    const Closing c = closing(slip, u);
    const auto Y = zeros::approximate_inverse<Ball, 2>(c.slope);
    if (!Y) {
      return std::nullopt;
    }
    const Box step = zeros::product(*Y, c.value);
    u = zeros::midpoint<2>(Box(u - step));
    if (!is_finite(u) || !u(1).is_positive()) {
      return std::nullopt;
    }
    const double size = std::max(abs(step(0)).upper().approximate() / (abs(u(0)).approximate() + 1),
                                 abs(step(1)).upper().approximate() / u(1).approximate());
    const bool settled = size < small || (i > 2 && size > last / 2);
    last = size;
    if (settled) {
      break;
    }
  }
  const Box X = zeros::box_around<2>(u, wider * last);
  const auto K = zeros::krawczyk_image<2>(u, closing(slip, u).value, closing(slip, X).slope, X);
  if (!K || !zeros::is_interior<2>(*K, X)) {
    return std::nullopt;
  }
  return Cycle{*K, closing(slip, *K).multiplier};
}

// ---- areas

struct Sides {
  Ball x_from, x_to, y_from, y_to;
};

// ∫ min(max(y, y_from), y_to) dx along K where x_from < x < x_to: the area of the rectangle inside K. All
// of the area without a rectangle.
class Area {
 public:
  Area(const SmoothPhase& phase, const Ball& T, const Sides * sides) : sides_(sides) {
    const Vector end = phase.end();
    const double speed = 1 + abs(end(velocity)).upper().approximate();
    const double error = std::max(end(position).radius().approximate(), end(velocity).radius().approximate());
    least_ = (std::exp2(-static_cast<double>(WorkingPrecision::bits()) + 40) + 0x1p10 * error) * speed;
    const SmoothPhase::Step * step = nullptr;
    const bool all = takes_all(phase, T, [&](const Stretch& s) {
      if (step != &s.step) {
        step = &s.step;
        square_.clear();
      }
      return take(s);
    });
    if (!all) {
      arb_indeterminate(sum_.raw());
    }
  }
  [[nodiscard]] const Ball& value() const { return sum_; }

 private:
  static constexpr long most_stretches = 100000;

  bool take(const Stretch& s) {
    if (sides_ == nullptr) {
      add_square(s);
      return true;
    }
    const Ball x = s.over(position), y = s.over(velocity);
    const Ball right = x - sides_->x_from, left = sides_->x_to - x;
    if (right.is_negative() || left.is_negative()) {
      return true;
    }
    const Ball low = y - sides_->y_from, high = sides_->y_to - y;
    if (right.is_positive() && left.is_positive()) {
      if (low.is_positive() && high.is_positive()) {
        add_square(s);
        return true;
      }
      if (low.is_negative() || high.is_negative()) {
        const Ball way = value_at(s, s.to) - value_at(s, s.from);
        sum_ += (low.is_negative() ? sides_->y_from : sides_->y_to) * way;
        return true;
      }
    }
    // All that it may be.
    Ball cut = y;
    arb_max(cut.raw(), cut.raw(), sides_->y_from.raw(), WorkingPrecision::bits());
    arb_min(cut.raw(), cut.raw(), sides_->y_to.raw(), WorkingPrecision::bits());
    Ball part = cut * y * (s.to - s.from);
    if (!right.is_positive() || !left.is_positive()) {
      part = Ball::hull(Ball(0), part);
    }
    if (part.radius().approximate() < least_ || ++stretches_ > most_stretches) {
      sum_ += part;
      return true;
    }
    return false;
  }
  [[nodiscard]] static Ball value_at(const Stretch& s, const Ball& time) {
    return stickslip::numeric::machines::value(s.step, position, 0, time);
  }
  // ∫ y² dt, for y > 0 and y < 0 alike: dx = y dt.
  void add_square(const Stretch& s) {
    if (square_.empty()) {
      const std::vector<Vector>& w = s.step.w;
      square_.assign(2 * w.size(), Ball(0));
      for (std::size_t i = 0; i < w.size(); ++i) {
        for (std::size_t k = 0; k < w.size(); ++k) {
          add_product(square_[i + k + 1], w[i](velocity), w[k](velocity));
        }
      }
      for (std::size_t k = 1; k < square_.size(); ++k) {
        square_[k] /= Ball(static_cast<long>(k));
      }
    }
    const auto integral = [&](const Ball& time) {
      Ball sum(0);
      for (std::size_t k = square_.size(); k-- > 0;) {
        sum = sum * time + square_[k];
      }
      return sum;
    };
    sum_ += integral(s.to) - integral(s.from);
  }

  const Sides * sides_;
  double least_ = 0;  // what a stretch that may be inside or not is let be
  long stretches_ = 0;
  std::vector<Ball> square_;  // the coefficients of ∫ y² dt since the step's beginning
  Ball sum_ = Ball(0);
};

Sides sides_of(const Rectangle& r) {
  return {Ball(r.x_from), Ball(r.x_to), Ball(r.y_from), Ball(r.y_to)};
}

// Of "what starts in the rectangle outside K ends on one cycle that sticks", by 4.
Verdict others_stick(const Slip& slip, const Rectangle& starts) {
  constexpr int most_turns = 100, most_attempts = 40;
  constexpr double farther = 1.25;
  const auto& o = slip.o();
  const Ball &m = o.masses[0], &k = o.stiffness(0, 0), held = o.damping(0, 0) * o.V;
  const Sides given = sides_of(starts);
  const auto larger = [](Ball a, const Ball& b) {
    arb_max(a.raw(), a.raw(), b.raw(), WorkingPrecision::bits());
    return a;
  };
  const auto smaller = [&](const Ball& a, const Ball& b) { return -larger(-a, -b); };
  const Sides inside{smaller(given.x_from, slip.steady()), larger(given.x_to, slip.steady()),
                     smaller(given.y_from, Ball(0)), o.V};
  const Ball x_most = larger(abs(given.x_from), abs(given.x_to));
  const Ball y_most = larger(larger(abs(given.y_from), abs(given.y_to)), o.V);
  const Ball bound = sqrt(Ball(x_most * x_most + m / k * (y_most * y_most - o.V * o.V))).upper();
  const Ball first = larger(larger(bound, inside.x_to), Ball((o.forward.at_rest - held) / k));
  const auto is_out = [&](const Stretch& s) {
    const Ball x = s.over(position);
    return Ball(x - inside.x_from).is_negative() || Ball(x - inside.x_to).is_positive() ||
           Ball(s.over(velocity) - inside.y_from).is_negative();
  };
  const auto anywhere = [](const Stretch&) { return true; };
  std::optional<Ball> back;
  double times = farther;
  for (int attempt = 0; attempt < most_attempts && !back; ++attempt, times *= farther) {
    back = slip.back_at_belt(Ball(first * Ball(times)).upper(), is_out);
    back = back && Ball(*back - inside.x_from).is_negative() ? back : std::nullopt;
  }
  // At least, while it overshoots from there: it gets no faster than without friction, and what falls is
  // least at the greatest speed.
  const auto friction = [&](const Ball& x) {
    const auto& law = o.backward.smooth;
    const Ball speed = Ball(sqrt(Ball(o.V * o.V + k / m * x * x)) - o.V).upper();
    return law && !Ball(law->first - law->last).is_negative()
               ? law->last + (law->first - law->last) * law->shape(larger(speed, Ball(0)))
               : Ball(0);
  };
  for (int turn = 0; turn < most_turns && back; ++turn) {
    if (Ball(k * *back + held + o.backward.at_rest).is_positive()) {
      return Verdict::proved();
    }
    const Ball x = Ball(-*back - Ball(2) * friction(*back) / k).upper();
    if (Ball(k * x + held - o.forward.at_rest).is_negative()) {
      return Verdict::proved();
    }
    back = slip.back_at_belt(x, anywhere);
  }
  return Verdict::undecided("the outermost motion was not seen to come to the belt so slowly that it sticks");
}

// With the belt running forward, at the working precision.
PlanarBasin basin_at(const Machine& machine, const Rectangle& starts) {
  const Slip slip(machine);
  PlanarBasin basin;
  basin.verdict = slip.steady_sliding_is_stable();
  if (basin.verdict.truth == Truth::proved) {
    basin.verdict = slip.cycle_exists();
  }
  if (basin.verdict.truth != Truth::proved) {
    return basin;
  }
  const auto guess = Guess(machine).cycle();
  const std::optional<Cycle> cycle = guess ? proved_cycle(slip, *guess) : std::nullopt;
  if (!cycle) {
    basin.verdict = Verdict::undecided("the closed motion exists, but was not enclosed");
    return basin;
  }
  basin.x = cycle->box(0);
  basin.period = cycle->box(1);
  basin.multiplier = cycle->multiplier;
  const SmoothPhase turn = slip.follow(basin.x, Ball(0), basin.period, false);
  if (!Ball(slip.steady() - basin.x).is_positive() || !slip.is_turn_below_belt(turn, basin.period)) {
    basin.verdict =
        Verdict::undecided("the closed motion that was enclosed may not be one turn below the belt");
    return basin;
  }
  basin.area = Area(turn, basin.period, nullptr).value();
  const Sides sides = sides_of(starts);
  basin.share =
      Area(turn, basin.period, &sides).value() / ((sides.x_to - sides.x_from) * (sides.y_to - sides.y_from));
  return basin;
}

enum class Regime { unknown, unstable, with_cycle, alone };

Regime regime_of(const Machine& given, long bits) {
  require_planar(given);
  const WorkingPrecision scope(bits);
  const Slip slip(with_belt_forward(given));
  const Truth stable = given.oscillator.V == 0 ? Truth::undecided : slip.steady_sliding_is_stable().truth;
  if (stable != Truth::proved) {
    return stable == Truth::refuted ? Regime::unstable : Regime::unknown;
  }
  const Truth exists = slip.cycle_exists().truth;
  return exists == Truth::proved    ? Regime::with_cycle
         : exists == Truth::refuted ? Regime::alone
                                    : Regime::unknown;
}

}  // namespace

PlanarBasin planar_basin(const Machine& given, const Rectangle& starts, int digits) {
  require_planar(given);
  require_rectangle(starts);
  PlanarBasin basin;
  if (given.oscillator.V == 0) {
    basin.verdict = Verdict::refuted("the belt stands still");
    return basin;
  }
  const bool mirror = given.oscillator.V < 0;
  const Machine machine = with_belt_forward(given);
  const Rectangle seen = mirror ? mirrored(starts) : starts;
  long bits = scalars::bits_for(digits) + 64;
  for (int attempt = 0; attempt <= more_precisions; ++attempt, bits *= 2) {
    const WorkingPrecision scope(bits);
    basin = basin_at(machine, seen);
    if (basin.verdict.truth != Truth::undecided) {
      break;
    }
  }
  if (basin.verdict.truth == Truth::proved) {
    const WorkingPrecision scope(bits_of_others);
    basin.others = others_stick(Slip(machine), seen);
  }
  basin.x = mirror ? -basin.x : basin.x;
  return basin;
}

PlanarBasinAlong planar_basin_along(const std::function<Machine(const Rational&)>& at, const Rational& from,
                                    const Rational& to, const Rectangle& starts, int digits) {
  if (from >= to) {
    throw UsageError(fmt::format("{}..{} does not rise: A..B needs A < B", to_string(from), to_string(to)));
  }
  const long bits = scalars::bits_for(digits) + 64;
  PlanarBasinAlong result;
  result.samples = parallel_map(values_along, [&](std::size_t k) {
    const Rational value =
        from + (to - from) * Rational(static_cast<long>(k)) / static_cast<long>(values_along - 1);
    return PlanarBasinAlong::Sample{value, planar_basin(at(value), starts, digits)};
  });
  const std::vector<Regime> regimes =
      parallel_map(values_along, [&](std::size_t k) { return regime_of(at(result.samples[k].value), bits); });
  for (std::size_t k = 0; k + 1 < values_along; ++k) {
    Rational a = result.samples[k].value, b = result.samples[k + 1].value;
    const Regime first = regimes[k], last = regimes[k + 1];
    if (first == last || first == Regime::unknown || last == Regime::unknown ||
        (first != Regime::with_cycle && last != Regime::with_cycle)) {
      continue;
    }
    while (b - a > (to - from) * Rational(resolution_along)) {
      const Rational middle = (a + b) / 2;
      const Regime there = regime_of(at(middle), bits);
      if (there != first && there != last) {
        break;
      }
      (there == first ? a : b) = middle;
    }
    result.ends.push_back(
        {a, b, last == Regime::with_cycle, first != Regime::unstable && last != Regime::unstable});
  }
  return result;
}

}  // namespace stickslip::numeric::machines
