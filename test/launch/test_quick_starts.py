# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""docs/quickstart.md with a live robot: its robot_state_publisher tells where the laser sits."""

import os
import pathlib
import subprocess
import tempfile
import time
import unittest

from launching import (free_port, largest_error, program, run_offline, SameAsOffline, start_launch)
import rosbag

SECONDS = 15  # of the drive
PRODUCT = "scan_grid_wheel"
TURTLEBOT = """
<robot name="turtlebot3">
  <link name="base_footprint"/> <link name="base_link"/> <link name="base_scan"/>
  <joint name="base_joint" type="fixed">
    <parent link="base_footprint"/> <child link="base_link"/> <origin xyz="0 0 0.010"/>
  </joint>
  <joint name="scan_joint" type="fixed">
    <parent link="base_link"/> <child link="base_scan"/> <origin xyz="-0.032 0 0.172"/>
  </joint>
</robot>
"""


class RobotStatePublisher:
    """A master of its own with a robot's bringup, as far as it tells where sensors sit."""

    def __init__(self, description):
        self.port = free_port()
        environment = {**os.environ, "ROS_MASTER_URI": f"http://localhost:{self.port}"}
        self.processes = [subprocess.Popen(["roscore", "-p", str(self.port)], env=environment,
                                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)]
        self.until_it_works(environment, "rosparam", "set", "robot_description", description)
        self.processes.append(subprocess.Popen(
            ["rosrun", "robot_state_publisher", "robot_state_publisher"], env=environment))
        self.until_it_works(environment, "rostopic", "echo", "-n", "1", "/tf_static")

    @staticmethod
    def until_it_works(environment, *command):
        end = time.monotonic() + 30
        while subprocess.run(command, env=environment, stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, timeout=30, check=False).returncode != 0:
            assert time.monotonic() < end, f"{command} failed"
            time.sleep(0.2)

    def close(self):
        for process in reversed(self.processes):
            process.terminate()
            process.wait()


class TurtleBotTest(SameAsOffline, unittest.TestCase):

    files = ("trajectory.tum", "map.pgm", "map.yaml")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        whole = self.root / "whole.bag"
        subprocess.run([program("slam_sim", "slam_sim"), whole, "--robot", "turtlebot3", "--only",
                        "odom,scan", "--duration", str(SECONDS)], check=True,
                       stdout=subprocess.DEVNULL)
        run_offline(whole, self.root / "offline", product=PRODUCT)
        self.bag = self.root / "driver.bag"
        with rosbag.Bag(str(whole)) as source, rosbag.Bag(str(self.bag), "w") as target:
            for topic, message, stamp in source.read_messages(topics=["/odom", "/scan"]):
                target.write(topic, message, stamp)

    def test_maps_with_the_shipped_robot_file(self):
        robot = RobotStatePublisher(TURTLEBOT)
        self.addCleanup(robot.close)
        run = self.root / "live"
        launch, _ = start_launch(f"product:={PRODUCT}", "robot:=turtlebot3", f"bag:={self.bag}",
                                 "rate:=0", f"output_dir:={run}", port=robot.port)
        self.addCleanup(launch.kill)
        output = launch.communicate(timeout=60)[0]
        self.assert_same_runs(run, self.root / "offline", output)
        self.assertLess(largest_error(self.root / "offline"), 0.05)


if __name__ == "__main__":
    unittest.main()
