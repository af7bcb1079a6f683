#include "numeric/families/through_phases/one_stick_search.hpp"

namespace stickslip::numeric::families {

template struct OneStick<2, Datum::friction>;
template struct LinearEliminant<OneStick<2, Datum::friction>>;
template struct OneStick<2, Datum::phase>;
template struct LinearEliminant<OneStick<2, Datum::phase>>;

}  // namespace stickslip::numeric::families
