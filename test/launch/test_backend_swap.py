# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""slam.launch with another back-end: one argument, the same files, maps that each can load."""

import itertools
import math
import pathlib
import re
import shutil
import tempfile
import unittest

from launching import cut_bag, make_demo_bag, run_launch, run_offline, SameAsOffline

BACKENDS = ("ekf", "pf", "graph", "seif")
FIRST, LAST = 15, 30  # [s] of the log: mapped, then localised in
FRAME = 0.1  # [s]; the last frame of the first part is where the second starts


def last_position(run):
    return [float(field) for field in
            (run / "trajectory.tum").read_text(encoding="ascii").splitlines()[-1].split()[1:3]]


def ids(run):
    return set(re.findall(r"id: (\d+)", (run / "landmarks.yaml").read_text(encoding="ascii")))


class BackendSwapTest(SameAsOffline, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp())
        make_demo_bag(cls.root / "log.bag")
        cut_bag(cls.root / "log.bag", cls.root / "first.bag", 0, FIRST)
        cut_bag(cls.root / "log.bag", cls.root / "second.bag", FIRST - 1.5 * FRAME, LAST)
        cut_bag(cls.root / "log.bag", cls.root / "both.bag", 0, LAST)
        for backend in BACKENDS:
            run_offline(cls.root / "first.bag", cls.root / backend, product=f"{backend}_wheel")
        run_offline(cls.root / "both.bag", cls.root / "both")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def launch(self, bag, run, *arguments):
        return run_launch(f"bag:={self.root / bag}", "rate:=0", f"output_dir:={run}", *arguments)[0]

    def test_one_argument_swaps_the_filter_in_either_composition(self):
        for backend, argument, composition in (("pf", "backend:=pf", "pubsub"),
                                               ("pf", "backend:=pf", "inprocess"),
                                               ("pf", "product:=pf_wheel", "pubsub"),
                                               ("graph", "backend:=graph", "pubsub"),
                                               ("graph", "backend:=graph", "inprocess"),
                                               ("seif", "backend:=seif", "pubsub"),
                                               ("seif", "backend:=seif", "inprocess")):
            with self.subTest(argument, composition=composition):
                run = self.root / f"swapped_{backend}_{argument[:7]}_{composition}"
                output = self.launch("first.bag", run, argument, f"composition:={composition}")
                self.assert_same_runs(run, self.root / backend, output)

    def test_each_localises_in_the_map_of_the_other(self):
        for backend, other in itertools.permutations(BACKENDS, 2):
            with self.subTest(backend, map_of=other):
                run = self.root / f"{backend}_in_map_of_{other}"
                output = self.launch("second.bag", run, f"backend:={backend}", "mode:=localization",
                                     "robot:=mrpt_demo",
                                     f"load_map:={self.root / other / 'landmarks.yaml'}")
                self.assertTrue((run / "trajectory.tum").exists(), output)
                self.assertEqual(ids(run), ids(self.root / other))
                error = math.dist(last_position(run), last_position(self.root / "both"))
                self.assertLess(error, 0.1)  # [m]


if __name__ == "__main__":
    unittest.main()
