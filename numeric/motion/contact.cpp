#include "numeric/motion/contact.hpp"

namespace stickslip::numeric::motion {

std::optional<Contact> contact_of(const std::vector<Condition>& conditions) {
  std::optional<Contact> nearest;
  for (const Condition& c : conditions) {
    if (c.verdict.truth != Truth::proved) {
      return std::nullopt;
    }
    if (!c.at || !c.margin) {
      continue;
    }
    if (!nearest) {
      nearest = {c.id, *c.margin, *c.at};
      continue;
    }
    if (c.margin->approximate() < nearest->margin.approximate()) {
      nearest->condition = c.id;
      nearest->at = *c.at;
    }
    arb_min(nearest->margin.raw(), nearest->margin.raw(), c.margin->raw(), WorkingPrecision::bits());
  }
  return nearest;
}

}  // namespace stickslip::numeric::motion
