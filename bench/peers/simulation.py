#!/usr/bin/python3
"""Follows an orbit under the raw law (2), (4) with SciPy: simulation.py chi eta us V omega p ur phi x1 x2 v1

The motion begins with a slip: x2' = V at t = 0. solve_ivp with DOP853, 1e-10, one call per phase, each ended by its
event. Prints one line of JSON: CPU seconds and events per period of the load, and how far the end is from the start.
"""
import json
import sys
import time
from math import cos, pi

from scipy.integrate import solve_ivp

TOLERANCE = 1e-10


class Law:
    def __init__(self, chi, eta, us, V, omega, p, ur, phi):
        self.chi, self.eta, self.us, self.V = chi, eta, us, V
        self.omega, self.p, self.ur, self.phi = omega, p, ur, phi

    def load(self, t):
        return self.p * cos(self.omega * t + self.phi)

    def at_rest(self, t, x):
        """r of (4)."""
        return self.chi * (x[1] - x[0]) - self.load(t) / self.eta

    def slipping(self, friction):
        def rate(t, x):
            return (x[2], x[3], self.chi * x[1] - x[0], self.eta * (friction - self.at_rest(t, x)))
        return rate

    def sticking(self, t, x):
        return (x[2], x[3], self.chi * x[1] - x[0], 0.0)

    def phase(self, kind):
        """Its equations, and the events that end it; they cross zero upwards."""
        def meets_belt(sign):
            def event(t, x):
                return sign * (x[3] - self.V)
            return event

        def gives_way(t, x):
            return abs(self.at_rest(t, x)) - self.ur
        rate, event = {"slip": (self.slipping(self.us), meets_belt(1)),
                       "overshoot": (self.slipping(-self.us), meets_belt(-1)),
                       "stick": (self.sticking, gives_way)}[kind]
        event.terminal, event.direction = True, 1
        return rate, event

    def after(self, kind, t, x):
        r = self.at_rest(t, x)
        if kind != "stick" and abs(r) < self.ur:
            return "stick"
        return "slip" if r > 0 else "overshoot"


def follow(law, x, duration):
    t, kind, events = 0.0, "slip", 0
    while True:
        rate, event = law.phase(kind)
        run = solve_ivp(rate, (t, duration), x, method="DOP853", rtol=TOLERANCE, atol=TOLERANCE, events=event)
        t, x = run.t[-1], run.y[:, -1]
        if run.status != 1:
            return x, events
        events += 1
        x[3] = law.V
        kind = law.after(kind, t, x)


def main():
    numbers = [float(a) for a in sys.argv[1:]]
    law = Law(*numbers[:8])
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
