# SPDX-License-Identifier: GPL-2.0-or-later
"""A bench that liggghts-muckpile has blasted: the package against summary.json, the tables of
muckpile-post and the engine's own energy account.

Scope: the definitions are the same, so that only digits of the files may differ.
"""

import csv
import unittest

import numpy as np

import muckpile
from runs import simulated

ROUNDING = 1e-12  # sums of some hundred numbers in another order, all digits in the files
SIX_DIGITS = 1e-5  # of the tables of muckpile-post


class SimulatedRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_ = muckpile.Run(simulated())
        cls.blocks, cls.last = cls.run_.blocks, cls.run_.snapshot()

    def same(self, value, wanted, relative):
        self.assertNotIn(0.0, np.atleast_1d(wanted), "a figure of zero compares nothing")
        np.testing.assert_allclose(value, wanted, rtol=relative, atol=0.0)

    def of_table(self, name, column):
        with (self.run_.folder / name).open() as file:
            return [row[column] for row in csv.DictReader(file)]

    def test_blast_has_thrown_rock(self):
        self.assertGreater(len(self.blocks), 300)
        self.assertGreater(self.run_.summary["throw_cg_m"], 0.5)
        self.assertGreater(self.run_.summary["fragments_in_pile"], 20)

    def test_counts_and_ids_are_those_of_the_record(self):
        self.assertEqual(len(self.blocks), self.run_.record["blocks"])
        self.assertEqual(self.last.step, self.run_.record["steps"])
        self.same(self.last.time, self.run_.record["physical_time_s"], 1e-9)  # ten digits
        self.assertEqual(self.run_.run_id, self.run_.scene["run_id"])
        self.assertEqual(set(self.run_.history["run_id"].tolist()), {self.run_.run_id})
        self.assertTrue((np.diff(self.run_.times) > 0.0).all())

    def test_centres_and_polyhedra_are_where_the_engine_has_them(self):
        start = self.run_.snapshot(0)
        self.assertLess(np.abs(start.position - self.blocks.centre).max(), 1e-8)  # ten digits of 3 m
        self.assertLess(np.abs(self.run_.vertices_at(start) - self.blocks.points).max(), 1e-8)
        self.same(self.blocks.mass, self.blocks.volume * self.run_.scene["rock_density_kg_m3"], ROUNDING)
        # Rigid: the distance of a vertex from its block's centre stays.
        block = self.blocks.point_block
        before = np.linalg.norm(self.blocks.points - self.blocks.centre[block], axis=1)
        after = np.linalg.norm(self.run_.vertices_at(self.last) - self.last.position[block], axis=1)
        self.same(after, before, ROUNDING * 100)  # coordinates of metres less each other

    def test_kinetic_energy_is_that_of_the_ledger_at_every_common_step(self):
        common = [k for k, step in enumerate(self.run_.steps) if step in self.run_.history["step"]]
        compared = 0
        for k in common:
            now = self.run_.snapshot(k)
            [ledger] = self.run_.history["kinetic_J"][self.run_.history["step"] == now.step]
            if ledger > 0.0:
                self.same(muckpile.kinetic_energy(self.blocks, now), ledger, 1e-6)  # seven digits of speed
                compared += 1
        self.assertGreaterEqual(compared, 2)
        turning = muckpile.kinetic_energy(self.blocks, self.last) - 0.5 * (
            self.blocks.mass * (self.last.velocity**2).sum(axis=1)).sum()
        self.assertGreater(turning, 0.005 * muckpile.kinetic_energy(self.blocks, self.last),
                           "too little spin to test inertia")

    def test_throw_is_that_of_the_summary(self):
        self.same(muckpile.throw(self.run_), self.run_.summary["throw_cg_m"], ROUNDING)

    def test_face_velocity_is_that_of_the_summary(self):
        self.same(muckpile.face_velocity(self.run_), self.run_.summary["face_velocity_m_s"], ROUNDING)

    def test_fragments_are_those_of_the_table(self):
        found, table = muckpile.fragments_of(self.blocks, self.last), self.run_.fragments
        self.assertEqual(found["id"].tolist(), table["fragment_id"].tolist())
        self.assertEqual(found["blocks"].tolist(), table["blocks"].tolist())
        self.assertEqual(found["in_pile"].tolist(), (table["in_pile"] == 1).tolist())
        self.same(found["size_m"], table["size_m"], SIX_DIGITS)
        self.same(found["position_m"][:, 0], table["x_m"], SIX_DIGITS)
        moved = np.linalg.norm(found["position_m"] - found["start_m"], axis=1)
        self.same(moved, table["displacement_m"], SIX_DIGITS)
        self.assertEqual(np.isnan(table["sieve_m"]).tolist(), (table["in_pile"] == 0).tolist())

    def test_sizes_are_those_of_the_summary(self):
        pile = muckpile.fragments_of(self.blocks, self.last)
        pile = pile[pile["in_pile"]]
        self.same(muckpile.pile_p50(self.blocks, self.last), self.run_.summary["fragment_p50_m"], ROUNDING)
        for share, key in ((0.2, "fragment_p20_m"), (0.8, "fragment_p80_m"), (1.0, "fragment_largest_m")):
            size = muckpile.size_at(pile["size_m"], pile["mass_kg"], share)
            self.same(size, self.run_.summary[key], ROUNDING)
        sizes, passing = muckpile.passing_curve(pile["size_m"], pile["mass_kg"])
        self.same(sizes, self.run_.size_curve["size_m"], SIX_DIGITS)
        self.same(passing, self.run_.size_curve["mass_fraction_passing"], SIX_DIGITS)
        out = muckpile.broken_out(self.blocks, self.last)
        self.same(muckpile.size_at(self.blocks.size[out], self.blocks.mass[out], 0.5),
                  self.run_.summary["block_p50_m"], ROUNDING)

    def test_tables_hold_what_stands_in_the_files(self):
        for name, table in (("profile.csv", self.run_.profile), ("sieve.csv", self.run_.sieve_curve),
                            ("dump/history.csv", self.run_.history)):
            self.assertGreater(len(table), 2)
            for column in table.dtype.names:
                words = self.of_table(name, column)
                if table.dtype[column].kind == "U":
                    self.assertEqual(table[column].tolist(), words)
                else:
                    wanted = [float(word) if word else np.nan for word in words]
                    np.testing.assert_array_equal(table[column], wanted)
