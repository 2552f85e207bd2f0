# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The robot that rviz shows: the robot's own description, or a model that fits its robot file."""

import os
import socket
import subprocess
import time
import unittest
from unittest import mock
import xml.etree.ElementTree as ElementTree

import rosgraph
import rospkg
from slam_launch import config_files, packages, robot_models
import yaml

UNUSED = "http://127.0.0.1:9"  # a port where no master is
OWN = '<robot name="mine"><link name="base_link"/></robot>'


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Master:
    """A master of its own for a test."""

    def __init__(self, test):
        self.uri = f"http://127.0.0.1:{free_port()}"
        process = subprocess.Popen(["rosmaster", "--core", "-p", self.uri.rsplit(":", 1)[1]],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        test.addCleanup(process.wait)
        test.addCleanup(process.terminate)
        end = time.monotonic() + 30
        while not rosgraph.is_master_online(self.uri):
            assert time.monotonic() < end, "rosmaster did not start"
            time.sleep(0.1)

    def describe(self, name, description):
        rosgraph.Master("/bringup", self.uri).setParam(name, description)


def link_of(description):
    links = ElementTree.fromstring(description).findall("link")
    assert len(links) == 1  # so that nobody has to publish transforms for the others
    return links[0]


def shown_with(uri, namespace="/", **robot):
    with mock.patch.dict(os.environ, ROS_MASTER_URI=uri, ROS_NAMESPACE=namespace):
        return robot_models.description_for(robot)


class Models(unittest.TestCase):
    def test_of_shipped_robots_stand_on_the_frame_that_their_odometry_moves(self):
        models = sorted((packages.share() / "models").glob("*.urdf"))
        robots = config_files.files("robots")
        self.assertEqual({path.stem for path in models} - robots.keys(), {robot_models.UNKNOWN})
        for path in models:
            link = link_of(path.read_text(encoding="utf-8"))
            self.assertIn("front", [visual.get("name") for visual in link], path)
            if path.stem in robots:
                base = config_files.load(robots[path.stem])["frames"]["base"]
                self.assertEqual(link.get("name"), base, path)

    def test_have_the_sensors_where_the_simulator_has_them(self):
        folder = rospkg.RosPack().get_path("slam_sim")
        for name in ("segway", "omni", "skid", "scout", "twin", "car", "turtlebot3"):
            with open(f"{folder}/robots/{name}.yaml", encoding="utf-8") as file:
                robot = yaml.safe_load(file)
            mounts = {"laser": robot["laser"]["position"]}
            if "rear_laser" in robot:
                mounts["rear_laser"] = robot["rear_laser"]["position"]
            for camera in robot.get("cameras", []):
                mounts[camera["name"]] = camera["pose"][:3]
            if "imu" in robot:
                mounts["imu"] = robot["imu"]["pose"][:3]
            link = ElementTree.parse(robot_models.path_of(robot["robot"])).find("link")
            shown = {visual.get("name"): [float(word) for word in
                                          visual.find("origin").get("xyz").split()]
                     for visual in link if visual.find("material").get("name") == "sensor"}
            self.assertEqual(shown, mounts, name)

    def test_of_a_robot_without_one_is_a_disc_on_its_base(self):
        for robot in ("of_mine", "../robots/husky.yaml", None):
            link = link_of(shown_with(UNUSED, robot=robot, frames={"base": "trolley"}))
            self.assertEqual(link.get("name"), "trolley")
        self.assertEqual(link_of(shown_with(UNUSED)).get("name"), "base_link")


class OwnDescription(unittest.TestCase):
    def test_of_the_robot_is_shown_and_not_replaced(self):
        master = Master(self)
        self.assertNotEqual(shown_with(master.uri, robot="husky"), OWN)
        master.describe("/robot_description", OWN)
        self.assertEqual(shown_with(master.uri, robot="husky"), OWN)
        self.assertEqual(shown_with(master.uri, "/left", robot="husky"), OWN)

    def test_is_not_what_an_earlier_launch_has_shown(self):
        master = Master(self)
        master.describe("/robot_description", shown_with(master.uri, robot="sim_omni"))
        self.assertIn("slam_launch/husky", shown_with(master.uri, robot="husky"))

    def test_that_is_no_urdf_is_left_to_rviz(self):
        master = Master(self)
        master.describe("/robot_description", "<robot")
        self.assertEqual(shown_with(master.uri, robot="husky"), "<robot")


if __name__ == "__main__":
    unittest.main()
