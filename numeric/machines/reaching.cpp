#include "numeric/machines/reaching.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

namespace {

constexpr long bits_of_pixels = 64;

}  // namespace

Reaching::Reaching(const Machine& machine, std::vector<std::shared_ptr<const Neighbourhood>> all)
    : flow_(machine),
      simulation_(oscillator_as<double>(machine), 0,
                  Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * machine.oscillator.size()))),
      autonomous_(machine.oscillator.is_autonomous()),
      all_(std::move(all)) {
  for (std::shared_ptr<const Neighbourhood>& one : all_) {
    if (one && one->verdict.truth != Truth::proved) {
      one.reset();
    }
  }
}

std::optional<std::size_t> Reaching::operator()(const Vector& middle, const Matrix& S,
                                                long most_periods) const {
  SetOfMotions set = set_at(Ball(0), {}, middle, S, false);
  const auto piece = flow_.piece_of(set.all.value.tail(middle.size()), Ball(0));
  if (!piece) {
    return std::nullopt;
  }
  set.piece = *piece;
  return autonomous_ ? at_events(set, most_periods) : in_periods(set, most_periods);
}

std::optional<std::size_t> Reaching::in_periods(SetOfMotions set, long most_periods) const {
  const Ball period = Ball(2) * Ball::pi() / flow_.phases().oscillator().omega;
  // In the order of the phases of the load.
  std::vector<std::pair<Ball, std::size_t>> times;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (all_[i]) {
      const Ball turns(std::floor(all_[i]->time / period.approximate()));
      const Ball time = Ball(all_[i]->time) - turns * period;
      times.emplace_back(time.is_positive() ? time : Ball(time + period), i);
    }
  }
  std::ranges::sort(times, {}, [](const auto& one) { return one.first.approximate(); });
  // Where the middle one is seen to be in one of them the set is looked at.
  simulation_.restart(0, zeros::in_double(set.middle.value.tail(set.middle.value.size() - 1)));
  double passed = 0;
  for (long k = 0; k < most_periods; ++k) {
    for (const auto& [time, i] : times) {
      const Ball here = time + Ball(k) * period;
      simulation_.advance(here.approximate() - std::exchange(passed, here.approximate()));
      const Neighbourhood& one = *all_[i];
      const Eigen::VectorXd away = simulation_.state() - zeros::in_double(one.centre);
      if (!((zeros::in_double(one.inverse) * away).norm() < one.radius)) {
        continue;
      }
      if (flow_.follow(set, here).truth != Truth::proved) {
        return std::nullopt;
      }
      if (one.holds(set)) {
        return i;
      }
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> Reaching::at_events(SetOfMotions set, long most_periods) const {
  double longest = 0;
  for (const auto& one : all_) {
    longest = one ? std::max(longest, one->period) : longest;
  }
  for (const MachineGuess::Event& event : flow_.events(set, longest * static_cast<double>(most_periods))) {
    if (flow_.to_event(set, event.begins, event.t - set.time().approximate()).truth != Truth::proved) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (all_[i] && all_[i]->holds(set)) {
        return i;
      }
    }
  }
  return std::nullopt;
}

std::vector<std::optional<std::size_t>> reached(const Machine& machine, const Pixels& pixels,
                                                std::vector<std::shared_ptr<const Neighbourhood>> all) {
  const WorkingPrecision scope(bits_of_pixels);
  tbb::enumerable_thread_specific<Reaching> reaching([&] { return Reaching(machine, all); });
  Matrix S = Matrix::Constant(pixels.starts.front().size(), 2, Ball(0));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // Middles are rounded: a little more, so that no start between two pixels is missed.
    const int k = pixels.across[axis];
    const double far = std::max(std::abs(pixels.starts.front()(k)), std::abs(pixels.starts.back()(k)));
    S(k, static_cast<Eigen::Index>(axis)) = Ball(pixels.half[axis] + 0x1p-48 * (far + pixels.half[axis]));
  }
  return parallel_map(pixels.starts.size(), [&](std::size_t i) {
    return interrupted() ? std::nullopt : reaching.local()(pixels.starts[i].cast<Ball>(), S);
  });
}

}  // namespace stickslip::numeric::machines
