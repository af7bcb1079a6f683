#!/usr/bin/python3
"""One of the paper's orbits to many digits with mpmath: orbits.py S|O|P DIGITS GUESS GUESS

S: the amplitude of the stick eliminated from (16), one equation for tau; secant method (findroot's own choice).
O: the paper's (22), (23), two equations for (tau, tau1); multidimensional Newton.
P: the closing conditions in (delta, mu) = (omega tau/2, phi + delta); multidimensional Newton.
P.closed: (35), which gives phi in closed form where tau = Theta/2; no iteration.

The guess is good to the digits of a double. Prints one line of JSON; the seconds are CPU time of the solution alone.
"""
import json
import sys
import time

from mpmath import asin, cos, findroot, lu_solve, matrix, mp, mpf, nstr, pi, sin, sqrt, tan

DATA = {  # chi, eta, us, V, omega, p
    "S": ("0.5", "3.8", "0.02", "1", "0.6", "0.05"),
    "O": ("0.2", "4", "0.05", "1", "0.6289", "0.05"),
    "P": ("0.3", "4", "0.1", "0", "0.6", "1"),
}


class Oscillator:
    def __init__(self, name):
        self.chi, self.eta, self.us, self.V, self.omega, self.p = (mpf(x) for x in DATA[name])
        chi, eta, w2 = self.chi, self.eta, self.omega**2
        half, product = (1 + chi * eta) / 2, chi * eta * (1 - chi)
        root = sqrt(half**2 - product)
        self.w1, self.w2 = sqrt(half - root), sqrt(half + root)                      # (39)
        self.l1, self.l2 = (1 - self.w1**2) / chi, (1 - self.w2**2) / chi
        q1 = chi * self.p / ((w2 - self.w1**2) * (w2 - self.w2**2))
        self.Q = (q1, q1 * (1 - w2) / chi)                                           # (7)
        d01 = self.us / (1 - chi)
        self.d0 = (d01, d01 / chi)                                                   # (6)
        self.Theta = 2 * pi / self.omega

    def H(self, t):
        """The blocks H_1, H_2, H_3 of (38) as 4 x 4."""
        det = self.l2 - self.l1
        def block(f1, f2):  # Lambda diag(f1, f2) Lambda^-1
            l1, l2 = self.l1, self.l2
            return (((l2 * f1 - l1 * f2) / det, (f2 - f1) / det), (l1 * l2 * (f1 - f2) / det, (l2 * f2 - l1 * f1) / det))
        c1, s1, c2, s2 = cos(self.w1 * t), sin(self.w1 * t), cos(self.w2 * t), sin(self.w2 * t)
        one, two, three = block(c1, c2), block(s1 / self.w1, s2 / self.w2), block(-self.w1 * s1, -self.w2 * s2)
        return matrix([one[0] + two[0], one[1] + two[1], three[0] + one[0], three[1] + one[1]])

    def F(self, t, phi):
        c, s, q = cos(self.omega * t + phi), sin(self.omega * t + phi), self.Q
        return matrix([q[0] * c, q[1] * c, -q[0] * self.omega * s, -q[1] * self.omega * s])


def solve_S(o, tau, _):
    def row(wj, wk, lk, tau):
        a, b, T = wj * tau / 2, o.omega * tau / 2, (o.Theta - tau) / 2
        left = lk * (wj * cos(a) * sin(T) + sin(a) * cos(T))
        load = (o.omega * cos(b) * sin(a) - wj * sin(b) * cos(a)) / (wj**2 - o.omega**2)
        return left, o.V * wk**2 * (wj * cos(a) * T + sin(a)) + o.p * load
    def eliminant(tau):
        left1, right1 = row(o.w1, o.w2, o.l2, tau)
        left2, right2 = row(o.w2, o.w1, o.l1, tau)
        return left2 * right1 - left1 * right2
    tau = findroot(eliminant, tau)
    left, right = row(o.w1, o.w2, o.l2, tau)
    T, C = (o.Theta - tau) / 2, right / left
    return {"tau": tau, "z10": o.chi * o.V * T + C * sin(T), "z20": o.V * T, "zdot10": o.chi * o.V + C * cos(T)}


def solve_O(o, tau, tau1):
    phi, belt, d0 = mpf(0), matrix([0, 0, 0, o.V]), o.d0
    F0 = o.F(0, phi)
    def rows(tau, tau1):
        """(21): five rows a z10 + b z20 + c z10' + d = 0."""
        T = o.Theta - tau - tau1
        first, whole, h = o.H(tau), o.H(tau + tau1), o.H(tau1)
        overshoot = matrix([2 * ((h[i, 0] - (i == 0)) * d0[0] + (h[i, 1] - (i == 1)) * d0[1]) for i in range(4)])
        c, s, x = cos(T), sin(T), o.chi
        back = matrix([[c, x * (1 - c), -s, x * (s - T)], [0, 1, 0, -T], [s, -x * s, c, x * (1 - c)]])
        rest_B = first * (belt - F0) + o.F(tau, phi)
        rest_C = whole * (belt - F0) + o.F(tau + tau1, phi) + overshoot
        gap = [[whole[i, j] - back[i, j] for j in range(3)] for i in range(3)]
        d = [rest_C[i] - back[i, 3] * o.V for i in range(3)]
        gap += [[first[3, j] for j in range(3)], [whole[3, j] for j in range(3)]]
        return gap, d + [rest_B[3] - o.V, rest_C[3] - o.V]
    def state(gap, d):
        return lu_solve(matrix(gap[:3]), -matrix(d[:3]))                             # (22)
    def F(tau, tau1):
        gap, d = rows(tau, tau1)
        u = state(gap, d)
        return [gap[k][0] * u[0] + gap[k][1] * u[1] + gap[k][2] * u[2] + d[k] for k in (3, 4)]  # (23)
    tau, tau1 = findroot(F, (tau, tau1), solver="mdnewton")
    u = state(*rows(tau, tau1))
    return {"tau": tau, "tau1": tau1, "z10": u[0], "z20": u[1], "zdot10": u[2]}


def solve_P(o, delta, mu):
    det, A = o.l2 - o.l1, o.Q[1] * o.omega
    c = ((o.l2 * o.d0[0] - o.d0[1]) / det, (o.d0[1] - o.l1 * o.d0[0]) / det)
    def speed(delta):
        return sum(-2 * l * cj * w * sin(w / o.omega * delta) * sin(w / o.omega * (pi - delta)) / sin(w / o.omega * pi)
                   for w, l, cj in ((o.w1, o.l1, c[0]), (o.w2, o.l2, c[1])))
    def F(delta, mu):
        return [o.V + A * sin(mu) * cos(delta), speed(delta) / sin(delta) + A * cos(mu)]
    delta, mu = findroot(F, (delta, mu), solver="mdnewton")
    return {"tau": 2 * delta / o.omega, "phi": mu - delta}


def closed_P(o, *_):
    f1, f2 = (w * tan(w * pi / (2 * o.omega)) for w in (o.w1, o.w2))
    d = o.chi / (o.w1**2 - o.w2**2)
    b1, b2 = d * (f1 - f2) * o.l1 * o.l2, d * (o.l2 * f2 - o.l1 * f1)
    return {"tau": pi / o.omega, "phi": asin(-(b1 * o.d0[0] + b2 * o.d0[1]) / (o.Q[1] * o.omega))}


def main():
    name, digits = sys.argv[1], int(sys.argv[2])
    mp.dps = digits + 5
    guess = [mpf(x) for x in sys.argv[3:]]
    solve = {"S": solve_S, "O": solve_O, "P": solve_P, "P.closed": closed_P}[name]
    runs = 0
    begin = time.process_time()
    while runs < 3 or time.process_time() - begin < 0.3:
        values = solve(Oscillator(name[0]), *guess)
        runs += 1
    seconds = (time.process_time() - begin) / runs
    print(json.dumps({"seconds": seconds, "values": {k: nstr(v, digits) for k, v in values.items()}}))


if __name__ == "__main__":
    main()
