# SPDX-License-Identifier: GPL-2.0-or-later
"""The package as its users meet it: installed by pip, by the example, by the README.

Scope: pip works without a network, on what is installed; without pip that one test is skipped.
"""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import unittest

import muckpile
from runs import ROOT, scratch, simulated

PACKAGE = ROOT / "postproc" / "python"
PACKAGING = ("pip", "setuptools", "wheel")


def output_of(words, **settings):
    done = subprocess.run([sys.executable, *map(str, words)], capture_output=True, text=True, **settings)
    if done.returncode != 0:
        raise AssertionError(f"{words} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


class Package(unittest.TestCase):
    def test_version_is_that_of_muckpile(self):
        [version] = re.findall(r"^project\(Muckpile VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(), re.M)
        self.assertEqual(muckpile.__version__, version)

    def test_all_names_are_there_and_say_what_they_are(self):
        self.assertEqual(sorted(muckpile.__all__), muckpile.__all__)
        for name in muckpile.__all__:
            self.assertTrue(getattr(muckpile, name).__doc__, name)
        for name, member in vars(muckpile.Run).items():
            if not name.startswith("_"):
                self.assertTrue(member.__doc__, f"Run.{name}")

    @unittest.skipUnless(all(importlib.util.find_spec(part) for part in PACKAGING),
                         "pip, setuptools or wheel is missing: apt-get install python3-pip")
    def test_pip_installs_it_without_a_network(self):
        source, target = scratch() / "python", scratch()
        shutil.copytree(PACKAGE, source)  # building leaves files in the source
        output_of(["-m", "pip", "install", "--quiet", "--no-index", "--no-build-isolation", "--no-deps",
                   "--target", target, source])
        alone = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        show = "import muckpile, sys; print(muckpile.__file__, muckpile.Run(sys.argv[1]).times.size)"
        where, snapshots = output_of(["-c", show, simulated()], env=alone | {"PYTHONPATH": str(target)},
                                     cwd=target).split()
        self.assertTrue(where.startswith(str(target)), where)
        self.assertGreater(int(snapshots), 2)
        modules = {path.name for path in (PACKAGE / "muckpile").glob("*.py")}
        self.assertEqual({path.name for path in (target / "muckpile").glob("*.py")}, modules)

    def test_example_prints_the_figures_of_the_summary(self):
        text = output_of([PACKAGE / "examples" / "bench_in_numpy.py", simulated()])
        summary = muckpile.Run(simulated()).summary
        throws = re.findall(r"^ +[0-9.]+  +([-0-9.]+)  +[-0-9.]+$", text, re.M)
        self.assertIn(f"{summary['throw_cg_m']:.4f}", throws)
        self.assertIn(f"P50 {summary['fragment_p50_m']:.4f} m;", text)
        self.assertIn(f"  {summary['face_velocity_m_s']:8.2f}\n", text)
        kinetic = re.search(r"blocks ([0-9.]+) kJ, of history.csv ([0-9.]+) kJ", text)
        self.assertAlmostEqual(float(kinetic[1]), float(kinetic[2]), delta=1e-3 + 1e-6 * float(kinetic[2]))

    def test_code_of_the_readme_runs(self):
        parts = re.findall(r"^```python\n(.*?)^```", (PACKAGE / "README.md").read_text(), re.M | re.S)
        self.assertEqual(len(parts), 1)
        text = output_of(["-c", "\n".join(parts)], cwd=simulated().parent.parent)
        self.assertIn(f"{muckpile.throw(muckpile.Run(simulated())):.3f}", text)
