# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Nodelets, one nodelet and the offline program write the same files from the same bag, byte for byte."""

import pathlib
import subprocess
import tempfile

from launching import program, run_launch

SECONDS = 10  # of a drive, as fast as it goes
MAPS = {"ekf_wheel_pointmap": {"landmarks.yaml", "points.pcd"},
        "pf_wheel_grid": {"map.pgm", "map.yaml"},
        "scan_grid": {"map.pgm", "map.yaml"},
        "scan_grid_wheel": {"map.pgm", "map.yaml", "points.pcd"},
        "graph_mono": {"graph.csv", "places.csv"},
        "rat_visual": {"graph.csv", "places.csv"},
        "graph_wheel_grid": {"map.pgm", "map.yaml"}}
OTHERS = {"metrics.json",  # tells how long it took, too
          # what else a bag has, which the offline program writes beside a run
          "ground_truth.tum", "ground_truth_landmarks.yaml", "wheel_odometry.tum"}


def files(run):
    """Returns the bytes of the files that a product writes, by name."""
    return {path.name: path.read_bytes() for path in run.iterdir() if path.name not in OTHERS}


class Compositions:
    """For a TestCase of a robot that drives through a world."""

    WORLD, ROBOT = "office", "skid"

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)
        cls.bag = cls.root / "drive.bag"
        subprocess.run([program("slam_sim", "slam_sim"), cls.bag, "--world", cls.WORLD, "--robot",
                        cls.ROBOT, "--duration", str(SECONDS)], check=True,
                       stdout=subprocess.DEVNULL)

    def offline(self, product, features):
        run = self.root / product
        words = [word for feature in features for word in ("--set", feature)]
        subprocess.run([program("slam_ros", "slam_run"), product, "--bag", self.bag,
                        "--out", run, *words], check=True, stdout=subprocess.DEVNULL)
        found = files(run)
        # ./slam run says where the run comes from, a launch cannot
        found["config.yaml"] = found["config.yaml"].partition(b"run:\n")[0]
        return found

    def launched(self, product, features, composition):
        run = self.root / f"{product}_{composition}"
        output, _ = run_launch(f"product:={product}", f"bag:={self.bag}", "rate:=0",
                               f"composition:={composition}", f"output_dir:={run}",
                               *(feature.replace("=", ":=") for feature in features))
        self.assertTrue(run.is_dir(), output)
        return files(run)

    def assert_same_as_offline(self, product, features=()):
        offline = self.offline(product, features)
        self.assertLessEqual({"trajectory.tum", *MAPS.get(product, {"landmarks.yaml"})},
                             offline.keys())
        self.assertGreater(offline["trajectory.tum"].count(b"\n"), 5 * SECONDS)
        for composition in ("pubsub", "inprocess"):
            with self.subTest(product, features=features, composition=composition):
                online = self.launched(product, features, composition)
                self.assertEqual(online.keys(), offline.keys())
                for name, content in online.items():
                    self.assertEqual(content, offline[name], name)
        return offline
