#include "numeric/motion/requirements.hpp"

namespace stickslip::numeric::motion {

bool needs_ur(Quantity quantity) {
  return quantity != Quantity::below_belt && quantity != Quantity::above_belt &&
         quantity != Quantity::duration && quantity != Quantity::slipping_friction;
}

Requirements sound_data(const std::vector<std::string>& durations) {
  Requirements list;
  for (std::size_t k = 0; k < durations.size(); ++k) {
    list.push_back({durations[k], "$" + durations[k] + " > 0$", Quantity::duration, k});
  }
  list.push_back({"us", "$us > 0$", Quantity::slipping_friction});
  list.push_back({"ur", "$ur > us$", Quantity::friction_step});
  return list;
}

Requirement slips(std::size_t phase, const std::string& statement) {
  return {"slip", statement, Quantity::below_belt, phase, true, {true, true}};
}

Requirement overshoots(std::size_t phase, const std::string& statement) {
  return {"overshoot", statement, Quantity::above_belt, phase, true, {true, true}};
}

Requirements slip_after_stick() {
  return {{"12", "$z2'(0) = V$, $chi eta (z20 - z10) = p cos(phi) + eta (ur - us)$, $x2''(0+) < 0$",
           Quantity::falls_behind},
          slips(0, "$z2' < V$ for $0 < t < tau$")};
}

Requirements sticks_at(const std::string& id, std::size_t phase, const std::string& time) {
  const std::string middle = "chi eta (z2C - z1C) - p cos(omega " + time + " + phi)";
  return {{id + ".lower", "$-eta (ur + us) < " + middle + "$", Quantity::above_minus_ur, phase},
          {id + ".upper", "$" + middle + " < eta (ur - us)$", Quantity::below_ur, phase}};
}

Requirements joined(const std::vector<Requirements>& lists) {
  Requirements all;
  for (const Requirements& list : lists) {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

}  // namespace stickslip::numeric::motion
