# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The thesis's five products (6.2.1 to 6.2.5) and others: nodelets, one nodelet and the offline program
write the same files from the same bag, byte for byte."""

import pathlib
import subprocess
import tempfile
import unittest

from launching import program, run_launch

SECONDS = 10  # of the office, as fast as it goes
PRODUCTS = ("ekf_wheel", "pf_wheel", "pf_visual", "ekf_wheel_pointmap", "pf_wheel_grid",
            "scan_grid", "ekf_ceiling", "ekf_laser", "ekf_wheel_imu", "ekf_wheel_lines",
            "graph_wheel", "graph_wheel_grid")
MAPS = {"ekf_wheel_pointmap": {"landmarks.yaml", "points.pcd"},
        "pf_wheel_grid": {"map.pgm", "map.yaml"},
        "scan_grid": {"map.pgm", "map.yaml"},
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
        cls.bag = cls.root / "office.bag"
        subprocess.run([program("slam_sim", "slam_sim"), cls.bag, "--robot", "skid", "--duration",
                        str(SECONDS)], check=True, stdout=subprocess.DEVNULL)

    def offline(self, product):
        run = self.root / product
        subprocess.run([program("slam_ros", "slam_run"), product, "--bag", self.bag, "--out", run],
                       check=True, stdout=subprocess.DEVNULL)
        found = files(run)
        # ./slam run says where the run comes from, a launch cannot
        found["config.yaml"] = found["config.yaml"].partition(b"run:\n")[0]
        return found

    def launched(self, product, composition):
        run = self.root / f"{product}_{composition}"
        output, _ = run_launch(f"product:={product}", f"bag:={self.bag}", "rate:=0",
                               f"composition:={composition}", f"output_dir:={run}")
        self.assertTrue(run.is_dir(), output)
        return files(run)

    def test_write_the_same_files_as_offline(self):
        for product in PRODUCTS:
            offline = self.offline(product)
            self.assertLessEqual({"trajectory.tum", *MAPS.get(product, {"landmarks.yaml"})},
                                 offline.keys())
            self.assertGreater(offline["trajectory.tum"].count(b"\n"), 5 * SECONDS)
            for composition in ("pubsub", "inprocess"):
                with self.subTest(product, composition=composition):
                    online = self.launched(product, composition)
                    self.assertEqual(online.keys(), offline.keys())
                    for name, content in online.items():
                        self.assertEqual(content, offline[name], name)


if __name__ == "__main__":
    unittest.main()
