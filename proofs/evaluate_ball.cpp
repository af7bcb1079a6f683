#include "proofs/evaluate.hpp"

namespace stickslip::proofs {

template Value<Ball> evaluate(const Term&, const Lookup<Ball>&);

}  // namespace stickslip::proofs
