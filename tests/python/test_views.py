"""How results show themselves, and that they survive being copied and pickled."""

import copy
import dataclasses
import os
import pickle
import subprocess
import sys
import types
from xml.etree import ElementTree

import numpy
import pytest

import stickslip
from stickslip import Ball

MACHINE = dict(chi="0.3", eta=4, us="0.1", V="0.1", omega="0.6", p=1)

LISTS = {
    "a family": lambda: stickslip.orbits("nonsticking", **MACHINE),
    "a box": lambda: stickslip.orbits("nonsticking", **{**MACHINE, "chi": "0.3+-1e-4"}, ur="0.2"),
    "a word": lambda: stickslip.orbits("OTS", example="O"),
    "branches": lambda: stickslip.branch("symmetric", example="S", omega="0.586..0.588"),
    "attractors": lambda: stickslip.attractors(example="P", starts=20),
    "claims": lambda: stickslip.check("44", "47"),
}


def again(result):
    return copy.copy(result), copy.deepcopy(result), pickle.loads(pickle.dumps(result))


@pytest.mark.parametrize("asked", LISTS.values(), ids=LISTS)
def test_lists_are_copied_and_pickled(asked):
    found = asked()
    for result in again(found):
        assert repr(result) == repr(found) and result.json == found.json and len(result) == len(found)
        assert [repr(item) for item in result] == [repr(item) for item in found]
        if not isinstance(found, stickslip.Attractors):  # their arrays have no truth value
            assert result == found
        if hasattr(found, "svg") and getattr(found, "word", None) is None:
            assert result.svg() == found.svg() != ""
    for result in again(found[0]):
        assert repr(result) == repr(found[0])


def test_what_is_pickled_needs_no_other_process(tmp_path):
    found = LISTS["a family"]()
    (tmp_path / "found").write_bytes(pickle.dumps(found))
    script = f"import pickle; found = pickle.load(open({str(tmp_path / 'found')!r}, 'rb')); print(len(found.svg()))"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert run.stdout == f"{len(found.svg())}\n", run.stderr


def test_an_atlas_and_a_branch_are_copied_and_pickled(tmp_path):
    made = subprocess.run([os.environ["STICKSLIP_PROGRAM"], "atlas", "nonsticking", "--example=P",
                           "--omega=0.55..0.65", "--p=0.9..1.1", "--resolution=2", f"--out={tmp_path / 'a.h5'}"])
    if made.returncode == 74 or not (tmp_path / "a.h5").exists():
        pytest.skip("the program was built without HDF5")
    atlas = stickslip.atlas(tmp_path / "a.h5")
    for result in again(atlas):
        assert numpy.array_equal(result.lower, atlas.lower) and result.box(3) == atlas.box(3)
        assert result.svg() == atlas.svg() and repr(result) == repr(atlas)
    assert len(repr(atlas).splitlines()) <= 20 and "<svg" in atlas._repr_html_()
    branch = LISTS["branches"]()[0]
    for result in again(branch):
        assert result == branch and numpy.array_equal(result.samples["state"], branch.samples["state"])


@pytest.mark.parametrize("asked", LISTS.values(), ids=LISTS)
def test_a_list_is_shown_in_a_few_lines_and_in_a_page(asked):
    found = asked()
    lines = repr(found).splitlines()
    assert len(lines) <= 20 and max(map(len, lines)) <= 170
    assert lines[0].startswith(f"{type(found).__name__}: ") and lines[2].startswith("0  ")
    assert all(len(repr(item).splitlines()) == 1 for item in found)
    page = ElementTree.fromstring(f"<div>{found._repr_html_()}</div>")
    assert len(page.findall("table/tbody/tr")) == len(found)
    item = getattr(found[0], "_repr_html_", None)
    assert item is None or len(ElementTree.fromstring(f"<div>{item()}</div>").findall("table/tbody/tr")) > 0


def test_of_a_long_list_the_beginning_is_shown():
    orbit = LISTS["a family"]()[0]
    listed = LISTS["a word"]()
    for count in (17, 18, 100):
        many = dataclasses.replace(listed, orbits=(orbit,) * count)
        lines = repr(many).splitlines()
        assert len(lines) == min(count + 2, 20) and (count <= 17) != (lines[-1] == f"… and {count - 17} more")
    assert repr(dataclasses.replace(listed, orbits=())).startswith("Orbits: OTS, chi=")


def test_pictures_can_stand_within_a_page():
    for name in ("a family", "branches"):
        found = LISTS[name]()
        assert found.svg().startswith("<?xml")
        for text in (found._repr_svg_(), found._repr_html_()):
            assert "<svg" in text and "<?xml" not in text and "<!DOCTYPE" not in text
        ElementTree.fromstring(found._repr_svg_())
    assert LISTS["a word"]()._repr_svg_() is None


def test_without_gnuplot_the_table_is_there(monkeypatch):
    found = LISTS["a family"]()
    monkeypatch.setenv("PATH", "")
    with pytest.raises(stickslip.InputOutputError, match="gnuplot"):
        found.svg()
    assert found._repr_svg_() is None and "<table>" in found._repr_html_()


def test_balls_are_formatted_as_far_as_they_are_known():
    tau = LISTS["a family"]().admissible[0].tau
    assert f"{tau:.5f}" == "5.40311" and f"{tau:12.3e}" == "    5.403e+0" and f"{tau:.6g}" == "5.40311"
    assert f"{tau}" == str(tau)
    wide = Ball("5.4031", "1e-4")
    assert f"{wide:.2f}" == "5.40" and f"{wide:.5f}" == "[5.40300, 5.40320]" and f"{wide:.3f}" == "5.403"
    assert f"{Ball('0.12345', '1e-3'):.3f}" == "[0.122, 0.125]"
    assert f"{Ball('nan', 'inf'):.2f}" == "[-Infinity, Infinity]"
    assert f"{stickslip.ComplexBall(tau, wide):.2f}" == "5.40 + i (5.40)"


class Frame(dict):
    """A stand-in for pandas' data frame, which is no dependence of the tests."""

    def __init__(self, columns):
        super().__init__({name: list(column) for name, column in columns.items()})
        assert len({len(column) for column in self.values()}) <= 1


def test_results_become_data_frames(monkeypatch):
    pandas = types.ModuleType("pandas")
    pandas.DataFrame = Frame
    monkeypatch.setitem(sys.modules, "pandas", pandas)
    found = LISTS["a family"]()
    table = found.to_frame()
    assert table["tau"] == [orbit.tau.approximate for orbit in found] and table["admissible"] == [False, True]
    assert table["z10"] == [orbit.z10.approximate for orbit in found] and "z10" not in repr(found)
    along = LISTS["branches"]()
    samples = along.to_frame()
    assert len(samples["value"]) == sum(len(branch.samples["value"]) for branch in along)
    assert samples["branch"][0] == 0 and samples["branch"][-1] == len(along) - 1
    assert samples["x20"] == [x for branch in along for x in branch.samples["x20"]]
    assert along[0].to_frame()["state"] == list(along[0].samples["state"])
    assert LISTS["attractors"]().to_frame()["count"][0] == 15
    assert "44.H" in LISTS["claims"]().to_frame()["id"]
    motion = stickslip.simulate((0, 0, 0, 0), **MACHINE, ur="0.2", periods=3)
    assert motion.to_frame()["x2'"] == list(motion.state[:, 3]) and len(repr(motion).splitlines()) == 1
