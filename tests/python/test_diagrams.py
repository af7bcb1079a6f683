"""Attractors along a parameter and in a plane: as the program's tables and JSON have them."""

import copy
import csv
import json
import os
import pickle
import subprocess
import sys
import types
from xml.etree import ElementTree

import numpy
import pytest

import stickslip

VALUES = dict(m1="2.5", m2="0.8", k1=1200, k2=450, normal_force=30, friction_at_rest="0.45", friction_sliding="0.3",
              belt_velocity="0.05", load_amplitude=12, load_frequency="3.2")


def program(*words):
    return subprocess.run([os.environ["STICKSLIP_PROGRAM"], *map(str, words)], capture_output=True, text=True)


def table(tmp_path, *words):
    """The CSV of a command."""
    report = program(*words, "--csv", tmp_path / "t.csv")
    assert report.returncode == 0, report.stderr
    with open(tmp_path / "t.csv") as stream:
        return list(csv.reader(stream))[1:]


@pytest.fixture
def file(tmp_path):
    (tmp_path / "machine.toml").write_text("".join(f"{name} = {value}\n" for name, value in VALUES.items()))
    return tmp_path / "machine.toml"


@pytest.fixture
def frames(monkeypatch):
    pandas = types.ModuleType("pandas")
    pandas.DataFrame = lambda columns: {name: list(column) for name, column in columns.items()}
    monkeypatch.setitem(sys.modules, "pandas", pandas)


def again(result):
    return copy.copy(result), copy.deepcopy(result), pickle.loads(pickle.dumps(result))


def same_states(frame, rows, columns):
    """Whether the frame's states are those in these columns of the table."""
    ours = numpy.column_stack([frame[name] for name in ("x1", "x2", "x1'", "x2'")])
    return numpy.array_equal(ours, [[float(row[k]) for k in columns] for row in rows])


def test_along_a_parameter(tmp_path, frames):
    found = stickslip.attractors(example="O", along=("ur", "0.3", "0.5"), values=3, starts=5)
    words = ("attractors", "--example=O", "--along", "ur", "0.3..0.5", "--values=3", "--starts=5")
    assert found.json == json.loads(program(*words, "--json").stdout)
    assert [point.value for point in found] == ["0.3", "0.4", "0.5"] and found.along == "ur" and found.units is None
    assert "ur" not in found.parameters and found.parameters["chi"] == "0.2" and found.starts == 5
    rows, frame = table(tmp_path, *words), found.to_frame()
    assert same_states(frame, rows, range(7, 11)) and frame["kind"] == [row[3] for row in rows]
    assert [f"{k + 1}" for k in frame["attractor"]] == [row[1] for row in rows]
    assert frame["ur"] == [float(row[0]) for row in rows]
    for result in again(found):
        assert repr(result) == repr(found) and result.json == found.json and result.svg() == found.svg()
    page = ElementTree.fromstring(f"<div>{found._repr_html_()}</div>")
    assert len(page.findall("table/tbody/tr")) == len(found) == 3 and "<svg" in found._repr_svg_()
    assert len(repr(found).splitlines()) == 5 and len(repr(found[0]).splitlines()) == 1


def test_what_lies_outside_the_domain_is_said():
    found = stickslip.attractors(example="O", along=("chi", "0.5", "1.5"), values=3, starts=2)
    assert found[0].attractors and not found[0].outside
    assert not found[2].attractors and "chi" in found[2].outside and found[2].outside[:20] in repr(found)


def test_along_a_value_of_a_machine_states_are_in_si(file, tmp_path, frames):
    machine = stickslip.read_machine(file)
    found = stickslip.attractors(machine=machine, along=("load_frequency", 3, "3.4"), values=3, starts=4)
    rows = table(tmp_path, "attractors", "--params", file, "--along", "load_frequency", "3..3.4", "--values=3",
                 "--starts=4")
    assert same_states(found.to_frame(), rows, range(7, 11)) and found.units == "si" and found.json is None
    assert found.parameters == {n: str(v) for n, v in VALUES.items() if n != "load_frequency"}
    assert abs(found[1].attractors[0].state[0]) < 0.1  # m; the data are in mm
    assert sum(d.approximate for d in found[1].attractors[0].durations) == pytest.approx(5 / 3.2)
    assert "load_frequency in Hz" in found.svg()
    assert pickle.loads(pickle.dumps(found)).svg() == found.svg()


@pytest.mark.parametrize("units", [None, "si"])
def test_in_a_plane(file, tmp_path, frames, units):
    machine = stickslip.read_machine(file)
    through = None if units is None else (0, "0.01", 0, 0.02)
    found = stickslip.attractors(machine=machine, plane=("x1", "x2'"), pixels=4, units=units, through=through)
    words = ["attractors", "--params", file, "--plane", "x1,x2'", "--pixels=4"]
    if units:
        words += ["--through=0,0.01,0,0.02", "--units=si"]
    else:
        assert found.json == json.loads(program(*words, "--json").stdout)
    rows, frame = table(tmp_path, *words), found.to_frame()
    assert same_states(frame, rows, range(4)) and found.plane == ("x1", "x2'") and found.units == units
    assert [f"{k + 1}" for k in frame["attractor"]] == [row[4] for row in rows]
    assert frame["word"] == [row[7] for row in rows]
    assert found.at.shape == (4, 4) and found.starts.shape == (4, 4, 4)
    assert sum(a.count for a in found) == 16 and (numpy.array(found.json["at"]) - 1 == found.at).all()
    # Along a row the first coordinate rises, along a column the other; what does not vary is the state's.
    assert (numpy.diff(found.starts[0, :, 0]) > 0).all() and (numpy.diff(found.starts[:, 0, 3]) > 0).all()
    if units:
        assert numpy.allclose(found.starts[..., 1], 0.01)
    for result in again(found):
        assert repr(result) == repr(found) and result.svg() == found.svg() and (result.starts == found.starts).all()
    ElementTree.fromstring(f"<div>{found._repr_html_()}</div>")


@pytest.mark.parametrize("given, words", [
    (dict(along=("ur", "0.3", "0.5"), plane=("x1", "x2")), ["--along", "ur", "0.3..0.5", "--plane", "x1,x2"]),
    (dict(along=("ur", "0.5", "0.3")), ["--along", "ur", "0.5..0.3"]),
    (dict(along=("kappa", 1, 2)), ["--along", "kappa", "1..2"]),
    (dict(along=("ur", "0.3", "0.5"), pixels=5), ["--along", "ur", "0.3..0.5", "--pixels=5"]),
    (dict(plane=("x1", "x3")), ["--plane", "x1,x3"]),
    (dict(plane=("x1", "x1")), ["--plane", "x1,x1"]),
    (dict(plane=("x1", "x2"), starts=5), ["--plane", "x1,x2", "--starts=5"]),
    (dict(plane=("x1", "x2"), pixels=1), ["--plane", "x1,x2", "--pixels=1"]),
    (dict(along=("ur", "0.3", "0.5"), values=1), ["--along", "ur", "0.3..0.5", "--values=1"]),
    (dict(plane=("x1", "x2"), pixels=1001), ["--plane", "x1,x2", "--pixels=1001"]),
    (dict(values=5), ["--values=5"]),
])
def test_questions_that_are_none_are_refused_as_the_program_does(given, words):
    report = program("attractors", "--example=O", *words)
    with pytest.raises(stickslip.UsageError) as raised:
        stickslip.attractors(example="O", **given)
    theirs = report.stderr.rstrip(".\n").replace("'1001'", "1001")
    assert report.returncode == 64 and theirs == f"stickslip: {raised.value}"
