"""How many lists of overshooting orbits at a given friction are complete, at data drawn at random; how many lists of
words of four phases have the attractor that simulation finds."""
import csv
import json
import math
import random
from pathlib import Path

RANGES = {"chi": (0.02, 0.98), "eta": (0.05, 50), "us": (0.001, 1), "V": (0, 3), "omega": (0.05, 5), "p": (0, 5)}
LOGARITHMIC = ("eta", "us")
SECONDS = 5  # of processor time, that a list may take to count as found in time
PATIENCE = 6  # seconds by the clock, on one core, after which a list of four phases is interrupted
# The first 40 of some 4,100 machines drawn as below, random.Random(1), of which 20 starts end on a word of four phases.
MACHINES = Path(__file__).parent / "four_phases.csv"


def natural_frequencies(chi, eta):
    a = 1 + chi * eta
    root = math.sqrt(a * a - 4 * chi * eta * (1 - chi))
    return math.sqrt((a - root) / 2), math.sqrt((a + root) / 2)


def drawn(rng, beside_resonance):
    data = {}
    for name, (low, high) in RANGES.items():
        data[name] = (math.exp(rng.uniform(math.log(low), math.log(high))) if name in LOGARITHMIC
                      else rng.uniform(low, high))
    if beside_resonance:
        # k omega = omega_j, or omega = 1, but for a part of 1e-4 to 1e-1.
        first, second = natural_frequencies(data["chi"], data["eta"])
        near = rng.choice([first / rng.randint(1, 4), second / rng.randint(1, 4), 1])
        low, high = RANGES["omega"]
        data["omega"] = min(max(near * (1 + rng.choice([-1, 1]) * 10 ** rng.uniform(-4, -1)), low), high)
    data["ur"] = data["us"] * rng.uniform(1.01, 10)
    return {name: f"{value:.6g}" for name, value in data.items()}


def complete_lists(run, count):
    """{"away", "beside"}: how many of `count` lists are complete, and how many of these in time. run(arguments): the
    program's output and the seconds of processor time that it took."""
    rng = random.Random(1)
    results = {}
    for place in ("away", "beside"):
        complete = in_time = 0
        longest = 0.0
        for _ in range(count):
            data = drawn(rng, place == "beside")
            out, seconds = run(["orbits", "overshooting", *(f"--{k}={v}" for k, v in data.items()), "--json"])
            found = json.loads(out)["complete"]
            complete += found
            in_time += found and seconds <= SECONDS
            longest = max(longest, seconds)
        results[place] = {"count": count, "complete": complete, "in_time": in_time, "longest": longest}
    return results


def four_phases(interrupted, count):
    """{"count", "found", "complete"}: of so many machines, how many lists have a stable orbit, and how many are complete
    in time. interrupted(arguments, seconds): what the program prints when it is interrupted after so long."""
    machines = list(csv.DictReader(MACHINES.open()))[:count]
    found = complete = 0
    for machine in machines:
        word, period = machine.pop("word"), machine.pop("period")
        machine.pop("share")
        listed = json.loads(interrupted(["orbits", word, "--period", period, "--jobs", "1", "--json",
                                         *(f"--{k}={v}" for k, v in machine.items())], PATIENCE))
        found += any(o["admissible"] and o["stability"] == "stable" for o in listed["orbits"])
        complete += listed["complete"]
    return {"count": len(machines), "found": found, "complete": complete}
