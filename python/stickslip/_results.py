"""Results: what the functions of stickslip return, as dataclasses."""

from __future__ import annotations

import json as _json
from dataclasses import dataclass, field
from fractions import Fraction
from html import escape as _escape
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

from . import _core
from ._exact import Ball, ComplexBall, Later
from ._exact import names as _names
from ._views import Drawn, Listed, Row
from ._views import frame as _frame
from ._views import html as _html
from ._views import short as _short

if TYPE_CHECKING:
    import numpy
    import pandas


def _value(data: Any) -> Any:
    """What stands in JSON: balls as balls, lists as tuples."""
    if isinstance(data, list):
        return tuple(map(_value, data))
    if isinstance(data, dict) and data.keys() == {"mid", "rad"}:
        return Ball(**data)
    if isinstance(data, dict) and data.keys() == {"re", "im"}:
        return ComplexBall(_value(data["re"]), _value(data["im"]))
    return data


def _given(cls: Any, data: Dict[str, Any], **more: Any) -> Any:
    """An object of the class with those of the data that are its fields."""
    return cls(**{**{key: _value(data[key]) for key in data.keys() & set(_names(cls)) - more.keys()}, **more})


def _with(result: Any, found: Any) -> Any:
    """The result, which from now on knows what it is made of: what draws, and no field of it."""
    result.__dict__["_found"] = found
    return result


@dataclass(frozen=True)
class Condition:
    """An inequality along the whole motion, decided."""

    id: str  #: the paper's equation, or a word
    statement: str  #: in the paper's symbols
    verdict: str  #: "proved", "refuted" or "undecided"
    reason: str = ""  #: of all but "proved"
    margin: Optional[Ball] = None  #: the smallest signed distance, a length
    at: Optional[Ball] = None  #: a time at which it has that margin
    phase: Optional[int] = None  #: of an orbit of a word: the phase, from 1


@dataclass(frozen=True)
class Neighbourhood:
    """Starts whose motions are all proved to converge to a stable orbit, or why none was proved.

    The set is centre + S z for all z whose norm is at most radius: states (x1, x2, x1', x2') at load phase theta.
    """

    verdict: str  #: "proved" or "undecided"
    reason: str = ""
    phase: Optional[str] = None  #: the phase that motions are in there
    theta: Optional[float] = None
    centre: Tuple[float, ...] = ()  #: the orbit's point there
    alone: Tuple[float, ...] = ()  #: how far each number may be from it while the others are as there
    half_widths: Tuple[float, ...] = ()  #: of the whole set
    S: Tuple[Tuple[float, ...], ...] = ()
    radius: Optional[float] = None
    boxes: Optional[int] = None  #: that the map over a period was looked at over
    ur: Optional[str] = None  #: where the orbit's ur is a result: that of the machine of which this is, 17 digits of it

    @classmethod
    def _in(cls, data: Dict[str, Any]) -> Optional["Neighbourhood"]:
        found = data.get("neighbourhood")
        return None if found is None else _given(cls, found, ur=data.get("ur_of_neighbourhood"))


@dataclass(frozen=True)
class Unresolved:
    """A part of the search's domain that could not be decided."""

    reason: str
    where: Dict[str, Ball]


def _conditions(data: List[Dict[str, Any]]) -> Tuple[Condition, ...]:
    return tuple(_given(Condition, c) for c in data)


def _unresolved(data: Dict[str, Any]) -> Tuple[Unresolved, ...]:
    return tuple(
        Unresolved(part["reason"], {name: _value(ball) for name, ball in part.items() if isinstance(ball, dict)})
        for part in data["unresolved"])


def _listed(parameters: Dict[str, str]) -> str:
    return " ".join(f"{name}={value}" for name, value in parameters.items())


def _in(units: Optional[str]) -> str:
    return "; values in SI units" if units else ""


@dataclass(frozen=True, repr=False)
class Orbit(Later, Row):
    """A periodic orbit that is proved to exist, with everything decided about it.

    Times and angles are dimensionless; lengths are in the unit of us, V and p; or, with units="si", times are in
    s, lengths in m, velocities in m/s and ur in N. Conditions always are in the units of the data. What the family
    does not have is None.
    """

    admissible: Optional[bool]  #: whether all conditions hold; None: undecided
    conditions: Tuple[Condition, ...]
    tau: Optional[Ball] = None  #: how long the first phase lasts
    tau1: Optional[Ball] = None  #: the second
    T: Optional[Ball] = None  #: the stick
    Theta: Optional[Ball] = None  #: the period of the load, 2 pi/omega
    phi: Optional[Ball] = None  #: the load's phase when the first phase begins
    z10: Optional[Ball] = None  #: the state then, of z = x - d_0 (6)
    z20: Optional[Ball] = None
    zdot10: Optional[Ball] = None
    x10: Optional[Ball] = None  #: the same, of x
    x20: Optional[Ball] = None
    xdot10: Optional[Ball] = None
    ur: Optional[Ball] = None  #: the friction at rest
    ur_max: Optional[Ball] = None  #: the largest that an orbit that never sticks allows
    stability: Optional[str] = None  #: "stable", "unstable", "marginal", "undecided"; of an admissible orbit
    stability_reason: str = ""
    multipliers: Tuple[ComplexBall, ...] = ()  #: Floquet multipliers, of an admissible orbit
    split: Optional[str] = None  #: for a box with something undecided: the parameter to split first
    word: Optional[str] = None  #: of an orbit of a word: S slip, O overshoot, T stick
    period: Optional[int] = None  #: of an orbit of a word: in periods of the load
    durations: Tuple[Ball, ...] = ()  #: of an orbit of a word: of its phases
    neighbourhood: Optional[Neighbourhood] = None  #: of a stable orbit, where it was asked for

    _balls = ("tau", "tau1", "T", "Theta", "phi", "z10", "z20", "zdot10", "x10", "x20", "xdot10", "ur", "ur_max")
    _aside = ("Theta", "z10", "z20", "zdot10")

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "Orbit":
        return _given(cls, data, conditions=_conditions(data["conditions"]), neighbourhood=Neighbourhood._in(data))

    @classmethod
    def _of(cls, found: _core.OrbitList, number: int) -> "Orbit":
        """One of a list; its conditions, and the decimals of its balls, are made when they are asked for."""
        known, balls, multipliers = found.orbit(number)
        return cls._later((found, number), **known, **{name: Ball._later(ball) for name, ball in balls.items()},
                          multipliers=tuple(ComplexBall(Ball._later(re), Ball._later(im)) for re, im in multipliers),
                          neighbourhood=Neighbourhood._in(_json.loads(found.neighbourhood(number))))

    def _made(self, name: str) -> Dict[str, Any]:
        found, number = self._found
        return {"conditions": _conditions(_json.loads(found.conditions(number)))}

    __getstate__ = Later._state

    def _row(self) -> Dict[str, Any]:
        told = ("word", "period", *self._balls, "admissible", "stability")
        return {name: getattr(self, name) for name in told}

    def _repr_html_(self) -> str:
        conditions = [
            dict(condition=c.statement, phase=c.phase, verdict=c.verdict, margin=c.margin, reason=c.reason)
            for c in self.conditions
        ]
        title = f"{self.word or 'orbit'}: " + {True: "admissible", False: "not admissible",
                                              None: "undecided"}[self.admissible]
        multipliers = ", ".join(f"{m:.6g}" for m in self.multipliers)
        stability = f", {self.stability}, multipliers {multipliers}" if self.stability else ""
        return _html(title + stability, conditions, _escape(self._repr_latex_()))

    def _repr_latex_(self) -> str:
        names = {"tau": r"\tau", "tau1": r"\tau_1", "Theta": r"\Theta", "phi": r"\varphi", "ur": "u_r",
                 "ur_max": r"u_{r,\max}"}
        rows = [f"{names[n]} &= {getattr(self, n)._repr_latex_()[1:-1]}" for n in names if getattr(self, n)]
        return "$$\\begin{aligned}" + r"\\ ".join(rows) + "\\end{aligned}$$"


@dataclass(frozen=True, repr=False)
class Orbits(Drawn, Later, Listed[Orbit]):
    """A list of orbits, and what is known of its completeness; a sequence of its orbits.

    Decimals are made of what was found when they are first asked for.
    """

    parameters: Dict[str, str]  #: exact decimals or fractions
    complete: bool  #: no orbit is missing
    orbits: Tuple[Orbit, ...]
    unresolved: Tuple[Unresolved, ...]
    family: Optional[str]  #: None of a word
    word: Optional[str]  #: in place of a family
    period: Optional[int]  #: of a word, in periods of the load
    remarks: Tuple[str, ...]
    seen: str  #: of a word: what was met in place of an orbit
    units: Optional[str]  #: "si": times in s, lengths in m, velocities in m/s, ur in N; None: those of the data
    json: Dict[str, Any] = field(repr=False, compare=False)  #: as orbits --json prints it

    def _made(self, name: str) -> Dict[str, Any]:
        found = self._found
        if name == "json":
            return {"json": _json.loads(found.json())}
        if isinstance(found, _core.OrbitList):
            data = _json.loads(found.without_orbits())
            orbits = tuple(Orbit._of(found, number) for number in range(len(found)))
        else:
            data = _json.loads(found.fields())
            orbits = tuple(Orbit._from(o) for o in data["orbits"])
        return dict(parameters=data["parameters"], complete=data["complete"], orbits=orbits,
                    unresolved=_unresolved(data), family=data.get("family"), word=data.get("word"),
                    period=data.get("period"), remarks=tuple(data.get("remarks", [])), seen=data.get("seen", ""),
                    units=data.get("units"))

    def _items(self) -> Tuple[Orbit, ...]:
        return self.orbits

    def _title(self) -> str:
        parts = f", {len(self.unresolved)} parts unresolved" if self.unresolved else ""
        found = "complete" if self.complete else "not complete" + parts
        return f"{self.family or self.word}, {_listed(self.parameters)}; {found}{_in(self.units)}"

    @property
    def admissible(self) -> Tuple[Orbit, ...]:
        """The orbits that obey every condition."""
        return tuple(orbit for orbit in self.orbits if orbit.admissible)

    def _script(self) -> str:
        return super()._script() if self.word is None else ""

    def svg(self) -> str:
        """Phase portraits and time histories, drawn by gnuplot; empty where there is no orbit to draw.

        Raises InputOutputError without gnuplot; for orbits of a word, of which there is no picture, TypeError.
        """
        if self.word is not None:
            raise TypeError("there are pictures of the orbits of a family, not of a word")
        return super().svg()

    def _repr_svg_(self) -> Optional[str]:
        return super()._repr_svg_() if self.word is None else None


@dataclass(frozen=True)
class PureWord:
    """Whether some motions stay in one phase for ever: slip, overshoot or stick."""

    word: str  #: "S", "O" or "T"
    parameters: Dict[str, str]  #: exact decimals or fractions
    verdict: str  #: on "some motions do": "proved", "refuted" or "undecided"
    reason: str = ""
    forced: Optional[Ball] = None  #: of "S" and "O": the speed `|q2| omega` that the load forces
    #: Where some motions do, what the amplitudes of free oscillations have to stay below: a speed, of "T" a force.
    room: Optional[Ball] = None
    stability: Optional[str] = None  #: "neutral", where some motions do
    units: Optional[str] = None  #: "si": speeds in m/s, forces in N; None: those of the data
    json: Dict[str, Any] = field(default_factory=dict, repr=False, compare=False)  #: as orbits --json prints it

    @classmethod
    def _from(cls, found: _core.PureWord) -> "PureWord":
        return _given(cls, _json.loads(found.fields()), json=_json.loads(found.json()))


@dataclass(frozen=True)
class Change:
    """Where something changes along a branch."""

    kind: str  #: "fold", "condition", "stability", "birth" or "resonance"
    what: str  #: which condition (its id), multiplier, duration or frequency; empty for a fold
    words: str  #: a sentence
    at: Ball  #: contains the parameter's value
    verdict: str  #: on "there is exactly one such change in `at`, and it is transversal": "proved" or "undecided"
    reason: str = ""  #: of what is undecided
    time: Optional[Ball] = None  #: of a condition: where in the motion, from its beginning

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "Change":
        whats = (data[key] for key in ("condition", "multiplier", "duration", "frequency") if key in data)
        return _given(cls, data, what=next(whats, ""))


@dataclass(frozen=True)
class Piece:
    """A part of a branch on which nothing changes, every orbit of it proved."""

    first: Ball  #: the parameter where it begins
    last: Ball  #: and ends
    state: str  #: "stable", "unstable", "marginal", "admissible" (stability undecided), "not admissible", "undecided"
    violates: str = ""  #: a condition that is violated all along, if one is

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "Piece":
        return _given(cls, data, first=_value(data["from"]), last=_value(data["to"]))


@dataclass(frozen=True)
class BranchEnd:
    """Why a branch begins or ends where it does."""

    at: Ball
    #: "interval" (its end), "birth" (a phase lasts no time), "closed", "infinity" (the motion grows beyond all
    #: bounds), "stopped"
    kind: str
    reason: str
    resolved: bool  #: else the branch may go on


@dataclass(frozen=True, repr=False)
class Branch(Row):
    """A curve of orbits, without a gap."""

    first: BranchEnd
    last: BranchEnd
    closed: bool  #: a closed curve
    pieces: Tuple[Piece, ...]  #: from first to last
    changes: Tuple[Change, ...]  #: likewise
    #: Nearly, for pictures: "value", "state", the durations by their names, "phi", "x10", "x20", "xdot10".
    samples: Dict[str, "numpy.ndarray"] = field(compare=False)

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "Branch":
        import numpy

        rows = data["samples"]
        first, last = (_given(BranchEnd, end) for end in data["ends"])
        return cls(first, last, data["closed"], tuple(Piece._from(p) for p in data["pieces"]),
                   tuple(Change._from(c) for c in data["changes"]),
                   {name: numpy.array([row[name] for row in rows]) for name in (rows[0] if rows else ())})

    def _row(self) -> Dict[str, Any]:
        return {"from": self.first.at, "begins": self.first.kind, "to": self.last.at, "ends": self.last.kind,
                "pieces": _short(", ".join(piece.state for piece in self.pieces)),
                "changes": _short(", ".join(f"{c.kind} {c.what}".strip() for c in self.changes))}

    def to_frame(self) -> "pandas.DataFrame":
        """The samples, a row each. Needs pandas."""
        return _frame(self.samples)


@dataclass(frozen=True)
class Count:
    """How many orbits there are on the branches between two values of the parameter."""

    first: Ball
    last: Ball
    orbits: int
    admissible: int
    stable: int
    unsettled: int  #: of the admissible ones, those whose stability is undecided
    undecided: int  #: further motions that close: whether they are orbits, or admissible, is undecided
    more: bool  #: an unresolved part may hold more orbits

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "Count":
        return _given(cls, data, first=_value(data["from"]), last=_value(data["to"]))


@dataclass(frozen=True, repr=False)
class Branches(Drawn, Listed[Branch]):
    """Orbits over an interval of one parameter; a sequence of branches."""

    family: str
    parameter: str  #: the one that varies
    interval: Tuple[str, str]  #: of its values
    parameters: Dict[str, str]  #: the others, exact decimals or fractions
    complete: bool  #: every orbit at any value of the interval is on one of the branches
    branches: Tuple[Branch, ...]
    counts: Tuple[Count, ...]
    unresolved: Tuple[Unresolved, ...]  #: where more may be; "value" is the parameter's
    at: Optional[str] = None  #: only the branches of the orbits at this value were asked for
    units: Optional[str] = None  #: "si" along a value of a machine: all is in SI units
    json: Dict[str, Any] = field(default_factory=dict, repr=False, compare=False)  #: as branch --json prints it

    @classmethod
    def _from(cls, found: Any) -> "Branches":
        data = _json.loads(found.json())
        branches = _given(cls, data, json=data, unresolved=_unresolved(data),
                          branches=tuple(Branch._from(b) for b in data["branches"]),
                          counts=tuple(Count._from(c) for c in data["counts"]))
        return _with(branches, found)

    def _items(self) -> Tuple[Branch, ...]:
        return self.branches

    def _title(self) -> str:
        found = "complete" if self.complete else "not complete"
        return (f"{self.family}, {self.parameter} from {self.interval[0]} to {self.interval[1]}, "
                f"{_listed(self.parameters)}; {found}{_in(self.units)}")

    def to_frame(self) -> "pandas.DataFrame":
        """The samples of all branches, a row each; "branch" counts from 0. Needs pandas."""
        names = ["value", "state", *{name: 0 for b in self.branches for name in b.samples if name != "state"}]
        columns: Dict[str, List[Any]] = {"branch": [], **{name: [] for name in names}}
        for number, branch in enumerate(self.branches):
            count = len(branch.samples.get("value", ()))
            columns["branch"] += [number] * count
            for name in columns.keys() - {"branch"}:
                columns[name] += list(branch.samples.get(name, [None] * count))
        return _frame(columns)


@dataclass(frozen=True, eq=False, repr=False)
class Atlas(Drawn):
    """What is proved over a rectangle of parameters, box by box. Arrays have a row per box."""

    family: str
    axes: Tuple[str, ...]  #: the parameters that vary
    parameters: Dict[str, str]  #: exact; of an axis its interval, "A..B"
    resolution: int  #: each axis is halved so many times at most
    volume: Dict[str, Fraction]  #: "decided", "outside" the domain and "open", as exact shares of the whole
    lower: "numpy.ndarray"  #: shape (n, axes): each box's least values, rounded to floats; box() has them exactly
    upper: "numpy.ndarray"  #: likewise the greatest
    orbits: "numpy.ndarray"  #: shape (n,): how many orbits there are at each point of the box; -1: not known
    admissible: "numpy.ndarray"  #: of these, obeying every condition; -1: not known
    stable: "numpy.ndarray"  #: of the latter; -1: not known
    reason: "numpy.ndarray"  #: shape (n,), of text: why a box is left open; empty where it is decided
    json: Dict[str, Any] = field(repr=False)  #: as atlas --json prints it

    @classmethod
    def _from(cls, found: Any) -> "Atlas":
        import numpy

        data, columns = _json.loads(found.json()), found.columns()
        orbits, admissible, stable, reason = columns["found"].T
        atlas = cls(data["family"], tuple(data["axes"]), data["parameters"], data["resolution"],
                    {name: Fraction(data["volume"][name]) for name in ("decided", "outside", "open")},
                    columns["lower"], columns["upper"], orbits, admissible, stable,
                    numpy.array(["", *columns["reasons"][1:]])[reason], data)
        return _with(atlas, found)

    def __len__(self) -> int:
        return len(self.orbits)

    def box(self, number: int) -> Dict[str, Tuple[Fraction, Fraction]]:
        """The exact least and greatest value of each parameter in the box of this row. IndexError beyond the last."""
        box = self.__dict__["_boxes"][number] if "_boxes" in self.__dict__ else self._found.box(number)
        return {name: (Fraction(least), Fraction(greatest)) for name, least, greatest in box}

    def __repr__(self) -> str:
        shares = ", ".join(f"{float(share):.4g} {name}" for name, share in self.volume.items())
        return f"Atlas: {self.family}, {_listed(self.parameters)}; {len(self)} boxes: {shares}"

    def _repr_html_(self) -> str:
        return _html(repr(self), [], self._repr_svg_() or "")

    def to_frame(self) -> "pandas.DataFrame":
        """A row for each box: least and greatest values as floats, counts, the reason of what is open. Needs pandas."""
        ends = {f"{axis}_{end}": array[:, k] for k, axis in enumerate(self.axes)
                for end, array in (("lower", self.lower), ("upper", self.upper))}
        return _frame({**ends, "orbits": self.orbits, "admissible": self.admissible, "stable": self.stable,
                       "reason": self.reason})

    def svg(self) -> str:
        """The map, drawn by gnuplot: of two axes, else UsageError. Raises InputOutputError without gnuplot."""
        return super().svg()

    def _repr_svg_(self) -> Optional[str]:
        return super()._repr_svg_() if len(self.axes) == 2 else None

    def __getstate__(self) -> Dict[str, Any]:
        drawing = self._script() if len(self.axes) == 2 else ""
        boxes = self.__dict__.get("_boxes") or [self._found.box(number) for number in range(len(self))]
        return {**{name: getattr(self, name) for name in _names(Atlas)}, "_drawing": drawing, "_boxes": boxes}


@dataclass(frozen=True, eq=False, repr=False)
class Attractor(Row):
    """A motion that starts end on, or that one motion settles on. A periodic one is proved."""

    kind: str  #: "periodic", "quasi-periodic", "irregular", "slides", "stuck", "grows without bound" or "unsettled"
    count: Optional[int]  #: how many starts end on it; None, as the next two, of what one motion settles on
    share: Optional[float]
    share_interval: Optional[Tuple[float, float]]  #: Wilson's, of 95 %
    state: "numpy.ndarray"  #: x1, x2, x1', x2' on it at load phase 0
    word: Optional[str] = None  #: periodic: its phases
    period: Optional[int] = None  #: periodic: in periods of the load
    verdict: Optional[str] = None  #: periodic: on "there is exactly one orbit there"
    reason: str = ""
    admissible: Optional[bool] = None
    durations: Tuple[Ball, ...] = ()
    multipliers: Tuple[ComplexBall, ...] = ()
    stability: Optional[str] = None
    stability_reason: str = ""
    family: Optional[str] = None  #: that of the paper that it belongs to
    lyapunov: Optional[float] = None  #: irregular, quasi-periodic: a check, no proof
    neighbourhood: Optional[Neighbourhood] = None  #: of a stable orbit, where it was asked for

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "Attractor":
        import numpy

        shares = {"count": None, "share": None, "share_interval": None, **data}
        return _given(cls, shares, state=numpy.array(data["state"]), neighbourhood=Neighbourhood._in(data))

    def _row(self) -> Dict[str, Any]:
        return dict(share=self.share, count=self.count, kind=self.kind, word=_short(self.word or ""),
                    period=self.period, verdict=self.verdict, stability=self.stability, family=self.family,
                    lyapunov=self.lyapunov)


@dataclass(frozen=True, repr=False)
class Attractors(Listed[Attractor]):
    """What a machine does, the most frequent first; a sequence of attractors."""

    parameters: Dict[str, str]
    starts: int
    seed: int
    simulated: int  #: periods of the load in all
    attractors: Tuple[Attractor, ...]
    units: Optional[str] = None  #: "si": states in m and m/s, durations in s; None: the units of the data
    json: Dict[str, Any] = field(default_factory=dict, repr=False, compare=False)  #: as attractors --json prints it

    @classmethod
    def _from(cls, found: _core.AttractorList) -> "Attractors":
        data = _json.loads(found.fields())
        return _given(cls, data, attractors=tuple(Attractor._from(a) for a in data["attractors"]),
                      json=_json.loads(found.json()))

    def _items(self) -> Tuple[Attractor, ...]:
        return self.attractors

    def _title(self) -> str:
        return f"{_listed(self.parameters)}; {self.starts} starts, seed {self.seed}{_in(self.units)}"


_coordinates = ("x1", "x2", "x1'", "x2'")


@dataclass(frozen=True, eq=False, repr=False)
class DiagramPoint(Row):
    """What a machine does at one value of the parameter that varies."""

    value: str  #: exact
    attractors: Tuple[Attractor, ...]  #: the most frequent first
    #: Of each attractor its states x1, x2, x1', x2' at load phase 0, one period apart, of shape (n, 4).
    once: Tuple["numpy.ndarray", ...]
    outside: str = ""  #: why the value is outside the domain, if it is; nothing else is known then

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "DiagramPoint":
        import numpy

        return _given(cls, data, attractors=tuple(Attractor._from(a) for a in data["attractors"]),
                      once=tuple(numpy.array(a["once"]).reshape(-1, 4) for a in data["attractors"]))

    def _row(self) -> Dict[str, Any]:
        ends = ", ".join(f"{100 * a.share:.0f} % {_short(a.word) if a.word else a.kind}" +
                         (f" ({a.period})" if a.period else "") for a in self.attractors)
        return dict(value=f"{float(Fraction(self.value)):.6g}", ends=_short(ends), outside=_short(self.outside))


@dataclass(frozen=True, eq=False, repr=False)
class Diagram(Drawn, Listed[DiagramPoint]):
    """What a machine does at many values of one parameter; a sequence of points, by rising value."""

    along: str  #: the parameter, or the value of a machine in SI units, that varies
    parameters: Dict[str, str]  #: what stays: of a machine whose values vary those of its file
    starts: int  #: at each value
    seed: int
    most_periods: int  #: of the load, that a start is followed for
    points: Tuple[DiagramPoint, ...]
    units: Optional[str] = None  #: "si": states in m and m/s, durations in s; None: the units of the data
    #: As attractors --along --json prints it; None along a value of a machine, where the data's unit of length changes.
    json: Optional[Dict[str, Any]] = field(default=None, repr=False)

    @classmethod
    def _from(cls, found: _core.Diagram) -> "Diagram":
        data, staying = _json.loads(found.fields()), found.staying()
        parameters = data["parameters"] if staying is None else staying
        diagram = _given(cls, data, points=tuple(DiagramPoint._from(p) for p in data["points"]),
                         parameters={name: value for name, value in parameters.items() if name != data["along"]},
                         units=data.get("units") if staying is None else "si",
                         json=_json.loads(found.json()) if staying is None else None)
        return _with(diagram, found)

    def _items(self) -> Tuple[DiagramPoint, ...]:
        return self.points

    def _title(self) -> str:
        ends = f" from {self.points[0].value} to {self.points[-1].value}" if self.points else ""
        return (f"along {self.along}{ends}, {_listed(self.parameters)}; {self.starts} starts at each value, "
                f"seed {self.seed}{_in(self.units)}")

    def to_frame(self) -> "pandas.DataFrame":
        """A row for each state once a period of each attractor, which count from 0 at each value. Needs pandas."""
        names = (self.along, "attractor", "share", "kind", "period", "word", "stability", *_coordinates)
        rows = [(float(Fraction(point.value)), k, a.share, a.kind, a.period, a.word, a.stability, *map(float, state))
                for point in self.points for k, (a, once) in enumerate(zip(point.attractors, point.once))
                for state in once]
        return _frame({name: [row[k] for row in rows] for k, name in enumerate(names)})


@dataclass(frozen=True, eq=False, repr=False)
class Basins(Drawn, Listed[Attractor]):
    """What the starts in a plane end on; a sequence of attractors, of which ``at`` says where each is met."""

    parameters: Dict[str, str]
    plane: Tuple[str, str]  #: the coordinates that vary: along rows, along columns
    most_periods: int  #: of the load, that a start is followed for
    attractors: Tuple[Attractor, ...]
    at: "numpy.ndarray"  #: shape (rows, columns), from below: the place in ``attractors`` of what the start ends on
    starts: "numpy.ndarray"  #: shape (rows, columns, 4): x1, x2, x1', x2'
    units: Optional[str] = None  #: "si": states in m and m/s, durations in s; None: the units of the data
    json: Dict[str, Any] = field(default_factory=dict, repr=False)  #: as attractors --plane --json prints it

    @classmethod
    def _from(cls, found: _core.Basins) -> "Basins":
        import numpy

        data = _json.loads(found.fields())
        basins = _given(cls, data, at=numpy.array(data["at"]) - 1, starts=found.starts(),
                        attractors=tuple(Attractor._from(a) for a in data["attractors"]),
                        json=_json.loads(found.json()))
        return _with(basins, found)

    def _items(self) -> Tuple[Attractor, ...]:
        return self.attractors

    def _title(self) -> str:
        return (f"the plane of {self.plane[0]} and {self.plane[1]}, {self.at.size} starts, "
                f"{_listed(self.parameters)}{_in(self.units)}")

    def to_frame(self) -> "pandas.DataFrame":
        """A row for each start: its state, the place of its attractor and what that is. Needs pandas."""
        ends = self.at.ravel()
        states = self.starts.reshape(-1, 4)
        told = {name: [getattr(self.attractors[k], name) for k in ends] for name in ("kind", "period", "word")}
        return _frame({**{name: states[:, k] for k, name in enumerate(_coordinates)}, "attractor": ends, **told})


@dataclass(frozen=True, eq=False)
class Event:
    """Where a motion changes from one phase to another."""

    t: float
    before: str  #: "slip", "overshoot" or "stick"
    after: str
    r: float  #: the friction at rest (4) then
    state: "numpy.ndarray"  #: x1, x2, x1', x2'


@dataclass(frozen=True, eq=False)
class Simulation:
    """A motion under the friction law (2), (4), in floats: it proves nothing. Arrays have a row per sample."""

    t: "numpy.ndarray" = field(repr=False)  #: shape (n,)
    state: "numpy.ndarray" = field(repr=False)  #: shape (n, 4): x1, x2, x1', x2'
    phase: "numpy.ndarray" = field(repr=False)  #: shape (n,), of text: "slip", "overshoot", "stick"
    r: "numpy.ndarray" = field(repr=False)  #: the friction at rest (4)
    u: "numpy.ndarray" = field(repr=False)  #: the friction force
    energy: "numpy.ndarray" = field(repr=False)
    shares: Dict[str, float]  #: of the time in each kind of phase
    events: int  #: how many changes of phase there were
    first_events: Tuple[Event, ...] = field(repr=False)
    last_events: Tuple[Event, ...] = field(repr=False)
    settles: Optional[Attractor] = None  #: what it settles on, where that was asked for and seen
    units: Optional[str] = None  #: "si": s, m, m/s, N and J; None: those of the data
    json: Dict[str, Any] = field(default_factory=dict, repr=False, compare=False)  #: as simulate --json prints it

    @classmethod
    def _from(cls, found: _core.Motion) -> "Simulation":
        import numpy

        data = _json.loads(found.fields())
        rows, phases = found.samples()
        events = data["events"]

        def made(listed: List[Dict[str, Any]]) -> Tuple[Event, ...]:
            return tuple(Event(e["t"], e["from"], e["to"], e["r"], numpy.array(e["state"])) for e in listed)

        return cls(t=rows[:, 0], state=rows[:, 1:5], phase=numpy.array(["slip", "overshoot", "stick"])[phases],
                   r=rows[:, 5], u=rows[:, 6], energy=rows[:, 7], shares=data["shares"], events=events["count"],
                   first_events=made(events["first"]), last_events=made(events.get("last", [])),
                   settles=Attractor._from(data["settles"]) if "settles" in data else None, units=data.get("units"), json=_json.loads(found.json()))

    def to_frame(self) -> "pandas.DataFrame":
        """The samples, a row each. Needs pandas."""
        states = {name: self.state[:, k] for k, name in enumerate(_coordinates)}
        return _frame({"t": self.t, **states, "phase": self.phase, "r": self.r, "u": self.u, "energy": self.energy})


@dataclass(frozen=True, repr=False)
class Claim(Row):
    """A statement, what became of its proof, and what the proof needs."""

    id: str
    status: str  #: "as_printed", "where_defined", "needs_hypotheses", "misprint_corrected", …
    meaning: str  #: the same in words
    words: str  #: what it says
    origin: str  #: whose it is: "paper", "reading", "converse", "new", "auxiliary"
    verdict: str  #: on the printed form: "proved", "refuted", …
    reason: str
    printed: Tuple[str, ...]  #: LaTeX
    corrected: Tuple[str, ...]  #: LaTeX; empty unless the printed form fails and another is proved
    hypotheses: Tuple[str, ...]  #: LaTeX: what must not vanish beyond what the paper says
    uses: Tuple[str, ...]  #: ids of the claims that the proof uses
    theorems: Tuple[str, ...]  #: of the kernel
    obeyed: str  #: whether there are values with which all it assumes holds: "theorem", "balls", "unknown", …

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "Claim":
        outcome = data["outcome"]

        def latex(key: str, where: Dict[str, Any]) -> Tuple[str, ...]:
            return tuple(item["latex"] for item in where[key])

        return cls(id=data["id"], status=data["status"], meaning=data["meaning"], words=data["words"],
                   origin=data["origin"], verdict=outcome["verdict"], reason=outcome["reason"],
                   printed=latex("printed", data),
                   corrected=latex("corrected", data), hypotheses=latex("hypotheses", outcome),
                   uses=tuple(outcome["uses"]), theorems=tuple(outcome["theorems"]),
                   obeyed=outcome["obeyed"])

    def _row(self) -> Dict[str, Any]:
        return dict(id=self.id, verdict=self.verdict, status=self.status, words=_short(self.words))

    def _repr_latex_(self) -> str:
        lines = [rf"\text{{({self.id}) {self.meaning}}}", *(self.corrected or self.printed)]
        lines += [h for h in self.hypotheses]
        return r"$$\begin{gathered}" + r"\\ ".join(lines) + r"\end{gathered}$$"


@dataclass(frozen=True, repr=False)
class Check(Listed[Claim]):
    """Claims in the paper's order, with what they come to; a sequence of claims."""

    claims: Tuple[Claim, ...]
    line: str  #: what they come to, in a sentence
    json: Dict[str, Any] = field(default_factory=dict, repr=False, compare=False)  #: as check --json prints it

    @classmethod
    def _from(cls, text: str) -> "Check":
        data = _json.loads(text)
        return cls(tuple(Claim._from(c) for place in data["places"] for c in place["claims"]),
                   data["summary"]["line"], data)

    def _items(self) -> Tuple[Claim, ...]:
        return self.claims

    def _title(self) -> str:
        return self.line
