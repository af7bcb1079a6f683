// What the audit found beyond the paper: theorems with all their hypotheses, the strongest first.
#include <fmt/format.h>

#include "model/parameters.hpp"
#include "proofs/pascal2012/examples.hpp"
#include "proofs/pascal2012/remarks.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace {

// What all of them assume.
const std::string model = "Let $0 < chi < 1$, $eta > 0$ and $u_s > 0$";
const std::string off_resonance = "$sin(omega_1 Theta/2) sin(omega_2 Theta/2) != 0$";

// What they speak of.
const std::string equations =
    "A motion is a continuous $X = (x_1, x_2, x_1', x_2')$ that obeys $x_1'' + x_1 - chi x_2 = 0$, $x_2'' + "
    "chi eta (x_2 - x_1) = eta u + p cos(omega t + phi)$ (2).";
const std::string law =
    " The friction $u$ is that of (4), with $r = chi (x_2 - x_1) - (p/eta) cos(omega t + phi)$: $u = u_s "
    "sign(V - x_2')$ where $x_2' != V$; where $x_2' = V$, $u = r$ if $|r| < u_r$, and $u = u_s$ if $r >= "
    "u_r$, $u = -u_s$ if $r <= -u_r$.";
const std::string period = " The load has the period $Theta = 2 pi/omega$.";
const std::string frequencies =
    " The squares of $omega_1 < omega_2$ are the eigenvalues of $K$, whose rows are $(1, -chi)$ and $(-chi "
    "eta, chi eta)$.";

const std::string closed_form =
    " Let $q_1 = chi p/D$, $q_2 = q_1 (1 - omega^2)/chi$, $d_01 = u_s/(1 - chi)$, $d_02 = d_01/chi$, "
    "$lambda_i = "
    "(1 - omega_i^2)/chi$, $phi_i = omega_i tan(omega_i pi/(2 omega))$, $d = chi/(omega_1^2 - omega_2^2)$, "
    "$b_1 "
    "= d (phi_1 - phi_2) lambda_1 lambda_2$ and $b_2 = d (lambda_2 phi_2 - lambda_1 phi_1)$.";

const std::string turned =
    " The slip ends by (13) if at its end the places $x - d_0$, $d_0 = (1, 1/chi) u_s/(1 - chi)$, are "
    "opposite to "
    "those at its beginning, and the velocities the same.";

// "$chi = 0.5$, $eta = 3.8$, …" of the figure: what its orbits were computed from.
std::string data_of(const std::string& name) {
  using stickslip::to_string;
  const Example& example = example_named(name);
  const numeric::motion::ExactParameters& a = example.data;
  std::string result =
      fmt::format("$chi = {}$, $eta = {}$, $u_s = {}$, $V = {}$, $omega = {}$, $p = {}$", to_string(a.chi),
                  to_string(a.eta), to_string(a.us), to_string(a.V), to_string(a.omega), to_string(a.p));
  result += example.phi ? fmt::format(", $phi = {}$", to_string(*example.phi)) : "";
  return result + (example.ur ? fmt::format(", $u_r = {}$", to_string(*example.ur)) : "");
}

// The machine that has these natural frequencies: "$chi = …$, $eta = …$, which give $omega_1 = 7/10$, …".
std::string with_frequencies(const Rational& omega1, const Rational& omega2) {
  return fmt::format("$chi = {}$, $eta = {}$, which give $omega_1 = {}$, $omega_2 = {}$",
                     model::chi_from_frequencies<Rational>(omega1, omega2).get_str(),
                     model::eta_from_frequencies<Rational>(omega1, omega2).get_str(), omega1.get_str(),
                     omega2.get_str());
}

std::vector<Result> on_orbits_that_never_stick() {
  return {
      {.id = "moving-belt",
       .title = "Orbits that never stick exist on a moving belt",
       .setting = equations + law + period,
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
           "lasts longer than half a period; at resonance, where $omega_1 = 2 omega$, one with two equal "
           "slips "
           "exists, too (7.only.half)",
       .see = "stickslip orbits nonsticking --chi 0.3 --eta 4 --us 0.1 --ur 0.2 --V 0.1 --omega 0.6 --p 1",
       .claims = {"7.only", "A5.longer", "28.reduced", "7.only.half"}},
      {.id = "resonance",
       .title = "At resonance there are families of orbits that are not symmetric",
       .setting = equations + law + period,
       .theorem =
           "At " + with_frequencies({7, 10}, {13, 10}) +
           ", and $omega = 7/20$, $u_s = 0.1$, $u_r = 0.12$, "
           "$p = 3$, $V = 0$ the equations (2) with the law (4) have, for every $epsilon$ from $-1/20$ to "
           "$1/20$, an orbit "
           "of the load's period that never sticks; $x(tau) + x(0) = 2 epsilon (1, lambda_1)$, so that it is "
           "symmetric in space for $epsilon = 0$ only",
       .idea = "where $omega_1 = 2 omega$ the free motion $epsilon cos(omega_1 t)$ of the first mode has the "
               "load's "
               "period and no velocity at 0 and $tau$, and may be added to the motion of (33); that $x2'$ "
               "keeps its "
               "sign on both slips is decided in balls for all $epsilon$ at once",
       .see = "stickslip check 33.even --explain",
       .claims = {"33.even.orbits", "33.even", "33.even.speed", "33.even.start", "33.even.places",
                  "7.exception"}},
      {.id = "uniqueness",
       .title = "There is at most one orbit that never sticks",
       .setting = equations + frequencies,
       .theorem =
           model + ", and let $Theta > 0$ be off resonance, " + off_resonance +
           ". For every $V$, $omega$, $p$ and $phi$ two motions $X$ and $Y$ of period $Theta$ that obey (2) "
           "with $u = u_s sign(V - x2')$ at all times but finitely many are equal, whatever the number of "
           "their transitions, and whether they are the paper's: there is at most one",
       .idea =
           "the energy of the difference of two such motions changes at the rate $u_s (x2' - y2') (sign(V - "
           "x2') - sign(V - y2')) <= 0$; being periodic it is constant, so that the frictions are equal. "
           "The difference then moves freely with period $Theta$, and off resonance only rest does",
       .see = "stickslip check A5.unique --explain",
       .claims = {"A5.unique", "A5.energy", "A5.sides", "A5.moves", "A5.free"}},
      {.id = "symmetry",
       .title = "Orbits that never stick are symmetric, without the paper's hypotheses",
       .setting = equations + frequencies,
       .theorem = model + ", $V = 0$, $Theta = 2 pi/omega$, and off resonance, " + off_resonance +
                  ". Every motion $X$ of period $Theta$ that obeys (2) with $u = u_s sign(-x2')$ at "
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
       .setting = equations,
       .theorem = model +
                  ". Two motions $X$ and $Y = (y_1, y_2, y_1', y_2')$ that obey (2) with $u = u_s sign(V - "
                  "x2')$ at all times but "
                  "finitely many do not move apart: the energy of their difference is at the end of any time "
                  "$Theta > "
                  "0$ at most what it was at its beginning",
       .idea = "the energy of the difference changes at the rate $u_s (x2' - y2') (sign(V - x2') - sign(V - "
               "y2')) <= "
               "0$",
       .see = "stickslip check A5.stable --explain",
       .claims = {"A5.stable", "A5.energy"}},
      {.id = "attraction",
       .title = "Off resonance, orbits that never stick on a belt at rest attract",
       .setting = equations + law,
       .theorem = model +
                  ", $V = 0$, $tau = pi/omega$, with $omega_j != k omega$ and $omega_2 +- omega_1 != 2 k "
                  "omega$ for all whole $k$. A deviation over four half periods loses energy unless it is "
                  "zero, so that every symmetric orbit with two transitions per period, none of them at "
                  "$|r| = u_s$, is exponentially stable, and the product of its Floquet multipliers is "
                  "$rho^2$, $rho = (|r| - u_s)/(|r| + u_s)$ at its transitions",
       .idea =
           "between transitions a small deviation moves freely and keeps its energy; a transition takes the "
           "speed $delta_2'$ of the second mass to $rho delta_2'$ and leaves all else. If nothing is lost "
           "over "
           "four of them, this speed was zero at all four, and then both modes are: their parts of it differ "
           "in frequency. These identities are checked; that a norm of deviations which falls over four half "
           "periods makes them die out exponentially is the usual argument, told here only",
       .see = "stickslip check A5.seen A5.loss A5.product --explain",
       .claims = {"A5.seen", "A5.loss", "A5.product"}},
      {.id = "stability",
       .title = "The orbit of Fig. 2 is unstable; those of Figs. 3 and 4 are stable",
       .setting = equations + law + period,
       .theorem = "At " + data_of("S") + " the orbit of Fig. 2 has a Floquet multiplier greater than 1; at " +
                  data_of("O") +
                  " all multipliers of the orbit of Fig. 3 lie inside the unit circle, and so do at " +
                  data_of("P") + " those of the orbit of Fig. 4",
       .idea = "the derivative of the return map is composed of the phases' flows and of the jumps at the "
               "events, "
               "and its eigenvalues are enclosed in balls",
       .see = "stickslip check S.stability O.stability P.stability --explain",
       .claims = {"S.stability", "O.stability", "P.stability"},
       .lists = true},
      {.id = "asymmetric",
       .title = "With all data of Fig. 2 there are two orbits of slip and stick, and they are not symmetric",
       .setting = equations + law + period + turned,
       .theorem = "At " + data_of("S") + " and $u_r = " + example_named("S").result("ur").value.text +
                  "$ the equations (2) with the law (4) have exactly two motions of the load's period with "
                  "one slip, "
                  "which lasts $tau$, and one stick; neither slip ends by (13)",
       .idea =
           "for a given $tau$ the closing conditions are linear in the state and in the cosine and sine of "
           "the load's phase: one equation for $tau$ remains, whose zeros are isolated in balls",
       .see = "stickslip orbits ST --period 1 --chi 0.5 --eta 3.8 --us 0.02 --V 1 --omega 0.6 --p 0.05 --ur "
              "0.1607",
       .claims = {"S.asymmetric", "S.data", "S.lag"},
       .lists = true},
      {.id = "lists",
       .title = "All orbits of each family at the data of the figures",
       .setting = equations + law + period + turned,
       .theorem = "Three families of orbits of the load's period are exactly these: at " + data_of("S") +
                  " (Fig. 2) those with a slip on $(0, tau)$ that ends by (13) and a stick, "
                  "each for another $u_r$; at " +
                  data_of("O") +
                  " (Fig. 3) those with a slip on $(0, tau)$, an overshoot on $(tau, tau + tau_1)$ and a "
                  "stick, each "
                  "for another $u_r$; at " +
                  data_of("P") +
                  " (Fig. 4) those with a slip on $(0, tau)$ and an overshoot. An orbit is admissible if it "
                  "obeys (4) "
                  "along the whole motion",
       .idea =
           "the closing equations are reduced to two unknowns; a box of these either holds no zero, or "
           "Krawczyk's test proves that it holds exactly one, and the boxes cover the domain, ends included",
       .see = "stickslip check S.list O.list P.list --explain",
       .claims = {"S.list", "O.list", "P.list"},
       .lists = true},
  };
}

std::vector<Result> on_equations() {
  return {
      {.id = "least-load",
       .title = "The sharp bound on the load against sticking",
       .setting = equations + law + period + frequencies + closed_form,
       .theorem =
           model +
           ", $V = 0$, $tau = Theta/2$, $sin(omega_1 tau) sin(omega_2 tau) != 0$, $omega != 1$ and $p > 0$. "
           "A motion of period $Theta$ with $u = u_s$ on $(0, tau)$ and $u = -u_s$ on $(tau, Theta)$, and "
           "with "
           "$x_2' = 0$ at 0 and $tau$, obeys $chi eta (q_2 - q_1) cos(phi) - p cos(phi) - eta u_r > 0$ (36), "
           "which is $r > u_r$ at 0 and $r < -u_r$ at $tau$, exactly if $q_2 cos(phi) > 0$ and $p^2 > "
           "(D/(omega (1 - omega^2)))^2 (B^2 + "
           "(eta u_r/omega)^2)$, with $D = (omega^2 - omega_1^2)(omega^2 - omega_2^2)$ and $B = b_1 d_01 + "
           "b_2 d_02$; (37) is this bound without $u_r$",
       .idea =
           "(36) gives $q_2 omega cos(phi) > eta u_r/omega$ and (35) gives $q_2 omega sin(phi) = -B$; the "
           "squares add up, and (7) makes $q_2$ a multiple of $p$",
       .see = "stickslip check 37.sharp 37.sharp.back --explain",
       .claims = {"37.sharp", "37.sharp.back", "P.least"}},
      {.id = "spurious",
       .title = "(16) and (23) have zeros that are no orbits",
       .setting = equations + law + period + frequencies,
       .theorem =
           "At " + with_frequencies({1, 2}, {7, 3}) +
           ", and $omega = 3/5$, $u_s = 0.1$, $V = 1$, $p = 1/2$, "
           "the equations (16) have, with $tau = pi/omega_1$, a solution that does not fulfil (13). At " +
           data_of("S") +
           " (Fig. 2) "
           "the determinant of (16) vanishes at eight $tau$ between 0 and $Theta$, of which two "
           "are orbits. At " +
           data_of("O") +
           " (Fig. 3) the equations "
           "(23) have a solution with $tau$, $tau_1$, $T > 0$ at which (21) has none",
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
