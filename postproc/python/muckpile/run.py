# SPDX-License-Identifier: GPL-2.0-or-later
"""One run: the folder that `./muckpile run` leaves, file by file as it is asked for.

Scope: reads only. Bench coordinates: free face x = 0, rock at x < 0, throw along +x, pit floor
z = 0; z is up.
"""

from collections.abc import Iterator
from functools import cached_property
from pathlib import Path

import numpy as np

from muckpile.blocks import Blocks
from muckpile.blocks_file import read_blocks
from muckpile.errors import ResultError
from muckpile.run_id import first_lines, id_in_json, run_id_of
from muckpile.snapshot import Snapshot, read_snapshot, snapshot_files, step_and_time
from muckpile.table import load_table, read_table
from muckpile.text_file import read_json


class Run:
    """Results of one run, e.g. Run("results/bench").

    Files are read when they are first asked for and kept, but for snapshots: make a new Run after
    the folder has changed.
    """

    def __init__(self, folder: str | Path):
        """Raises ResultError if the folder is that of no run, or holds files of two."""
        self.folder = Path(folder)
        self._dump = self.folder / "dump"
        if not self._dump.is_dir():
            raise ResultError(f"{self.folder}: has no folder dump/; give the folder that a run wrote, "
                              "such as results/bench")
        self.run_id: str = run_id_of(self._dump)
        self._files = snapshot_files(self._dump)
        marks = [step_and_time("".join(first_lines(path, 1)), path) for path in self._files]
        #: (m,) step of each snapshot, ascending.
        self.steps = np.array([step for step, _ in marks], dtype=int)
        #: (m,) physical time of each snapshot [s].
        self.times = np.array([time for _, time in marks], dtype=float)

    def __repr__(self) -> str:
        return f"Run('{self.folder}'): {self.times.size} snapshots of run {self.run_id or 'without id'}"

    @cached_property
    def scene(self) -> dict:
        """dump/scene.json: measures of the scene with their units in the names, and `knobs`."""
        return read_json(self._dump / "scene.json")

    @cached_property
    def record(self) -> dict:
        """dump/run.json: counts, times, energies of the explosive, `holes`, `still`."""
        return read_json(self._dump / "run.json")

    @cached_property
    def summary(self) -> dict | None:
        """summary.json, every figure that muckpile-post has measured; None before it has.

        A figure without meaning is None. Raises ResultError if the summary is of another run.
        """
        path = self.folder / "summary.json"
        if not path.exists():
            return None
        summary = read_json(path)
        if id_in_json(summary) != self.run_id:
            raise ResultError(f"{path}: is of another run than dump/; measure the run anew: "
                              f"muckpile-post all {self.folder}")
        return summary

    @cached_property
    def history(self) -> np.ndarray:
        """dump/history.csv as a structured array (rows,): `history["kinetic_J"]` is a column."""
        table = load_table(self._dump / "history.csv")
        if not table.rows.size:
            raise ResultError(f"{table.path}: holds no rows")
        return table.rows

    @cached_property
    def blocks(self) -> Blocks:
        """dump/blocks.vtk: the blocks before the blast, in ascending order of id."""
        return read_blocks(self._dump / "blocks.vtk")

    def snapshot(self, index: int | None = None, *, time: float | None = None) -> Snapshot:
        """The snapshot with this index of `times` (-1 is the last, also the default), or the one
        nearest to `time` [s]. Nothing is interpolated: see `.time` of what comes back."""
        if not self._files:
            raise ResultError(f"{self._dump}: holds no blocks_<step>.csv or .bin; the run needs fix muckpile/dump")
        if index is not None and time is not None:
            raise ValueError("give either the index of a snapshot or a time, not both")
        if time is not None:
            if not self.times[0] <= time <= self.times[-1]:
                raise ResultError(f"{self.folder}: time must be >= {self.times[0]:g} s and <= "
                                  f"{self.times[-1]:g} s, got '{time:g}'")
            index = int(np.argmin(np.abs(self.times - time)))
        index = -1 if index is None else index
        if not isinstance(index, (int, np.integer)):
            raise TypeError(f"the index of a snapshot must be a whole number, got '{index}'; "
                            "for a time write snapshot(time=...)")
        if not -len(self._files) <= index < len(self._files):
            raise IndexError(f"{self.folder}: has {len(self._files)} snapshots, got index '{index}'")
        return read_snapshot(self._files[index], self.blocks)

    def snapshots(self) -> Iterator[Snapshot]:
        """All snapshots in order of time, one in memory at a time."""
        return (self.snapshot(index) for index in range(len(self._files)))

    def vertices_at(self, snapshot: Snapshot) -> np.ndarray:
        """(p, 3) the vertices of all blocks, moved and turned [m]; rows as of `blocks.points`."""
        return self.blocks.vertices_at(snapshot)

    def displacement(self, snapshot: Snapshot) -> np.ndarray:
        """(n, 3) of the mass centres since the start [m]."""
        return snapshot.position - self.blocks.centre

    @cached_property
    def profile(self) -> np.ndarray:
        """profile.csv of a bench: heights of rock and pile over x_m [m], a structured array."""
        return self.table("profile.csv")

    @cached_property
    def fragments(self) -> np.ndarray:
        """fragments_list.csv: a row per fragment; `sieve_m` is NaN for rock that stayed."""
        return self.table("fragments_list.csv")

    @cached_property
    def size_curve(self) -> np.ndarray:
        """fragments.csv: size_m by volume^(1/3) and mass_fraction_passing."""
        return self.table("fragments.csv")

    @cached_property
    def sieve_curve(self) -> np.ndarray:
        """sieve.csv: sieve_m, mass_fraction_passing, and fits and formula at that size."""
        return self.table("sieve.csv")

    def table(self, name: str) -> np.ndarray:
        """Any table that muckpile-post has left, such as "movement.csv", as a structured array.

        Raises ResultError if it is not there or the summary beside it is not of this run.
        """
        path = self.folder / name
        summary = self.summary
        if not path.exists() or summary is None:
            # "movement_refused" and "profile_refused" say why a sub-command has left no table.
            reason = (summary or {}).get(f"{Path(name).stem}_refused")
            missing = name if not path.exists() else "summary.json"
            raise ResultError(reason or f"{self.folder / missing}: is not there; measure the run: "
                              f"muckpile-post all {self.folder}")
        return read_table(path)
