"""Balls: exact ends, and floats only where they are asked for."""

import random
import sys
import types
from decimal import Decimal
from fractions import Fraction

import pytest

from stickslip import Ball


def test_ends_are_exact():
    ball = Ball("5.4031075860350524982", "9.94e-21")
    assert ball.lower == "5.40310758603505249819006" and ball.upper == "5.40310758603505249820994"
    assert ball.contains(ball.lower) and ball.contains(ball.upper)
    assert not ball.contains("5.40310758603505249819005") and not ball.contains("5.40310758603505249820995")
    assert Ball("-1", "0.5").upper == "-0.5" and Ball("0", "0").lower == "0"


def test_no_float_without_asking():
    with pytest.raises(TypeError, match="approximate"):
        float(Ball("1", "0"))
    with pytest.raises(TypeError, match="not exact"):
        Ball("1", "0").contains(1.0)
    assert Ball("0.1", "0").approximate == 0.1


def test_floats_enclose_the_ball():
    draw = random.Random(20)
    for _ in range(500):
        digits = draw.randrange(1, 40)
        mid = f"{draw.choice(['', '-'])}{draw.randrange(10**digits)}e{draw.randrange(-60, 20)}"
        ball = Ball(mid, f"{draw.randrange(1, 999)}e{draw.randrange(-70, 5)}")
        low, high = ball.interval
        assert Fraction(low) <= Fraction(ball.lower) <= Fraction(Decimal(mid)) <= Fraction(ball.upper) <= Fraction(high)


def test_what_is_unbounded_contains_everything():
    line = Ball("nan", "inf")
    assert line.contains(10**100) and line.overlaps(Ball("0", "0"))
    assert line.interval == (float("-inf"), float("inf"))
    assert not Ball("1", "0.1").overlaps(Ball("1.3", "0.1")) and Ball("1", "0.1").overlaps(Ball("1.2", "0.1"))


def test_for_notebooks():
    assert Ball("7.7", "1e-20")._repr_latex_() == r"$7.7 \pm 1\cdot 10^{-20}$"


def test_arb_of_python_flint(monkeypatch):
    """Debian has no python-flint: a stand-in of the two types used, over exact fractions."""

    class Arb:
        def __init__(self, mid, rad=0):
            self.mid = mid.mid if isinstance(mid, Arb) else Fraction(mid)
            self.rad = (mid.rad if isinstance(mid, Arb) else 0) + (rad.mid if isinstance(rad, Arb) else Fraction(rad))

        def __add__(self, other):
            return Arb(self.mid + other.mid, self.rad + other.rad)

        def upper(self):
            return Arb(self.mid + self.rad)

    flint = types.ModuleType("flint")
    flint.arb, flint.fmpq = Arb, Fraction
    monkeypatch.setitem(sys.modules, "flint", flint)
    arb = Ball("0.1", "1e-3").to_arb()
    assert (arb.mid, arb.rad) == (Fraction(1, 10), Fraction(1, 1000))
