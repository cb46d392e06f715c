# SPDX-License-Identifier: GPL-2.0-or-later
"""Two boxes whose every figure is known by hand.

Tolerance: rounding of a few operations, 1e-12.
"""

import unittest

import numpy as np

import muckpile
from runs import RUN_ID, hand_made


def same(value, wanted):
    np.testing.assert_allclose(value, wanted, rtol=0.0, atol=1e-12 * max(1.0, np.abs(wanted).max()))


class HandMadeRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_ = muckpile.Run(hand_made())
        cls.blocks, cls.last = cls.run_.blocks, cls.run_.snapshot()

    def test_blocks_are_in_ascending_order_of_id(self):
        self.assertEqual(self.blocks.id.tolist(), [1, 7])
        same(self.blocks.centre, np.array([[-0.5, 0, 0.5], [-2, 0, 1.5]]))
        same(self.blocks.volume, np.array([1.0, 6.0]))
        same(self.blocks.mass, np.array([2000.0, 12000.0]))
        self.assertEqual(self.blocks.on_free_face.tolist(), [True, True])
        same(self.blocks.mean_size, np.cbrt(3.5))

    def test_inertia_is_that_of_boxes(self):
        cube = 2000.0 / 6.0 * np.eye(3)  # m a^2 / 6
        box = 1000.0 * np.diag([2**2 + 3**2, 1**2 + 3**2, 1**2 + 2**2])  # m / 12 = 1000 kg
        same(self.blocks.inertia, np.array([cube, box]))

    def test_faces_and_triangles_are_closed_and_turned_outwards(self):
        for b, (volume, area) in enumerate([(1.0, 6.0), (6.0, 22.0)]):
            vertices, faces = self.blocks.vertices(b), self.blocks.faces(b)
            self.assertEqual((len(vertices), [len(f) for f in faces]), (8, [4] * 6))
            total = np.zeros(3)
            for face in faces:
                p = vertices[face]
                normal = np.cross(p[2] - p[0], p[3] - p[1]) / 2
                total += normal
                self.assertGreater(normal @ (p.mean(axis=0) - self.blocks.centre[b]), 0.0)
            same(total, np.zeros(3))
            p = self.blocks.points[self.blocks.triangles[self.blocks.triangle_block == b]]
            normals = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]) / 2
            same(np.linalg.norm(normals, axis=1).sum(), area)
            same((normals * p[:, 0]).sum() / 3, volume)  # by Gauss' theorem

    def test_arrays_of_blocks_cannot_be_written(self):
        with self.assertRaises(ValueError):
            self.blocks.mass[0] = 1.0
        with self.assertRaises(ValueError):
            self.blocks.vertices(0)[0] = 1.0

    def test_snapshots_come_in_order_of_time_and_of_blocks(self):
        self.assertEqual(self.run_.steps.tolist(), [0, 10])
        same(self.run_.times, np.array([0.0, 0.5]))
        self.assertEqual((self.last.step, self.last.time), (10, 0.5))
        same(self.last.position, np.array([[2, 0, 0.5], [-2, 0, 1.5]]))
        same(self.last.velocity, np.array([[4, 0, 0], [0, 0, 1.0]]))
        same(self.last.spin, np.array([[0, 0, 2], [0, 3.0, 0]]))
        self.assertEqual(self.last.fragment.tolist(), [1, 7])
        same(self.last.broken_fraction, np.array([1, 0.25]))
        self.assertEqual([s.step for s in self.run_.snapshots()], [0, 10])

    def test_packed_snapshots_hold_the_same_to_the_digits_of_floats(self):
        packed = muckpile.Run(hand_made(packed=True)).snapshot()
        self.assertEqual((packed.step, packed.time), (self.last.step, self.last.time))
        for field in ("position", "rotation", "velocity", "spin", "fragment", "broken_fraction"):
            np.testing.assert_allclose(getattr(packed, field), getattr(self.last, field), rtol=1e-7, atol=1e-7)

    def test_snapshot_is_chosen_by_index_or_by_nearest_time(self):
        self.assertEqual(self.run_.snapshot(0).step, 0)
        self.assertEqual(self.run_.snapshot(-1).step, 10)
        self.assertEqual(self.run_.snapshot(time=0.2).step, 0)
        self.assertEqual(self.run_.snapshot(time=0.3).step, 10)

    def test_vertices_move_and_turn_with_their_block(self):
        same(self.run_.vertices_at(self.run_.snapshot(0)), self.blocks.points)
        half = 0.5**0.5
        same(self.last.rotation, np.array([[half, half, 0, 0], [half, 0, 0, half]]))
        cube, moved = np.split(self.run_.vertices_at(self.last), self.blocks.vertex_start[1:2])
        # A quarter turn about x takes (y, z) from the centre to (-z, y).
        arm = self.blocks.vertices(0) - np.array([-0.5, 0, 0.5])
        same(cube, np.array([2, 0, 0.5]) + np.stack([arm[:, 0], -arm[:, 2], arm[:, 1]], axis=1))
        # A quarter turn about z takes (x, y) from the centre to (-y, x).
        arm = self.blocks.vertices(1) - np.array([-2, 0, 1.5])
        same(moved, np.array([-2, 0, 1.5]) + np.stack([-arm[:, 1], arm[:, 0], arm[:, 2]], axis=1))
        same([moved.min(axis=0), moved.max(axis=0)], np.array([[-3, -0.5, 0], [-1, 0.5, 3]]))
        same(self.run_.displacement(self.last), np.array([[2.5, 0, 0], [0, 0, 0]]))

    def test_energy_and_momentum_are_those_of_the_boxes(self):
        # Cube: 2000 / 2 * 4^2 + 2000 / 6 / 2 * 2^2. Box: its x axis now lies along y, so that the
        # spin of 3 is about the axis of 13000 kg m2: 12000 / 2 * 1^2 + 13000 / 2 * 3^2.
        same(muckpile.block_energy(self.blocks, self.last), np.array([16000 + 2000 / 3, 64500]))
        same(muckpile.kinetic_energy(self.blocks, self.last, [1]), 64500)
        same(muckpile.kinetic_energy(self.blocks, self.last), 80500 + 2000 / 3)
        same(muckpile.momentum(self.blocks, self.last), np.array([8000, 0, 12000]))
        same(muckpile.mean_velocity(self.blocks, self.last), np.array([4 / 7, 0, 6 / 7]))
        same(muckpile.mass_centre(self.blocks), np.array([-12.5 / 7, 0, 9.5 / 7]))
        same(muckpile.mass_centre(self.blocks, self.last, self.blocks.id == 1), np.array([2, 0, 0.5]))

    def test_throw_and_face_velocity_are_those_of_the_cube(self):
        self.assertEqual(muckpile.burden_prism(self.run_).tolist(), [True, False])
        same(muckpile.throw(self.run_), 2.5)
        same(muckpile.throw(self.run_, self.run_.snapshot(0)), 0.0)
        same(muckpile.face_velocity(self.run_), 4.0)
        heights, speeds = muckpile.face_velocities(self.run_)
        same(heights, np.arange(0.05, 1.0, 0.1))
        self.assertEqual(speeds.shape, (2, 10))
        self.assertEqual(np.isfinite(speeds[1]).tolist(), [k in (4, 5) for k in range(10)])

    def test_only_the_cube_is_broken_out(self):
        # It moved by 2.5 m, more than its own 1 m and than the mean block of 1.52 m.
        self.assertEqual(muckpile.broken_out(self.blocks, self.last).tolist(), [True, False])
        self.assertEqual(muckpile.broken_out(self.blocks, self.last, 2.6).tolist(), [False, False])
        same(muckpile.pile_p50(self.blocks, self.last), 1.0)
        whole = muckpile.fragments_of(self.blocks, self.run_.snapshot(0))
        self.assertEqual((whole["id"].tolist(), whole["blocks"].tolist()), ([1], [2]))
        same(whole["size_m"], np.cbrt([7.0]))
        same(whole["position_m"], np.array([[-12.5 / 7, 0, 9.5 / 7]]))

    def test_size_curve_has_straight_lines_between_its_points(self):
        size, mass = np.array([4.0, 1.0, 2.0, 4.0]), np.array([1.0, 1.0, 1.0, 1.0])
        sizes, passing = muckpile.passing_curve(size, mass)
        same(sizes, np.array([1.0, 2.0, 4.0]))
        same(passing, np.array([0.25, 0.5, 1.0]))
        # The first of the two pieces of 4 m has passed at 0.75.
        same([muckpile.size_at(size, mass, share) for share in (0.1, 0.5, 0.625, 0.75, 1.0)],
             np.array([1.0, 2.0, 3.0, 4.0, 4.0]))

    def test_sizes_that_differ_by_rounding_are_one_point(self):
        size, mass = np.array([2.0, 1.0, np.nextafter(2.0, 3.0)]), np.array([1.0, 1.0, 1.0])
        sizes, _ = muckpile.passing_curve(size, mass)
        same(sizes, np.array([1.0, np.nextafter(2.0, 3.0)]))
        same([muckpile.size_at(size, mass, 0.5)], np.array([1.5]))  # 1 + (1/2 - 1/3)/(1/3)
        self.assertEqual(len(muckpile.passing_curve(np.array([1.0, 1.0 + 3e-6]), np.ones(2))[0]), 2)

    def test_tables_and_texts_are_read_as_they_stand(self):
        self.assertEqual(self.run_.run_id, RUN_ID)
        self.assertEqual(self.run_.scene["case"], "bench")
        self.assertIs(self.run_.record["still"], False)
        self.assertIsNone(self.run_.summary["swell_factor"])
        history = self.run_.history
        self.assertEqual(history["phase"].tolist(), ["wave", "throw"])
        self.assertEqual(history["step"].tolist(), [0, 10])
        same(history["kinetic_J"], np.array([0.0, 1500.0]))
        np.testing.assert_array_equal(self.run_.profile["pile_mean_m"], [0.5, np.nan])
        same(self.run_.profile["floor_m"], np.array([0.0, -0.25]))
