# SPDX-License-Identifier: GPL-2.0-or-later
"""Which run wrote the files of a dump folder, by the run id that each of them carries.

Scope: the rule of muckpile-post: blocks.vtk, run.json, history.csv, gauges.csv, burden.csv, joints.csv, the snapshots,
and scene.json where it has an id; files that are not there are no strangers.
"""

import re
from itertools import islice
from pathlib import Path

from muckpile.errors import ResultError
from muckpile.snapshot import snapshot_files
from muckpile.table import load_table
from muckpile.text_file import read_json

ID = "[0-9a-f]{16}"


def first_lines(path: Path, count: int) -> list[str]:
    """The first lines of a file; fewer where it has fewer, which is no error."""
    try:
        with path.open(encoding="utf-8", errors="replace") as file:
            return [line[:1000].rstrip("\n") for line in islice(file, count)]
    except OSError as error:
        raise ResultError(f"{path}: cannot be read: {error.strerror}") from None


def _id_in(line: str) -> str:
    """The id behind the first word run=<id>; "" if there is none."""
    found = re.search(rf"(?<!\S)run=({ID})(?!\S)", line)
    return found[1] if found else ""


def id_in_json(content: dict) -> str:
    """The run_id of an object; "" if it has none."""
    word = content.get("run_id")
    return word if isinstance(word, str) and re.fullmatch(ID, word) else ""


def _ids_of_table(path: Path) -> list[tuple[str, str]]:
    """One for each change of id: a second run may have gone on writing at the end."""
    table = load_table(path, may_be_empty=True)
    if "run_id" not in table.rows.dtype.names:
        return [(str(path), "")]
    found, before = [], None
    for row, word in enumerate(table.rows["run_id"].tolist()):
        if word != before:
            where = str(path) if row == 0 else table.where(row)[:-2]
            found.append((where, word if re.fullmatch(ID, word) else ""))
        before = word
    return found


def _origins(dump: Path) -> list[tuple[str, str]]:
    """Each file and the id that it carries, "" without one."""
    found = []
    blocks, record, scene = dump / "blocks.vtk", dump / "run.json", dump / "scene.json"
    if blocks.exists():
        found.append((str(blocks), _id_in("".join(first_lines(blocks, 2)[1:]))))
    if record.exists():
        found.append((str(record), id_in_json(read_json(record))))
    # A script that prints this file by itself gives it no id.
    if scene.exists() and (word := id_in_json(read_json(scene))):
        found.append((str(scene), word))
    for name in ("history.csv", "gauges.csv", "burden.csv"):
        if (dump / name).exists():
            found += _ids_of_table(dump / name)
    joints = [dump / "joints.csv"] if (dump / "joints.csv").exists() else []
    for path in joints + snapshot_files(dump):
        found.append((str(path), _id_in("".join(first_lines(path, 1)))))
    return found


def run_id_of(dump: Path) -> str:
    """The id that all files carry; "" where none has one.

    Raises ResultError, naming two files and what they carry, where ids differ or only some files
    have one: what two runs have left in one folder is not to be measured as one.
    """
    origins = _origins(dump)
    known = next((origin for origin in origins if origin[1]), None)
    if known is None:
        return ""
    for file, word in origins:
        if word != known[1]:
            said = f"is of run {word}" if word else "has no run id"
            raise ResultError(
                f"{file} {said}, but {known[0]} is of run {known[1]}: files of two runs lie in one "
                "folder; run the input again into a folder that is empty, or take away what the "
                "other run has left")
    return known[1]
