// Where simulations begin: states at random, reproducibly, in a box that a machine's motions come from.
#pragma once

#include <cstdint>
#include <vector>

#include "model/parameters.hpp"
#include "numeric/attractors/many_starts.hpp"

namespace stickslip::numeric::attractors {

using StartBox = StartBoxOf<model::Vector4<double>>;
[[nodiscard]] StartBox start_box(const model::Parameters<double>& a);

// With d = us/(chi (1 - chi)), the rest position of the second mass, and s the largest of V, 3 us, 0.1 and,
// but at resonance, 1.2 |q2| omega, a speed: uniformly x1 in chi d ± 2 s, x2 in d ± 3 s, x1' in ± 1.5 s, x2'
// in V - s ± 1.5 s. The same seed gives the same states everywhere; the first ones do not depend on how many
// there are.
[[nodiscard]] std::vector<model::Vector4<double>> random_starts(const model::Parameters<double>& a,
                                                                std::size_t count, std::uint64_t seed);

}  // namespace stickslip::numeric::attractors
