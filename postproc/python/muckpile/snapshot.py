# SPDX-License-Identifier: GPL-2.0-or-later
"""Where every block is at one instant, from dump/blocks_<step>.csv.

Scope: every block of blocks.vtk has exactly one row; nothing is interpolated.
"""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from muckpile.blocks import Blocks
from muckpile.errors import ResultError
from muckpile.table import Table, load_table
from muckpile.text_file import RUN_AGAIN

# Nine digits of text leave a unit quaternion within 1e-8; a wrong column is off by far more.
UNIT_TOLERANCE = 1e-4


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
    """The files blocks_<step>.csv of a dump folder in order of step."""
    found = [(int(match[1]), path) for path in dump.iterdir()
             if (match := re.fullmatch(r"blocks_([0-9]{1,18})\.csv", path.name))]
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
    table = load_table(path, words=())
    step, time = step_and_time(f"#{table.remarks[0]}" if table.remarks else "", path)
    row = _rows_of(table, blocks)
    rotation = table.columns("qw", "qx", "qy", "qz")
    length = np.sqrt((rotation**2).sum(axis=1))
    for wrong in np.flatnonzero(np.abs(length - 1.0) > UNIT_TOLERANCE)[:1]:
        raise ResultError(f"{table.where(wrong)}qw, qx, qy, qz must be a unit quaternion, got length "
                          f"'{length[wrong]:.6g}'")
    return Snapshot(
        step=step, time=time,
        position=table.columns("x_m", "y_m", "z_m")[row],
        rotation=(rotation / length[:, None])[row],
        velocity=table.columns("vx_m_s", "vy_m_s", "vz_m_s")[row],
        spin=table.columns("wx_rad_s", "wy_rad_s", "wz_rad_s")[row],
        fragment=table.column("fragment_id")[row],
        broken_fraction=table.column("broken_fraction")[row])


def _rows_of(table: Table, blocks: Blocks) -> np.ndarray:
    """The row of each block."""
    ids = table.column("id")
    row = np.argsort(ids, kind="stable")
    ordered = ids[row]
    for wrong in row[1:][np.diff(ordered) == 0][:1]:
        raise ResultError(f"{table.where(wrong)}id {ids[wrong]} occurs twice")
    for wrong in np.flatnonzero(~np.isin(ids, blocks.id))[:1]:
        raise ResultError(f"{table.where(wrong)}id {ids[wrong]} is not a block of blocks.vtk")
    for missing in blocks.id[~np.isin(blocks.id, ids)][:1]:
        raise ResultError(f"{table.path}: block {missing} has no row; {RUN_AGAIN}")
    return row
