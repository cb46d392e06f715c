# SPDX-License-Identifier: GPL-2.0-or-later
"""Volume, centroid and inertia of many convex polyhedra at once.

Scope: faces as ranges of one list of corners (compressed rows), all polyhedra in one set of arrays.
"""

import numpy as np


def ranges(starts: np.ndarray, counts: np.ndarray) -> np.ndarray:
    """start, start + 1, ... start + count - 1 of each range, one behind the other."""
    ends = np.cumsum(counts)
    return np.arange(ends[-1] if ends.size else 0) + np.repeat(starts - ends + counts, counts)


def offsets(counts: np.ndarray) -> np.ndarray:
    """Where each of consecutive ranges begins, and the end of the last: (n + 1,)."""
    return np.concatenate(([0], np.cumsum(counts)))


def sums(values: np.ndarray, owner: np.ndarray, owners: int) -> np.ndarray:
    """Sum of the rows of `values` (m, ...) of each owner 0 .. owners - 1: (owners, ...)."""
    flat = values.reshape(len(values), -1)
    total = [np.bincount(owner, column, owners) for column in flat.T]
    return np.stack(total, axis=1).reshape((owners,) + values.shape[1:])


def means(points: np.ndarray, owner: np.ndarray, owners: int) -> np.ndarray:
    """Mean of the points (m, 3) of each owner; inside of a convex polyhedron: (owners, 3)."""
    return sums(points, owner, owners) / np.bincount(owner, minlength=owners)[:, None]


def outward(points: np.ndarray, inside: np.ndarray, corner_start: np.ndarray, corners: np.ndarray):
    """The corners with each face counter-clockwise seen from outside.

    points (p, 3) [m]; inside (f, 3) [m], a point within each face's polyhedron; face k has the
    corners[corner_start[k]:corner_start[k + 1]].
    """
    counts = np.diff(corner_start)
    face = np.repeat(np.arange(len(counts)), counts)
    place = np.arange(len(corners))
    following = np.where(place + 1 == corner_start[face + 1], corner_start[face], place + 1)
    arm = points[corners] - inside[face]
    normal = sums(np.cross(arm, arm[following]), face, len(counts))
    turn = np.einsum("fc,fc->f", normal, sums(arm, face, len(counts))) < 0.0
    mirrored = corner_start[face] + corner_start[face + 1] - 1 - place
    return corners[np.where(turn[face], mirrored, place)]


def triangles_of(corner_start: np.ndarray, corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Each face cut into triangles from its first corner: (t, 3) points and (t,) faces."""
    counts = np.diff(corner_start) - 2
    face = np.repeat(np.arange(len(counts)), counts)
    second = ranges(corner_start[:-1] + 1, counts)
    first = corner_start[face]
    return np.stack([corners[first], corners[second], corners[second + 1]], axis=1), face


def mass_properties(points, triangles, owner, apex):
    """Volume (n,) [m3], centroid (n, 3) [m] and, for unit density, inertia about it (n, 3, 3) [m5].

    Each polyhedron is cut into tetrahedra from `apex` (n, 3) [m] to its triangles (t, 3), which are
    counter-clockwise seen from outside; `owner` (t,) is the polyhedron of each.
    """
    count = len(apex)
    arms = points[triangles] - apex[owner][:, None, :]
    six_volumes = np.einsum("tc,tc->t", arms[:, 0], np.cross(arms[:, 1], arms[:, 2]))
    volume = sums(six_volumes, owner, count) / 6.0
    far = arms.sum(axis=1)
    first = sums(six_volumes[:, None] * far, owner, count) / 24.0
    # Integral of x x^T over a tetrahedron with one corner at the origin.
    second = np.einsum("tki,tkj->tij", arms, arms) + far[:, :, None] * far[:, None, :]
    second = sums(six_volumes[:, None, None] * second, owner, count) / 120.0
    with np.errstate(invalid="ignore", divide="ignore"):  # the caller checks the volumes
        offset = first / volume[:, None]
    spread = second - volume[:, None, None] * offset[:, :, None] * offset[:, None, :]
    trace = np.einsum("tii->t", spread)
    return volume, apex + offset, trace[:, None, None] * np.eye(3) - spread
