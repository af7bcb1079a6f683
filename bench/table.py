#!/usr/bin/python3
"""Results of measure.py as Markdown: table.py results.json"""
import json
import math
import sys
from pathlib import Path

import atlases
import boxes
import branches
from completeness import SECONDS

NAMES = {
    "40": "(40) H₁² − I = H₂H₃", "38.reversal": "H(−t)E = EH(t)", "38.group": "H(t + s) = H(t)H(s)",
    "42": "(42) Γ₁² − I = Γ₂Γ₃", "41.reversal": "Γ(−t)E = EΓ(t)", "41.group": "Γ(t + s) = Γ(t)Γ(s)",
    "59": "(59) (H(t)E − I)(H(t) + E) = 0", "A3.d": "(47)–(51) d₁ … d₅", "34.H": "b₁, b₂ of (35)",
    "35": "(35) from nothing", "70": "(70) P = ΛP̃Λ⁻¹",
}
EXAMPLES = ["S", "O", "P"]
# Machines in tables: example O with dampers, and a damped chain of five masses; friction of one falls in three pieces.
MACHINES = {"two": "examples/machines/damped_O.toml", "five": "bench/five_masses.toml"}
SIMULATED = [*EXAMPLES, *MACHINES]
PEERS = ["scipy", "auto"]
# Why a target is missed, where it is known.
WHY_FILE = Path(__file__).resolve().parent / "why.json"


def duration(seconds):
    if seconds is None:
        return "–"
    for unit, size in (("s", 1), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def rows(header, lines):
    cells = [header, ["---"] * len(header), *lines]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in cells) + "\n"


def best_route(row):
    """SymPy's fastest route and its seconds; where none gets through, the longer one's."""
    tried = {route: row[route] for route in ("circle", "simplify") if route in row}
    got_through = {route: x["seconds"] for route, x in tried.items() if x["proved"]}
    if got_through:
        return min(got_through.items(), key=lambda item: item[1])
    return "none", max((x["seconds"] for x in tried.values()), default=None)


def route_shown(row, route):
    if route not in row:
        return ""
    return duration(row[route]["seconds"]) if row[route]["proved"] else f"not proved in {duration(row[route]['seconds'])}"


def exponent(points):
    """The slope of log(seconds) over log(size), by least squares."""
    x, y = [math.log(a) for a, _ in points], [math.log(b) for _, b in points]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def simulations(r):
    """Seconds per period by way and example or machine."""
    b = r["benchmarks"]
    ways = {way: {e: b[f"simulate_{way}/{e}"]["per_period"] for e in SIMULATED}
            for way in ("closed_form", "odeint", "cvode")}
    ways["scipy"] = {e: x["seconds"] for e, x in r["scipy"].items()}
    return ways


def targets(r):
    """(key, what, value, limit, at least?, shown)"""
    b, sim = r["benchmarks"], simulations(r)
    ids = r["identities"]
    ours = [row["stickslip"] for row in ids.values()]
    def at_most(key, what, value, limit, show=duration):
        return key, what, value, limit, False, show
    def at_least(key, what, value, limit, show=lambda x: f"{x:.3g} ×"):
        return key, what, value, limit, True, show
    per_second = lambda x: f"{x:,.0f}/s"
    percent = lambda x: f"{100 * x:.4g} %"
    cores = r["machine"]["cores"]
    out = [at_most("symbolic", "all symbolic claims", b["audit/symbolic"]["seconds"], 3)]
    ratios = [best_route(row)[1] / row["stickslip"] for row in ids.values() if best_route(row)[1]]
    if ratios:
        out += [at_least("each", "each of the ten identities, SymPy's best route", min(ratios), 20),
                at_least("mean", "the ten identities, geometric mean", math.exp(sum(map(math.log, ratios)) / len(ratios)), 40)]
    out.append(at_most("slowest", "the slowest of the ten identities", max(ours), 0.5))
    for way, limit in (("odeint", 25), ("cvode", 250)):
        worst = min(sim[way][e] / sim["closed_form"][e] for e in EXAMPLES)
        out.append(at_least(way, f"simulation, {way} (worst of S, O, P)", worst, limit))
    for e, limit in zip(SIMULATED, (1.5e-6, 1.5e-6, 1.5e-6, 3e-6, 8e-6)):
        out.append(at_most(f"period.{e}", f"a period of {e}, followed", sim["closed_form"][e], limit))
    for e in EXAMPLES:
        mine = b[f"enclose_{e}/digits:300"]["seconds"]
        if r["mpmath"]:
            out.append(at_least(f"mpmath.{e}", f"300 digits of {e}, mpmath", r["mpmath"][e] / mine, 200))
        out.append(at_most(f"digits.{e}", f"300 digits of {e}", mine, 2e-3))
        out.append(at_most(f"conditions.{e}", f"all conditions of {e}", b[f"conditions_{e}"]["seconds"], 2e-4))
    out += [at_most("list.S", "complete list, symmetric", b["list_symmetric_S"]["seconds"], 5e-3),
            at_most("list.O", "complete list, overshooting, φ given", b["list_overshooting_O_at_phi"]["seconds"], 0.2),
            at_most("list.O.ur", "complete list, overshooting, u_r given", b["list_overshooting_O_at_ur"]["seconds"], 0.2)]
    for key, what, name, limit in (("boxes.S", "boxes of parameters, symmetric", "box_S", 1000),
                                   ("boxes.O", "boxes of parameters, overshooting, φ given", "box_O_at_phi", 200),
                                   ("boxes.O.ur", "boxes of parameters, overshooting, u_r given", "box_O_at_ur", 200)):
        seconds = next(x["seconds"] for n, x in b.items() if n.startswith(name + ","))
        out.append(at_least(key, what, 1 / seconds, limit, per_second))
    box = b["box_of_atlas_S/four_zeros_known/240"]
    out.append(at_least("orbits.S", f"orbits of symmetric boxes of four parameters ± 2.4e-4, {box['orbits']:.0f} in each, one core",
                        box["orbits"] / box["seconds"], 5e4, per_second))
    for e, family in (("S", "symmetric"), ("P", "nonsticking")):
        if r.get("python"):
            ratio = r["python"][e] / b[f"list_{family}_{e}"]["seconds"]
            out.append(at_most(f"python.{e}", f"complete list, {family}, through Python, of the time in C++", ratio, 1.05,
                               lambda x: f"{x:.3g} ×"))
    if r.get("python"):
        out.append(at_most("import", "import of the Python module", r["python"]["import"], 0.3))
    for key, what, name, limit in (("list.ST", "complete list of ST, S", "list_word/ST_S", 1e-2),
                                   ("list.SOT.O", "complete list of SOT, O", "list_word/SOT_O", 0.5),
                                   ("list.SOT.driven", "complete list of SOT, p = 2", "list_word/SOT_driven", 3),
                                   ("chain.3", "a word of 8 phases", "prove_existence/P_3", 2e-3),
                                   ("chain.13", "a word of 34 phases", "prove_existence/P_13", 25e-3),
                                   ("chain.182", "a word of 182 periods", "prove_existence/S_182", 1.5),
                                   ("stable.182", "its stability", "prove_stability/S_182", 8),
                                   ("machine.3", "a word of 8 phases, as a machine", "prove_machine/P_3", 2.5e-3),
                                   ("machine.13", "a word of 34 phases, as a machine", "prove_machine/P_13", 10e-3),
                                   ("machine.five", "a word of 8 pieces of five masses, all decided", "prove_machine/five", 60e-3),
                                   ("attractors.S", "500 starts, 2,000 periods each, S", "attractors_of/S", 3.5),
                                   ("attractors.machine", "the same as a machine", "machine_attractors/S", 3.5),
                                   ("attractors.five", "500 starts, 2,000 periods each, five masses", "machine_attractors/five", 15)):
        out += [at_most(key, what, x["seconds"], limit) for n, x in b.items() if n.startswith(name)]
    out += [at_most("box", "a part of a box of two data, two masses, three phases, all decided", 1 / x["items_per_second"], 0.2)
            for n, x in b.items() if n.startswith("box/two")]
    rate = sum(x["items_per_second"] for n, x in b.items() if n.startswith("attractors_of")) / 3
    out.append(at_least("periods", "periods of a machine, all proofs included, mean of S, O, P, one core", rate, 2.5e5, per_second))
    lists = r["completeness"].values()
    out += [at_least("complete", "complete lists of overshooting orbits at random data",
                     sum(x["complete"] for x in lists) / sum(x["count"] for x in lists), 0.95, percent),
            at_most("complete.longest", "the longest of them", max(x["longest"] for x in lists), SECONDS)]
    four = r["four_phases"]
    out.append(at_least("four.phases", "lists of four phases at random data, interrupted after 6 s on one core, that have "
                        "a stable orbit", four["found"] / four["count"], 0.95, percent))
    for x in r["branches"]:
        what = f"{x['family']} branches in ω over [{', '.join(x['interval'])}]"
        if x["example"] == "S":
            out.append(at_most("branch.S", what + ", all", x["listed"]["seconds"], 2))
        else:
            out += [at_most("branch.O", what + f", of the orbits at {x['at']}", x["followed"]["seconds"], 10),
                    at_most("branch.O.all", what + ", all", x["listed"]["seconds"], 300)]
    for e, reached in r["boxes"].items():
        for one, names in ((True, [n for n in reached if n != "all"]), (False, ["all"])):
            short = min((boxes.SMALLEST if (k := reached[n]["conditions"]) is None else k) - boxes.GOALS[e][n]
                        for n in names if n in boxes.GOALS[e])
            out.append(at_least(f"largest.{e}", f"largest box of {e}, {'one parameter, the worst' if one else 'all parameters'}, "
                                "of its goal", 10 ** (short / 2), 1))
    minutes_shown = lambda x: f"{x / 60:.3g} min"
    for x in [] if r["quick"] else atlases.finest(r["atlases"]):
        family, at = x["name"], f", 2^-{x['resolution']}"
        decided, minutes, rate = atlases.GOALS[family]
        out += [at_least(f"atlas.{family}", f"atlas, {family}, decided{at}", x["decided"], decided, percent),
                at_most(f"atlas.wall.{family}", f"the same, wall, {cores} cores", x["wall"], 60 * minutes, minutes_shown)]
        if rate:
            out.append(at_least(f"atlas.rate.{family}", "boxes of it, halved or kept, by the clock",
                                (2 * x["boxes"] - 1) / x["wall"], rate, per_second))
    two = {x["name"]: x["wall"] for x in r["atlases"] if x["grows"] == "processes"}
    if two and not r["quick"]:
        out.append(at_least("atlas.processes", "efficiency of two processes of mpirun, by the clock", two["1"] / (2 * two["2"]),
                            0.9, percent))
    if r["certificates"]:
        seconds, asked, accepted = (r["certificates"][k] for k in ("seconds", "asked", "accepted"))
        out.append(at_most("certificates", f"certificates, as last recorded, {accepted} of {asked} accepted by Coq, processor time",
                           seconds, 1200, minutes_shown))
    out += [at_most("wall", f"script/audit, wall, {r['audit']['cores']} cores", r["audit"]["wall"], 10),
            at_most("memory", "script/audit, peak memory of a process", r["audit"]["megabytes"], 500, lambda x: f"{x:.0f} MB")]
    return out


def target_rows(r):
    why = json.loads(WHY_FILE.read_text()) if WHY_FILE.exists() else {}
    lines = []
    for key, what, value, limit, at_least, show in targets(r):
        met = value >= limit if at_least else value <= limit
        off = limit / value if at_least else value / limit
        verdict = "met" if met else f"missed by a factor {off:.3g}"
        lines.append([what, ("≥ " if at_least else "≤ ") + show(limit), show(value), verdict, "" if met else why.get(key, "")])
    return rows(["what", "target", "measured", "", "why"], lines)


def identity_rows(r):
    lines = []
    for name, row in r["identities"].items():
        route, best = best_route(row)
        lines.append([NAMES[name], duration(row["stickslip"]), route_shown(row, "circle"), route_shown(row, "simplify"),
                      f"{best / row['stickslip']:.3g} × ({route})" if best else ""])
    return rows(["identity", "stickslip", "SymPy, circle", "SymPy, simplify", "best route / stickslip"], lines)


def simulation_rows(r):
    sim = simulations(r)
    lines = []
    for e in SIMULATED:
        own = sim["closed_form"][e]
        line = [e, duration(own)]
        for way in ("odeint", "cvode", "scipy"):
            x = sim[way].get(e)
            line.append(f"{duration(x)} ({x / own:.3g} ×)" if x else "not installed")
        lines.append(line)
    return rows(["orbit", "stickslip", "Boost.Odeint", "CVODE", "SciPy solve_ivp"], lines)


def orbit_rows(r):
    lines = []
    for e in EXAMPLES:
        own, other = r["benchmarks"][f"enclose_{e}/digits:300"]["seconds"], r["mpmath"].get(e)
        lines.append([e, duration(own), f"{duration(other)} ({other / own:.3g} ×)" if other else "not installed"])
    return rows(["orbit, 300 digits", "stickslip, proved", "mpmath findroot, not proved"], lines)


def growth_rows(r):
    b = r["benchmarks"]
    def series(prefix):
        return sorted((int(n.rsplit("/", 1)[1].split(":")[-1]), x["seconds"]) for n, x in b.items() if n.startswith(prefix + "/"))
    lines = []
    for what, prefix in (("digits of S", "enclose_S"), ("digits of O", "enclose_O"), ("digits of P", "enclose_P"),
                         ("boxes that an interval is cut into", "growth_boxes"),
                         ("parameters that are intervals", "growth_parameters"), ("periods simulated", "growth_periods")):
        points = series(prefix)
        tail = points[1:] if prefix.startswith("enclose") else points
        told = ", ".join(f"{n}: {duration(s)}" for n, s in points)
        lines.append([what, told, f"{exponent(tail):.2f}", f"{tail[0][0]}–{tail[-1][0]}"])
    return rows(["with the number of", "time", "exponent", "fitted over"], lines)


def completeness_rows(r):
    words = {"away": "anywhere", "beside": "beside kω = ω_j (k ≤ 4) or ω = 1"}
    return rows(["frequency", "lists", "complete", f"in {SECONDS} s", "longest"],
                [[words[place], x["count"], x["complete"], x["in_time"], duration(x["longest"])]
                 for place, x in r["completeness"].items()])


def branch_rows(r):
    lines = []
    for x in r["branches"]:
        done, all_of = x["followed"], x["listed"]
        peers = [f"{duration(p['seconds'])}, {p['steps']} steps" if (p := x["peers"].get(way)) else "–" for way in PEERS]
        which = f"{x['family']}, {x['interval'][0]}–{x['interval'][1]}"
        left = "complete" if all_of["complete"] else f"open on {all_of['open']:.2g} of ω"
        lines += [[which, f"those of the orbits at {x['at']}", f"{duration(done['seconds'])}, {done['branches']}", *peers],
                  [which, "all, every orbit counted", f"{duration(all_of['seconds'])}, {all_of['branches']}; {left}", "–", "–"]]
    return rows(["branches in ω", "which", "stickslip, branches", "SciPy", "AUTO-07p"], lines)


def place_rows(r):
    lines = []
    for x in r["branches"]:
        for what, change, theirs in branches.beside(x):
            if change:
                at = float(change["at"]["mid"])
                own = f"{change['at']['mid']} ± {float(change['at']['rad']):.0e}, {change['verdict']}"
                peers = [f"{theirs[way] - at:+.1e}" if way in theirs else "" for way in PEERS]
            else:
                own, peers = "", [f"{theirs[way]:.12f}" if way in theirs else "" for way in PEERS]
            lines.append([x["family"], change["kind"] if change else "", what, own, *peers])
    return rows(["orbits", "kind", "what", "stickslip", "SciPy, off by", "AUTO-07p, off by"], lines)


def box_rows(r):
    def power(k):
        return "none" if k is None else f"10^{k / 2:g}"

    def cell(example, name, what):
        if name not in r["boxes"][example]:
            return ""
        goal = boxes.GOALS[example].get(name) if what == "conditions" else None
        return power(r["boxes"][example][name][what]) + (f" (≥ {power(goal)})" if goal is not None else "")
    names = [*boxes.PARAMETERS, "all"]
    return rows(["orbit", "proved", *names], [[e, what, *(cell(e, name, what) for name in names)]
                                              for e in r["boxes"] for what in ("conditions", "stability")])


def atlas_rows(r):
    lines, before = [], None
    for x in r["atlases"]:
        grown = before and x["grows"] == before["grows"] and (x["name"] == before["name"] or x["grows"] != "resolution")
        lines.append([x["grows"], x["name"], f"2^-{x['resolution']}", f"{x['boxes']:,}", f"{100 * x['decided']:.3f} %",
                      duration(x["seconds"]), f"{x['seconds'] / before['seconds']:.2f} ×" if grown else "", duration(x["wall"]),
                      f"{x['boxes'] / x['seconds']:,.0f}"])
        before = x
    return rows(["what grows", "", "resolution", "boxes", "decided", "CPU", "of the row above", "wall", "boxes/s of CPU"], lines)


def set_rows(r):
    lines = []
    for name, x in r["benchmarks"].items():
        if name.startswith("box_of_starts/"):
            k = name.split("/")[1]
            lines.append([f"starts within 10^-{k}, after a period", duration(x["seconds"]),
                          f"{x['parts']:.0f} parts, {x['growth']:.3g} times the volume" if x["proved"] == 1
                          else f"{100 * x['proved']:.4g} % of them"])
        elif name.startswith("neighbourhood_O"):
            lines.append(["a neighbourhood of the orbit", duration(x["seconds"]), f"{x['half_width_of_x2']:.2g} in x₂"])
    return rows(["set", "CPU time", "proved"], lines)


def all_rows(r):
    return rows(["benchmark", "CPU time", "cells"], [[n, duration(x["seconds"]), f"{x['cells']:.0f}" if "cells" in x else ""]
                                                     for n, x in r["benchmarks"].items()])


def markdown(r):
    m = r["machine"]
    profiles = Path(__file__).resolve().parent / "profiles.md"
    mode = " A quick run: figures are rough." if r["quick"] else ""
    loaded = m["load"] > 0.5
    caution = " Other work was on the cores: wall times are too long, CPU times somewhat." if loaded else ""
    parts = [
        "# How fast it is\n\nMade by `script/bench`; the raw figures are in `results.json`. CPU time on one core unless called "
        f"wall; all rows are of one run.{mode}\n\n"
        f"Machine: {m['cpu']}, {m['cores']} cores, load {m['load']:.1f} at the start.{caution} Commit {m['commit']}.\n\n"
        "Versions: " + ", ".join(f"{k} {v}" for k, v in m["versions"].items()) + ".",
        "## Targets\n\n" + target_rows(r),
        "## Identities\n\nA claim in a fresh process, with every claim that its proof uses but the definitions, its hypotheses "
        "and the two cross-checks of its verdict, beside SymPy on the bare equation in its most general form; for (35) SymPy has only the row of H₂⁻¹(H₁ − I) "
        "that it rests on. `circle` puts a pair (c, s) with c² + s² = 1 for each phase, as stickslip does.\n\n" + identity_rows(r),
        "## Simulation, time per period of the load\n\nThe raw law (2), (4), tolerance 1e-10; Odeint with dopri5 and dense "
        "output, CVODE with Adams and root finding, SciPy with DOP853 and events. `two` is `examples/machines/damped_O.toml`, "
        "`five` is `bench/five_masses.toml`.\n\n" + simulation_rows(r),
        "## Orbits to 300 digits\n\nBoth start from a guess in double. stickslip proves existence, uniqueness and a ball for "
        "every value of the orbit; mpmath (with gmpy2) finds the zero of the same reduced equations. P in closed form, by "
        f"(35): {duration(r['mpmath'].get('P.closed'))} in mpmath.\n\n" + orbit_rows(r),
        "## Lists of overshooting orbits at random data, u_r given\n\nχ 0.02–0.98, η 0.05–50, u_s 0.001–1 (both "
        "logarithmic), V 0–3, ω 0.05–5, p 0–5, u_r/u_s 1–10; beside a resonance but for 10⁻⁴ to 10⁻¹ of ω.\n\n" + completeness_rows(r),
        "## Branches\n\nThe paper's data, overshooting orbits at φ = 0. stickslip proves each branch without gaps and each "
        "change; the peers follow a branch in doubles until a length is 1,000. SciPy: pseudo-arclength, flows by exponentials "
        "of matrices, conditions on 200 points of each phase; AUTO: the orbit as a boundary value problem over its phases, "
        "30 × 4 points, conditions at their ends. Neither looks at stability, nor for branches that do not pass through the "
        "value where it begins.\n\n" + branch_rows(r)
        + "\nWhere something changes; of conditions, where an orbit becomes admissible or ceases to be:\n\n" + place_rows(r),
        "## Boxes of parameters\n\nThe largest half width, relative to the value, in half decades, over which the orbit is "
        "proved with every condition, and its stability, too; u_r is a result. In parentheses: what was to be reached.\n\n"
        + box_rows(r),
        "## Atlases\n\nThe paper's data, χ, η, u_s, V as there; `symmetric` ω 0.5–0.8, p 0–0.2, `overshooting` ω 0.61–0.65, "
        "p 0.03–0.07, φ = 0, `nonsticking` ω 0.5–0.8, p 0.5–1.5; area: shares of the symmetric one; dimension: parameters that "
        "vary, of the symmetric orbit; processes: of mpirun with one thread each, of the nonsticking one; else one process, a "
        "thread for each core. CPU time of all. Boxes are those that are kept.\n\n" + atlas_rows(r),
        "## Sets of motions of O\n\n" + set_rows(r),
        "## Growth\n\n" + growth_rows(r),
        f"## `script/audit` on a built tree\n\n{r['audit']['wall']:.1f} s wall on {r['audit']['cores']} cores, "
        f"{r['audit']['seconds']:.1f} s CPU, {r['audit']['megabytes']:.0f} MB in its largest process.",
        "## All benchmarks\n\n" + all_rows(r),
    ]
    if profiles.exists():
        parts.append(profiles.read_text())
    return "\n\n".join(part.strip() for part in parts) + "\n"


if __name__ == "__main__":
    print(markdown(json.loads(Path(sys.argv[1]).read_text())), end="")
