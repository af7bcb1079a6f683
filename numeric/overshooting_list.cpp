#include "numeric/overshooting.hpp"

#include <algorithm>
#include <cmath>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/end_rows.hpp"
#include "numeric/overshooting_rows.hpp"
#include "numeric/symmetric.hpp"

namespace stickslip {
namespace {

constexpr long search_bits = 64;
constexpr SearchLimits limits{.smallest = 0x1p-20, .cells = 30000};

// One equation of a cheap test: value over the box, and what its mean value form leaves of it.
template <class G>
[[nodiscard]] std::optional<Box<2>> contract_by_one(const G& g, const Box<2>& X) {
  const Jet<Ball, 2> jet = g(variables<Ball, 2>(X));
  if (jet.value.is_nonzero()) {
    return std::nullopt;
  }
  const Box<2> m = midpoint<2>(X);
  return contract_by<2>(g(m), Eigen::Matrix<Ball, 1, 2>(jet.partials[0], jet.partials[1]), m, X);
}

// ---- phi given ----

using AtPhase = OvershootingAtPhase<Ball>;

// The odd row with the larger left side at the middle of the box eliminates C.
AtPhase adapted(AtPhase f, const Box<2>& X) {
  const AtPhase::Odd<Ball> o = f.odd<Ball>(f.data, times<Ball>(f.data.Theta, midpoint<2>(X)));
  f.pivot = magnitude(o.left(0)) > magnitude(o.left(1)) ? 0 : 1;
  return f;
}

std::optional<Box<2>> contract_cheaply(const AtPhase& f, const Box<2>& X) {
  return contract_by_one([&](const auto& sw) { return f.first(sw); }, X);
}

// omega = 1/k: the left sides vanish like (tau + tau1)³ and the right sides do not. Divided out.
bool excluded_at_origin(const AtPhase& f, const Box<2>& X) {
  const Times<Ball> t = times<Ball>(f.data.Theta, X);
  const model::Modes<Ball>& m = f.data.m;
  const EndRows end{m, f.data.omega, t.tau + t.tau1};
  const AtPhase::Odd<Ball> o = f.odd<Ball>(f.data, t);
  return end.applies() && o.right(0).is_nonzero() &&
         (end.left(m.omega1, m.lambda2) * o.right(1) - end.left(m.omega2, m.lambda1) * o.right(0))
             .is_nonzero();
}

// At a zero of both determinants: C from the pivot, (a, D) from the pair of rows with the largest minor.
// Nothing when a divisor may vanish; else the amplitudes exist and are unique and all five equations hold:
// the other odd row because the first determinant vanishes, the third row because the second does.
std::optional<StickAmplitudes> amplitudes(const AtPhase& f, const Box<2>& sw) {
  const Times<Ball> t = times<Ball>(f.data.Theta, sw);
  const AtPhase::Odd<Ball> o = f.odd<Ball>(f.data, t);
  const Eigen::Matrix<Ball, 3, 3> m = f.even<Ball>(f.data, t, o);
  std::optional<StickAmplitudes> best;
  double largest = 0;
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
    const Ball minor = det2<Ball>(m(i, 0), m(i, 1), m(j, 0), m(j, 1));
    if (minor.is_nonzero() && o.left(f.pivot).is_nonzero() && magnitude(minor) > largest) {
      largest = magnitude(minor);
      best = StickAmplitudes{det2<Ball>(m(i, 1), m(i, 2), m(j, 1), m(j, 2)) / minor,
                             -o.right(f.pivot) / o.left(f.pivot),
                             det2<Ball>(m(i, 2), m(i, 0), m(j, 2), m(j, 0)) / minor, f.phi};
    }
  }
  return best;
}

// ---- u_r given ----

using AtFriction = OvershootingAtFriction<Ball>;

// cos psi from the three rows with the largest determinant at the middle of the box.
AtFriction adapted(AtFriction f, const Box<2>& X) {
  const Times<Ball> t = times<Ball>(f.data.Theta, midpoint<2>(X));
  const Eigen::Matrix<Ball, 4, 4> m = f.rows<Ball>(f.data, t, f.odd<Ball>(f.data, t));
  double largest = -1;
  int best = 3;
  for (f.left_out = 0; f.left_out < 4; ++f.left_out) {
    const double size = magnitude(det3<Ball, 4, 4>(m, f.kept(), {0, 1, 2}));
    if (size > largest) {
      largest = size;
      best = f.left_out;
    }
  }
  f.left_out = best;
  return f;
}

// Where both odd rows may be multiples of each other their minors say nothing, and both functions can vanish
// without an orbit. There one odd row at a time and the other four equations are solved for (a, C, D, cos
// psi, sin psi): no orbit when cos² psi + sin² psi = 1 or the odd row left out cannot hold.
bool excluded_by_all_rows(const AtFriction& f, const Box<2>& X) {
  const Times<Ball> t = times<Ball>(f.data.Theta, X);
  const auto odd = model::overshooting_odd<Ball>(f.data, t.tau, t.tau1);
  const auto [even1, even2] = model::overshooting_even<Ball>(f.data, t.tau, t.tau1);
  const std::array<model::OvershootingRow<Ball>, 4> others{
      even1, even2, model::overshooting_turn<Ball>(f.data, t.tau, t.tau1),
      model::overshooting_friction<Ball>(f.data, f.ur, t.tau, t.tau1)};
  for (const std::size_t j : {0U, 1U}) {
    Eigen::Matrix<Ball, 5, 5> A;
    Eigen::Matrix<Ball, 5, 1> b;
    for (int i = 0; i < 5; ++i) {
      const model::OvershootingRow<Ball>& row = i == 0 ? odd[j] : others[static_cast<std::size_t>(i - 1)];
      A.row(i) << row.a, row.C, row.D, row.cos_psi, row.sin_psi;
      b(i) = -row.one;
    }
    const std::optional<Eigen::Matrix<Ball, 5, 1>> x = enclose_solution<5>(A, b);
    if (x) {
      const model::OvershootingRow<Ball>& other = odd[1 - j];
      const Ball norm = (*x)(3) * (*x)(3) + (*x)(4) * (*x)(4) - Ball(1);
      const Ball residual = other.C * (*x)(1) + other.sin_psi * (*x)(4) + other.one;
      if (norm.is_nonzero() || residual.is_nonzero()) {
        return true;
      }
    }
  }
  return false;
}

// |sin psi| > 1 all over the box: sin psi ∓ 1, times the denominator, have the same sign.
std::optional<Box<2>> contract_cheaply(const AtFriction& f, const Box<2>& X) {
  const model::OvershootingData<Jet<Ball, 2>> d = model::lift<Jet<Ball, 2>>(f.data);
  const Box<2> m = midpoint<2>(X);
  const auto jets = f.odd<Jet<Ball, 2>>(d, times<Jet<Ball, 2>>(d.Theta, variables<Ball, 2>(X)));
  const auto at_m = f.odd<Ball>(f.data, times<Ball>(f.data.Theta, m));
  const auto range = [&](const Jet<Ball, 2>& jet, const Ball& middle) {
    const Ball form = middle + jet.partials[0] * (X(0) - m(0)) + jet.partials[1] * (X(1) - m(1));
    return intersection(form, jet.value).value_or(form);
  };
  const Ball below = range(jets.sin_psi - jets.over, at_m.sin_psi - at_m.over);
  const Ball above = range(jets.sin_psi + jets.over, at_m.sin_psi + at_m.over);
  const bool excluded =
      (below.is_positive() && above.is_positive()) || (below.is_negative() && above.is_negative());
  const bool degenerate = jets.over.value.contains_zero() && radius_exponent<2>(X) < -5;
  if (excluded || (degenerate && excluded_by_all_rows(f, X))) {
    return std::nullopt;
  }
  return X;
}

// omega = 1/k: the coefficients of C and sin psi vanish like t³, t = tau + tau1, and the rest does not.
bool excluded_at_origin(const AtFriction& f, const Box<2>& X) {
  const Times<Ball> t = times<Ball>(f.data.Theta, X);
  const model::Modes<Ball>& m = f.data.m;
  const Ball total = t.tau + t.tau1;
  const EndRows end{m, f.data.omega, total};
  const auto [x, y] = model::overshooting_odd<Ball>(f.data, t.tau, t.tau1);
  const Ball left1 = end.left(m.omega1, m.lambda2);
  const Ball left2 = end.left(m.omega2, m.lambda1);
  const Ball load1 = f.data.p * end.transfer(m.omega1, f.data.omega);
  const Ball load2 = f.data.p * end.transfer(m.omega2, f.data.omega);
  const Ball sine = abs(det2<Ball>(x.one, left1, y.one, left2));
  const Ball over = abs(det2<Ball>(left1, load1, left2, load2)) * total * total * total;
  return end.applies() && (sine - over).is_positive();
}

Ball angle(const Ball& sine, const Ball& cosine) {
  Ball result;
  arb_atan2(result.raw(), sine.raw(), cosine.raw(), WorkingPrecision::bits());
  return result;
}

// At a zero of both functions. Nothing when a denominator may vanish; else the amplitudes and the phase exist
// and are unique and all six equations hold with cos² psi + sin² psi = 1.
std::optional<StickAmplitudes> amplitudes(const AtFriction& f, const Box<2>& sw) {
  const Times<Ball> t = times<Ball>(f.data.Theta, sw);
  const AtFriction::Odd<Ball> o = f.odd<Ball>(f.data, t);
  const Eigen::Matrix<Ball, 4, 4> m = f.rows<Ball>(f.data, t, o);
  const std::array<int, 3> kept = f.kept();
  const Ball scale = det3<Ball, 4, 4>(m, kept, {0, 1, 2});
  const Ball denominator = scale * o.over;
  if (!denominator.is_nonzero()) {
    return std::nullopt;
  }
  const auto solved = [&](std::array<int, 3> columns) {
    return -det3<Ball, 4, 4>(m, kept, columns) / denominator;
  };
  Ball phi = angle(o.sin_psi / o.over, solved({0, 1, 3})) - f.data.omega * (t.tau + t.tau1) / Ball(2);
  const Ball turn = Ball(2) * Ball::pi();
  phi += turn * Ball(-std::floor((phi / turn).approximate() + 0.5));
  return StickAmplitudes{solved({3, 1, 2}), o.C / o.over, solved({0, 3, 2}), phi};
}

// ---- both ----

// A proved zero of the two functions, refined and looked at.
struct Concluded {
  bool outside = false;  // of the triangle
  Times<Ball> times;
  std::string reason;  // why it is no proved orbit
  std::optional<OvershootingOrbit> orbit;
};

// recipe(): the functions at the working precision.
template <class Recipe>
Concluded conclude(const ExactParameters& a, const Recipe& recipe, const FoundZero<2>& found, int digits) {
  const auto here = [&] { return adapted(recipe(), found.zero); };
  const Box<2> sw = refine<2>(here, found.zero, bits_for(digits));
  const WorkingPrecision scope(bits_for(digits) + 64);
  const auto f = here();
  Concluded result;
  result.times = times<Ball>(f.data.Theta, sw);
  bool inside = true;
  for (int i = 0; i < 2; ++i) {
    const Ball beyond = sw(i) - Ball(1);
    result.outside = result.outside || sw(i).is_negative() || beyond.is_positive();
    inside = inside && sw(i).is_positive() && beyond.is_negative();
  }
  if (!inside) {
    result.reason = "an orbit one of whose phases may last no time at all";
    return result;
  }
  const std::optional<StickAmplitudes> amplitude = amplitudes(f, sw);
  if (!amplitude) {
    result.reason = "the amplitudes cannot be eliminated: their determinant may vanish here";
    return result;
  }
  result.orbit = describe_overshooting(a, result.times.tau, result.times.tau1, *amplitude);
  result.orbit->unique = found.unique;
  return result;
}

template <class Recipe>
OvershootingList list_all(const ExactParameters& a, const Recipe& recipe, int digits) {
  OvershootingList list;
  SearchResult<2> result;
  {
    const WorkingPrecision scope(search_bits);
    const auto f = recipe();
    using F = std::remove_const_t<decltype(f)>;
    const bool vanishes_at_origin = a.omega.get_num() == 1;
    const auto contract = [&](const Box<2>& X) -> std::optional<Box<2>> {
      if (vanishes_at_origin && X(0).contains_zero() && excluded_at_origin(f, X)) {
        return std::nullopt;
      }
      const std::optional<Box<2>> rest = contract_cheaply(f, X);
      return rest ? KrawczykContractor<2, F>{adapted(f, *rest)}(*rest) : std::nullopt;
    };
    const auto decide = [&](const Box<2>& X) { return KrawczykDecider<2, F>{adapted(f, X)}(X); };
    result = search<2>({{0, 0}, {1, 1}}, contract, decide, limits);
    for (const UnresolvedBox<2>& open : result.unresolved) {
      const Times<Ball> t = times<Ball>(f.data.Theta, open.box);
      list.unresolved.push_back({t.tau, t.tau1, open.reason});
    }
  }
  list.cells = result.cells;
  std::sort(result.zeros.begin(), result.zeros.end(),
            [](const auto& x, const auto& y) { return x.zero(0).approximate() < y.zero(0).approximate(); });
  for (const FoundZero<2>& found : result.zeros) {
    const Concluded zero = conclude(a, recipe, found, digits);
    if (zero.orbit) {
      list.orbits.push_back(*zero.orbit);
    } else if (!zero.outside) {
      list.unresolved.push_back({zero.times.tau, zero.times.tau1, zero.reason});
    }
  }
  return list;
}

auto at_phase(const ExactParameters& a, const Rational& phi) {
  return [&a, &phi] { return AtPhase{overshooting_data<Ball>(a), Ball(phi), 0}; };
}

}  // namespace

OvershootingList list_overshooting_at_phase(const ExactParameters& a, const Rational& phi, int digits) {
  require_stick_slip_domain(a);
  return list_all(a, at_phase(a, phi), digits);
}

OvershootingProof prove_overshooting_at_phase(const ExactParameters& a, const Rational& phi,
                                              const model::Vector2<double>& guess, int digits) {
  require_stick_slip_domain(a);
  ZeroProof<2> zero;
  {
    const WorkingPrecision scope(128);
    const AtPhase f = at_phase(a, phi)();
    const Ball total = Ball(guess(0)) + Ball(guess(1));
    const Box<2> sw(total / f.data.Theta, Ball(guess(1)) / total);
    zero = prove_zero_near<2>(adapted(f, sw), sw);
  }
  if (zero.verdict.truth != Truth::proved) {
    return {zero.verdict, {}};
  }
  const Concluded concluded = conclude(a, at_phase(a, phi), {zero.box, zero.unique}, digits);
  if (!concluded.orbit) {
    return {Verdict::undecided(concluded.reason), {}};
  }
  return {zero.verdict, *concluded.orbit};
}

OvershootingList list_overshooting_at_friction(const ExactParameters& a, const Rational& ur, int digits) {
  require_stick_slip_domain(a);
  if (a.p == 0) {
    throw DomainError("p", to_string(a.p), "p > 0 when ur is given and the load's phase is unknown");
  }
  if (ur <= 0) {
    throw DomainError("ur", to_string(ur), "ur > 0");
  }
  return list_all(
      a,
      [&] {
        return AtFriction{overshooting_data<Ball>(a), Ball(ur), 3};
      },
      digits);
}

}  // namespace stickslip
