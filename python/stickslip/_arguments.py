"""Arguments as the program takes them."""

from __future__ import annotations

import threading as _threading
from numbers import Integral as _Integral
from typing import Any, List, Optional, Sequence, Union

from . import _core
from ._core import UsageError
from ._exact import Exact, exact


def conduct(jobs: Optional[int]) -> _core.Conduct:
    threads = None if jobs is None else whole("jobs", jobs, 1, 1024)
    return _core.Conduct(threads, _threading.current_thread() is _threading.main_thread())


def whole(name: str, value: int, least: int, most: int) -> int:
    if not isinstance(value, _Integral) or not least <= value <= most:
        raise UsageError(f"{name}: {value!r} is not a whole number from {least} to {most}")
    return int(value)


def number(name: str, value: Union[Exact, float]) -> str:
    """As text; of what a proof does not need exactly, a float, too."""
    return repr(float(value)) if isinstance(value, float) else exact(name, value)  # NumPy's repr names its type


def count(name: str, value: Optional[int], most: int) -> Optional[int]:
    return None if value is None else whole(name, value, 1, most)


def words(command: str, *places: str, along: Sequence[Sequence[str]] = (), **options: Any) -> List[str]:
    """What is typed behind the program's name: options under their names, unless they are None or False."""
    typed = [command, *places]
    for name, value in options.items():
        if value is not None and value is not False:
            option = "--" + name.replace("_", "-")
            typed.append(option if value is True else f"{option}={value}")
    for name, ends in along:
        typed += ["--along", name, ends]
    for word in typed:
        if "\0" in word:  # where the program would take the word to end
            raise UsageError(f"{word!r} has a zero character")
    return typed
