#include "numeric/motion/requirements.hpp"

#include "core/error.hpp"

namespace stickslip::numeric::motion {
namespace {

const char * duration_name(Family family, std::size_t phase) {
  switch (family) {
    case Family::symmetric:
      return phase == 0 ? "tau" : "T";
    case Family::overshooting:
      return phase == 0 ? "tau" : (phase == 1 ? "tau1" : "T");
    case Family::nonsticking:
      return phase == 0 ? "tau" : "tau1";
  }
  return "";
}

using List = std::vector<Requirement>;

void add_data(List& list, Family family, bool ur_given) {
  for (std::size_t k = 0; k < phase_kinds(family).size(); ++k) {
    const std::string name = duration_name(family, k);
    list.push_back({name, "$" + name + " > 0$", Quantity::duration, k, false, {}, true});
  }
  list.push_back({"us", "$us > 0$", Quantity::slipping_friction, 0, false, {}, true});
  if (ur_given) {
    list.push_back({"ur", "$ur > us$", Quantity::friction_step, 0, false, {}, true});
  }
}

void add_slip_after_stick(List& list) {
  list.push_back({"12",
                  "$z2'(0) = V$, $chi eta (z20 - z10) = p cos(phi) + eta (ur - us)$, $x2''(0+) < 0$",
                  Quantity::falls_behind,
                  0,
                  false,
                  {},
                  true});
  list.push_back({"slip", "$z2' < V$ for $0 < t < tau$", Quantity::below_belt, 0, true, {true, true}, true});
}

// (14), (19): the motion sticks when phase k begins, with names of the time and of the coordinates then.
void add_stick_begins(List& list, const std::string& id, std::size_t k, const std::string& time) {
  const std::string middle = "chi eta (z2C - z1C) - p cos(omega " + time + " + phi)";
  list.push_back(
      {id + ".lower", "$-eta (ur + us) < " + middle + "$", Quantity::above_minus_ur, k, false, {}, true});
  list.push_back({id + ".upper", "$" + middle + " < eta (ur - us)$", Quantity::below_ur, k, false, {}, true});
}

List symmetric_requirements() {
  List list;
  add_data(list, Family::symmetric, true);
  add_slip_after_stick(list);
  add_stick_begins(list, "14", 1, "tau");
  list.push_back(
      {"f1", "$f1 <= 0$ for $tau < t < Theta$", Quantity::below_ur, 1, true, {false, true}, false});
  list.push_back({"f2", "$f2 > 0$ for $tau < t < Theta$", Quantity::above_minus_ur, 1, true, {}, true});
  return list;
}

List overshooting_requirements() {
  List list;
  add_data(list, Family::overshooting, true);
  add_slip_after_stick(list);
  list.push_back({"18",
                  "$z2'(tau) = V$, $chi eta (z2B - z1B) - p cos(omega tau + phi) + eta (ur + us) < 0$",
                  Quantity::beyond_minus_ur,
                  1,
                  false,
                  {},
                  true});
  list.push_back({"overshoot",
                  "$z2' > V$ for $tau < t < tau + tau1$",
                  Quantity::above_belt,
                  1,
                  true,
                  {true, true},
                  true});
  add_stick_begins(list, "19", 2, "(tau + tau1)");
  list.push_back({"11.upper",
                  "$chi eta (x2 - x1) - p cos(omega t + phi) < eta ur$ for $tau + tau1 < t < Theta$",
                  Quantity::below_ur,
                  2,
                  true,
                  {false, true},
                  true});
  list.push_back({"11.lower",
                  "$chi eta (x2 - x1) - p cos(omega t + phi) > -eta ur$ for $tau + tau1 < t < Theta$",
                  Quantity::above_minus_ur,
                  2,
                  true,
                  {},
                  true});
  return list;
}

List nonsticking_requirements(bool ur_given) {
  List list;
  add_data(list, Family::nonsticking, ur_given);
  if (ur_given) {
    list.push_back({"25",
                    "$z2'(0) = V$, $chi eta (z20 - z10) > p cos(phi) + eta (ur - us)$",
                    Quantity::beyond_ur,
                    0,
                    false,
                    {},
                    true});
    list.push_back({"26",
                    "$z2'(tau) = V$, $chi eta (z2B - z1B) < p cos(omega tau + phi) - eta (ur + us)$",
                    Quantity::beyond_minus_ur,
                    1,
                    false,
                    {},
                    true});
  }
  list.push_back({"slip", "$z2' < V$ for $0 < t < tau$", Quantity::below_belt, 0, true, {true, true}, true});
  list.push_back(
      {"overshoot", "$z2' > V$ for $tau < t < Theta$", Quantity::above_belt, 1, true, {true, true}, true});
  return list;
}

}  // namespace

std::vector<PhaseKind> phase_kinds(Family family) {
  switch (family) {
    case Family::symmetric:
      return {PhaseKind::slip, PhaseKind::stick};
    case Family::overshooting:
      return {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick};
    case Family::nonsticking:
      return {PhaseKind::slip, PhaseKind::overshoot};
  }
  throw InternalError("a family of no known kind");
}

std::vector<Requirement> requirements(Family family, bool ur_given) {
  switch (family) {
    case Family::symmetric:
      return symmetric_requirements();
    case Family::overshooting:
      return overshooting_requirements();
    case Family::nonsticking:
      return nonsticking_requirements(ur_given);
  }
  throw InternalError("a family of no known kind");
}

}  // namespace stickslip::numeric::motion
