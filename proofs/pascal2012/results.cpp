// What the audit found beyond the paper: theorems with all their hypotheses, the strongest first.
#include "proofs/pascal2012/remarks.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace {

// What all of them assume.
const std::string model = "Let $0 < chi < 1$, $eta > 0$ and $u_s > 0$";
const std::string off_resonance = "$sin(omega_1 Theta/2) sin(omega_2 Theta/2) != 0$";

std::vector<Result> on_orbits_that_never_stick() {
  return {
      {.id = "moving-belt",
       .title = "Orbits that never stick exist on a moving belt",
       .theorem =
           "At $chi = 0.3$, $eta = 4$, $u_s = 0.1$, $V = 0.1$, $omega = 0.6$, $p = 1$ and $u_r = 0.2$ "
           "the equations (2) with the law (4) have a motion of the load's period "
           "that slips below the belt's velocity, $x2' < V$, on $(0, tau)$ and above it, $x2' > V$, on "
           "$(tau, Theta)$, with $|r| > u_r$ at 0 and at $tau$; it never sticks",
       .idea =
           "Krawczyk's test in balls proves a zero of the closing equations for $tau$, which are "
           "equivalent to (28) with $z2' = V$ at both ends; each condition is decided in balls for all times "
           "of its slip. None is symmetric in time: off resonance, for $V > 0$, the slip below the belt's "
           "velocity "
           "lasts longer than half a period",
       .see = "stickslip orbits nonsticking --chi 0.3 --eta 4 --us 0.1 --ur 0.2 --V 0.1 --omega 0.6 --p 1",
       .claims = {"7.only", "A5.longer", "28.reduced"}},
      {.id = "resonance",
       .title = "At resonance there are families of orbits that are not symmetric",
       .theorem =
           "At $omega_1 = 7/10$, $omega_2 = 13/10$, $omega = 7/20$, $u_s = 0.1$, $u_r = 0.12$, $p = 3$, $V = "
           "0$ "
           "the equations (2) with the law (4) have, for every $epsilon$ from $-1/20$ to $1/20$, an orbit "
           "of the load's period that never sticks; $x(tau) + x(0) = 2 epsilon (1, lambda_1)$, so that it is "
           "symmetric in space for $epsilon = 0$ only",
       .idea = "where $omega_1 = 2 omega$ the free motion $epsilon cos(omega_1 t)$ of the first mode has the "
               "load's "
               "period and no velocity at 0 and $tau$, and may be added to the motion of (33); that $x2'$ "
               "keeps its "
               "sign on both slips is decided in balls for all $epsilon$ at once",
       .see = "stickslip check 33.even --explain",
       .claims = {"33.even.orbits", "33.even", "33.even.speed", "33.even.start", "33.even.places",
                  "7.always"}},
      {.id = "uniqueness",
       .title = "There is at most one orbit that never sticks",
       .theorem =
           model + ", and let the period $Theta$ be off resonance, " + off_resonance +
           ". For every $V$, $omega$, $p$ and $phi$ there is at most one continuous motion of period "
           "$Theta$ that obeys (2) with $u = u_s sign(V - x2')$ at all times but finitely many: whatever the "
           "number of its transitions, and whether they are the paper's",
       .idea =
           "the energy of the difference of two such motions changes at the rate $u_s (x2' - y2') (sign(V - "
           "x2') - sign(V - y2')) <= 0$; being periodic it is constant, so that the frictions are equal. "
           "The difference then moves freely with period $Theta$, and off resonance only rest does",
       .see = "stickslip check A5.unique --explain",
       .claims = {"A5.unique", "A5.energy", "A5.sides", "A5.moves", "A5.free"}},
      {.id = "symmetry",
       .title = "Orbits that never stick are symmetric, without the paper's hypotheses",
       .theorem = model + ", $V = 0$, $Theta = 2 pi/omega$, and off resonance, " + off_resonance +
                  ". Every continuous motion of period $Theta$ that obeys (2) with $u = u_s sign(-x2')$ at "
                  "all times "
                  "but finitely many fulfils $X(t) = -X(t + Theta/2)$",
       .idea =
           "$-X(t + Theta/2)$ is such a motion as well, since the load changes its sign after half a period, "
           "and there is one only. Nothing is assumed of the number of transitions, of $det P$, $det H_2$ or "
           "$det(H_1 - I)$, or of $omega = 1$",
       .see = "stickslip check A5.symmetry --explain",
       .claims = {"A5.symmetry", "A5.mirror", "A5.unique", "65.sharp"}},
  };
}

std::vector<Result> on_stability() {
  return {
      {.id = "neutral",
       .title = "An orbit that never sticks is not linearly unstable",
       .theorem = model +
                  ". Two continuous motions that obey (2) with $u = u_s sign(V - x2')$ at all times but "
                  "finitely many do not move apart: the energy of their difference is at the end of any time "
                  "$Theta > "
                  "0$ at most what it was at its beginning",
       .idea = "the energy of the difference changes at the rate $u_s (x2' - y2') (sign(V - x2') - sign(V - "
               "y2')) <= "
               "0$",
       .see = "stickslip check A5.stable --explain",
       .claims = {"A5.stable", "A5.energy"}},
      {.id = "stability",
       .title = "The orbit of Fig. 2 is unstable; those of Figs. 3 and 4 are stable",
       .theorem =
           "At the data of Fig. 2 the orbit has a Floquet multiplier greater than 1; at the data of Figs. 3 "
           "and 4 all multipliers of the orbit lie inside the unit circle",
       .idea = "the derivative of the return map is composed of the phases' flows and of the jumps at the "
               "events, "
               "and its eigenvalues are enclosed in balls",
       .see = "stickslip check S.stability O.stability P.stability --explain",
       .claims = {"S.stability", "O.stability", "P.stability"}},
      {.id = "asymmetric",
       .title = "At all data of Fig. 2 there are two orbits of slip and stick, and they are not symmetric",
       .theorem =
           "At $chi = 0.5$, $eta = 3.8$, $u_s = 0.02$, $V = 1$, $omega = 0.6$, $p = 0.05$ and $u_r = "
           "0.1607$ the equations (2) with the law (4) have exactly two motions of the load's period "
           "with one slip, $tau = 7.74666...$ and $tau = 7.62995...$, and one stick; neither obeys (13)",
       .idea =
           "for a given $tau$ the closing conditions are linear in the state and in the cosine and sine of "
           "the load's phase: one equation for $tau$ remains, whose zeros are isolated in balls",
       .see = "stickslip orbits ST --period 1 --chi 0.5 --eta 3.8 --us 0.02 --V 1 --omega 0.6 --p 0.05 --ur "
              "0.1607",
       .claims = {"S.asymmetric", "S.data", "S.lag"}},
      {.id = "lists",
       .title = "All orbits of each family at the data of the figures",
       .theorem =
           "The families have, at the data of Figs. 2, 3 and 4, exactly the orbits that the program lists: "
           "four symmetric ones, each with another $u_r$, which all obey every condition; two overshooting "
           "ones and two that never stick, of which one each does",
       .idea =
           "the closing equations are reduced to two unknowns; a box of these either holds no zero, or "
           "Krawczyk's test proves that it holds exactly one, and the boxes cover the domain, ends included",
       .see = "stickslip check S.list O.list P.list --explain",
       .claims = {"S.list", "O.list", "P.list"}},
  };
}

std::vector<Result> on_equations() {
  return {
      {.id = "least-load",
       .title = "The sharp bound on the load against sticking",
       .theorem =
           model +
           ", $V = 0$, $tau = Theta/2$, $det H_3(tau) != 0$, $omega != 1$ and $p > 0$. A motion that "
           "closes obeys (36) exactly if $q_2 cos(phi) > 0$ and $p^2 > (D/(omega (1 - omega^2)))^2 (B^2 + "
           "(eta u_r/omega)^2)$, with $D = (omega^2 - omega_1^2)(omega^2 - omega_2^2)$ and $B = b_1 d_01 + "
           "b_2 d_02$; (37) is this bound without $u_r$",
       .idea =
           "(36) gives $q_2 omega cos(phi) > eta u_r/omega$ and (35) gives $q_2 omega sin(phi) = -B$; the "
           "squares add up, and (7) makes $q_2$ a multiple of $p$",
       .see = "stickslip check 37.sharp 37.sharp.back --explain",
       .claims = {"37.sharp", "37.sharp.back", "P.least"}},
      {.id = "spurious",
       .title = "(16) and (23) have zeros that are no orbits",
       .theorem =
           "At $omega_1 = 1/2$, $omega_2 = 7/3$, $omega = 3/5$, $u_s = 0.1$, $V = 1$, $p = 1/2$ "
           "(16) has, with $tau = pi/omega_1$, a solution that does not fulfil (13). At the data of "
           "Fig. 2 the determinant of (16) vanishes at eight $tau$ between 0 and $Theta$, of which two "
           "are orbits. At the data of "
           "Fig. 3 (23) has a solution with $tau$, $tau_1$, $T > 0$ at which (21) has none",
       .idea = "where $cos(omega_1 tau/2) = 0$ the half of (13) that (16) keeps does not give back the other "
               "one; the determinant is $cos(omega_1 tau/2) cos(omega_2 tau/2) cos(T/2)$ times the one that "
               "orbits need; "
               "(23) is deduced by dividing by $Delta$, which is zero along lines $tau + tau_1$ = constant",
       .see = "stickslip check 16 23.spurious --explain",
       .claims = {"23.spurious", "16", "16.det", "16.orbits", "S.det", "22.square", "22.null"}},
  };
}

}  // namespace

std::vector<Result> results() {
  std::vector<Result> all = on_orbits_that_never_stick();
  for (const std::vector<Result>& more : {on_stability(), on_equations()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace stickslip::proofs::pascal2012
