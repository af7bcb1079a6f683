#!/usr/bin/python3
"""Measures stickslip and its peers on the same work in one run; started by script/bench.

measure.py [--quick] [--out DIR]

Writes DIR/results.json and DIR/RESULTS.md (bench/ by default; --quick measures less, and writes to build/bench/).
All times are CPU times of one core unless they are called wall. A peer that is not installed is left out.
"""
import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import time
from decimal import Decimal, getcontext
from pathlib import Path

import atlases
import boxes
import branches
import table
from completeness import complete_lists, four_phases

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/release"
PEERS = ROOT / "bench/peers"
CORE = max(os.sched_getaffinity(0))
IDENTITIES = ["40", "38.reversal", "38.group", "42", "41.reversal", "41.group", "59", "A3.d", "34.H", "70"]
ROUTES = ["circle", "simplify"]
PRINTED_TAU = {"S": 7.749, "O": 4.909, "P": 5.236}


def on_one_core(command, cpu_limit=None):
    """Standard output, or nothing when the limit ended it."""
    def limits():
        os.sched_setaffinity(0, {CORE})
        if cpu_limit:
            resource.setrlimit(resource.RLIMIT_CPU, (cpu_limit, cpu_limit + 1))
    run = subprocess.run(command, stdout=subprocess.PIPE, text=True, preexec_fn=limits, check=False)
    if run.returncode < 0 and cpu_limit:
        return None
    if run.returncode != 0:
        sys.exit(f"measure.py: {' '.join(map(str, command))} failed with exit code {run.returncode}.")
    return run.stdout


def google_benchmark(pattern, min_time):
    out = on_one_core([BUILD / "bench/stickslip_bench", f"--benchmark_filter={pattern}", "--benchmark_format=json",
                       f"--benchmark_min_time={min_time}"])
    results = {}
    for b in json.loads(out)["benchmarks"]:
        if b.get("error_occurred"):
            sys.exit(f"measure.py: {b['name']}: {b['error_message']}.")
        unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[b["time_unit"]]
        name = b["name"].removesuffix("/iterations:1/process_time")
        known = ("cells", "per_period", "events", "closure", "items_per_second", "orbits", "parts", "growth", "proved",
                 "half_width_of_x2")
        results[name] = {"seconds": b["cpu_time"] * unit, **{k: b[k] for k in known if k in b}}
    return results


def once_per_process(name, processes):
    runs = [google_benchmark(f"^{name}/", 0.01)[name]["seconds"] for _ in range(processes)]
    return {"seconds": statistics.median(runs)}


def peer(script, *arguments, cpu_limit=None):
    out = on_one_core(["/usr/bin/python3", PEERS / script, *map(str, arguments)], cpu_limit)
    return None if out is None else json.loads(out)


def installed(module):
    return subprocess.run(["/usr/bin/python3", "-c", f"import {module}"], stderr=subprocess.DEVNULL, check=False).returncode == 0


def identities(quick):
    limit = 5 if quick else 120
    results = {}
    for name in IDENTITIES:
        results[name] = row = {"stickslip": once_per_process(f"identity/{name}", 1 if quick else 5)["seconds"]}
        for route in ROUTES if installed("sympy") else []:
            found = peer("identities.py", name, route, cpu_limit=limit + 1)
            row[route] = found or {"seconds": limit, "proved": False}
        print(f"  {name}: {row}", file=sys.stderr)
    results["35"] = {"stickslip": once_per_process("audit/35", 1 if quick else 5)["seconds"]}
    return results


def proved_orbits(digits):
    """The paper's three orbits as `stickslip orbits --json` tells them."""
    orbits = {}
    for name, family in boxes.FAMILIES.items():
        out = on_one_core([BUILD / "cli/stickslip", "orbits", family, "--example", name, "--json", "--digits", str(digits)])
        orbits[name] = min(json.loads(out)["orbits"], key=lambda o: abs(float(o["tau"]["mid"]) - PRINTED_TAU[name]))
        orbits[name]["parameters"] = {k: float(v) for k, v in json.loads(out)["parameters"].items()}
    return orbits


def mpmath_orbits(orbits, digits):
    results = {}
    getcontext().prec = digits + 10
    for name in ["S", "O", "P", "P.closed"]:
        o = orbits[name[0]]
        value = {k: float(o[k]["mid"]) for k in ("tau", "tau1", "phi") if k in o}
        delta = o["parameters"]["omega"] * value["tau"] / 2
        guess = {"S": [value["tau"]], "O": [value["tau"], value.get("tau1")], "P": [delta, value["phi"] + delta]}[name[0]]
        found = peer("orbits.py", name, digits, *(map(repr, guess + [0.0] * (2 - len(guess)))))
        for key, text in found["values"].items():
            away = abs(Decimal(text) - Decimal(o[key]["mid"])) if key in o else 0
            if away > Decimal(10) ** (3 - digits):
                sys.exit(f"measure.py: {key} of {name} is {away} away from what mpmath finds.")
        results[name] = found["seconds"]
    return results


def scipy_simulations(orbits):
    results = {}
    for name, o in orbits.items():
        a = o["parameters"]
        ur = float(o["ur"]["mid"]) if "ur" in o else a.get("ur", 0.2)
        results[name] = peer("simulation.py", *(repr(a[k]) for k in ("chi", "eta", "us", "V", "omega", "p")), ur,
                             *(o[k]["mid"] for k in ("phi", "x10", "x20", "xdot10")))
    for name, file in table.MACHINES.items():
        found = json.loads(on_one_core([BUILD / "cli/stickslip", "attractors", "--params", ROOT / file, "--starts", "20", "--json"]))
        results[name] = peer("simulation.py", json.dumps({"machine": found["machine"], "state": found["attractors"][0]["state"]}))
    for name, found in results.items():
        if found["closure"] > 1e-6:
            sys.exit(f"measure.py: the orbit {name} does not close under SciPy: {found}.")
    return results


def whole_audit():
    """script/audit on a built tree, on all cores: wall, CPU, and the largest of its processes."""
    begin = time.monotonic()
    process = subprocess.Popen([ROOT / "script/audit", "--out", BUILD / "bench/audit"], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit("measure.py: script/audit failed.")
    return {"wall": time.monotonic() - begin, "seconds": used.ru_utime + used.ru_stime, "megabytes": used.ru_maxrss / 1024,
            "cores": len(os.sched_getaffinity(0))}


def program(arguments, before=(), cores=1):
    """The program's output, complete or not, its seconds of processor time, with those of all that it started, and by
    the clock. `before`: what starts it, such as mpirun; on one core or, for 0, all."""
    used, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    run = subprocess.run([*before, BUILD / "cli/stickslip", *arguments], stdout=subprocess.PIPE, text=True, check=False,
                         env=atlases.environment(),
                         preexec_fn=(lambda: os.sched_setaffinity(0, {CORE})) if cores == 1 else None)
    wall, after = time.monotonic() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
    if run.returncode not in (0, 2, 130):
        sys.exit(f"measure.py: stickslip {' '.join(arguments)} failed with exit code {run.returncode}.")
    return run.stdout, after.ru_utime + after.ru_stime - used.ru_utime - used.ru_stime, wall


def certificates():
    """What script/certify recorded, if it did: seconds of Coq's processor time for all claims, and how many it was asked."""
    record = ROOT / "build/certificates/certificates.json"
    if not record.exists():
        return {}
    claims = [c for c in json.loads(record.read_text())["claims"] if c["accepted"] is not None]
    return {"seconds": sum(float(c["seconds"]) for c in claims), "asked": len(claims),
            "accepted": sum(c["accepted"] for c in claims)}


def machine():
    model = next(line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name"))
    versions = dict(line.split(maxsplit=1) for line in on_one_core([BUILD / "cli/stickslip", "--version"]).splitlines())
    for name in ("sympy", "scipy", "mpmath"):
        code = f"import {name}; print({name}.__version__)"
        versions[name] = on_one_core(["/usr/bin/python3", "-c", code]).strip() if installed(name) else "not installed"
    for package in ("libbenchmark-dev", "libboost-dev", "libsundials-dev", "g++", "python3-gmpy2", "auto-07p",
                    "libopenmpi-dev"):
        query = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True, check=False)
        versions[package] = query.stdout or "not installed"
    commit = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True, check=False)
    return {"cpu": model, "cores": os.cpu_count(), "load": os.getloadavg()[0], "commit": commit.stdout.strip(),
            "versions": versions}


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--quick", action="store_true", help="measure less, to see that everything works")
    arguments.add_argument("--out", type=Path, help="where results.json and RESULTS.md go")
    given = arguments.parse_args()
    out = given.out or (ROOT / "build/bench" if given.quick else ROOT / "bench")
    out.mkdir(parents=True, exist_ok=True)
    say = lambda text: print(f"measure.py: {text}", file=sys.stderr)

    results = {"quick": given.quick, "machine": machine()}
    say("everything but claims, by Google Benchmark")
    results["benchmarks"] = google_benchmark("-^(identity|audit)/", 0.01 if given.quick else 0.3)
    say("the audit")
    results["benchmarks"]["audit/symbolic"] = once_per_process("audit/symbolic", 1 if given.quick else 3)
    results["benchmarks"]["audit/all"] = once_per_process("audit/all", 1 if given.quick else 3)
    results["audit"] = whole_audit()
    orbits = proved_orbits(310)
    say("lists at random data")
    run = lambda words: program(words)[:2]
    results["completeness"] = complete_lists(run, 5 if given.quick else 100)
    results["four_phases"] = four_phases(
        lambda words, seconds: program(words, ["timeout", "--preserve-status", "--signal=INT", str(seconds)])[0],
        3 if given.quick else 40)
    say("branches, SciPy and AUTO beside")
    results["branches"] = branches.measured(run, peer, installed)
    say("boxes of parameters")
    results["boxes"] = boxes.measured(run, orbits)
    say("atlases")
    results["atlases"] = atlases.measured(program, given.quick, say)
    say("mpmath and SciPy")
    results["mpmath"] = mpmath_orbits(orbits, 300) if installed("mpmath") else {}
    results["scipy"] = scipy_simulations(orbits) if installed("scipy") else {}
    say("the Python module")
    module = BUILD / "python"
    results["python"] = peer("module.py", module) if (module / "stickslip").exists() else {}
    results["certificates"] = certificates()
    say("identities, SymPy beside")
    results["identities"] = identities(given.quick)

    (out / "results.json").write_text(json.dumps(results, indent=1) + "\n")
    text = table.markdown(results)
    (out / "RESULTS.md").write_text(text)
    print(text)
    say(f"written: {out}/results.json, {out}/RESULTS.md")


if __name__ == "__main__":
    main()
