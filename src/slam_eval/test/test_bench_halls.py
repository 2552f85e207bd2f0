# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random halls, and what a sensor of landmarks sees on a drive through them."""
import math
import pathlib
import tempfile
import unittest

from geometry_msgs.msg import PoseStamped
import genpy
import numpy as np
import rosbag
from sensor_msgs.msg import LaserScan
from slam_eval.bench.harness import halls
from slam_eval.bench.harness import landmark_sensor as sensor
from slam_msgs.msg import Landmark, LandmarkMap


class Simulation(unittest.TestCase):

    def test_a_seed_makes_one_hall(self):
        self.assertEqual(halls.hall(7), halls.hall(7))
        self.assertNotEqual(halls.hall(7)["markers"], halls.hall(8)["markers"])

    def test_furniture_leaves_the_way_free_and_all_landmarks_are_inside(self):
        for seed in range(1, 21):
            world = halls.hall(seed)
            _, _, (width, depth), _ = world["walls"][0]["points"]
            self.assertEqual(len(world["markers"]), 20)
            for marker in world["markers"]:
                self.assertTrue(0 < marker["position"][0] < width)
                self.assertTrue(0 < marker["position"][1] < depth)
            for x, y in world["path"]["points"]:
                self.assertGreater(min(x, y, width - x, depth - y), 0.5)
                for box in world["furniture"]:
                    off = [max(0.0, abs(p - c) - s / 2)
                           for p, c, s in zip((x, y), box["centre"], box["size"])]
                    self.assertGreater(math.hypot(*off), 0.5)

    def test_a_sensor_sees_what_is_near_and_in_view_with_the_noise_that_it_reports(self):
        points = np.array([[3.0, 0.5], [-3.0, 0.0], [20.0, 0.0]])
        look = sensor.Sensor([1, 2, 3], points, 4)
        messages = [look.look(genpy.Time(5), (0.0, 0.0, 0.0)) for _ in range(2000)]
        self.assertEqual({z.id for m in messages for z in m.observations}, {1})
        self.assertEqual([m.sequence for m in messages[:3]], [0, 1, 2])
        (true_range,), (true_bearing,) = sensor.seen_from((0.0, 0.0, 0.0), points[:1])
        seen = [m.observations[0] for m in messages]
        for values, true, variance in (([z.range for z in seen], true_range, seen[0].covariance[0]),
                                       ([z.bearing for z in seen], true_bearing,
                                        seen[0].covariance[3])):
            self.assertAlmostEqual(np.mean(values), true, delta=4 * math.sqrt(variance / 2000))
            self.assertAlmostEqual(np.var(values) / variance, 1.0, delta=0.15)

    def test_what_is_seen_lies_where_it_stands(self):
        pose = (1.0, -2.0, 2.5)
        (distance,), (bearing,) = sensor.seen_from(pose, np.array([[2.0, 3.0]]))
        np.testing.assert_allclose(sensor.place_of(pose, distance, bearing), (2.0, 3.0))

    def test_observations_take_the_place_of_scans(self):
        with tempfile.TemporaryDirectory() as name:
            source, target = pathlib.Path(name) / "a.bag", pathlib.Path(name) / "b.bag"
            with rosbag.Bag(str(source), "w") as bag:
                landmarks = LandmarkMap(landmarks=[Landmark(id=3, x=2.0, y=0.3)])
                bag.write("/ground_truth/landmarks", landmarks, genpy.Time(1))
                for i in range(50):
                    truth = PoseStamped()
                    truth.header.stamp = genpy.Time.from_sec(1.0 + 0.02 * i)
                    truth.pose.orientation.w = 1.0
                    bag.write("/ground_truth/pose", truth, truth.header.stamp)
                    bag.write("/scan", LaserScan(), truth.header.stamp)
            sensor.observe(source, target, 1)
            with rosbag.Bag(str(target)) as bag:
                topics = bag.get_type_and_topic_info().topics
                self.assertNotIn("/scan", topics)
                self.assertEqual(topics["/observations"].message_count, 10)
                for _, message, time in bag.read_messages(topics=["/observations"]):
                    self.assertEqual(message.header.stamp, time)
                    self.assertEqual([z.id for z in message.observations], [3])


if __name__ == "__main__":
    unittest.main()
