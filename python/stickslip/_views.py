"""How results show themselves: in a few lines, as HTML, as a picture, as a data frame."""

from __future__ import annotations

from dataclasses import fields
from html import escape
from typing import TYPE_CHECKING, Any, Dict, Generic, Iterator, List, Optional, Tuple, TypeVar

from . import _core
from ._exact import Ball

if TYPE_CHECKING:
    import pandas

Item = TypeVar("Item")

_most_lines = 20  # of a text
_most_rows = 200  # of a table in HTML
_widest = 60  # of a cell of a text


def _cell(value: Any) -> str:
    if value is None:
        return ""
    return f"{value:.6g}" if isinstance(value, (Ball, float)) else str(value)


def _table(rows: List[Dict[str, Any]]) -> List[List[str]]:
    """The names and a line for each row, of what is there in some row."""
    names = [name for name in (rows[0] if rows else ()) if any(row[name] not in (None, "") for row in rows)]
    return [names, *([_cell(row[name]) for name in names] for row in rows)]


def short(text: str) -> str:
    """The beginning of a long text."""
    return text if len(text) <= _widest else text[:_widest - 1] + "…"


def html(title: str, rows: List[Dict[str, Any]], below: str = "") -> str:
    """A table with a row for each, under a title."""
    first, *lines = _table(rows[:_most_rows])
    more = f"<p>… and {len(rows) - _most_rows} more</p>" if len(rows) > _most_rows else ""
    head = "".join(f"<th>{escape(name)}</th>" for name in first)
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in line) + "</tr>" for line in lines)
    table = f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>" if rows else ""
    return f"<p>{escape(title)}</p>{table}{more}{below}"


def frame(columns: Dict[str, Any]) -> "pandas.DataFrame":
    """A data frame of these columns. Needs pandas."""
    import pandas

    return pandas.DataFrame(columns)


class Row:
    """A result that is told in a row of a table."""

    def _row(self) -> Dict[str, Any]:
        """The cells by their names: balls, numbers, texts; None where there is nothing to say."""
        raise NotImplementedError

    _aside: Tuple[str, ...] = ()  #: cells that only data frames have

    def _brief(self) -> Dict[str, Any]:
        return {name: value for name, value in self._row().items() if name not in self._aside}

    def __repr__(self) -> str:
        told = {name: _cell(value) for name, value in self._brief().items() if value not in (None, "")}
        return f"{type(self).__name__}({', '.join(f'{name}={cell}' for name, cell in told.items())})"


class Listed(Generic[Item]):
    """A sequence of results, each of which is told in a row."""

    def _items(self) -> Tuple[Item, ...]:
        raise NotImplementedError

    def _title(self) -> str:
        """The question, and how complete the answer is, in a line."""
        raise NotImplementedError

    def _rows(self) -> List[Dict[str, Any]]:
        return [item._brief() for item in self._items()]  # type: ignore

    def __len__(self) -> int:
        return len(self._items())

    def __iter__(self) -> Iterator[Item]:
        return iter(self._items())

    def __getitem__(self, index: int) -> Item:
        return self._items()[index]

    def __repr__(self) -> str:
        rows = self._rows()
        most = _most_lines - 3  # without the title, the names, and what is left out
        first, *lines = _table(rows[:most])
        table = [["", *first], *([str(k), *line] for k, line in enumerate(lines))] if rows else []
        widths = [max(map(len, column)) for column in zip(*table)]
        text = ["  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip() for line in table]
        left_out = [f"… and {len(rows) - most} more"] if len(rows) > most else []
        return "\n".join([f"{type(self).__name__}: {self._title()}", *text, *left_out])

    def _repr_html_(self) -> str:
        picture = self._repr_svg_() if isinstance(self, Drawn) else None
        return html(self._title(), self._rows(), picture or "")

    def to_frame(self) -> "pandas.DataFrame":
        """A row for each, of balls the floats next to their midpoints. Needs pandas."""
        rows = [item._row() for item in self._items()]  # type: ignore
        return frame({name: [row[name].approximate if isinstance(row[name], Ball) else row[name] for row in rows]
                      for name in (rows[0] if rows else ())})


class Drawn:
    """A result of which there is a picture; copied and pickled, it keeps what the picture is drawn from."""

    def _script(self) -> str:
        """For gnuplot; empty where there is nothing to draw."""
        return self.__dict__["_drawing"] if "_drawing" in self.__dict__ else self._found.script()  # type: ignore

    def svg(self) -> str:
        """The picture, drawn by gnuplot; empty where there is nothing to draw. Raises InputOutputError without it."""
        script = self._script()
        return _core.gnuplot(script) if script else ""

    def _repr_svg_(self) -> Optional[str]:
        """What can stand within a page: without the declaration of a file of its own."""
        if "_picture" not in self.__dict__:
            try:
                drawn = self.svg()
            except _core.InputOutputError:  # no gnuplot: the tables are there without it
                drawn = ""
            self.__dict__["_picture"] = drawn[drawn.index("<svg"):] if drawn else None
        return self.__dict__["_picture"]  # type: ignore

    def __getstate__(self) -> Dict[str, Any]:
        return {**{f.name: getattr(self, f.name) for f in fields(self)}, "_drawing": self._script()}  # type: ignore
