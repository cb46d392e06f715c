# SPDX-License-Identifier: GPL-2.0-or-later
"""Where every block is at one instant, from dump/blocks_<step>.csv or .bin.

Scope: every block of blocks.vtk has exactly one row; nothing is interpolated.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from muckpile.blocks import Blocks
from muckpile.errors import ResultError
from muckpile.table import load_table
from muckpile.text_file import RUN_AGAIN

# Nine digits of text leave a unit quaternion within 1e-8; a wrong column is off by far more.
UNIT_TOLERANCE = 1e-4

# Packed rows, as `form packed` of fix muckpile/dump writes them behind the first two lines.
PACKED_HEADER = (b"packed i4 id f8 x_m y_m z_m i4/2147483647 qw qx qy qz f4 vx_m_s vy_m_s vz_m_s "
                 b"wx_rad_s wy_rad_s wz_rad_s i4 fragment_id f4 broken_fraction\n")
PACKED_ROW = np.dtype([("id", "<i4"), ("position", "<f8", 3), ("rotation", "<i4", 4), ("velocity", "<f4", 3),
                       ("spin", "<f4", 3), ("fragment", "<i4"), ("broken_fraction", "<f4")])


@dataclass(frozen=True)
class Snapshot:
    """State of n blocks at one time; row b of each array is block b of the run's Blocks."""

    step: int
    time: float  # [s]
    position: np.ndarray  # (n, 3) mass centres [m]
    rotation: np.ndarray  # (n, 4) unit quaternions w, x, y, z from the start orientation
    velocity: np.ndarray  # (n, 3) of the mass centres [m/s]
    spin: np.ndarray  # (n, 3) in the axes of space [rad/s]
    fragment: np.ndarray  # (n,) smallest block id of the fragment that the block is part of
    broken_fraction: np.ndarray  # (n,) broken share of the block's joint area, 0 to 1


def snapshot_files(dump: Path) -> list[Path]:
    """The files blocks_<step>.csv and .bin of a dump folder in order of step."""
    found = [(int(match[1]), path) for path in dump.iterdir()
             if (match := re.fullmatch(r"blocks_([0-9]{1,18})\.(?:csv|bin)", path.name))]
    return [path for _, path in sorted(found)]


def step_and_time(line: str, path: Path) -> tuple[int, float]:
    """Step and time [s] in the first line of a snapshot."""
    match = re.match(r"# *step=([0-9]{1,18}) time_s=([-+.0-9e]+)(?: |$)", line)
    try:
        step, time = int(match[1]), float(match[2])
    except (TypeError, ValueError):
        raise ResultError(f"{path}: the first line must hold '# step=<n> time_s=<t>'; {RUN_AGAIN}") from None
    if not np.isfinite(time):
        raise ResultError(f"{path}: time_s must be a finite number, got '{match[2]}'")
    return step, time


def read_snapshot(path: Path, blocks: Blocks) -> Snapshot:
    """The state of all blocks, in their order.

    Raises ResultError, naming file and line, on a malformed row, an unknown or repeated id, or a
    block without a row.
    """
    if path.suffix == ".bin":
        return _read_packed(path, blocks)
    table = load_table(path, words=())
    step, time = step_and_time(f"#{table.remarks[0]}" if table.remarks else "", path)
    return Snapshot(
        step=step, time=time,
        **_states(blocks, table.column("id"), table.where, path,
                  position=table.columns("x_m", "y_m", "z_m"),
                  rotation=table.columns("qw", "qx", "qy", "qz"),
                  velocity=table.columns("vx_m_s", "vy_m_s", "vz_m_s"),
                  spin=table.columns("wx_rad_s", "wy_rad_s", "wz_rad_s"),
                  fragment=table.column("fragment_id"),
                  broken_fraction=table.column("broken_fraction")))


def _read_packed(path: Path, blocks: Blocks) -> Snapshot:
    first, _, behind = path.read_bytes().partition(b"\n")
    step, time = step_and_time(first.decode("ascii", "replace"), path)
    data = behind.removeprefix(PACKED_HEADER)
    if len(data) == len(behind) or len(data) % PACKED_ROW.itemsize:
        raise ResultError(f"{path}: packed rows must stand behind their header, each of "
                          f"{PACKED_ROW.itemsize} bytes; {RUN_AGAIN}")
    rows = np.frombuffer(data, PACKED_ROW)
    fields = {name: rows[name] for name in PACKED_ROW.names if name != "id"}
    for name in ("position", "rotation", "velocity", "spin", "broken_fraction"):
        fields[name] = fields[name].astype(float)
        sound = np.isfinite(fields[name])
        for wrong in np.flatnonzero(~(sound if sound.ndim == 1 else sound.all(axis=1)))[:1]:
            raise ResultError(f"{path}: row {wrong + 1}: {name} must be finite numbers; {RUN_AGAIN}")
    fields["rotation"] /= 2147483647
    return Snapshot(step=step, time=time,
                    **_states(blocks, rows["id"], lambda row: f"{path}: row {row + 1}: ", path, **fields))


def _states(blocks: Blocks, ids: np.ndarray, where: Callable[[int], str], path: Path,
            rotation: np.ndarray, **fields: np.ndarray) -> dict[str, np.ndarray]:
    """The rows in the order of the blocks, quaternions of length 1."""
    row = _rows_of(ids, blocks, where, path)
    length = np.sqrt((rotation**2).sum(axis=1))
    for wrong in np.flatnonzero(np.abs(length - 1.0) > UNIT_TOLERANCE)[:1]:
        raise ResultError(f"{where(wrong)}qw, qx, qy, qz must be a unit quaternion, got length "
                          f"'{length[wrong]:.6g}'")
    states = {name: values[row] for name, values in fields.items()}
    return {"rotation": (rotation / length[:, None])[row], **states}


def _rows_of(ids: np.ndarray, blocks: Blocks, where: Callable[[int], str], path: Path) -> np.ndarray:
    """The row of each block."""
    row = np.argsort(ids, kind="stable")
    ordered = ids[row]
    for wrong in row[1:][np.diff(ordered) == 0][:1]:
        raise ResultError(f"{where(wrong)}id {ids[wrong]} occurs twice")
    for wrong in np.flatnonzero(~np.isin(ids, blocks.id))[:1]:
        raise ResultError(f"{where(wrong)}id {ids[wrong]} is not a block of blocks.vtk")
    for missing in blocks.id[~np.isin(blocks.id, ids)][:1]:
        raise ResultError(f"{path}: block {missing} has no row; {RUN_AGAIN}")
    return row
