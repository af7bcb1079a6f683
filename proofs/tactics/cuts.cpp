#include "proofs/tactics/cuts.hpp"

#include <algorithm>
#include <cmath>

#include "core/fmpq.hpp"
#include "proofs/tactics/closed.hpp"

namespace stickslip::proofs::tactics {

using namespace kernel;

namespace {

using Float = long double;
constexpr Float nearly_zero = 1e-9L;

// The number between, or an end, that has the least denominator.
Rational simplest(Float from, Float to) {
  const Fmpq lower(Rational(static_cast<double>(from))), upper(Rational(static_cast<double>(to)));
  Fmpq result;
  fmpq_simplest_between(result.raw(), lower.raw(), upper.raw());
  return result.value();
}

class Graph {
 public:
  Graph(const Term& f, const Variable& x, const std::optional<Rational>& lower,
        const std::optional<Rational>& upper)
      : x_(x), lower_(lower), upper_(upper), rates_{f, rate(f, x)} {
    constexpr int many = 96;
    const Float from = lower ? lower->get_d() : 0, to = upper ? upper->get_d() : 0;
    for (int k = 0; k <= many; ++k) {
      const Float part = static_cast<Float>(k) / many, far = (std::exp2(12 * part) - 1) / 16;
      if (lower && upper) {
        grid_.push_back(from + (to - from) * part);
      } else if (lower) {
        grid_.push_back(from + far);
      } else if (upper) {
        grid_.push_back(to - far);
      } else {
        grid_.insert(grid_.end(), {far, -far});
      }
    }
    std::ranges::sort(grid_);
  }

  Cuts cuts() {
    Cuts result;
    for (const Float place : grid_) {
      const Float value = at(0, place);
      if (value < -nearly_zero) {
        result.below = number(place);
        return result;
      }
      if (std::isnan(value)) {
        return result;
      }
    }
    std::vector<std::size_t> turns;  // since the last zero
    std::size_t start = 0;
    bool has_valley = false;
    const auto end_part = [&](std::size_t end) {
      const bool is_open = (start == 0 && !lower_) || (end + 1 == grid_.size() && !upper_);
      if (has_valley || !is_open) {
        add_cuts(start, end, turns, result.places);
      }
      result.has_valley = result.has_valley || has_valley;
      turns.clear();
      has_valley = false;
      start = end;
    };
    std::optional<std::size_t> fell, rose;  // the last place, if it is since the other
    for (std::size_t k = 0; k < grid_.size(); ++k) {
      const Float slope = at(1, grid_[k]);
      if (!(std::abs(slope) > least_slope)) {
        continue;
      }
      const bool rises = slope > 0;
      const std::optional<std::size_t> before = rises ? fell : rose;
      (rises ? rose : fell) = k;
      (rises ? fell : rose).reset();
      if (!before) {
        continue;
      }
      if (rises) {
        const Float lowest = zero_of_rate(grid_[*before], grid_[k]);
        if (at(0, lowest) > nearly_zero) {
          has_valley = true;
        } else {
          Float near = 1e-5L;  // or as far as it is flat
          while (near < 1 && at(0, lowest - near) < nearly_zero && at(0, lowest + near) < nearly_zero) {
            near *= 2;
          }
          const Rational zero = simplest(lowest - near, lowest + near);
          if (at(0, lowest) < -nearly_zero) {
            return {.below = number(lowest)};
          }
          if (!seems_zero({substitute(rates_[0], {{x_, zero}})}, {})) {
            return {};
          }
          result.places.push_back(zero);
          grid_[k] = zero.get_d();
          rose.reset();
          end_part(k);
          result.has_valley = true;
          continue;
        }
      }
      turns.insert(turns.end(), {*before, k});
    }
    end_part(grid_.size() - 1);
    if ((!lower_ && swings(0)) || (!upper_ && swings(grid_.size() - far_out))) {
      result.places.clear();
    }
    std::ranges::sort(result.places);
    result.places.erase(std::unique(result.places.begin(), result.places.end()), result.places.end());
    return result;
  }

 private:
  [[nodiscard]] static Rational number(Float place) { return static_cast<double>(place); }
  [[nodiscard]] Float at(std::size_t order, Float place) const {
    return estimated(rates_[order], {{x_, number(place)}});
  }

  // Whether it rises and falls far out, on some places of the grid from this one on.
  [[nodiscard]] bool swings(std::size_t start) const {
    constexpr Float least = 1e-6L;
    bool rises = false, falls = false;
    for (std::size_t k = start; k < start + far_out; ++k) {
      const Float slope = at(1, grid_[k]);
      rises = rises || slope > least;
      falls = falls || slope < -least;
    }
    return rises && falls;
  }

  [[nodiscard]] Float zero_of_rate(Float falling, Float rising) const {
    constexpr int halvings = 60;
    for (int k = 0; k < halvings; ++k) {
      const Float middle = (falling + rising) / 2;
      (at(1, middle) < 0 ? falling : rising) = middle;
    }
    return rising;
  }

  // Beside an end at which it is zero, and beyond the turns on the side of one that is far out.
  void add_cuts(std::size_t start, std::size_t end, const std::vector<std::size_t>& turns,
                std::vector<Rational>& places) {
    if (start == 0 && !lower_) {
      const Float first = turns.empty() ? grid_[end] : grid_[turns.front()];
      places.push_back(simplest(first - 1, first));
    } else if (at(0, grid_[start]) < nearly_zero) {
      add_beside(start, end, places);
    }
    if (end + 1 == grid_.size() && !upper_) {
      const Float last = turns.empty() ? grid_[start] : grid_[turns.back()];
      places.push_back(simplest(last, last + 1));
    } else if (at(0, grid_[end]) < nearly_zero) {
      add_beside(end, start, places);
    }
  }

  // From a zero about half as far as the first rate that is not zero there keeps its sign.
  void add_beside(std::size_t zero, std::size_t end, std::vector<Rational>& places) {
    constexpr std::size_t most = 5;
    std::size_t order = 1;
    while (order < most && std::abs(at(order, grid_[zero])) < nearly_zero) {
      if (++order == rates_.size()) {
        rates_.push_back(rate(rates_.back(), x_));
      }
    }
    std::size_t k = zero;
    while (k != end && (at(order, grid_[k]) > 0) == (at(order, grid_[zero]) > 0)) {
      k += zero < end ? 1 : -1UL;
    }
    const Float near = grid_[zero] + (grid_[k] - grid_[zero]) / 4,
                far = grid_[zero] + (grid_[k] - grid_[zero]) / 2;
    places.push_back(simplest(std::min(near, far), std::max(near, far)));
  }

  static constexpr std::size_t far_out = 16;
  static constexpr Float least_slope = 1e-12L;

  Variable x_;
  std::optional<Rational> lower_, upper_;
  std::vector<Term> rates_;  // f, f', …
  std::vector<Float> grid_;
};

}  // namespace

Term rate(const Term& f, const Variable& x) {
  const Variable t = fresh(real_number, {f, x});
  return Theorem::differentiate(lambda(t, substitute(f, {{x, t}})), x).conclusion().parts()[2];
}

Cuts cuts(const Term& f, const Variable& x, const std::optional<Rational>& lower,
          const std::optional<Rational>& upper) {
  return Graph(f, x, lower, upper).cuts();
}

}  // namespace stickslip::proofs::tactics
