/* Orbit O for AUTO-07p: slip, overshoot and stick, each over t in [0, 1], as one boundary value problem.
   u: x1, x2, x1', x2' of the slip; the same of the overshoot; x1, x2, x1' of the stick; t.
   par: omega, tau, tau1, then what must be positive at the ends of phases: u_r - u_s, (18), (19) above and below. */
#include "auto_f2c.h"

static const double chi = 0.2, eta = 4, us = 0.05, V = 1, p = 0.05; /* phi = 0 */

/* r of (4) at the load's phase. */
static double at_rest(const double * x, double phase) {
  return chi * (x[1] - x[0]) - p * cos(phase) / eta;
}

static void slip(const double * x, double friction, double phase, double duration, double * f) {
  f[0] = duration * x[2];
  f[1] = duration * x[3];
  f[2] = duration * (chi * x[1] - x[0]);
  f[3] = duration * eta * (friction - at_rest(x, phase));
}

static int func(integer ndim, const doublereal * u, const integer * icp, const doublereal * par, integer ijac,
                doublereal * f, doublereal * dfdu, doublereal * dfdp) {
  const double omega = par[0], tau = par[1], tau1 = par[2], t = u[11];
  const double T = 2 * M_PI / omega - tau - tau1;
  slip(u, us, omega * tau * t, tau, f);
  slip(u + 4, -us, omega * (tau + tau1 * t), tau1, f + 4);
  f[8] = T * u[10];
  f[9] = T * V;
  f[10] = T * (chi * u[9] - u[8]);
  f[11] = 1;
  return 0;
}

static int bcnd(integer ndim, const doublereal * par, const integer * icp, integer nbc, const doublereal * a,
                const doublereal * b, integer ijac, doublereal * f, doublereal * dbc) {
  const double omega = par[0], tau = par[1], tau1 = par[2], ur = at_rest(a, 0);
  const double landing = at_rest(a + 8, omega * (tau + tau1));
  int i;
  for (i = 0; i < 3; ++i) {
    f[i] = a[4 + i] - b[i];
    f[3 + i] = a[8 + i] - b[4 + i];
    f[6 + i] = a[i] - b[8 + i];
  }
  f[9] = a[3] - V;
  f[10] = b[3] - V;
  f[11] = a[7] - V;
  f[12] = b[7] - V;
  f[13] = a[11];
  f[14] = par[3] - (ur - us);
  f[15] = par[4] + (at_rest(a + 4, omega * tau) + ur);
  f[16] = par[5] - (ur - landing);
  f[17] = par[6] - (ur + landing);
  return 0;
}

static int stpnt(integer ndim, doublereal t, doublereal * u, doublereal * par) {
  return 0;
}
static int icnd() {
  return 0;
}
static int fopt() {
  return 0;
}
static int pvls() {
  return 0;
}
