"""Branches and atlases: the same as the program says, exact, with pictures."""

import json
import os
import subprocess
from fractions import Fraction

import numpy
import pytest

import stickslip


def program(*words):
    return subprocess.run([os.environ["STICKSLIP_PROGRAM"], *words], capture_output=True, text=True)


def test_branches_are_those_of_the_program():
    found = stickslip.branch("symmetric", example="S", omega="0.586..0.588")
    assert found.json == json.loads(program("branch", "symmetric", "--example=S", "--omega=0.586..0.588",
                                            "--json").stdout)
    assert found.complete and found.parameter == "omega" and "omega" not in found.parameters and len(found) == 4
    changes = [change for branch in found for change in branch.changes]
    assert [(change.kind, change.what, change.verdict) for change in changes] == [("stability", "real -1", "proved")]
    branch = next(branch for branch in found if branch.changes)
    assert {piece.state for piece in branch.pieces} == {"stable", "unstable"}
    assert branch.pieces[0].last.overlaps(changes[0].at) and branch.pieces[1].first.overlaps(changes[0].at)
    assert branch.samples["value"].shape == branch.samples["state"].shape == branch.samples["tau"].shape
    assert "<svg" in found._repr_svg_()
    # On either side of the change the program's list of orbits counts as many that are stable.
    for omega, count in (("0.586", found.counts[0]), ("0.588", found.counts[-1])):
        orbits = stickslip.orbits("symmetric", example="S", omega=omega)
        assert (count.orbits, count.admissible) == (len(orbits), len(orbits.admissible))
        assert count.stable == sum(orbit.stability == "stable" for orbit in orbits.admissible)


def test_a_box_of_data_is_proved_at_once():
    box = [("eta", "3.999", "4.001"), ("p", "0.0499", "0.0501")]
    found = stickslip.branch("OTS", example="O", along=box, parts=50)
    assert [datum.path for datum in found.data] == ["eta", "p"]
    assert {(part.existence, part.state) for part in found.motions[0].parts} == {("proved", "stable")}
    words = [word for name, *ends in box for word in ("--along", name, "..".join(ends))]
    told = json.loads(program("branch", "OTS", "--example=O", *words, "--parts=50", "--json").stdout)
    assert len(found.motions[0].parts) == len(told["motions"][0]["parts"])
    for what, message in [(dict(family="symmetric", along=box), "several --along are for a word"),
                          (dict(family="OTS", along=box[0], parts=5), "--parts is for several"),
                          (dict(family="OTS", along=[*box, ("p", 1, 2)]), "p and p vary together")]:
        with pytest.raises(stickslip.UsageError, match=message):
            stickslip.branch(example="O", **what)


def test_an_interval_is_a_pair_too():
    pair = stickslip.branch("nonsticking", example="P", omega=(Fraction(3, 5), "0.61"), at="0.6")
    text = stickslip.branch("nonsticking", example="P", omega="3/5..0.61", at=Fraction(3, 5))
    assert pair == text and pair.interval == ("0.6", "0.61") and pair.at == "0.6" and not pair.complete


def test_branches_of_a_word():
    found = stickslip.branch("OTS", example="O", ur="0.439..0.441", at="0.44")
    assert found.family == "OTS" and found.parameter == "ur" and found.at == "0.44" and not found.complete
    assert found.json == json.loads(program("branch", "OTS", "--example=O", "--ur=0.439..0.441", "--at=0.44",
                                            "--json").stdout)
    with pytest.raises(stickslip.UsageError, match="period is for words"):
        stickslip.branch("symmetric", example="S", omega="0.5..0.6", period=2)


@pytest.mark.parametrize("given, error, words", [
    (dict(), stickslip.UsageError, "interval"),
    (dict(omega="0.5..0.6", p="0..1"), stickslip.UsageError, "omega and p"),
    (dict(omega="0.6..0.5"), stickslip.UsageError, "does not rise"),
    (dict(omega=(0.5, "0.6")), TypeError, "omega: the float 0.5 is not exact"),
    (dict(chi="0.5..1"), stickslip.DomainError, "chi = 1"),
    (dict(omega="0.5..0.6", at="0.7"), stickslip.UsageError, "at: omega"),
])
def test_branches_that_are_none_are_refused(given, error, words):
    with pytest.raises(error, match=words):
        stickslip.branch("symmetric", example="S", **given)


@pytest.fixture(scope="module")
def atlas_file(tmp_path_factory):
    file = tmp_path_factory.mktemp("atlas") / "a.h5"
    made = program("atlas", "nonsticking", "--example=P", "--omega=0.55..0.65", "--p=0.9..1.1", "--resolution=3",
                   f"--out={file}", "--json")
    if not file.exists():
        pytest.skip("the program was built without HDF5")
    return file, json.loads(made.stdout)


def test_an_atlas_is_read_as_the_program_wrote_it(atlas_file):
    file, said = atlas_file
    atlas = stickslip.atlas(file)
    assert atlas.json == said and atlas.axes == ("omega", "p") and len(atlas) == said["boxes"]
    assert atlas.volume == {name: Fraction(said["volume"][name]) for name in ("decided", "outside", "open")}
    assert atlas.lower.shape == atlas.upper.shape == (len(atlas), 2)
    # The boxes are the rectangle, and those without a reason have the shares that are said.
    boxes = [atlas.box(i) for i in range(len(atlas))]

    def area(box):
        return (box["omega"][1] - box["omega"][0]) * (box["p"][1] - box["p"][0]) / Fraction("0.02")

    assert sum(map(area, boxes)) == 1
    decided = atlas.reason == ""
    assert sum(area(box) for box, is_decided in zip(boxes, decided) if is_decided) == atlas.volume["decided"] > 0
    assert ((atlas.orbits >= 0) & (atlas.admissible >= 0) & (atlas.stable >= 0))[decided].all()
    assert all(said for said in atlas.reason[~decided])
    assert numpy.allclose(atlas.lower, [[float(box[name][0]) for name in atlas.axes] for box in boxes], rtol=1e-15)
    # A corner of a decided box has so many orbits.
    i = int(numpy.flatnonzero(decided)[0])
    here = stickslip.orbits("nonsticking", example="P", **{name: ends[0] for name, ends in boxes[i].items()})
    assert (len(here), len(here.admissible)) == (atlas.orbits[i], atlas.admissible[i])
    with pytest.raises(IndexError):
        atlas.box(len(atlas))
    assert "<svg" in atlas._repr_svg_()


def test_an_atlas_of_machines_has_the_values_of_their_file(tmp_path):
    (tmp_path / "machine.toml").write_text("""
        m1 = 4\nm2 = 1\nk1 = "320+-1%"\nk2 = 80\nfriction_force_sliding = 0.02
        belt_velocity = 0.01\nload_amplitude = "0.1+-1%"\nload_frequency = 1.1""")
    program("atlas", "nonsticking", f"--params={tmp_path / 'machine.toml'}", "--resolution=2",
            f"--out={tmp_path / 'a.h5'}")
    if not (tmp_path / "a.h5").exists():
        pytest.skip("the program was built without HDF5")
    atlas = stickslip.atlas(tmp_path / "a.h5")
    assert atlas.axes == ("k1", "load_amplitude") and atlas.json["units"] == "si"
    boxes = [atlas.box(i) for i in range(len(atlas))]
    assert min(box["k1"][0] for box in boxes) == Fraction("316.8") and boxes[0]["m1"] == (4, 4)
    assert "load_amplitude in N" in atlas.svg()


def test_what_is_no_atlas_is_refused(tmp_path):
    with pytest.raises(stickslip.InputOutputError, match="none.h5"):
        stickslip.atlas(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("no atlas")
    with pytest.raises(stickslip.InputOutputError, match="not an atlas|without HDF5"):
        stickslip.atlas(str(tmp_path / "text.h5"))


def as_made(said, made):
    """Whether an atlas is the one that the program's JSON tells of."""
    return made.json == said and len(made) == said["boxes"]


def test_an_atlas_is_made_as_the_program_makes_it(atlas_file):
    file, said = atlas_file
    made = stickslip.atlas("nonsticking", example="P", omega=("0.55", "0.65"), p="0.9..1.1", resolution=3)
    assert as_made(said, made)
    along = [("omega", "0.55", "0.65"), ("p", "0.9", "1.1")]
    assert as_made(said, stickslip.atlas("nonsticking", example="P", along=along, resolution=3))
    read = stickslip.atlas(file)
    assert numpy.array_equal(made.lower, read.lower) and numpy.array_equal(made.stable, read.stable)
    assert made.svg() == read.svg() and made.box(2) == read.box(2)


@pytest.mark.parametrize("given, words", [
    (dict(example="P"), ["--example=P"]),
    (dict(example="P", omega="0.6..0.5"), ["--example=P", "--omega=0.6..0.5"]),
    (dict(example="P", eta="3..4", us="0.1..0.2", V="0..1", omega="0.5..0.6", p="1..2"),
     ["--example=P", "--eta=3..4", "--us=0.1..0.2", "--V=0..1", "--omega=0.5..0.6", "--p=1..2"]),
    (dict(example="P", phi="0..1"), ["--example=P", "--phi=0..1"]),
    (dict(example="P", along=("kappa", 1, 2)), ["--example=P", "--along", "kappa", "1..2"]),
])
def test_atlases_that_are_none_are_refused_as_the_program_does(given, words, tmp_path):
    report = program("atlas", "nonsticking", *words, f"--out={tmp_path / 'a.h5'}")
    assert report.returncode == 64
    with pytest.raises(stickslip.UsageError) as raised:
        stickslip.atlas("nonsticking", **given)
    assert report.stderr.rstrip(".\n") == f"stickslip: {raised.value}".rstrip(".")


def test_what_is_read_takes_no_parameters(atlas_file):
    with pytest.raises(stickslip.UsageError, match="is read"):
        stickslip.atlas(atlas_file[0], example="P")
