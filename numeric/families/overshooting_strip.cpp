#include "numeric/families/overshooting.hpp"
#include "numeric/families/through_phases/one_stick_reduced.hpp"

namespace stickslip::numeric::families {

using namespace motion;

namespace {

using AtPhase = OneStick<2, Datum::phase>;

// Where an unknown may be larger they are looked at by their ratios, too.
constexpr double large = 16;

// The same where a or D, the unknown of that column, may be unbounded, and then the other, too, but not C:
// the row that is 1 and the column change places. The functions that must vanish are added.
template <class T, class S>
void add_large(const AllRows<AtPhase, T>& rows, const Eigen::Matrix<T, 2, 1>& t, int column,
               Reduced<T>& result) {
  constexpr int one = AtPhase::columns - 1;
  AllRows<AtPhase, T> turned = rows;
  turned.col(column).swap(turned.col(one));
  const auto rest = eliminated<AtPhase, T, S>(turned);
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

// The unknowns are tau, tau1, a, C, D.
struct AtPhaseStrip {
  template <class T, class S>
  [[nodiscard]] Reduced<T> operator()(const Given<T>& given, const T& s, const T& w) const {
    const OneStickData<T> data{model::reduced_data<T>(given.data, T(scalars::pi<S>())), *given.phi};
    const Eigen::Matrix<T, 2, 1> sw(s, w);
    const AllRows<AtPhase, T> rows = rows_of<2, Datum::phase, T>(data, sw);
    constexpr int one = AtPhase::columns - 1;
    const T odd = det2<T>(rows(0, 1), rows(0, one), rows(1, 1), rows(1, one));
    Reduced<T> result{{odd}};
    result.excluded = is_nonzero(odd);
    if (result.excluded) {
      return result;
    }
    const auto rest = eliminated<AtPhase, T, S>(rows);
    const Eigen::Matrix<T, 2, 1> t = times<T, 2>(data.d.Theta, sw);
    const auto may_be_large = [&](int k) {
      const auto [low, high] = scalars::ends(rest->linear(k).over);
      return !(-large < low && high < large);
    };
    if (!rest || may_be_large(0) || may_be_large(2)) {
      add_large<T, S>(rows, t, 0, result);
      add_large<T, S>(rows, t, 2, result);
    }
    if (!rest) {
      return result;
    }
    result.vanish.insert(result.vanish.end(), {rest->vanish(0), rest->vanish(1)});
    for (const T& x : {t(0), t(1), rest->linear(0), rest->linear(1), rest->linear(2)}) {
      result.x.push_back(scalars::ends(x.over));
    }
    return result;
  }
};

struct AtFrictionStrip {
  template <class T, class S>
  [[nodiscard]] Reduced<T> operator()(const Given<T>& given, const T& s, const T& w) const {
    return reduced_at_friction<2, T, S>({model::reduced_data<T>(given.data, T(scalars::pi<S>())), *given.ur},
                                        {s, w});
  }
};

}  // namespace

std::vector<Strip> overshooting_strips(const StripQuestion& q) {
  const zeros::Cell<3> domain{{0, 0, 0}, {1, 1, 1}};
  if (q.given.phi) {
    return {strip_of(q, 0, -1, domain, AtPhaseStrip{})};
  }
  return {strip_of(q, 0, 5, domain, AtFrictionStrip{})};
}

}  // namespace stickslip::numeric::families
