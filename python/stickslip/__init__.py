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

Errors: UsageError and DomainError (both are ValueErrors), InputOutputError (an OSError), InternalError (a
RuntimeError), all of them stickslip.Error, with the program's sentences. Long work runs without Python's lock;
Ctrl-C ends it.
"""

from __future__ import annotations

import os as _os
import threading as _threading
from numbers import Integral as _Integral
from typing import Dict, List, Optional, Sequence, Tuple, Union

from . import _core
from ._core import DomainError, Error, InputOutputError, InternalError, UsageError
from ._exact import Ball, ComplexBall, Exact, exact
from ._results import (Atlas, Attractor, Attractors, Branch, Branches, BranchEnd, Change, Check, Claim, Condition,
                       Count, Event, Orbit, Orbits, Piece, Simulation, Unresolved)

__all__ = [
    "orbits", "branch", "atlas", "attractors", "simulate", "check", "latex", "expressions", "Ball", "ComplexBall",
    "Condition", "Unresolved", "Orbit", "Orbits", "Change", "Piece", "BranchEnd", "Branch", "Count", "Branches",
    "Atlas", "Attractor", "Attractors", "Event", "Simulation", "Claim", "Check", "Error", "UsageError", "DomainError",
    "InputOutputError", "InternalError", "__version__"
]

__version__ = _core.version()

Error.__doc__ = "What all errors of this module are; its text is the program's sentence."
UsageError.__doc__ = "Something is missing, malformed, or not asked for in this way; a ValueError, too."
DomainError.__doc__ = "A parameter lies outside its domain, which the sentence names; a ValueError, too."
InputOutputError.__doc__ = "A file or another program failed; an OSError, too."
InternalError.__doc__ = "Engines disagree, or a rule of this program is broken; a RuntimeError, too."

#: A number, or for the one parameter that varies the interval between two.
Along = Union[Exact, Tuple[Exact, Exact]]

_data = ("chi", "eta", "us", "V", "omega", "p")


def _conduct(jobs: Optional[int]) -> _core.Conduct:
    threads = None if jobs is None else _whole("jobs", jobs, 1, 1024)
    return _core.Conduct(threads, _threading.current_thread() is _threading.main_thread())


def _parameters(example: Optional[str], needed: Sequence[str], given: Dict[str, Optional[Exact]]) -> Dict[str, str]:
    """What is given, as text. Raises UsageError for what is missing without an example."""
    texts = {name: exact(name, value) for name, value in given.items() if value is not None}
    missing = [name for name in needed if name not in texts]
    if missing and example is None:
        raise UsageError(f"missing: {', '.join(missing)}; or take the data of the paper's example='S', 'O' or 'P'")
    return texts


def _whole(name: str, value: int, least: int, most: int) -> int:
    if not isinstance(value, _Integral) or not least <= value <= most:
        raise UsageError(f"{name}: {value!r} is not a whole number from {least} to {most}")
    return int(value)


def _state(name: str, state: Sequence[Union[Exact, float]]) -> str:
    if len(state) != 4:
        raise UsageError(f"{name}: a state is four numbers x1, x2, x1', x2', not {len(state)}")
    return ",".join(repr(x) if isinstance(x, float) else exact(name, x) for x in state)


def _is_word(family: str) -> bool:
    return bool(family) and set(family) <= set("SOT")


def orbits(family: str, *, chi: Optional[Exact] = None, eta: Optional[Exact] = None, us: Optional[Exact] = None,
           V: Optional[Exact] = None, omega: Optional[Exact] = None, p: Optional[Exact] = None,
           phi: Optional[Exact] = None, ur: Optional[Exact] = None, example: Optional[str] = None,
           digits: int = 20, period: int = 1, near: Optional[Sequence[Union[Exact, float]]] = None,
           jobs: Optional[int] = None) -> Orbits:
    """All periodic orbits of a family, each proved to exist, with every condition decided.

    family: "symmetric" (Section 4; phi and ur are results), "overshooting" (Section 5; exactly one of phi and
    ur is given), "nonsticking" (Section 6 and any V; ur may be given); or a word of S (slip), O (overshoot), T
    (stick) such as "OTS": its orbits over `period` periods of the load at ur, near a state (x1, x2, x1', x2')
    or where random starts end; complete for up to four phases, OSOS aside, without `near`.
    digits: significant ones of each value, at most 2000. jobs: the most threads; the result is the same.

    A parameter may be a box ("0.3+-1e-4", a Ball): then each orbit is proved for all its members.

    Raises UsageError for what is missing, malformed or not given for the family, DomainError for data outside
    the domain, TypeError for a float, KeyboardInterrupt after Ctrl-C.
    """
    parameters = _parameters(example, _data, dict(chi=chi, eta=eta, us=us, V=V, omega=omega, p=p, phi=phi, ur=ur))
    conduct = _conduct(jobs)
    if _is_word(family):
        return Orbits._later(
            _core.word_orbits(family, _whole("period", period, 1, 100000),
                              None if near is None else _state("near", near), parameters, example or "",
                              _whole("digits", digits, 1, 2000), conduct))
    if near is not None or period != 1:
        raise UsageError(f"period and near are for words of phases, not for the family '{family}'")
    return Orbits._later(_core.orbits(family, parameters, example or "", _whole("digits", digits, 1, 2000), conduct))


def branch(family: str, *, chi: Optional[Along] = None, eta: Optional[Along] = None, us: Optional[Along] = None,
           V: Optional[Along] = None, omega: Optional[Along] = None, p: Optional[Along] = None,
           phi: Optional[Along] = None, ur: Optional[Along] = None, at: Optional[Exact] = None,
           example: Optional[str] = None, period: int = 1, jobs: Optional[int] = None) -> Branches:
    """The orbits of a family over an interval of one parameter, and every change along them, enclosed and proved.

    family: as for orbits; of a word the branches of the orbits that are found at `at`, or else in the middle of
    the interval, are followed, and no others are looked for. One parameter is an interval: a pair of exact
    numbers, ("0.5", "0.6"), or text, "0.5..0.6"; the others are numbers.
    at: follow the branches of the orbits at this value of it only; otherwise all branches are looked for.

    Raises as orbits does.
    """
    given = dict(chi=chi, eta=eta, us=us, V=V, omega=omega, p=p, phi=phi, ur=ur)
    texts = {name: "..".join(exact(name, end) for end in value) if isinstance(value, tuple) else value
             for name, value in given.items()}
    parameters = _parameters(example, _data, texts)
    where = "" if at is None else exact("at", at)
    if _is_word(family):
        return Branches._from(_core.word_branch(family, _whole("period", period, 1, 100000), parameters,
                                                example or "", where, _conduct(jobs)))
    if period != 1:
        raise UsageError(f"period is for words of phases, not for the family '{family}'")
    return Branches._from(_core.branch(family, parameters, example or "", where, _conduct(jobs)))


def atlas(file: Union[str, "_os.PathLike[str]"]) -> Atlas:
    """What an atlas says, from the HDF5 file that the program's atlas command wrote.

    Raises InputOutputError for what is no atlas or does not cover its rectangle, or when the module was built
    without HDF5.
    """
    return Atlas._from(_core.atlas(_os.fspath(file), _conduct(None)))


def attractors(*, chi: Optional[Exact] = None, eta: Optional[Exact] = None, us: Optional[Exact] = None,
               V: Optional[Exact] = None, omega: Optional[Exact] = None, p: Optional[Exact] = None,
               ur: Optional[Exact] = None, example: Optional[str] = None, starts: int = 500, seed: int = 1,
               most_periods: int = 20000, digits: int = 20, jobs: Optional[int] = None) -> Attractors:
    """What a machine does: the motions that random starts end on, each periodic one proved.

    starts: how many; seed: of the random numbers, the same everywhere; most_periods: of the load, that a start
    is followed for. The load is cos(omega t). What is quasi-periodic or irregular is distinguished by its Lyapunov
    exponent, which is a check and no proof.

    Raises as orbits does.
    """
    parameters = _parameters(example, (*_data, "ur"), dict(chi=chi, eta=eta, us=us, V=V, omega=omega, p=p, ur=ur))
    return Attractors._from(
        _core.attractors(parameters, example or "", _whole("starts", starts, 1, 100000),
                         _whole("seed", seed, 0, 10**9), _whole("most_periods", most_periods, 1, 10**9),
                         _whole("digits", digits, 1, 2000), _conduct(jobs)))


def simulate(state: Sequence[Union[Exact, float]], *, chi: Exact, eta: Exact, us: Exact, V: Exact, omega: Exact,
             p: Exact, ur: Exact, phi: Exact = 0, periods: Union[Exact, float] = 100,
             every: Union[Exact, float, None] = None) -> Simulation:
    """The motion under the friction law (2), (4) from a state x1, x2, x1', x2' at t = 0, by closed forms, in floats.

    phi: the load's phase at t = 0, in rad; periods: of the load, how long; every: the time between samples, by
    default a 200th of a period. No event is missed, up to rounding. A simulation proves nothing, so state,
    periods and every may be floats.

    Raises as orbits does.
    """
    def text(name: str, value: Union[Exact, float]) -> str:
        return repr(value) if isinstance(value, float) else exact(name, value)

    parameters = _parameters(None, (), dict(chi=chi, eta=eta, us=us, V=V, omega=omega, p=p, ur=ur, phi=phi))
    return Simulation._from(
        *_core.simulate(parameters, _state("state", state), text("periods", periods),
                        "" if every is None else text("every", every), _conduct(None)))


def check(*ids: str, jobs: Optional[int] = None) -> Check:
    """Proves statements of the paper, or all of them, and says what became of each.

    ids: a statement ("44.H"), an equation with its parts ("47"), a place ("sec4", "A3"), a kind ("theorem"), an
    origin ("new"); nothing for all, which takes some seconds.

    Raises UsageError for what names nothing, KeyboardInterrupt after Ctrl-C.
    """
    return Check._from(_core.check(list(ids), _conduct(jobs)))


def latex(name: str, *, unknowns: str = "chi") -> str:
    r"""A derived expression as a displayed equation for a document with amsmath.

    name: one of expressions(); unknowns: "chi" (chi, eta and the abbreviations omega_j, lambda_j) or "omega"
    (the natural frequencies alone).

    Raises UsageError for an unknown name.
    """
    if unknowns not in ("chi", "omega"):
        raise UsageError(f"unknowns: '{unknowns}' is neither chi nor omega")
    return _core.latex(name, unknowns == "omega", _conduct(None))


def expressions() -> List[Tuple[str, str, str]]:
    """The derived expressions that latex() knows: name, number of the paper's equation, title."""
    return _core.expressions()
