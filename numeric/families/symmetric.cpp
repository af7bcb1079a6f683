#include "numeric/families/symmetric.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "numeric/families/through_phases/end_rows.hpp"
#include "numeric/families/through_phases/isolate.hpp"

namespace stickslip::numeric::families {

using namespace motion;
using namespace scalars;
using namespace zeros;

namespace {

using Vector1 = Box<1>;
using Data = model::SymmetricData<Ball>;

// Which rows vanish identically at an end: decided in rationals.
struct EndZeros {
  bool origin;                   // omega = 1/k: both left sides vanish at tau = 0
  std::array<bool, 2> resonant;  // omega_j = k omega, k > 1: row j vanishes at T = 0
};

EndZeros end_zeros(const ExactParameters& a) {
  const Resonances k = resonances(a);
  return {a.omega.get_num() == 1, {k.first > 1, k.second > 1}};
}

EndRows end_rows(const Data& d, const Ball& t) {
  return {d.m, d.omega, t};
}

// omega = 1/k. At tau = 0 the left sides vanish and the right sides are V omega_k² omega_j Theta/2 > 0: no
// orbit. Beside it the divided eliminant decides.
bool excluded_at_origin(const Data& data, const Ball& tau) {
  const EndRows end = end_rows(data, tau);
  const model::Vector2<Ball> right = model::symmetric_rows(data, tau).right;
  const Ball quotient =
      end.left(data.m.omega2, data.m.lambda1) * right(0) - end.left(data.m.omega1, data.m.lambda2) * right(1);
  return end.applies() && quotient.is_nonzero() && right(0).is_positive();
}

// omega_j = k omega: row j holds at T = 0 whatever C. For T > 0 the divided eliminant decides.
bool excluded_before_end(const Data& data, const std::array<bool, 2>& resonant, const Ball& tau) {
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

// C at tau, from the row whose left side keeps farther away from zero; nothing when both may vanish.
std::optional<Ball> amplitude(const Data& data, const Ball& tau) {
  const model::SymmetricRows<Ball> rows = model::symmetric_rows(data, tau);
  const int j = magnitude(rows.left(0)) > magnitude(rows.left(1)) ? 0 : 1;
  for (const int k : {j, 1 - j}) {
    if (rows.left(k).is_nonzero()) {
      return rows.right(k) / rows.left(k);
    }
  }
  return std::nullopt;
}

std::vector<NamedBall> tau_and_phi(const Data& data, const Ball& tau) {
  return {{"tau", tau}, {"phi", model::symmetric_phase<Ball>(data, Ball::pi(), tau)}};
}

// For the search.
struct Searched {
  SymmetricEliminant f;
  EndZeros zeros;

  // Krawczyk's contractor, helped out at the ends where the eliminant has a multiple zero that is no
  // stick-slip orbit.
  [[nodiscard]] std::optional<Vector1> contract(const Vector1& X) const {
    const Ball tau = f.data.Theta * X(0);
    const bool at_end = (X(0) - Ball(1)).contains_zero() && (zeros.resonant[0] || zeros.resonant[1]);
    if ((zeros.origin && X(0).contains_zero() && excluded_at_origin(f.data, tau)) ||
        (at_end && excluded_before_end(f.data, zeros.resonant, tau))) {
      return std::nullopt;
    }
    return contract_by_krawczyk<1>(f, X);
  }
  // A zero of the eliminant is an orbit when C can be had from a row.
  [[nodiscard]] ZeroProof<1> decide(const Vector1& X) const {
    ZeroProof<1> decision = decide_by_krawczyk<1>(f, X);
    if (decision.verdict.truth == Truth::proved && !amplitude(f.data, f.data.Theta * decision.box(0))) {
      decision.verdict = Verdict::undecided(
          "the amplitude $C$ cannot be eliminated: both of its coefficients may vanish here");
    }
    return decision;
  }
  [[nodiscard]] std::optional<Unresolved> left_open(const UnresolvedBox<1>& open) const {
    return Unresolved{tau_and_phi(f.data, f.data.Theta * open.box(0)), open.reason};
  }
};

// The zero refined and looked at: an orbit of the list, outside the domain, or at its very end.
Concluded<Candidate> conclude(const ExactParameters& a, LoadPhase phase, const ZeroProof<1>& found) {
  const auto here = [&] { return SymmetricEliminant{symmetric_data(a, phase)}; };
  const Vector1 u = refine<1>(here, found.box, guess_bits);
  const Data data = here().data;
  const Ball tau = data.Theta * u(0);
  const std::vector<NamedBall> where = tau_and_phi(data, tau);
  return concluded<Candidate>(place(u(0)), where, [&] {
    const Closing equations = SymmetricClosing{phase};
    Vector tau_C(2);
    tau_C << tau, *amplitude(data, tau);
    const auto is_same = [unique = found.unique](const Motion& motion) {
      return unique(0).contains(motion.phases[0].duration / period(motion));
    };
    return Candidate{
        {equations.motion<Ball>(tau_C, equations.parameters({parameters_as<Ball>(a)})), where, is_same},
        equations,
        phase == LoadPhase::first ? 0 : 1};
  });
}

void search_phase(const ExactParameters& a, LoadPhase phase, const EndZeros& zeros, Found& result) {
  Found found = isolate<Candidate, 1>(
      {{0}, {1}}, {},
      [&] {
        return Searched{{symmetric_data(a, phase)}, zeros};
      },
      [&](const ZeroProof<1>& zero) { return conclude(a, phase, zero); });
  std::ranges::move(found.candidates, std::back_inserter(result.candidates));
  std::ranges::move(found.unresolved, std::back_inserter(result.unresolved));
  result.cells += found.cells;
}

// Both load phases; what stays open is a multiple zero, an orbit whose stick or slip may last no time at all,
// or a tau at which C cannot be eliminated.
Found search_symmetric(const Given<Rational>& given) {
  const ExactParameters& a = given.data;
  require_stick_slip_domain(a);
  Found result;
  const EndZeros zeros = end_zeros(a);
  search_phase(a, LoadPhase::first, zeros, result);
  if (a.p == 0) {  // both load phases have the same orbits
    result.remarks.push_back(Remark::load_absent);
  } else {
    search_phase(a, LoadPhase::second, zeros, result);
  }
  // At T = 0 (13) and (15) then hold for a motion that slips all the time.
  if (zeros.resonant[0] || zeros.resonant[1]) {
    result.remarks.push_back(Remark::closes_without_stick);
  }
  return result;
}

// The eliminant at u = tau/Theta, and (tau, C).
struct OverStrip {
  LoadPhase phase;

  template <class T, class S>
  [[nodiscard]] Reduced<T> operator()(const Given<T>& given, const T& u, const T& /*none*/) const {
    const model::SymmetricData<T> data{model::reduced_data<T>(given.data, T(scalars::pi<S>())),
                                       T(phase == LoadPhase::first ? 1 : -1)};
    const T tau = data.Theta * u;
    const model::SymmetricRows<T> rows = model::symmetric_rows<T>(data, tau);
    Reduced<T> result{{T(rows.left(1) * rows.right(0) - rows.left(0) * rows.right(1))}};
    for (const int k : {0, 1}) {
      const auto size = [&](const T& x) { return std::abs(x.at.approximate()); };
      const T &left = rows.left(k), &right = rows.right(k);
      if (is_nonzero(left) && (result.x.empty() || size(left) > size(rows.left(0)))) {
        result.x = {ends(tau.over), ends(T(right / left).over)};
      }
      if (is_nonzero(right)) {
        result.large.push_back({1, {1}, {ends(tau.over), ends(T(left / right).over)}});
      }
    }
    return result;
  }
};

std::vector<Strip> symmetric_strips(const StripQuestion& q) {
  std::vector<Strip> strips;
  for (const LoadPhase phase : {LoadPhase::first, LoadPhase::second}) {
    if (phase == LoadPhase::first || q.given.data.p != 0 || q.place == 5) {
      strips.push_back(strip_of(q, static_cast<int>(phase), -1, {{0, 0, 0}, {1, 0, 1}}, OverStrip{phase}));
    }
  }
  return strips;
}

}  // namespace

Vector SymmetricClosing::unknowns(const Motion& motion) const {
  if (motion.phases.size() != 2) {
    throw InternalError("a symmetric motion with other phases than a slip and a stick");
  }
  const model::Parameters<Ball>& a = motion.oscillator.data;
  const Phase& slip = motion.phases[0];
  const Ball half_T = motion.phases[1].duration / Ball(2);
  Vector x(2);
  x << slip.duration, (slip.Z(0) - a.chi * slip.Z(1)) * sin(half_T) + (slip.Z(2) - a.chi * a.V) * cos(half_T);
  return x;
}

model::SymmetricData<Ball> symmetric_data(const ExactParameters& a, LoadPhase phase) {
  return SymmetricClosing{phase}.data<Ball>(
      Closing(SymmetricClosing{phase}).parameters({parameters_as<Ball>(a)}));
}

const Family& symmetric() {
  static const Family family{
      .name = "symmetric",
      .title = "Symmetric orbits: slip on $(0, tau)$, stick on $(tau, Theta)$",
      .phases = {PhaseKind::slip, PhaseKind::stick},
      .durations = {"tau", "T"},
      .requirements = joined(
          {sound_data({"tau", "T"}),
           slip_after_stick(),
           sticks_at("14", 1, "tau"),
           {{"f1", "$f1 <= 0$ for $tau < t < Theta$", Quantity::below_ur, 1, true, {false, true}, false},
            {"f2", "$f2 > 0$ for $tau < t < Theta$", Quantity::above_minus_ur, 1, true}}}),
      .why_no_phi = "phi is not given for symmetric orbits: the symmetry fixes it, (pi - omega tau)/2",
      .why_no_ur = "ur is not given for symmetric orbits: it is a result, by (12)",
      .why_datum = "",
      .searched =
          [](const OrbitQuestion&) {
            return std::string(
                "$0 <= tau <= Theta$ at both load phases, $phi = (pi - omega tau)/2$ and that $+ pi$");
          },
      .search = search_symmetric,
      .strips = symmetric_strips,
      .judges = &atlas::symmetric_judges,
      .belt = 1,
      .is_symmetric = true,
      .growths = {{{1}, {}, {}}}};  // C
  return family;
}

}  // namespace stickslip::numeric::families
