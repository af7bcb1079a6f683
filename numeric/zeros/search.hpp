// Branch and prune: all zeros in a box, with nothing lost. Nothing here knows what the function is.
//
// Three things, each small. A contractor takes a box and returns a smaller one that still holds every zero of
// it, or nothing when there is none. A decider says whether a box, slightly enlarged, holds exactly one zero.
// The search splits what neither settles. The union of the excluded cells, the unique boxes of the zeros and
// the unresolved cells covers the whole closed domain.
#pragma once

#include <array>
#include <deque>
#include <string>
#include <tuple>
#include <vector>

#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/zeros/effort.hpp"
#include "numeric/zeros/krawczyk.hpp"

namespace stickslip::numeric::zeros {

// Why something is open that was not looked at any more.
inline constexpr const char * was_interrupted = "the search was interrupted";

// A closed box whose ends are exactly these doubles: cells share their faces and leave no gap.
template <int N>
struct Cell {
  std::array<double, N> lower;
  std::array<double, N> upper;
};

// A box of balls that contains the cell.
template <int N>
[[nodiscard]] Box<N> to_box(const Cell<N>& cell) {
  Box<N> box;
  for (std::size_t i = 0; i < N; ++i) {
    box(static_cast<int>(i)) = Ball::hull(Ball(cell.lower[i]), Ball(cell.upper[i]));
  }
  return box;
}

// The part of `cell` that can meet `box`, rounded outwards; nothing when they are disjoint.
template <int N>
[[nodiscard]] std::optional<Cell<N>> clip(const Cell<N>& cell, const Box<N>& box) {
  Cell<N> result = cell;
  for (std::size_t i = 0; i < N; ++i) {
    const Ball& side = box(static_cast<int>(i));
    if (!side.is_finite()) {
      continue;
    }
    const auto [low, high] = scalars::ends(side);
    result.lower[i] = std::max(cell.lower[i], low);
    result.upper[i] = std::min(cell.upper[i], high);
    if (result.lower[i] > result.upper[i]) {
      return std::nullopt;
    }
  }
  return result;
}

// The largest such box inside; its lower ends may be above its upper ones.
template <int N>
[[nodiscard]] Cell<N> inside(const Box<N>& box) {
  Cell<N> result;
  for (std::size_t i = 0; i < N; ++i) {
    std::tie(result.lower[i], result.upper[i]) = scalars::inner_ends(box(static_cast<int>(i)));
  }
  return result;
}

template <int N>
[[nodiscard]] bool contains(const Cell<N>& outer, const Cell<N>& inner) {
  for (std::size_t i = 0; i < N; ++i) {
    if (!(outer.lower[i] <= inner.lower[i] && inner.upper[i] <= outer.upper[i])) {
      return false;
    }
  }
  return true;
}

template <int N>
struct UnresolvedBox {
  Box<N> box;
  std::string reason;
};

struct SearchLimits {
  double smallest = 0x1p-24;  // cells whose sides are all below this are left unresolved
  long cells = 4000;          // and so is what remains after this many, or when effort.hpp says so
};

template <int N>
struct SearchResult {
  std::vector<ZeroProof<N>> zeros;           // pairwise different
  std::vector<UnresolvedBox<N>> unresolved;  // neighbours with the same reason joined
  long cells = 0;                            // examined

  [[nodiscard]] bool complete() const { return unresolved.empty(); }
};

inline constexpr const char * no_progress = "the zero cannot be distinguished from a multiple one";

namespace detail {

// Whether a contractor got so far that a proof of uniqueness is worth trying. A side that is small enough to
// be given up need not shrink any more: it may be as short as doubles allow while the others are still long.
template <int N>
[[nodiscard]] bool shrunk(const Cell<N>& part, const Cell<N>& whole, double smallest) {
  for (std::size_t i = 0; i < N; ++i) {
    const double side = part.upper[i] - part.lower[i];
    if (side >= smallest && side > 0.9 * (whole.upper[i] - whole.lower[i])) {
      return false;
    }
  }
  return true;
}

template <int N>
[[nodiscard]] std::size_t longest_side(const Cell<N>& cell) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < N; ++i) {
    if (cell.upper[i] - cell.lower[i] > cell.upper[longest] - cell.lower[longest]) {
      longest = i;
    }
  }
  return longest;
}

// What came of a cell: nothing if it holds no zero that is not known.
template <int N>
struct Examined {
  std::optional<Cell<N>> rest;  // the part that may hold zeros
  ZeroProof<N> decision;        // about it
  bool interrupted = false;     // before anything was done
};

// Cells that are examined at the same time.
inline constexpr long batch = 32;

// Adds a zero unless it is one that is known. Two proofs are of the same zero when the enclosure of one lies
// where the other is unique; they are of different zeros when their enclosures are disjoint.
template <int N>
void record(SearchResult<N>& result, const ZeroProof<N>& found) {
  for (const ZeroProof<N>& known : result.zeros) {
    if (contains<N>(known.unique, found.box) || contains<N>(found.unique, known.box)) {
      return;
    }
    if (intersection<N>(known.box, found.box)) {
      result.unresolved.push_back({found.box, "two proved zeros could not be distinguished"});
      return;
    }
  }
  result.zeros.push_back(found);
}

// Joins an unresolved cell to a neighbour that it touches and that has the same reason.
template <int N>
void leave_open(SearchResult<N>& result, const Box<N>& box, const std::string& reason) {
  for (UnresolvedBox<N>& known : result.unresolved) {
    if (known.reason == reason && intersection<N>(known.box, box)) {
      for (int i = 0; i < N; ++i) {
        known.box(i) = Ball::hull(known.box(i), box(i));
      }
      return;
    }
  }
  result.unresolved.push_back({box, reason});
}

}  // namespace detail

// Every zero in the domain; after an interruption (core/interruption.hpp) the cells that are still open are
// left unresolved. contract: Box<N> -> optional<Box<N>>; decide: Box<N> -> ZeroProof<N>, proved: of exactly
// one zero in a box that contains the one asked about; refuted: the one asked about has none; both are called
// from several threads at once. A zero of the result may lie just outside the domain, where its enclosure
// reaches across the boundary: the caller refines it and looks. halved: Cell<N> -> which side is to be
// halved; the longest one is where that is below the smallest.
template <int N, class Contract, class Decide, class Halved = std::size_t(const Cell<N>&)>
[[nodiscard]] SearchResult<N> search(const Cell<N>& domain, const Contract& contract, const Decide& decide,
                                     const SearchLimits& limits = {},
                                     const Halved& halved = detail::longest_side<N>) {
  SearchResult<N> result;
  std::vector<Cell<N>> unique;  // of the zeros
  const auto is_known = [&](const Cell<N>& cell) {
    return std::any_of(unique.begin(), unique.end(),
                       [&](const Cell<N>& known) { return contains<N>(known, cell); });
  };
  const auto examine = [&](const Cell<N>& whole) -> detail::Examined<N> {
    if (interrupted()) {
      return {whole, {}, true};
    }
    if (is_known(whole)) {
      return {};
    }
    const std::optional<Box<N>> contracted = contract(to_box<N>(whole));
    const std::optional<Cell<N>> cell = contracted ? clip<N>(whole, *contracted) : std::nullopt;
    if (!cell || is_known(*cell)) {
      return {};
    }
    ZeroProof<N> decision{Verdict::undecided(no_progress), {}, {}};
    if (detail::shrunk<N>(*cell, whole, limits.smallest)) {
      decision = decide(to_box<N>(*cell));
      if (!detail::shrunk<N>(*cell, whole, 0)) {
        decision.verdict.reason = no_progress;
      }
    }
    return {cell, decision};
  };
  std::deque<Cell<N>> open{domain};
  const auto settle = [&](const detail::Examined<N>& examined) {
    if (!examined.rest || is_known(*examined.rest)) {
      return;
    }
    const Cell<N>& cell = *examined.rest;
    const Verdict& decided = examined.decision.verdict;
    if (examined.interrupted) {
      detail::leave_open<N>(result, to_box<N>(cell), was_interrupted);
      return;
    }
    if (decided.truth == Truth::proved) {
      detail::record<N>(result, examined.decision);
      unique.push_back(inside<N>(examined.decision.unique));
    }
    if (decided.truth == Truth::proved || decided.truth == Truth::refuted) {
      return;
    }
    const auto is_small = [&](std::size_t side) {
      return cell.upper[side] - cell.lower[side] < limits.smallest;
    };
    const std::size_t proposed = halved(cell);
    const std::size_t i = is_small(proposed) ? detail::longest_side<N>(cell) : proposed;
    if (is_small(i)) {
      detail::leave_open<N>(result, to_box<N>(cell), decided.reason);
      return;
    }
    const double middle = cell.lower[i] + (cell.upper[i] - cell.lower[i]) / 2;
    Cell<N> right = cell;
    Cell<N> left = cell;
    left.upper[i] = middle;
    right.lower[i] = middle;
    open.push_back(right);
    open.push_back(left);
  };
  const Limit limit(limits.cells);
  while (!open.empty() && !limit.reached(result.cells)) {
    // A batch's cells know the zeros of earlier batches only, however many threads examine them.
    const auto size =
        std::min<long>({detail::batch, static_cast<long>(open.size()), limit.cells() - result.cells});
    const std::vector<Cell<N>> batch(open.begin(), open.begin() + size);
    open.erase(open.begin(), open.begin() + size);
    result.cells += size;
    for (const auto& examined :
         parallel_map(batch.size(), [&](std::size_t i) { return examine(batch[i]); })) {
      settle(examined);
    }
  }
  for (const Cell<N>& cell : open) {
    detail::leave_open<N>(result, to_box<N>(cell), *limit.reached(result.cells));
  }
  return result;
}

// The part of X that a single equation g = 0 leaves, from its mean value form g(m) + slope (X - m): solved
// for each coordinate in turn. Nothing when g has no zero in X.
template <int N, class S>
[[nodiscard]] std::optional<Eigen::Matrix<S, N, 1>> contract_by(const S& at_m,
                                                                const Eigen::Matrix<S, 1, N>& slope,
                                                                const Eigen::Matrix<S, N, 1>& m,
                                                                Eigen::Matrix<S, N, 1> X) {
  Eigen::Matrix<S, N, 1> share;
  S sum = at_m;
  for (int i = 0; i < N; ++i) {
    share(i) = slope(i) * (X(i) - m(i));
    sum += share(i);
  }
  if (sum.is_nonzero()) {
    return std::nullopt;
  }
  for (int i = 0; i < N; ++i) {
    if (!slope(i).is_nonzero()) {
      continue;
    }
    S others = at_m;
    for (int j = 0; j < N; ++j) {
      others += j == i ? S(0) : share(j);
    }
    const std::optional<S> side = intersection(X(i), S(m(i) - others / slope(i)));
    if (!side) {
      return std::nullopt;
    }
    X(i) = *side;
    share(i) = slope(i) * (X(i) - m(i));
  }
  return X;
}

// The contractor and the decider that Krawczyk's operator gives for f (see krawczyk.hpp). By the sign of f,
// by each equation's mean value form, and by the operator; by its test of a box a little larger than X.
template <int N, class F>
[[nodiscard]] std::optional<Box<N>> contract_by_krawczyk(const F& f, const Box<N>& X) {
  const auto [value, slope] = linearise<Ball, N>(f, X);
  const Box<N> m = midpoint<N>(X);
  const Box<N> at_m = f(m);
  std::optional<Box<N>> rest = X;
  for (int i = 0; i < N && rest; ++i) {
    rest = value(i).is_nonzero() ? std::nullopt : contract_by<N, Ball>(at_m(i), slope.row(i), m, *rest);
  }
  if (!rest) {
    return std::nullopt;
  }
  const std::optional<Box<N>> K = krawczyk_image<N>(m, at_m, slope, X);
  return K ? intersection<N>(*K, *rest) : rest;
}
template <int N, class F>
[[nodiscard]] ZeroProof<N> decide_by_krawczyk(const F& f, const Box<N>& X) {
  return krawczyk_test<N>(f, inflate<N>(X, 1.25));
}

}  // namespace stickslip::numeric::zeros
