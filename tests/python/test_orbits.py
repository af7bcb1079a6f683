"""Orbits: the same as the program prints, and refusals in its words."""

import copy
import dataclasses
import json
import os
import pickle
import subprocess
from decimal import Decimal
from fractions import Fraction

import pytest

import stickslip

MACHINE = dict(chi="0.3", eta=4, us="0.1", V="0.1", omega="0.6", p=1)


def program(*words):
    return subprocess.run([os.environ["STICKSLIP_PROGRAM"], *words], capture_output=True, text=True)


def typed(parameters):
    return [f"--{name}={value}" for name, value in parameters.items()]


def test_orbits_are_those_of_the_program():
    found = stickslip.orbits("nonsticking", **MACHINE)
    assert found.json == json.loads(program("orbits", "nonsticking", *typed(MACHINE), "--json").stdout)
    assert found.complete and len(found) == 2 and len(found.admissible) == 1
    orbit = found.admissible[0]
    assert orbit.tau == stickslip.Ball("5.4031075860350524982", "9.94e-21")
    assert orbit.T is None and orbit.ur is None and orbit.stability == "stable"
    assert abs(orbit.multipliers[0].approximate - (0.37990063128505213 + 0.65007627864454549j)) < 1e-15
    assert [c.verdict for c in orbit.conditions] == ["proved"] * 6
    assert not found[0].admissible and any(c.verdict == "refuted" for c in found[0].conditions)


@pytest.mark.parametrize("family, given", [
    ("nonsticking", MACHINE),
    ("symmetric", dict(example="S", digits=60)),
    ("nonsticking", {**MACHINE, "chi": "0.3+-1e-4", "ur": "0.2"}),
    ("nonsticking", {**MACHINE, "chi": "0.3+-1e-3", "ur": "0.2786"}),
])
def test_what_is_made_when_it_is_read_is_what_is_printed(family, given):
    found, untouched = (stickslip.orbits(family, **given) for _ in range(2))
    printed = tuple(stickslip.Orbit._from(orbit) for orbit in found.json["orbits"])
    assert found.orbits == printed and repr(found.orbits) == repr(printed)
    # So it is for what nobody has read before.
    for again in (copy.copy, copy.deepcopy, lambda orbit: pickle.loads(pickle.dumps(orbit))):
        assert tuple(map(again, untouched)) == printed
        untouched = stickslip.orbits(family, **given)
        balls = [getattr(orbit, name) for orbit in untouched for name in ("tau", "Theta")]
        assert list(map(again, balls)) == [getattr(orbit, name) for orbit in printed for name in ("tau", "Theta")]
    assert {dataclasses.replace(orbit) for orbit in stickslip.orbits(family, **given)} == set(printed)


@pytest.mark.parametrize("word, given, verdict", [
    ("S", dict(V="1"), "proved"),
    ("S", dict(V="0"), "refuted"),
    ("O", dict(V="-1"), "proved"),
    ("T", dict(V="0", p="0.1"), "proved"),
    ("T", dict(V="1"), "refuted"),
])
def test_words_of_one_phase_are_those_of_the_program(word, given, verdict):
    data = {**dict(chi="0.3", eta="4", us="0.1", omega="0.6", p="0.05", ur="0.2"), **given}
    found = stickslip.orbits(word, **data)
    assert found.json == json.loads(program("orbits", word, *typed(data), "--json").stdout)
    assert (found.word, found.verdict) == (word, verdict)
    assert (found.room is None) == (found.stability is None) == (verdict != "proved")
    assert (found.forced is None) == (word == "T")
    with pytest.raises(stickslip.UsageError, match="one phase for ever"):
        stickslip.orbits(word, **data, period=2)


def test_every_notation_of_a_number_means_the_same():
    other = dict(chi=Fraction(3, 10), eta="4", us=Decimal("0.1"), V=Fraction(1, 10), omega="3/5", p="1")
    assert stickslip.orbits("nonsticking", **other) == stickslip.orbits("nonsticking", **MACHINE)


def test_digits_and_examples():
    orbit = stickslip.orbits("symmetric", example="S", digits=60).admissible[0]
    assert len(orbit.tau.mid.replace(".", "")) == 60 and Decimal(orbit.tau.rad) < Decimal("1e-55")
    # The paper's data with another load are the paper's no more.
    assert stickslip.orbits("symmetric", example="S", p="0.04").parameters["p"] == "0.04"


def test_a_box_is_proved_for_its_members():
    box = stickslip.orbits("nonsticking", **{**MACHINE, "chi": "0.3+-1e-4"}, ur="0.2")
    assert not box.complete
    wide = next(orbit for orbit in box if orbit.admissible)
    for chi in ("0.2999", "0.3", "0.3001"):
        member = stickslip.orbits("nonsticking", **{**MACHINE, "chi": chi}, ur="0.2").admissible[0]
        assert wide.tau.overlaps(member.tau) and wide.tau.contains(member.tau.mid)
    outside = stickslip.orbits("nonsticking", **{**MACHINE, "chi": "0.31"}, ur="0.2").admissible[0]
    assert not wide.tau.overlaps(outside.tau)
    as_ball = stickslip.orbits("nonsticking", **{**MACHINE, "chi": stickslip.Ball("0.3", "1e-4")}, ur="0.2")
    assert as_ball == box


def test_orbits_of_words():
    found = stickslip.orbits("OTS", example="O")
    assert found.complete and found.word == "OTS" and found.family is None
    assert found[0].durations and found[0].conditions[0].phase == 1
    with pytest.raises(TypeError, match="of a family"):
        found.svg()
    with pytest.raises(stickslip.UsageError, match="SS"):
        stickslip.orbits("SS", example="O")


@pytest.mark.parametrize("name", [*MACHINE, "ur"])
def test_floats_are_refused_with_the_hint(name):
    given = {**MACHINE, name: 0.25}
    with pytest.raises(TypeError, match=f"{name}: the float 0.25 is not exact: write '0.25'"):
        stickslip.orbits("nonsticking", **given)
    with pytest.raises(TypeError, match="no number"):
        stickslip.orbits("nonsticking", **{**MACHINE, name: True})


@pytest.mark.parametrize("given, error, words", [
    (dict(chi="2"), stickslip.DomainError, ["--chi=2"]),
    (dict(omega="-1"), stickslip.DomainError, ["--omega=-1"]),
    (dict(chi="a"), stickslip.UsageError, ["--chi=a"]),
    (dict(p="1/0"), stickslip.UsageError, ["--p=1/0"]),
    (dict(phi="1"), stickslip.UsageError, ["--phi=1"]),
])
def test_what_is_wrong_is_said_as_the_program_says_it(given, error, words):
    with pytest.raises(error) as raised:
        stickslip.orbits("nonsticking", **{**MACHINE, **given})
    assert isinstance(raised.value, stickslip.Error) and isinstance(raised.value, ValueError)
    said = program("orbits", "nonsticking", *typed({k: v for k, v in MACHINE.items() if k not in given}), *words)
    assert said.stderr.rstrip(".\n") == f"stickslip: {raised.value}".rstrip(".")


def test_a_zero_character_does_not_end_a_number():
    with pytest.raises(stickslip.UsageError, match="zero character"):
        stickslip.orbits("nonsticking", **{**MACHINE, "chi": "0.3\0"})


def test_what_is_missing_or_out_of_range_is_named():
    with pytest.raises(stickslip.UsageError, match="missing: eta, us, V, omega, p"):
        stickslip.orbits("symmetric", chi="0.5")
    with pytest.raises(stickslip.UsageError, match="'nothing'"):
        stickslip.orbits("nothing", **MACHINE)
    for digits in (0, "20", 2.5):
        with pytest.raises(stickslip.UsageError, match=f"digits: {digits!r} is not a whole number from 1 to 2000"):
            stickslip.orbits("nonsticking", **MACHINE, digits=digits)
    with pytest.raises(stickslip.UsageError, match="jobs: 0"):
        stickslip.orbits("nonsticking", **MACHINE, jobs=0)
    # There is no way to write it exactly.
    with pytest.raises(TypeError, match="eta: nan is no number"):
        stickslip.orbits("nonsticking", **{**MACHINE, "eta": float("nan")})
    with pytest.raises(TypeError, match="kappa"):
        stickslip.orbits("nonsticking", **MACHINE, kappa=1)


def test_pictures_and_formulas_for_notebooks():
    found = stickslip.orbits("nonsticking", **MACHINE)
    assert "<svg" in found._repr_svg_()
    assert r"\tau &= 5.4031075860350524982 \pm 9.94\cdot 10^{-21}" in found.admissible[0]._repr_latex_()


def test_results_become_dictionaries():
    found = stickslip.orbits("nonsticking", **MACHINE)
    assert dataclasses.asdict(found)["orbits"][0]["tau"]["mid"] == found[0].tau.mid
    assert repr(found).startswith("Orbits: nonsticking, chi=0.3 eta=4") and "_found" not in repr(found)
    for thing in (found, found[0], found[0].tau):
        with pytest.raises(AttributeError, match="nothing"):
            thing.nothing


@pytest.mark.nightly
def test_stable_orbits_have_neighbourhoods_where_they_are_asked_for():
    found = stickslip.orbits("overshooting", example="O", neighbourhood=True)
    assert found.json["command"].endswith(" --neighbourhood")
    [orbit] = [one for one in found if one.stability == "stable"]
    around = orbit.neighbourhood
    assert around.verdict == "proved" and 0 < around.alone[1] <= around.half_widths[1] > 5e-3
    [told] = [one for one in found.json["orbits"] if "neighbourhood" in one]
    assert around.ur == told["ur_of_neighbourhood"] and told["ur"]["mid"].startswith(around.ur[:15])
    assert stickslip.orbits("overshooting", example="O")[0].neighbourhood is None
    with pytest.raises(stickslip.UsageError, match="neighbourhood is not for --along"):
        stickslip.attractors(example="O", along=("p", "0.1", "0.2"), neighbourhood=True)


@pytest.mark.nightly
def test_a_neighbourhood_of_a_machine_in_si_units_is_in_these():
    machine = stickslip.Machine(m1=4, m2=1, k1=320, k2=80, normal_force="0.1", friction_at_rest="1.834",
                                friction_sliding="0.2", belt_velocity="0.01", load_amplitude="0.005",
                                load_frequency="1.0009254372")
    found = stickslip.attractors(machine=machine, units="si", starts=1, neighbourhood=True)
    told, plain = found[0].neighbourhood, found.json["attractors"][0]["neighbourhood"]  # the JSON is in the data's units
    assert told.verdict == "proved" and told.ur is None
    for k, factor in enumerate((1e-3, 1e-3, 1e-2, 1e-2)):
        for name in ("centre", "alone", "half_widths"):
            assert abs(getattr(told, name)[k] - factor * plain[name][k]) <= 1e-12 * abs(factor * plain[name][k])
        assert abs(told.S[k][0] - factor * plain["S"][k][0]) <= 1e-12 * factor
