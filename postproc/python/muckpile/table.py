# SPDX-License-Identifier: GPL-2.0-or-later
"""Comma-separated tables as structured NumPy arrays.

Scope: one header line, rows of numbers or words without quotes, `#` lines kept as remarks: what a
run and muckpile-post write.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from muckpile.errors import ResultError
from muckpile.text_file import read_text

# Columns that hold words, and those that hold whole numbers, in any table of a run.
WORDS = ("phase", "run_id", "polygon", "hole", "figure", "variable", "state", "folder")
WHOLE = ("id", "step", "blocks", "joints", "joints_broken", "fragment_id", "in_pile")


@dataclass(frozen=True)
class Table:
    """A table with what its messages need."""

    path: Path
    remarks: list[str]  # without the '#'
    lines: list[int]  # line number of each row, from 1
    rows: np.ndarray  # (rows,) structured: a field per column, of float64, int64 or text

    def where(self, row: int) -> str:
        """ "<file>:<line>: " for a message about a row."""
        return f"{self.path}:{self.lines[row]}: "

    def column(self, name: str) -> np.ndarray:
        """A column (rows,). Raises ResultError if the table lacks it."""
        if name not in self.rows.dtype.names:
            raise ResultError(f"{self.path}: has no column '{name}'")
        return self.rows[name]

    def columns(self, *names: str) -> np.ndarray:
        """Several columns of numbers side by side, (rows, names)."""
        return np.stack([self.column(name) for name in names], axis=1)


def read_table(path: str | Path, words: tuple[str, ...] = WORDS) -> np.ndarray:
    """A comma-separated table as a structured array (rows,): `table["time_s"]` is a column.

    Units stand in the names of the columns. `words` names the columns that hold words. An empty
    field, which stands for "no measure", is NaN. Raises ResultError, naming file and line, on
    ragged rows and on fields that are no finite number.
    """
    return load_table(Path(path), words, may_be_empty=True).rows


def load_table(path: Path, words: tuple[str, ...] = WORDS, may_be_empty: bool = False) -> Table:
    """The same with remarks and line numbers; `may_be_empty` lets fields of numbers be empty."""
    remarks, lines, header, texts = [], [], None, []
    for number, line in enumerate(read_text(path).splitlines(), 1):
        if not line.strip():
            continue
        if line.startswith("#"):
            remarks.append(line[1:])
        elif header is None:
            header = [name.strip() for name in line.split(",")]
        else:
            fields = line.count(",") + 1
            if fields != len(header):
                raise ResultError(f"{path}:{number}: must have {len(header)} fields, got {fields}")
            lines.append(number)
            texts.append(line)
    if header is None:
        raise ResultError(f"{path}: has no header line")
    if len(set(header)) != len(header) or "" in header:
        raise ResultError(f"{path}: each column must have a name of its own, got {header}")
    table = Table(path, remarks, lines, _empty_rows(header, words, texts))
    _fill_numbers(table, texts, may_be_empty)
    return table


def _empty_rows(header: list[str], words: tuple[str, ...], texts: list[str]) -> np.ndarray:
    """Rows with their words filled in; numbers are still to come."""
    fields = {}
    for place, name in enumerate(header):
        if name in words:
            fields[name] = np.array([text.split(",")[place].strip() for text in texts], dtype=str)
    kinds = [(name, fields[name].dtype if name in fields else np.int64 if name in WHOLE else float)
             for name in header]
    rows = np.zeros(len(texts), dtype=kinds)
    for name, values in fields.items():
        rows[name] = values
    return rows


def _fill_numbers(table: Table, texts: list[str], may_be_empty: bool) -> None:
    names = table.rows.dtype.names
    places = [place for place, name in enumerate(names) if table.rows.dtype[name].kind != "U"]
    if not texts or not places:
        return
    if may_be_empty:
        texts = [",".join(field if field.strip() else "nan" for field in text.split(","))
                 for text in texts]
    try:
        values = np.loadtxt(texts, delimiter=",", comments=None, usecols=places, ndmin=2)
    except ValueError as error:
        raise _fault(table, texts, places, str(error)) from None
    bad = np.isinf(values) if may_be_empty else ~np.isfinite(values)
    for column, place in enumerate(places):
        name = names[place]
        if name in WHOLE:
            bad[:, column] |= values[:, column] != np.rint(values[:, column])
            # Larger ones would not be exact as float64.
            bad[:, column] |= ~(np.abs(values[:, column]) < 2.0**53)
    if bad.any():
        row, column = np.argwhere(bad)[0]
        raise _not_a_number(table, row, names[places[column]], texts[row].split(",")[places[column]])
    for column, place in enumerate(places):
        table.rows[names[place]] = values[:, column]


def _not_a_number(table: Table, row: int, name: str, text: str) -> ResultError:
    kind = "whole" if name in WHOLE else "finite"
    return ResultError(f"{table.where(row)}{name} must be a {kind} number, got '{text.strip()}'")


def _fault(table: Table, texts: list[str], places: list[int], reason: str) -> ResultError:
    """The first field that is no number, after NumPy has refused the whole."""
    for row, text in enumerate(texts):
        fields = text.split(",")
        for place in places:
            try:
                float(fields[place])
            except ValueError:
                return _not_a_number(table, row, table.rows.dtype.names[place], fields[place])
    return ResultError(f"{table.path}: holds what is no number: {reason}")
