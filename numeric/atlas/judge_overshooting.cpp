#include "numeric/atlas/judge.hpp"
#include "numeric/atlas/judging.hpp"
#include "numeric/atlas/overshooting_orbit.hpp"
#include "numeric/families/through_phases/isolate.hpp"

namespace stickslip::numeric::atlas {

namespace {

template <class S, int N>
class Judge {
  using T = scalars::Form<S, N>;
  using Orbit = OvershootingOrbit<S, N>;

 public:
  Judge(const Question& q, const Box& box, bool last)
      : family_(*q.family),
        last_(last),
        data_(forms_of<T, S>(q, box)),
        setting_(Orbit::setting(data_.parameters, *data_.datum)) {}

  Finding operator()(Knowledge& known) const {
    known.sheets.resize(1);
    Knowledge::Sheet& sheet = known.sheets[0];
    sheet.cells.clear();
    if (!sheet.orbits) {
      settle_patches<S, N>(look(), sheet, data_.least);
      if (!sheet.patches.empty()) {
        return open(Reason::merging);
      }
      const Reason why = count(sheet);
      if (why != Reason::none) {
        return open(why);
      }
    }
    for (Knowledge::Orbit& orbit : *sheet.orbits) {
      if (orbit.is_decided()) {
        continue;
      }
      const auto zero = zero_in_patch<S, N>(look(), orbit.patch);
      const auto here = zero ? Orbit::at(setting_, (*zero)[0], (*zero)[1]) : std::nullopt;
      if (here) {
        judge_orbit(family_, *here, data_.least, false, orbit);
      }
      if (last_ && !orbit.is_decided() && !orbit.hope().is_promising) {
        break;
      }
    }
    return finding_of(known.sheets);
  }

 private:
  [[nodiscard]] auto look() const {
    return [this](const T& s, const T& w) { return Orbit::look(setting_, s, w); };
  }

  // The zeros all of whose durations are positive, or why that is not known. A zero is an orbit where the
  // amplitudes are determined.
  Reason count(Knowledge::Sheet& sheet) const {
    std::vector<Knowledge::Orbit> orbits;
    for (ZeroPatch& zero : sheet.zeros) {
      const auto at = zero_in_patch<S, N>(look(), zero);
      if (!at) {
        return Reason::no_amplitude;
      }
      const families::Place s = families::place((*at)[0].over);
      const families::Place w = families::place((*at)[1].over);
      if (s == families::Place::outside || w == families::Place::outside) {
        continue;
      }
      if (s == families::Place::at_edge || w == families::Place::at_edge) {
        return Reason::no_time;
      }
      if (!Orbit::at(setting_, (*at)[0], (*at)[1])) {
        return Reason::no_amplitude;
      }
      Knowledge::Orbit& orbit = orbits.emplace_back();
      orbit.patch = zero;
      orbit.exists = true;
      orbit.conditions.resize(family_.requirements.size());
    }
    if (orbits.size() > most_orbits) {
      return Reason::too_many;
    }
    sheet.orbits = std::move(orbits);
    sheet.zeros.clear();
    return Reason::none;
  }

  const families::Family& family_;
  bool last_;
  Data<T, S> data_;
  typename Orbit::Setting setting_;
};

template <class S>
Finding judge_with(const Question& q, const Box& box, bool last, Knowledge& known) {
  return q.axes.size() <= 2 ? Judge<S, 4>(q, box, last)(known) : Judge<S, 6>(q, box, last)(known);
}

}  // namespace

// phi is given.
const Judges overshooting_judges{judge_with<scalars::HardwareBall>, judge_with<Ball>};

}  // namespace stickslip::numeric::atlas
