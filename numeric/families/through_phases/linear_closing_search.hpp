// The definitions of linear_closing.hpp, for the source files of problems.
#pragma once

#include "numeric/families/through_phases/linear_closing.hpp"
#include "numeric/zeros/elimination.hpp"

namespace stickslip::numeric::families {

// What is left of the rows once the amplitudes are eliminated.
template <class P, class T>
using LoadRows = Eigen::Matrix<T, P::left, P::loads>;

template <class T>
[[nodiscard]] T det2(const T& a, const T& b, const T& c, const T& d) {
  return a * d - b * c;
}

// A problem's data over T, of those that it has, `exact` or `fast`, as lifted<T>() makes them of its data.
template <class T, class P>
[[nodiscard]] auto data_over(const P& problem) {
  if constexpr (std::is_constructible_v<T, scalars::HardwareBall>) {
    return lifted<T>(problem.fast);
  } else {
    return lifted<T>(problem.exact);
  }
}

template <class P, class T>
[[nodiscard]] AllRows<P, T> stacked(const FirstRows<P, T>& first, const OtherRows<P, T>& others) {
  AllRows<P, T> m;
  m.template topRows<P::first>() = first;
  m.template bottomRows<P::rows - P::first>() = others;
  return m;
}

template <class P, class T>
[[nodiscard]] AllRows<P, T> rows_at(const P& problem, const Unknowns<P, T>& x) {
  return stacked<P, T>(first_rows<T>(problem, x), other_rows<T>(problem, x));
}

// A cell in hardware balls, for a contraction.
template <int N>
struct HardwareBox {
  Eigen::Matrix<scalars::HardwareBall, N, 1> X, m, spread;

  explicit HardwareBox(const zeros::Box<N>& box) {
    for (int i = 0; i < N; ++i) {
      X(i) = scalars::HardwareBall(box(i));
      m(i) = scalars::HardwareBall(X(i).approximate());
      spread(i) = X(i) - m(i);
    }
  }
};

template <int N>
using FastJet = scalars::Jet<scalars::HardwareBall, N>;
template <int N>
using FastBox = Eigen::Matrix<scalars::HardwareBall, N, 1>;

template <int N>
[[nodiscard]] std::optional<FastBox<N>> contracted(const FastJet<N>& g, const scalars::HardwareBall& at_m,
                                                   const FastBox<N>& m, const FastBox<N>& X) {
  if (g.value.is_nonzero()) {
    return std::nullopt;
  }
  Eigen::Matrix<scalars::HardwareBall, 1, N> slope;
  for (int i = 0; i < N; ++i) {
    slope(i) = g.partials[static_cast<std::size_t>(i)];
  }
  return zeros::contract_by<N, scalars::HardwareBall>(at_m, slope, m, X);
}

namespace detail {

using scalars::HardwareBall;

template <int N>
zeros::Box<N> as_balls(const FastBox<N>& X) {
  return X.unaryExpr([](const HardwareBall& x) { return x.ball(); });
}

// The rows' combinations that make the amplitudes at the middle of a box simple.
template <class P, class S>
auto combinations_for(const AllRows<P, S>& at_m) {
  constexpr int R = P::rows, C = P::amplitudes + 1;
  const Eigen::Matrix<S, R, C> part = at_m.template leftCols<C>();
  return zeros::proposed_combinations<R, C>(part);
}

// Where more than two rows are left the same for cos psi and sin psi.
template <class P, class S>
auto combinations_for_load(const LoadRows<P, S>& at_m) {
  constexpr int K = P::left;
  if constexpr (K > 2 && P::loads == 3) {
    return zeros::proposed_combinations<K, 3>(at_m);
  } else {
    using Combinations = Eigen::Matrix<double, K, K>;
    return std::optional<Combinations>(Combinations::Identity());
  }
}

// What is left of combined rows; nothing where a pivot may vanish.
template <class P, class T>
std::optional<LoadRows<P, T>> left_for_load(AllRows<P, T> m) {
  if (!zeros::eliminate<T, P::rows, P::columns>(m, 0, P::amplitudes)) {
    return std::nullopt;
  }
  return LoadRows<P, T>(m.template bottomRightCorner<P::left, P::loads>());
}

template <class P, class T>
Eigen::Matrix<T, 3, 1> direction(const LoadRows<P, T>& m, int i, int j) {
  const auto minor = [&](int k, int l) { return det2<T>(m(i, k), m(i, l), m(j, k), m(j, l)); };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

template <class T>
T circle(const Eigen::Matrix<T, 3, 1>& n) {
  return n(0) * n(0) + n(1) * n(1) - n(2) * n(2);
}

// What must vanish.
template <class P, class T>
Unknowns<P, T> functions(const LoadRows<P, T>& m) {
  if constexpr (P::loads == 1) {
    return m;
  } else {
    const Eigen::Matrix<T, 3, 1> n = direction<P, T>(m, 0, 1);
    Unknowns<P, T> f;
    f(0) = circle<T>(n);
    for (int i = 1; i < P::times; ++i) {
      f(i) = m(i + 1, 0) * n(0) + m(i + 1, 1) * n(1) + m(i + 1, 2) * n(2);
    }
    return f;
  }
}

// What each two rows leave.
template <class P>
std::optional<FastBox<P::times>> contracted_by_pairs(const LoadRows<P, FastJet<P::times>>& over,
                                                     const LoadRows<P, HardwareBall>& at_m,
                                                     const HardwareBox<P::times>& box,
                                                     std::optional<FastBox<P::times>> rest) {
  constexpr int N = P::times;
  for (int i = 0; i < P::left && rest; ++i) {
    for (int j = i + 1; j < P::left && rest; ++j) {
      Eigen::Matrix<FastJet<N>, 3, 1> n = direction<P, FastJet<N>>(over, i, j);
      const Eigen::Matrix<HardwareBall, 3, 1> n_at_m = direction<P, HardwareBall>(at_m, i, j);
      zeros::sharpen<3, 1, N>(n, n_at_m, box.spread);
      rest = contracted<N>(circle<FastJet<N>>(n), circle<HardwareBall>(n_at_m), box.m, *rest);
    }
  }
  return rest;
}

// Whether a row allows some cos psi and sin psi: |1's part| is at most the length of the other two.
template <class P>
bool load_is_possible(const LoadRows<P, FastJet<P::times>>& m) {
  if constexpr (P::loads == 3) {
    for (int i = 0; i < P::left; ++i) {
      const HardwareBall &a = m(i, 0).value, &b = m(i, 1).value, &c = m(i, 2).value;
      if ((c * c - a * a - b * b).is_positive()) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace detail

template <class P>
template <class T>
Unknowns<P, T> LinearEliminant<P>::at(const Unknowns<P, T>& x) const {
  const auto left = detail::left_for_load<P, T>(
      zeros::combined_rows<T, P::rows, P::columns>(combinations, rows_at<P, T>(problem, x)));
  return left ? detail::functions<P, T>(*left) : Unknowns<P, T>(Unknowns<P, T>::Constant(T(1) / T(0)));
}

template <class P>
std::optional<Linear<P>> LinearEliminant<P>::linear(const Box& x) const {
  AllRows<P, Ball> m =
      zeros::combined_rows<Ball, P::rows, P::columns>(combinations, rows_at<P, Ball>(problem, x));
  if (!zeros::eliminate<Ball, P::rows, P::columns>(m, 0, P::amplitudes)) {
    return std::nullopt;
  }
  Linear<P> result;
  Eigen::Matrix<Ball, P::loads, 1> load = Eigen::Matrix<Ball, P::loads, 1>::Constant(Ball(1));
  if constexpr (P::loads == 3) {
    const LoadRows<P, Ball> left = m.template bottomRightCorner<P::left, P::loads>();
    const Eigen::Matrix<Ball, 3, 1> n = detail::direction<P, Ball>(left, 0, 1);
    if (!n(2).is_nonzero()) {
      return std::nullopt;
    }
    load(0) = n(0) / n(2);
    load(1) = n(1) / n(2);
    result.cos_sin_psi = {load(0), load(1)};
  }
  Eigen::Matrix<Ball, P::amplitudes, 1>& u = result.amplitudes;
  for (int k = P::amplitudes - 1; k >= 0; --k) {
    Ball sum(0);
    for (int j = k + 1; j < P::columns; ++j) {
      sum += m(k, j) * (j < P::amplitudes ? u(j) : load(j - P::amplitudes));
    }
    u(k) = -sum / m(k, k);
  }
  return result;
}

template <class P>
std::optional<LinearEliminant<P>> LinearEliminant<P>::near(const P& problem, const Box& X) {
  constexpr int R = P::rows, C = P::columns, K = P::left;
  const AllRows<P, Ball> at_m = rows_at<P, Ball>(problem, zeros::midpoint<P::times>(X));
  const auto proposed = detail::combinations_for<P, Ball>(at_m);
  if (!proposed) {
    return std::nullopt;
  }
  Eigen::Matrix<Ball, R, R> combinations = proposed->template cast<Ball>();
  const auto left = detail::left_for_load<P, Ball>(zeros::combined_rows<Ball, R, C>(combinations, at_m));
  const auto further = left ? detail::combinations_for_load<P, Ball>(*left) : std::nullopt;
  if (!further) {
    return std::nullopt;
  }
  combinations.template bottomRows<K>() =
      zeros::product(further->template cast<Ball>(), combinations.template bottomRows<K>()).eval();
  if (!zeros::is_invertible(combinations)) {
    return std::nullopt;
  }
  return LinearEliminant<P>{problem, combinations};
}

// Rows that hold still do when they are combined.
template <class P>
auto LinearEliminant<P>::contract(const P& problem, const Box& X) -> std::optional<Box> {
  using scalars::HardwareBall;
  constexpr int N = P::times, R = P::rows, C = P::columns, K = P::left, L = P::loads;
  using Jets = FastJet<N>;
  if (is_excluded(problem, X)) {
    return std::nullopt;
  }
  const HardwareBox<N> box(X);
  const Eigen::Matrix<Jets, N, 1> x = scalars::variables<HardwareBall, N>(box.X);
  const auto first = first_rows<Jets>(problem, x);
  const auto first_at_m = first_rows<HardwareBall>(problem, box.m);
  std::optional<FastBox<N>> rest = look(problem, first, first_at_m, box);
  if (!rest) {
    return std::nullopt;
  }
  AllRows<P, HardwareBall> at_m =
      stacked<P, HardwareBall>(first_at_m, other_rows<HardwareBall>(problem, box.m));
  AllRows<P, Jets> over = stacked<P, Jets>(first, other_rows<Jets>(problem, x));
  const auto combinations = zeros::proposed_combinations<P::amplitudes, R, C, N>(at_m, over);
  if (!combinations) {
    return detail::as_balls<N>(*rest);
  }
  over = zeros::combined_rows<Jets, R, C>(*combinations, over);
  at_m = zeros::combined_rows<HardwareBall, R, C>(*combinations, at_m);
  zeros::sharpen<R, C, N>(over, at_m, box.spread);
  auto left_over = detail::left_for_load<P, Jets>(over);
  auto left_at_m = detail::left_for_load<P, HardwareBall>(at_m);
  if (!left_over || !left_at_m) {
    return detail::as_balls<N>(*rest);
  }
  zeros::sharpen<K, L, N>(*left_over, *left_at_m, box.spread);
  if (!detail::load_is_possible<P>(*left_over)) {
    return std::nullopt;
  }
  if constexpr (L == 3) {
    rest = detail::contracted_by_pairs<P>(*left_over, *left_at_m, box, rest);
  }
  if constexpr (L == 3 && K > 2) {
    // Before, what is wide is in as few rows as can be; now cos psi, sin psi and what must vanish are apart.
    const auto further = zeros::proposed_combinations<2, K, L, N>(*left_at_m, *left_over);
    if (!rest || !further) {
      return rest ? std::optional(detail::as_balls<N>(*rest)) : std::nullopt;
    }
    left_over = zeros::combined_rows<Jets, K, L>(*further, *left_over);
    left_at_m = zeros::combined_rows<HardwareBall, K, L>(*further, *left_at_m);
    zeros::sharpen<K, L, N>(*left_over, *left_at_m, box.spread);
    rest = detail::contracted_by_pairs<P>(*left_over, *left_at_m, box, rest);
  }
  const auto f = detail::functions<P, Jets>(*left_over);
  const FastBox<N> f_at_m = detail::functions<P, HardwareBall>(*left_at_m);
  for (int i = 0; i < N && rest; ++i) {
    rest = contracted<N>(f(i), f_at_m(i), box.m, *rest);
  }
  if (!rest) {
    return std::nullopt;
  }
  const auto image =
      zeros::krawczyk_image<N, HardwareBall>(box.m, f_at_m, scalars::jacobian<HardwareBall, N, N>(f), box.X);
  for (int i = 0; i < N && image; ++i) {
    const std::optional<HardwareBall> side = scalars::intersection((*image)(i), (*rest)(i));
    if (!side) {
      return std::nullopt;
    }
    (*rest)(i) = *side;
  }
  return detail::as_balls<N>(*rest);
}

template <class P>
zeros::ZeroProof<P::times> LinearEliminant<P>::decide(const P& problem, const Box& X) {
  const auto f = near(problem, X);
  if (!f) {
    return {Verdict::undecided(dependent), X, X};
  }
  zeros::ZeroProof<P::times> decision = zeros::decide_by_krawczyk<P::times>(*f, X);
  if (decision.verdict.truth == Truth::proved && !f->linear(decision.box)) {
    decision.verdict = Verdict::undecided("the load's phase may be undetermined");
  }
  return decision;
}

}  // namespace stickslip::numeric::families
