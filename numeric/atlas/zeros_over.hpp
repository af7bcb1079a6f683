// The zeros of f(u), 0 < u < 1, for every member of a box of parameters at once: how many there are, the same
// number for all, and each as a function of the parameters. Nothing here knows what f is.
//
// [0, 1] is cut into cells until on each f keeps a sign, or f' does, over the whole box. Where f' keeps its
// sign from one cell to the next f is monotone, and has one zero between different signs, none between equal
// ones.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <variant>
#include <vector>

#include "numeric/atlas/along.hpp"
#include "numeric/atlas/knowledge.hpp"
#include "numeric/atlas/question.hpp"
#include "numeric/scalars/form.hpp"
#include "numeric/scalars/jet.hpp"

namespace stickslip::numeric::atlas {

// u as the argument by which f is differentiated.
template <class T>
[[nodiscard]] scalars::Jet<T, 1> as_variable(const T& u) {
  return scalars::Jet<T, 1>::variable(u, 0);
}

namespace detail {

inline constexpr int most_cells = 500;
inline constexpr double longest_cell = 0.25;

}  // namespace detail

// Cuts what is not known of the cells until it is, or cells would be shorter than `least`. f: Form -> Form
// and df, the same from jets of Forms; their variable 0 is free for u.
template <class S, int N, class F, class D>
[[nodiscard]] std::vector<Cell> settled(const F& f, const D& df, const std::vector<Cell>& cells,
                                        double least) {
  using T = scalars::Form<S, N>;
  std::vector<Cell> result;
  std::vector<Cell> todo(cells.rbegin(), cells.rend());
  for (int examined = 0; !todo.empty();) {
    Cell cell = todo.back();
    todo.pop_back();
    if (cell.value != 0 || cell.slope != 0 || examined >= detail::most_cells) {
      result.push_back(cell);
      continue;
    }
    const double middle = (cell.first + cell.last) / 2;  // exact, as are the cells
    bool hopeless = false;
    if (cell.last - cell.first <= detail::longest_cell) {
      ++examined;
      const T u = T::variable(middle, cell.last - middle, 0);
      const T value = f(u);
      cell.value = scalars::sign_of(value.over);
      const auto keep_slope = [&](const S& slope) {
        cell.slope = scalars::sign_of(slope);
        std::tie(cell.least_slope, cell.greatest_slope) = scalars::ends(slope);
      };
      if (cell.value == 0) {
        keep_slope(value.slopes[0] / S(cell.last - middle));
      }
      if (cell.value == 0 && !vary_less_than(1.5, cell.least_slope, cell.greatest_slope)) {
        const T slope = df(as_variable(u)).partials[0];
        keep_slope(slope.over);
        if (cell.slope == 0) {
          // Where f bends away from zero its least distance tells.
          const int side = scalars::sign_of(slope.slopes[0]);
          const T away(side);
          const T half = T(S(cell.last - middle));
          const auto at = [&](double e) {
            const auto here = df(as_variable(T(S(middle + e * (cell.last - middle)))));
            return std::array<T, 2>{away * here.value, away * here.partials[0]};
          };
          const auto bent = convex<T>({away * value, away * slope}, half, false, false, at);
          if (bent && bent->is_proved) {
            cell.value = side;
          } else if (bent && !bent->is_refuted) {
            hopeless = !bent->least.over_from(1).is_nonzero();
            cell.hope = hope_of(bent->least, 1);
          } else {
            hopeless = is_left_open_by_parameters(value) && is_left_open_by_parameters(slope);
            const Hope of_value = hope_of(value, 1);
            cell.hope = of_value.is_promising ? of_value : hope_of(slope, 1);
          }
        }
      }
    }
    if (cell.value != 0 || cell.slope != 0 || hopeless || cell.last - cell.first <= least) {
      result.push_back(cell);
    } else {
      todo.push_back({middle, cell.last});
      todo.push_back({cell.first, middle});
    }
  }
  return result;
}

// All zeros, of which these cells tell, or why not; sign_at_end(u) is the sign of f at u = 0 or 1.
template <class Sign>
[[nodiscard]] std::variant<std::vector<Bracket>, Reason> zeros_between(const std::vector<Cell>& cells,
                                                                       const Sign& sign_at_end) {
  const std::size_t n = cells.size();
  for (const Cell& cell : cells) {
    if (cell.value == 0 && cell.slope == 0) {
      return Reason::merging;
    }
  }
  std::vector<Bracket> zeros;
  int before = cells[0].value != 0 ? 0 : sign_at_end(0);
  if (cells[0].value == 0 && before == 0) {
    return Reason::no_time;
  }
  for (std::size_t i = 0; i < n;) {
    const Cell& cell = cells[i];
    if (cell.value != 0) {
      if (before != 0 && before != cell.value) {
        return Reason::merging;  // neighbours share a point: this cannot happen
      }
      before = cell.value;
      ++i;
      continue;
    }
    Bracket run{cell.first, cell.last, cell.least_slope, cell.greatest_slope, 0};
    std::size_t last = i;
    for (; last + 1 < n && cells[last + 1].value == 0; ++last) {
      const Cell& next = cells[last + 1];
      if (next.slope != cell.slope) {
        return Reason::merging;  // nor this
      }
      run = {cell.first, next.last, std::min(run.least_slope, next.least_slope),
             std::max(run.greatest_slope, next.greatest_slope), 0};
    }
    const int after = last + 1 < n ? cells[last + 1].value : sign_at_end(1);
    if (after == 0) {
      return Reason::no_time;
    }
    if (after != before) {
      if (after != cell.slope) {
        return Reason::merging;  // nor this
      }
      zeros.push_back(run);
    }
    before = after;
    i = last + 1;
  }
  return zeros;
}

// The zero as a function of the parameters: at the middle of the box, over it, and its slopes -f_i/f_u, by
// Newton's interval operator, where the centre, a double, is only the point of expansion. For every member
//   0 = f(centre, 0) + f_u (u - centre) + sum of f_i e_i,
// with slopes over the bracket and the box, all of which one form of f tells; f_u is told better by the jet,
// which is asked where it varies. While it varies much the bracket is cut where f keeps a sign a quarter from
// one of its ends over the whole box. What is found out of the bracket is left there.
template <class S, int N, class F, class D>
[[nodiscard]] scalars::Form<S, N> zero_over(const F& f, const D& df, Bracket& bracket) {
  using T = scalars::Form<S, N>;
  constexpr int most_steps = 4;
  constexpr double little = 1.05, tight = 1.2;
  double& first = bracket.first;
  double& last = bracket.last;
  const bool rises = bracket.least_slope + bracket.greatest_slope > 0;
  for (bool cut = !bracket.is_straight(); cut && last - first > 0x1p-40;) {
    cut = false;
    for (const double share : {0.25, 0.75}) {
      const double u = first + share * (last - first);
      const int sign = scalars::sign_of(f(T(S(u))).over);
      if (sign != 0) {
        (sign > 0) == rises ? last = u : first = u;
        cut = true;
      }
    }
  }
  S slope = scalars::around<S>(bracket.least_slope, bracket.greatest_slope);
  double centre = first + (last - first) / 2;
  T zero;
  for (int k = 0; k < most_steps; ++k) {
    const double before = last - first;
    const double reach = scalars::reach(first, centre, last);
    const T u = T::variable(centre, reach, 0);
    const bool varies = !vary_less_than(little, bracket.least_slope, bracket.greatest_slope);
    const scalars::Jet<T, 1> jet = varies ? df(as_variable(u)) : scalars::Jet<T, 1>(f(u));
    const T& around = jet.value;
    const S found = varies ? jet.partials[0].over : S(around.slopes[0] / S(reach));
    if (found.is_nonzero() && scalars::is_narrower(found, slope)) {
      slope = found;
      std::tie(bracket.least_slope, bracket.greatest_slope) = scalars::ends(slope);
    }
    zero.at = S(centre) - around.at / slope;
    zero.over = S(centre) - around.over_from(1) / slope;
    for (std::size_t i = 1; i < zero.slopes.size(); ++i) {
      zero.slopes[i] = -around.slopes[i] / slope;
    }
    bracket.steepest = hope_of(around, 1).steepest;
    const auto [low, high] = scalars::ends(zero.over);
    first = std::max(first, low);
    last = std::min(last, high);
    centre = std::clamp(zero.at.approximate(), first, last);
    if ((k > 0 || vary_less_than(tight, bracket.least_slope, bracket.greatest_slope)) &&
        last - first > 0.8 * before) {
      break;
    }
  }
  zero.sharpen();
  const S range = scalars::around<S>(first, last);
  zero.over = scalars::is_narrower(range, zero.over) ? range : zero.over;
  return zero;
}

// Next to a fold: there a zero u of f moves fast with a parameter q, and says little of the motion at the
// zero; but q is a function of u, and of the other parameters, that hardly varies.

template <class T>
struct SteepZero {
  T u;  // the k-th variable of the forms, over all of the bracket
  T q;  // the parameter that was this variable, at the zero
};

// For each member of a box the zero u in the bracket, and its parameter q, are among these, which reach
// somewhat beyond the box. f(u, q): Form -> Form, at the other parameters of the box; `axis` is q as the k-th
// variable. Nothing where q may be no function of u.
//
// With e, e_q and e_i the shares of u, q and the other parameters, |·| <= 1, and slopes over all of them,
//   f = f(0) + f_u e + f_q e_q + sum of f_i e_i.
// If f_q ≠ 0 and E = -(f(0) + f_u [-1, 1] + sum of f_i [-1, 1])/f_q lies within (-1, 1), then for all e and
// e_i there is exactly one e_q in [-1, 1] with f = 0, and its slopes are -f_u/f_q and -f_i/f_q.
template <class S, int N, class F>
[[nodiscard]] std::optional<SteepZero<scalars::Form<S, N>>> steep_zero(const F& f, const Bracket& zero, int k,
                                                                       const scalars::Form<S, N>& axis) {
  using T = scalars::Form<S, N>;
  const auto place = static_cast<std::size_t>(k);
  const double centre = axis.at.approximate();
  double radius = 1.25 * axis.slopes[place].approximate();
  for (int attempt = 0; attempt < 3; ++attempt) {
    const T value = f(T::variable_between(zero.first, zero.last, 0), T::variable(centre, radius, k));
    const S& by_q = value.slopes[place];
    if (!by_q.is_nonzero()) {
      return std::nullopt;
    }
    T share;  // e_q, with e as the k-th variable
    share.at = -value.at / by_q;
    for (std::size_t i = 1; i < share.slopes.size(); ++i) {
      share.slopes[i] = -value.slopes[i == place ? 0 : i] / by_q;
    }
    share.over = share.at + scalars::sway(share.slopes);
    const auto [low, high] = scalars::ends(share.over);
    if (low > -1 && high < 1) {
      return SteepZero<T>{T::variable_between(zero.first, zero.last, k),
                          T(T(S(centre)) + T(S(radius)) * share)};
    }
    const double needed = 1.25 * std::max(std::abs(low), std::abs(high));
    if (!(needed < 16)) {
      return std::nullopt;
    }
    radius *= std::max(needed, 1.25);
  }
  return std::nullopt;
}

}  // namespace stickslip::numeric::atlas
