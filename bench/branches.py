"""Branches over omega by `stickslip branch`, proved, beside continuation in doubles by SciPy and AUTO-07p."""
import json
import shutil
import tempfile
from pathlib import Path

# Family, example, interval, and the value whose orbits are followed by all.
CASES = [("symmetric", "S", "0.5", "0.6", "0.6"), ("overshooting", "O", "0.61", "0.65", "0.6289")]


def peers_of(family, installed):
    if installed("scipy"):
        yield "scipy"
        # orbit_O.c is one family's.
        if family == "overshooting" and Path("/usr/lib/auto-07p").exists() and shutil.which("gfortran"):
            yield "auto"


def name_of(change):
    return change.get("condition") or change.get("duration") or change.get("multiplier") or change["kind"]


def measured(run, peer, installed):
    """A record for each case. run(arguments): the program's output and the seconds of processor time that it took;
    peer(script, arguments): what it prints."""
    results = []
    for family, example, first, last, at in CASES:
        words = ["branch", family, "--example", example, "--omega", f"{first}..{last}", "--json"]
        followed, seconds_followed = run([*words, "--at", at])
        listed, seconds_listed = run(words)
        listed = json.loads(listed)
        open_parts = [(float(u["value"]["mid"]), float(u["value"]["rad"])) for u in listed["unresolved"]]
        row = {"family": family, "example": example, "interval": [first, last], "at": at,
               "followed": {"seconds": seconds_followed, "branches": len(json.loads(followed)["branches"])},
               "listed": {"seconds": seconds_listed, "branches": len(listed["branches"]), "complete": listed["complete"],
                          "open": length([(m - r, m + r) for m, r in open_parts])},
               "changes": [{"what": name_of(c), "kind": c["kind"], "at": c["at"], "verdict": c["verdict"]}
                           for b in listed["branches"] for c in b["changes"]], "peers": {}}
        with tempfile.TemporaryDirectory() as directory:
            orbits = Path(directory) / "orbits.json"
            orbits.write_text(run(["orbits", family, "--example", example, "--json"])[0])
            for way in peers_of(family, installed):
                row["peers"][way] = peer("branches.py", way, family, first, last, orbits)
        results.append(row)
    return results


def length(intervals):
    total, reached = 0, float("-inf")
    for low, high in sorted(intervals):
        total += max(0, high - max(low, reached))
        reached = max(reached, high)
    return total


def beside(row):
    """For each place where something changes: what, stickslip's change or nothing, the peers' values by way. Of the same
    name the first is beside the first, and so on, if there are as many, else the nearest."""
    def pairs(own, found):
        if len(own) == len(found):
            return list(zip(own, found))
        near = sorted(((o, f) for o in own for f in found), key=lambda x: abs(x[0] - x[1]))
        chosen = []
        for o, f in near:
            if all(o != x and f != y for x, y in chosen):
                chosen.append((o, f))
        return chosen

    places = [(c["what"], c, {}) for c in sorted(row["changes"], key=lambda c: float(c["at"]["mid"]))]
    for way, told in row["peers"].items():
        for what in sorted({x["what"] for x in told["found"]}):
            own = [(float(c["at"]["mid"]), theirs) for name, c, theirs in places if name == what and c]
            found = sorted(x["at"] for x in told["found"] if x["what"] == what)
            matched = dict(pairs([at for at, _ in own], found))
            for at, theirs in own:
                if at in matched:
                    theirs[way] = matched[at]
            places += [(what, None, {way: x}) for x in found if x not in matched.values()]
    return places
