"""How the work of `stickslip atlas` grows with resolution, area, dimension and processes, by the program itself."""
import json
import os
import shutil
import tempfile
from fractions import Fraction
from pathlib import Path

S = ["symmetric", "--example", "S"]
O = ["overshooting", "--example", "O"]
P = ["nonsticking", "--example", "P"]
AREA_S = ["--omega", "0.5..0.8", "--p", "0..0.2"]
AREA_O = ["--omega", "0.61..0.65", "--p", "0.03..0.07"]
AREA_P = ["--omega", "0.5..0.8", "--p", "0.5..1.5"]
# By what grows: arguments, resolution, processes (0: no mpirun).
FAMILIES = {"symmetric": S + AREA_S, "overshooting": O + AREA_O, "nonsticking": P + AREA_P}
FINEST = {"symmetric": 12, "overshooting": 9, "nonsticking": 12}
# What is to be decided, in how many minutes on two cores, and boxes judged in a second.
GOALS = {"symmetric": (0.995, 5, 1e5), "overshooting": (0.99, 30, 1e4), "nonsticking": (0.995, 5, None)}
DIMENSIONS = [["--omega", "0.55..0.57"], ["--p", "0.05..0.1"], ["--eta", "3.8..3.81"], ["--V", "1..1.01"]]


def cases(quick):
    for family, arguments in FAMILIES.items():
        finest = FINEST[family] - (4 if quick else 0)
        for resolution in range(finest - 2, finest + 1):
            yield "resolution", family, arguments, resolution, 0
    for share, last in (("1/4", "0.575"), ("1/2", "0.65"), ("1", "0.8")):
        yield "area", share, S + ["--omega", f"0.5..{last}", "--p", "0..0.2"], 5 if quick else 8, 0
    for k in range(1, len(DIMENSIONS) + 1):
        yield "dimension", str(k), S + sum(DIMENSIONS[:k], []), 2 if quick else 4, 0
    if shutil.which("mpirun"):
        for processes in (1, 2):
            yield "processes", str(processes), P + AREA_P, 6 if quick else 12, processes


def measured(program, quick, say):
    """A row for each case: the program's counts, and the time of all its processes, one thread each under mpirun, else
    as many as there are cores. program(arguments, before, cores): standard output, processor time, time by the clock."""
    rows = []
    for grows, name, arguments, resolution, processes in cases(quick):
        with tempfile.TemporaryDirectory() as directory:
            out = Path(directory) / "atlas.h5"
            words = ["atlas", *arguments, "--resolution", str(resolution), "--out", str(out), "--json"]
            before = ["mpirun", "--oversubscribe", "-n", str(processes)] if processes else []
            text, seconds, wall = program([*words, "--jobs", "1"] if processes else words, before, 0)
            found = json.loads(text)
        decided = Fraction(found["volume"]["decided"])
        rows.append({"grows": grows, "name": name, "resolution": resolution, "boxes": found["boxes"],
                     "decided": float(decided), "seconds": seconds, "wall": wall})
        say(f"  {grows} {name}: {rows[-1]}")
    return rows


def finest(rows):
    """Of each family the row of the finest resolution."""
    return [max((x for x in rows if x["name"] == family), key=lambda x: x["resolution"]) for family in FAMILIES]


def environment():
    """For mpirun as root, as in a container."""
    return dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
