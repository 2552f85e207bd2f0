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


def description(name, links, laser):
    """Returns a URDF: a chain of fixed links, of which the last one is the laser at x y z [m]."""
    places = ["0 0 0"] * (len(links) - 2) + [laser]
    joints = [f'<joint name="{child}_joint" type="fixed"><parent link="{parent}"/>'
              f'<child link="{child}"/><origin xyz="{place}"/></joint>'
              for parent, child, place in zip(links, links[1:], places)]
    parts = [f'<link name="{link}"/>' for link in links] + joints
    return f'<robot name="{name}">{"".join(parts)}</robot>'


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


class Bringup(SameAsOffline):
    """For a TestCase: a product maps with a shipped robot file beside a robot's bringup, which has
    topics of its own and tells by its robot_state_publisher alone where the laser sits."""

    files = ("trajectory.tum", "map.pgm", "map.yaml")
    robot = None      # the robot file
    simulated = None  # the simulated robot that takes its place
    topics = {"/odom": "/odom", "/scan": "/scan"}  # the robot's names by those of the simulator
    links, laser = None, None  # of its description

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        drive = self.root / "drive.bag"
        subprocess.run([program("slam_sim", "slam_sim"), drive, "--robot", self.simulated, "--only",
                        "odom,scan", "--duration", str(SECONDS)], check=True,
                       stdout=subprocess.DEVNULL)
        whole, self.bag = self.root / "whole.bag", self.root / "driver.bag"
        with rosbag.Bag(str(drive)) as source, rosbag.Bag(str(whole), "w") as recorded, \
                rosbag.Bag(str(self.bag), "w") as driver:
            for topic, message, stamp in source.read_messages():
                recorded.write(self.topics.get(topic, topic), message, stamp)
                if topic in self.topics:
                    driver.write(self.topics[topic], message, stamp)
        run_offline(whole, self.root / "offline", "--robot", self.robot, product=PRODUCT)

    def test_maps_with_the_shipped_robot_file(self):
        robot = RobotStatePublisher(description(self.robot, self.links, self.laser))
        self.addCleanup(robot.close)
        run = self.root / "live"
        launch, _ = start_launch(f"product:={PRODUCT}", f"robot:={self.robot}", f"bag:={self.bag}",
                                 "rate:=0", f"output_dir:={run}", port=robot.port)
        self.addCleanup(launch.kill)
        output = launch.communicate(timeout=60)[0]
        self.assert_same_runs(run, self.root / "offline", output)
        self.assertLess(largest_error(self.root / "offline"), 0.05)


class TurtleBot3Test(Bringup, unittest.TestCase):
    robot, simulated = "turtlebot3", "turtlebot3"
    links, laser = ("base_footprint", "base_link", "base_scan"), "-0.032 0 0.182"


class TurtleBot2Test(Bringup, unittest.TestCase):
    robot, simulated = "turtlebot2", "turtlebot3"
    links, laser = ("base_footprint", "base_link", "base_scan"), "-0.032 0 0.182"


class HuskyTest(Bringup, unittest.TestCase):
    robot, simulated = "husky", "omni"  # which slips sideways as well
    topics = {"/odom": "/husky_velocity_controller/odom", "/scan": "/front/scan"}
    links, laser = ("base_link", "top_plate_link", "laser"), "0.12 0 0.3"


if __name__ == "__main__":
    unittest.main()
