# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Online runs of bags and into folders whose names roslaunch itself cannot carry."""

import os
import pathlib
import subprocess
import tempfile
import unittest

from launching import cut_bag, free_port, make_demo_bag, program, run_offline

ODD = "it's a := \"place\""


class OddNames(unittest.TestCase):
    def test_an_online_run_is_as_the_offline_one(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            odd = root / ODD
            odd.mkdir()
            make_demo_bag(root / "demo.bag")
            cut_bag(root / "demo.bag", odd / "a b.bag", 0, 5)
            run_offline(odd / "a b.bag", root / "offline")
            environment = {**os.environ, "ROS_MASTER_URI": f"http://localhost:{free_port()}"}
            done = subprocess.run(
                [program("slam_ros", "slam_run"), "ekf_wheel", "--bag", odd / "a b.bag", "--out",
                 odd / "run", "--online"], env=environment, text=True, check=False, timeout=120,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(done.returncode, 0, done.stdout)
            for name in ("trajectory.tum", "landmarks.yaml", "ground_truth.tum"):
                self.assertEqual((odd / "run" / name).read_bytes(),
                                 (root / "offline" / name).read_bytes(), name)


if __name__ == "__main__":
    unittest.main()
