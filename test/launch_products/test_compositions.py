# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The thesis's five products (6.2.1 to 6.2.5) and others: nodelets, one nodelet and the offline program
write the same files from the same bag, byte for byte."""

import pathlib
import subprocess
import tempfile
import unittest

from launching import program, run_launch
import yaml

SECONDS = 10  # of the office, as fast as it goes
PRODUCTS = ("ekf_wheel", "pf_wheel", "pf_visual", "ekf_wheel_pointmap", "pf_wheel_grid",
            "scan_grid", "ekf_ceiling", "ekf_laser", "ekf_wheel_imu", "ekf_wheel_lines",
            "graph_wheel", "graph_wheel_grid", "rat_visual", "graph_mono")
TWO_OF_EACH = ("second_detector=aruco", "second_camera=true")
TWO_LASERS = {"scan_grid_wheel": ("pointmap=true",), "pf_wheel_grid": (), "graph_wheel_grid": ()}
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


class CompositionsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)
        cls.bags = {}
        for world, robot in (("office", "skid"), ("foyer", "scout"), ("office", "twin")):
            bag = cls.bags[robot] = cls.root / f"{robot}.bag"
            subprocess.run([program("slam_sim", "slam_sim"), bag, "--world", world, "--robot", robot,
                            "--duration", str(SECONDS)], check=True, stdout=subprocess.DEVNULL)

    def offline(self, product, robot, features):
        run = self.root / f"{product}_{robot}"
        words = [word for feature in features for word in ("--set", feature)]
        subprocess.run([program("slam_ros", "slam_run"), product, "--bag", self.bags[robot],
                        "--out", run, *words], check=True, stdout=subprocess.DEVNULL)
        found = files(run)
        # ./slam run says where the run comes from, a launch cannot
        found["config.yaml"] = found["config.yaml"].partition(b"run:\n")[0]
        return found

    def launched(self, product, robot, features, composition):
        run = self.root / f"{product}_{robot}_{composition}"
        output, _ = run_launch(f"product:={product}", f"bag:={self.bags[robot]}", "rate:=0",
                               f"composition:={composition}", f"output_dir:={run}",
                               *(feature.replace("=", ":=") for feature in features))
        self.assertTrue(run.is_dir(), output)
        return files(run)

    def assert_same_as_offline(self, product, robot="skid", features=()):
        offline = self.offline(product, robot, features)
        self.assertLessEqual({"trajectory.tum", *MAPS.get(product, {"landmarks.yaml"})},
                             offline.keys())
        self.assertGreater(offline["trajectory.tum"].count(b"\n"), 5 * SECONDS)
        for composition in ("pubsub", "inprocess"):
            with self.subTest(product, features=features, composition=composition):
                online = self.launched(product, robot, features, composition)
                self.assertEqual(online.keys(), offline.keys())
                for name, content in online.items():
                    self.assertEqual(content, offline[name], name)
        return offline

    def test_write_the_same_files_as_offline(self):
        for product in PRODUCTS:
            self.assert_same_as_offline(product)

    def test_do_so_with_two_kinds_of_markers_and_two_cameras(self):
        for product in ("ekf_wheel", "pf_wheel", "graph_wheel"):
            run = self.assert_same_as_offline(product, "scout", TWO_OF_EACH)
            ids = [landmark["id"] for landmark in yaml.safe_load(run["landmarks.yaml"])["landmarks"]]
            self.assertTrue(any(number < 587 for number in ids), ids)
            self.assertTrue(any(10000 <= number < 10050 for number in ids), ids)

    def test_do_so_with_two_lasers(self):
        for product, features in TWO_LASERS.items():
            self.assert_same_as_offline(product, "twin", ("rear_laser=true", *features))


if __name__ == "__main__":
    unittest.main()
