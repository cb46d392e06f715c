# SPDX-License-Identifier: GPL-2.0-or-later
"""A bench blast in NumPy, cell by cell: where the rock went, how fast, in what pieces.

Run it as `python3 bench_in_numpy.py [FOLDER]`, FOLDER being results/bench unless given, or cell by
cell in an editor that knows `# %%`.
Scope: prints tables; any run of inputs/bench. SI units.
"""

# %% Open a run. The package reads the folder that `./muckpile run inputs/bench/in.bench` leaves.
import sys

import numpy as np

import muckpile

run = muckpile.Run(sys.argv[1] if len(sys.argv) > 1 else "results/bench")
blocks, last = run.blocks, run.snapshot()
scene = run.scene
print(f"{run}")
print(f"bench {scene['bench_height_m']} m, burden {scene['burden_m']} m, {len(blocks)} blocks of "
      f"{blocks.size.min():.2f} to {blocks.size.max():.2f} m, {blocks.mass.sum() / 1000:.1f} t")
print(f"end at {last.time:.3f} s, {'at rest' if run.record['still'] else 'still moving'}")

# %% Throw: how far the mass centre of the burden has gone, over time.
prism = muckpile.burden_prism(run)
print(f"\nburden: {prism.sum()} blocks, {blocks.mass[prism].sum() / 1000:.1f} t")
print("time [s]  throw [m]  speed along x [m/s]")
wanted = last.time * np.geomspace(0.003, 1.0, 8)  # dense at first, when the gas pushes
for k in np.unique([np.argmin(np.abs(run.times - time)) for time in wanted]):
    now = run.snapshot(k)
    speed = muckpile.mean_velocity(blocks, now, prism)[0]
    print(f"{now.time:8.4f}  {muckpile.throw(run, now):9.4f}  {speed:8.3f}")

# %% Face: mean speed along +x by height, the largest over the snapshots; nan where no block is.
heights, speeds = muckpile.face_velocities(run)
print("\nheight [m]  fastest [m/s]")
for height, fastest in zip(heights[::-1], np.fmax.reduce(speeds)[::-1]):
    print(f"{height:10.2f}  {fastest:8.2f}")

# %% Levels: what moved where, by height before the blast. Masks choose blocks; masses weigh them.
moved = run.displacement(last)
edges = np.linspace(0.0, scene["bench_height_m"], 6)
print("\nlevel [m]      mass [t]  moved x [m]  moved z [m]")
for low, high in zip(edges[:-1], edges[1:]):
    level = prism & (blocks.centre[:, 2] >= low) & (blocks.centre[:, 2] < high)
    if level.any():
        x, _, z = np.average(moved[level], axis=0, weights=blocks.mass[level])
        print(f"{low:5.2f} - {high:5.2f}  {blocks.mass[level].sum() / 1000:8.2f}  {x:11.3f}  {z:11.3f}")

# %% Energy: that of the blocks against the run's own account of the same step.
mine = muckpile.kinetic_energy(blocks, last)
account = run.history[run.history["step"] == last.step]
print(f"\nkinetic energy of blocks {mine / 1000:.3f} kJ", end="")
print(f", of history.csv {account['kinetic_J'][-1] / 1000:.3f} kJ" if account.size else "")
x, y, z = muckpile.momentum(blocks, last, prism)
print(f"momentum of the burden [kg m/s]: x {x:.0f}, y {y:.0f}, z {z:.0f}")

# %% Outline: the highest vertex in each metre along x, from the polyhedra as they lie at the end.
points = run.vertices_at(last)
metre = np.floor(points[:, 0]).astype(int)
print("\nx [m]      highest point [m]")
for x in np.unique(metre):
    print(f"{x:4d} - {x + 1:3d}  {points[metre == x, 2].max():6.2f}")

# %% Pieces: fragments are blocks that joints still hold together; those broken out are the pile.
fragments = muckpile.fragments_of(blocks, last)
pile = fragments[fragments["in_pile"]]
if pile.size:
    largest = pile[np.argmax(pile["mass_kg"])]
    print(f"\n{pile.size} fragments in the pile, {pile['mass_kg'].sum() / 1000:.1f} t")
    print(f"P50 {muckpile.pile_p50(blocks, last):.4f} m; the largest has {largest['blocks']} blocks, "
          f"{largest['mass_kg']:.0f} kg, and lies at x = {largest['position_m'][0]:.2f} m")
else:
    print("\nnothing was broken out")

# %% Beside it: what muckpile-post has measured.
if run.summary is not None:
    for key in ("throw_cg_m", "face_velocity_m_s", "fragment_p50_m", "pile_toe_m"):
        print(f"summary.json: {key} {run.summary.get(key)}")
