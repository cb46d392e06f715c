# SPDX-License-Identifier: GPL-2.0-or-later
"""The blocks of a run before the blast, and rigid motion of their points.

Scope: arrays only; blocks_file.py reads them.
"""

from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np

from muckpile.polyhedra import Tetrahedra


def rotated(rotation: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Vectors (n, 3) turned by unit quaternions (n, 4) in the order w, x, y, z: (n, 3)."""
    axis = rotation[:, 1:]
    twice = 2.0 * np.cross(axis, vectors)
    return vectors + rotation[:, :1] * twice + np.cross(axis, twice)


@dataclass(frozen=True)
class Blocks:
    """n blocks in ascending order of id. Arrays are read-only; row b of each is block b.

    Vertices of all blocks stand in one array, those of a block together and used by it alone; so do
    faces and corners. `vertices(b)` and `faces(b)` give those of one block.
    """

    id: np.ndarray  # (n,) tag of the block's body
    centre: np.ndarray  # (n, 3) centroid of the volume, also the mass centre [m]
    volume: np.ndarray  # (n,) [m3]
    size: np.ndarray  # (n,) volume^(1/3) [m]
    mass: np.ndarray  # (n,) [kg]
    on_free_face: np.ndarray  # (n,) bool: a face of it is a free face, also those at back and sides
    muck: np.ndarray  # (n,) bool: lay loose in front of the rock, and is no rock that is blasted
    points: np.ndarray  # (p, 3) vertices of all blocks [m]
    vertex_start: np.ndarray  # (n + 1,) block b has points[vertex_start[b]:vertex_start[b + 1]]
    face_start: np.ndarray  # (n + 1,) block b has the faces face_start[b] .. face_start[b + 1] - 1
    corner_start: np.ndarray  # (f + 1,) face k has corners[corner_start[k]:corner_start[k + 1]]
    corners: np.ndarray  # (c,) rows of points, counter-clockwise seen from outside
    triangles: np.ndarray  # (t, 3) rows of points: the faces cut into triangles, turned the same way
    triangle_block: np.ndarray  # (t,) block of each triangle

    def __post_init__(self):
        for field in fields(self):
            getattr(self, field.name).flags.writeable = False

    def __len__(self) -> int:
        return len(self.id)

    @cached_property
    def inertia(self) -> np.ndarray:
        """(n, 3, 3) about the mass centre, in the orientation of the start [kg m2]."""
        unit = Tetrahedra(self.points, self.triangles, self.triangle_block, self.centre).inertia()
        inertia = (self.mass / self.volume)[:, None, None] * unit
        inertia.flags.writeable = False
        return inertia

    @property
    def mean_size(self) -> float:
        """(mean volume)^(1/3) of all blocks of the rock [m]."""
        return float(np.cbrt(self.volume[~self.muck].mean()))

    @property
    def point_block(self) -> np.ndarray:
        """(p,) block of each of the points."""
        return np.repeat(np.arange(len(self)), np.diff(self.vertex_start))

    def vertices(self, block: int) -> np.ndarray:
        """(v, 3) vertices of one block before the blast [m]."""
        return self.points[self.vertex_start[block]:self.vertex_start[block + 1]]

    def faces(self, block: int) -> list[np.ndarray]:
        """Faces of one block, each as rows of vertices(block), counter-clockwise from outside."""
        first = self.vertex_start[block]
        return [self.corners[self.corner_start[face]:self.corner_start[face + 1]] - first
                for face in range(self.face_start[block], self.face_start[block + 1])]

    def vertices_at(self, snapshot) -> np.ndarray:
        """(p, 3) the points moved and turned with their blocks as rigid bodies [m]."""
        block = self.point_block
        arms = self.points - self.centre[block]
        return snapshot.position[block] + rotated(snapshot.rotation[block], arms)
