# SPDX-License-Identifier: GPL-2.0-or-later
"""What was broken out, the fragments in it and their size curve, as muckpile-post defines them.

Scope: sizes are volume^(1/3); sieve sizes are in fragments_list.csv. docs/post/fragments.md has the
definitions.
"""

import numpy as np

from muckpile.blocks import Blocks
from muckpile.errors import ResultError
from muckpile.snapshot import Snapshot


def broken_out(blocks: Blocks, snapshot: Snapshot, least_move: float | None = None) -> np.ndarray:
    """(n,) bool: blocks of the rock, no muck, whose mass centre moved farther than their own size and than `least_move`
    [m], which is the mean block size unless given. The true crater is measured with 0."""
    least = blocks.mean_size if least_move is None else least_move
    moved = np.sqrt(((snapshot.position - blocks.centre)**2).sum(axis=1))
    return (moved > np.maximum(least, blocks.size)) & ~blocks.muck


def fragments_of(blocks: Blocks, snapshot: Snapshot, moved: np.ndarray | None = None) -> np.ndarray:
    """Fragments as a structured array in ascending order of id.

    Fields: id (smallest block id in it), blocks, volume_m3, size_m, mass_kg, start_m (3) and
    position_m (3), its mass centre before the blast and now, and in_pile: more than half of its
    mass is `moved`, which is broken_out() unless given.
    """
    moved = broken_out(blocks, snapshot) if moved is None else moved
    ids, owner, count = np.unique(snapshot.fragment, return_inverse=True, return_counts=True)

    def total(values):
        return np.bincount(owner, values)

    mass = total(blocks.mass)
    fragments = np.zeros(len(ids), dtype=[
        ("id", int), ("blocks", int), ("volume_m3", float), ("size_m", float), ("mass_kg", float),
        ("start_m", float, 3), ("position_m", float, 3), ("in_pile", bool)])
    fragments["id"], fragments["blocks"] = ids, count
    fragments["volume_m3"], fragments["mass_kg"] = total(blocks.volume), mass
    fragments["size_m"] = np.cbrt(fragments["volume_m3"])
    for axis in range(3):
        fragments["start_m"][:, axis] = total(blocks.mass * blocks.centre[:, axis]) / mass
        fragments["position_m"][:, axis] = total(blocks.mass * snapshot.position[:, axis]) / mass
    fragments["in_pile"] = total(blocks.mass * moved) > 0.5 * mass
    return fragments


def _points(size: np.ndarray, mass: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of passing_curve(), and the number of pieces of each point."""
    order = np.argsort(size, kind="stable")
    sizes, passing = np.asarray(size)[order], np.cumsum(np.asarray(mass)[order])
    if not sizes.size:
        raise ResultError("a size curve needs at least one piece; nothing was broken out")
    last = [-1]
    while last[-1] + 1 < sizes.size:
        last.append(int(np.searchsorted(sizes, sizes[last[-1] + 1] * (1.0 + 1e-6), side="right")) - 1)
    return sizes[last[1:]], passing[last[1:]] / passing[-1], np.diff(last)


def passing_curve(size: np.ndarray, mass: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Sizes [m], ascending, and the mass fraction in pieces of each size or smaller. Sizes that agree to a millionth
    are one, the largest of them."""
    return _points(size, mass)[:2]


def size_at(size: np.ndarray, mass: np.ndarray, passing: float) -> float:
    """Size [m] that the share `passing` of the mass passes, e.g. 0.5 for P50: straight lines between the points of
    the curve, of a point of several pieces up to the first of them; the smallest size below the first point."""
    if not 0.0 <= passing <= 1.0:
        raise ValueError(f"passing must be >= 0 and <= 1, got '{passing}'")
    sizes, fractions, pieces = _points(size, mass)
    above = min(int(np.searchsorted(fractions, passing)), len(sizes) - 1)
    if above == 0:
        return float(sizes[0])
    one_piece = (fractions[above] - fractions[above - 1]) / pieces[above]
    way = min(1.0, (passing - fractions[above - 1]) / one_piece)
    return float(sizes[above - 1] + way * (sizes[above] - sizes[above - 1]))


def pile_p50(blocks: Blocks, snapshot: Snapshot) -> float:
    """P50 by volume^(1/3) of the fragments in the pile [m]: `fragment_p50_m` of the summary."""
    fragments = fragments_of(blocks, snapshot)
    pile = fragments[fragments["in_pile"]]
    return size_at(pile["size_m"], pile["mass_kg"], 0.5)
