#include "proofs/evaluate.hpp"

namespace stickslip::proofs {

template Value<GiNaC::ex> evaluate(const Term&, const Lookup<GiNaC::ex>&);

}  // namespace stickslip::proofs
