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
DIMENSIONS = [["--omega", "0.55..0.57"], ["--p", "0.05..0.1"], ["--eta", "3.8..3.81"], ["--V", "1..1.01"]]


def cases(quick):
    for family, arguments in FAMILIES.items():
        finest = FINEST[family] - (5 if quick else 0)
        for resolution in range(finest - 2, finest + 1):
            yield "resolution", family, arguments, resolution, 0
    for share, last in (("1/4", "0.575"), ("1/2", "0.65"), ("1", "0.8")):
        yield "area", share, S + ["--omega", f"0.5..{last}", "--p", "0..0.2"], 5 if quick else 8, 0
    for k in range(1, len(DIMENSIONS) + 1):
        yield "dimension", str(k), S + sum(DIMENSIONS[:k], []), 2 if quick else 4, 0
    if shutil.which("mpirun"):
        for processes in (1, 2):
            yield "processes", str(processes), P + AREA_P, 6 if quick else 10, processes


def measured(timed, quick):
    """A row for each case: the program's counts and the processor time of all its processes. timed(command): standard
    output and those seconds."""
    rows = []
    for grows, name, arguments, resolution, processes in cases(quick):
        with tempfile.TemporaryDirectory() as directory:
            out = Path(directory) / "atlas.h5"
            words = ["atlas", *arguments, "--resolution", str(resolution), "--out", str(out), "--json", "--jobs", "1"]
            before = ["mpirun", "--oversubscribe", "-n", str(processes)] if processes else []
            text, seconds = timed(before, words)
            found = json.loads(text)
        decided = Fraction(found["volume"]["decided"])
        rows.append({"grows": grows, "name": name, "resolution": resolution, "boxes": found["boxes"],
                     "decided": float(decided), "seconds": seconds})
    return rows


def environment():
    """For mpirun as root, as in a container."""
    return dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
