# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""ekf_wheel on the simulated office's first seconds: images in, the same map in every way."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from launching import play_into_launch, program, run_launch, run_offline, SameAsOffline
import yaml

SECONDS = 10
CAMERA = ("/camera/image_raw/compressed", "/camera/camera_info", "/tf_static")
DATA = pathlib.Path(os.environ.get("SLAM_DATA_DIR",
                                   pathlib.Path(__file__).resolve().parents[3] / "shared/data"))


class CameraLaunchTest(SameAsOffline, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp())
        cls.bag = cls.root / "office.bag"
        subprocess.run([program("slam_sim", "slam_sim"), cls.bag, "--duration", str(SECONDS),
                        "--only", "odom,camera"], check=True, stdout=subprocess.DEVNULL)
        for detector in ("apriltag", "aruco"):
            run_offline(cls.bag, cls.root / detector, "--set", f"detector={detector}")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def landmarks(self, run):
        content = yaml.safe_load((self.root / run / "landmarks.yaml").read_text(encoding="ascii"))
        return {entry["id"]: (entry["x"], entry["y"]) for entry in content["landmarks"]}

    def test_both_detectors_see_the_same_markers(self):
        apriltag, aruco = self.landmarks("apriltag"), self.landmarks("aruco")
        self.assertGreater(len(apriltag), 1)
        self.assertEqual(apriltag.keys(), aruco.keys())
        for key, (x, y) in apriltag.items():
            self.assertAlmostEqual(x, aruco[key][0], delta=0.1)
            self.assertAlmostEqual(y, aruco[key][1], delta=0.1)

    def replay_without_loss(self, composition, detector):
        run = self.root / f"{composition}_{detector}"
        output, _ = run_launch(f"bag:={self.bag}", "rate:=0", f"composition:={composition}",
                               f"detector:={detector}", f"output_dir:={run}")
        self.assert_same_runs(run, self.root / detector, output)
        self.assertNotIn("WARN", output)

    def test_pubsub_without_loss_equals_offline(self):
        self.replay_without_loss("pubsub", "apriltag")

    def test_inprocess_without_loss_equals_offline(self):
        self.replay_without_loss("inprocess", "apriltag")

    def test_pubsub_with_aruco_equals_offline(self):
        self.replay_without_loss("pubsub", "aruco")

    def play_twice_as_fast(self, composition):
        run = self.root / f"{composition}_played"
        output = play_into_launch(self.bag, ("/odom", *CAMERA), 2, self.root / "apriltag",
                                  "robot:=sim_segway", f"composition:={composition}",
                                  f"output_dir:={run}")
        self.assert_same_runs(run, self.root / "apriltag", output)
        self.assertNotIn("has died", output)

    def test_pubsub_at_rate_2_equals_offline(self):
        self.play_twice_as_fast("pubsub")

    def test_inprocess_at_rate_2_equals_offline(self):
        self.play_twice_as_fast("inprocess")

    def test_a_real_photograph_of_a_robot_is_read(self):
        bag = DATA / "tags/ubiquity_aruco_images.bag"
        if not bag.is_file():
            self.skipTest(f"there is no {bag}")
        robot = self.root / "ubiquity.yaml"
        robot.write_text("version: 1\nrobot: ubiquity\nfiducial: {marker_size: 0.14}\n"
                         "camera: {sensor_pose: [0, 0, 0.1, -1.5707963, 0, -1.5707963]}\n"
                         "aruco: {dictionaries: [DICT_5X5_1000]}\n", encoding="ascii")
        joined = self.root / "ubiquity.bag"
        add_standing_odometry(bag, joined)
        output = run_offline(joined, self.root / "ubiquity", "--robot", robot, "--set",
                             "detector=aruco")
        self.assertIn("/raspicam_node/image/compressed is the input camera", output)
        self.assertGreater(len(self.landmarks("ubiquity")), 0, output)


def add_standing_odometry(source, target):
    """Copies a bag that has images only, and adds the odometry of a robot that stands."""
    from nav_msgs.msg import Odometry
    import rosbag
    import rospy
    with rosbag.Bag(str(source)) as images, rosbag.Bag(str(target), "w") as bag:
        for topic, message, stamp in images.read_messages():
            bag.write(topic, message, stamp)
        begin, end = images.get_start_time() - 1, images.get_end_time() + 1
        for step in range(int((end - begin) / 0.05)):
            odometry = Odometry(child_frame_id="base_link")
            odometry.header.frame_id = "odom"
            odometry.header.stamp = rospy.Time.from_sec(begin + 0.05 * step)
            odometry.pose.pose.orientation.w = 1.0
            bag.write("/odom", odometry, odometry.header.stamp)


if __name__ == "__main__":
    unittest.main()
