#include "numeric/words/eliminated_phase.hpp"

namespace stickslip::numeric::words {

using namespace motion;
using namespace zeros;
using scalars::HardwareBall;
using scalars::Jet;

namespace {

constexpr int states = 3;  // columns to be eliminated

template <class T, int N>
using LoadRows = Eigen::Matrix<T, N + 1, 3>;

// What is left of combined rows; nothing where a pivot may vanish.
template <class T, int N>
std::optional<LoadRows<T, N>> left_for_load(ClosingRows<T, N> m) {
  if (!eliminate<T, closing_rows<N>, closing_columns>(m, 0, states)) {
    return std::nullopt;
  }
  return LoadRows<T, N>(m.template bottomRightCorner<N + 1, 3>());
}

template <class T, int N>
Eigen::Matrix<T, 3, 1> direction(const LoadRows<T, N>& m, int i, int j) {
  const auto minor = [&](int k, int l) { return T(m(i, k) * m(j, l) - m(i, l) * m(j, k)); };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

template <class T>
T circle(const Eigen::Matrix<T, 3, 1>& n) {
  return n(0) * n(0) + n(1) * n(1) - n(2) * n(2);
}

// The first two rows' direction meets the circle, and the third row.
template <class T, int N>
Eigen::Matrix<T, N, 1> functions(const LoadRows<T, N>& m) {
  const Eigen::Matrix<T, 3, 1> n = direction<T, N>(m, 0, 1);
  Eigen::Matrix<T, N, 1> f;
  f(0) = circle<T>(n);
  if constexpr (N == 2) {
    f(1) = m(2, 0) * n(0) + m(2, 1) * n(1) + m(2, 2) * n(2);
  }
  return f;
}

// The rows' combinations that make the state at the middle of a box simple.
template <int N, class S>
auto combinations_for(const ClosingRows<S, N>& at_m) {
  const Eigen::Matrix<S, closing_rows<N>, states + 1> part = at_m.template leftCols<states + 1>();
  return row_combinations<closing_rows<N>, states + 1>(part);
}

// With two times the same for cos phi and sin phi, for what is left then.
template <int N, class S>
std::optional<Eigen::Matrix<S, N + 1, N + 1>> combinations_for_load(const LoadRows<S, N>& at_m) {
  if constexpr (N == 2) {
    return row_combinations<N + 1, 3>(at_m);
  } else {
    return Eigen::Matrix<S, N + 1, N + 1>(Eigen::Matrix<S, N + 1, N + 1>::Identity());
  }
}

template <class T, int N, class S>
ClosingRows<T, N> rows_at(const ClosingData<S>& data, const Eigen::Matrix<T, N, 1>& x) {
  const ClosingData<T> d = data.template lifted<T>();
  return rows_of_closing<T, N>(d, ClosingProblem<N>::template times<T>(d.total, x));
}

// Whether a row allows some cos phi and sin phi: |1's part| is at most the length of the other two.
template <int N>
bool is_possible(const LoadRows<Jet<HardwareBall, N>, N>& m) {
  for (int i = 0; i <= N; ++i) {
    const HardwareBall &a = m(i, 0).value, &b = m(i, 1).value, &c = m(i, 2).value;
    if ((c * c - a * a - b * b).is_positive()) {
      return false;
    }
  }
  return true;
}

ClosingData<HardwareBall> in_hardware(const ClosingData<Ball>& d) {
  return d.template lifted<HardwareBall>();
}

// n/omega a whole number: why is in complete_list.hpp.
template <int N>
bool lasts_too_short(const ClosingProblem<N>& problem, const Box<N>& X) {
  const Box<N> times = ClosingProblem<N>::template times<Ball>(problem.exact.total, X);
  for (int i = 0; i < N; ++i) {
    if (!(times(i) - Ball::pi()).is_negative()) {
      return false;
    }
  }
  return problem.whole;
}

// g and its slope as balls, for the contraction of X about m.
template <int N>
std::optional<Box<N>> contracted(const Jet<HardwareBall, N>& g, const HardwareBall& at_m, const Box<N>& m,
                                 const Box<N>& X) {
  if (g.value.is_nonzero()) {
    return std::nullopt;
  }
  Eigen::Matrix<Ball, 1, N> slope;
  for (int i = 0; i < N; ++i) {
    slope(i) = g.partials[static_cast<std::size_t>(i)].ball();
  }
  return contract_by<N>(at_m.ball(), slope, m, X);
}

}  // namespace

template <int N>
ClosingProblem<N>::ClosingProblem(const WordQuestion& question, const Word& word, long periods)
    : oscillator(model::oscillator<Ball>(parameters_as<Ball>(question.data))),
      phases(word.phases()),
      exact{oscillator.data,
            oscillator.modes,
            oscillator.Q,
            oscillator.d0,
            Ball(question.ur),
            Ball(2 * periods) * Ball::pi() / oscillator.data.omega,
            true},
      whole(Rational(Rational(periods) / question.data.omega).get_den() == 1) {
  const auto stick = std::find(phases.begin(), phases.end(), PhaseKind::stick);
  std::rotate(phases.begin(), stick + 1, phases.end());
  exact.begins_below = phases.front() == PhaseKind::slip;
  fast = in_hardware(exact);
}

template <int N>
template <class T>
Eigen::Matrix<T, N, 1> Eliminant<N>::operator()(const Eigen::Matrix<T, N, 1>& x) const {
  const auto left = left_for_load<T, N>(
      combined_rows<T, closing_rows<N>, closing_columns>(combinations, rows_at<T, N>(problem.exact, x)));
  return left ? functions<T, N>(*left)
              : Eigen::Matrix<T, N, 1>(Eigen::Matrix<T, N, 1>::Constant(T(1) / T(0)));
}

template <int N>
std::optional<StateAndLoad> Eliminant<N>::solved(const Box<N>& x) const {
  ClosingRows<Ball, N> m =
      combined_rows<Ball, closing_rows<N>, closing_columns>(combinations, rows_at<Ball, N>(problem.exact, x));
  if (!eliminate<Ball, closing_rows<N>, closing_columns>(m, 0, states)) {
    return std::nullopt;
  }
  const LoadRows<Ball, N> left = m.template bottomRightCorner<N + 1, 3>();
  const Eigen::Matrix<Ball, 3, 1> n = direction<Ball, N>(left, 0, 1);
  if (!n(2).is_nonzero()) {
    return std::nullopt;
  }
  StateAndLoad result{{}, n(0) / n(2), n(1) / n(2)};
  for (int k = states - 1; k >= 0; --k) {
    Ball sum = m(k, 3) * result.cosine + m(k, 4) * result.sine + m(k, 5);
    for (int j = k + 1; j < states; ++j) {
      sum += m(k, j) * result.z(j);
    }
    result.z(k) = -sum / m(k, k);
  }
  return result;
}

template <int N>
std::optional<Eliminant<N>> eliminant_near(const ClosingProblem<N>& problem, const Box<N>& X) {
  constexpr int R = closing_rows<N>;
  const ClosingRows<Ball, N> at_m = rows_at<Ball, N>(problem.exact, midpoint<N>(X));
  auto combinations = combinations_for<N>(at_m);
  const auto left = combinations
                        ? left_for_load<Ball, N>(combined_rows<Ball, R, closing_columns>(*combinations, at_m))
                        : std::nullopt;
  const auto further = left ? combinations_for_load<N>(*left) : std::nullopt;
  if (!further) {
    return std::nullopt;
  }
  combinations->template bottomRows<N + 1>() = (*further * combinations->template bottomRows<N + 1>()).eval();
  if (!is_invertible<R>(*combinations)) {
    return std::nullopt;
  }
  return Eliminant<N>{problem, *combinations};
}

// Rows that hold still do when they are combined.
template <int N>
std::optional<Box<N>> contract(const ClosingProblem<N>& problem, const Box<N>& X) {
  using BoxJet = Jet<HardwareBall, N>;
  constexpr int R = closing_rows<N>;
  constexpr int C = closing_columns;
  if (lasts_too_short<N>(problem, X)) {
    return std::nullopt;
  }
  Eigen::Matrix<HardwareBall, N, 1> x, m, spread;
  Box<N> exact_m;
  for (int i = 0; i < N; ++i) {
    x(i) = HardwareBall(X(i));
    m(i) = HardwareBall(x(i).approximate());
    spread(i) = x(i) - m(i);
    exact_m(i) = Ball(x(i).approximate());
  }
  ClosingRows<HardwareBall, N> at_m = rows_at<HardwareBall, N>(problem.fast, m);
  const auto combinations = combinations_for<N>(at_m);
  if (!combinations) {
    return X;
  }
  ClosingRows<BoxJet, N> over = combined_rows<BoxJet, R, C>(
      *combinations, rows_at<BoxJet, N>(problem.fast, scalars::variables<HardwareBall, N>(x)));
  at_m = combined_rows<HardwareBall, R, C>(*combinations, at_m);
  sharpen<R, C, N>(over, at_m, spread);
  auto left_over = left_for_load<BoxJet, N>(over);
  auto left_at_m = left_for_load<HardwareBall, N>(at_m);
  if (!left_over || !left_at_m) {
    return X;
  }
  sharpen<N + 1, 3, N>(*left_over, *left_at_m, spread);
  if (!is_possible<N>(*left_over)) {
    return std::nullopt;
  }
  const auto further = combinations_for_load<N>(*left_at_m);
  if (!further) {
    return X;
  }
  if (N == 2) {
    left_over = combined_rows<BoxJet, N + 1, 3>(*further, *left_over);
    left_at_m = combined_rows<HardwareBall, N + 1, 3>(*further, *left_at_m);
    sharpen<N + 1, 3, N>(*left_over, *left_at_m, spread);
  }
  std::optional<Box<N>> rest = X;
  for (int i = 0; i < N + 1 && rest; ++i) {
    for (int j = i + 1; j < N + 1 && rest; ++j) {
      rest =
          contracted<N>(circle<BoxJet>(direction<BoxJet, N>(*left_over, i, j)),
                        circle<HardwareBall>(direction<HardwareBall, N>(*left_at_m, i, j)), exact_m, *rest);
    }
  }
  if (N == 1 || !rest) {
    return rest;
  }
  const auto f = functions<BoxJet, N>(*left_over);
  const auto f_at_m = functions<HardwareBall, N>(*left_at_m);
  rest = contracted<N>(f(N - 1), f_at_m(N - 1), exact_m, *rest);
  if (!rest) {
    return rest;
  }
  const auto as_ball = [](const HardwareBall& b) { return b.ball(); };
  const BallMatrix<N> slope = scalars::jacobian<HardwareBall, N, N>(f).unaryExpr(as_ball);
  const std::optional<Box<N>> K = krawczyk_image<N>(exact_m, Box<N>(f_at_m.unaryExpr(as_ball)), slope, X);
  return K ? intersection<N>(*K, *rest) : rest;
}

template <int N>
Decision<N> decide(const ClosingProblem<N>& problem, const Box<N>& X) {
  const auto f = eliminant_near<N>(problem, X);
  if (!f) {
    return {std::nullopt, false, dependent};
  }
  Decision<N> decision = KrawczykDecider<N, Eliminant<N>>{*f}(X);
  if (decision.found && !f->solved(decision.found->zero)) {
    return {std::nullopt, false, "the load's phase may be undetermined"};
  }
  return decision;
}

template struct ClosingProblem<1>;
template struct ClosingProblem<2>;
template struct Eliminant<1>;
template struct Eliminant<2>;
template Eigen::Matrix<Ball, 1, 1> Eliminant<1>::operator()(const Eigen::Matrix<Ball, 1, 1>&) const;
template Eigen::Matrix<Ball, 2, 1> Eliminant<2>::operator()(const Eigen::Matrix<Ball, 2, 1>&) const;
template std::optional<Eliminant<1>> eliminant_near(const ClosingProblem<1>&, const Box<1>&);
template std::optional<Eliminant<2>> eliminant_near(const ClosingProblem<2>&, const Box<2>&);
template std::optional<Box<1>> contract(const ClosingProblem<1>&, const Box<1>&);
template std::optional<Box<2>> contract(const ClosingProblem<2>&, const Box<2>&);
template Decision<1> decide(const ClosingProblem<1>&, const Box<1>&);
template Decision<2> decide(const ClosingProblem<2>&, const Box<2>&);

}  // namespace stickslip::numeric::words
