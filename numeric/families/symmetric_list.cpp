#include "numeric/families/symmetric_list.hpp"

#include <algorithm>
#include <array>

#include "numeric/families/end_rows.hpp"

namespace stickslip::numeric::families {

using namespace motion;
using namespace scalars;
using namespace zeros;

namespace {

using Vector1 = Box<1>;
constexpr long search_bits = 64;

// C eliminated, as a function of u = tau/Theta in [0, 1].
struct Eliminant {
  SymmetricClosing<Ball> closing;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 1, 1> operator()(const Eigen::Matrix<T, 1, 1>& u) const {
    const model::SymmetricData<T> data = closing.lifted<T>();
    return Eigen::Matrix<T, 1, 1>(model::symmetric_eliminant<T>(data, T(data.Theta * u(0))));
  }
};

Eliminant eliminant(const ExactParameters& a, LoadPhase phase) {
  return {{symmetric_data<Ball>(a, phase)}};
}

// Which rows vanish identically at an end: decided in rationals.
struct EndZeros {
  bool origin;                   // omega = 1/k: both left sides vanish at tau = 0
  std::array<bool, 2> resonant;  // omega_j = k omega, k > 1: row j vanishes at T = 0
};

EndRows end_rows(const model::SymmetricData<Ball>& d, const Ball& t) {
  return {d.m, d.omega, t};
}

// omega = 1/k. At tau = 0 the left sides vanish and the right sides are V omega_k² omega_j Theta/2 > 0: no
// orbit. Beside it the divided eliminant decides.
bool excluded_at_origin(const model::SymmetricData<Ball>& data, const Ball& tau) {
  const EndRows end = end_rows(data, tau);
  const model::Vector2<Ball> right = model::symmetric_rows(data, tau).right;
  const Ball quotient =
      end.left(data.m.omega2, data.m.lambda1) * right(0) - end.left(data.m.omega1, data.m.lambda2) * right(1);
  return end.applies() && quotient.is_nonzero() && right(0).is_positive();
}

// omega_j = k omega: row j holds at T = 0 whatever C. For T > 0 the divided eliminant decides.
bool excluded_before_end(const model::SymmetricData<Ball>& data, const std::array<bool, 2>& resonant,
                         const Ball& tau) {
  const EndRows end = end_rows(data, data.Theta - tau);
  model::SymmetricRows<Ball> rows = model::symmetric_rows(data, tau);
  const auto divide = [&](const Ball& omega_j, const Ball& omega_k, const Ball& lambda_k, int j) {
    rows.left(j) = -end.left(omega_j, lambda_k);
    rows.right(j) = data.V * omega_k * omega_k * end.cubic(omega_j) +
                    data.sigma * data.p * end.transfer(omega_j, data.omega);
  };
  if (resonant[0]) {
    divide(data.m.omega1, data.m.omega2, data.m.lambda2, 0);
  }
  if (resonant[1]) {
    divide(data.m.omega2, data.m.omega1, data.m.lambda1, 1);
  }
  return end.applies() && (rows.left(1) * rows.right(0) - rows.left(0) * rows.right(1)).is_nonzero();
}

// The search's contractor: Krawczyk's, helped out at the ends where the eliminant has a multiple zero that is
// no stick-slip orbit.
struct Contractor {
  const Eliminant& f;
  EndZeros zeros;

  std::optional<Vector1> operator()(const Vector1& X) const {
    const Ball tau = f.closing.data.Theta * X(0);
    const bool at_end = (X(0) - Ball(1)).contains_zero() && (zeros.resonant[0] || zeros.resonant[1]);
    if ((zeros.origin && X(0).contains_zero() && excluded_at_origin(f.closing.data, tau)) ||
        (at_end && excluded_before_end(f.closing.data, zeros.resonant, tau))) {
      return std::nullopt;
    }
    return KrawczykContractor<1, Eliminant>{f}(X);
  }
};

EndZeros end_zeros(const ExactParameters& a) {
  const Resonances k = resonances(a);
  return {a.omega.get_num() == 1, {k.first > 1, k.second > 1}};
}

// One of the rows has a left side without zero in the box: its index, the one that keeps farther away.
std::optional<int> pivot_row(const model::SymmetricRows<Ball>& rows) {
  const int j = magnitude(rows.left(0)) > magnitude(rows.left(1)) ? 0 : 1;
  for (const int k : {j, 1 - j}) {
    if (rows.left(k).is_nonzero()) {
      return k;
    }
  }
  return std::nullopt;
}

// A zero of the eliminant is an orbit when C can be had from a row.
struct Decider {
  const Eliminant& f;

  Decision<1> operator()(const Vector1& X) const {
    const Decision<1> decision = KrawczykDecider<1, Eliminant>{f}(X);
    const auto& data = f.closing.data;
    if (decision.found && !pivot_row(model::symmetric_rows(data, data.Theta * decision.found->zero(0)))) {
      return {std::nullopt, false,
              "the amplitude $C$ cannot be eliminated: both of its coefficients may vanish here"};
    }
    return decision;
  }
};

// The zero refined and looked at: an orbit of the list, outside the domain, or at its very end.
void conclude(const ExactParameters& a, LoadPhase phase, const FoundZero<1>& found, int digits,
              SymmetricList& list) {
  const long bits = bits_for(digits);
  const Vector1 u = refine<1>([&] { return eliminant(a, phase); }, found.zero, bits);
  const WorkingPrecision scope(bits + 64);
  const Ball beyond = u(0) - Ball(1);
  if (u(0).is_negative() || beyond.is_positive()) {
    return;
  }
  const model::SymmetricData<Ball> data = symmetric_data<Ball>(a, phase);
  const Ball tau = data.Theta * u(0);
  if (!u(0).is_positive() || !beyond.is_negative()) {
    list.unresolved.push_back({phase, tau, "an orbit whose slip or stick may last no time at all"});
    return;
  }
  const model::SymmetricRows<Ball> rows = model::symmetric_rows(data, tau);
  const int j = *pivot_row(rows);
  SymmetricOrbit orbit = describe_symmetric(a, phase, Box<2>(tau, rows.right(j) / rows.left(j)));
  orbit.tau_unique = data.Theta * found.unique(0);
  arb_zero_pm_inf(orbit.C_unique.raw());
  list.orbits.push_back(orbit);
}

}  // namespace

SymmetricList list_symmetric(const ExactParameters& a, int digits) {
  require_stick_slip_domain(a);
  SymmetricList list;
  list.load_absent = a.p == 0;
  const EndZeros zeros = end_zeros(a);
  list.closes_without_stick = zeros.resonant[0] || zeros.resonant[1];
  for (const LoadPhase phase : {LoadPhase::first, LoadPhase::second}) {
    if (phase == LoadPhase::second && list.load_absent) {
      continue;
    }
    SearchResult<1> result;
    {
      const WorkingPrecision scope(search_bits);
      const Eliminant f = eliminant(a, phase);
      result = search<1>({{0}, {1}}, Contractor{f, zeros}, Decider{f});
      for (const UnresolvedBox<1>& open : result.unresolved) {
        list.unresolved.push_back({phase, f.closing.data.Theta * open.box(0), open.reason});
      }
    }
    std::sort(result.zeros.begin(), result.zeros.end(),
              [](const auto& x, const auto& y) { return x.zero(0).approximate() < y.zero(0).approximate(); });
    for (const FoundZero<1>& found : result.zeros) {
      conclude(a, phase, found, digits, list);
    }
    list.cells += result.cells;
  }
  return list;
}

}  // namespace stickslip::numeric::families
