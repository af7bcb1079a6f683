"""Machines of any number of masses from Python."""

import json
from fractions import Fraction
from pathlib import Path

import numpy
import pytest

import stickslip

MACHINE = Path(__file__).resolve().parents[2] / "examples" / "machines" / "engineer.toml"


@pytest.fixture(name="machine")
def fixture_machine():
    return stickslip.MachineInTables(MACHINE)


def test_what_it_does_is_proved(machine):
    found = machine.attractors(starts=10)
    assert found.machine.masses == ("2.5", "0.8")
    orbit = found.attractors[0].orbit
    assert orbit.word == "OTS" and orbit.stability == "stable" and orbit.admissible
    assert orbit.period.contains(Fraction(5, 9))
    assert found.attractors[0].count == 10
    assert machine.attractors(starts=10, jobs=1).attractors[0].orbit.period == orbit.period


def test_an_orbit_is_where_a_simulation_returns_to(machine):
    orbit = machine.orbits("OTS").orbits[0]
    start = [x.approximate for x in orbit.phases[0].state]
    record, samples = machine.simulate(start, time=orbit.period.approximate, phi=orbit.theta.approximate)
    assert samples.shape[1] == 8
    assert numpy.allclose(samples[-1, 1:5], start, atol=1e-7)
    assert record.events.count == len(orbit.phases) or record.events.count == len(orbit.phases) - 1


def test_a_branch_has_changes_and_samples(machine):
    found = machine.branch("OTS", ("load.1.frequency", "3.58", "3.6"))
    branch = found.branches[0]
    assert [change.kind for change in branch.changes] == ["condition"]
    assert "stick.upper" in branch.changes[0].words
    assert branch.samples[-1].orbit.verdict == "proved"
    assert branch.last.kind == "interval"


def test_a_branch_is_proved_at_all_values_where_that_is_asked_for():
    machine = stickslip.MachineInTables(MACHINE.with_name("stribeck.toml"))
    branch = machine.branch("ST", ("belt.velocity", "1.2", "1.25"), without_gaps=True).branches[0]
    assert len(branch.joints) == len(branch.samples) - 1
    assert {(joint.existence, joint.state) for joint in branch.joints} == {("proved", "proved")}


def test_a_box_of_data_is_proved_at_once(machine):
    found = machine.branch("OTS", [("belt.velocity", "0.0495", "0.0505"), ("spring.1.c", "0.59", "0.61")], parts=20)
    assert [datum.path for datum in found.data] == ["belt.velocity", "spring.1.c"]
    part, = found.motions[0].parts
    assert (part.existence, part.state) == ("proved", "stable")
    assert (part["from"], part.to) == (("0.0495", "0.59"), ("0.0505", "0.61"))
    with pytest.raises(stickslip.UsageError, match="--parts is for several"):
        machine.branch("OTS", ("belt.velocity", "0.04", "0.06"), parts=20)


def test_which_starts_end_in_steady_sliding():
    machine = stickslip.MachineInTables(MACHINE.with_name("smooth_stribeck.toml"))
    found = machine.orbits("S", basin=((-2, 2), (0, 2)))
    assert found.steady_sliding.stability == "stable"
    assert found.basin.verdict == found.basin.others == "proved"
    assert abs(found.basin.share.approximate - 0.3071261377816009) < 1e-15
    along = machine.branch("S", ("belt.velocity", "1.1", "1.152"), basin=(("-2", "2"), (0, "2"))).basins
    assert [(end.gained, end.at_belt) for end in along.ends] == [(True, False)]
    assert 1.1512925464 < float(Fraction(along.ends[0].to)) < 1.1512925466
    with pytest.raises(stickslip.UsageError, match="is for steady sliding"):
        machine.orbits("ST", basin=((-2, 2), (0, 2)))


def test_what_starts_end_on_along_a_number_and_in_a_plane(machine):
    found = machine.attractors(starts=3, along=("load.1.frequency", "3.5", "3.6"), values=3)
    assert [point.value for point in found.points] == ["3.5", "3.55", "3.6"]
    last = found.points[-1].attractors[0]
    assert last.orbit.word == "OTS" and last.count == 3 and len(last.once) == last.orbit.periods == 2
    plane = machine.attractors(plane=("x2", "x1'"), pixels=4, through=[0, 0, 0, 0])
    assert plane.plane == ("x2", "x1'") and [len(row) for row in plane.at] == [4] * 4
    assert sum(one.count for one in plane.attractors) == 16
    middle = [(first + last) / 2 for first, last in zip(plane["from"], plane.to)]
    assert numpy.allclose(middle, 0)
    with pytest.raises(stickslip.UsageError, match="two questions"):
        machine.attractors(plane=("x1", "x2"), along=("belt.velocity", 1, 2))
    with pytest.raises(stickslip.UsageError, match="is not two of x1, x2, x1', x2'"):
        machine.attractors(plane=("x1", "x3"))


def test_what_is_wrong_is_said(machine, tmp_path):
    with pytest.raises(stickslip.UsageError, match="nothing stands at belt.speed"):
        machine.branch("OTS", ("belt.speed", 1, 2))
    with pytest.raises(stickslip.UsageError, match="4 numbers, not 2"):
        machine.simulate([0, 0], time=1)
    for wrong in (dict(starts=-5), dict(starts=0), dict(jobs=0), dict(digits=0), dict(most_periods=1.5)):
        with pytest.raises(stickslip.UsageError, match="is not a whole number from 1 to"):
            machine.attractors(**wrong)
    with pytest.raises(stickslip.UsageError, match="is not a whole number from 1 to"):
        machine.orbits("OTS", period=-1)
    flat = tmp_path / "flat.toml"
    flat.write_text("chi = 0.5\n")
    with pytest.raises(stickslip.UsageError, match="no machine in tables"):
        stickslip.MachineInTables(flat)
    with pytest.raises(stickslip.InputOutputError):
        stickslip.MachineInTables(tmp_path / "none.toml")
    with pytest.raises(AttributeError, match="there is no wrd"):
        machine.orbits("OTS").wrd


def test_records_are_mappings(machine):
    found = machine.orbits("OTS", period=2)
    assert dict(found)["word"] == found.word == found["word"] == "OTS"
    assert "orbits" in dir(found) and "OTS" in repr(found)
    assert json.loads(json.dumps(found.machine.belt["velocity"])) == "0.05"


def test_a_set_holds_the_motion_from_its_middle(machine):
    start = [0.01, 0.01, 0.1, 0.01]
    found = machine.simulate_set(start, [1e-5, 1e-5, 0, 1e-4], time=1)
    assert abs(found.proved - 1) < 1e-12 and not found.open
    _, samples = machine.simulate(start, time=1)
    assert any(all(abs(x - ball.approximate) <= float(ball.rad) + 1e-9 for x, ball in zip(samples[-1, 1:5], part.then))
               for part in found.parts)


def test_a_stable_orbit_has_a_neighbourhood_where_one_is_asked_for():
    free = stickslip.MachineInTables(MACHINE.with_name("stribeck.toml"))
    orbit = free.orbits("ST", neighbourhood=True).orbits[0]
    assert orbit.neighbourhood.verdict == "proved"
    around = orbit.neighbourhood
    assert around.alone[0] > 0 and all(0 <= alone <= half for alone, half in zip(around.alone, around.half_widths))
    assert "neighbourhood" not in list(free.orbits("ST").orbits[0])
