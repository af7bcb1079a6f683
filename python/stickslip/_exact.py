"""Numbers at the door: exact ones go in, enclosures come out."""

from __future__ import annotations

import numbers
from dataclasses import dataclass, fields
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal, localcontext
from fractions import Fraction
from functools import lru_cache
from math import inf, isfinite, nextafter
from typing import Any, Dict, FrozenSet, Tuple, Union

Exact = Union[str, int, Fraction, Decimal, "Ball"]


def _plain(value: Decimal) -> str:
    """The exact decimal, without an exponent where that is short."""
    text = str(value)
    return format(value, "f") if "E" in text and -40 < value.adjusted() < 40 else text


@lru_cache(maxsize=None)
def names(cls: Any) -> FrozenSet[str]:
    """Of the fields of a dataclass."""
    return frozenset(f.name for f in fields(cls))


class Later:
    """A dataclass of which some fields are made, by _made, when one of them is first asked for."""

    @classmethod
    def _later(cls, found: Any, **known: Any) -> Any:
        """An object of the class that is made of what was found; some of its fields are known."""
        result = object.__new__(cls)
        result.__dict__.update(known, _found=found)
        return result

    def _made(self, name: str) -> Dict[str, Any]:
        """The field of that name, and what else comes with it."""
        raise NotImplementedError

    def __getattr__(self, name: str) -> Any:
        if name not in names(type(self)) or "_found" not in self.__dict__:
            raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        self.__dict__.update(self._made(name))
        return self.__dict__[name]

    def _state(self) -> Dict[str, Any]:
        """What is copied and pickled: the fields, and not what they are made of."""
        return {name: getattr(self, name) for name in names(type(self))}


@dataclass(frozen=True)
class Ball(Later):
    """All numbers from mid - rad to mid + rad; the one that is meant is proved to be among them.

    ``mid`` and ``rad`` are exact decimals as text. A ball is never taken for a float silently: ask for
    ``approximate`` (the float next to mid) or for ``interval`` (two floats that enclose the ball).
    """

    mid: str
    rad: str

    def _made(self, name: str) -> Dict[str, str]:
        mid, rad = self._found.decimals()
        return {"mid": mid, "rad": rad}

    __getstate__ = Later._state

    def _end(self, sign: int) -> Decimal:
        mid, rad = Decimal(self.mid), Decimal(self.rad)
        if not (mid.is_finite() and rad.is_finite()):
            return Decimal("Infinity") * sign
        exact = Context(prec=max(mid.adjusted(), rad.adjusted()) + 3 - min(mid.as_tuple().exponent,
                                                                           rad.as_tuple().exponent))
        return exact.add(mid, rad * sign) if rad else mid

    @property
    def lower(self) -> str:
        """mid - rad, an exact decimal."""
        return _plain(self._end(-1))

    @property
    def upper(self) -> str:
        """mid + rad, an exact decimal."""
        return _plain(self._end(1))

    @property
    def approximate(self) -> float:
        """The float next to mid: for pictures and guesses."""
        return float(self.mid)

    @property
    def interval(self) -> Tuple[float, float]:
        """The narrowest two floats that enclose the ball."""
        lower, upper = self._end(-1), self._end(1)
        low, high = float(lower), float(upper)
        return (nextafter(low, -inf) if Decimal(low) > lower else low,
                nextafter(high, inf) if Decimal(high) < upper else high)

    def contains(self, value: Union[str, int, Fraction, Decimal]) -> bool:
        """Whether the exact number is a member."""
        number = Fraction(exact("value", value))
        lower, upper = self._end(-1), self._end(1)
        if not (lower.is_finite() and upper.is_finite()):
            return True
        return Fraction(lower) <= number <= Fraction(upper)

    def overlaps(self, other: "Ball") -> bool:
        """Whether the two have a member in common."""
        return self._end(-1) <= other._end(1) and other._end(-1) <= self._end(1)

    def to_arb(self) -> Any:
        """A python-flint ``arb`` that contains this ball, at flint's working precision. Needs python-flint."""
        from flint import arb, fmpq

        mid, rad = Fraction(self.mid), Fraction(self.rad)
        return arb(fmpq(mid.numerator, mid.denominator)) + arb(0, arb(fmpq(rad.numerator, rad.denominator)).upper())

    def __float__(self) -> float:
        raise TypeError("a ball is no float: say ball.approximate or ball.interval")

    def __str__(self) -> str:
        return f"{self.mid} ± {self.rad}"

    def __format__(self, spec: str) -> str:
        """As a Decimal is formatted, where all members become the same text; else the interval, rounded outwards.

        f"{ball:.5f}" is "5.40311", or of a wider ball "[5.40310, 5.40324]"; f"{ball}" is str(ball).
        """
        if not spec:
            return str(self)
        lower, upper = self._end(-1), self._end(1)
        low, high = format(lower, spec), format(upper, spec)
        if low == high:
            return low
        with localcontext() as context:
            context.rounding = ROUND_FLOOR
            low = format(lower, spec)
            context.rounding = ROUND_CEILING
            return f"[{low}, {format(upper, spec)}]"

    def _repr_latex_(self) -> str:
        return rf"${self.mid} \pm {_latex_decimal(self.rad)}$"


def _latex_decimal(text: str) -> str:
    mantissa, _, exponent = text.lower().partition("e")
    return rf"{mantissa}\cdot 10^{{{int(exponent)}}}" if exponent else mantissa


@dataclass(frozen=True)
class ComplexBall:
    """A complex number: balls around its real and its imaginary part."""

    re: Ball
    im: Ball

    @property
    def approximate(self) -> complex:
        """The complex float next to the midpoints."""
        return complex(self.re.approximate, self.im.approximate)

    def __format__(self, spec: str) -> str:
        return f"{self.re:{spec}} + i ({self.im:{spec}})"

    def __complex__(self) -> complex:
        raise TypeError("a ball is no complex float: say ball.approximate")


def exact(name: str, value: Exact) -> str:
    """The number as text that is read exactly.

    Takes text such as ``"0.1607"``, ``"1/3"`` or ``"0.5+-1e-4"``, an int, a ``Fraction``, a ``Decimal``, a
    ``Ball``. A float is refused with a TypeError that says how to write it.
    """
    if isinstance(value, str):
        return value
    if isinstance(value, Ball):
        return f"{value.mid}+-{value.rad}"
    if isinstance(value, bool):
        raise TypeError(f"{name}: {value} is no number")
    if isinstance(value, numbers.Rational):
        return str(Fraction(value))
    if isinstance(value, Decimal):
        return str(value)
    if isinstance(value, numbers.Real) and isfinite(value):
        short = repr(float(value))
        raise TypeError(f"{name}: the float {short} is not exact: write '{short}' for the decimal, or "
                        f"Fraction({short}) for what the float holds")
    raise TypeError(f"{name}: {value!r} is no number: write text such as '0.1607' or '1/3', an int or a Fraction")
