# SPDX-License-Identifier: GPL-2.0-or-later
"""Volume, centroid and inertia of many convex polyhedra at once.

Scope: faces as ranges of one list of corners (compressed rows), those of a polyhedron together, all
polyhedra in one set of arrays. Inside, vectors are stored by component, (3, m), and polyhedra are
taken in batches: both keep what is worked on within the processor's caches.
"""

from collections.abc import Iterator

import numpy as np

BATCH = 1000  # polyhedra


def ranges(starts: np.ndarray, counts: np.ndarray) -> np.ndarray:
    """start, start + 1, ... start + count - 1 of each range, one behind the other."""
    ends = np.cumsum(counts)
    return np.arange(ends[-1] if ends.size else 0) + np.repeat(starts - ends + counts, counts)


def offsets(counts: np.ndarray) -> np.ndarray:
    """Where each of consecutive ranges begins, and the end of the last: (n + 1,)."""
    return np.concatenate(([0], np.cumsum(counts)))


def batches(count: int) -> Iterator[slice]:
    """Slices of at most BATCH that cover 0 .. count - 1."""
    return (slice(first, min(first + BATCH, count)) for first in range(0, count, BATCH))


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def _dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def means(points: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """Mean of the points (p, 3) of each range of `starts` (n + 1,): (n, 3), within a convex body."""
    return np.add.reduceat(points, starts[:-1], axis=0) / np.diff(starts)[:, None]


def outward(points: np.ndarray, inside: np.ndarray, corner_start: np.ndarray, corners: np.ndarray):
    """The corners with each face counter-clockwise seen from outside.

    points (p, 3) [m]; inside (f, 3) [m], a point within each face's polyhedron; face k has the
    corners[corner_start[k]:corner_start[k + 1]].
    """
    turned = np.empty_like(corners)
    for batch in batches(len(inside)):
        start = corner_start[batch.start:batch.stop + 1]
        counts, here = np.diff(start), corners[start[0]:start[-1]]
        begin = np.repeat(start[:-1] - start[0], counts)
        last = np.repeat(start[1:] - start[0] - 1, counts)
        place = np.arange(len(here))
        arm = points[here].T - np.repeat(inside[batch].T, counts, axis=1)
        following = np.where(place == last, begin, place + 1)
        cuts = start[:-1] - start[0]
        normal = np.add.reduceat(_cross(arm, arm[:, following]), cuts, axis=1)
        inwards = _dot(normal, np.add.reduceat(arm, cuts, axis=1)) < 0.0
        turned[start[0]:start[-1]] = here[np.where(np.repeat(inwards, counts), begin + last - place, place)]
    return turned


def triangles_of(corner_start: np.ndarray, corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Each face cut into triangles from its first corner: (t, 3) points and (t,) faces."""
    counts = np.diff(corner_start) - 2
    face = np.repeat(np.arange(len(counts)), counts)
    second = ranges(corner_start[:-1] + 1, counts)
    first = corner_start[face]
    return np.stack([corners[first], corners[second], corners[second + 1]], axis=1), face


class Tetrahedra:
    """Polyhedra 0 .. n - 1 cut into tetrahedra from `apex` (n, 3) [m] to the triangles of their
    faces (t, 3), rows of points (p, 3) [m] and counter-clockwise seen from outside; `owner` (t,),
    ascending, is the polyhedron of each triangle, and each has one at least."""

    def __init__(self, points, triangles, owner, apex):
        self.points, self.triangles, self.apex = points, triangles, apex
        self.starts = np.searchsorted(owner, np.arange(len(apex) + 1))

    def _batches(self):
        """Polyhedra, where their tetrahedra begin, these' edges from the apex and six volumes."""
        for batch in batches(len(self.apex)):
            starts = self.starts[batch.start:batch.stop + 1]
            apex = np.repeat(self.apex[batch].T, np.diff(starts), axis=1)
            corners = self.triangles[starts[0]:starts[-1]]
            a, b, c = (self.points[corners[:, k]].T - apex for k in range(3))
            yield batch, starts[:-1] - starts[0], (a, b, c), _dot(a, _cross(b, c))

    def volumes_and_centroids(self) -> tuple[np.ndarray, np.ndarray]:
        """(n,) [m3] and (n, 3) [m]."""
        volume, centroid = np.empty(len(self.apex)), np.empty((len(self.apex), 3))
        for batch, cuts, (a, b, c), six_volumes in self._batches():
            volume[batch] = np.add.reduceat(six_volumes, cuts) / 6.0
            first = np.add.reduceat(six_volumes * (a + b + c), cuts, axis=1) / 24.0
            with np.errstate(invalid="ignore", divide="ignore"):  # the caller checks the volumes
                centroid[batch] = self.apex[batch] + (first / volume[batch]).T
        return volume, centroid

    def inertia(self) -> np.ndarray:
        """About the apex, which must be the centroid, for unit density: (n, 3, 3) [m5]."""
        inertia = np.empty((len(self.apex), 3, 3))
        for batch, cuts, (a, b, c), six_volumes in self._batches():
            far = a + b + c
            second = np.empty((batch.stop - batch.start, 3, 3))  # integral of x x^T
            for i in range(3):
                for j in range(i, 3):
                    # A tetrahedron with one corner at the origin: det / 120 (sum v v^T + s s^T).
                    product = a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + far[i] * far[j]
                    second[:, i, j] = np.add.reduceat(six_volumes * product, cuts) / 120.0
                    second[:, j, i] = second[:, i, j]
            inertia[batch] = np.einsum("tii->t", second)[:, None, None] * np.eye(3) - second
        return inertia
