# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs that the tests read: one simulated, one written by hand.

Scope: temporary folders, which go when the tests end.
"""

import atexit
import functools
import os
import shutil
import struct
import subprocess
import tempfile
from itertools import product
from pathlib import Path

ROOT = Path(os.environ["MUCKPILE_ROOT"])
RUN_ID = "0123456789abcdef"
OTHER_ID = "fedcba9876543210"
HEADER = ("id,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,fragment_id,"
          "broken_fraction")


def scratch() -> Path:
    """An empty folder."""
    folder = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return Path(folder)


@functools.cache
def simulated() -> Path:
    """A bench of some 570 blocks, blasted and measured: results/bench under a scratch folder."""
    folder = scratch() / "results" / "bench"
    (folder / "dump").mkdir(parents=True)
    small = {"accuracy": "quick", "bench_height": "3", "burden": "1.5", "hole_diameter": "0.06",
             "time_end": "0.3", "out": str(folder)}
    words = [word for name, value in small.items() for word in ("-var", name, value)]
    _must_work([os.environ["MUCKPILE_PROGRAM"], "-in", "inputs/bench/in.bench", "-log", "none", *words])
    for command in ("profile", "fragments"):
        _must_work([os.environ["MUCKPILE_POST"], command, str(folder)])
    return folder


def _must_work(words: list[str]) -> None:
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{words} ended with {done.returncode}:\n{done.stdout[-3000:]}{done.stderr}")


# A box as VTK describes it: corners counted x slowest, z fastest. The second face is turned inwards.
BOX_FACES = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))


def box(low, high):
    """Eight corners [m]."""
    return [tuple(choice) for choice in product(*zip(low, high))]


def blocks_file(boxes: dict, density: float = 2000.0, run_id: str = RUN_ID) -> str:
    """blocks.vtk of boxes: id to (low, high) [m], written in the order given."""
    points = [p for low, high in boxes.values() for p in box(low, high)]
    volumes = [(b[0] - a[0]) * (b[1] - a[1]) * (b[2] - a[2]) for a, b in boxes.values()]
    cells = []
    for k in range(len(boxes)):
        faces = " ".join("4 " + " ".join(str(8 * k + v) for v in face) for face in BOX_FACES)
        cells.append(f"31 6 {faces}")
    columns = {"id int": list(boxes), "volume_m3 double": volumes,
               "size_m double": [v ** (1 / 3) for v in volumes],
               "mass_kg double": [density * v for v in volumes],
               "on_free_face int": [1] * len(boxes)}
    lines = ["# vtk DataFile Version 3.0", f"Blocks run={run_id}", "ASCII",
             "DATASET UNSTRUCTURED_GRID", f"POINTS {len(points)} double"]
    lines += [" ".join(map(str, p)) for p in points]
    lines += [f"CELLS {len(cells)} {32 * len(cells)}", *cells, f"CELL_TYPES {len(cells)}"]
    lines += ["42"] * len(cells) + [f"CELL_DATA {len(cells)}"]
    for name, values in columns.items():
        lines += [f"SCALARS {name} 1", "LOOKUP_TABLE default", *map(str, values)]
    return "\n".join(lines) + "\n"


# As docs/styles/fix_muckpile_dump.md has them: header, and a row's integers, doubles and floats.
PACKED_HEADER = ("packed i4 id f8 x_m y_m z_m i4/2147483647 qw qx qy qz f4 vx_m_s vy_m_s vz_m_s wx_rad_s "
                 "wy_rad_s wz_rad_s i4 fragment_id f4 broken_fraction\n")


def packed_row(line: str) -> bytes:
    words = line.split(",")
    turn = [round(float(word) * 2147483647) for word in words[4:8]]
    return struct.pack("<i3d4i6fif", int(words[0]), *map(float, words[1:4]), *turn, *map(float, words[8:14]),
                       int(words[14]), float(words[15]))


def hand_made(packed: bool = False) -> Path:
    """A bench 1 m high, burden 1 m: a cube of 1 m at the face (id 1) and, behind it, a box of
    1 x 2 x 3 m (id 7), which the files name first. At 0.5 s they have made a quarter turn, the cube
    about x, the box about z."""
    folder = scratch() / "bench"
    dump = folder / "dump"
    dump.mkdir(parents=True)
    boxes = {7: ((-2.5, -1, 0), (-1.5, 1, 3)), 1: ((-1, -0.5, 0), (0, 0.5, 1))}
    (dump / "blocks.vtk").write_text(blocks_file(boxes))
    half = 0.5**0.5
    rows = {0: ("7,-2,0,1.5,1,0,0,0,0,0,0,0,0,0,1,0", "1,-0.5,0,0.5,1,0,0,0,0,0,0,0,0,0,1,0"),
            10: (f"7,-2,0,1.5,{half},0,0,{half},0,0,1,0,3,0,7,0.25",
                 f"1,2,0,0.5,{half},{half},0,0,4,0,0,0,0,2,1,1")}
    for step, lines in rows.items():
        first = f"# step={step} time_s={step / 20} run={RUN_ID}\n"
        if packed:
            (dump / f"blocks_{step:09d}.bin").write_bytes(
                (first + PACKED_HEADER).encode() + b"".join(map(packed_row, lines)))
        else:
            (dump / f"blocks_{step:09d}.csv").write_text("\n".join([first + HEADER, *lines]) + "\n")
    (dump / "scene.json").write_text(
        f'{{"case": "bench", "burden_m": 1.0, "bench_height_m": 1, "run_id": "{RUN_ID}"}}\n')
    (dump / "run.json").write_text(f'{{"blocks": 2, "still": false, "run_id": "{RUN_ID}"}}\n')
    (dump / "history.csv").write_text(
        f"step,time_s,phase,kinetic_J,run_id\n0,0,wave,0,{RUN_ID}\n10,0.5,throw,1.5e3,{RUN_ID}\n")
    (folder / "summary.json").write_text(f'{{"run_id": "{RUN_ID}", "swell_factor": null}}\n')
    (folder / "profile.csv").write_text("x_m,pile_mean_m,floor_m\n-1,0.5,0\n0,,-0.25\n")
    return folder
