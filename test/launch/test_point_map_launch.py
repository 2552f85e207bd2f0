# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""ekf_wheel_pointmap in the simulated office for seconds: the same points in each way to run."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

from launching import play_into_launch, program, run_launch, run_offline, SameAsOffline

SECONDS = 8
PRODUCT = "ekf_wheel_pointmap"
TOPICS = ("/odom", "/scan", "/camera/image_raw/compressed", "/camera/camera_info", "/tf_static")


def read_points(run):
    """Returns the header of a points.pcd as a map, and its rows of numbers."""
    header, _, body = (run / "points.pcd").read_text(encoding="ascii").partition("DATA ascii\n")
    words = (line.split(maxsplit=1) for line in header.splitlines())
    return dict(words), [[float(word) for word in line.split()] for line in body.splitlines()]


class PointMapLaunchTest(SameAsOffline, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp())
        cls.bag = cls.root / "office.bag"
        subprocess.run([program("slam_sim", "slam_sim"), cls.bag, "--duration", str(SECONDS),
                        "--only", "odom,camera,scan"], check=True, stdout=subprocess.DEVNULL)
        run_offline(cls.bag, cls.root / "offline", product=PRODUCT)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def assert_same_points(self, run, output):
        self.assert_same_runs(run, self.root / "offline", output)
        self.assertEqual((run / "points.pcd").read_bytes(),
                         (self.root / "offline/points.pcd").read_bytes(), output)

    def test_the_file_holds_what_its_header_says(self):
        header, points = read_points(self.root / "offline")
        self.assertEqual(header["FIELDS"], "x y z intensity")
        self.assertEqual(int(header["POINTS"]), len(points))
        self.assertGreater(len(points), 200)
        self.assertTrue(all(len(point) == 4 and point[2] == 0 for point in points))
        self.assertGreater(sum(point[3] for point in points), 5 * len(points))

    def test_the_point_map_has_no_effect_on_the_filter(self):
        run_offline(self.bag, self.root / "without", product="ekf_wheel")
        self.assertEqual((self.root / "without/trajectory.tum").read_bytes(),
                         (self.root / "offline/trajectory.tum").read_bytes())
        self.assertFalse((self.root / "without/points.pcd").exists())

    def replay_without_loss(self, composition):
        run = self.root / composition
        output, _ = run_launch(f"product:={PRODUCT}", f"bag:={self.bag}", "rate:=0",
                               f"composition:={composition}", f"output_dir:={run}")
        self.assert_same_points(run, output)
        self.assertNotIn("WARN", output)

    def test_pubsub_without_loss_equals_offline(self):
        self.replay_without_loss("pubsub")

    def test_inprocess_without_loss_equals_offline(self):
        self.replay_without_loss("inprocess")

    def test_pubsub_at_rate_2_equals_offline(self):
        run = self.root / "played"
        output = play_into_launch(self.bag, TOPICS, 2, self.root / "offline",
                                  f"product:={PRODUCT}", "robot:=sim_segway", f"output_dir:={run}")
        self.assert_same_points(run, output)
        self.assertNotIn("has died", output)

    def test_any_product_can_have_a_point_map_beside_it(self):
        run = self.root / "pf"
        run_launch("backend:=pf", "pointmap:=true", f"bag:={self.bag}", "rate:=0",
                   f"output_dir:={run}")
        run_offline(self.bag, self.root / "pf_offline", "--set", "pointmap=true",
                    product="pf_wheel")
        self.assertEqual((run / "points.pcd").read_bytes(),
                         (self.root / "pf_offline/points.pcd").read_bytes())

    def test_a_product_with_a_point_map_needs_scans(self):
        bag = self.root / "blind.bag"
        subprocess.run([program("slam_sim", "slam_sim"), bag, "--duration", "1", "--only",
                        "odom,camera"], check=True, stdout=subprocess.DEVNULL)
        with self.assertRaises(subprocess.CalledProcessError) as failure:
            run_offline(bag, self.root / "blind", product=PRODUCT)
        self.assertIn("lacks laser scans: 'scan' (sensor_msgs/LaserScan)", failure.exception.stdout)


if __name__ == "__main__":
    unittest.main()
