#include "numeric/atlas/judge.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "numeric/atlas/judging.hpp"
#include "numeric/atlas/symmetric_orbit.hpp"
#include "numeric/atlas/zeros_over.hpp"

namespace stickslip::numeric::atlas {

namespace {

constexpr long arb_bits = 64;
constexpr int enough_for_doubles = 26;  // halvings of a side
// Of the finest boxes. Arb's radii, of 30 bits and in sines to first order only, are a little wider than
// those of the hardware balls: what these decided they have to decide again.
constexpr int more_halvings = 14;
constexpr int more_for_arb = 4;

// ---- the domain, exactly

enum class Where { inside, outside, across };

// Each bound is on one parameter, except for ur > us.
Where place(const Question& q, const Box& box) {
  const bool sticks = families::has_stick(*q.family);
  Where where = Where::inside;
  const auto see = [&](bool all, bool none) {
    where = none || where == Where::outside ? Where::outside : all ? where : Where::across;
  };
  const auto above = [&](const Interval& x, const Rational& bound) {
    see(x.lower > bound, x.upper <= bound);
  };
  if (sticks) {
    above(belt_of(q, box), 0);
  }
  if (q.is_in_SI()) {
    return where;  // require_understood has seen to the rest
  }
  above(box[place_of_chi], 0);
  see(box[place_of_chi].upper < 1, box[place_of_chi].lower >= 1);
  above(box[place_of_eta], 0);
  above(box[place_of_us], 0);
  above(box[place_of_omega], 0);
  see(box[place_of_p].lower >= 0, box[place_of_p].upper < 0);
  if (box.size() > place_of_datum && !takes_phi(*q.family)) {
    const Interval& ur = box[place_of_datum];
    see(ur.lower > box[place_of_us].upper, ur.upper <= box[place_of_us].lower);
  }
  return where;
}

// Whether a natural frequency may be a multiple of the load's, for orbits that never stick.
template <class T>
bool may_be_resonant(const model::Oscillator<T>& o) {
  for (const T& omega_j : {o.modes.omega1, o.modes.omega2}) {
    const auto [low, high] = scalars::ends(T(omega_j / o.data.omega).over);
    if (!(high < std::max(std::ceil(low), 1.0))) {
      return true;
    }
  }
  return false;
}

// ---- all orbits of a family with one unknown

// An orbit that never sticks over a box of parameters: what it has to obey, and its multipliers.
template <class T>
struct NonstickingOrbit : MotionOver<T> {
  T share;  // of the slip in the period

  // The orbit of the sheet at the share u; nothing when it may be two. When ur is not given, some ur > us has
  // to be small enough: (25) and (26) at ur = us.
  [[nodiscard]] static std::optional<NonstickingOrbit> at(const Sheet& sheet, const Setting<T>& s, const T& u,
                                                          const std::optional<T>& ur) {
    auto motion = motion_of<T>(sheet, s, u);
    return motion ? std::optional(NonstickingOrbit{{std::move(*motion), ur}, u}) : std::nullopt;
  }

  [[nodiscard]] Decision stability() const {
    return stability_without_stick<T>(this->motion.oscillator, share);
  }
};

// Orbit: SymmetricOrbit or NonstickingOrbit.
template <template <class> class OrbitOf, class S, int N>
class Judge {
  using T = scalars::Form<S, N>;
  using Orbit = OrbitOf<T>;
  static constexpr bool sticks = std::is_same_v<Orbit, SymmetricOrbit<T>>;
  using Jet = scalars::Jet<T, 1>;

 public:
  Judge(const Question& q, const Box& box, bool last)
      : q_(q),
        box_(box),
        last_(last),
        data_(forms_of<T, S>(q, box)),
        setting_(setting_of<T>(data_.parameters, T(scalars::pi<S>()))),
        lifted_(setting_.template lifted<Jet>()) {}

  Finding operator()(Knowledge& known) {
    if (!sticks && may_be_resonant(setting_.o)) {
      return open(Reason::resonance);
    }
    const Sheets found =
        sticks ? symmetric_sheets(load_of(q_, box_)) : nonsticking_sheets<T>(setting_, belt_of(q_, box_));
    if (const auto * reason = std::get_if<Reason>(&found)) {
      return open(*reason);
    }
    const auto& sheets = std::get<std::vector<Sheet>>(found);
    if (known.sheets.size() != sheets.size()) {
      known.sheets.assign(sheets.size(), {});
    }
    const Reason why = count_all(sheets, known);
    if (why != Reason::none) {
      return open(why);
    }
    return judge_all(sheets, known) ? finding_of(known.sheets)
                                    : open(sticks ? Reason::no_amplitude : Reason::merging);
  }

 private:
  [[nodiscard]] auto f(const Sheet& sheet) const {
    return [&](const T& u) { return equation<T>(sheet, setting_, u); };
  }
  [[nodiscard]] auto df(const Sheet& sheet) const {
    return [&](const Jet& u) { return equation<Jet>(sheet, lifted_, u); };
  }

  // Counts the zeros where that was not done; the reason why it could not be.
  Reason count_all(const std::vector<Sheet>& sheets, Knowledge& known) const {
    Reason why = Reason::none;
    std::size_t orbits = 0;
    for (std::size_t i = 0; i < sheets.size() && !(last_ && why != Reason::none); ++i) {
      const Reason reason = known.sheets[i].orbits ? Reason::none : count(sheets[i], known.sheets[i]);
      why = why == Reason::none ? reason : why;
      orbits += reason == Reason::none ? known.sheets[i].orbits->size() : 0;
    }
    return why == Reason::none && orbits > most_orbits ? Reason::too_many : why;
  }

  Reason count(const Sheet& sheet, Knowledge::Sheet& known) const {
    std::vector<Bracket> zeros{{}};
    if (sheet.has_equation()) {
      known.cells = settled<S, N>(f(sheet), df(sheet), known.cells, data_.least);
      const auto found =
          zeros_between(known.cells, [&](int u) { return scalars::sign_of(f(sheet)(T(u)).over); });
      if (const auto * reason = std::get_if<Reason>(&found)) {
        return *reason;
      }
      zeros = std::get<std::vector<Bracket>>(found);
      known.cells.clear();
    }
    known.orbits.emplace();
    for (const Bracket& zero : zeros) {
      Knowledge::Orbit& orbit = known.orbits->emplace_back();
      orbit.zero = zero;
      if (sheet.is_never_admissible()) {
        orbit.exists = true;
        orbit.admissible = Truth::refuted;
      }
    }
    return Reason::none;
  }

  // False when a zero may be no orbit.
  bool judge_all(const std::vector<Sheet>& sheets, Knowledge& known) const {
    std::vector<std::pair<Orbit, Knowledge::Orbit *>> orbits;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      for (Knowledge::Orbit& orbit : *known.sheets[i].orbits) {
        if (orbit.exists && orbit.is_decided()) {
          continue;
        }
        const T share = sheets[i].has_equation() ? zero_over<S, N>(f(sheets[i]), df(sheets[i]), orbit.zero)
                                                 : T(T(1) / T(2));
        std::optional<Orbit> here = Orbit::at(sheets[i], setting_, share, data_.datum);
        if (!here) {
          return false;
        }
        if (!orbit.zero.is_straight() && orbit.zero.steepest > 0) {
          if (auto better = at_steep_zero(sheets[i], orbit.zero)) {
            here = std::move(better);
            orbit.zero.steepest = 0;
          }
        }
        orbit.exists = true;
        orbits.emplace_back(*here, &orbit);
      }
    }
    const bool without_load = load_of(q_, box_).upper == 0;
    for (const auto& [orbit, of_orbit] : orbits) {
      judge_orbit(*q_.family, orbit, data_.least, without_load, *of_orbit);
      if (last_ && of_orbit->admissible == Truth::undecided && !of_orbit->hope().is_promising) {
        break;
      }
    }
    return true;
  }

  // The orbit, and some beyond the box, as a function of u; nothing where it is none.
  [[nodiscard]] std::optional<Orbit> at_steep_zero(const Sheet& sheet, const Bracket& zero) const {
    const int k = zero.steepest;
    const auto setting_at = [&](const Data<T, S>& data) {
      return setting_of<T>(data.parameters, T(scalars::pi<S>()));
    };
    const auto steep = steep_zero<S, N>(
        [&](const T& u, const T& q) {
          return equation<T>(sheet, setting_at(forms_of<T, S>(q_, box_, k, q)), u);
        },
        zero, k, data_.axes[static_cast<std::size_t>(k - 1)]);
    if (!steep) {
      return std::nullopt;
    }
    const Data<T, S> data = forms_of<T, S>(q_, box_, k, steep->q);
    return Orbit::at(sheet, setting_at(data), steep->u, data.datum);
  }

  const Question& q_;
  const Box& box_;
  bool last_;
  Data<T, S> data_;
  Setting<T> setting_;
  Setting<Jet> lifted_;
};

template <template <class> class OrbitOf, class S>
Finding judge_with(const Question& q, const Box& box, bool last, Knowledge& known) {
  return q.axes.size() <= 2 ? Judge<OrbitOf, S, 3>(q, box, last)(known)
                            : Judge<OrbitOf, S, 5>(q, box, last)(known);
}

}  // namespace

const Judges symmetric_judges{judge_with<SymmetricOrbit, scalars::HardwareBall>,
                              judge_with<SymmetricOrbit, Ball>};
const Judges nonsticking_judges{judge_with<NonstickingOrbit, scalars::HardwareBall>,
                                judge_with<NonstickingOrbit, Ball>};

namespace {

// `last`: no leaf is smaller, and what is open is said of all of it; `halvings` of the whole have led there.
Finding judge_box(const Question& q, const Box& box, Balls balls, bool last, int halvings, Knowledge& known) {
  const WorkingPrecision scope(arb_bits);
  switch (place(q, box)) {
    case Where::outside:
      return open(Reason::outside);
    case Where::across:
      return open(Reason::reaches_out);
    case Where::inside:
      break;
  }
  if (balls != Balls::arb) {
    const Finding finding = q.family->judges->in_doubles(q, box, last, known);
    if (finding.is_decided() || balls == Balls::hardware ||
        halvings < enough_for_doubles * static_cast<int>(q.axes.size())) {
      return finding;
    }
  }
  return q.family->judges->in_balls(q, box, last, known);
}

// The box is halved, if there is hope or Arb alone is asked, and so are its halves: what all parts say is
// said of it. Two times of three across what it varies most with, else across each parameter in turn.
Finding judge_parts(const Question& q, const Box& box, Balls balls, int halvings, Knowledge known, int more) {
  const Finding all = judge_box(q, box, balls, true, halvings, known);
  const Hope hope = known.hope();
  const bool goes_on = hope.is_promising || balls == Balls::arb;  // those have time
  if (all.is_decided() || more == 0 || !goes_on) {
    return all;
  }
  const auto turn = static_cast<std::size_t>(more / 3) % q.axes.size();
  const std::size_t across =
      q.axes[more % 3 == 0 || hope.steepest == 0 ? turn : static_cast<std::size_t>(hope.steepest - 1)];
  Box lower = box;
  Box upper = box;
  lower[across].upper = upper[across].lower = (box[across].lower + box[across].upper) / 2;
  const Finding first = judge_parts(q, lower, balls, halvings + 1, known, more - 1);
  const bool agree =
      first.is_decided() && judge_parts(q, upper, balls, halvings + 1, std::move(known), more - 1) == first;
  return agree ? first : all;
}

}  // namespace

Finding finding_of(const std::vector<Knowledge::Sheet>& sheets) {
  Finding finding{0, 0, 0, 0};
  const auto leave_open = [&](std::size_t reason) {
    finding.reason = finding.reason == 0 ? static_cast<std::uint8_t>(reason) : finding.reason;
  };
  bool admissible_known = true;
  bool stable_known = true;
  for (const Knowledge::Sheet& sheet : sheets) {
    for (const Knowledge::Orbit& orbit : *sheet.orbits) {
      ++finding.orbits;
      finding.admissible = static_cast<std::int8_t>(finding.admissible + (orbit.admissible == Truth::proved));
      finding.stable = static_cast<std::int8_t>(finding.stable + (orbit.stable == Truth::proved));
      if (orbit.admissible == Truth::undecided) {
        admissible_known = stable_known = false;
        const auto is_open = [](const Knowledge::Condition& c) { return c.truth != Truth::proved; };
        leave_open(
            static_cast<std::size_t>(Reason::condition) +
            static_cast<std::size_t>(std::find_if(orbit.conditions.begin(), orbit.conditions.end(), is_open) -
                                     orbit.conditions.begin()));
      } else if (!orbit.is_decided()) {
        stable_known = false;
        leave_open(static_cast<std::size_t>(Reason::stability));
      }
    }
  }
  finding.admissible = admissible_known ? finding.admissible : std::int8_t{-1};
  finding.stable = stable_known ? finding.stable : std::int8_t{-1};
  return finding;
}

Finding judge(const Question& q, Tile tile, Balls balls, Knowledge& known) {
  return judge_box(q, box_of(q, tile), balls, depth(tile) >= q.finest(), depth(tile), known);
}

Knowledge known_around(const Question& q, Tile tile, Balls balls) {
  Knowledge known;
  for (int halvings = depth(tile); halvings > 0; --halvings) {
    (void)judge(q, tile >> halvings, balls, known);
  }
  return known;
}

Finding judge_finest(const Question& q, Tile tile, Balls balls, Knowledge known) {
  return judge_parts(q, box_of(q, tile), balls, depth(tile), std::move(known),
                     more_halvings + (balls == Balls::arb ? more_for_arb : 0));
}

Finding judge_from_whole(const Question& q, Tile tile, Balls balls) {
  return judge_finest(q, tile, balls, known_around(q, tile, balls));
}

}  // namespace stickslip::numeric::atlas
