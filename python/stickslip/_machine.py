"""A machine in SI units, as its file has it."""

from __future__ import annotations

import os as _os
from dataclasses import dataclass, field, fields
from typing import Dict, Optional, Tuple, Union

from . import _core
from ._core import UsageError
from ._exact import Exact, exact

#: A number, or for what varies the interval between two.
Along = Union[Exact, Tuple[Exact, Exact]]


def interval(name: str, value: Along) -> str:
    """The number as text that is read exactly; of a pair "A..B"."""
    return "..".join(exact(name, end) for end in value) if isinstance(value, tuple) else exact(name, value)


@dataclass(frozen=True)
class Machine:
    """A machine in SI units. Values are exact, as all parameters; each is under the name that it has in a file.

    Friction is either normal_force with two coefficients, friction_sliding and friction_at_rest, or
    friction_force_sliding and friction_force_at_rest. Friction at rest is not needed where it is a result.
    What is missing, and what does not go together, is said by the function that takes the machine.
    """

    m1: Optional[Along] = None  #: kg
    m2: Optional[Along] = None  #: kg
    k1: Optional[Along] = None  #: N/m, between wall and m1
    k2: Optional[Along] = None  #: N/m, between m1 and m2
    normal_force: Optional[Along] = None  #: N
    friction_at_rest: Optional[Along] = None  #: a coefficient
    friction_sliding: Optional[Along] = None  #: a coefficient
    friction_force_at_rest: Optional[Along] = None  #: N
    friction_force_sliding: Optional[Along] = None  #: N
    belt_velocity: Optional[Along] = None  #: m/s
    load_amplitude: Optional[Along] = None  #: N
    load_frequency: Optional[Along] = None  #: Hz
    load_phase: Optional[Along] = None  #: rad, at t = 0; for simulate
    name: str = field(default="machine", compare=False)  #: what sentences call it: its file, if it has one

    def values(self) -> Dict[str, str]:
        """What is given, as text under the names of a file. Raises TypeError for a float."""
        given = {f.name: getattr(self, f.name) for f in fields(self) if f.name != "name"}
        return {name: interval(name, value) for name, value in given.items() if value is not None}


def read_machine(file: Union[str, "_os.PathLike[str]"]) -> Machine:
    """The machine in SI units in a parameter file of the program, TOML with lines such as k1 = 1200.

    Raises InputOutputError when the file cannot be read, UsageError for what is no parameter, or no machine's.
    """
    name = _os.fspath(file)
    values = _core.machine_values(name)
    keys = [f.name for f in fields(Machine)]
    for key in values:
        if key not in keys:
            raise UsageError(f"{name}: {key} is not a value of a machine in SI units")
    return Machine(**values, name=name)
