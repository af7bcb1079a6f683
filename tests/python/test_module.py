"""The rest of the module: attractors, simulation, claims, LaTeX; threads, Ctrl-C, help."""

import ast
import inspect
import json
import os
import signal
import subprocess
import sys
import threading
import time
import warnings
from pathlib import Path

import numpy
import pytest

import stickslip
from stickslip import _core

MACHINE = dict(chi="0.3", eta=4, us="0.1", V="0.1", omega="0.6", p=1)


def program(*words):
    return subprocess.run([os.environ["STICKSLIP_PROGRAM"], *words], capture_output=True, text=True).stdout


def test_attractors_are_those_of_the_program():
    found = stickslip.attractors(example="P", starts=10)
    said = json.loads(program("attractors", "--example", "P", "--starts", "10", "--json"))
    assert found.json == said
    first = found[0]
    assert first.kind == "periodic" and first.verdict == "proved" and first.state.shape == (4,)
    assert sum(a.count for a in found) == found.starts == 10
    assert len(first.durations) == len(first.word)


def test_simulation_is_that_of_the_program():
    start = (0, 0.5, "0", -0.25)
    motion = stickslip.simulate(start, **MACHINE, ur="0.2", periods=3, every=0.5)
    csv = program("simulate", *[f"--{k}={v}" for k, v in MACHINE.items()], "--ur=0.2", "--phi=0", "--periods=3",
                  "--every=0.5", "--state=0,0.5,0,-0.25", "--csv", "-").splitlines()[1:]
    rows = [line.split(",") for line in csv]
    assert motion.t.shape == (len(rows),) and motion.state.shape == (len(rows), 4)
    assert motion.phase.tolist() == [row[1] for row in rows]
    numbers = numpy.array([[float(x) for i, x in enumerate(row) if i != 1] for row in rows])
    ours = numpy.column_stack([motion.t, motion.state, motion.r, motion.u, motion.energy])
    assert numpy.array_equal(numbers, ours)
    assert numpy.allclose(motion.state[0], [0, 0.5, 0, -0.25], rtol=1e-14)
    assert motion.first_events[0].before == "slip" and abs(sum(motion.shares.values()) - 1) < 1e-12


def test_what_a_motion_settles_on_is_that_of_the_program(tmp_path):
    motion = stickslip.simulate((0, 0, 0, 0), **MACHINE, ur="0.2", periods=3, settle=True)
    words = [*[f"--{k}={v}" for k, v in MACHINE.items()], "--ur=0.2", "--phi=0", "--periods=3", "--state=0,0,0,0"]
    assert motion.json == json.loads(program("simulate", *words, "--json", f"--csv={tmp_path / 't.csv'}"))
    assert motion.settles.kind == motion.json["settles"]["kind"] and motion.settles.count is None
    assert motion.settles.state.tolist() == motion.json["settles"]["state"]
    assert stickslip.simulate((0, 0, 0, 0), **MACHINE, ur="0.2", periods=3).settles is None


@pytest.mark.parametrize("given, words", [
    (dict(example="S"), ["--example=S"]),
    (dict(example="S", orbit="symmetric:2"), ["--example=S", "--orbit=symmetric:2"]),
    (dict(example="O", perturb=("0.5", 0, 0, 0.25)), ["--example=O", "--perturb=0.5,0,0,0.25"]),
    (dict(orbit="overshooting:1", **MACHINE, ur="0.2"),
     ["--orbit=overshooting:1", *[f"--{k}={v}" for k, v in MACHINE.items()], "--ur=0.2"]),
])
def test_a_simulation_starts_where_an_orbit_begins(given, words, tmp_path):
    report = subprocess.run([os.environ["STICKSLIP_PROGRAM"], "simulate", *words, "--periods=2", "--json",
                             f"--csv={tmp_path / 't.csv'}"], capture_output=True, text=True)
    if report.returncode:
        with pytest.raises(stickslip.UsageError) as raised:
            stickslip.simulate(periods=2, **given)
        assert report.stderr == f"stickslip: {raised.value}.\n"
        return
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        motion = stickslip.simulate(periods=2, **given)
    theirs = json.loads(report.stdout)
    theirs.pop("settles", None)
    assert motion.json == theirs and "".join(f"{w.message}\n" for w in warned) == report.stderr
    last = (tmp_path / "t.csv").read_text().splitlines()[-1].split(",")
    assert [float(x) for x in last[2:6]] == motion.state[-1].tolist()


def test_a_simulation_without_a_start_is_refused():
    with pytest.raises(stickslip.UsageError, match="a start is missing"):
        stickslip.simulate(**MACHINE, ur="0.2")
    with pytest.raises(stickslip.UsageError, match="missing: ur"):
        stickslip.simulate((0, 0, 0, 0), **MACHINE)
    with pytest.raises(stickslip.UsageError, match="state and orbit"):
        stickslip.simulate((0, 0, 0, 0), example="S", orbit="symmetric:1")
    with pytest.raises(stickslip.UsageError, match="there is no orbit symmetric:9"):
        stickslip.simulate(example="S", orbit="symmetric:9")


def test_a_simulation_refuses_what_the_machine_is_not_given_exactly():
    with pytest.raises(TypeError, match="ur: the float"):
        stickslip.simulate((0, 0, 0, 0), **MACHINE, ur=0.2)
    with pytest.raises(stickslip.DomainError, match="ur"):
        stickslip.simulate((0, 0, 0, 0), **MACHINE, ur="0.05")
    with pytest.raises(stickslip.UsageError, match="four numbers"):
        stickslip.simulate((0, 0, 0), **MACHINE, ur="0.2")


def test_claims():
    checked = stickslip.check("47.c", "44.H")
    assert {claim.id for claim in checked} >= {"44.H"}
    proved = next(claim for claim in checked if claim.id == "44.H")
    assert proved.status == "as_printed" and proved.verdict == "proved" and proved.theorems
    misprint = next(claim for claim in checked if claim.id.startswith("47.c"))
    assert misprint.status == "misprint_corrected" and misprint.verdict == "refuted" and misprint.corrected
    assert misprint.corrected[0] in misprint._repr_latex_()
    with pytest.raises(stickslip.UsageError, match="'99.x'"):
        stickslip.check("99.x")


def test_statements_of_ones_own():
    proved = stickslip.prove("H(2 t) = H(t)^2")
    assert proved.verdict == "proved" and proved.theorems and not proved.hypotheses
    given = stickslip.prove("(a + b)^2 = 1 + 2 a b", "a^2 + b^2 = 1", symbols=["a", "b"])
    assert given.verdict == "proved" and given.obeyed == "theorem"
    refuted = stickslip.prove("H1(t)^2 + I = H2(t) H3(t)")
    assert refuted.verdict == "refuted" and "omega1 = " in refuted.reason and len(refuted.corrected) == 1
    assert stickslip.prove("d/dt[1/t] = -1/t^2").verdict == "undecided"
    with pytest.raises(stickslip.UsageError, match="column 1: no symbol 'nonsense'; one of your own is named by symbols=nonsense"):
        stickslip.prove("nonsense = 1")
    with pytest.raises(stickslip.UsageError, match="'chi' has a meaning already"):
        stickslip.prove("chi = 1", symbols=["chi"])


def test_claims_of_a_file(tmp_path):
    file = tmp_path / "note.claims"
    file.write_text("paper A note\nsymbols us, a\nclaim one step: .\n  us > 0\nclaim two identity: .\n  a - a = 0\n")
    assert [claim.status for claim in stickslip.check(file=file)] == ["refuted", "as_printed"]
    assert [claim.id for claim in stickslip.check("two", file=file)] == ["two"]
    assert stickslip.check("40")[0].status == "as_printed"  # the paper's names mean what they did
    file.write_text("paper A note\nclaim one step: .\n  us > 0\n")
    with pytest.raises(stickslip.UsageError, match="note.claims:3: column 1: no symbol 'us'"):
        stickslip.check(file=file)
    with pytest.raises(stickslip.InputOutputError, match="nowhere.claims"):
        stickslip.check(file=tmp_path / "nowhere.claims")


def test_latex():
    assert {name for name, _, _ in stickslip.expressions()} >= {"H", "Gamma2"}
    for unknowns in ("chi", "omega"):
        assert stickslip.latex("H2", unknowns=unknowns) in program("latex", "H2", "--in", unknowns)
    with pytest.raises(stickslip.UsageError, match="'H9'"):
        stickslip.latex("H9")


def test_latex_of_theorems_and_orbits():
    assert stickslip.latex(theorem="moving-belt") == program("latex", "--theorem", "moving-belt")
    assert stickslip.latex(orbit="symmetric:1", example="S") == program("latex", "--orbit=symmetric:1", "--example=S")
    given = [f"--{k}={v}" for k, v in MACHINE.items()]
    assert (stickslip.latex(orbit="nonsticking:2", **MACHINE, digits=30) ==
            program("latex", "--orbit=nonsticking:2", *given, "--digits=30") != "")
    with pytest.raises(stickslip.UsageError, match="there is no result 'x'"):
        stickslip.latex(theorem="x")
    with pytest.raises(stickslip.UsageError, match="exactly one"):
        stickslip.latex("H2", errata=True)
    with pytest.raises(stickslip.UsageError, match="theorems and errata have none"):
        stickslip.latex(theorem="moving-belt", example="S")
    with pytest.raises(stickslip.UsageError, match="for all parameters"):
        stickslip.latex("H2", example="S")


@pytest.mark.nightly
def test_latex_of_errata():
    printed = os.environ.get("STICKSLIP_ERRATA")  # by the program
    assert stickslip.latex(errata=True) == (Path(printed).read_text(encoding="utf-8") if printed else
                                            program("latex", "--errata")) != ""


def test_other_threads_run_meanwhile():
    done = threading.Event()
    results = []

    def work():
        results.append(stickslip.attractors(example="P", starts=200))
        done.set()

    worker = threading.Thread(target=work)
    worker.start()
    turns = 0
    while not done.wait(0.001):
        turns += 1
    worker.join()
    # Under Python's lock this thread would have had no turn but the first and the last.
    assert turns > 5 and results[0].starts == 200


def test_two_threads_get_what_one_gets():
    expected = stickslip.orbits("nonsticking", **MACHINE)
    results = [None] * 4

    def work(i):
        results[i] = stickslip.orbits("nonsticking", **MACHINE)

    workers = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert results == [expected] * 4


@pytest.mark.parametrize("call", ["stickslip.attractors(example='S', starts=100000)", "stickslip.check()"])
def test_ctrl_c_ends_long_work_and_python_goes_on(call):
    script = f"""
import stickslip, sys
print("begins", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
print(stickslip.orbits("nonsticking", example="P").complete)
"""
    process = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begins\n"
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=300)
    assert out == "interrupted\nTrue\n" and process.returncode == 0


def test_help_is_complete():
    assert stickslip.__doc__ and stickslip.__version__ in program("--version")
    for name in stickslip.__all__:
        thing = getattr(stickslip, name)
        if name.startswith("__"):
            continue
        assert vars(thing).get("__doc__") if inspect.isclass(thing) else inspect.getdoc(thing), name
        members = [thing] if inspect.isfunction(thing) else [
            member for key, member in vars(thing).items() if inspect.isfunction(member) and not key.startswith("_")
        ]
        for member in members:
            assert inspect.getdoc(member), member
            signature = inspect.signature(member)
            assert signature.return_annotation is not inspect.Signature.empty, member
            for parameter in list(signature.parameters.values())[0 if inspect.isfunction(thing) else 1:]:
                assert parameter.annotation is not inspect.Parameter.empty, (member, parameter)


def test_the_stub_names_what_the_module_has():
    stub = ast.parse((Path(stickslip.__file__).parent / "_core.pyi").read_text())
    named = {node.name for node in stub.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    assert named == {name for name in dir(_core) if not name.startswith("_")}
