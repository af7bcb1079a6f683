#!/usr/bin/python3
"""Follows an orbit under the raw law with SciPy, one period of the load:

simulation.py chi eta us V omega p ur phi x1 x2 v1    of (2), (4); it begins with a slip: x2' = V at t = 0
simulation.py JSON                                    {"machine": …, "state": (x, x')} as `stickslip attractors --json` has them

solve_ivp with DOP853, 1e-10, one call per phase, each ended by its
event. Prints one line of JSON: CPU seconds and events per period of the load, and how far the end is from the start.
"""
import json
import sys
import time
from math import cos, pi, sin

import numpy as np
from scipy.integrate import solve_ivp

TOLERANCE = 1e-10


class Law:
    """Phases of a mass that rubs, speed the place of its velocity in the state."""

    def phase(self, kind):
        """Its equations, and the events that end it; they cross zero upwards."""
        def meets_belt(sign):
            def event(t, x):
                return sign * (x[self.speed] - self.V)
            return event

        def gives_way(t, x):
            r = self.at_rest(t, x)
            return max(r - self.forward, -r - self.backward)
        event = {"slip": meets_belt(1), "overshoot": meets_belt(-1), "stick": gives_way}[kind]
        event.terminal, event.direction = True, 1
        return self.rates(kind), event

    def after(self, kind, t, x):
        r = self.at_rest(t, x)
        if kind != "stick" and -self.backward < r < self.forward:
            return "stick"
        return "slip" if r > 0 else "overshoot"

    def first(self, x):
        lag = self.V - x[self.speed]
        return self.after("slip", 0, x) if lag == 0 else "slip" if lag > 0 else "overshoot"


class Paper(Law):
    def __init__(self, chi, eta, us, V, omega, p, ur, phi):
        self.chi, self.eta, self.us, self.V = chi, eta, us, V
        self.omega, self.p, self.phi = omega, p, phi
        self.forward = self.backward = ur
        self.speed = 3

    def load(self, t):
        return self.p * cos(self.omega * t + self.phi)

    def at_rest(self, t, x):
        """r of (4)."""
        return self.chi * (x[1] - x[0]) - self.load(t) / self.eta

    def rates(self, kind):
        def slipping(friction):
            def rate(t, x):
                return (x[2], x[3], self.chi * x[1] - x[0], self.eta * (friction - self.at_rest(t, x)))
            return rate

        def sticking(t, x):
            return (x[2], x[3], self.chi * x[1] - x[0], 0.0)
        return {"slip": slipping(self.us), "overshoot": slipping(-self.us), "stick": sticking}[kind]

    def first(self, x):
        return "slip"


class Machine(Law):
    def __init__(self, tables):
        def numbers(rows):
            return np.array([[float(x) for x in row] for row in rows])
        self.n, self.j = len(tables["masses"]), tables["belt"]["mass"] - 1
        self.masses = numbers([tables["masses"]])[0]
        self.force_of = -np.hstack([numbers(tables["stiffness"]), numbers(tables["damping"])])
        self.V, self.omega = float(tables["belt"]["velocity"]), float(tables["angular_frequency"])
        self.sides = {"slip": tables["friction"], "overshoot": tables["friction_overshoot"]}
        self.forward, self.backward = (float(side["at_rest"]) for side in self.sides.values())
        self.loads = [(x["mass"] - 1, x["multiple"] * self.omega, float(x["cosine"]), float(x["sine"])) for x in tables["loads"]]
        self.speed = self.n + self.j

    def forces(self, t, x):
        """Without friction."""
        found = self.force_of @ x
        for mass, angle, cosine, sine in self.loads:
            found[mass] += cosine * cos(angle * t) + sine * sin(angle * t)
        return found

    def at_rest(self, t, x):
        return -self.forces(t, x)[self.j]

    def rates(self, kind):
        side = {"slip": 1, "overshoot": -1, "stick": 0}[kind]
        pieces = [[float(piece[k]) for k in ("from", "force", "slope")] for piece in self.sides[kind]["sliding"]] if side else []

        def rate(t, x):
            f = self.forces(t, x)
            if side:
                v = side * (self.V - x[self.speed])
                begin, force, slope = next((p for p in reversed(pieces) if v > p[0]), pieces[0])
                f[self.j] += side * (force + slope * (v - begin))
            else:
                f[self.j] = 0
            return np.concatenate([x[self.n:], f / self.masses])
        return rate


def follow(law, x, duration):
    t, kind, events = 0.0, law.first(x), 0
    while True:
        rate, event = law.phase(kind)
        run = solve_ivp(rate, (t, duration), x, method="DOP853", rtol=TOLERANCE, atol=TOLERANCE, events=event)
        t, x = run.t[-1], run.y[:, -1]
        if run.status != 1:
            return x, events
        events += 1
        x[law.speed] = law.V
        kind = law.after(kind, t, x)


def main():
    if len(sys.argv) == 2:
        given = json.loads(sys.argv[1])
        law, start = Machine(given["machine"]), given["state"]
    else:
        numbers = [float(a) for a in sys.argv[1:]]
        law = Paper(*numbers[:8])
        start = [*numbers[8:], law.V]
    # One period later the slip begins anew; the end of that stick is not waited for.
    period = 2 * pi / law.omega * (1 - 1e-9)
    runs = 0
    begin = time.process_time()
    while runs < 3 or time.process_time() - begin < 0.5:
        end, events = follow(law, start, period)
        runs += 1
    seconds = (time.process_time() - begin) / runs
    print(json.dumps({"seconds": seconds, "events": events, "closure": max(abs(a - b) for a, b in zip(end, start))}))


if __name__ == "__main__":
    main()
