#include "numeric/atlas/question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "core/names.hpp"
#include "numeric/families/through_phases/isolate.hpp"

namespace stickslip::numeric::atlas {

bool takes_phi(const families::Family& family) {
  return family.why_no_phi.empty();
}

const std::vector<std::string>& names_of(const families::Family& family, Values values) {
  using Names = std::vector<std::string>;
  static const auto lists = [] {
    const std::array<Names, 3> without_datum{Names{"chi", "eta", "us", "V", "omega", "p"},
                                             {"m1", "m2", "k1", "k2", "normal_force", "friction_sliding",
                                              "belt_velocity", "load_amplitude", "load_frequency"},
                                             {"m1", "m2", "k1", "k2", "friction_force_sliding",
                                              "belt_velocity", "load_amplitude", "load_frequency"}};
    const std::array<const char *, 3> at_rest{"ur", "friction_at_rest", "friction_force_at_rest"};
    std::array<std::array<Names, 2>, 3> all;
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k].fill(without_datum[k]);
      all[k][0].emplace_back(at_rest[k]);
      all[k][1].emplace_back("phi");
    }
    return all;
  }();
  return lists[static_cast<std::size_t>(values)][takes_phi(family) ? 1 : 0];
}

std::vector<std::string> axis_names(const Question& q) {
  std::vector<std::string> names;
  for (const std::size_t axis : q.axes) {
    names.push_back(names_of(q)[axis]);
  }
  return names;
}

std::size_t place_of(const Question& q, std::string_view name) {
  const std::vector<std::string>& names = names_of(q);
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

const Interval& belt_of(const Question& q, const Box& box) {
  return box[q.is_in_SI() ? place_of(q, "belt_velocity") : place_of_V];
}

const Interval& load_of(const Question& q, const Box& box) {
  return box[q.is_in_SI() ? place_of(q, "load_amplitude") : place_of_p];
}

namespace {

void require_machines(const Question& q) {
  const std::vector<std::string>& names = names_of(q);
  for (std::size_t i = 0; i < q.region.size(); ++i) {
    const Rational& least = q.region[i].lower;
    const bool may_vanish = names[i] == "belt_velocity" || names[i] == "load_amplitude";
    if (names[i] != "phi" && (least < 0 || (least == 0 && !may_vanish))) {
      throw DomainError(names[i], to_string(least), names[i] + (may_vanish ? " >= 0" : " > 0"));
    }
  }
  if (takes_phi(*q.family) || q.region.size() < names.size()) {
    return;
  }
  const std::size_t sliding =
      place_of(q, q.values == Values::forces ? "friction_force_sliding" : "friction_sliding");
  if (q.region.back().lower <= q.region[sliding].upper) {
    throw DomainError(
        names.back(), to_string(q.region.back().lower),
        fmt::format("greater than {} = {}", names[sliding], to_string(q.region[sliding].upper)));
  }
}

}  // namespace

void require_understood(const Question& q) {
  if (q.family->judges == nullptr) {
    throw UsageError(fmt::format("no atlas is made of {} orbits", q.family->name));
  }
  if (takes_phi(*q.family) && q.region.size() < names_of(q).size()) {
    throw UsageError(fmt::format("an atlas of {} orbits needs phi; u_r is a result", q.family->name));
  }
  if (q.axes.empty() || q.axes.size() > 4) {
    throw UsageError(fmt::format(
        "an atlas needs one to four parameters that vary, such as --omega 0.5..0.8, not {}", q.axes.size()));
  }
  const int most = most_depth / static_cast<int>(q.axes.size());
  if (q.resolution < 1 || q.resolution > most) {
    throw UsageError(
        fmt::format("resolution: {} is not from 1 to {}, the most halvings of each of {} "
                    "parameters",
                    q.resolution, most, q.axes.size()));
  }
  if (q.is_in_SI()) {
    require_machines(q);
  } else if (!takes_phi(*q.family) && q.region.size() > place_of_datum &&
             q.region[place_of_datum].upper <= q.region[place_of_us].lower) {
    throw DomainError("ur", to_string(q.region[place_of_datum].upper),
                      "ur > us = " + to_string(q.region[place_of_us].lower));
  }
}

Box box_of(const Question& q, Tile tile) {
  Box box = q.region;
  for (std::size_t k = 0; k < q.axes.size(); ++k) {
    const Side at = side(tile, k, q.axes.size());
    const Interval& range = q.region[q.axes[k]];
    Rational step = range.upper - range.lower;
    mpq_div_2exp(step.get_mpq_t(), step.get_mpq_t(), static_cast<mp_bitcnt_t>(at.halvings));
    const Rational lower = range.lower + step * static_cast<unsigned long>(at.place);
    box[q.axes[k]] = {lower, lower + step};
  }
  return box;
}

std::string Interval::text() const {
  return is_point() ? to_string(lower) : to_string(lower) + ".." + to_string(upper);
}

std::string text_of(const Question& q) {
  std::string options, file;
  for (std::size_t i = 0; i < q.region.size(); ++i) {
    const std::string& name = names_of(q)[i];
    if (q.is_in_SI() && name != "phi") {
      file += fmt::format(" '{} = \"{}\"'", name, q.region[i].text());
    } else {
      options += fmt::format(" --{} {}", name, q.region[i].text());
    }
  }
  if (q.is_in_SI()) {
    file = fmt::format(" --params <(printf '%s\\n'{})", file);
  }
  return fmt::format("{}{}{} --resolution {}", q.family->name, file, options, q.resolution);
}

std::string sentence_of(const families::Family& family, std::uint8_t reason) {
  const auto first_condition = static_cast<std::size_t>(Reason::condition);
  if (reason < first_condition) {
    return name_of<Reason::stability>(
        static_cast<Reason>(reason), "decided", "outside the domain of the family",
        "reaches out of the domain of the family", "a natural frequency may be a multiple of omega",
        "p = 0 for some members, where both load phases are one",
        "the load may not act on the mass on the belt: p = 0 or omega = 1",
        "V = 0 for some members, where the closing conditions are others", "two orbits may be one",
        families::no_time_at_all, "the amplitude of an orbit may be unbounded",
        fmt::format("there are more than {} orbits", most_orbits), "a multiplier may lie on the unit circle");
  }
  const std::size_t k = reason - first_condition;
  if (k >= family.requirements.size()) {
    throw InternalError(fmt::format("no reason has the number {}", reason));
  }
  return fmt::format("condition {} may hold or not: {}", family.requirements[k].id,
                     plain(family.requirements[k].statement));
}

}  // namespace stickslip::numeric::atlas
