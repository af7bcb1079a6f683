#include "numeric/atlas/judge.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "numeric/atlas/along.hpp"
#include "numeric/atlas/multipliers.hpp"
#include "numeric/atlas/sheets.hpp"
#include "numeric/atlas/zeros_over.hpp"

namespace stickslip::numeric::atlas {

using motion::Requirement;

namespace {

constexpr long arb_bits = 64;
// Boxes narrower than this, as a share of the parameter, are too narrow for doubles.
constexpr double too_narrow = 0x1p-26;

// ---- the domain, exactly

enum class Where { inside, outside, across };

// Each bound is on one parameter, but for ur > us.
Where place(const Question& q, const Box& box) {
  const bool sticks = families::has_stick(*q.family);
  Where where = Where::inside;
  const auto see = [&](bool all, bool none) {
    where = none || where == Where::outside ? Where::outside : all ? where : Where::across;
  };
  const auto above = [&](const Interval& x, const Rational& bound) {
    see(x.lower > bound, x.upper <= bound);
  };
  above(box[place_of_chi], 0);
  see(box[place_of_chi].upper < 1, box[place_of_chi].lower >= 1);
  above(box[place_of_eta], 0);
  above(box[place_of_us], 0);
  above(box[place_of_omega], 0);
  see(box[place_of_p].lower >= 0, box[place_of_p].upper < 0);
  if (sticks) {
    above(box[place_of_V], 0);
  }
  if (box.size() > place_of_ur) {
    see(box[place_of_ur].lower > box[place_of_us].upper, box[place_of_ur].upper <= box[place_of_us].lower);
  }
  return where;
}

// ---- the box as forms

// A double not below the number, which is not negative.
double above(const Rational& x) {
  return x == 0 ? 0 : std::nextafter(x.get_d(), INFINITY);
}

template <class T, class S>
struct Data {
  model::Parameters<T> parameters;
  std::optional<T> ur;
  double width = 0;  // the largest share of a parameter that a radius is
};

// Variable 0 is left free.
template <class T, class S>
Data<T, S> forms_of(const Box& box) {
  Data<T, S> data;
  std::vector<T> all;
  int next = 1;
  for (const Interval& x : box) {
    if (x.is_point()) {
      all.push_back(T(scalars::scalar<S>(x.lower)));
      continue;
    }
    const double middle = Rational((x.lower + x.upper) / 2).get_d();
    const double radius = std::max(above(x.upper - Rational(middle)), above(Rational(middle) - x.lower));
    all.push_back(T::variable(middle, radius, next++));
    data.width = std::max(data.width, middle == 0 ? 1 : radius / std::abs(middle));
  }
  data.parameters = {all[0], all[1], all[2], all[3], all[4], all[5]};
  if (all.size() > place_of_ur) {
    data.ur = all[place_of_ur];
  }
  return data;
}

// ---- what stands in the way of every orbit of the box

template <class T>
bool may_be_resonant(const model::Oscillator<T>& o, bool sticks) {
  for (const T& omega_j : {o.modes.omega1, o.modes.omega2}) {
    const auto [low, high] = scalars::ends(T(omega_j / o.data.omega).over);
    const double first = std::max(std::ceil(low), 1.0);
    // For orbits that stick only the load's own frequency matters: there (7) has no Q.
    if (!(high < first) && (!sticks || first == 1)) {
      return true;
    }
  }
  return false;
}

// ---- one orbit

struct Judged {
  Truth admissible = Truth::undecided;
  Truth stable = Truth::undecided;
  std::uint8_t reason = 0;
};

// The requirements that an orbit of a family that never sticks has to meet when ur is not given: that some ur
// > us is small enough, so (25) and (26) at ur = us.
bool is_asked(const Requirement& q, bool ur_known) {
  return ur_known || q.quantity != motion::Quantity::friction_step;
}

template <class S, int N>
Judged judge_orbit(const Question& q, const Data<scalars::Form<S, N>, S>& data,
                   const motion::MotionOf<scalars::Form<S, N>>& motion, bool without_load) {
  using T = scalars::Form<S, N>;
  const families::Family& family = *q.family;
  const motion::PhaseOf<T>& first = motion.phases.front();
  const bool sticks = families::has_stick(family);
  const bool ur_known = sticks || data.ur.has_value();
  const T ur = sticks ? T(model::friction_at<T>(data.parameters, first.Z, first.load))
                      : data.ur.value_or(data.parameters.us);
  std::vector<model::PhaseWaves<T>> waves;
  for (const motion::PhaseOf<T>& phase : motion.phases) {
    waves.push_back(motion::waves_of<T>(motion.oscillator, phase));
  }
  const double least = std::clamp(data.width / 16, 0x1p-30, 0x1p-5);
  Judged result;
  for (std::size_t k = 0; k < family.requirements.size(); ++k) {
    if (!is_asked(family.requirements[k], ur_known)) {
      continue;
    }
    const Truth truth = holds_over<S, N>(family.requirements[k], motion, waves, ur, least);
    if (truth == Truth::refuted) {
      return {Truth::refuted, Truth::refuted, 0};
    }
    if (truth != Truth::proved && result.reason == 0) {
      result.reason = static_cast<std::uint8_t>(static_cast<std::size_t>(Reason::condition) + k);
    }
  }
  if (result.reason != 0) {
    return result;
  }
  // Without load each shift in time of the orbit is an orbit: none attracts all of its neighbours.
  const Truth stable =
      without_load ? Truth::refuted : is_inside_unit_circle(characteristic_polynomial<T>(motion));
  return {Truth::proved, stable,
          static_cast<std::uint8_t>(stable == Truth::undecided ? Reason::stability : Reason::none)};
}

Finding open(Reason reason) {
  return {-1, -1, -1, static_cast<std::uint8_t>(reason)};
}

template <class S, int N>
Finding judge_inside(const Question& q, const Box& box) {
  using T = scalars::Form<S, N>;
  const Data<T, S> data = forms_of<T, S>(box);
  const model::Oscillator<T> o = model::oscillator<T>(data.parameters);
  const bool sticks = families::has_stick(*q.family);
  if (may_be_resonant(o, sticks)) {
    return open(Reason::resonance);
  }
  const Sheets<T> found = sticks ? symmetric_sheets<T, S>(o, box) : nonsticking_sheets<T, S>(o, box);
  if (const auto * reason = std::get_if<Reason>(&found)) {
    return open(*reason);
  }
  const auto& sheets = std::get<std::vector<Sheet<T>>>(found);
  const double least = std::clamp(data.width / 16, 0x1p-30, 0x1p-5);
  const bool without_load = box[place_of_p].is_point() && box[place_of_p].lower == 0;
  Finding finding{0, 0, 0, 0};
  std::vector<motion::MotionOf<T>> motions;
  for (const Sheet<T>& sheet : sheets) {
    std::vector<T> zeros;
    if (!sheet.value) {
      zeros.push_back(T(1) / T(2));
    } else {
      const auto brackets = zeros_over<S, N>(sheet.value, sheet.slope, least);
      if (const auto * reason = std::get_if<Reason>(&brackets)) {
        return open(*reason);
      }
      for (const Bracket& bracket : std::get<std::vector<Bracket>>(brackets)) {
        zeros.push_back(sheet.never_admissible ? T(0) : zero_over<S, N>(sheet.value, sheet.slope, bracket));
      }
    }
    const std::size_t orbits = static_cast<std::size_t>(finding.orbits) + zeros.size();
    if (orbits > most_orbits) {
      return open(Reason::too_many);
    }
    finding.orbits = static_cast<std::int8_t>(orbits);
    for (std::size_t k = 0; k < zeros.size() && !sheet.never_admissible; ++k) {
      const auto motion = sheet.motion(zeros[k]);
      if (const auto * reason = std::get_if<Reason>(&motion)) {
        return open(*reason);
      }
      motions.push_back(std::get<motion::MotionOf<T>>(motion));
    }
  }
  bool stability_known = true;
  for (const motion::MotionOf<T>& motion : motions) {
    const Judged one = judge_orbit<S, N>(q, data, motion, without_load);
    finding.reason = finding.reason == 0 ? one.reason : finding.reason;
    if (one.admissible == Truth::undecided) {
      return {finding.orbits, -1, -1, one.reason};
    }
    finding.admissible =
        static_cast<std::int8_t>(finding.admissible + (one.admissible == Truth::proved ? 1 : 0));
    finding.stable = static_cast<std::int8_t>(finding.stable + (one.stable == Truth::proved ? 1 : 0));
    stability_known = stability_known && one.stable != Truth::undecided;
  }
  finding.stable = stability_known ? finding.stable : std::int8_t{-1};
  return finding;
}

template <class S>
Finding judge_with(const Question& q, const Box& box) {
  return q.axes.size() <= 2 ? judge_inside<S, 3>(q, box) : judge_inside<S, 5>(q, box);
}

}  // namespace

Finding judge(const Question& q, Tile tile, Balls balls) {
  const WorkingPrecision scope(arb_bits);
  const Box box = box_of(q, tile);
  switch (place(q, box)) {
    case Where::outside:
      return open(Reason::outside);
    case Where::across:
      return open(Reason::reaches_out);
    case Where::inside:
      break;
  }
  if (balls == Balls::hardware) {
    return judge_with<scalars::HardwareBall>(q, box);
  }
  return judge_with<Ball>(q, box);
}

Finding judge(const Question& q, Tile tile) {
  const Finding finding = judge(q, tile, Balls::hardware);
  if (finding.is_decided() || depth(tile) < 26 * static_cast<int>(q.axes.size())) {
    return finding;
  }
  return judge(q, tile, Balls::arb);
}

}  // namespace stickslip::numeric::atlas
