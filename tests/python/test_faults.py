# SPDX-License-Identifier: GPL-2.0-or-later
"""Files that are missing, cut short, damaged or of another run, and questions without an answer.

Each must end with ResultError that names the file, and with no other exception.
"""

import random
import re
import unittest

import muckpile
from runs import OTHER_ID, RUN_ID, blocks_file, hand_made

BLOCKS, LAST = "dump/blocks.vtk", "dump/blocks_000000010.csv"
HISTORY, SCENE, RECORD = "dump/history.csv", "dump/scene.json", "dump/run.json"
CUBE = ((0, 0, 0), (1, 1, 1))


def read_all(folder):
    run = muckpile.Run(folder)
    for _ in run.snapshots():
        pass
    return run, run.blocks, run.scene, run.record, run.history, run.summary, run.profile


class Faults(unittest.TestCase):
    def setUp(self):
        self.folder = hand_made()

    def edit(self, name, old, new):
        text = (self.folder / name).read_text()
        self.assertIn(old, text, "the fault must change the file")
        (self.folder / name).write_text(text.replace(old, new, 1))

    def refused(self, message, action=None):
        with self.assertRaises(muckpile.ResultError) as caught:
            (action or (lambda: read_all(self.folder)))()
        self.assertRegex(str(caught.exception), message)

    def test_sound_files_are_not_refused(self):
        read_all(self.folder)

    def test_missing_files_are_named_with_what_to_do(self):
        for name in (BLOCKS, HISTORY, SCENE, RECORD):
            self.folder = hand_made()
            (self.folder / name).unlink()
            self.refused(f"{re.escape(name)}: is not there; give the folder of a run")
        self.folder = hand_made()
        self.refused("has no folder dump/; give the folder that a run wrote",
                     lambda: muckpile.Run(self.folder / "dump"))
        for path in self.folder.glob("dump/blocks_*.csv"):
            path.unlink()
        self.refused("holds no blocks_<step>.csv or .bin", lambda: muckpile.Run(self.folder).snapshot())

    def test_files_cut_anywhere_are_refused(self):
        for name in (BLOCKS, LAST, SCENE, RECORD, HISTORY):
            self.folder = hand_made()
            whole = (self.folder / name).read_bytes()
            for length in range(0, len(whole), 1 if len(whole) < 500 else 7):
                if name == HISTORY and whole[:length].count(b"\n") > 1 and whole[:length].endswith(b"\n"):
                    continue  # whole rows, as of a run that has not ended
                (self.folder / name).write_bytes(whole[:length])
                with self.subTest(name=name, length=length):
                    self.refused(re.escape(str(self.folder)))

    def test_packed_snapshots_that_are_cut_or_damaged_end_in_no_other_exception(self):
        self.folder = hand_made(packed=True)
        last = self.folder / "dump/blocks_000000010.bin"
        whole = last.read_bytes()
        for length in range(len(whole)):
            last.write_bytes(whole[:length])
            with self.subTest(length=length):
                self.refused(re.escape(str(self.folder)))
        dice, refusals = random.Random(2), 0
        for _ in range(300):
            damaged = bytearray(whole)
            damaged[dice.randrange(len(whole))] = dice.randrange(256)
            last.write_bytes(damaged)
            try:
                read_all(self.folder)
            except muckpile.ResultError as error:
                self.assertIn(str(self.folder), str(error))
                refusals += 1
        self.assertGreater(refusals, 150, "damage of header, ids and turns must be seen")

    def test_damaged_bytes_end_in_no_other_exception(self):
        dice = random.Random(1)
        refusals = 0
        for name in (BLOCKS, LAST, SCENE, RECORD, HISTORY, "summary.json", "profile.csv"):
            whole = (self.folder / name).read_bytes()
            for _ in range(150):
                damaged = bytearray(whole)
                damaged[dice.randrange(len(whole))] = dice.choice(b"0179-.eE,\n {}[]\"anx\x00\xff#=")
                (self.folder / name).write_bytes(damaged)
                with self.subTest(name=name, damaged=bytes(damaged)):
                    try:
                        read_all(self.folder)
                    except muckpile.ResultError:
                        refusals += 1
            (self.folder / name).write_bytes(whole)
        self.assertGreater(refusals, 300, "most damage must be seen")

    def test_files_of_two_runs_are_refused_and_named(self):
        for name in (BLOCKS, LAST, HISTORY, SCENE, RECORD):
            self.folder = hand_made()
            self.edit(name, RUN_ID, OTHER_ID)
            self.refused(f"is of run ({RUN_ID}|{OTHER_ID}), but .* is of run .*: files of two runs lie in one folder",
                         lambda: muckpile.Run(self.folder))
            self.refused(re.escape(name), lambda: muckpile.Run(self.folder))
        self.folder = hand_made()
        self.edit(LAST, f" run={RUN_ID}", "")
        self.refused("has no run id, but", lambda: muckpile.Run(self.folder))
        self.folder = hand_made()
        text = (self.folder / HISTORY).read_text()
        (self.folder / HISTORY).write_text(f"{text}20,1,throw,1,{OTHER_ID}\n")
        self.refused(f"history.csv:4 is of run {OTHER_ID}", lambda: muckpile.Run(self.folder))

    def test_files_without_any_id_are_read_as_they_are(self):
        for path in self.folder.rglob("*.*"):
            if path.is_file():
                text = path.read_text().replace(f" run={RUN_ID}", "").replace(f', "run_id": "{RUN_ID}"', "")
                text = text.replace(f'"run_id": "{RUN_ID}", ', "").replace(RUN_ID, "-")
                path.write_text(text)
        run, *_ = read_all(self.folder)
        self.assertEqual(run.run_id, "")

    def test_measures_of_another_run_are_refused(self):
        self.edit("summary.json", RUN_ID, OTHER_ID)
        for action in (lambda: muckpile.Run(self.folder).summary, lambda: muckpile.Run(self.folder).profile):
            self.refused("summary.json: is of another run than dump/; measure the run anew", action)
        (self.folder / "summary.json").unlink()
        self.assertIsNone(muckpile.Run(self.folder).summary)
        self.refused("summary.json: is not there; measure the run: muckpile-post all",
                     lambda: muckpile.Run(self.folder).profile)

    def test_tables_that_were_not_made_say_why(self):
        (self.folder / "profile.csv").unlink()
        self.refused("profile.csv: is not there; measure the run", lambda: muckpile.Run(self.folder).profile)
        self.edit("summary.json", '"swell_factor": null', '"profile_refused": "profile: the face leans"')
        self.refused("the face leans", lambda: muckpile.Run(self.folder).profile)
        self.refused("the face leans", lambda: muckpile.throw(muckpile.Run(self.folder)))

    def test_history_without_rows_is_refused(self):
        self.edit(HISTORY, (self.folder / HISTORY).read_text(), "step,time_s,run_id\n")
        self.refused("history.csv: holds no rows", lambda: muckpile.Run(self.folder).history)

    def test_rows_of_snapshots_name_file_line_and_value(self):
        for old, new, message in (
            ("1,2,0,0.5", "8,2,0,0.5", r"blocks_000000010.csv:4: id 8 is not a block of blocks.vtk"),
            ("1,2,0,0.5", "7,2,0,0.5", r"blocks_000000010.csv:4: id 7 occurs twice"),
            ("1,2,0,0.5", "1.5,2,0,0.5", r":4: id must be a whole number, got '1.5'"),
            ("1,2,0,0.5", "1,2,nan,0.5", r":4: y_m must be a finite number, got 'nan'"),
            ("1,2,0,0.5", "1,2,x,0.5", r":4: y_m must be a finite number, got 'x'"),
            ("1,2,0,0.5", "1,2,,0.5", r":4: y_m must be a finite number, got ''"),
            ("1,2,0,0.5", "1,2,0.5", r":4: must have 16 fields, got 15"),
            ("0.7071", "0.71", r":3: qw, qx, qy, qz must be a unit quaternion, got length '1.00"),
            ("qw", "qv", r"has no column 'qw'"),
            ("x_m,y_m", "x_m,x_m", r"each column must have a name of its own"),
            ("step=10 ", "", r"the first line must hold '# step=<n> time_s=<t>'"),
        ):
            with self.subTest(new=new):
                self.folder = hand_made()
                self.edit(LAST, old, new)
                self.refused(message)
        self.folder = hand_made()
        text = (self.folder / LAST).read_text()
        (self.folder / LAST).write_text(text[:text.rindex("\n1,") + 1])
        self.refused("blocks_000000010.csv: block 1 has no row")

    def test_faults_of_the_blocks_name_the_file(self):
        for old, new, message in (
            ("# vtk", "# VTK", "is no legacy VTK file"),
            ("POINTS 16", "POINTS 99999999999", "POINTS: must be 299999999997 numbers, got 48"),
            ("POINTS 16", "POINTS -1", "POINTS must say how many"),
            ("CELLS 2 64", "CELLS 3 64", "CELL_TYPES must be 42 .* for each of 3 cells"),
            ("CELLS 2 64", "CELLS 2 65", "CELLS: must be 65 numbers, got 64"),
            ("CELLS 2 64", "CELLS 0 64", "at least one cell"),
            ("31 6 4", "40 6 4", "cut short|behind its last cell"),
            ("31 6 4", "31 5 4", "must be a closed polyhedron"),
            ("31 6 4 0 1", "31 6 4 0 77", "a face has a point that is not in the file"),
            ("31 6 4", "31 6 2", "the faces of cell 1 are cut short"),
            ("42\n", "12\n", "CELL_TYPES must be 42"),
            ("CELL_DATA 2", "CELL_DATA 3", "CELL_DATA must be for 2 cells, got 3"),
            ("\n7\n1\n", "\n7\n7\n", "id 7 occurs twice"),
            ("\n7\n1\n", "\n7\n-1\n", "id must be a whole number >= 1, got '-1'"),
            ("\n6.0\n1.0\n", "\n6.2\n1.0\n", "block 7: volume_m3 must be its polyhedron's 6 m3, got '6.2'"),
            ("\n6.0\n1.0\n", "\n6.0\n1.0\n1.0\n", "volume_m3: must be 2 numbers, got 3"),
            ("\n12000.0\n", "\n-12000.0\n", "mass_kg must be > 0 kg, got '-12000'"),
            ("SCALARS mass_kg", "SCALARS mass_g", "has no cell data 'mass_kg'"),
            ("1.8171", "0.0 ", "size_m: must be 2 numbers"),
            ("-2.5", "inf", "numbers must be finite|holds what is no number"),
        ):
            with self.subTest(new=new):
                self.folder = hand_made()
                self.edit(BLOCKS, old, new)
                self.refused(message)
                self.refused("blocks.vtk")

    def test_box_with_hundredth_of_its_volume_missing_is_refused(self):
        (self.folder / BLOCKS).write_text(
            blocks_file({1: CUBE, 7: CUBE}).replace("volume_m3 double 1\nLOOKUP_TABLE default\n1\n",
                                                    "volume_m3 double 1\nLOOKUP_TABLE default\n1.02\n"))
        self.refused(r"block 1: volume_m3 must be its polyhedron's 1 m3, got '1.02'")

    def test_questions_without_an_answer_are_refused(self):
        run = muckpile.Run(self.folder)
        self.refused("time must be >= 0 s and <= 0.5 s, got '0.6'", lambda: run.snapshot(time=0.6))
        for none in ([], [False, False]):
            self.refused("at least one block", lambda: muckpile.momentum(run.blocks, run.snapshot(), none))
        self.refused("needs at least one piece", lambda: muckpile.pile_p50(run.blocks, run.snapshot(0)))
        with self.assertRaisesRegex(IndexError, "has 2 snapshots, got index '2'"):
            run.snapshot(2)
        with self.assertRaisesRegex(TypeError, r"for a time write snapshot\(time=...\)"):
            run.snapshot(0.5)
        with self.assertRaisesRegex(ValueError, "not both"):
            run.snapshot(1, time=0.1)
        with self.assertRaisesRegex(ValueError, "passing must be >= 0 and <= 1, got '50'"):
            muckpile.size_at([1.0], [1.0], 50)
        self.edit(SCENE, '"case": "bench"', '"case": "crater"')
        crater = (self.folder / SCENE).read_text()
        self.edit(SCENE, '"bench_height_m"', '"height_m"')
        for measure in (muckpile.throw, muckpile.face_velocity):
            self.refused("the run must be a bench, got 'crater'", lambda: measure(muckpile.Run(self.folder)))
        (self.folder / SCENE).write_text(crater)
        self.edit(SCENE, '"case": "crater", "burden_m": 1.0', '"case": "bench", "burden_m": "1 m"')
        self.refused("burden_m must be a number, got '1 m'", lambda: muckpile.throw(muckpile.Run(self.folder)))
