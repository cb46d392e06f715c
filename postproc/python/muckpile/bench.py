# SPDX-License-Identifier: GPL-2.0-or-later
"""Throw and face velocity of a bench, as muckpile-post defines them.

Scope: vertical free face x = 0 and one row of vertical holes along the whole width. Others, which
muckpile-post measures too, are refused.
"""

import numpy as np

from muckpile.errors import ResultError
from muckpile.motion import mass_centre, mean_velocity
from muckpile.run import Run
from muckpile.snapshot import Snapshot

FACE_BANDS = 10  # bands of height, as a velocity profile of a filmed face has
TOUCH = 1e-3  # of a block's size: a vertex nearer to x = 0 lies in the face


def scene_number(run: Run, key: str) -> float:
    """A measure of the scene. Raises ResultError if scene.json lacks it or it is no number."""
    value = run.scene.get(key)
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise ResultError(f"{run.folder}/dump/scene.json: {key} must be a number, got '{value}'")
    return float(value)


def _require_bench(run: Run) -> None:
    if run.scene.get("case") != "bench":
        raise ResultError(f"{run.folder}: the run must be a bench, got '{run.scene.get('case')}'")
    if reason := (run.summary or {}).get("profile_refused"):
        raise ResultError(f"{run.folder}: {reason}")
    there = "read throw_cg_m and face_velocity_m_s of summary.json, which muckpile-post has measured"
    if (run.folder / "dump" / "holes.csv").exists():
        raise ResultError(f"{run.folder}: the bench must be without a hole table; {there}")
    blocks = run.blocks
    upper = blocks.points[:, 2] > 0.5 * scene_number(run, "bench_height_m")
    in_face = np.abs(blocks.points[:, 0]) <= TOUCH * blocks.size[blocks.point_block]
    if upper.any() and not (upper & in_face).any():
        raise ResultError(f"{run.folder}: the face must be the plane x = 0; {there}")


def burden_prism(run: Run) -> np.ndarray:
    """(n,) bool: blocks that started at -burden < x < 0 above the pit floor z = 0; of several rows
    that is the burden of the front one."""
    _require_bench(run)
    x, z = run.blocks.centre[:, 0], run.blocks.centre[:, 2]
    return (x > -scene_number(run, "burden_m")) & (x < 0.0) & (z > 0.0)


def throw(run: Run, snapshot: Snapshot | None = None) -> float:
    """Displacement along x of the mass centre of the burden prism [m], at the end unless a snapshot
    is given: `throw_cg_m` of the summary."""
    snapshot = run.snapshot() if snapshot is None else snapshot
    prism = burden_prism(run)
    moved = mass_centre(run.blocks, snapshot, prism) - mass_centre(run.blocks, None, prism)
    return float(moved[0])


def face_layer(run: Run, low: float, high: float) -> np.ndarray:
    """(n,) bool: blocks that started within max(burden / 4, one block) of the face, at heights
    from `low` to `high` [m]. One block: mean size of the blocks that touch the face."""
    _require_bench(run)
    blocks = run.blocks
    owner = blocks.point_block
    in_face = np.abs(blocks.points[:, 0]) <= TOUCH * blocks.size[owner]
    touches = (np.bincount(owner, in_face, len(blocks)) > 0) & ~blocks.muck
    one_block = np.cbrt(blocks.volume[touches].mean()) if touches.any() else 0.0
    depth = max(0.25 * scene_number(run, "burden_m"), one_block)
    x, z = blocks.centre[:, 0], blocks.centre[:, 2]
    return (x > -depth) & (x < 0.0) & (z >= low) & (z <= high)


def face_velocities(run: Run) -> tuple[np.ndarray, np.ndarray]:
    """Height of the middle of each band of the face above the floor (bands,) [m] and its mass mean
    of velocity along +x in each snapshot (m, bands) [m/s]; NaN for bands without a block.

    Reads all snapshots; between two of them the face may have been faster.
    """
    _require_bench(run)
    edges = np.linspace(0.0, scene_number(run, "bench_height_m"), FACE_BANDS + 1)
    bands = [face_layer(run, low, high) for low, high in zip(edges[:-1], edges[1:])]
    speeds = [[mean_velocity(run.blocks, now, band)[0] if band.any() else np.nan for band in bands]
              for now in run.snapshots()]
    return 0.5 * (edges[:-1] + edges[1:]), np.array(speeds, dtype=float).reshape(-1, len(bands))


def face_velocity(run: Run) -> float:
    """Largest of face_velocities() over bands and snapshots [m/s]: `face_velocity_m_s`."""
    _, speeds = face_velocities(run)
    if not np.isfinite(speeds).any():
        raise ResultError(f"{run.folder}: no block of the face layer has a velocity")
    return float(np.nanmax(speeds))
