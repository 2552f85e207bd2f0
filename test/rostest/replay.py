#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the nodelets publish and serve while a recorded log is replayed, in either composition."""

import math
import os
import re
import sys
import tempfile
import unittest

from dynamic_reconfigure.client import Client
from geometry_msgs.msg import PoseWithCovarianceStamped
import numpy
import rospy
import rosservice
import rostest
from slam_msgs.srv import LoadMap, RemoveLandmark, SaveMap
from std_srvs.srv import SetBool, Trigger
from player import Player, wait_for

LANDMARKS = 70
REMOVERS = ("ekf", "pf", "graph", "seif")  # other back-ends need not remove landmarks
NUMBER = re.compile(r"-?\d[\d.]*(?:e[-+]?\d+)?")


def yaw(q):
    return 2 * math.atan2(q.z, q.w)


def matrix(pose):
    """The homogeneous matrix of a planar pose or transform."""
    at = getattr(pose, "position", None) or pose.translation
    angle = yaw(getattr(pose, "orientation", None) or pose.rotation)
    return numpy.array([[math.cos(angle), -math.sin(angle), at.x],
                        [math.sin(angle), math.cos(angle), at.y], [0, 0, 1]])


def numbers(text):
    return [float(number) for number in NUMBER.findall(text)]


class ReplayTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.player = Player()
        cls.arrays = [m for topic, m in cls.player.log if topic == "/observations"]
        cls.player.play()
        cls.player.advance(0.5)  # past the transform's tolerance
        wait_for(lambda: len(cls.player.get("pose")) >= len(cls.arrays) and
                 len(cls.player.get("path")) > 0 and
                 len(cls.player.get("path")[-1].poses) >= len(cls.arrays) and
                 cls.player.get("landmarks")[-1].header.stamp == cls.arrays[-1].header.stamp and
                 cls.player.counters("slam").get("message") == "running")
        cls.full = {topic: cls.player.get(topic) for topic in cls.player.received}

    def test_a_pose_carries_the_stamp_of_each_observation_array(self):
        self.assertTrue(self.player.connected)
        self.assertEqual([p.header.stamp for p in self.full["pose"]],
                         [a.header.stamp for a in self.arrays])
        self.assertEqual({p.header.frame_id for p in self.full["pose"]}, {"map"})

    def test_covariances_are_symmetric_and_positive_definite(self):
        for pose in self.full["pose"]:
            covariance = numpy.array(pose.pose.covariance).reshape(6, 6)
            planar = covariance[numpy.ix_([0, 1, 5], [0, 1, 5])]
            numpy.testing.assert_allclose(planar, planar.T)
            self.assertGreater(numpy.linalg.eigvalsh(planar).min(), 0)
        for landmark in self.full["landmarks"][-1].landmarks:
            covariance = numpy.array(landmark.covariance).reshape(2, 2)
            self.assertGreater(numpy.linalg.eigvalsh(covariance).min(), 0)

    def test_the_last_path_is_complete(self):
        path = self.full["path"][-1]
        self.assertEqual(path.header.frame_id, "map")
        self.assertEqual([p.header.stamp for p in path.poses],
                         [p.header.stamp for p in self.full["pose"]])

    def test_all_landmarks_are_published_sorted_with_the_last_stamp(self):
        last = self.full["landmarks"][-1]
        ids = [landmark.id for landmark in last.landmarks]
        self.assertEqual(len(ids), LANDMARKS)
        self.assertEqual(ids, sorted(ids))
        self.assertEqual(last.header.frame_id, "map")
        self.assertEqual(last.header.stamp, self.arrays[-1].header.stamp)

    def test_each_landmark_has_ellipse_point_and_id(self):
        markers = self.full["landmark_markers"][-1].markers
        kinds = [marker.ns for marker in markers]
        self.assertEqual({kind: kinds.count(kind) for kind in set(kinds)},
                         {"ellipse": LANDMARKS, "landmark": LANDMARKS, "id": LANDMARKS})

    def edges(self):
        return [t for m in self.full["/tf"] for t in m.transforms]

    def test_only_the_map_transform_is_published_with_growing_stamps(self):
        edges = self.edges()
        self.assertEqual({(e.header.frame_id, e.child_frame_id) for e in edges}, {("map", "odom")})
        stamps = [e.header.stamp for e in edges]
        self.assertTrue(all(a < b for a, b in zip(stamps, stamps[1:])))

    def test_the_map_transform_leads_from_odometry_to_pose(self):
        odometry = [m for topic, m in self.player.log if topic == "/odom"][-1]
        pose = self.full["pose"][-1]
        self.assertEqual(odometry.header.stamp, pose.header.stamp)
        chained = matrix(self.edges()[-1].transform) @ matrix(odometry.pose.pose)
        numpy.testing.assert_allclose(chained, matrix(pose.pose.pose), atol=1e-6)

    def live_parameters(self):
        """A client of dynamic_reconfigure for the nodelet whose outputs can be changed."""
        (service,) = rosservice.rosservice_find("dynamic_reconfigure/Reconfigure")
        client = Client(service.rpartition("/")[0], timeout=10)
        self.addCleanup(client.close)
        return client

    def test_what_may_change_while_it_runs_is_described(self):
        described = {each["name"]: each
                     for each in self.live_parameters().get_parameter_descriptions()}
        self.assertEqual(set(described),
                         {"landmark_rate", "map_period", "tf_rate", "transform_tolerance"})
        rate = described["tf_rate"]
        self.assertEqual((rate["type"], rate["min"], rate["max"], rate["default"]),
                         ("double", 0.1, 1000, 20))
        self.assertEqual(rate["description"], "of the map's transform [Hz]")

    def test_what_is_changed_is_in_force_and_what_is_not_allowed_is_not(self):
        client = self.live_parameters()
        self.addCleanup(client.update_configuration, {"transform_tolerance": 0.1})
        in_force = client.update_configuration({"transform_tolerance": 3.0, "map_period": 0.0})
        self.assertEqual((in_force["transform_tolerance"], in_force["map_period"]), (3, 2))
        self.assertTrue(wait_for(lambda: any("map_period is not changed: " in warning
                                             for warning in self.player.warnings())))
        self.player.begin()
        ahead = self.player.get("pose")[-1].header.stamp + rospy.Duration(3)
        self.assertTrue(wait_for(lambda: self.player.get("/tf")[-1].transforms[-1].header.stamp
                                 >= ahead))

    def last_status(self, task):
        return [status for array in self.full["/diagnostics"] for status in array.status
                if status.name.startswith("slam") and status.name.endswith(": " + task)][-1]

    def test_diagnostics_say_running(self):
        last = self.last_status("state")
        self.assertEqual((last.level, last.message), (0, "running"))

    def test_a_filter_with_particles_shows_them_about_its_pose(self):
        if rospy.get_param("~backend") != "pf":
            self.assertEqual(self.full["particlecloud"], [])
            return
        poses = {p.header.stamp: p.pose.pose.position for p in self.full["pose"]}
        self.assertTrue(self.full["particlecloud"])
        for cloud in self.full["particlecloud"]:
            self.assertEqual(cloud.header.frame_id, "map")
            self.assertGreater(len(cloud.poses), 1)
            mean = numpy.mean([(p.position.x, p.position.y) for p in cloud.poses], axis=0)
            pose = poses[cloud.header.stamp]
            self.assertLess(math.dist(mean, (pose.x, pose.y)), 0.2)

    def test_diagnostics_say_that_the_noise_is_as_believed(self):
        last = self.last_status("consistency")
        self.assertEqual((last.level, last.message), (0, "errors match the reported covariance"))

    def test_each_step_tells_how_far_its_innovations_are_off(self):
        told = self.full["consistency"]
        self.assertEqual([m.header.stamp for m in told], [a.header.stamp for a in self.arrays])
        last = told[-1]
        self.assertEqual(last.sources, ["range", "bearing", "odometry"])
        self.assertTrue(all(0.5 < factor < 1.5 for factor in last.factors), last.factors)
        self.assertEqual((last.nees, last.finding), (-1, ""))
        self.assertLess(last.nis_bounds[0], last.nis_mean)
        self.assertLess(last.nis_mean, last.nis_bounds[1])

    def call(self, name, kind, *arguments):
        return rospy.ServiceProxy(name, kind)(*arguments)

    def test_reset_empties_the_map(self):
        self.player.begin()
        self.assertGreater(len(self.saved_ids()), 0)
        self.assertTrue(self.call("reset", Trigger).success)
        self.assertEqual(self.saved_ids(), [])

    def test_a_landmark_that_is_not_there_is_removed(self):
        self.player.begin()
        known = self.saved_ids()
        answer = self.call("remove_landmark", RemoveLandmark, known[0])
        if rospy.get_param("~backend") not in REMOVERS:
            self.assertFalse(answer.success)
            self.assertIn("this back-end removes no landmarks", answer.message)
            return
        self.assertTrue(answer.success, answer.message)
        self.assertIn(f"landmark {known[0]} is removed", answer.message)
        self.assertEqual(self.saved_ids(), known[1:])
        again = self.call("remove_landmark", RemoveLandmark, known[0])
        self.assertFalse(again.success)
        self.assertIn(f"there is no landmark {known[0]} in the map", again.message)
        self.assertEqual(self.saved_ids(), known[1:])

    def test_paused_observations_are_ignored(self):
        self.player.begin(5)
        before = self.saved_ids()
        self.assertTrue(self.call("pause", SetBool, True).success)
        self.player.play(self.player.part(6, 40))
        self.assertTrue(wait_for(lambda: len(self.player.get("pose")) >= 35))
        self.assertEqual(self.saved_ids(), before)
        self.assertTrue(self.call("pause", SetBool, False).success)

    def saved_ids(self):
        return [int(found) for found in re.findall(r"- \{id: (\d+),", self.saved())]

    def saved(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "landmarks.yaml")
            answer = self.call("save_map", SaveMap, path)
            self.assertTrue(answer.success, answer.message)
            with open(path, encoding="utf-8") as file:
                return file.read()

    def test_a_saved_map_loads_as_it_was(self):
        self.player.begin()
        saved = self.saved()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "landmarks.yaml")
            with open(path, "w", encoding="utf-8") as file:
                file.write(saved)
            self.call("reset", Trigger)
            answer = self.call("load_map", LoadMap, path)
        self.assertTrue(answer.success, answer.message)
        expected, loaded = self.lasting(saved), self.lasting(self.saved())
        if rospy.get_param("~backend") not in ("graph", "seif"):
            self.assertEqual(loaded, expected)
            return
        self.assertEqual(NUMBER.sub("", loaded), NUMBER.sub("", expected))  # inverted when loaded
        numpy.testing.assert_allclose(numbers(loaded), numbers(expected), rtol=1e-6, atol=1e-12)

    def lasting(self, saved):
        """What a map keeps when it is loaded: without joint covariance, marginals are inflated."""
        kept = re.sub("stamp: .*\n", "", saved)
        has_joint = "joint_covariance: true" in saved
        return kept if has_joint else re.sub(r"covariance: \[.*?\]", "", kept)

    def refusal_of(self, text):
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            file.write(text)
            file.flush()
            answer = self.call("load_map", LoadMap, file.name)
        self.assertFalse(answer.success)
        return answer.message

    def test_maps_of_another_version_or_frame_are_refused(self):
        saved = self.saved()
        self.assertIn("version 9", self.refusal_of(saved.replace("version: 1", "version: 9")))
        self.assertIn("'attic'", self.refusal_of(saved.replace("frame: map", "frame: attic")))
        self.assertFalse(self.call("load_map", LoadMap, "/no/such/file").success)
        self.assertFalse(self.call("load_map", LoadMap, "").success)

    def test_saving_where_it_cannot_is_told(self):
        answer = self.call("save_map", SaveMap, "/proc/landmarks.yaml")
        self.assertFalse(answer.success)
        self.assertIn("/proc/landmarks.yaml", answer.message)
        full = self.call("save_map", SaveMap, "/dev/full/landmarks.yaml")
        self.assertFalse(full.success)

    def test_initialpose_moves_the_robot_and_keeps_the_map(self):
        self.player.begin()
        ids = self.saved_ids()
        pose = PoseWithCovarianceStamped()
        pose.header.frame_id = "map"
        pose.pose.pose.position.x = 3.5
        pose.pose.pose.orientation.w = 1.0
        for index in (0, 7, 35):
            pose.pose.covariance[index] = 0.01
        self.player.publishers["initialpose"].publish(pose)
        self.assertTrue(wait_for(lambda: "pose: {x: 3.5," in self.saved()))
        self.assertEqual(self.saved_ids(), ids)


if __name__ == "__main__":
    rospy.init_node("replay_test")
    rostest.rosrun("slam_tests", "replay", ReplayTest, sys.argv)
