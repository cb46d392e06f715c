# SPDX-License-Identifier: GPL-2.0-or-later
"""Reads dump/blocks.vtk: the blocks before the blast.

Scope: the legacy VTK unstructured grid of polyhedra that create_blocks writes; faces are turned
outwards, else nothing is repaired. Every count in the file is checked against what is there.
"""

import re
from pathlib import Path

import numpy as np

from muckpile.blocks import Blocks
from muckpile.errors import ResultError
from muckpile.polyhedra import Tetrahedra, means, offsets, outward, ranges, triangles_of
from muckpile.text_file import RUN_AGAIN, numbers, read_bytes

POLYHEDRON = 42  # VTK's number of the cell type
# As muckpile-post: a wrong unit, face or id is off by far more than the digits of the file.
VOLUME_TOLERANCE = 0.01
LARGEST_ID = 2**31 - 1  # of a body in the engine


class _Sections:
    """Headings of the file in order, each with the text up to the next one."""

    def __init__(self, path: Path):
        self.path = path
        data = read_bytes(path)
        if not data.startswith(b"# vtk DataFile Version"):
            raise ResultError(f"{path}: is no legacy VTK file; give the folder that a run wrote")
        title = data.find(b"\n") + 1  # any words
        heads = list(re.compile(rb"\n([A-Z][^\n]*)(?=\n)").finditer(data, data.find(b"\n", title)))
        ends = [head.start() for head in heads[1:]] + [len(data)]
        self._rest = [(head[1].decode("ascii", "replace").split(), data[head.end():end])
                      for head, end in zip(heads, ends)]
        self._rest.reverse()

    def __bool__(self) -> bool:
        return bool(self._rest)

    def next(self, *wanted: str) -> tuple[list[str], bytes]:
        """Words behind the wanted ones in the next heading, and the text below it."""
        words, text = self._rest.pop() if self._rest else (["the end of the file"], b"")
        if tuple(words[:len(wanted)]) != wanted:
            raise ResultError(f"{self.path}: '{' '.join(wanted)}' expected, got '{' '.join(words)}'; "
                              f"{RUN_AGAIN}")
        return words[len(wanted):], text

    def counts(self, wanted: str, how_many: int) -> tuple[list[int], bytes]:
        """Counts behind a heading, such as cells and words of CELLS, and the text below."""
        words, text = self.next(wanted)
        counts = words[:how_many]
        if len(counts) < how_many or not all(re.fullmatch(r"\d{1,12}", word) for word in counts):
            raise ResultError(f"{self.path}: {wanted} must say how many there are, got "
                              f"'{' '.join(words)}'")
        return [int(word) for word in counts], text


def _faces(words: np.ndarray, cells: int, path: Path):
    """Cell (f,), first word (f,) and number of corners (f,) of each face, in order of the cells."""
    starts, at = np.empty(cells, int), 0
    for cell in range(cells):
        starts[cell] = at
        length = words[at] if at < len(words) else -1
        if length < 1 or length >= len(words) - at:
            raise ResultError(f"{path}: CELLS: cell {cell + 1} is cut short; {RUN_AGAIN}")
        at += 1 + length
    if at != len(words):
        raise ResultError(f"{path}: CELLS: holds {len(words) - at} words behind its last cell")
    ends = np.append(starts[1:], at)
    found, here, left = [], starts + 2, words[starts + 1].copy()
    active = np.arange(cells)
    while True:  # one face of every cell that has another
        active = active[left[active] > 0]
        if not active.size:
            break
        inside = here[active] < ends[active]
        count = np.where(inside, words[np.minimum(here[active], at - 1)], 0)
        bad = (count < 3) | (count > ends[active] - here[active] - 1)
        if bad.any():
            raise ResultError(f"{path}: the faces of cell {active[bad][0] + 1} are cut short")
        found.append((active, here[active] + 1, count))
        here[active] += count + 1
        left[active] -= 1
    if (here != ends).any() or (words[starts + 1] < 4).any():
        cell = np.flatnonzero((here != ends) | (words[starts + 1] < 4))[0] + 1
        raise ResultError(f"{path}: cell {cell} must be a closed polyhedron of the faces it states")
    cell, first, count = (np.concatenate(part) for part in zip(*found))
    order = np.argsort(cell, kind="stable")  # the faces of a cell stay in their order
    return cell[order], first[order], count[order]


def _cell_data(sections: _Sections, cells: int) -> dict[str, np.ndarray]:
    [stated], _ = sections.counts("CELL_DATA", 1)
    if stated != cells:
        raise ResultError(f"{sections.path}: CELL_DATA must be for {cells} cells, got {stated}")
    data = {}
    while sections:
        words, _ = sections.next("SCALARS")
        name = words[0] if words else ""
        _, text = sections.next("LOOKUP_TABLE")
        data[name] = numbers(text, cells, float, f"{sections.path}: {name}")
    for name in ("id", "volume_m3", "size_m", "mass_kg", "on_free_face"):
        if name not in data:
            raise ResultError(f"{sections.path}: has no cell data '{name}'; {RUN_AGAIN}")
    return data


def _order_of_ids(data: dict[str, np.ndarray], path: Path) -> np.ndarray:
    """Cells in ascending order of id."""
    ids = data["id"]
    bad = (ids != np.rint(ids)) | (ids < 1) | (ids > LARGEST_ID)
    if bad.any():
        raise ResultError(f"{path}: id must be a whole number >= 1, got '{ids[bad][0]:.17g}'")
    order = np.argsort(ids)
    twice = np.flatnonzero(np.diff(ids[order]) == 0)
    if twice.size:
        raise ResultError(f"{path}: id {int(ids[order][twice[0]])} occurs twice")
    return order


def _check(blocks: Blocks, measured: np.ndarray, path: Path) -> None:
    bad = ~(np.abs(measured - blocks.volume) <= VOLUME_TOLERANCE * blocks.volume)
    for what, unit, values in (("size_m", "m", blocks.size), ("mass_kg", "kg", blocks.mass)):
        if not (values > 0.0).all():
            raise ResultError(f"{path}: {what} must be > 0 {unit}, got '{values.min():.17g}'")
    if bad.any():
        b = np.flatnonzero(bad)[0]
        raise ResultError(f"{path}: block {blocks.id[b]}: volume_m3 must be its polyhedron's "
                          f"{measured[b]:.9g} m3, got '{blocks.volume[b]:.9g}'")


def read_blocks(path: Path) -> Blocks:
    """All blocks in ascending order of id.

    Raises ResultError, naming the file, if it is absent, cut short or damaged, if an id occurs
    twice, or if a polyhedron's volume is not the one that the file states.
    """
    sections = _Sections(path)
    sections.next("ASCII")
    sections.next("DATASET", "UNSTRUCTURED_GRID")
    [count], text = sections.counts("POINTS", 1)
    points = numbers(text, 3 * count, float, f"{path}: POINTS").reshape(-1, 3)
    [cells, length], text = sections.counts("CELLS", 2)
    words = numbers(text, length, int, f"{path}: CELLS")
    if cells < 1 or cells > length:
        raise ResultError(f"{path}: CELLS must hold at least one cell and a word for each, got "
                          f"{cells} cells in {length} words")
    [types], text = sections.counts("CELL_TYPES", 1)
    if types != cells or (numbers(text, types, int, f"{path}: CELL_TYPES") != POLYHEDRON).any():
        raise ResultError(f"{path}: CELL_TYPES must be {POLYHEDRON} (polyhedron) for each of {cells} cells")
    cell, first, corner_count = _faces(words, cells, path)
    data = _cell_data(sections, cells)
    order = _order_of_ids(data, path)
    corners = words[ranges(first, corner_count)]
    if corners.min() < 0 or corners.max() >= count:
        raise ResultError(f"{path}: CELLS: a face has a point that is not in the file")
    return _assemble(path, points, (cell, corner_count, corners), data, order)


def _assemble(path, points, faces, data, order) -> Blocks:
    """Blocks of the faces of all cells, in the `order` of their ids, each with its own vertices."""
    cell, corner_count, corners = faces
    n = len(order)
    rank = np.empty(n, int)
    rank[order] = np.arange(n)
    by_rank = np.argsort(rank[cell], kind="stable")
    starts = offsets(corner_count)[:-1]
    corners = corners[ranges(starts[by_rank], corner_count[by_rank])]
    owner, corner_count = rank[cell][by_rank], corner_count[by_rank]
    corner_start = offsets(corner_count)
    used, corners = np.unique(np.repeat(owner, corner_count) * len(points) + corners,
                              return_inverse=True)
    vertex_block, own = np.divmod(used, len(points))
    vertex_start, own = np.searchsorted(vertex_block, np.arange(n + 1)), points[own]
    middle = means(own, vertex_start)
    corners = outward(own, middle[owner], corner_start, corners.reshape(-1))
    triangles, face = triangles_of(corner_start, corners)
    volume, centre = Tetrahedra(own, triangles, owner[face], middle).volumes_and_centroids()
    stated = {name: values[order] for name, values in data.items()}
    blocks = Blocks(
        id=stated["id"].astype(int), centre=centre, volume=stated["volume_m3"],
        size=stated["size_m"], mass=stated["mass_kg"],
        on_free_face=stated["on_free_face"] != 0.0,
        muck=stated.get("muck", np.zeros(n)) != 0.0, points=own, vertex_start=vertex_start,
        face_start=offsets(np.bincount(owner, minlength=n)), corner_start=corner_start,
        corners=corners, triangles=triangles, triangle_block=owner[face])
    _check(blocks, volume, path)
    return blocks
