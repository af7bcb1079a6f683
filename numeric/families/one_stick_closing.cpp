#include "numeric/families/one_stick_closing.hpp"

#include <cmath>

#include "numeric/families/end_rows.hpp"
#include "numeric/families/one_stick_rows.hpp"

namespace stickslip::numeric::families {

using namespace zeros;
using scalars::HardwareBall;
using scalars::Jet;

namespace {

// The rows' combinations that make the amplitudes at the middle of a box simple.
template <int N, Datum G, class S>
auto combinations_for(const AllRows<S, N, G>& at_m) {
  constexpr int R = OneStick<N, G>::rows;
  const Eigen::Matrix<S, R, amplitudes + 1> part = at_m.template leftCols<amplitudes + 1>();
  return row_combinations<R, amplitudes + 1>(part);
}

// Where three rows are left the same for cos psi and sin psi.
template <int N, Datum G, class S>
auto combinations_for_load(const LoadRows<S, N, G>& at_m) {
  constexpr int K = OneStick<N, G>::left;
  using Combinations = Eigen::Matrix<S, K, K>;
  if constexpr (K == 3) {
    return row_combinations<3, 3>(at_m);
  } else {
    return std::optional<Combinations>(Combinations::Identity());
  }
}

// A cell in hardware balls, for a contraction.
template <int N>
struct HardwareBox {
  Eigen::Matrix<HardwareBall, N, 1> X, m, spread;

  explicit HardwareBox(const Box<N>& box) {
    for (int i = 0; i < N; ++i) {
      X(i) = HardwareBall(box(i));
      m(i) = HardwareBall(X(i).approximate());
      spread(i) = X(i) - m(i);
    }
  }
};

template <int N>
using FastJet = Jet<HardwareBall, N>;
template <int N>
using FastBox = Eigen::Matrix<HardwareBall, N, 1>;

template <int N>
std::optional<FastBox<N>> contracted(const FastJet<N>& g, const HardwareBall& at_m, const FastBox<N>& m,
                                     const FastBox<N>& X) {
  if (g.value.is_nonzero()) {
    return std::nullopt;
  }
  Eigen::Matrix<HardwareBall, 1, N> slope;
  for (int i = 0; i < N; ++i) {
    slope(i) = g.partials[static_cast<std::size_t>(i)];
  }
  return contract_by<N, HardwareBall>(at_m, slope, m, X);
}

template <int N>
Box<N> as_balls(const FastBox<N>& X) {
  return X.unaryExpr([](const HardwareBall& x) { return x.ball(); });
}

// The part of X that the odd rows alone leave. phi given: they are left C + right = 0, and their determinant
// must vanish. ur given: determinants with C say sin psi, and nothing is left where |sin psi| > 1: sin psi ∓
// 1, times the determinant of (C, sin psi), have one sign.
template <int N, Datum G>
std::optional<FastBox<N>> contract_by_odd(const RowsOf<FastJet<N>, 2, N, G>& over,
                                          const RowsOf<HardwareBall, 2, N, G>& at_m,
                                          const HardwareBox<N>& box) {
  const auto minor = [](const auto& x, int k) {
    using T = std::decay_t<decltype(x(0, 0))>;
    return det2<T>(x(0, k), x(0, 1), x(1, k), x(1, 1));
  };
  constexpr int one = OneStick<N, G>::columns - 1;
  if constexpr (G == Datum::phase) {
    return contracted<N>(minor(over, one), minor(at_m, one), box.m, box.X);
  } else {
    const auto range = [&](int sign) {
      const FastJet<N> jet = minor(over, one) - FastJet<N>(sign) * minor(over, one - 1);
      HardwareBall form = minor(at_m, one) - HardwareBall(sign) * minor(at_m, one - 1);
      for (int i = 0; i < N; ++i) {
        form += jet.partials[static_cast<std::size_t>(i)] * box.spread(i);
      }
      return intersection(form, jet.value).value_or(form);
    };
    const HardwareBall below = range(-1), above = range(1);
    const bool outside =
        (below.is_positive() && above.is_positive()) || (below.is_negative() && above.is_negative());
    return outside ? std::nullopt : std::optional(box.X);
  }
}

// Whether a row allows some cos psi and sin psi: |1's part| is at most the length of the other two.
template <int N, Datum G>
bool load_is_possible(const LoadRows<FastJet<N>, N, G>& m) {
  for (int i = 0; i < OneStick<N, G>::left && G == Datum::friction; ++i) {
    constexpr int last = OneStick<N, G>::loads - 1;
    const HardwareBall &a = m(i, 0).value, &b = m(i, last / 2).value, &c = m(i, last).value;
    if ((c * c - a * a - b * b).is_positive()) {
      return false;
    }
  }
  return true;
}

// omega = n/k: the coefficients of C and sin psi vanish like t³, t = tau + tau1, and the rest does not.
template <int N, Datum G>
bool excluded_at_origin(const OneStickData<Ball>& data, const Box<N>& X) {
  const auto [tau, tau1] = both_times<Ball, N>(data, X);
  const model::Modes<Ball>& m = data.d.m;
  const Ball total = tau + tau1;
  const EndRows end{m, data.d.omega, total};
  const auto odd = odd_rows<N, G, Ball>(data, X);
  const Ball left1 = end.left(m.omega1, m.lambda2);
  const Ball left2 = end.left(m.omega2, m.lambda1);
  constexpr int one = OneStick<N, G>::columns - 1;
  const Ball rest = det2<Ball>(odd(0, one), left1, odd(1, one), left2);
  if (G == Datum::phase) {
    return end.applies() && odd(0, one).is_nonzero() && rest.is_nonzero();
  }
  const Ball load1 = data.d.p * end.transfer(m.omega1, data.d.omega);
  const Ball load2 = data.d.p * end.transfer(m.omega2, data.d.omega);
  const Ball most = abs(det2<Ball>(left1, load1, left2, load2)) * total * total * total;
  return end.applies() && (abs(rest) - most).is_positive();
}

Ball angle(const Ball& sine, const Ball& cosine) {
  Ball result;
  arb_atan2(result.raw(), sine.raw(), cosine.raw(), WorkingPrecision::bits());
  return result;
}

}  // namespace

template <int N, Datum G>
OneStick<N, G>::OneStick(const OneStickData<Ball>& data, bool is_sound)
    : exact(data), fast(lifted<HardwareBall>(data)), sound_at_origin(is_sound) {}

template <int N, Datum G>
template <class T>
Eigen::Matrix<T, N, 1> OneStickEliminant<N, G>::operator()(const Eigen::Matrix<T, N, 1>& x) const {
  using Problem = OneStick<N, G>;
  const auto left = left_for_load<N, G, T>(
      combined_rows<T, Problem::rows, Problem::columns>(combinations, rows_at<N, G, T>(problem.exact, x)));
  return left ? functions<N, G, T>(*left)
              : Eigen::Matrix<T, N, 1>(Eigen::Matrix<T, N, 1>::Constant(T(1) / T(0)));
}

template <int N, Datum G>
std::optional<OneStickMotion<N>> OneStickEliminant<N, G>::motion(const Box<N>& x) const {
  using Problem = OneStick<N, G>;
  AllRows<Ball, N, G> m = combined_rows<Ball, Problem::rows, Problem::columns>(
      combinations, rows_at<N, G, Ball>(problem.exact, x));
  if (!eliminate<Ball, Problem::rows, Problem::columns>(m, 0, amplitudes)) {
    return std::nullopt;
  }
  const model::OvershootingData<Ball>& d = problem.exact.d;
  OneStickMotion<N> result{times<Ball, N>(d.Theta, x), d.Theta * (Ball(1) - x(0)), {}, problem.exact.given};
  Eigen::Matrix<Ball, Problem::loads, 1> load = Eigen::Matrix<Ball, Problem::loads, 1>::Constant(Ball(1));
  if constexpr (G == Datum::friction) {
    const LoadRows<Ball, N, G> left = m.template bottomRightCorner<Problem::left, Problem::loads>();
    const Eigen::Matrix<Ball, 3, 1> n = direction<N, Ball>(left, 0, 1);
    if (!n(2).is_nonzero()) {
      return std::nullopt;
    }
    load(0) = n(0) / n(2);
    load(1) = n(1) / n(2);
    const Ball phi = angle(load(1), load(0)) - d.omega * d.Theta * x(0) / Ball(2);
    const Ball turn = Ball(2) * Ball::pi();
    result.phi = phi - turn * Ball(std::floor((phi / turn).approximate() + 0.5));
  }
  Eigen::Matrix<Ball, amplitudes, 1> u;
  for (int k = amplitudes - 1; k >= 0; --k) {
    Ball sum(0);
    for (int j = k + 1; j < Problem::columns; ++j) {
      sum += m(k, j) * (j < amplitudes ? u(j) : load(j - amplitudes));
    }
    u(k) = -sum / m(k, k);
  }
  result.Z0 = model::overshooting_start<Ball>(d, result.stick, u(0), u(1), u(2));
  return result;
}

template <int N, Datum G>
std::optional<OneStickEliminant<N, G>> eliminant_near(const OneStick<N, G>& problem, const Box<N>& X) {
  constexpr int R = OneStick<N, G>::rows, C = OneStick<N, G>::columns, K = OneStick<N, G>::left;
  const AllRows<Ball, N, G> at_m = rows_at<N, G, Ball>(problem.exact, midpoint<N>(X));
  auto combinations = combinations_for<N, G>(at_m);
  const auto left =
      combinations ? left_for_load<N, G, Ball>(combined_rows<Ball, R, C>(*combinations, at_m)) : std::nullopt;
  const auto further = left ? combinations_for_load<N, G>(*left) : std::nullopt;
  if (!further) {
    return std::nullopt;
  }
  combinations->template bottomRows<K>() = (*further * combinations->template bottomRows<K>()).eval();
  if (!is_invertible<R>(*combinations)) {
    return std::nullopt;
  }
  return OneStickEliminant<N, G>{problem, *combinations};
}

// Rows that hold still do when they are combined.
template <int N, Datum G>
std::optional<Box<N>> contract(const OneStick<N, G>& problem, const Box<N>& X) {
  constexpr int R = OneStick<N, G>::rows, C = OneStick<N, G>::columns;
  constexpr int K = OneStick<N, G>::left, L = OneStick<N, G>::loads;
  if (!problem.sound_at_origin && X(0).contains_zero() && excluded_at_origin<N, G>(problem.exact, X)) {
    return std::nullopt;
  }
  const HardwareBox<N> box(X);
  const OneStickData<FastJet<N>> lift = lifted<FastJet<N>>(problem.fast);
  const Eigen::Matrix<FastJet<N>, N, 1> x = scalars::variables<HardwareBall, N>(box.X);
  const auto odd = odd_rows<N, G, FastJet<N>>(lift, x);
  const auto odd_at_m = odd_rows<N, G, HardwareBall>(problem.fast, box.m);
  std::optional<FastBox<N>> rest = contract_by_odd<N, G>(odd, odd_at_m, box);
  if (!rest) {
    return std::nullopt;
  }
  AllRows<HardwareBall, N, G> at_m =
      stacked<N, G, HardwareBall>(odd_at_m, other_rows<N, G, HardwareBall>(problem.fast, box.m));
  const auto combinations = combinations_for<N, G>(at_m);
  if (!combinations) {
    return as_balls<N>(*rest);
  }
  AllRows<FastJet<N>, N, G> over = combined_rows<FastJet<N>, R, C>(
      *combinations, stacked<N, G, FastJet<N>>(odd, other_rows<N, G, FastJet<N>>(lift, x)));
  at_m = combined_rows<HardwareBall, R, C>(*combinations, at_m);
  sharpen<R, C, N>(over, at_m, box.spread);
  auto left_over = left_for_load<N, G, FastJet<N>>(over);
  auto left_at_m = left_for_load<N, G, HardwareBall>(at_m);
  if (!left_over || !left_at_m) {
    return as_balls<N>(*rest);
  }
  sharpen<K, L, N>(*left_over, *left_at_m, box.spread);
  if (!load_is_possible<N, G>(*left_over)) {
    return std::nullopt;
  }
  if constexpr (G == Datum::friction) {
    const auto further = combinations_for_load<N, G>(*left_at_m);
    if (!further) {
      return as_balls<N>(*rest);
    }
    if (K == 3) {
      left_over = combined_rows<FastJet<N>, K, L>(*further, *left_over);
      left_at_m = combined_rows<HardwareBall, K, L>(*further, *left_at_m);
      sharpen<K, L, N>(*left_over, *left_at_m, box.spread);
    }
    for (int i = 0; i < K && rest; ++i) {
      for (int j = i + 1; j < K && rest; ++j) {
        rest =
            contracted<N>(circle<FastJet<N>>(direction<N, FastJet<N>>(*left_over, i, j)),
                          circle<HardwareBall>(direction<N, HardwareBall>(*left_at_m, i, j)), box.m, *rest);
      }
    }
  }
  const auto f = functions<N, G, FastJet<N>>(*left_over);
  const FastBox<N> f_at_m = functions<N, G, HardwareBall>(*left_at_m);
  for (int i = 0; i < N && rest; ++i) {
    rest = contracted<N>(f(i), f_at_m(i), box.m, *rest);
  }
  if (!rest) {
    return std::nullopt;
  }
  const auto image =
      krawczyk_image<N, HardwareBall>(box.m, f_at_m, scalars::jacobian<HardwareBall, N, N>(f), box.X);
  for (int i = 0; i < N && image; ++i) {
    const std::optional<HardwareBall> side = intersection((*image)(i), (*rest)(i));
    if (!side) {
      return std::nullopt;
    }
    (*rest)(i) = *side;
  }
  return as_balls<N>(*rest);
}

template <int N, Datum G>
Decision<N> decide(const OneStick<N, G>& problem, const Box<N>& X) {
  const auto f = eliminant_near<N, G>(problem, X);
  if (!f) {
    return {std::nullopt, false, dependent};
  }
  Decision<N> decision = KrawczykDecider<N, OneStickEliminant<N, G>>{*f}(X);
  if (decision.found && !f->motion(decision.found->zero)) {
    return {std::nullopt, false, "the load's phase may be undetermined"};
  }
  return decision;
}

#define STICKSLIP_ONE_STICK(N, G)                                                                          \
  template struct OneStick<N, G>;                                                                          \
  template struct OneStickEliminant<N, G>;                                                                 \
  template Eigen::Matrix<Ball, N, 1> OneStickEliminant<N, G>::operator()(const Eigen::Matrix<Ball, N, 1>&) \
      const;                                                                                               \
  template std::optional<OneStickEliminant<N, G>> eliminant_near(const OneStick<N, G>&, const Box<N>&);    \
  template std::optional<Box<N>> contract(const OneStick<N, G>&, const Box<N>&);                           \
  template Decision<N> decide(const OneStick<N, G>&, const Box<N>&);
STICKSLIP_ONE_STICK(1, Datum::friction)
STICKSLIP_ONE_STICK(2, Datum::friction)
STICKSLIP_ONE_STICK(2, Datum::phase)
#undef STICKSLIP_ONE_STICK

}  // namespace stickslip::numeric::families
