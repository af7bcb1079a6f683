#include "proofs/symbols/evaluate.hpp"

namespace stickslip::proofs::symbols {

using numeric::scalars::Exact;

template Value<Exact> evaluate(const Term&, const Lookup<Exact>&);

}  // namespace stickslip::proofs::symbols
