// The zeros of f(u), 0 < u < 1, for every member of a box of parameters at once: how many there are, the same
// number for all, and each as a function of the parameters. Nothing here knows what f is.
//
// [0, 1] is cut into cells until on each f keeps a sign, or f' does, over the whole box. Where f' keeps its
// sign from one cell to the next f is monotone, and has one zero between different signs, none between equal
// ones.
#pragma once

#include <cmath>
#include <optional>
#include <tuple>
#include <variant>
#include <vector>

#include "numeric/atlas/question.hpp"
#include "numeric/scalars/form.hpp"
#include "numeric/scalars/jet.hpp"

namespace stickslip::numeric::atlas {

// u as the argument by which f is differentiated.
template <class T>
[[nodiscard]] scalars::Jet<T, 1> as_variable(const T& u) {
  return scalars::Jet<T, 1>::variable(u, 0);
}

// f has exactly one zero in [first, last], for every member of the box, and f' keeps its sign there: it lies
// between these bounds.
struct Bracket {
  double first, last;
  double least_slope, greatest_slope;
};

namespace detail {

// On a cell: f keeps the sign `value`, or else f' keeps the sign `slope`; 0 where that is not known.
struct Piece {
  double first, last;
  int value = 0, slope = 0;
  double least_slope = 0, greatest_slope = 0;
};

template <class S>
[[nodiscard]] int sign_of(const S& x) {
  return x.is_positive() ? 1 : x.is_negative() ? -1 : 0;
}

inline constexpr int most_cells = 500;

// From left to right; nothing if cells below the given length are not settled.
template <class S, int N, class F, class D>
[[nodiscard]] std::optional<std::vector<Piece>> pieces_of(const F& f, const D& df, double least) {
  using T = scalars::Form<S, N>;
  std::vector<Piece> pieces;
  std::vector<Piece> open;
  for (int k = 7; k >= 0; --k) {
    open.push_back({k / 8.0, (k + 1) / 8.0});
  }
  for (int examined = 0; !open.empty(); ++examined) {
    Piece cell = open.back();
    open.pop_back();
    const double middle = (cell.first + cell.last) / 2;  // exact, as are the cells
    const T u = T::variable(middle, cell.last - middle, 0);
    cell.value = sign_of(f(u).over);
    if (cell.value == 0) {
      const S slope = df(as_variable(u)).partials[0].over;
      cell.slope = sign_of(slope);
      std::tie(cell.least_slope, cell.greatest_slope) = scalars::ends(slope);
    }
    if (cell.value != 0 || cell.slope != 0) {
      pieces.push_back(cell);
    } else if (cell.last - cell.first > least && examined < most_cells) {
      open.push_back({middle, cell.last});
      open.push_back({cell.first, middle});
    } else {
      return std::nullopt;
    }
  }
  return pieces;
}

}  // namespace detail

// All zeros. f: Form -> Form and df, the same from jets of Forms; their variable 0 is free for u. `least` is
// how short cells may become.
template <class S, int N, class F, class D>
[[nodiscard]] std::variant<std::vector<Bracket>, Reason> zeros_over(const F& f, const D& df, double least) {
  using T = scalars::Form<S, N>;
  const auto pieces = detail::pieces_of<S, N>(f, df, least);
  if (!pieces) {
    return Reason::merging;
  }
  const auto sign_at_end = [&](int u) { return detail::sign_of(f(T(u)).over); };
  std::vector<Bracket> zeros;
  const std::size_t n = pieces->size();
  int before = (*pieces)[0].value != 0 ? 0 : sign_at_end(0);
  if ((*pieces)[0].value == 0 && before == 0) {
    return Reason::no_time;
  }
  for (std::size_t i = 0; i < n;) {
    const detail::Piece& piece = (*pieces)[i];
    if (piece.value != 0) {
      if (before != 0 && before != piece.value) {
        return Reason::merging;  // neighbours share a point: this cannot happen
      }
      before = piece.value;
      ++i;
      continue;
    }
    Bracket run{piece.first, piece.last, piece.least_slope, piece.greatest_slope};
    std::size_t last = i;
    for (; last + 1 < n && (*pieces)[last + 1].value == 0; ++last) {
      const detail::Piece& next = (*pieces)[last + 1];
      if (next.slope != piece.slope) {
        return Reason::merging;  // nor this
      }
      run = {piece.first, next.last, std::min(run.least_slope, next.least_slope),
             std::max(run.greatest_slope, next.greatest_slope)};
    }
    const int after = last + 1 < n ? (*pieces)[last + 1].value : sign_at_end(1);
    if (after == 0) {
      return Reason::no_time;
    }
    if (after != before) {
      if (after != piece.slope) {
        return Reason::merging;  // nor this
      }
      zeros.push_back(run);
    }
    before = after;
    i = last + 1;
  }
  return zeros;
}

// The zero as a function of the parameters: at the middle of the box, over it, and its slopes -f_i/f_u. The
// bracket is cut as long as f keeps a sign a quarter from one of its ends over the whole box; then follows
// Newton's interval operator, where the centre, a double, is only the point of expansion.
template <class S, int N, class F, class D>
[[nodiscard]] scalars::Form<S, N> zero_over(const F& f, const D& df, const Bracket& bracket) {
  using T = scalars::Form<S, N>;
  const bool rises = bracket.least_slope > 0;
  double first = bracket.first;
  double last = bracket.last;
  for (bool cut = true; cut && last - first > 0x1p-40;) {
    cut = false;
    for (const double share : {0.25, 0.75}) {
      const double u = first + share * (last - first);
      const int sign = detail::sign_of(f(T(S(u))).over);
      if (sign != 0) {
        (sign > 0) == rises ? last = u : first = u;
        cut = true;
      }
    }
  }
  S slope = scalars::around<S>(bracket.least_slope, bracket.greatest_slope);
  double centre = first + (last - first) / 2;
  T zero;
  for (int step = 0; step < 4; ++step) {
    const double before = last - first;
    const double reach = std::nextafter(std::max(last - centre, centre - first), INFINITY);
    const scalars::Jet<T, 1> around = df(as_variable(T::variable(centre, reach, 0)));
    if (around.partials[0].over.is_nonzero()) {
      slope = around.partials[0].over;
    }
    const T here = f(T(S(centre)));
    zero.at = S(centre) - here.at / slope;
    zero.over = S(centre) - here.over / slope;
    for (std::size_t i = 1; i < zero.slopes.size(); ++i) {
      zero.slopes[i] = -around.value.slopes[i] / slope;
    }
    zero.sharpen();
    const auto [low, high] = scalars::ends(zero.over);
    first = std::max(first, low);
    last = std::min(last, high);
    centre = std::clamp(zero.at.approximate(), first, last);
    if (step > 0 && last - first > 0.8 * before) {
      break;
    }
  }
  const S range = scalars::around<S>(first, last);
  zero.over = scalars::is_narrower(range, zero.over) ? range : zero.over;
  return zero;
}

}  // namespace stickslip::numeric::atlas
