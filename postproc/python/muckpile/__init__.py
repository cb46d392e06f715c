# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of Muckpile bench blasts as NumPy arrays.

    import muckpile
    run = muckpile.Run("results/bench")
    last = run.snapshot()          # the state of all blocks at the end
    muckpile.throw(run)            # [m]

Scope: reads what `./muckpile run` leaves and never writes. SI units; z is up.
"""

from muckpile.bench import burden_prism, face_layer, face_velocities, face_velocity, throw
from muckpile.blocks import Blocks, rotated
from muckpile.errors import ResultError
from muckpile.fragments import broken_out, fragments_of, passing_curve, pile_p50, size_at
from muckpile.motion import block_energy, kinetic_energy, mass_centre, mean_velocity, momentum
from muckpile.run import Run
from muckpile.snapshot import Snapshot
from muckpile.table import read_table
from muckpile.version import VERSION as __version__

__all__ = [
    "Blocks", "ResultError", "Run", "Snapshot", "block_energy", "broken_out", "burden_prism",
    "face_layer", "face_velocities", "face_velocity", "fragments_of", "kinetic_energy",
    "mass_centre", "mean_velocity", "momentum", "passing_curve", "pile_p50", "read_table",
    "rotated", "size_at", "throw",
]
