"""The largest boxes of parameters over which the paper's orbits are proved, with every condition; and their stability."""
import functools
import json

FAMILIES = {"S": "symmetric", "O": "overshooting", "P": "nonsticking"}
PARAMETERS = ["chi", "eta", "us", "V", "omega", "p"]
# Half widths are 10^(k/2) of the value; k that are to be reached.
GOALS = {"S": {"chi": -6, "eta": -5, "omega": -6, "p": -2, "all": -7},
         "O": {**dict.fromkeys(PARAMETERS, -6), "all": -8},
         "P": {"chi": -4, "eta": -4, "omega": -4, "all": -5}}
SMALLEST, LARGEST = -12, -1


def box(data, names, k):
    """The data as arguments; those named are intervals."""
    return [f"--{name}={value}+-{abs(value) * 10 ** (k / 2):.6g}" if name in names else f"--{name}={value}"
            for name, value in data.items()]


def proved(text, start):
    """Of the orbit that begins there, for all members: whether it obeys every condition, and its stability is known."""
    for orbit in json.loads(text)["orbits"]:
        if all(abs(float(orbit[k]["mid"]) - x) <= float(orbit[k]["rad"]) + 1e-6 for k, x in start.items()):
            admissible = orbit["admissible"] is True
            return {"conditions": admissible, "stability": admissible and orbit["stability"] in ("stable", "unstable")}
    return {"conditions": False, "stability": False}


def largest(holds):
    """The largest k that holds, if -8 does and all between, or below; or none."""
    k = -8
    if holds(k):
        while k < LARGEST and holds(k + 1):
            k += 1
        return k
    return next((k for k in range(-9, SMALLEST - 1, -1) if holds(k)), None)


def measured(run, orbits):
    """By example, then parameter ("all" for all of them at once), the k reached with "conditions" and "stability".
    orbits: of the paper, as the program says. The friction at rest is a result."""
    results = {}
    for example, family in FAMILIES.items():
        orbit = orbits[example]
        start = {k: float(orbit[k]["mid"]) for k in ("tau", "x10", "x20", "xdot10")}
        data = {k: v for k, v in orbit["parameters"].items() if k != "ur"}
        vary = [name for name in PARAMETERS if data[name]]
        results[example] = {}
        for name, names in [*((n, [n]) for n in vary), ("all", vary)]:
            @functools.cache
            def over(k):
                return proved(run(["orbits", family, *box(data, names, k), "--json"])[0], start)
            results[example][name] = {what: largest(lambda k: over(k)[what]) for what in ("conditions", "stability")}
    return results
