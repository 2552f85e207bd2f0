# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""add_observations on simulated drives, up to the product that runs on its bag."""
import json
import pathlib
import subprocess
import tempfile
import unittest

from catkin.find_in_workspaces import find_in_workspaces
from detections_made import APRILTAG, apriltag_array, fiducial_array, with_detections
import genpy
import rosbag
from slam_eval.io.landmarks import read_landmarks
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import landmark_error, trajectory_error
from std_msgs.msg import String

SECONDS = "25"  # of the drives


def program(package, name):
    """The path of a program of a package."""
    return find_in_workspaces(["libexec"], package, name, first_match_only=True)[0]


def call(*words):
    """The finished call of add_observations."""
    return subprocess.run([program("slam_bridges", "add_observations"), *map(str, words)],
                          text=True, capture_output=True, check=False)


class Folder(unittest.TestCase):
    """Has a folder with simulated drives, made once."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)

    def drive(self, seed, world="office"):
        """The bag of a drive with wheels and without images."""
        bag = self.root / f"{world}_{seed}.bag"
        if not bag.exists():
            subprocess.run([program("slam_sim", "slam_sim"), bag, "--only", "odom", "--duration",
                            SECONDS, "--seed", str(seed), "--world", world], check=True,
                           stdout=subprocess.DEVNULL)
        return bag


class EndToEnd(Folder):
    def run_on(self, name, source, make, topic, seed):
        """The run of ekf_wheel on a drive with detections, and the ids of its truth."""
        seen = with_detections(source, self.root / f"{name}_seen.bag", make, topic, seed)
        added, run = self.root / f"{name}_added.bag", self.root / name
        done = call(seen, added)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "", "nothing is wrong with these detections")
        subprocess.run([program("slam_ros", "slam_offline"), "ekf_wheel", "--bag", added, "--out",
                        run], check=True, stdout=subprocess.DEVNULL)
        return run

    def assert_right(self, run):
        told = read_run(run)
        self.assertLess(trajectory_error(told.trajectory, told.truth, align=True).rmse, 0.04)
        metrics = json.loads((run / "metrics.json").read_text(encoding="ascii"))
        self.assertEqual(metrics["dropped_messages"], 0)
        truth = read_landmarks(run / "ground_truth_landmarks.yaml")
        mapped = read_landmarks(run / "landmarks.yaml")
        self.assertLess(landmark_error(mapped, truth).rmse, 0.05)
        self.assertGreater(len(mapped.ids), 6)
        self.assertLessEqual(set(mapped.ids), set(truth.ids))

    def test_apriltag_ros(self):
        for seed in (1, 2):
            self.assert_right(self.run_on(f"tags_{seed}", self.drive(seed), apriltag_array,
                                          "/tag_detections", seed))

    def test_aruco_detect(self):
        self.assert_right(self.run_on("fiducials", self.drive(3), fiducial_array,
                                      "/fiducial_transforms", 3))


class Bags(Folder):
    def seen(self):
        """A drive with detections."""
        bag = self.root / "seen.bag"
        return bag if bag.exists() else with_detections(self.drive(1), bag)

    def assert_refused(self, words, *arguments, code=1):
        done = call(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertIn(words, done.stderr)
        self.assertFalse((self.root / "out.bag").exists())
        self.assertEqual(list(self.root.glob("*unfinished*")), [])

    def test_all_else_is_copied_byte_for_byte(self):
        out = self.root / "copied.bag"
        done = call(self.seen(), out)
        self.assertIn(" observations of ", done.stdout)
        with rosbag.Bag(str(self.seen())) as before, rosbag.Bag(str(out)) as after:
            rest = [(topic, raw[:3], time) for topic, raw, time in after.read_messages(raw=True)
                    if topic != "/observations"]
            self.assertEqual(rest, [(topic, raw[:3], time) for topic, raw, time in
                                    before.read_messages(raw=True)])
            arrays = [message for _, message, _ in after.read_messages(["/observations"])]
            stamps = [message.header.stamp for _, message, _ in
                      before.read_messages(["/tag_detections"])]
        self.assertEqual([array.header.stamp for array in arrays], stamps)
        self.assertEqual([array.sequence for array in arrays], list(range(len(arrays))))

    def test_the_mount_may_come_last(self):
        late = self.root / "late.bag"
        with rosbag.Bag(str(self.seen())) as bag, rosbag.Bag(str(late), "w") as out:
            for topic, message, time in bag.read_messages():
                shift = genpy.Duration(100) if topic == "/tf_static" else genpy.Duration()
                out.write(topic, message, time + shift)
        done = call(late, self.root / "late_added.bag")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_bag_without_detections(self):
        self.assert_refused("the bag holds no detections", self.drive(1), self.root / "out.bag")

    def test_detections_on_several_topics(self):
        both = with_detections(self.seen(), self.root / "both.bag", fiducial_array, "/fiducials")
        self.assert_refused("choose one, --topic /fiducials", both, self.root / "out.bag")
        done = call(both, self.root / "one.bag", "--topic", "fiducials")
        self.assertIn("made of /fiducials", done.stdout)

    def test_a_topic_that_is_not_there_or_carries_something_else(self):
        self.assert_refused("the bag has no topic /tags; it has ", self.seen(),
                            self.root / "out.bag", "--topic", "/tags")
        self.assert_refused("/odom carries nav_msgs/Odometry; a bridge takes", self.seen(),
                            self.root / "out.bag", "--topic", "/odom")

    def test_a_bag_with_observations(self):
        added = self.root / "added.bag"
        call(self.seen(), added)
        self.assert_refused("has a topic /observations already", added, self.root / "out.bag")
        done = call(added, self.root / "other.bag", "--observations", "/other")
        self.assertIn(" on /other, made of", done.stdout)

    def test_no_mount(self):
        lost = self.root / "lost.bag"
        with rosbag.Bag(str(self.seen())) as bag, rosbag.Bag(str(lost), "w") as out:
            for topic, message, time in bag.read_messages():
                if topic != "/tf_static":
                    out.write(topic, message, time)
        self.assert_refused("no transform leads from base_link to camera_optical_frame", lost,
                            self.root / "out.bag")
        self.assert_refused("no message on /tag_detections could be used", lost,
                            self.root / "out.bag")
        robot = self.root / "robot.yaml"
        robot.write_text("version: 1\nrobot: r\ncamera: {sensor_pose: [0.1, 0, 0.65, -1.5707963, "
                         "0, -1.5707963]}\n", encoding="utf-8")
        self.assertEqual(call(lost, self.root / "given.bag", "--robot", robot).returncode, 0)

    def test_files_that_are_none(self):
        self.assert_refused("there is no bag", self.root / "nothing.bag", self.root / "out.bag")
        bad = self.root / "bad.bag"
        bad.write_text("no bag", encoding="ascii")
        self.assert_refused("cannot read the bag", bad, self.root / "out.bag")
        self.assert_refused("are the same file", self.seen(), self.seen())
        self.assert_refused("cannot read or write a bag", self.seen(),
                            self.root / "nowhere" / "out.bag")
        self.assert_refused("there is no robot 'nobody'", self.seen(), self.root / "out.bag",
                            "--robot", "nobody")

    def test_a_message_with_other_fields_is_passed_over(self):
        other = genpy.dynamic.generate_dynamic(APRILTAG, "string data\n")[APRILTAG]
        odd = self.root / "odd.bag"
        with rosbag.Bag(str(odd), "w") as out:
            out.write("/tag_detections", other("x"), genpy.Time(1))
            out.write("/robot", String("sim_segway"), genpy.Time(1))
        self.assert_refused("cannot be read", odd, self.root / "out.bag")


if __name__ == "__main__":
    unittest.main()
