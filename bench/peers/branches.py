#!/usr/bin/python3
"""The branches over omega that some orbits are on, in doubles: branches.py WAY FAMILY FROM TO ORBITS.json

FAMILY is symmetric or overshooting, ORBITS.json what `stickslip orbits FAMILY --json` says: the starts.
WAY scipy: pseudo-arclength continuation with fsolve; after each step the conditions of the friction law on a grid of each
phase, and where one changes its sign, or omega its direction, brentq. WAY auto: AUTO-07p on orbit_O.c, the orbit as a
boundary value problem over its phases; of the conditions those at the ends of phases.
Prints one line of JSON: CPU seconds, steps, and what was found where.
"""
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from scipy.linalg import expm, null_space
from scipy.optimize import brentq, fsolve

GRID = 200            # parts of a phase
LARGEST_STEP = 0.02   # of the size of the motion
SMALLEST_STEP = 1e-7
LARGEST = 1e3         # a motion that has grown to this is followed no further
PHASES = {"symmetric": ["slip", "stick"], "overshooting": ["slip", "overshoot", "stick"]}
# What is said of a stick as long as it lasts, in this family.
STICK = {"symmetric": ("f1", "f2"), "overshooting": ("11.upper", "11.lower")}
AUTO = Path("/usr/lib/auto-07p")


class Orbits:
    """The motions of one family that close, as zeros of a function of x1, x2, x1' where the slip begins, the durations
    of the phases but the stick, and omega."""

    def __init__(self, family, data, orbit):
        self.phases, self.stick = PHASES[family], STICK[family]
        a = {name: float(value) for name, value in data.items()}
        self.chi, self.eta, self.us, self.V, self.p = (a[k] for k in ("chi", "eta", "us", "V", "p"))
        value = lambda k: float(orbit[k]["mid"])
        durations = ["tau", "tau1"][:len(self.phases) - 1]
        self.start = np.array([*map(value, ("x10", "x20", "xdot10", *durations)), a["omega"]])
        self.given_phi = a.get("phi")
        if self.given_phi is None:  # (pi - omega tau)/2, or that plus pi
            self.turn = value("phi") - (math.pi - a["omega"] * value("tau")) / 2

    def durations(self, y):
        return [*y[3:-1], 2 * math.pi / y[-1] - sum(y[3:-1])]

    def first(self, y):
        phi = self.turn + (math.pi - y[-1] * y[3]) / 2 if self.given_phi is None else self.given_phi
        return np.array([*y[:3], self.V, 1, math.cos(phi), math.sin(phi)])

    def rate(self, phase, omega):
        """(2), (4) in x1, x2, x1', x2', 1, cos and sin of the load's phase."""
        M = np.zeros((7, 7))
        M[0, 2] = M[1, 3] = 1
        M[2, :2] = -1, self.chi
        if phase != "stick":
            M[3] = self.eta * self.chi, -self.eta * self.chi, 0, 0, 0, self.p, 0
            M[3, 4] = self.eta * (self.us if phase == "slip" else -self.us)
        M[5, 6], M[6, 5] = -omega, omega
        return M

    def residual(self, y):
        w, gaps = self.first(y), []
        for phase, duration in zip(self.phases, self.durations(y)):
            w = expm(self.rate(phase, y[-1]) * duration) @ w
            if phase != "stick":
                gaps.append(w[3] - self.V)
        return np.array([*gaps, *(w[:3] - y[:3])])

    def motion(self, y, parts=GRID):
        """The states of each phase, in rows."""
        w, runs = self.first(y), []
        for phase, duration in zip(self.phases, self.durations(y)):
            step, states = expm(self.rate(phase, y[-1]) * duration / parts), [w]
            for _ in range(parts):
                states.append(step @ states[-1])
            w = states[-1]
            runs.append(np.array(states))
        return runs

    def conditions(self, y):
        """By name what has to be positive, the smallest value on the grid; what is zero at an end of its phase is
        divided by min(1, time to that end)."""
        at_rest = lambda w: self.chi * (w[..., 1] - w[..., 0]) - self.p * w[..., 5] / self.eta
        runs, durations = self.motion(y), self.durations(y)
        ur = at_rest(runs[0][0])
        found = {"ur": ur - self.us, **dict(zip(("tau", "T") if len(runs) == 2 else ("tau", "tau1", "T"), durations))}
        for phase, states, duration in zip(self.phases, runs, durations):
            t = np.linspace(0, duration, len(states))[1:-1]
            before, after = np.minimum(1, np.abs(t)), np.minimum(1, np.abs(duration - t))
            inside = states[1:-1]
            if phase == "stick":
                found[self.stick[0]] = np.min((ur - at_rest(inside)) / after)
                found[self.stick[1]] = np.min(ur + at_rest(states))
            else:
                sign = 1 if phase == "slip" else -1
                found[phase] = np.min(sign * (self.V - inside[:, 3]) / np.minimum(before, after))
            if phase == "overshoot":
                found["18"] = -at_rest(states[0]) - ur
        if len(runs) == 3:
            found["19.upper"], found["19.lower"] = ur - at_rest(runs[2][0]), ur + at_rest(runs[2][0])
        return found


def tangent(f, y, before):
    J = np.empty((len(y) - 1, len(y)))
    for k in range(len(y)):
        h = 1e-6 * max(1, abs(y[k]))
        e = np.eye(len(y))[k] * h
        J[:, k] = (f(y + e) - f(y - e)) / (2 * h)
    t = null_space(J)[:, 0]
    return t if t @ before >= 0 else -t


def corrected(f, y, t, h):
    """The point at y + h t, up to what is orthogonal to t; or nothing."""
    guess = y + h * t
    found, _, status, _ = fsolve(lambda x: np.append(f(x), t @ (x - guess)), guess, full_output=True, xtol=1e-13)
    return found if status == 1 or np.max(np.abs(f(found))) < 1e-9 else None


def changes(orbits, y, t, h, told, now):
    """What has another sign at the end of a step than at its beginning, and where; of conditions, if no other is violated
    there. Nothing if brentq or a correction fails."""
    found = []
    for name in now:
        if (now[name] > 0) == (told[name] > 0):
            continue

        def value(s):
            x = corrected(orbits.residual, y, t, s)
            return tangent(orbits.residual, x, t)[-1] if name == "fold" else orbits.conditions(x)[name]
        try:
            there = corrected(orbits.residual, y, t, brentq(value, 0, h, xtol=1e-13))
            if name == "fold" or all(v > 0 for k, v in orbits.conditions(there).items() if k != name):
                found.append({"what": name, "at": there[-1]})
        except (TypeError, ValueError, AttributeError):
            return None
    return found


def follow(orbits, first, last, direction):
    """Steps, what was found, and why no more was, from the start on, omega rising or falling at first."""
    y = orbits.start
    t = tangent(orbits.residual, y, np.eye(len(y))[-1] * direction)
    h, found, steps = 1e-3, [], 0
    told = {**orbits.conditions(y), "fold": t[-1]}
    while h > SMALLEST_STEP:
        ahead = corrected(orbits.residual, y, t, h)
        turned = None if ahead is None else tangent(orbits.residual, ahead, t)
        if turned is None or turned @ t < 0.98 or np.max(np.abs(ahead - y)) > 2 * h or min(orbits.durations(ahead)) <= 0:
            h /= 2
            continue
        now = {**orbits.conditions(ahead), "fold": turned[-1]}
        passed = changes(orbits, y, t, h, told, now)
        if passed is None:
            h /= 2
            continue
        steps += 1
        found += passed
        size = np.max(np.abs(ahead[:3]))
        if not first <= ahead[-1] <= last:
            return steps, [x for x in found if first <= x["at"] <= last], "the end of the interval"
        if size > LARGEST:
            return steps, found, f"too large at omega = {ahead[-1]:.9g}"
        y, t, told, h = ahead, turned, now, min(1.3 * h, LARGEST_STEP * size)
    return steps, found, f"no step from omega = {y[-1]:.9g}; the shortest phase lasts {min(orbits.durations(y)):.1g}"


def by_scipy(starts, first, last):
    begin = time.process_time()
    ways = [follow(orbits, first, last, direction) for orbits in starts for direction in directions(orbits, first, last)]
    return time.process_time() - begin, ways


def directions(orbits, first, last):
    return [d for d, end in ((-1, first), (1, last)) if orbits.start[-1] != end]


# AUTO's parameters after omega, tau, tau1: what has to be positive.
AT_ENDS = ["ur", "18", "19.upper", "19.lower"]


def constants(orbits, first, last, direction):
    """AUTO's file of constants: folds, and zeros of all parameters but omega, are looked for. Without more weight on
    omega (THL) it passes the fold where the motion is large."""
    y, conditions = orbits.start, orbits.conditions(orbits.start)
    values = [y[-1], *y[3:-1], *(conditions[name] for name in AT_ENDS)]
    numbers = range(1, len(values) + 1)
    return f"""dat = 'O'
ICP = {list(numbers)}, PAR = {{{", ".join(f"{k}: {v:.17g}" for k, v in zip(numbers, values))}}}
UZR = {{{", ".join(f"{k}: 0" for k in numbers[1:])}}}
NDIM = 12, NBC = 18, NINT = 0, IPS = 4, IRS = 0, ILP = 1, ISP = 0, ISW = 1, JAC = 0
NTST = 30, NCOL = 4, IAD = 3, NMX = 3000, NPR = 0, MXBF = 0, IID = 0, ITMX = 9, ITNW = 7, NWTN = 3
EPSL = 1e-10, EPSU = 1e-10, EPSS = 1e-8, THL = {{1: 1e6}}
DS = {direction * 1e-3}, DSMIN = 1e-8, DSMAX = {LARGEST_STEP * LARGEST:g}, IADS = 1
RL0 = {first}, RL1 = {last}, A1 = {3 * LARGEST:g}
"""


def told_by_auto(table):
    """Steps, what was found, and why no more was, from the rows of fort.7: branch, point, type, label, omega, norm,
    the other parameters."""
    steps, found, end = 0, [], ""
    for line in table.splitlines():
        branch, *row = line.split()
        if branch == "0":
            continue
        point, kind, _, omega, *others = row
        steps, zeros = abs(int(point)), dict(zip(["tau", "tau1", *AT_ENDS], map(float, others[1:])))
        if kind == "5":
            found.append({"what": "fold", "at": float(omega)})
        elif kind == "-4":
            name = min(zeros, key=lambda k: abs(zeros[k]))
            if all(v > 0 for k, v in zeros.items() if k != name):
                found.append({"what": name, "at": float(omega)})
        elif kind in ("9", "-9"):
            end = ("no step from" if kind == "-9" else "the end of the interval, or too large at") + f" omega = {omega}"
    return steps, found, end


def by_auto(starts, first, last):
    seconds, ways = 0, []
    with tempfile.TemporaryDirectory() as directory:
        def run(*command, **more):
            subprocess.run(command, cwd=directory, stdout=subprocess.DEVNULL, text=True, check=True,
                           env=dict(os.environ, OMP_NUM_THREADS="1"), **more)
        source = Path(__file__).resolve().with_name("orbit_O.c")
        run("gcc", "-O2", f"-I{AUTO.parents[1] / 'include'}", "-c", source, "-o", "O.o")
        run("gfortran", "-fopenmp", "O.o", *sorted((AUTO / "lib").glob("*.o")), f"-L{AUTO / 'lib'}", "-lauto_c", "-o", "O")
        for orbits in starts:
            times, runs = np.linspace(0, 1, 41), orbits.motion(orbits.start, 40)
            rows = np.column_stack([times, runs[0][:, :4], runs[1][:, :4], runs[2][:, :3], times])
            np.savetxt(Path(directory, "O.dat"), rows, fmt="%.17g")
            for direction in directions(orbits, first, last):
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                run("./O", input=constants(orbits, first, last, direction))
                seconds += resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                ways.append(told_by_auto(Path(directory, "fort.7").read_text()))
    return seconds, ways


def main():
    way, family, first, last, file = sys.argv[1:]
    given = json.loads(Path(file).read_text())
    starts = [Orbits(family, given["parameters"], orbit) for orbit in given["orbits"]]
    seconds, ways = {"scipy": by_scipy, "auto": by_auto}[way](starts, float(first), float(last))
    print(json.dumps({"seconds": seconds, "steps": sum(w[0] for w in ways), "found": sum((w[1] for w in ways), []),
                      "ends": [w[2] for w in ways]}))


if __name__ == "__main__":
    main()
