// The common zeros of two functions f of (s, w) in [0, 1]², for every member of a box of parameters at once:
// how many there are, the same number for all, and each as a function of the parameters. Nothing here knows
// what f is. Of the variables of a form the first is s, the last is w, those between are the parameters.
//
// The square is cut into patches. With forms over a patch and the box, f lies in f(0) + J e + f_p q, e and q
// the shares of (s, w) and of the parameters, J the range of the slopes. For Y near the inverse of J each
// zero has e in K = -Y (f(0) + f_p [-1, 1]) + (1 - Y J) [-1, 1]²; where K lies inside the patch each member
// has exactly one zero there, by Krawczyk's theorem.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "numeric/atlas/knowledge.hpp"

namespace stickslip::numeric::atlas {

namespace detail {

inline constexpr int most_patches = 4000;
inline constexpr int most_attempts = 12;  // to prove a zero

template <class T>
[[nodiscard]] T side_of(const Patch& patch, int k) {
  const auto& [first, last] = patch[static_cast<std::size_t>(k)];
  return T::variable_between(first, last, k == 0 ? 0 : static_cast<int>(T().slopes.size()) - 1);
}

[[nodiscard]] inline bool is_within(const Patch& inner, const Patch& outer) {
  return inner[0].first >= outer[0].first && inner[0].second <= outer[0].second &&
         inner[1].first >= outer[1].first && inner[1].second <= outer[1].second;
}
// Nothing when they are disjoint.
[[nodiscard]] inline std::optional<Patch> common(const Patch& a, const Patch& b) {
  Patch result;
  for (std::size_t k = 0; k < 2; ++k) {
    result[k] = {std::max(a[k].first, b[k].first), std::min(a[k].second, b[k].second)};
    if (result[k].first > result[k].second) {
      return std::nullopt;
    }
  }
  return result;
}

// K, and the parts that it is made of.
template <class S, int N>
struct Image {
  Eigen::Matrix<S, 2, 1> at;      // -Y f(0)
  Eigen::Matrix<S, 2, N> slopes;  // -Y f_p, of the parameters, between the columns of 1 - Y J
  std::array<S, 2> over;          // K

  // 1 - Y J.
  [[nodiscard]] const S& rest(int i, int j) const { return slopes(i, j == 0 ? 0 : N - 1); }
  // Whether that, in the norm of row sums, is below a bound; it is as much smaller as the patch and the box
  // are.
  [[nodiscard]] bool rest_is_below(double bound) const {
    const auto size = [](const S& x) {
      const auto [low, high] = scalars::ends(x);
      return std::max(std::abs(low), std::abs(high));
    };
    return size(rest(0, 0)) + size(rest(0, 1)) < bound && size(rest(1, 0)) + size(rest(1, 1)) < bound;
  }
  [[nodiscard]] bool is_contraction() const { return rest_is_below(0.7); }
};

// Nothing where J may be singular.
template <class S, int N>
[[nodiscard]] std::optional<Image<S, N>> image(const std::array<scalars::Form<S, N>, 2>& f) {
  Eigen::Matrix<S, 2, N> slopes;
  for (int k = 0; k < N; ++k) {
    slopes.col(k) << f[0].slopes[static_cast<std::size_t>(k)], f[1].slopes[static_cast<std::size_t>(k)];
  }
  const auto near = [&](int i, int j) { return slopes(i, j == 0 ? 0 : N - 1).approximate(); };
  const double det = near(0, 0) * near(1, 1) - near(0, 1) * near(1, 0);
  if (!std::isfinite(1 / det)) {
    return std::nullopt;
  }
  const Eigen::Matrix<S, 2, 2> minus_Y{{S(-near(1, 1) / det), S(near(0, 1) / det)},
                                       {S(near(1, 0) / det), S(-near(0, 0) / det)}};
  Image<S, N> K;
  K.at = minus_Y.lazyProduct(Eigen::Matrix<S, 2, 1>(f[0].at, f[1].at));
  K.slopes = minus_Y.lazyProduct(slopes);
  K.slopes(0, 0) += S(1);
  K.slopes(1, N - 1) += S(1);
  for (int i = 0; i < 2; ++i) {
    std::array<S, static_cast<std::size_t>(N)> all;
    std::copy_n(K.slopes.row(i).begin(), N, all.begin());
    K.over[static_cast<std::size_t>(i)] = K.at(i) + scalars::sway(all);
  }
  return K;
}

// The part of the patch that shares e within these balls make, and all around it, a double wider.
template <class S>
[[nodiscard]] Patch part(const Patch& patch, const std::array<S, 2>& e, double wider = 1) {
  Patch result;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& [first, last] = patch[k];
    const double middle = first + (last - first) / 2;
    const double reach = scalars::reach(first, middle, last);
    const auto [low, high] = scalars::ends(e[k]);
    const double centre = low / 2 + high / 2;
    const double radius = wider * (high - low) / 2;
    const auto out = [&](double share, double to) {
      return std::nextafter(std::nextafter(middle + std::nextafter(reach * share, to), to), to);
    };
    result[k] = {out(std::nextafter(centre - radius, -INFINITY), -INFINITY),
                 out(std::nextafter(centre + radius, INFINITY), INFINITY)};
  }
  return result;
}

template <class S>
[[nodiscard]] bool is_inside_unit(const std::array<S, 2>& K) {
  for (const S& x : K) {
    const auto [low, high] = scalars::ends(x);
    if (!(low > -1 && high < 1)) {
      return false;
    }
  }
  return true;
}
template <class S>
[[nodiscard]] bool misses_unit(const std::array<S, 2>& K) {
  for (const S& x : K) {
    const auto [low, high] = scalars::ends(x);
    if (low > 1 || high < -1) {
      return true;
    }
  }
  return false;
}

// Across which side to cut; negative when shorter sides tell nothing that the parameters leave open.
template <class T>
[[nodiscard]] int side_to_cut(const std::array<T, 2>& f) {
  double by_s = 0;
  double by_w = 0;
  bool is_hopeless = true;
  for (const T& g : f) {
    const auto size = [&](std::size_t i) {
      const auto [low, high] = scalars::ends(g.slopes[i]);
      return std::max(std::abs(low), std::abs(high));
    };
    const std::size_t w = g.slopes.size() - 1;
    double by_parameters = 0;
    for (std::size_t i = 1; i < w; ++i) {
      by_parameters += size(i);
    }
    const double all = by_parameters + size(0) + size(w);
    by_s += size(0) / all;
    by_w += size(w) / all;
    is_hopeless =
        is_hopeless && std::abs(g.at.approximate()) < by_parameters && size(0) + size(w) < by_parameters;
  }
  return is_hopeless ? -1 : by_s >= by_w ? 0 : 1;
}

}  // namespace detail

// Looks at the open patches of a sheet. What is left in `patches` is open; `zeros` grow. look: of two forms
// f, or nothing when no member has a zero there; sides of patches shorter than `least` are not cut.
template <class S, int N, class F>
void settle_patches(const F& look, Knowledge::Sheet& sheet, double least) {
  using T = scalars::Form<S, N>;
  std::vector<Patch> todo(sheet.patches.rbegin(), sheet.patches.rend());
  sheet.patches.clear();
  sheet.of_patches = {true};
  const auto leave_open = [&](const Patch& patch, const Hope& hope) {
    sheet.patches.push_back(patch);
    sheet.of_patches = sheet.of_patches.and_also(hope);
  };
  const auto look_at = [&](const Patch& patch) {
    return look(detail::side_of<T>(patch, 0), detail::side_of<T>(patch, 1));
  };
  // Whether all zeros in the patch, which lie in `part`, are known ones.
  const auto is_known = [&](const Patch& part) {
    return std::any_of(sheet.zeros.begin(), sheet.zeros.end(),
                       [&](const ZeroPatch& zero) { return detail::is_within(part, zero.unique); });
  };
  // False unless all zeros in `part` are known afterwards. X, around it, grows with K.
  int attempts = 0;
  const auto prove_zero = [&](const Patch& part, Patch X) {
    ZeroPatch zero;
    bool is_proved = false;
    for (int round = 0; round < 4 && !is_proved; ++round) {
      const auto f = look_at(X);
      const auto K = f ? detail::image<S, N>(*f) : std::nullopt;
      if (!K || !K->is_contraction() || !detail::is_within(part, X)) {
        return false;
      }
      zero = {X, detail::part<S>(X, K->over)};
      is_proved = detail::is_inside_unit<S>(K->over);
      X = detail::part<S>(X, K->over, 1.3);
    }
    if (!is_proved) {
      return false;
    }
    for (const ZeroPatch& other : sheet.zeros) {
      if (detail::is_within(zero.where, other.unique) || detail::is_within(other.where, zero.unique)) {
        return true;  // it is the other
      }
      if (detail::common(zero.where, other.where)) {
        return false;
      }
    }
    sheet.zeros.push_back(zero);
    return true;
  };
  for (int examined = 0; !todo.empty(); ++examined) {
    const Patch patch = todo.back();
    todo.pop_back();
    if (is_known(patch)) {
      continue;
    }
    if (examined >= detail::most_patches) {
      leave_open(patch, {});
      continue;
    }
    const auto f = look_at(patch);
    if (!f || (*f)[0].over.is_nonzero() || (*f)[1].over.is_nonzero()) {
      continue;
    }
    Hope hope{false, 0};
    if (const auto K = detail::image<S, N>(*f)) {
      hope.is_promising = K->rest_is_below(32);
      if (detail::misses_unit<S>(K->over)) {
        continue;
      }
      if (K->is_contraction()) {
        const std::optional<Patch> zeros = detail::common(detail::part<S>(patch, K->over), patch);
        if (!zeros || is_known(*zeros)) {
          continue;
        }
        if (attempts++ < detail::most_attempts && prove_zero(*zeros, detail::part<S>(patch, K->over, 1.5))) {
          continue;
        }
      }
    }
    for (T g : *f) {
      g.slopes.back() = S(0);
      const Hope of_g = hope_of(g, 1);
      hope = {hope.is_promising || of_g.is_promising, of_g.steepest};
    }
    const int cut = detail::side_to_cut<T>(*f);
    const auto k = static_cast<std::size_t>(std::max(cut, 0));
    if (cut < 0 || patch[k].second - patch[k].first <= least) {
      leave_open(patch, hope);
      continue;
    }
    const double middle = (patch[k].first + patch[k].second) / 2;  // exact, as are the patches
    Patch lower = patch;
    Patch upper = patch;
    lower[k].second = upper[k].first = middle;
    todo.push_back(upper);
    todo.push_back(lower);
  }
}

// (s, w) of a zero as forms in the parameters; what is found out of where it is is left there.
template <class S, int N, class F>
[[nodiscard]] std::optional<std::array<scalars::Form<S, N>, 2>> zero_in_patch(const F& look,
                                                                              ZeroPatch& zero) {
  using T = scalars::Form<S, N>;
  std::optional<std::array<T, 2>> result;
  for (int step = 0; step < 4; ++step) {
    const Patch X = zero.where;
    const auto f = look(detail::side_of<T>(X, 0), detail::side_of<T>(X, 1));
    const auto K = f ? detail::image<S, N>(*f) : std::nullopt;
    if (!K) {
      return result;
    }
    const auto narrower = detail::common(detail::part<S>(X, K->over), X);
    if (!narrower) {
      return result;
    }
    zero.where = *narrower;
    // The zero at e: e = -Y f(0) + (1 - Y J) e at the middle, de = -Y f_p + (1 - Y J) de.
    const S a = S(1) - K->rest(0, 0), b = S(1) - K->rest(1, 1);
    const S det = a * b - K->rest(0, 1) * K->rest(1, 0);
    const auto solved = [&](const Eigen::Matrix<S, 2, 1>& r) {
      return std::array<S, 2>{S((b * r(0) + K->rest(0, 1) * r(1)) / det),
                              S((K->rest(1, 0) * r(0) + a * r(1)) / det)};
    };
    std::array<T, 2> forms{detail::side_of<T>(X, 0), detail::side_of<T>(X, 1)};
    const std::array<S, 2> at = solved(K->at);
    for (std::size_t k = 0; k < 2; ++k) {
      T& x = forms[k];
      const S reach = static_cast<const S&>(x.slopes[k == 0 ? 0 : static_cast<std::size_t>(N - 1)]);
      const S centre = x.at;
      x.slopes.fill(S(0));
      x.at = centre + reach * at[k];
      x.over = scalars::around<S>(zero.where[k].first, zero.where[k].second);
      for (std::size_t p = 1; p + 1 < x.slopes.size(); ++p) {
        x.slopes[p] = reach * solved(K->slopes.col(static_cast<int>(p)))[k];
      }
      x.sharpen();
    }
    result = forms;
    const double before = std::max(X[0].second - X[0].first, X[1].second - X[1].first);
    const double now = std::max(narrower->at(0).second - narrower->at(0).first,
                                narrower->at(1).second - narrower->at(1).first);
    if (now > 0.8 * before) {
      break;
    }
  }
  return result;
}

}  // namespace stickslip::numeric::atlas
