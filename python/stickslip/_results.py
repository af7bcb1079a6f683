"""Results: what the functions of stickslip return, as dataclasses."""

from __future__ import annotations

import json as _json
from dataclasses import dataclass, field, fields
from functools import lru_cache as _lru_cache
from typing import TYPE_CHECKING, Any, Dict, FrozenSet, Iterator, List, Optional, Tuple

from ._exact import Ball, ComplexBall

if TYPE_CHECKING:
    import numpy


def _ball(data: Optional[Dict[str, str]]) -> Optional[Ball]:
    return None if data is None else Ball(data["mid"], data["rad"])


def _multipliers(data: Dict[str, Any]) -> Tuple[ComplexBall, ...]:
    return tuple(ComplexBall(Ball(**m["re"]), Ball(**m["im"])) for m in data.get("multipliers", []))


@_lru_cache(maxsize=None)
def _names(cls: Any) -> FrozenSet[str]:
    return frozenset(f.name for f in fields(cls))


def _given(cls: Any, data: Dict[str, Any], **more: Any) -> Any:
    """An object of the class with those of the data that are its fields."""
    names = _names(cls)
    return cls(**{**{key: value for key, value in data.items() if key in names}, **more})


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
class Unresolved:
    """A part of the search's domain that could not be decided."""

    reason: str
    where: Dict[str, Ball]


@dataclass(frozen=True)
class Orbit:
    """A periodic orbit that is proved to exist, with everything decided about it.

    Times and angles are dimensionless; lengths are in the unit of us, V and p. What the family does not have
    is None.
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

    _balls = ("tau", "tau1", "T", "Theta", "phi", "z10", "z20", "zdot10", "x10", "x20", "xdot10", "ur", "ur_max")

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "Orbit":
        conditions = tuple(
            _given(Condition, c, margin=_ball(c.get("margin")), at=_ball(c.get("at"))) for c in data["conditions"])
        return _given(cls, data, conditions=conditions, multipliers=_multipliers(data),
                      durations=tuple(Ball(**d) for d in data.get("durations", [])),
                      **{name: _ball(data.get(name)) for name in cls._balls})

    def _repr_latex_(self) -> str:
        names = {"tau": r"\tau", "tau1": r"\tau_1", "Theta": r"\Theta", "phi": r"\varphi", "ur": "u_r",
                 "ur_max": r"u_{r,\max}"}
        rows = [f"{names[n]} &= {getattr(self, n)._repr_latex_()[1:-1]}" for n in names if getattr(self, n)]
        return "$$\\begin{aligned}" + r"\\ ".join(rows) + "\\end{aligned}$$"


@dataclass(frozen=True)
class Orbits:
    """A list of orbits, and what is known of its completeness; a sequence of its orbits."""

    parameters: Dict[str, str]  #: exact decimals or fractions
    complete: bool  #: no orbit is missing
    orbits: Tuple[Orbit, ...]
    unresolved: Tuple[Unresolved, ...]
    family: Optional[str] = None
    word: Optional[str] = None  #: in place of a family
    period: Optional[int] = None  #: of a word, in periods of the load
    remarks: Tuple[str, ...] = ()
    seen: str = ""  #: of a word: what was met in place of an orbit
    json: Dict[str, Any] = field(default_factory=dict, repr=False, compare=False)  #: as orbits --json prints it
    _list: Any = field(default=None, repr=False, compare=False)

    @classmethod
    def _from(cls, text: str, found: Any = None) -> "Orbits":
        data = _json.loads(text)
        unresolved = tuple(
            Unresolved(part["reason"], {n: Ball(**b) for n, b in part.items() if isinstance(b, dict)})
            for part in data["unresolved"])
        return _given(cls, data, orbits=tuple(Orbit._from(o) for o in data["orbits"]), unresolved=unresolved,
                      remarks=tuple(data.get("remarks", [])), json=data, _list=found)

    def __len__(self) -> int:
        return len(self.orbits)

    def __iter__(self) -> Iterator[Orbit]:
        return iter(self.orbits)

    def __getitem__(self, index: int) -> Orbit:
        return self.orbits[index]

    @property
    def admissible(self) -> Tuple[Orbit, ...]:
        """The orbits that obey every condition."""
        return tuple(orbit for orbit in self.orbits if orbit.admissible)

    def svg(self) -> str:
        """Phase portraits and time histories, drawn by gnuplot; empty where there is no orbit to draw.

        Raises InputOutputError without gnuplot; for orbits of a word, of which there is no picture, TypeError.
        """
        if self._list is None:
            raise TypeError("there are pictures of the orbits of a family, not of a word")
        return self._list.svg()

    def _repr_svg_(self) -> Optional[str]:
        return (self.svg() or None) if self._list is not None else None


@dataclass(frozen=True)
class Attractor:
    """A motion that starts end on. A periodic one is proved."""

    kind: str  #: "periodic", "quasi-periodic", "irregular", "slides", "stuck" or "unsettled"
    count: int  #: how many starts end on it
    share: float
    share_interval: Tuple[float, float]  #: Wilson's, of 95 %
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

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "Attractor":
        import numpy

        return _given(cls, data, state=numpy.array(data["state"]), share_interval=tuple(data["share_interval"]),
                      durations=tuple(Ball(**d) for d in data.get("durations", [])), multipliers=_multipliers(data))


@dataclass(frozen=True)
class Attractors:
    """What a machine does, the most frequent first; a sequence of attractors."""

    parameters: Dict[str, str]
    starts: int
    seed: int
    simulated: int  #: periods of the load in all
    attractors: Tuple[Attractor, ...]
    json: Dict[str, Any] = field(default_factory=dict, repr=False, compare=False)  #: as attractors --json prints it

    @classmethod
    def _from(cls, text: str) -> "Attractors":
        data = _json.loads(text)
        return _given(cls, data, attractors=tuple(Attractor._from(a) for a in data["attractors"]), json=data)

    def __len__(self) -> int:
        return len(self.attractors)

    def __iter__(self) -> Iterator[Attractor]:
        return iter(self.attractors)

    def __getitem__(self, index: int) -> Attractor:
        return self.attractors[index]


@dataclass(frozen=True)
class Event:
    """Where a motion changes from one phase to another."""

    t: float
    before: str  #: "slip", "overshoot" or "stick"
    after: str
    r: float  #: the friction at rest (4) then
    state: "numpy.ndarray"  #: x1, x2, x1', x2'


@dataclass(frozen=True)
class Simulation:
    """A motion under the friction law (2), (4), in floats: it proves nothing. Arrays have a row per sample."""

    t: "numpy.ndarray"  #: shape (n,)
    state: "numpy.ndarray"  #: shape (n, 4): x1, x2, x1', x2'
    phase: "numpy.ndarray"  #: shape (n,), of text: "slip", "overshoot", "stick"
    r: "numpy.ndarray"  #: the friction at rest (4)
    u: "numpy.ndarray"  #: the friction force
    energy: "numpy.ndarray"
    shares: Dict[str, float]  #: of the time in each kind of phase
    events: int  #: how many changes of phase there were
    first_events: Tuple[Event, ...]
    last_events: Tuple[Event, ...]
    json: Dict[str, Any] = field(default_factory=dict, repr=False, compare=False)  #: as simulate --json prints it

    @classmethod
    def _from(cls, text: str, rows: "numpy.ndarray", phases: "numpy.ndarray") -> "Simulation":
        import numpy

        data = _json.loads(text)
        events = data["events"]

        def made(listed: List[Dict[str, Any]]) -> Tuple[Event, ...]:
            return tuple(Event(e["t"], e["from"], e["to"], e["r"], numpy.array(e["state"])) for e in listed)

        return cls(t=rows[:, 0], state=rows[:, 1:5], phase=numpy.array(["slip", "overshoot", "stick"])[phases],
                   r=rows[:, 5], u=rows[:, 6], energy=rows[:, 7], shares=data["shares"], events=events["count"],
                   first_events=made(events["first"]), last_events=made(events.get("last", [])), json=data)


@dataclass(frozen=True)
class Claim:
    """A statement, what became of its proof, and what the proof needs."""

    id: str
    status: str  #: "as_printed", "needs_hypotheses", "misprint_corrected", …
    meaning: str  #: the same in words
    words: str  #: what it says
    verdict: str  #: on the printed form: "proved", "refuted", …
    reason: str
    printed: Tuple[str, ...]  #: LaTeX
    corrected: Tuple[str, ...]  #: LaTeX; empty unless the printed form fails and another is proved
    hypotheses: Tuple[str, ...]  #: LaTeX: what must not vanish beyond what the paper says
    uses: Tuple[str, ...]  #: ids of the claims that the proof uses
    theorems: Tuple[str, ...]  #: of the kernel

    @classmethod
    def _from(cls, data: Dict[str, Any]) -> "Claim":
        outcome = data["outcome"]

        def latex(key: str, where: Dict[str, Any]) -> Tuple[str, ...]:
            return tuple(item["latex"] for item in where[key])

        return cls(id=data["id"], status=data["status"], meaning=data["meaning"], words=data["words"],
                   verdict=outcome["verdict"], reason=outcome["reason"], printed=latex("printed", data),
                   corrected=latex("corrected", data), hypotheses=latex("hypotheses", outcome),
                   uses=tuple(outcome["uses"]), theorems=tuple(outcome["theorems"]))

    def _repr_latex_(self) -> str:
        lines = [rf"\text{{({self.id}) {self.meaning}}}", *(self.corrected or self.printed)]
        lines += [h for h in self.hypotheses]
        return r"$$\begin{gathered}" + r"\\ ".join(lines) + r"\end{gathered}$$"


@dataclass(frozen=True)
class Check:
    """Claims in the paper's order, with what they come to; a sequence of claims."""

    claims: Tuple[Claim, ...]
    line: str  #: what they come to, in a sentence
    json: Dict[str, Any] = field(default_factory=dict, repr=False, compare=False)  #: as check --json prints it

    @classmethod
    def _from(cls, text: str) -> "Check":
        data = _json.loads(text)
        return cls(tuple(Claim._from(c) for place in data["places"] for c in place["claims"]),
                   data["summary"]["line"], data)

    def __len__(self) -> int:
        return len(self.claims)

    def __iter__(self) -> Iterator[Claim]:
        return iter(self.claims)

    def __getitem__(self, index: int) -> Claim:
        return self.claims[index]
