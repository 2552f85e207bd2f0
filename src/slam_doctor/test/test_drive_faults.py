# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each fault of laser and odometry that is put into a simulated drive is found; the drive without
faults has none."""
import math
import unittest

from drives import (diagnose, drive, Edit, edited, faults, FOLDER, IMU, ODOMETRY, SCAN,
                    simulate)
import genpy
from slam_eval.bench.adverse import changes
from slam_eval.bench.harness import miscalibration
from slam_eval.bench.harness.bag_edit import rewrite, People


def later(seconds):
    """An edit that stamps scans later."""
    def change(kind, message, time):
        message.header.stamp += genpy.Duration.from_sec(seconds)
    return Edit((SCAN,), change)


class Clean(unittest.TestCase):
    def test_drives_have_no_faults(self):
        for seed in (1, 2, 3):
            self.assertEqual(faults(diagnose(drive(seed))), {}, seed)

    def test_nor_have_other_worlds_and_robots(self):
        for name, robot, *options in (("corridor", "sim_segway", "--duration", "60"),
                                      ("depot", "sim_omni", "--robot", "omni")):
            bag = simulate(name, "--world", name, "--seed", "4", "--only", "odom,scan", *options)
            self.assertEqual(faults(diagnose(bag, robot)), {}, name)

    def test_nor_has_a_drive_among_people(self):
        bag = drive().with_name("people.bag")
        rewrite(drive(), bag, people=People(5, 3.0))
        self.assertEqual(faults(diagnose(bag)), {})


def of_imu(change):
    """An edit of the angular velocities."""
    def edit(kind, message, time):
        velocity = message.angular_velocity
        velocity.x, velocity.y, velocity.z = change(velocity.x, velocity.y, velocity.z)
    return Edit((IMU,), edit)


class Imu(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bag = simulate("imu", "--robot", "skid", "--only", "odom,imu,scan", "--duration",
                           "30")

    def diagnose(self, name, change, left_out=()):
        return diagnose(edited(f"imu_{name}", change, self.bag, left_out), "sim_skid")

    def test_is_right_though_it_hangs_upside_down(self):
        found = diagnose(self.bag, "sim_skid")
        self.assertEqual(faults(found), {"odom.turn_scale": "ERROR"}, "as its wheels are")
        self.assertAlmostEqual(found["imu.turns"].value, 1 / 1.41, delta=0.1)
        self.assertAlmostEqual(found["imu.rest"].value, 0.009, delta=0.002)

    def test_in_degrees(self):
        found = self.diagnose("degrees", of_imu(lambda *rate: [math.degrees(r) for r in rate]))
        self.assertEqual(found["imu.turns"].level.name, "ERROR")
        self.assertIn("imu.units", found["imu.turns"].advice)

    def test_whose_mount_does_not_say_that_it_hangs_upside_down(self):
        found = self.diagnose("opposite", of_imu(lambda *rate: [-r for r in rate]))
        self.assertEqual(found["imu.turns"].level.name, "ERROR")
        self.assertIn("upside down", found["imu.turns"].advice)

    def test_that_measures_about_another_axis(self):
        found = self.diagnose("axis", of_imu(lambda x, y, z: [x, z, y]))
        self.assertEqual(found["imu.turns"].level.name, "ERROR")

    def test_without_a_mount(self):
        found = self.diagnose("no_mount", of_imu(lambda *rate: rate), ("/tf_static",))
        self.assertEqual(found["imu.mount"].level.name, "ERROR")

    def test_of_no_numbers(self):
        found = self.diagnose("nan", of_imu(lambda *rate: [math.nan, 0.0, 0.0]))
        self.assertEqual(found["imu.numbers"].level.name, "ERROR")


class Laser(unittest.TestCase):
    def test_mirrored(self):
        found = diagnose(edited("mirrored", changes.MirroredLaser(0.0)))
        self.assertEqual(found["scan.direction"].level.name, "ERROR")
        self.assertIn("mirrored", found["scan.direction"].text)

    def test_upside_down_with_a_mount_that_says_so_is_no_fault(self):
        def change(kind, message, time):
            if kind == SCAN:
                message.ranges = message.ranges[::-1]
            else:
                for each in message.transforms:
                    if each.child_frame_id == "laser":
                        q = each.transform.rotation
                        q.x, q.y, q.z, q.w = 1.0, 0.0, 0.0, 0.0
        found = diagnose(edited("upside_down", Edit((SCAN, "tf2_msgs/TFMessage"), change)))
        self.assertEqual(faults(found), {})
        self.assertIn("upside down", found["scan.mount"].text)

    def test_a_second_one_is_checked_as_the_first(self):
        bag = simulate("two_lasers", "--robot", "twin")
        found = diagnose(bag, "sim_twin")
        self.assertEqual(faults(found), {})
        for check in ("mount", "angles", "beams", "frozen", "rate", "direction", "heading"):
            self.assertIn(f"rear_scan.{check}", found)
        self.assertIn("yaw 3.00", found["rear_scan.mount"].text)

        def mirror(kind, message, time):
            if kind == SCAN and message.header.frame_id == "rear_laser":
                message.ranges = message.ranges[::-1]
        found = diagnose(edited("rear_mirrored", Edit((SCAN,), mirror), bag), "sim_twin")
        self.assertEqual(found["rear_scan.direction"].level.name, "ERROR")
        self.assertEqual(found["scan.direction"].level.name, "OK")

        def rename(kind, message, time):
            for each in message.transforms:
                each.child_frame_id = each.child_frame_id.replace("rear_laser", "elsewhere")
        found = diagnose(edited("rear_mount", Edit(("tf2_msgs/TFMessage",), rename), bag), "sim_twin")
        self.assertEqual(found["rear_scan.mount"].level.name, "ERROR")
        self.assertIn("rear_scan.sensor_pose", found["rear_scan.mount"].advice)
        product = FOLDER / "two_lasers.yaml"
        product.write_text("version: 1\nbackend: grid\nmap: grid\nodometry: wheel\ndetector: none\n"
                           "rear_laser: true\n", encoding="utf-8")
        found = diagnose(edited("one_laser", Edit((), None), bag, ("/rear_scan",)), "sim_twin",
                         product)
        self.assertEqual(found["rear_scan.topic"].level.name, "ERROR")

    def test_frozen(self):
        found = faults(diagnose(edited("frozen", changes.FrozenLaser(20.0))))
        self.assertEqual(found["scan.frozen"], "ERROR")

    def test_constant(self):
        found = faults(diagnose(edited("constant", changes.ConstantLaser(2.0, 20.0))))
        self.assertEqual(found["scan.constant"], "ERROR")

    def test_without_returns(self):
        found = faults(diagnose(edited("blind", changes.ConstantLaser(math.inf, 0.0))))
        self.assertEqual(found["scan.beams"], "ERROR")

    def test_turned_mount(self):
        found = diagnose(edited("turned", miscalibration.TurnedBearings(0.25)))
        self.assertEqual(faults(found), {"scan.heading": "ERROR"})
        self.assertAlmostEqual(found["scan.heading"].value, 0.25, delta=0.03)

    def test_angles_that_contradict_the_number_of_beams(self):
        def change(kind, message, time):
            message.angle_increment *= 0.5
        found = faults(diagnose(edited("angles", Edit((SCAN,), change))))
        self.assertEqual(found["scan.angles"], "ERROR")

    def test_tilted_mount(self):
        def change(kind, message, time):
            for each in message.transforms:
                if each.child_frame_id == "laser":
                    q = each.transform.rotation
                    q.y, q.w = math.sin(0.15), math.cos(0.15)
        found = faults(diagnose(edited("tilted", Edit(("tf2_msgs/TFMessage",), change))))
        self.assertEqual(found, {"scan.mount": "ERROR"})


class Odometry(unittest.TestCase):
    def test_scale_of_ways(self):
        def change(kind, message, time):
            message.pose.pose.position.x *= 1.3
            message.pose.pose.position.y *= 1.3
        found = diagnose(edited("ways", Edit((ODOMETRY,), change)))
        self.assertEqual(faults(found), {"odom.scale": "ERROR"})
        self.assertAlmostEqual(found["odom.scale"].value, 1.3, delta=0.05)
        self.assertIn("translation_scale: 0.7", found["odom.scale"].advice)

    def test_scale_of_ways_and_turns(self):
        clean = diagnose(drive())
        for factor in (0.7, 1.3):
            scaled = diagnose(edited(f"scaled_{factor}", miscalibration.ScaledOdometry(factor)))
            for check in ("odom.turn_scale", "odom.scale"):
                ratio = scaled[check].value / clean[check].value
                self.assertAlmostEqual(ratio, factor, delta=0.05, msg=check)

    def test_a_scale_that_the_robot_file_knows_is_no_fault(self):
        def change(kind, message, time):
            message.pose.pose.position.x *= 1.3
            message.pose.pose.position.y *= 1.3
        robot = drive().with_name("scaled.yaml")
        robot.write_text("version: 1\nrobot: scaled\nwheel_odometry: {translation_scale: 0.77}\n")
        self.assertEqual(faults(diagnose(edited("known", Edit((ODOMETRY,), change)), robot)), {})

    def test_backwards(self):
        def change(kind, message, time):
            q = message.pose.pose.orientation  # drives with its back ahead
            q.z, q.w = q.w, -q.z
        found = diagnose(edited("backwards", Edit((ODOMETRY,), change)))
        self.assertEqual(found["odom.scale"].level.name, "ERROR")
        self.assertIn("backwards", found["odom.scale"].text)

    def test_stuck(self):
        found = diagnose(edited("stuck", miscalibration.ScaledOdometry(0.0, begin=20.0, end=35.0)))
        self.assertEqual(found["odom.stuck"].level.name, "ERROR")
        self.assertGreater(found["odom.stuck"].value, 8.0)

    def test_jump(self):
        found = faults(diagnose(edited("jump", changes.OdometryJump(5.0, 20.0))))
        self.assertEqual(found["odom.jump"], "ERROR")

    def test_reset(self):
        origin = []
        def change(kind, message, time):
            pose = message.pose.pose
            if time > 30.0:
                origin.append((pose.position.x, pose.position.y))
                pose.position.x -= origin[0][0]
                pose.position.y -= origin[0][1]
                if len(origin) == 1:
                    pose.orientation.z, pose.orientation.w = 0.0, 1.0
        found = faults(diagnose(edited("reset", Edit((ODOMETRY,), change))))
        self.assertEqual(found["odom.reset"], "ERROR")

    def test_numbers_and_covariances(self):
        def change(kind, message, time):
            if 20.0 < time < 21.0:
                message.pose.pose.position.x = math.nan
            message.twist.covariance = [-0.1] + 35 * [0.0]
        found = faults(diagnose(edited("numbers", Edit((ODOMETRY,), change))))
        self.assertEqual(found["odom.numbers"], "ERROR")
        self.assertEqual(found["odom.covariance"], "ERROR")

    def test_covariances_that_are_not_given(self):
        def change(kind, message, time):
            message.pose.covariance = [-1.0] + 35 * [0.0]
        self.assertEqual(faults(diagnose(edited("not_given", Edit((ODOMETRY,), change)))), {})

    def test_huge_covariance(self):
        def change(kind, message, time):
            message.pose.covariance = [1e9 if i % 7 == 0 else 0.0 for i in range(36)]
        found = faults(diagnose(edited("huge", Edit((ODOMETRY,), change))))
        self.assertEqual(found, {"odom.covariance": "WARN"})


class Time(unittest.TestCase):
    def test_offset_of_scans(self):
        for seconds in (0.15, -0.15):
            found = diagnose(edited(f"later_{seconds}", later(seconds)))
            self.assertEqual(found["scan.offset"].level.name, "WARN")
            self.assertAlmostEqual(found["scan.offset"].value, 1000 * seconds, delta=30)

    def test_without_an_offset_little_is_told(self):
        for seed in (1, 2, 3):
            self.assertLess(abs(diagnose(drive(seed))["scan.offset"].value), 30)


if __name__ == "__main__":
    unittest.main()
