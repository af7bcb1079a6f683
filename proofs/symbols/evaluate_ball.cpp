#include "proofs/symbols/evaluate.hpp"

namespace stickslip::proofs::symbols {

template Value<Ball> evaluate(const Term&, const Lookup<Ball>&);

}  // namespace stickslip::proofs::symbols
