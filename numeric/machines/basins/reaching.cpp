#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/machines/basins/neighbourhood.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

namespace {

constexpr long bits_of_pixels = 64;

// Pixels of some columns and rows.
struct Block {
  std::array<long, 2> from, count;
};
constexpr long largest_block = 4;  // to a side

// How long sets are followed: periods of the load, or of the orbits.
constexpr long periods_followed = 30;

class Reaching {
 public:
  // At the working precision; those that are not proved are reached by none.
  Reaching(const Machine& machine, std::vector<std::shared_ptr<const Neighbourhood>> all)
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

  // That which all motions from middle + S e at load phase 0, |e_k| <= 1, are proved to reach; nothing if
  // they are not.
  std::optional<std::size_t> operator()(const Vector& middle, const Matrix& S) {
    SetOfMotions set = set_at(Ball(0), {}, middle, S, false);
    const auto piece = flow_.piece_of(set.all.value.tail(middle.size()), Ball(0));
    if (!piece) {
      return std::nullopt;
    }
    set.piece = *piece;
    set.timeless = autonomous_;
    return autonomous_ ? at_events(set) : in_periods(set);
  }

 private:
  std::optional<std::size_t> in_periods(SetOfMotions set) {
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
    for (long k = 0; k < periods_followed; ++k) {
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

  [[nodiscard]] std::optional<std::size_t> at_events(SetOfMotions set) const {
    double longest = 0;
    for (const auto& one : all_) {
      longest = one ? std::max(longest, one->period) : longest;
    }
    for (const MachineGuess::Event& event :
         flow_.events(set, longest * static_cast<double>(periods_followed))) {
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

  SetFlow flow_;
  simulation::AnySimulation simulation_;
  bool autonomous_;
  std::vector<std::shared_ptr<const Neighbourhood>> all_;
};

}  // namespace

std::vector<std::optional<std::size_t>> reached(const Machine& machine, const Pixels& pixels,
                                                std::vector<std::shared_ptr<const Neighbourhood>> all) {
  const WorkingPrecision scope(bits_of_pixels);
  tbb::enumerable_thread_specific<Reaching> reaching([&] { return Reaching(machine, all); });
  const auto place = [&](long column, long row) {
    return static_cast<std::size_t>(row * pixels.count[0] + column);
  };
  const auto reach = [&](const Block& block) {
    const auto& first = pixels.starts[place(block.from[0], block.from[1])];
    const auto& last =
        pixels.starts[place(block.from[0] + block.count[0] - 1, block.from[1] + block.count[1] - 1)];
    Matrix S = Matrix::Constant(first.size(), 2, Ball(0));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      // Middles are rounded: a little more, so that no start between two pixels is missed.
      const int k = pixels.across[axis];
      const double half = static_cast<double>(block.count[axis]) * pixels.half[axis];
      S(k, static_cast<Eigen::Index>(axis)) =
          Ball(half + 0x1p-48 * (std::abs(first(k)) + std::abs(last(k)) + half));
    }
    const Eigen::VectorXd middle = (first + last) / 2;
    return interrupted() ? std::nullopt : reaching.local()(middle.cast<Ball>(), S);
  };
  std::vector<std::optional<std::size_t>> result(pixels.starts.size());
  std::vector<Block> open;
  for (long row = 0; row < pixels.count[1]; row += largest_block) {
    for (long column = 0; column < pixels.count[0]; column += largest_block) {
      open.push_back({{column, row},
                      {std::min(largest_block, pixels.count[0] - column),
                       std::min(largest_block, pixels.count[1] - row)}});
    }
  }
  while (!open.empty() && !interrupted()) {
    const auto ends = parallel_map(open.size(), [&](std::size_t i) { return reach(open[i]); });
    std::vector<Block> next;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Block& block = open[i];
      for (long row = 0; ends[i] && row < block.count[1]; ++row) {
        std::fill_n(result.begin() + static_cast<long>(place(block.from[0], block.from[1] + row)),
                    block.count[0], ends[i]);
      }
      const std::size_t axis = block.count[1] > block.count[0] ? 1 : 0;
      if (!ends[i] && block.count[axis] > 1) {
        Block one = block, other = block;
        one.count[axis] /= 2;
        other.from[axis] += one.count[axis];
        other.count[axis] -= one.count[axis];
        next.insert(next.end(), {one, other});
      }
    }
    open = next;
  }
  return result;
}

}  // namespace stickslip::numeric::machines
