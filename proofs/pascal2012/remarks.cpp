// What there is to say about the statements that do not hold as the paper has them, the weightiest first:
// what it says, what is so, and why, each on its own.
#include "proofs/pascal2012/remarks.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace {

std::vector<Remark> on_orbits() {
  return {
      {.claim = "7.only",
       .place = "Section 6, after (33)",
       .says = "orbits that never stick are obtained for $V = 0$ and for no other $V$",
       .fact = "such orbits exist on a moving belt: at $chi = 0.3$, $eta = 4$, $u_s = 0.1$, $u_r = 0.2$, $V "
               "= 0.1$, $omega = 0.6$, $p = 1$ one is proved to exist and to obey every condition along the "
               "whole motion",
       .because = "(33) is deduced for slips that last half a period, and off resonance only $V = 0$ allows "
                  "that (33.V); without this assumption the slip below the belt's velocity lasts longer than "
                  "half a period where $V > 0$ (A5.longer)",
       .see = "stickslip orbits nonsticking --chi 0.3 --eta 4 --us 0.1 --ur 0.2 --V 0.1 --omega 0.6 --p 1",
       .quote = "non-sticking periodic orbits are obtained only for $V = 0$"},
      {.claim = "7.only.half",
       .place = "Section 6, after (33)",
       .says = "orbits that never stick, with $tau = Theta/2$, are obtained for $V = 0$ and for no other $V$",
       .fact = "at resonance one exists on a moving belt: at $chi = 0.625$, $eta = 2.4$, $u_s = 0.1$, $u_r = "
               "0.12$, $V = 0.1$, $omega = 0.25$, $p = 3$, where $omega_1 = 2 omega$ and $omega_2 = 6 omega$",
       .because = "a free motion of the first mode then has the load's period and $x2' = V cos(omega_1 t)$, "
                  "which is $V$ at 0 and $tau$: it may be added to the orbit for a belt at rest; where $det "
                  "H_3$ is not zero the statement is proved (33.V)",
       .see = "stickslip check 7.only.half --explain",
       .quote = "non-sticking periodic orbits are obtained only for $V = 0$"},
      {.claim = "7.always",
       .place = "abstract and Section 7",
       .says = "with the belt at rest every orbit that never sticks is symmetric in space and time; said "
               "without exception",
       .fact =
           "at resonance it is not: at $omega_1 = 7/10 = 2 omega$, $omega_2 = 13/10$ a whole family of "
           "orbits of one and the same machine is proved, of which one alone is symmetric (33.even.orbits)",
       .because = "a free motion of the first mode then has the load's period and vanishing velocity at both "
                  "transitions, and may be added to the symmetric orbit; off resonance, which is all $omega$ "
                  "but countably many, the statement is proved (7.symmetric, A5.symmetry)",
       .see = "stickslip check 7.always 33.even --explain",
       .quote = "We prove that this kind of solution is symmetric in space and in time"},
      {.claim = "12.enough",
       .place = "Section 4, after (12)",
       .says = "once (12) holds the second mass slips below the belt's velocity until $tau$",
       .fact = "it may exceed the belt's velocity within the slip, though (12)-(16) hold, (14) strictly: at "
               "$omega_1 = 2/3$, $omega_2 = 8/3$, $omega = 1/2$, $u_s = 0.02$, $V = 1$ the slip that lasts "
               "$tau = 6$ does, by 1.43",
       .because = "(12)-(16) look at the ends of the slip alone; $x2' < V$ between them is a condition of "
                  "its own",
       .see = "stickslip check 12.enough --explain",
       .quote = "For $0 < t < tau$, the system undergoes a slip motion defined by (5)"},
      {.claim = "14.enough",
       .place = "Section 4, after (14)",
       .says = "once (14) holds the mass sticks from $tau$ to $tau + T$",
       .fact = "the friction that this needs may exceed $u_r$ within the stick, though (12)-(16) hold, (14) "
               "strictly: at $omega_1 = 1/3$, $omega_2 = 2$, $omega = 2/3$, $u_s = 0.02$, $V = 1$, $tau = "
               "3$ it is 3.1 where $u_r = 0.29$",
       .because =
           "(14) is (11) at $tau$ alone; at all times of the stick (11) is a condition of its own, $f_1 "
           "<= 0$ and $f_2 > 0$, which the paper looks at for its example",
       .see = "stickslip check 14.enough --explain",
       .quote = "the system motion is a sticking motion given by"},
      {.claim = "18.enough",
       .place = "Section 5, after (18)",
       .says = "once (18) holds the second mass is faster than the belt until $tau + tau_1$",
       .fact = "it may be slower than the belt for a time, though (12) and (18)-(20) hold: at $omega_1 = "
               "1/3$, $omega_2 = 13/6$, $omega = 1/6$, $phi = -0.05$, $V = 1$, $u_s = 0.044$, $p = 4.48$ a "
               "motion with $tau = 6 pi$, $tau_1 = T = 3 pi$ is, by 0.045",
       .because = "(18) and (19) look at the ends of the overshoot alone; $x2' > V$ between them is a "
                  "condition of its own",
       .see = "stickslip check 18.enough --explain",
       .quote = "we get an overshooting motion for $t > tau$"},
      {.claim = "19.enough",
       .place = "Section 5, after (19)",
       .says = "once (19) holds the mass sticks until the period is over",
       .fact = "the friction that this needs may exceed $u_r$ within the stick, though (12) and (18)-(20) "
               "hold: on the motion given after (18) it is 0.277 where $u_r = 0.204$",
       .because = "(19) is (11) at $tau + tau_1$ alone; at all times of the stick (11) is a condition of its "
                  "own",
       .see = "stickslip check 19.enough --explain",
       .quote = "the system undergoes a sticking motion"},
      {.claim = "25.enough",
       .place = "Section 6, after (25)",
       .says = "once (25) holds the second mass slips below the belt's velocity until $tau$",
       .fact = "it may exceed the belt's velocity within the slip, though (25), (26), (36) and (37) hold and "
               "the motion closes: by 0.57 at $omega_1 = 2/3$, $omega_2 = 2.4$, $omega = 0.5$, $u_s = "
               "0.1$, $u_r = 0.15$, $V = 0$ and the load that makes $phi = -0.25$",
       .because = "(25) and (26) look at the ends of the slip alone; that $x2' < V$ between them is a "
                  "condition of its own, on the load, too (37.speed)",
       .see = "stickslip check 25.enough --explain",
       .quote = "the system undergoes a slipping motion with"},
      {.claim = "26.enough",
       .place = "Section 6, after (26)",
       .says = "once (26) holds the second mass is faster than the belt until the period is over",
       .fact = "it may be slower than the belt for a time, though (25), (26), (36) and (37) hold and the "
               "motion closes: the motion of 25.enough is",
       .because = "its second half is the first one turned round, $x(t + tau) = -x(t)$ (54), and so is "
                  "what fails",
       .see = "stickslip check 26.enough --explain",
       .quote = "For $t > tau$ the system undergoes an overshooting slipping motion"},
      {.claim = "S.data",
       .place = "Section 4, example",
       .says = "$u_r = 0.1607$ belongs to the data of the orbit of Fig. 2",
       .fact =
           "at the other data no symmetric orbit has a $u_r$ that rounds to it; at all of them, $u_r = "
           "0.1607$ included, there are two orbits of slip and stick, which are not symmetric (S.asymmetric)",
       .because = "by (12) $u_r$ is a result, and the one of the orbit of Fig. 2 is another in the last "
                  "digits (S.ur); it was computed from the other printed numbers (S.from.ur)",
       .see = "stickslip check S.data S.asymmetric --explain",
       .quote = "A numerical validation is made for the following set of data"},
      {.claim = "16",
       .place = "(16)",
       .says = "orbits of the first family exist under the four equations (16)",
       .fact = "(16) follows from (13) and (15), and gives them back where $cos(omega_1 tau/2)$, "
               "$cos(omega_2 tau/2)$ and $cos(T/2)$ are not zero (16.back); at $tau = pi/omega_1$ it has a "
               "solution for all parameters, and at $omega_1 = 1/2$, $omega_2 = 7/3$, $omega = 3/5$, $u_s = "
               "0.1$, $V = 1$, $p = 1/2$ this does not close",
       .because = "each equation is one half of (13) or (15), and the other half follows by dividing by "
                  "these cosines",
       .see = "stickslip check 16 16.back --explain",
       .quote = "the conditions for the existence of this periodic solution are given by the following "
                "system of four scalar equations"},
      {.claim = "37.enough",
       .place = "(37)",
       .says = "the least load amplitude against sticking is the right side of (37)",
       .fact =
           "(37) is necessary and not sufficient: it leaves out $u_r$ and what the mass does within the "
           "slip. "
           "Necessary and sufficient for (36) is the same bound with the root of $B^2 + (eta u_r/omega)^2$ "
           "in "
           "place of $|B|$, $B = b_1 d_01 + b_2 d_02$ (37.sharp, 37.sharp.back); for $x2' < 0$ at a time $t$ "
           "of the slip at which it would be $g > 0$ without the load's push, the root of $B^2 + "
           "(g/sin(omega t))^2$ (37.slip, 37.slip.back). The least load is the largest of all these, for "
           "all parameters (37.slip.free): at $chi = 0.64$, $eta = 7.9$, $u_s = 0.1$, $u_r = 0.15$, $omega = "
           "0.492$ it is 6.04, and (36) alone asks for 2.75 (37.least)",
       .because =
           "(36) says $q_2 omega cos(phi) > eta u_r/omega$, $x2' < 0$ says $q_2 omega cos(phi) > g/sin(omega "
           "t)$ (37.speed), and (35) says $q_2 omega sin(phi) = -B$: the squares add up to $(q_2 omega)^2$; "
           "(37) keeps the last alone, which is that $phi$ exists",
       .see = "stickslip check 37 --explain",
       .quote = "a condition about the minimum value of the external force amplitude needed to avoid a "
                "sticking motion is obtained"},
  };
}

std::vector<Remark> on_misprints() {
  return {
      {.claim = "47.c",
       .place = "(47), $c_1$",
       .says = "$Gamma_13$ has the minus sign in $c_1$",
       .fact = "it has the plus sign; the nineteen other coefficients of (47)-(51) are right",
       .because = "the stick is run backwards there, and of $Gamma(-T)$ the entries of the upper right block "
                  "have the opposite sign (20.C); the printed $tau$ and $tau_1$ were not computed with the "
                  "minus sign (O.c1)",
       .see = "stickslip check 47 --explain"},
      {.claim = "19",
       .place = "(19)",
       .says = "the friction needed for sticking is compared at the time $tau + tau_2$, and without the "
               "factor $eta$",
       .fact = "the time is $tau + tau_1$, where the overshooting ends, and the factor is there",
       .because = "(19) is $|r| < u_r$ of (4), multiplied by $eta$; with this factor and $tau_1$ it says the "
                  "same as (4) (19.back). Its left inequality always holds (19.implied)",
       .see = "stickslip check 19 --explain",
       .quote =
           "an overshooting motion for $t > tau$. This motion ends at $t = tau + tau_1$ if, at this time",
       .note = "To be compared with the printed page: the text read has lost glyphs, and the factor $eta$ "
               "may be one of them; $tau_2$ is in it."},
      {.claim = "45",
       .place = "(45)",
       .says =
           "the right side, with $Gamma(T - t_1)$, is the state at the time $t$, where $t_1 = t - tau$ by "
           "(17)",
       .fact = "it is the state at the time $tau + T - t_1$",
       .because = "$T - t_1$ is the time that has passed since the stick began at $tau$",
       .see = "stickslip check 45 --explain"},
  };
}

// Which no claim of the paper's fails for: its letter says more than its proof gives, or leaves out a step.
std::vector<Remark> on_steps() {
  return {
      {.claim = "4.lag.only",
       .place = "Section 4, before (14)",
       .says = "the time lag is $phi = (pi - omega tau)/2$, without argument",
       .fact =
           "as a choice it is sound, and (44) makes use of it; it does not follow: except for slips on which "
           "(13) leaves $phi$ free, (13) asks for $cos(phi + omega tau/2) = 0$ (4.lag.needed), which "
           "$phi + pi$ fulfils as well, and both occur: {S.lag}",
       .because =
           "adding $pi$ to $phi$ changes the sign of $p$, in (16) and in $f_1$, $f_2$, and nothing else",
       .see = "stickslip orbits symmetric --example S",
       .quote = "The time lag $phi$ of the external force is given by"},
      {.claim = "67.branch",
       .place = "Appendix 5, after (67)",
       .says = "either $phi_B = -phi$, which is $phi = -omega tau/2$, or $tau = tau_1 = pi/omega$",
       .fact = "it is $sin(phi + omega tau/2) = 0$, so that $phi = pi - omega tau/2$ is a case as well; the "
               "argument of the paper excludes it, too (67.first, 67.impossible)",
       .because = "a sine is zero at every multiple of $pi$",
       .see = "stickslip check 67 --explain"},
      {.claim = "67.sin",
       .place = "Appendix 5, after (67)",
       .says = "(67) gives $sin(phi_B) = -sin(phi)$",
       .fact =
           "(67) gives $q_2 (sin(phi_B) + sin(phi)) = 0$, which is divided by $q_2$: that $q_2$ is not zero, "
           "neither $p = 0$ nor $omega = 1$, is a hypothesis. The symmetry holds without it (A5.symmetry)",
       .because = "the second row of (67) has $Q omega$, that is $q_2 omega$, in front of both sines",
       .see = "stickslip check 67 A5.symmetry --explain"},
  };
}

std::vector<Remark> on_what_is_taken_for_granted() {
  return {
      {.claim = "7.steady",
       .place = "Section 7",
       .says = "the orbits of the three figures are steady-state responses: what a motion settles on",
       .fact = "that of Fig. 2 is unstable, and motions that begin near it leave it; those of Figs. 3 and 4 "
               "are stable",
       .because = "a Floquet multiplier of the orbit of Fig. 2 is greater than 1, in balls",
       .see = "stickslip orbits symmetric --example S",
       .quote = "the steady state response of a two-degree-of-freedom oscillator subjected to dry friction "
                "and harmonic load is considered"},
      {.claim = "4.defined",
       .place = "(4)",
       .says = "the law gives a friction in every state",
       .fact = "it gives none where $x2' = V$ and $|r| = u_r$, where each slip of Sections 4 and 5 begins; "
               "every motion of the paper goes on from there with $u = u_s$",
       .because = "its cases are $|r| < u_r$, $r > u_r$ and $r < -u_r$",
       .see = "stickslip check 4.defined --explain",
       .quote = "The dry friction force $u$ is obtained from Coulomb’s laws"},
      {.claim = "4.unique",
       .place = "(4)",
       .says = "the law continues every motion in one way",
       .fact = "where $x2' = V$ and $u_s < r < u_r$ a stick obeys it, and so does a slip with $u = u_s$; the "
               "paper means the stick",
       .because = "with $u = u_s$ the acceleration $x2'' = eta (u_s - r)$ is negative there, and the mass "
                  "has left the belt's velocity at once",
       .see = "stickslip check 4.unique 4.slips --explain"},
  };
}

}  // namespace

std::vector<Remark> remarks() {
  std::vector<Remark> all = on_orbits();
  for (const std::vector<Remark>& more : {on_misprints(), on_steps(), on_what_is_taken_for_granted()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace stickslip::proofs::pascal2012
