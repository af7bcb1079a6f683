"""How many lists of overshooting orbits at a given friction are complete, at data drawn at random."""
import json
import math
import random

RANGES = {"chi": (0.02, 0.98), "eta": (0.05, 50), "us": (0.001, 1), "V": (0, 3), "omega": (0.05, 5), "p": (0, 5)}
LOGARITHMIC = ("eta", "us")
SECONDS = 5  # of processor time, that a list may take to count as found in time


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
