#include "report/orbit_words.hpp"

#include "core/decimal.hpp"
#include "core/error.hpp"

namespace stickslip::report {

std::string name_of(Family family) {
  switch (family) {
    case Family::symmetric:
      return "symmetric";
    case Family::overshooting:
      return "overshooting";
    case Family::nonsticking:
      return "nonsticking";
  }
  throw InternalError("a family of no known kind");
}

std::string notation(const Range& range) {
  const std::string middle = to_string(range.middle);
  return range.radius == 0 ? middle : middle + "+-" + to_string(range.radius);
}

std::vector<NamedRange> named_parameters(const OrbitQuestion& question) {
  const model::Parameters<Range>& a = question.parameters;
  std::vector<NamedRange> named{{"chi", a.chi}, {"eta", a.eta},     {"us", a.us},
                                {"V", a.V},     {"omega", a.omega}, {"p", a.p}};
  if (question.phi) {
    named.push_back({"phi", *question.phi});
  }
  if (question.ur) {
    named.push_back({"ur", *question.ur});
  }
  return named;
}

std::string colour_of(PhaseKind kind) {
  switch (kind) {
    case PhaseKind::slip:
      return "#1f4e9c";
    case PhaseKind::overshoot:
      return "#c0392b";
    case PhaseKind::stick:
      return "#404040";
  }
  return "#000000";
}

std::string describe(Remark remark) {
  switch (remark) {
    case Remark::load_absent:
      return "p = 0: the load's phase means nothing, and each orbit is listed for the first of the two "
             "phases "
             "only.";
    case Remark::closes_without_stick:
      return "A natural frequency is a multiple of omega: there are also closed motions that slip all the "
             "time, "
             "which are not in this list.";
    case Remark::searched_at_middle:
      return "The orbits were searched for at the middle of the parameters; each is then proved for the "
             "whole "
             "box. Other orbits may exist elsewhere in the box.";
  }
  throw InternalError("a remark of no known kind");
}

}  // namespace stickslip::report
