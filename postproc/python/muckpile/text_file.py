# SPDX-License-Identifier: GPL-2.0-or-later
"""Whole files as bytes, as text and as JSON objects, and numbers in text.

Scope: files that a run or muckpile-post has written; these end with a line break, so that one that
does not was cut short.
"""

import json
import warnings
from pathlib import Path

import numpy as np

from muckpile.errors import ResultError

RUN_AGAIN = "run the input again, or copy the folder anew"


def read_bytes(path: Path) -> bytes:
    """The whole file. Raises ResultError if it is absent, empty or cut short."""
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        raise ResultError(f"{path}: is not there; give the folder of a run that has written it") from None
    except OSError as error:
        raise ResultError(f"{path}: cannot be read: {error.strerror}") from None
    if not data.endswith(b"\n"):
        what = "ends within a line, so it was cut short" if data else "is empty"
        raise ResultError(f"{path}: {what}; {RUN_AGAIN}")
    return data


def read_text(path: Path) -> str:
    """The same as text without a byte order mark. Raises ResultError if it is no UTF-8."""
    try:
        return read_bytes(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ResultError(f"{path}: is no text: {error.reason} at byte {error.start}") from None


def read_json(path: Path) -> dict:
    """A JSON object. Raises ResultError if the file holds anything else."""

    def refuse(word):
        raise ValueError(f"'{word}' is no number of JSON")

    try:
        value = json.loads(read_text(path), parse_constant=refuse)
    except (ValueError, RecursionError) as error:  # JSONDecodeError is a ValueError
        raise ResultError(f"{path}: is no JSON: {error}; {RUN_AGAIN}") from None
    if not isinstance(value, dict):
        raise ResultError(f"{path}: must be a JSON object, got {type(value).__name__}")
    return value


def numbers(text: bytes, count: int, kind: type, where: str) -> np.ndarray:
    """Exactly `count` finite numbers between blanks. `kind` is float or int, `where` stands before
    messages. Memory follows the length of the text, never `count`, which a damaged file may hold."""
    values = np.empty(0, kind)
    if text.strip():
        with warnings.catch_warnings():
            # This is how NumPy 1 says that it came upon what is no number; NumPy 2 raises.
            warnings.simplefilter("error", DeprecationWarning)
            try:
                values = np.fromstring(text, dtype=kind, sep=" ")
            except (DeprecationWarning, ValueError):
                raise ResultError(f"{where}: holds what is no number; {RUN_AGAIN}") from None
    if values.size != count:
        raise ResultError(f"{where}: must be {count} numbers, got {values.size}; {RUN_AGAIN}")
    if not np.isfinite(values).all():
        raise ResultError(f"{where}: numbers must be finite")
    return values
