#include "numeric/families/overshooting.hpp"
#include "numeric/families/overshooting_reduced.hpp"

namespace stickslip::numeric::families {

using namespace motion;

namespace {

// tau, tau1, a, C, D.
template <class T, int U>
std::vector<Bounds> bounds(const Eigen::Matrix<T, 2, 1>& t, const Eigen::Matrix<T, U, 1>& linear) {
  return {scalars::ends(t(0).over), scalars::ends(t(1).over), scalars::ends(linear(0).over),
          scalars::ends(linear(1).over), scalars::ends(linear(2).over)};
}

// Where an unknown may be larger they are looked at by their ratios, too.
constexpr double large = 16;

// The same where a or D, the unknown of that column, may be unbounded, and then the other, too, but not C:
// the row that is 1 and the column change places. The functions that must vanish are added.
template <class T, class S>
void add_large(const AllRows<OneStick<2, Datum::phase>, T>& rows, const Eigen::Matrix<T, 2, 1>& t, int column,
               Reduced<T>& result) {
  constexpr int one = OneStick<2, Datum::phase>::columns - 1;
  AllRows<OneStick<2, Datum::phase>, T> turned = rows;
  turned.col(column).swap(turned.col(one));
  const auto rest = eliminated<Datum::phase, T, S>(turned);
  if (!rest) {
    return;
  }
  result.vanish.insert(result.vanish.end(), {rest->vanish(0), rest->vanish(1)});
  const int odd = std::abs(rows(0, 1).at.approximate()) > std::abs(rows(1, 1).at.approximate()) ? 0 : 1;
  LargeBounds bounds{2 + column, {2, 4}, {}};
  for (const T& x : {t(0), t(1), rest->linear(0), T(-rows(odd, one) / rows(odd, 1)), rest->linear(2)}) {
    bounds.x.push_back(scalars::ends(x.over));
  }
  result.large.push_back(bounds);
}

Ball as_ball(const Ball& x) {
  return x;
}
Ball as_ball(const scalars::HardwareBall& x) {
  return x.ball();
}

// Of (x, y), up to full turns: in a short interval, on the negative x axis too.
Ball angle(const Ball& x, const Ball& y) {
  Ball result;
  const bool turned = x.is_negative();
  arb_atan2(result.raw(), (turned ? -y : y).raw(), (turned ? -x : x).raw(), WorkingPrecision::bits());
  return turned ? result + Ball::pi() : result;
}

// What the rows still say of the load's phase psi where only a, C and D are eliminated: |1's part| of each is
// at most the length of the other two, and the vector product n of two of them is parallel to (cos psi, sin
// psi, 1), so n1² + n2² = n3². This needs no division by what may vanish where psi is hardly determined.
template <class T, class S>
void add_load(const AllRows<OneStick<2, Datum::friction>, T>& rows, Reduced<T>& result) {
  using P = OneStick<2, Datum::friction>;
  const AllRows<P, S> at_middle = rows.unaryExpr([](const T& x) { return x.at; });
  const auto combinations = detail::combinations_for<P, S>(at_middle);
  if (!combinations) {
    return;
  }
  const auto left = detail::left_for_load<P, T>(zeros::combined_rows<T, P::rows, P::columns>(
      Eigen::Matrix<S, P::rows, P::rows>(combinations->template cast<S>()), rows));
  if (!left) {
    return;
  }
  for (int i = 0; i < P::left; ++i) {
    const S a = (*left)(i, 0).over, b = (*left)(i, 1).over, c = (*left)(i, 2).over;
    result.excluded = result.excluded || (c * c - a * a - b * b).is_positive();
    for (int j = i + 1; j < P::left; ++j) {
      result.vanish.push_back(detail::circle<T>(detail::direction<P, T>(*left, i, j)));
    }
  }
}

template <Datum G>
struct OverStrip {
  template <class T, class S>
  [[nodiscard]] Reduced<T> operator()(const Given<T>& given, const T& s, const T& w) const {
    constexpr bool at_phase = G == Datum::phase;
    const OneStickData<T> data{model::reduced_data<T>(given.data, T(scalars::pi<S>())),
                               at_phase ? *given.phi : *given.ur};
    const Eigen::Matrix<T, 2, 1> sw(s, w);
    const AllRows<OneStick<2, G>, T> rows = rows_of<2, G, T>(data, sw);
    constexpr int one = OneStick<2, G>::columns - 1;
    const T odd = det2<T>(rows(0, 1), rows(0, one), rows(1, 1), rows(1, one));
    Reduced<T> result;
    if constexpr (at_phase) {
      result.excluded = is_nonzero(odd);
      result.vanish = {odd};
    } else {
      // sin psi - 1 and sin psi + 1, times the determinant of the odd rows in (C, sin psi).
      const T size = det2<T>(rows(0, 1), rows(0, one - 1), rows(1, 1), rows(1, one - 1));
      const S above = T(size - odd).over, below = T(-odd - size).over;
      result.excluded =
          (above.is_positive() && below.is_positive()) || (above.is_negative() && below.is_negative());
    }
    if (result.excluded) {
      return result;
    }
    const auto rest = eliminated<G, T, S>(rows);
    const Eigen::Matrix<T, 2, 1> t = times<T, 2>(data.d.Theta, sw);
    if constexpr (at_phase) {
      const auto may_be_large = [&](int k) {
        const auto [low, high] = scalars::ends(rest->linear(k).over);
        return !(-large < low && high < large);
      };
      if (!rest || may_be_large(0) || may_be_large(2)) {
        add_large<T, S>(rows, t, 0, result);
        add_large<T, S>(rows, t, 2, result);
      }
    }
    if constexpr (!at_phase) {
      add_load<T, S>(rows, result);
    }
    if (!rest || result.excluded) {
      return result;
    }
    result.vanish.insert(result.vanish.end(), {rest->vanish(0), rest->vanish(1)});
    result.x = bounds<T>(t, rest->linear);
    if constexpr (!at_phase) {
      const Ball phi = angle(as_ball(rest->linear(3).over), as_ball(rest->linear(4).over)) -
                       as_ball(T(data.d.omega * T(t(0) + t(1)) / T(2)).over);
      result.x.push_back(scalars::ends(phi));
    }
    return result;
  }
};

}  // namespace

std::vector<Strip> overshooting_strips(const StripQuestion& q) {
  const zeros::Cell<3> domain{{0, 0, 0}, {1, 1, 1}};
  if (q.given.phi) {
    return {strip_of(q, 0, -1, domain, OverStrip<Datum::phase>{})};
  }
  return {strip_of(q, 0, 5, domain, OverStrip<Datum::friction>{})};
}

}  // namespace stickslip::numeric::families
