#include "numeric/families/one_stick_search.hpp"

namespace stickslip::numeric::families {

STICKSLIP_ONE_STICK(TwoPhases, 2, Datum::friction)
STICKSLIP_ONE_STICK(TwoPhasesAtPhase, 2, Datum::phase)

}  // namespace stickslip::numeric::families
