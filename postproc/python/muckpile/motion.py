# SPDX-License-Identifier: GPL-2.0-or-later
"""Mass centre, momentum and kinetic energy of chosen blocks.

Scope: `chosen` is a mask (n,) or a list of rows of the blocks; without it all count.
"""

import numpy as np

from muckpile.blocks import Blocks, rotated
from muckpile.errors import ResultError
from muckpile.snapshot import Snapshot


def _rows(blocks: Blocks, chosen) -> np.ndarray:
    rows = np.arange(len(blocks))
    if chosen is not None:
        chosen = np.asarray(chosen)
        rows = rows[chosen if chosen.size else []]
    if not rows.size:
        raise ResultError("the selection must hold at least one block")
    return rows


def mass_centre(blocks: Blocks, snapshot: Snapshot | None = None, chosen=None) -> np.ndarray:
    """Common mass centre (3,) [m]; before the blast where no snapshot is given."""
    rows = _rows(blocks, chosen)
    position = blocks.centre if snapshot is None else snapshot.position
    return np.average(position[rows], axis=0, weights=blocks.mass[rows])


def momentum(blocks: Blocks, snapshot: Snapshot, chosen=None) -> np.ndarray:
    """Sum of mass times velocity (3,) [kg m/s]."""
    rows = _rows(blocks, chosen)
    return blocks.mass[rows] @ snapshot.velocity[rows]


def mean_velocity(blocks: Blocks, snapshot: Snapshot, chosen=None) -> np.ndarray:
    """Velocity of the common mass centre (3,) [m/s]."""
    rows = _rows(blocks, chosen)
    return np.average(snapshot.velocity[rows], axis=0, weights=blocks.mass[rows])


def block_energy(blocks: Blocks, snapshot: Snapshot) -> np.ndarray:
    """Kinetic energy of each block, of translation and spin together (n,) [J]."""
    inverse = snapshot.rotation * np.array([1.0, -1.0, -1.0, -1.0])
    spin = rotated(inverse, snapshot.spin)  # in the orientation in which the inertia is known
    turning = np.einsum("ni,nij,nj->n", spin, blocks.inertia, spin)
    return 0.5 * (blocks.mass * (snapshot.velocity**2).sum(axis=1) + turning)


def kinetic_energy(blocks: Blocks, snapshot: Snapshot, chosen=None) -> float:
    """Kinetic energy of translation and spin [J]."""
    return float(block_energy(blocks, snapshot)[_rows(blocks, chosen)].sum())
