#!/usr/bin/python3
"""Proves one of ten identities of the paper with SymPy: identities.py NAME ROUTE

ROUTE simplify: sympy.simplify on every entry of left - right.
ROUTE circle:   cos and sin of each phase become generators c, s by the addition theorems; the numerator of every
                entry is expanded and s^2 -> 1 - c^2 put in. It is zero exactly if the entry is.

Each identity is stated in the most general form in which it holds, which is the easiest for both routes: lambda_j and
chi are free symbols where nothing links them to the frequencies. Prints one line of JSON; the seconds are CPU time of
the proof alone, without the import of SymPy.
"""
import json
import sys
import time

from sympy import (Matrix, Poly, Symbol, cos, diag, expand, expand_trig, eye, fraction, pi, simplify, sin, symbols, tan,
                   together)

t, s, tau, tau1 = symbols("t s tau tau1", positive=True)
omega1, omega2, omega = symbols("omega1 omega2 omega", positive=True)
lambda1, lambda2, chi, phi, V = symbols("lambda1 lambda2 chi phi V")
q1, q2, d01, d02, Theta = symbols("q1 q2 d01 d02 Theta")
I2, I4, E = eye(2), eye(4), diag(-1, -1, 1, 1)
Lambda = Matrix([[1, 1], [lambda1, lambda2]])
Sigma = Matrix([[1, chi], [0, 1]])


def flow(basis, blocks, at):
    """Blocks 1, 2, 3 of H or Gamma, (38), (41)."""
    inverse = basis.inv()
    b2 = blocks(t)
    b1 = b2.diff(t)
    return [(basis * b.subs(t, at) * inverse) for b in (b1, b2, b1.diff(t))]


def H_blocks(at):
    return flow(Lambda, lambda u: diag(sin(omega1 * u) / omega1, sin(omega2 * u) / omega2), at)


def Gamma_blocks(at):
    return flow(Sigma, lambda u: diag(sin(u), u), at)


def assembled(blocks):
    one, two, three = blocks
    return Matrix([[one, two], [three, one]])


def H(at):
    return assembled(H_blocks(at))


def Gamma(at):
    return assembled(Gamma_blocks(at))


def blocks_relation(blocks):
    one, two, three = blocks
    return one * one - I2 - two * three


def response(at):
    """F of (5)."""
    x = omega * at + phi
    return Matrix([q1 * cos(x), q2 * cos(x), -q1 * omega * sin(x), -q2 * omega * sin(x)])


def coefficients_d():
    """d_1 ... d_5 of (47)-(51): what is left of the closing conditions where z10 = z20 = z10' = 0."""
    T = Symbol("T")
    Z0, d0, F0 = Matrix([0, 0, 0, V]), Matrix([d01, d02]), response(0)
    whole, first, second = tau + tau1, H(tau), H_blocks(tau1)
    L = Matrix([second[0] - I2, second[2]])
    ZB = first * (Z0 - F0) + response(tau)
    ZC = H(tau1) * (ZB - response(tau)) + response(whole) + 2 * L * d0
    back = Gamma(-T) * Z0
    derived = Matrix([ZC[0] - back[0], ZC[1] - back[1], ZC[2] - back[2], ZB[3] - V, ZC[3] - V])

    Ht, Hb, h, G = H(whole), first, H(tau1), Gamma(T)
    xB, xC = omega * tau + phi, omega * tau + phi + omega * tau1

    def place(M, i):
        return -(M[i, 0] * q1 + M[i, 1] * q2) * cos(phi)

    def speed(M, i, j):
        return omega * (M[i, j] * q1 + M[i, j + 1] * q2) * sin(phi)
    printed = Matrix([
        place(Ht, 0) + speed(Ht, 0, 2) + q1 * cos(xC) + 2 * (h[0, 0] - 1) * d01 + 2 * h[0, 1] * d02
        + (Ht[0, 3] + G[0, 3]) * V,
        place(Ht, 1) + speed(Ht, 1, 2) + q2 * cos(xC) + 2 * h[1, 0] * d01 + 2 * (h[1, 1] - 1) * d02 + (Ht[1, 3] + T) * V,
        place(Ht, 2) + speed(Ht, 0, 0) - omega * q1 * sin(xC) + 2 * h[2, 0] * d01 + 2 * h[2, 1] * d02
        + (Ht[0, 1] - G[0, 1]) * V,
        (Hb[1, 1] - 1) * V - q2 * omega * sin(xB) + place(Hb, 3) + speed(Hb, 1, 0),
        (Ht[1, 1] - 1) * V - q2 * omega * sin(xC) + place(Ht, 3) + speed(Ht, 1, 0) + 2 * (h[3, 0] * d01 + h[3, 1] * d02)])
    return derived - printed


def phase_35():
    """What (35) rests on: the second row of H2^-1 (H1 - I) at tau = pi/omega is -(b1, b2)."""
    one, two, _ = H_blocks(pi / omega)
    phi1, phi2 = (w * tan(w * pi / (2 * omega)) for w in (omega1, omega2))
    d = 1 / (lambda2 - lambda1)  # (35): chi/(omega1^2 - omega2^2), by lambda_j = (1 - omega_j^2)/chi
    row = (two.inv() * (one - I2))[1, :]
    return row + Matrix([[d * (phi1 - phi2) * lambda1 * lambda2, d * (lambda2 * phi2 - lambda1 * phi1)]])


def modal_70():
    """(70): P1 - P2 = Lambda diag(rho_1, rho_2) Lambda^-1."""
    one, two, _ = H_blocks(tau)
    h1, h2, _ = H_blocks(tau1)

    def rho(w):
        a, b = w * tau / 2, w * tau1 / 2
        return w * sin(a + b) / (sin(a) * sin(b))
    return two.inv() * (one + I2) + h2.inv() * (h1 + I2) - Lambda * diag(rho(omega1), rho(omega2)) * Lambda.inv()


IDENTITIES = {
    "40": lambda: blocks_relation(H_blocks(t)),
    "38.reversal": lambda: H(-t) * E - E * H(t),
    "38.group": lambda: H(t + s) - H(t) * H(s),
    "42": lambda: blocks_relation(Gamma_blocks(t)),
    "41.reversal": lambda: Gamma(-t) * E - E * Gamma(t),
    "41.group": lambda: Gamma(t + s) - Gamma(t) * Gamma(s),
    "59": lambda: ((H(t) * E - I4) * (H(t) + E)).col_join((H(-t) * E - I4) * (H(-t) + E)),
    "A3.d": coefficients_d,
    "34.H": phase_35,
    "70": modal_70,
}


def on_circles(entries):
    """The entries with a pair (c, s) of symbols for each phase, and the pairs."""
    # Half of what is met, so that double and half angles are multiples of the generators' phases.
    phases = {omega1 * t, omega1 * s, omega2 * t, omega2 * s, t, s, omega1 * tau / 2, omega2 * tau / 2, omega1 * tau1 / 2,
              omega2 * tau1 / 2, omega * tau, omega * tau1, phi, omega1 * pi / (2 * omega), omega2 * pi / (2 * omega),
              Symbol("T")}
    pairs = []
    substitution = {}
    for k, phase in enumerate(sorted(phases, key=str)):
        c, z = Symbol(f"c{k}"), Symbol(f"s{k}")
        pairs.append((c, z))
        substitution.update({cos(phase): c, sin(phase): z, cos(2 * phase): 2 * c**2 - 1, sin(2 * phase): 2 * c * z})
    result = []
    for entry in entries:
        entry = entry.replace(lambda x: x.func in (sin, cos), lambda x: x.func(expand(x.args[0])))
        entry = entry.xreplace({tan(p): sin(p) / cos(p) for p in phases}).xreplace(substitution)
        # Sums of times: the addition theorems, on sums only.
        entry = entry.replace(lambda x: x.func in (sin, cos) and x.args[0].is_Add, added(substitution))
        result.append(entry)
    return result, pairs


def added(substitution):
    def by_addition(x):
        first, rest = x.args[0].as_two_terms()
        def value(f, a):
            return f(a).xreplace(substitution) if not a.is_Add else by_addition(f(a))
        c1, s1, c2, s2 = value(cos, first), value(sin, first), value(cos, rest), value(sin, rest)
        return s1 * c2 + c1 * s2 if x.func == sin else c1 * c2 - s1 * s2
    return by_addition


def vanishes_on_circles(entry, pairs):
    numerator = expand(fraction(together(entry))[0])
    used = [(c, z) for c, z in pairs if numerator.has(z)]
    for c, z in used:
        if not numerator.is_zero:
            numerator = Poly(numerator, z).rem(Poly(z**2 + c**2 - 1, z)).as_expr()
    return expand(numerator) == 0


def prove(residual, route):
    entries = [x for x in residual if x != 0]
    if route == "simplify":
        return all(simplify(x) == 0 for x in entries)
    entries, pairs = on_circles(entries)
    return all(vanishes_on_circles(x, pairs) for x in entries)


def main():
    name, route = sys.argv[1:]
    begin = time.process_time()
    proved = prove(IDENTITIES[name](), route)
    print(json.dumps({"seconds": time.process_time() - begin, "proved": proved}))


if __name__ == "__main__":
    main()
