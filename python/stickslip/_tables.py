"""Machines of any number of masses, in tables."""

from __future__ import annotations

import json as _json
import os as _os
from typing import TYPE_CHECKING, Any, Dict, Iterator, Mapping, Optional, Sequence, Tuple, Union

from . import _core
from ._arguments import conduct, count, number, whole, words
from ._exact import Ball, Exact, exact
from ._machine import interval
from ._results import _value as _ball

if TYPE_CHECKING:
    import numpy

_Number = Union[Exact, float]
_Rectangle = Tuple[Tuple[Exact, Exact], Tuple[Exact, Exact]]
_Range = Tuple[str, Exact, Exact]


class Record(Mapping[str, Any]):
    """An object of a result, as the program's JSON has it (doc/formats.md): keys are attributes, too.

    Balls are Ball, pairs of them ComplexBall, lists tuples, other objects records.
    """

    def __init__(self, data: Dict[str, Any]) -> None:
        self._data = {key: _value(value) for key, value in data.items()}

    def __getitem__(self, key: str) -> Any:
        return self._data[key]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._data:
            raise AttributeError(f"there is no {name}: {', '.join(self.__dict__.get('_data', {}))}")
        return self._data[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __len__(self) -> int:
        return len(self._data)

    def __dir__(self) -> Sequence[str]:
        return [*super().__dir__(), *self._data]

    def __repr__(self) -> str:
        inside = ", ".join(f"{key}={value!r}" for key, value in self._data.items()
                           if isinstance(value, (str, int, float, bool, Ball)))
        return f"Record({inside})"


def _value(data: Any) -> Any:
    if isinstance(data, list):
        return tuple(map(_value, data))
    if not isinstance(data, dict):
        return data
    found = _ball(data)
    return Record(data) if found is data else found


def _text(name: str, value: Optional[_Number]) -> Optional[str]:
    return None if value is None else number(name, value)


def _ranges(*along: _Range) -> Sequence[Tuple[str, str]]:
    return [(path, interval("along", tuple(ends))) for path, *ends in along]


def _rectangle(name: str, starts: Optional[_Rectangle]) -> Optional[str]:
    return None if starts is None else ",".join(interval(name, side) for side in starts)


def _state(name: str, state: Optional[Sequence[_Number]]) -> Optional[str]:
    return None if state is None else ",".join(number(name, x) for x in state)


class MachineInTables:
    """A machine with any number of masses, dashpots, friction that changes with the velocity, several loads or none.

    file: TOML, as doc/any_machine.md says. States are positions and then velocities of all masses, at load phase 0.
    All methods raise InputOutputError, UsageError and DomainError as the program does, KeyboardInterrupt after Ctrl-C.
    """

    def __init__(self, file: Union[str, "_os.PathLike[str]"]) -> None:
        self.file = _os.fspath(file)
        _core.require_tables(self._asking("orbits"))

    def __repr__(self) -> str:
        return f"MachineInTables({self.file!r})"

    def attractors(self, starts: Optional[int] = None, seed: Optional[int] = None, most_periods: int = 20000,
                   digits: int = 20, along: Optional[_Range] = None, values: Optional[int] = None,
                   plane: Optional[Tuple[str, str]] = None, pixels: Optional[int] = None,
                   through: Optional[Sequence[_Number]] = None, window: Optional[Sequence[_Number]] = None,
                   neighbourhood: bool = False, jobs: Optional[int] = None) -> Record:
        """What random starts end on, by default 500, each periodic motion proved.

        along: one of the file's numbers and its interval, ("belt.velocity", "0.03", "0.08"): what 50 starts end on at
        so many values of it, by default 41. plane: two of "x1", ..., "x1'", ...: where pixels x pixels starts in that
        plane end, by default 60 x 60, through a state, by default in the middle of the random starts; window: how far
        the pixels go to each side of it. neighbourhood: of each stable orbit also a proved set of starts that converge
        to it, and in a plane which pixels are proved to end where they do.
        """
        asking = self._asking("attractors", starts=count("starts", starts, 100000), seed=count("seed", seed, 10**9),
                              most_periods=count("most_periods", most_periods, 10**9),
                              digits=whole("digits", digits, 1, 2000), along=_ranges(*([along] if along else [])),
                              values=count("values", values, 10000), plane=None if plane is None else ",".join(plane),
                              pixels=count("pixels", pixels, 1000), through=_state("through", through),
                              window=_state("window", window), neighbourhood=bool(neighbourhood))
        return Record(_json.loads(_core.attractors_in_tables(asking, conduct(jobs))))

    def orbits(self, word: str, period: Optional[int] = None, near: Optional[Sequence[_Number]] = None,
               digits: int = 20, neighbourhood: bool = False, basin: Optional[_Rectangle] = None,
               jobs: Optional[int] = None) -> Record:
        """The orbits through a word's phases that random starts end on, or that near one state, each proved.

        neighbourhood: of each stable one also a proved set of starts that converge to it.
        Of "S", steady sliding; basin: the share of starts that end in it, ((-2, 2), (0, 2)) of positions and
        velocities, of one mass without a load whose friction falls smoothly.
        """
        asking = self._asking("orbits", word, period=count("period", period, 100000), near=_state("near", near),
                              digits=whole("digits", digits, 1, 2000), neighbourhood=bool(neighbourhood),
                              basin=_rectangle("basin", basin))
        return Record(_json.loads(_core.orbits_in_tables(asking, conduct(jobs))))

    def branch(self, word: str, along: Union[_Range, Sequence[_Range]], at: Optional[Exact] = None,
               period: Optional[int] = None, orbit: Optional[int] = None,
               near: Optional[Sequence[_Number]] = None, all: bool = False, basin: Optional[_Rectangle] = None,
               without_gaps: bool = False, parts: Optional[int] = None, jobs: Optional[int] = None) -> Record:
        """The branches of these orbits along one of the file's numbers, ("belt.velocity", "0.03", "0.08").

        along: of a list of several, these orbits at all data of that box, proved in so many parts, by default 500.

        without_gaps: prove also between the values at which orbits are proved. Of "S", steady sliding along it;
        basin as of orbits.
        """
        asking = self._asking("branch", word, along=_ranges(*([along] if isinstance(along, tuple) and isinstance(along[0], str) else along)),
                              at=None if at is None else exact("at", at), period=count("period", period, 100000),
                              orbit=count("orbit", orbit, 10**6), near=_state("near", near), all=bool(all),
                              basin=_rectangle("basin", basin), without_gaps=bool(without_gaps),
                              parts=count("parts", parts, 10**6))
        return Record(_json.loads(_core.branch_in_tables(asking, conduct(jobs))))

    def simulate(self, state: Sequence[_Number], time: Optional[_Number] = None, periods: Optional[_Number] = None,
                 every: Optional[_Number] = None, phi: Optional[_Number] = None) -> Tuple[Record, "numpy.ndarray"]:
        """A motion in double: the record, and its samples in rows t, x, x', r, u, E. It proves nothing."""
        asking = self._asking("simulate", state=_state("state", state), time=_text("time", time),
                              periods=_text("periods", periods), every=_text("every", every), phi=_text("phi", phi))
        told, samples = _core.simulate_in_tables(asking, conduct(None))
        return Record(_json.loads(told)), samples

    def simulate_set(self, state: Sequence[_Number], half: Sequence[_Number], time: Optional[_Number] = None,
                     periods: Optional[_Number] = None, phi: Optional[_Number] = None) -> Record:
        """Where all motions from a box of starts, so far around a state, are after that time: proved, part by part."""
        asking = self._asking("simulate", state=_state("state", state), set=_state("half", half),
                              time=_text("time", time), periods=_text("periods", periods), phi=_text("phi", phi))
        return Record(_json.loads(_core.set_in_tables(asking, conduct(None))))

    def _asking(self, command: str, *places: str, **options: Any) -> _core.Asking:
        return _core.Asking(words(command, *places, params=self.file, **options), None)
