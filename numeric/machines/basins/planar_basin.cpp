#include "numeric/machines/basins/planar_basin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/domain.hpp"
#include "core/parallel.hpp"
#include "numeric/machines/basins/planar_slip.hpp"
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
  require(o.size() == 1, "the number of masses", o.size(),
          "1: the basin of steady sliding is proved for one mass without a load");
  require(o.loads.empty(), "the number of loads", o.loads.size(),
          "0: the basin of steady sliding is proved for one mass without a load");
  require(o.stiffness(0, 0) > 0, "the stiffness", o.stiffness(0, 0),
          "> 0: without a spring there is no steady sliding");
  require(o.damping(0, 0) >= 0, "the damping", o.damping(0, 0), ">= 0");
  const std::optional<model::SmoothFriction<Rational>>& law = o.law(o.V < 0 ? -1 : 1).smooth;
  require(law.has_value(), "the sliding friction", "in pieces",
          "a smooth law: the basin of steady sliding is proved for those alone");
  require(law->first > law->last, "the sliding friction at 0", law->first,
          fmt::format("> {}, to which it falls", to_string(law->last)));
}

void require_rectangle(const Rectangle& r) {
  require(r.x_from < r.x_to, "the starts' positions", to_string(r.x_from) + ".." + to_string(r.x_to),
          "A..B, A < B");
  require(r.y_from < r.y_to, "the starts' velocities", to_string(r.y_from) + ".." + to_string(r.y_to),
          "A..B, A < B");
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
Closing closing(const PlanarSlip& slip, const Box& u) {
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
std::optional<Cycle> proved_cycle(const PlanarSlip& slip, const std::array<double, 2>& guess) {
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
    sum_ = all ? sum_ : scalars::anything();
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
Verdict others_stick(const PlanarSlip& slip, const Rectangle& starts) {
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
  const PlanarSlip slip(machine);
  PlanarBasin basin;
  basin.verdict = slip.steady_sliding_is_stable();
  if (basin.verdict.truth == Truth::proved) {
    basin.verdict = slip.cycle_exists();
  }
  if (basin.verdict.truth != Truth::proved) {
    return basin;
  }
  const auto guess = SlipGuess(machine).cycle();
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
  const PlanarSlip slip(with_belt_forward(given));
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
    basin.others = others_stick(PlanarSlip(machine), seen);
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
