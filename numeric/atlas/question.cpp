#include "numeric/atlas/question.hpp"

#include <fmt/format.h>

#include "core/decimal.hpp"
#include "core/error.hpp"

namespace stickslip::numeric::atlas {

bool takes_phi(const families::Family& family) {
  return family.why_no_phi.empty();
}

const std::vector<std::string>& parameter_names(const families::Family& family) {
  static const std::vector<std::string> with_phi{"chi", "eta", "us", "V", "omega", "p", "phi"};
  static const std::vector<std::string> with_ur{"chi", "eta", "us", "V", "omega", "p", "ur"};
  return takes_phi(family) ? with_phi : with_ur;
}

void require_understood(const Question& q) {
  if (q.family->judges == nullptr) {
    throw UsageError(fmt::format("no atlas is made of {} orbits", q.family->name));
  }
  if (takes_phi(*q.family) && q.region.size() <= place_of_datum) {
    throw UsageError(fmt::format("an atlas of {} orbits needs phi; u_r is a result", q.family->name));
  }
  if (q.axes.empty() || q.axes.size() > 4) {
    throw UsageError(
        fmt::format("an atlas needs one to four parameters that vary, such as --omega 0.5..0.8; here are {}",
                    q.axes.size()));
  }
  const int most = most_depth / static_cast<int>(q.axes.size());
  if (q.resolution < 1 || q.resolution > most) {
    throw UsageError(
        fmt::format("resolution: {} is not from 1 to {}, the most halvings of each of {} "
                    "parameters",
                    q.resolution, most, q.axes.size()));
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

std::string text_of(const Question& q) {
  std::string text = q.family->name;
  for (std::size_t i = 0; i < q.region.size(); ++i) {
    const Interval& range = q.region[i];
    text += fmt::format(" --{} {}", parameter_names(*q.family)[i], to_string(range.lower));
    if (!range.is_point()) {
      text += ".." + to_string(range.upper);
    }
  }
  return text + fmt::format(" --resolution {}", q.resolution);
}

std::string sentence_of(const families::Family& family, std::uint8_t reason) {
  switch (static_cast<Reason>(reason)) {
    case Reason::none:
      return "decided";
    case Reason::outside:
      return "outside the domain of the family";
    case Reason::reaches_out:
      return "reaches out of the domain of the family";
    case Reason::resonance:
      return "a natural frequency may be a multiple of omega";
    case Reason::no_load:
      return "p = 0 for some members, where both load phases are one";
    case Reason::idle_load:
      return "the load may not act on the mass on the belt: p = 0 or omega = 1";
    case Reason::belt_at_rest:
      return "V = 0 for some members, where the closing conditions are others";
    case Reason::merging:
      return "two orbits may be one";
    case Reason::no_time:
      return std::string(families::no_time_at_all);
    case Reason::no_amplitude:
      return "the amplitude of an orbit may be unbounded";
    case Reason::too_many:
      return fmt::format("there are more than {} orbits", most_orbits);
    case Reason::stability:
      return "a multiplier may lie on the unit circle";
    default:
      break;
  }
  const std::size_t k = reason - static_cast<std::size_t>(Reason::condition);
  if (k >= family.requirements.size()) {
    throw InternalError(fmt::format("no reason has the number {}", reason));
  }
  return fmt::format("condition {} may hold or not: {}", family.requirements[k].id,
                     plain(family.requirements[k].statement));
}

}  // namespace stickslip::numeric::atlas
