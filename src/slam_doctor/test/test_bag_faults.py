# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Faults of stamps, rates, topics, frames and mounts in simulated drives."""
import unittest

from drives import diagnose, drive, Edit, edited, faults, FOLDER, ODOMETRY, SCAN
import genpy
from geometry_msgs.msg import TransformStamped
import rosbag
from slam_eval.bench.harness import landmark_sensor
from slam_eval.bench.harness.bag_edit import OBSERVATIONS
from tf2_msgs.msg import TFMessage

TRANSFORMS = "tf2_msgs/TFMessage"


def copied(name, keep, added=()):
    """A bag with the messages for which keep(topic, time since the start) holds, and others."""
    path = FOLDER / f"{name}.bag"
    with rosbag.Bag(str(drive())) as bag, rosbag.Bag(str(path), "w") as out:
        start = bag.get_start_time()
        for topic, raw, time in bag.read_messages(raw=True):
            if keep(topic, time.to_sec() - start):
                out.write(topic, raw, time, raw=True)
        for topic, message, seconds in added:
            out.write(topic, message, genpy.Time.from_sec(start + seconds))
    return path


def restamped(name, kinds, function):
    """A bag in which function(stamp, time) gives the stamps of some types."""
    def change(kind, message, time):
        message.header.stamp = function(message.header.stamp, time)
    return edited(name, Edit(kinds, change))


def transform(parent, child):
    """A message with one transform."""
    out = TransformStamped()
    out.header.frame_id, out.child_frame_id = parent, child
    out.transform.rotation.w = 1.0
    return TFMessage([out])


class Rates(unittest.TestCase):
    def test_a_gap_in_which_the_robot_drives(self):
        found = diagnose(copied("gap", lambda topic, t: topic != "/scan" or not 20 < t < 25))
        self.assertIn(found["scan.gap"].level.name, ("WARN", "ERROR"))
        self.assertAlmostEqual(found["scan.gap"].value, 5.0, delta=0.2)
        self.assertIn("in which the robot moved by", found["scan.gap"].text)

    def test_a_gap_while_the_robot_stands_is_no_fault(self):
        # The robot stands in the first second.
        found = diagnose(copied("pause", lambda topic, t: topic != "/scan" or not 0.05 < t < 0.95))
        self.assertEqual(faults(found), {})

    def test_messages_that_are_lost(self):
        found = diagnose(copied("lost", lambda topic, t: topic != "/scan" or round(10 * t) % 5))
        self.assertEqual(faults(found), {"scan.rate": "WARN"})
        self.assertAlmostEqual(found["scan.rate"].value, 0.2, delta=0.02)


class Stamps(unittest.TestCase):
    def test_zero(self):
        bag = restamped("zero", (SCAN,), lambda stamp, time: genpy.Time())
        self.assertEqual(faults(diagnose(bag))["scan.stamps"], "ERROR")

    def test_going_back(self):
        bag = restamped("back", (ODOMETRY,), lambda stamp, time:
                        stamp - genpy.Duration.from_sec(5.0) if time > 30 else stamp)
        found = diagnose(bag)
        self.assertEqual(found["odom.stamps"].level.name, "ERROR")
        self.assertIn("go back", found["odom.stamps"].text)

    def test_used_twice(self):
        last = []

        def change(stamp, time):
            last.append(stamp)
            return last[-2] if len(last) % 2 == 0 else stamp
        found = faults(diagnose(restamped("twice", (ODOMETRY,), change)))
        self.assertEqual(found["odom.stamps"], "WARN")

    def test_a_clock_of_another_machine(self):
        ahead = diagnose(restamped("ahead", (SCAN,), lambda stamp, time:
                                   stamp + genpy.Duration.from_sec(60.0)))
        self.assertEqual(ahead["scan.clock"].level.name, "ERROR")
        self.assertAlmostEqual(ahead["scan.clock"].value, 60.0, delta=0.1)
        self.assertEqual(ahead["stamps.apart"].level.name, "ERROR")

    def test_a_clock_that_drifts(self):
        bag = restamped("drift", (SCAN,), lambda stamp, time:
                        stamp - genpy.Duration.from_sec(0.004 * time))
        found = diagnose(bag)
        self.assertEqual(found["scan.drift"].level.name, "WARN")
        self.assertAlmostEqual(found["scan.drift"].value, 0.004 * 54 * 0.75, delta=0.03)

    def test_old_stamps_of_all_sensors_alike_are_only_asked_about(self):
        bag = restamped("old", (SCAN, ODOMETRY), lambda stamp, time:
                        stamp - genpy.Duration.from_sec(2.0))
        self.assertEqual(faults(diagnose(bag)), {"scan.clock": "WARN", "odom.clock": "WARN"})


class Frames(unittest.TestCase):
    def test_no_mount(self):
        found = diagnose(copied("no_mount", lambda topic, t: topic != "/tf_static"))
        self.assertEqual(faults(found), {"scan.mount": "ERROR"})
        self.assertIn("laser.sensor_pose", found["scan.mount"].advice)

    def test_a_mount_in_the_robot_file(self):
        robot = FOLDER / "mounted.yaml"
        robot.write_text("version: 1\nrobot: mounted\nlaser: {sensor_pose: [0.12, 0, 0.3, 0, 0, "
                         "0]}\n", encoding="utf-8")
        bag = copied("own_mount", lambda topic, t: topic != "/tf_static")
        self.assertEqual(faults(diagnose(bag, robot)), {})

    def test_a_mount_on_tf_that_stands_still(self):
        bag = copied("mount_on_tf", lambda topic, t: topic != "/tf_static",
                     [("/tf", transform("base_link", "laser"), t) for t in range(1, 50)])
        found = diagnose(bag)
        self.assertEqual(faults(found), {})
        self.assertIn("from /tf, where it stands still", found["scan.mount"].text)

    def test_a_mount_that_moves(self):
        moving = []
        for t in range(1, 50):
            moving.append(("/tf", transform("base_link", "laser"), t))
            moving[-1][1].transforms[0].transform.translation.x = 0.01 * t
        bag = copied("moving", lambda topic, t: topic != "/tf_static", moving)
        self.assertEqual(faults(diagnose(bag))["scan.mount"], "ERROR")

    def test_two_parents(self):
        bag = copied("parents", lambda topic, t: True,
                     [("/tf_static", transform("base_footprint", "laser"), 1.0)])
        self.assertEqual(faults(diagnose(bag))["frames.parents"], "ERROR")

    def test_a_circle_of_frames_ends(self):
        bag = copied("circle", lambda topic, t: topic != "/tf_static",
                     [("/tf_static", transform("a", "laser"), 1.0),
                      ("/tf_static", transform("laser", "a"), 1.0)])
        self.assertEqual(faults(diagnose(bag))["scan.mount"], "ERROR")

    def test_a_mount_in_millimetres(self):
        def change(kind, message, time):
            for each in message.transforms:
                if each.child_frame_id == "laser":
                    each.transform.translation.x *= 1000
        found = diagnose(edited("millimetres", Edit((TRANSFORMS,), change)))
        self.assertEqual(found["scan.mount"].level.name, "WARN")
        self.assertIn("millimetres", found["scan.mount"].advice)

    def test_a_quaternion_that_is_none(self):
        def change(kind, message, time):
            for each in message.transforms:
                if each.child_frame_id == "camera_link":
                    each.transform.rotation.w = 0.0
        found = faults(diagnose(edited("quaternion", Edit((TRANSFORMS,), change))))
        self.assertEqual(found["frames.numbers"], "WARN")

    def test_another_base(self):
        def change(kind, message, time):
            message.child_frame_id = "base_footprint"
        found = diagnose(edited("other_base", Edit((ODOMETRY,), change)))
        self.assertEqual(found["odom.frames"].level.name, "WARN")


class Topics(unittest.TestCase):
    def test_what_a_product_lacks(self):
        found = diagnose(drive(), product="ekf_wheel")
        self.assertEqual(found["camera.topic"].level.name, "ERROR")
        self.assertIn("camera/image_raw", found["camera.topic"].text)

    def test_what_a_product_needs_is_enough(self):
        self.assertEqual(faults(diagnose(drive(), product="pf_wheel_grid")), {})

    def test_products_for_which_the_inputs_suffice(self):
        told = diagnose(drive())["product"].text
        self.assertIn("pf_wheel_grid", told)
        self.assertNotIn("ekf_wheel,", told)

    def test_no_product(self):
        bag = copied("nothing", lambda topic, t: topic not in ("/scan", "/odom", "/tf"))
        self.assertEqual(faults(diagnose(bag))["product"], "ERROR")

    def test_odometry_from_transforms(self):
        found = diagnose(copied("from_tf", lambda topic, t: topic != "/odom"))
        self.assertEqual(faults(found), {})
        self.assertIn("/tf odom -> base_link", found["odom.topic"].text)

    def test_topics_of_other_names_are_found_by_their_type(self):
        path = FOLDER / "renamed.bag"
        with rosbag.Bag(str(drive())) as bag, rosbag.Bag(str(path), "w") as out:
            for topic, raw, time in bag.read_messages(raw=True):
                out.write({"/scan": "/front/laser"}.get(topic, topic), raw, time, raw=True)
        found = diagnose(path)
        self.assertEqual(faults(found), {})
        self.assertIn("/front/laser", found["scan.topic"].text)


class Landmarks(unittest.TestCase):
    def seen(self, name, change=None):
        path = FOLDER / f"{name}.bag"
        if not path.exists():
            landmark_sensor.observe(drive(), path, 1)
        bag = edited(f"{name}_edited", Edit((OBSERVATIONS,), change), path) if change else path
        return diagnose(bag, product="ekf_wheel")

    def test_observations_take_the_place_of_images(self):
        found = self.seen("landmarks")
        self.assertEqual(faults(found), {})
        self.assertEqual(found["product"].level.name, "OK")
        self.assertGreater(found["observations.seen"].value, 1)

    def test_ranges_and_covariances_that_cannot_be(self):
        def change(kind, message, time):
            for each in message.observations:
                each.range = -each.range
                each.covariance = [0.01, 1.0, 1.0, 0.01]
        self.assertEqual(faults(self.seen("landmarks", change)),
                         {"observations.range": "ERROR", "observations.covariance": "ERROR"})

    def test_no_landmark(self):
        def change(kind, message, time):
            message.observations = []
        self.assertEqual(faults(self.seen("landmarks", change)), {"observations.seen": "WARN"})


class RobotFile(unittest.TestCase):
    def robot(self, text):
        path = FOLDER / "robot.yaml"
        path.write_text(f"version: 1\nrobot: mine\n{text}\n", encoding="utf-8")
        return diagnose(drive(), path)

    def test_a_marker_in_millimetres_is_asked_about(self):
        found = self.robot("fiducial: {marker_size: 160}")["marker.size"]
        self.assertEqual(found.level.name, "ERROR")
        self.assertIn("Did you mean 0.160 m?", found.advice)

    def test_a_marker_in_centimetres_is_asked_about(self):
        found = self.robot("fiducial: {marker_size: 16}")["marker.size"]
        self.assertIn("Did you mean 0.160 m?", found.advice)

    def test_a_marker_of_a_usual_size(self):
        for size in (0.02, 0.16, 0.9):
            found = self.robot(f"fiducial: {{marker_size: {size}}}")["marker.size"]
            self.assertEqual(found.level.name, "OK")

    def test_a_key_that_is_none(self):
        found = self.robot("fiducial: {size: 160}")["robot"]
        self.assertEqual(found.level.name, "ERROR")
        self.assertIn("fiducial.size", found.text)


if __name__ == "__main__":
    unittest.main()
