#include "numeric/motion/exits.hpp"

#include "core/names.hpp"

namespace stickslip::numeric::motion {

using zeros::ParameterJet;

std::string to_string(Exit exit) {
  return name_of<Exit::pair>(exit, "real +1", "real -1", "complex pair");
}

std::optional<StabilityKind> stability_over(const zeros::ParametricProof& proof,
                                            const MotionOf<ParameterJet>& jets, const Motion& middle,
                                            bool is_symmetric) {
  const ExitFactors<ParameterJet> over = exit_factors(jets, is_symmetric);
  const ExitFactors<Ball> at_middle = exit_factors(middle, is_symmetric);
  const auto sign_of = [&](const std::vector<ParameterJet>& a, const std::vector<Ball>& b) {
    int product = 1;
    for (std::size_t k = 0; k < a.size(); ++k) {
      product *= scalars::sign_of(proof.over_box(a[k], b[k]));
    }
    return product;
  };
  if (!proof.over_box(over.is_regular, at_middle.is_regular).is_positive()) {
    return std::nullopt;
  }
  bool none_vanishes = true;
  for (const Exit exit : exits) {
    int product = sign_of(over[exit], at_middle[exit]);
    for (std::size_t j = 0; j < 2 && product == 0 && exit == Exit::plus_one && is_symmetric; ++j) {
      product = sign_of(SymmetricExits<ParameterJet>(jets).at_one_by_mode(j),
                        SymmetricExits<Ball>(middle).at_one_by_mode(j));
    }
    if (product < 0) {
      return StabilityKind::unstable;
    }
    none_vanishes = none_vanishes && product > 0;
  }
  const StabilityKind kind = none_vanishes ? decide_stability(middle).kind : StabilityKind::undecided;
  return kind == StabilityKind::undecided ? std::nullopt : std::optional(kind);
}

}  // namespace stickslip::numeric::motion
