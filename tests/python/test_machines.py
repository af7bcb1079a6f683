"""Machines in SI units: what the program says of the same file, in the data's units and in SI."""

import csv
import dataclasses
import json
import os
import pickle
import subprocess
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy
import pytest

import stickslip

VALUES = dict(m1="2.5", m2=Fraction(4, 5), k1=1200, k2=450, normal_force=30, friction_at_rest="0.45",
              friction_sliding=Decimal("0.3"), belt_velocity="0.05", load_amplitude=12, load_frequency="3.2")

# Example O, but for the last digits of omega.
LIKE_O = dict(m1=4, m2=1, k1=320, k2=80, normal_force="0.1", friction_at_rest="1.834", friction_sliding="0.2",
              belt_velocity="0.01", load_amplitude="0.005", load_frequency="1.0009254372")


def program(*words):
    return subprocess.run([os.environ["STICKSLIP_PROGRAM"], *map(str, words)], capture_output=True, text=True)


def said(*words):
    return json.loads(program(*words, "--json").stdout)


def rows_of(file):
    with open(file) as stream:
        return list(csv.reader(stream))[1:]


def write(file, **values):
    file.write_text("".join(f"{name} = {value}\n" for name, value in values.items()))
    return file


@pytest.fixture
def file(tmp_path):
    return write(tmp_path / "machine.toml", **VALUES)


@pytest.fixture
def machine(file):
    return stickslip.read_machine(file)


def interval(ball):
    return Fraction(ball.lower), Fraction(ball.upper)


def test_a_machine_is_that_of_its_file(file, machine):
    assert machine.values() == {**{name: str(value) for name, value in VALUES.items()}, "m2": "4/5"}
    assert machine.name == str(file) and dataclasses.replace(machine, m1="3").m1 == "3"
    typed = stickslip.Machine(**VALUES)
    assert typed.name == "machine" and pickle.loads(pickle.dumps(machine)) == machine
    assert stickslip.orbits("nonsticking", machine=typed) == stickslip.orbits("nonsticking", machine=machine)


def test_orbits_of_a_machine_are_those_of_the_program(file, machine):
    found = stickslip.orbits("nonsticking", machine=machine)
    assert found.json == said("orbits", "nonsticking", "--params", file) and found.units is None
    in_si = stickslip.orbits("nonsticking", machine=machine, units="si")
    assert in_si.json == found.json and in_si.units == "si" and "SI units" in repr(in_si)
    text = program("orbits", "nonsticking", "--params", file, "--units", "si", "--all", "--digits", 20).stdout
    units = {name: stickslip.Ball(**ball) for name, ball in found.json["machine"]["units"].items()}
    for orbit, same in zip(found, in_si):
        for name, unit in (("tau", "time"), ("Theta", "time"), ("x10", "length"), ("z20", "length"),
                           ("xdot10", "velocity"), ("ur", "force")):
            ball, told = getattr(orbit, name), getattr(same, name)
            symbol = {"time": "s", "length": "m", "velocity": "m/s", "force": "N"}[unit]
            assert name == "ur" or f"{told} {symbol}" in text, name  # which was given
            ends = sorted(a * b for a in interval(ball) for b in interval(units[unit]))
            low, high = interval(told)
            assert low <= ends[-1] and ends[0] <= high and abs(high - low) < abs(high) / 10**18, name
        assert same.ur.contains("13.5")
        assert same.phi == orbit.phi and same.conditions == orbit.conditions
    assert [orbit for orbit in pickle.loads(pickle.dumps(in_si))] == list(in_si)
    program("orbits", "nonsticking", "--params", file, "--units", "si", "--plot", file.parent / "o.svg")
    assert in_si.svg() == (file.parent / "o.svg").read_text() and "k1 = 1200 N/m" in in_si._repr_svg_()


def test_orbits_of_a_word_and_attractors_of_a_machine(tmp_path):
    file, word = write(tmp_path / "O.toml", **LIKE_O), "OTS"
    machine = stickslip.read_machine(file)
    found = stickslip.orbits(word, machine=machine, units="si")
    assert found.json == said("orbits", word, "--params", file)
    assert stickslip.orbits(word, machine=machine, period=2).json == said("orbits", word, "--params", file, "--period", 2)
    text = program("orbits", word, "--params", file, "--units", "si", "--digits", 20).stdout
    orbit = found.admissible[0]
    assert f"{orbit.x10} m" in text and orbit.ur.contains("0.1834")
    assert abs(sum(d.approximate for d in orbit.durations) - 1 / 1.0009254372) < 1e-12
    does, in_si = (stickslip.attractors(machine=machine, starts=3, units=units) for units in (None, "si"))
    assert does.json == in_si.json == said("attractors", "--params", file, "--starts", 3)
    assert does[0].word == in_si[0].word == word
    mm, seconds = (float(does.json["machine"]["units"][name]["mid"]) for name in ("length", "time"))
    assert numpy.allclose(in_si[0].state[:2], does[0].state[:2] * mm, rtol=1e-12)
    assert numpy.allclose(in_si[0].state[2:], does[0].state[2:] * mm / seconds, rtol=1e-12)
    assert in_si[0].durations[0].approximate == pytest.approx(does[0].durations[0].approximate * seconds)
    # From where the attractor is, in m and m/s, the orbit is found again.
    near = stickslip.orbits(word, machine=machine, units="si", near=tuple(in_si[0].state.tolist()))
    assert near[0].ur == orbit.ur and near[0].Theta == orbit.Theta


@pytest.mark.parametrize("units", [None, "si"])
def test_a_motion_of_a_machine_is_that_of_the_program(file, machine, tmp_path, units):
    given = [] if units is None else ["--units", units]
    words = ("--state=0.001,0.002,0,0.01", "--periods=3", "--every=0.01")
    state = (1e-3, 2e-3, 0, "0.01")
    motion = stickslip.simulate(state, machine=machine, units=units, periods=3, every="0.01")
    report = program("simulate", "--params", file, *words, "--csv", tmp_path / "t.csv", *given)
    assert report.returncode == 0, report.stderr
    rows = rows_of(tmp_path / "t.csv")
    ours = numpy.column_stack([motion.t, motion.state, motion.r, motion.u, motion.energy])
    assert numpy.array_equal(ours, [[float(x) for x in (row[0], *row[2:])] for row in rows])
    assert motion.phase.tolist() == [row[1] for row in rows] and motion.units == units
    # The JSON is in the units of the data in any case.
    if units is None:
        theirs = said("simulate", "--params", file, *words, "--csv", tmp_path / "u.csv")
        del theirs["settles"]
        assert motion.json == theirs
    assert abs(motion.t[-1] - (3 / 3.2 if units else 3 / 3.2 / 0.0389249)) < 1e-4 and "machine" in motion.json


def test_the_load_of_a_motion_begins_at_the_machine_s_phase(machine):
    def phi(**more):
        changed = dataclasses.replace(machine, **more)
        return stickslip.simulate((0, 0, 0, 0), periods=1, machine=changed).json["parameters"]["phi"]

    assert phi() == 0 and phi(load_phase="0.5") == 0.5


def test_branches_along_a_value_of_a_machine(file, machine):
    along = stickslip.branch("nonsticking", machine=machine, along=("load_frequency", 7, "7.5"))
    theirs = said("branch", "nonsticking", "--params", file, "--along", "load_frequency", "7..7.5")
    assert along.json == theirs and along.units == "si" and along.parameter == "load_frequency"
    write(file.parent / "O.toml", **LIKE_O)
    word = stickslip.branch("OTS", machine=stickslip.read_machine(file.parent / "O.toml"),
                            along=("load_frequency", "1", "1.002"))
    assert word.json == said("branch", "OTS", "--params", file.parent / "O.toml", "--along", "load_frequency",
                             "1..1.002")
    # Near a state of that orbit, in m and m/s.
    near = [float(x) for x in stickslip.attractors(machine=stickslip.read_machine(file.parent / "O.toml"), starts=20,
                                                   units="si")[0].state]
    followed = stickslip.branch("OTS", machine=stickslip.read_machine(file.parent / "O.toml"), units="si", near=near,
                                along=("load_frequency", "1", "1.002"))
    assert len(followed) == 1 and followed[0].pieces == word[0].pieces
    with pytest.raises(stickslip.UsageError, match="--units si goes with --along a value of the machine"):
        stickslip.branch("nonsticking", machine=machine, units="si", phi=("0.1", "0.2"))
    given = dict(example="O", ur="0.439..0.441")
    followed = stickslip.branch("OTS", **given, orbit=1)
    assert followed.json == said("branch", "OTS", "--example=O", "--ur=0.439..0.441", "--orbit=1")
    with pytest.raises(stickslip.UsageError, match="not a name and two numbers"):
        stickslip.branch("nonsticking", machine=machine, along=("load_frequency", "7..8"))
    with pytest.raises(TypeError, match="along: the float 7.5"):
        stickslip.branch("nonsticking", machine=machine, along=("load_frequency", 7, 7.5))


def without(*names, **more):
    return {**{name: value for name, value in VALUES.items() if name not in names}, **more}


@pytest.mark.parametrize("values, words, given", [
    (without("m2", "k1"), [], {}),
    (without(friction_force_sliding=9), [], {}),
    (without(m1=-1), [], {}),
    (without(m1="heavy"), [], {}),
    (without(m1="2..3"), [], {}),
    (without(friction_at_rest="0.2"), [], {}),
    (without(friction_sliding=0), [], {}),
    (VALUES, ["--chi=0.5"], dict(chi="0.5")),
    (VALUES, ["--example=S"], dict(example="S")),
    (VALUES, ["--units=cm"], dict(units="cm")),
    (VALUES, ["--phi=1"], dict(phi=1)),
])
def test_what_is_wrong_with_a_machine_is_said_as_the_program_says_it(tmp_path, values, words, given):
    file = write(tmp_path / "machine.toml", **{n: f'"{v}"' if str(v)[0] == "h" or ".." in str(v) else v
                                               for n, v in values.items()})
    report = program("orbits", "nonsticking", "--params", file, *words)
    kind = {64: stickslip.UsageError, 65: stickslip.DomainError}[report.returncode]
    with pytest.raises(kind) as raised:
        stickslip.orbits("nonsticking", machine=stickslip.Machine(**values, name=str(file)), **given)
    said = [text.replace(f"{file}: ", "").rstrip(".\n") for text in (report.stderr, f"stickslip: {raised.value}")]
    assert said[0] == said[1]  # the program names the file wherever it reads one


def test_data_outside_the_domain_are_said_in_the_keys_of_the_machine(tmp_path):
    file = write(tmp_path / "machine.toml", **without(load_amplitude=0))
    report = program("attractors", "--params", file)
    with pytest.raises(stickslip.DomainError, match="load_amplitude = 0 in .*machine.toml: p = 0") as raised:
        stickslip.attractors(machine=stickslip.read_machine(file))
    assert report.returncode == 65 and report.stderr == f"stickslip: {raised.value}.\n"


def test_what_is_no_machine_is_refused(tmp_path, machine):
    with pytest.raises(stickslip.InputOutputError, match="none.toml"):
        stickslip.read_machine(tmp_path / "none.toml")
    with pytest.raises(stickslip.UsageError, match="chi is not a value of a machine in SI units"):
        stickslip.read_machine(write(tmp_path / "data.toml", chi="0.5"))
    with pytest.raises(stickslip.UsageError, match="'damping' is not a parameter: the model has no damping"):
        stickslip.read_machine(write(tmp_path / "damped.toml", damping="0.5"))
    with pytest.raises(TypeError, match="m1: the float 2.5 is not exact"):
        stickslip.orbits("nonsticking", machine=dataclasses.replace(machine, m1=2.5))
    with pytest.raises(stickslip.UsageError, match="machine: missing for a machine in SI units: m1, m2"):
        stickslip.orbits("nonsticking", machine=stickslip.Machine())
    with pytest.raises(stickslip.UsageError, match="--units si needs a machine"):
        stickslip.attractors(example="P", units="si")


def test_what_a_family_does_not_take_of_a_machine_is_warned_of(file, machine):
    with pytest.warns(UserWarning) as warned:
        found = stickslip.orbits("symmetric", machine=machine)
    report = program("orbits", "symmetric", "--params", file, "--json")
    assert found.json == json.loads(report.stdout)
    assert [f"{w.message}\n" for w in warned] == [report.stderr] and warned[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        stickslip.orbits("symmetric", machine=dataclasses.replace(machine, friction_at_rest=None))


def test_atlases_of_machines_are_those_of_the_program(file, machine, tmp_path):
    report = program("atlas", "nonsticking", "--params", file, "--along", "load_frequency", "7..7.5", "--along",
                     "load_amplitude", "11..12", "--resolution=2", f"--out={tmp_path / 'a.h5'}", "--json")
    if not (tmp_path / "a.h5").exists():
        pytest.skip("the program was built without HDF5")
    theirs = json.loads(report.stdout)
    made = stickslip.atlas("nonsticking", machine=machine, resolution=2,
                           along=[("load_frequency", 7, "7.5"), ("load_amplitude", 11, 12)])
    assert made.json == theirs and len(made) == theirs["boxes"] and "load_frequency in Hz" in made.svg()
    ranges = dataclasses.replace(machine, load_frequency=(7, "7.5"), load_amplitude="11..12")
    assert stickslip.atlas("nonsticking", machine=ranges, resolution=2).json == theirs
    with pytest.raises(stickslip.UsageError) as raised:
        stickslip.atlas("nonsticking", machine=stickslip.Machine(m1=1))
    assert str(raised.value).startswith("machine: missing for a machine in SI units: m2, k1")
