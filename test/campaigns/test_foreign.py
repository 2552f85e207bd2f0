# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Foreign systems in campaigns: MRPT's, a node that publishes map -> odom, and a driver of one's
own."""
import csv
import os
import pathlib
import tempfile
import unittest

from campaigns import InFolder, require_snakemake

SYSTEMS = pathlib.Path(__file__).resolve().parent / "foreign"
CAMPAIGN = """
version: 1
campaign: foreign
bags:
  - {world: office, only: [SENSORS], duration: 8}
products:
PRODUCTS
metrics: [ate_rmse_m, landmark_rmse_m, map_walls_found_percent]
"""


def setUpModule():
    require_snakemake()


class Foreign(InFolder):
    def campaign(self, sensors, *products):
        """The metrics of each product, by its name, as numbers."""
        text = CAMPAIGN.replace("SENSORS", sensors).replace(
            "PRODUCTS", "".join(f"  - {product}\n" for product in products))
        out = self.folder / "out"
        with tempfile.TemporaryDirectory() as home:
            self.run_campaign(self.write(text), out, ROS_HOME=home)
        with open(out / "runs.csv", encoding="utf-8", newline="") as stream:
            rows = {row["product"]: row for row in csv.DictReader(stream)}
        for row in rows.values():
            self.assertEqual(row["why"], "")
        return {name: {key: float(value) for key, value in row.items()
                       if key.endswith(("_m", "_percent")) and value}
                for name, row in rows.items()}

    def test_systems_of_mrpt_map_with_a_laser(self):
        found = self.campaign("odom, scan", "foreign: mrpt_rbpf", "scan_grid_wheel")
        self.assertLess(found["mrpt_rbpf"]["ate_rmse_m"], 0.05)
        self.assertGreater(found["mrpt_rbpf"]["map_walls_found_percent"], 50.0)
        self.assertAlmostEqual(found["mrpt_rbpf"]["odometry_ate_rmse_m"],
                               found["scan_grid_wheel"]["odometry_ate_rmse_m"], places=3)

    def test_systems_of_mrpt_map_markers(self):
        found = self.campaign("odom, camera", "foreign: mrpt_kf", "ekf_wheel")["mrpt_kf"]
        self.assertLess(found["ate_rmse_m"], 0.05)
        self.assertLess(found["landmark_rmse_m"], 0.1)

    def test_nodes_are_judged_by_the_transform_that_they_publish(self):
        found = self.campaign("odom, scan", f"foreign: {SYSTEMS / 'own_nodelets.yaml'}",
                              "scan_grid_wheel")
        self.assertLess(found["own_nodelets"]["ate_rmse_m"],
                        found["scan_grid_wheel"]["ate_rmse_m"] + 0.02)
        self.assertGreater(found["own_nodelets"]["map_walls_found_percent"], 50.0)

    def test_drivers_of_ones_own_stand_beside_their_file(self):
        path = SYSTEMS / "dead_reckoning.yaml"
        found = self.campaign("odom", f"foreign: {path}",
                              f"{{name: bent, foreign: {path}, set: {{scale: 1.5}}}}")
        self.assertLess(found["dead_reckoning"]["ate_rmse_m"], found["bent"]["ate_rmse_m"])


class Silent(InFolder):
    def test_is_told_of_topics_to_which_nobody_listens(self):
        (self.folder / "deaf.launch").write_text("<launch/>", encoding="utf-8")
        text = (SYSTEMS / "own_nodelets.yaml").read_text(encoding="utf-8")
        text = text.replace("own_nodelets.launch", "deaf.launch").replace("/tf /tf_static", "/tf")
        text = "\n".join(line for line in text.splitlines() if "arg." not in line)
        path = self.write(f"{text}\n  patience: 1\n", "deaf.yaml")
        campaign = CAMPAIGN.replace("SENSORS", "odom, scan").replace(
            "PRODUCTS", f"  - foreign: {path}\n")
        done = self.call(self.write(campaign), "--out", self.folder / "ap'os")
        self.assertIn("nobody listened to /odom, /scan, /tf 1 s after the start", done.stdout)


class WrongUse(InFolder):
    def refuses_system(self, text, *says):
        path = self.write(text, "some.yaml")
        campaign = CAMPAIGN.replace("SENSORS", "odom").replace("PRODUCTS", f"  - foreign: {path}\n")
        self.refuses(self.write(campaign), "--out", self.folder / "out", says=says)

    def test_is_told_of_a_driver_that_is_missing(self):
        text = (SYSTEMS / "dead_reckoning.yaml").read_text(encoding="utf-8")
        self.refuses_system(text, "there is no", "dead_reckoning.py", "driver")
        self.refuses_system(text.replace("dead_reckoning.py", "slam_eval.foreign.nobody"),
                            "cannot be imported")
        self.refuses_system(text.replace("dead_reckoning.py:D", "slam_eval.foreign.ros_node:D"),
                            "has no class 'DeadReckoning'")
        self.refuses_system(text.replace("dead_reckoning.py:", ""), "MODULE:CLASS")
        self.refuses_system(text.replace("version: 1", "version: 3"), "'version: 1'")

    def test_is_told_of_a_launch_file_that_is_missing(self):
        text = (SYSTEMS / "own_nodelets.yaml").read_text(encoding="utf-8")
        self.refuses_system(text, "there is no launch file", "own_nodelets.launch")

    def test_is_told_which_package_brings_a_program(self):
        folder = self.folder / "bin"
        folder.mkdir()
        for name in ("ldd", "rospack", "python3", "snakemake", "env", "sh", "bash"):
            for place in os.environ["PATH"].split(os.pathsep):
                if os.access(f"{place}/{name}", os.X_OK):
                    (folder / name).symlink_to(f"{place}/{name}")
                    break
        campaign = CAMPAIGN.replace("SENSORS", "odom").replace("PRODUCTS", "  - foreign: mrpt_kf\n")
        self.refuses(self.write(campaign), "--out", self.folder / "out", PATH=str(folder),
                     says=["mrpt_kf cannot be run", "install mrpt-apps"])


if __name__ == "__main__":
    unittest.main()
