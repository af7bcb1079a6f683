#include "proofs/pascal2012/judgement.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

const std::vector<Judgement>& judgements() {
  static const std::vector<Judgement> all{
      {"7",
       true,
       "The load is in resonance: (7) has no solution $Q$ unless $p = 0$, and (5), (8) and all that is "
       "deduced from them say nothing there.",
       {"7.resonance"}},
      {"16.back",
       true,
       "At $tau = pi/omega_1$ the equations (16) have a solution that does not close.",
       {"16"}},
      {"35", false, "Where $q_2 = 0$, (36) cannot hold: no motion is lost.", {"36.load"}},
      {"37.p",
       false,
       "Where $omega = 1$, $q_2 = 0$ whatever $p$ is, and (7) cannot be solved for $p$; but (36) cannot hold "
       "there: no motion is lost.",
       {"36.load"}},
      {"35.def",
       false,
       "Where $omega_i$ is an odd multiple of $omega$, $det H_3 = 0$, which (31) excludes, and no motion "
       "closes.",
       {"31.det", "31.modes", "31.rest"}},
      {"7.always",
       true,
       "At resonance there are orbits that never stick and are not symmetric. Section 6 and Appendix 5 state "
       "the hypothesis, the abstract and the conclusion do not.",
       {"7.exception"}},
      {"67.sin", false, "Uniqueness by energy gives the symmetry without it.", {"A5.symmetry"}},
      {"63.P", false, "Uniqueness by energy gives the symmetry without $P_1$ and $P_2$.", {"A5.symmetry"}},
      {"70.rho", false, "Uniqueness by energy gives the symmetry without $det P$.", {"A5.symmetry"}},
  };
  return all;
}

}  // namespace stickslip::proofs::pascal2012
