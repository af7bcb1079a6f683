"""Periodic orbits of dry-friction oscillators, proved; the motion simulated; a paper's statements checked.

>>> import stickslip
>>> found = stickslip.orbits("nonsticking", chi="0.3", eta=4, us="0.1", V="0.1", omega="0.6", p=1)
>>> found.complete, [orbit.stability for orbit in found.admissible]
(True, ['stable'])

The oscillator is that of M. Pascal, New limit cycles of dry friction oscillators under harmonic load,
Nonlinear Dynamics 70 (2012), in its dimensionless data: chi = k2/(k1 + k2), eta = m1/m2, us the slipping
friction, V the belt's velocity, omega and p frequency and amplitude of the load; ur is the friction at rest,
phi the load's phase. They are given exactly: as text ("0.1607", "1/3", or a box "0.5+-1e-4"), int, Fraction
or Decimal; a float is refused. ``example="S"`` (O, P) takes the paper's data; what is given replaces them.

``machine=Machine(m1="2.5", …)`` or ``machine=read_machine("machine.toml")`` is a machine in SI units: the data are
taken for it by (3), in a unit of length that ``json["machine"]`` of the result says. With ``units="si"`` results and
states are in s, m, m/s, N and J. A warning says what a question does not take of a machine.

Errors: UsageError and DomainError (both are ValueErrors), InputOutputError (an OSError), InternalError (a
RuntimeError), all of them stickslip.Error, with the program's sentences. Long work runs without Python's lock;
Ctrl-C ends it.
"""

from __future__ import annotations

import json as _json
import os as _os
import warnings as _warnings
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

from . import _core
from ._arguments import conduct as _conduct
from ._arguments import count as _count
from ._arguments import number as _number
from ._arguments import whole as _whole
from ._arguments import words as _words
from ._core import DomainError, Error, InputOutputError, InternalError, UsageError
from ._exact import Ball, ComplexBall, Exact, exact
from ._machine import Along, Machine, interval, read_machine
from ._results import (Atlas, Attractor, Attractors, Basins, Branch, Branches, BranchEnd, Change, Check, Claim,
                       Condition, Count, Diagram, DiagramPoint, Event, Neighbourhood, Orbit, Orbits, Piece, PureWord,
                       Simulation, Unresolved)

from ._tables import MachineInTables, Record

__all__ = [
    "MachineInTables", "Record", "orbits", "branch", "atlas", "attractors", "simulate", "check", "prove", "latex", "expressions", "Machine", "read_machine",
    "Ball", "ComplexBall", "Condition", "Neighbourhood", "Unresolved", "Orbit", "Orbits", "PureWord", "Change", "Piece", "BranchEnd", "Branch",
    "Count", "Branches", "Atlas", "Attractor", "Attractors", "DiagramPoint", "Diagram", "Basins", "Event", "Simulation",
    "Claim", "Check", "Error", "UsageError", "DomainError", "InputOutputError", "InternalError", "__version__"
]

__version__ = _core.version()

Error.__doc__ = "What all errors of this module are; its text is the program's sentence."
UsageError.__doc__ = "Something is missing, malformed, or not asked for in this way; a ValueError, too."
DomainError.__doc__ = "A parameter lies outside its domain, which the sentence names; a ValueError, too."
InputOutputError.__doc__ = "A file or another program failed; an OSError, too."
InternalError.__doc__ = "Engines disagree, or a rule of this program is broken; a RuntimeError, too."

_data = ("chi", "eta", "us", "V", "omega", "p")


def _asking(command: str, *places: str, parameters: Dict[str, Optional[Along]], needed: Sequence[str],
            example: Optional[str], machine: Optional[Machine] = None, **options: Any) -> _core.Asking:
    """What is asked. Raises UsageError for what is missing without an example and a machine."""
    texts = {name: interval(name, value) for name, value in parameters.items() if value is not None}
    missing = [name for name in needed if name not in texts]
    if missing and example is None and machine is None:
        raise UsageError(f"missing: {', '.join(missing)}; or take the data of the paper's example='S', 'O' or 'P'")
    typed = _words(command, *places, **texts, example=example or None,
                   params=None if machine is None else machine.name, **options)
    return _core.Asking(typed, None if machine is None else machine.values())


def _told(found: Any) -> Any:
    """What was found, after warnings of what was not taken."""
    _warn(found.left_out())
    return found


def _warn(sentences: Sequence[str], frames: int = 4) -> None:
    for sentence in sentences:
        _warnings.warn(sentence, stacklevel=frames)


def _state(name: str, state: Optional[Sequence[Union[Exact, float]]]) -> Optional[str]:
    if state is None:
        return None
    if len(state) != 4:
        raise UsageError(f"{name}: a state is four numbers x1, x2, x1', x2', not {len(state)}")
    return ",".join(_number(name, x) for x in state)


def _range(along: Optional[Tuple[str, Exact, Exact]]) -> List[Tuple[str, str]]:
    """A name and A..B, or nothing. Raises UsageError for anything else."""
    if along is None:
        return []
    if not isinstance(along, tuple) or len(along) != 3 or not isinstance(along[0], str):
        raise UsageError(f"along: {along!r} is not a name and two numbers, such as ('load_frequency', 7, 8)")
    return [(along[0], interval("along", along[1:]))]


def _ranges(along: Union[Tuple[str, Exact, Exact], Sequence[Tuple[str, Exact, Exact]], None]) -> List[Tuple[str, str]]:
    """Those of one, or of several in a list."""
    if along is None or isinstance(along, tuple) and along and isinstance(along[0], str):
        return _range(along)
    return [_range(one)[0] for one in along]


def _is_word(family: str) -> bool:
    return bool(family) and set(family) <= set("SOT")


def orbits(family: str, *, chi: Optional[Exact] = None, eta: Optional[Exact] = None, us: Optional[Exact] = None,
           V: Optional[Exact] = None, omega: Optional[Exact] = None, p: Optional[Exact] = None,
           phi: Optional[Exact] = None, ur: Optional[Exact] = None, example: Optional[str] = None,
           machine: Optional[Machine] = None, units: Optional[str] = None, digits: int = 20, period: int = 1,
           near: Optional[Sequence[Union[Exact, float]]] = None, neighbourhood: bool = False,
           jobs: Optional[int] = None) -> Union[Orbits, PureWord]:
    """All periodic orbits of a family, each proved to exist, with every condition decided.

    family: "symmetric" (Section 4; phi and ur are results), "overshooting" (Section 5; exactly one of phi and
    ur is given), "nonsticking" (Section 6 and any V; ur may be given); or a word of S (slip), O (overshoot), T
    (stick) such as "OTS": its orbits over `period` periods of the load at ur, near a state (x1, x2, x1', x2')
    or where random starts end; complete for up to four phases, OSOS aside, without `near`. Of "S", "O" or "T" alone,
    whose motions have one phase for ever, a PureWord: whether there are such motions.
    machine: in SI units, in place of the data; phi, in rad, goes with it. units: "si": values and `near` are
    in s, m, m/s and N; by default in the units of the data.
    digits: significant ones of each value, at most 2000. jobs: the most threads; the result is the same.
    neighbourhood: of each stable orbit also a proved set of starts that converge to it; takes a while.

    A parameter may be a box ("0.3+-1e-4", a Ball): then each orbit is proved for all its members.

    Raises UsageError for what is missing, malformed or not given for the family, DomainError for data outside
    the domain, TypeError for a float, KeyboardInterrupt after Ctrl-C.
    """
    is_word = _is_word(family)
    if not is_word and (near is not None or period != 1):
        raise UsageError(f"period and near are for words of phases, not for the family '{family}'")
    is_default = period == 1 and (not is_word or len(family) == 1)
    asking = _asking("orbits", family, needed=_data, example=example, machine=machine, units=units,
                     parameters=dict(chi=chi, eta=eta, us=us, V=V, omega=omega, p=p, phi=phi, ur=ur),
                     digits=_whole("digits", digits, 1, 2000), near=_state("near", near),
                     neighbourhood=bool(neighbourhood), period=None if is_default else _count("period", period, 100000))
    conduct = _conduct(jobs)
    if family in ("S", "O", "T"):
        return PureWord._from(_told(_core.pure_word(asking, conduct)))
    return Orbits._later(_told((_core.word_orbits if is_word else _core.orbits)(asking, conduct)))


def branch(family: str, *, chi: Optional[Along] = None, eta: Optional[Along] = None, us: Optional[Along] = None,
           V: Optional[Along] = None, omega: Optional[Along] = None, p: Optional[Along] = None,
           phi: Optional[Along] = None, ur: Optional[Along] = None, at: Optional[Exact] = None,
           example: Optional[str] = None, machine: Optional[Machine] = None, units: Optional[str] = None,
           along: Union[Tuple[str, Exact, Exact], Sequence[Tuple[str, Exact, Exact]], None] = None, period: int = 1,
           orbit: Optional[int] = None, near: Optional[Sequence[Union[Exact, float]]] = None, all: bool = False,
           parts: Optional[int] = None, jobs: Optional[int] = None) -> Union[Branches, Record]:
    """The orbits of a family over an interval of one parameter, and every change along them, enclosed and proved.

    family: as for orbits; of a word the branches of the orbits that are found at `at`, or else in the middle of
    the interval, are followed, and no others are looked for. One parameter is an interval: a pair of exact
    numbers, ("0.5", "0.6"), or text, "0.5..0.6"; the others are numbers.
    machine: in SI units, in place of the data. along: the parameter that varies, and its interval; of a machine
    also one of its values, ("load_frequency", 7, 8) in Hz, and then all results are in s, m, m/s and N; with
    units="si", which goes with such a value only, `near` is given in m and m/s, too.
    at: follow the branches of the orbits at this value of it only; otherwise all branches are looked for.
    Of a word: period, of the load; orbit: the K-th that orbits(word) lists, from 1; near: the orbit near the state
    (x1, x2, x1', x2') at load phase 0; all: those that are not admissible, too. along: of a list of several, its
    orbits at all data of that box, proved in so many parts, by default 500: a Record, as MachineInTables.branch has.

    Raises as orbits does.
    """
    ranges = _ranges(along)
    asking = _asking("branch", family, needed=() if along else _data, example=example, machine=machine, units=units,
                     parameters=dict(chi=chi, eta=eta, us=us, V=V, omega=omega, p=p, phi=phi, ur=ur),
                     along=ranges, at=None if at is None else _number("at", at),
                     period=None if period == 1 else _count("period", period, 100000),
                     orbit=_count("orbit", orbit, 10**6), near=_state("near", near), all=bool(all),
                     parts=_count("parts", parts, 10**6))
    if len(ranges) > 1:
        return Record(_json.loads(_core.branch_over_box(asking, _conduct(jobs))))
    return Branches._from(_told(_core.branch(asking, _conduct(jobs))))


def atlas(what: Union[str, "_os.PathLike[str]"], *, chi: Optional[Along] = None, eta: Optional[Along] = None,
          us: Optional[Along] = None, V: Optional[Along] = None, omega: Optional[Along] = None,
          p: Optional[Along] = None, phi: Optional[Along] = None, ur: Optional[Along] = None,
          example: Optional[str] = None, machine: Optional[Machine] = None,
          along: Union[Tuple[str, Exact, Exact], Sequence[Tuple[str, Exact, Exact]]] = (),
          resolution: int = 8, jobs: Optional[int] = None) -> Atlas:
    """How many orbits of a family there are over ranges of parameters, how many admissible and stable, box by box.

    what: "symmetric", "nonsticking" or "overshooting", with phi: the atlas is made. Or the HDF5 file that the
    program's atlas command wrote: it is read, and nothing else is given; that command can be interrupted and goes on.
    One to four parameters vary, each an interval, ("0.5", "0.6") or "0.5..0.6". Boxes that cannot be decided are
    halved, each side at most so many times as resolution says, at most 60.
    machine: in SI units, in place of the data; its values may be intervals. along: a parameter, or a value of the
    machine, such as ("load_frequency", 7, 8) in Hz, and its interval, or several of these: the axes are values of the
    machine, and what is said of a box holds for every machine in it.

    Raises as orbits does; InputOutputError for what is no atlas or does not cover its rectangle, or when the module
    was built without HDF5.
    """
    data = dict(chi=chi, eta=eta, us=us, V=V, omega=omega, p=p, phi=phi, ur=ur)
    ranges = _ranges(along)
    if _os.fspath(what) not in _core.families():
        if ranges or example or machine or any(value is not None for value in data.values()):
            raise UsageError(f"parameters are for an atlas that is made, of a family: '{_os.fspath(what)}' is read")
        return Atlas._from(_core.atlas(_os.fspath(what), _conduct(jobs)))
    asking = _asking("atlas", _os.fspath(what), parameters=data, needed=() if ranges else _data, example=example,
                     machine=machine, along=ranges, resolution=_whole("resolution", resolution, 1, 60))
    return Atlas._from(_told(_core.make_atlas(asking, _conduct(jobs))))


def attractors(*, chi: Optional[Exact] = None, eta: Optional[Exact] = None, us: Optional[Exact] = None,
               V: Optional[Exact] = None, omega: Optional[Exact] = None, p: Optional[Exact] = None,
               ur: Optional[Exact] = None, example: Optional[str] = None, machine: Optional[Machine] = None,
               units: Optional[str] = None, starts: Optional[int] = None, seed: Optional[int] = None,
               along: Optional[Tuple[str, Exact, Exact]] = None, values: Optional[int] = None,
               plane: Optional[Tuple[str, str]] = None, pixels: Optional[int] = None,
               through: Optional[Sequence[Union[Exact, float]]] = None, most_periods: int = 20000, digits: int = 20,
               neighbourhood: bool = False, jobs: Optional[int] = None) -> Union[Attractors, Diagram, Basins]:
    """What a machine does: the motions that random starts end on, each periodic one proved.

    starts: how many, by default 500; seed: of the random numbers, the same everywhere, by default 1; most_periods: of
    the load, that a start is followed for. The load is cos(omega t). What is quasi-periodic or irregular is
    distinguished by its Lyapunov exponent, which is a check, not a proof.
    machine: in SI units, in place of the data. units: "si": states, and `through`, are in m and m/s,
    durations are in s; by default in the units of the data.

    along: a parameter, or a value of the machine such as ("load_frequency", 2, 4) in Hz, and its interval: a Diagram
    of what starts end on at so many values of it, by default 41 with 50 starts each. Along a value of a machine
    states are in SI units in any case.
    plane: two of "x1", "x2", "x1'", "x2'": Basins of pixels x pixels starts in that plane, by default 60 x 60,
    through a state, by default in the middle of the random starts.
    neighbourhood: without these two, of each stable orbit also a proved set of starts that converge to it.

    Raises as orbits does.
    """
    if neighbourhood and plane is not None:
        raise UsageError("neighbourhood is not for a plane of the paper's two masses here: MachineInTables proves pixels")
    across = None if plane is None else ",".join(plane)
    asking = _asking("attractors", parameters=dict(chi=chi, eta=eta, us=us, V=V, omega=omega, p=p, ur=ur),
                     needed=(*_data, "ur"), example=example, machine=machine, units=units,
                     starts=_count("starts", starts, 100000), seed=_count("seed", seed, 10**9),
                     most_periods=_count("most_periods", most_periods, 10**9), digits=_count("digits", digits, 2000),
                     values=_count("values", values, 10000), pixels=_count("pixels", pixels, 1000),
                     through=_state("through", through), along=_range(along), plane=across,
                     neighbourhood=bool(neighbourhood))
    conduct = _conduct(jobs)
    if along is not None:
        return Diagram._from(_told(_core.diagram(asking, conduct)))
    if across is not None:
        return Basins._from(_told(_core.basins(asking, conduct)))
    return Attractors._from(_told(_core.attractors(asking, conduct)))


def simulate(state: Optional[Sequence[Union[Exact, float]]] = None, *, chi: Optional[Exact] = None,
             eta: Optional[Exact] = None, us: Optional[Exact] = None, V: Optional[Exact] = None,
             omega: Optional[Exact] = None, p: Optional[Exact] = None, ur: Optional[Exact] = None,
             phi: Optional[Exact] = None, example: Optional[str] = None, machine: Optional[Machine] = None,
             units: Optional[str] = None, orbit: Optional[str] = None,
             perturb: Optional[Sequence[Union[Exact, float]]] = None, periods: Union[Exact, float] = 100,
             every: Union[Exact, float, None] = None, settle: bool = False) -> Simulation:
    """The motion under the friction law (2), (4) from a state x1, x2, x1', x2' at t = 0, by closed forms, in floats.

    In place of the state: example, of the paper, where its orbit begins; or orbit, such as "symmetric:1": where
    that orbit of those that orbits("symmetric") lists begins, counted from 1. perturb is added to the start.
    phi: the load's phase at t = 0, in rad, by default 0, of an orbit its own, of a machine its load_phase; periods:
    of the load, how long; every: the time between samples, by default a 200th of a period. No event is missed, up
    to rounding. A simulation proves nothing, so state, perturb, periods and every may be floats.
    settle: the motion goes on from its end, and what it settles on is `settles`, if that is seen within a second or so.
    machine: in SI units, in place of the data. units: "si": state, perturb, every and the motion are in s, m,
    m/s, N and J; by default in the units of the data.

    Raises as orbits does. Warns of an orbit that is not admissible, which the motion leaves.
    """
    from_state = state is not None and machine is None and example is None and orbit is None
    if from_state and phi is None:
        phi = 0
    if state is not None and orbit is not None:
        raise UsageError("state and orbit do not go together")
    asking = _asking("simulate", parameters=dict(chi=chi, eta=eta, us=us, V=V, omega=omega, p=p, ur=ur, phi=phi),
                     needed=(*_data, "ur") if from_state else (), example=example, machine=machine, units=units,
                     orbit=orbit or None, state=_state("state", state), perturb=_state("perturb", perturb),
                     periods=_number("periods", periods), every=None if every is None else _number("every", every))
    return Simulation._from(_told(_core.simulate(asking, bool(settle), _conduct(None))))


def check(*ids: str, file: Union[str, "_os.PathLike[str]", None] = None, jobs: Optional[int] = None) -> Check:
    """Proves statements of the paper, or all of them, and says what became of each.

    ids: a statement ("44.H"), an equation with its parts ("47"), a place ("sec4", "A3"), a kind ("theorem"), an
    origin ("new"); nothing for all, which takes some seconds. file: of claims, whose paper takes the place of this one
    (doc/claims.md).

    Raises UsageError for what names nothing and for a file that cannot be understood, InputOutputError for one that
    cannot be read, KeyboardInterrupt after Ctrl-C.
    """
    return Check._from(_core.check(list(ids), "" if file is None else _os.fspath(file), _conduct(jobs)))


def prove(statement: str, *assumptions: str, symbols: Sequence[str] = ()) -> Claim:
    """Proves or refutes a statement of one's own in the paper's symbols, such as "H(2 t) = H(t)^2".

    assumptions: statements that it may use. symbols: names of further numbers. The notation is that of the program's
    prove command (doc/prove.md). verdict of the answer is "proved", under its hypotheses; "refuted", with values in
    reason and, where one change makes it true, the corrected form; or "undecided".

    Raises UsageError for what cannot be read, with the column; KeyboardInterrupt after Ctrl-C.
    """
    return Check._from(_core.prove(statement, list(assumptions), list(symbols), _conduct(None))).claims[0]


def latex(name: Optional[str] = None, *, unknowns: str = "chi", theorem: Optional[str] = None,
          orbit: Optional[str] = None, errata: bool = False, chi: Optional[Exact] = None,
          eta: Optional[Exact] = None, us: Optional[Exact] = None, V: Optional[Exact] = None,
          omega: Optional[Exact] = None, p: Optional[Exact] = None, phi: Optional[Exact] = None,
          ur: Optional[Exact] = None, example: Optional[str] = None, machine: Optional[Machine] = None,
          digits: Optional[int] = None) -> str:
    r"""A text in LaTeX, as the program prints it: exactly one of name, theorem, orbit and errata says which.

    name: one of expressions(), as a displayed equation for a document with amsmath; unknowns: "chi" (chi, eta and
    the abbreviations omega_j, lambda_j) or "omega" (the natural frequencies alone).
    theorem: the id of a result of the audit, after the proofs of its claims. errata: those of the paper, after all
    proofs, which take some seconds.
    orbit: "symmetric:1" is the first that orbits("symmetric") lists at the data, the example's or the machine's:
    its values to so many digits, by default 10, times dimensionless and lengths in the unit of us.

    Raises UsageError for an unknown name and for what is missing, DomainError for data outside the domain,
    KeyboardInterrupt after Ctrl-C.
    """
    if [name is not None, theorem is not None, orbit is not None, errata].count(True) != 1:
        raise UsageError("latex takes exactly one of a name, theorem, orbit and errata")
    if unknowns not in ("chi", "omega"):
        raise UsageError(f"unknowns: '{unknowns}' is neither chi nor omega")
    data = dict(chi=chi, eta=eta, us=us, V=V, omega=omega, p=p, phi=phi, ur=ur)
    if name is not None:
        if any(value is not None for value in (*data.values(), example, machine, digits)):
            raise UsageError("parameters and digits are for an orbit: an expression is for all parameters")
        return _core.latex(name, unknowns == "omega", _conduct(None))
    asking = _asking("latex", parameters=data, needed=() if orbit is None else _data, example=example, machine=machine,
                     theorem=theorem, orbit=orbit, errata=errata, digits=_count("digits", digits, 2000))
    text, left_out = _core.latex_text(asking, _conduct(None))
    _warn(left_out, 3)
    return text


def expressions() -> List[Tuple[str, str, str]]:
    """The derived expressions that latex() knows: name, number of the paper's equation, title."""
    return _core.expressions()
