# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""True poses in whatever form: the figures are the same, and those of another implementation."""
import contextlib
import io
import json
import pathlib
import tempfile
import unittest

import run_maker
from geometry_msgs.msg import (
    PointStamped, PoseStamped, PoseWithCovarianceStamped, TransformStamped)
from nav_msgs.msg import Odometry, Path
import numpy as np
import rosbag
import rospy
from scipy.optimize import least_squares
from slam_eval.io.bag_poses import read_bag_poses
from slam_eval.io.errors import InputError
from slam_eval.io.trajectory import interpolate, read_trajectory, read_truth
from slam_eval.report.cli import main
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage


def fill(pose, values):
    """Sets a pose (position and orientation) or transform (translation and rotation)."""
    place, turn = [getattr(pose, name) for name in
                   (("position", "orientation") if hasattr(pose, "position") else
                    ("translation", "rotation"))]
    place.x, place.y = values[:2]
    turn.z, turn.w = np.sin(values[2] / 2), np.cos(values[2] / 2)


def stamped(message, stamp, pose_of, values):
    message.header.stamp = rospy.Time(nsecs=int(stamp))
    fill(pose_of(message), values)
    return message


class InFolder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.run_folder = cls.folder / "run"
        run_maker.make_run(cls.run_folder, count=300, gap=False)
        cls.own = cls.run_folder / "ground_truth.tum"
        cls.truth = read_truth(cls.own)
        cls.write_bag(cls.folder / "truth.bag")

    @classmethod
    def write_bag(cls, path):
        travelled = Path()
        with rosbag.Bag(str(path), "w") as bag:
            for stamp, pose in zip(cls.truth.stamps, cls.truth.poses):
                time = rospy.Time(nsecs=int(stamp))
                step = stamped(PoseStamped(), stamp, lambda m: m.pose, pose)
                travelled.poses.append(step)
                bag.write("/pose", step, time)
                short = stamped(PoseStamped(), stamp, lambda m: m.pose, pose)
                for name in ("z", "w"):
                    setattr(short.pose.orientation, name, getattr(short.pose.orientation, name) / 2)
                bag.write("/half_length", short, time)
                for topic, message in (("/odometry", Odometry()),
                                       ("/amcl", PoseWithCovarianceStamped())):
                    bag.write(topic, stamped(message, stamp, lambda m: m.pose.pose, pose), time)
                tf = stamped(TransformStamped(), stamp, lambda m: m.transform, pose)
                tf.child_frame_id = "mocap_base"
                other = stamped(TransformStamped(), stamp, lambda m: m.transform, (9.0, 9.0, 0.0))
                other.child_frame_id = "somebody"
                bag.write("/tf", TFMessage([other, tf]), time)
                bag.write("/vicon", tf, time)
                point = PointStamped()
                point.header.stamp, (point.point.x, point.point.y) = time, pose[:2]
                bag.write("/gps", point, time)
            bag.write("/path", travelled, time)
            bag.write("/robot", String("ring"), time)
            step = stamped(PoseStamped(), stamp, lambda m: m.pose, (np.nan, 0.0, 0.0))
            bag.write("/broken", step, time)

    def evaluate(self, *arguments):
        """(exit code, metrics, what was said) of ./slam eval."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                code = main([str(each) for each in (self.run_folder, *arguments)])
            except SystemExit as wrong_use:
                code = wrong_use.code
        metrics = json.loads((self.run_folder / "metrics.json").read_text(encoding="utf-8"))
        return code, metrics, err.getvalue()


class Truth(InFolder):
    def test_is_read_from_each_kind_of_message(self):
        bag = self.folder / "truth.bag"
        for topic in ("/pose", "/half_length", "odometry", "/amcl", "/path", "/vicon"):
            found = read_bag_poses(bag, topic)
            np.testing.assert_array_equal(found.stamps, self.truth.stamps, topic)
            np.testing.assert_allclose(found.poses, self.truth.poses, atol=1e-7, err_msg=topic)
        for frame in ("mocap_base", "/mocap_base"):
            np.testing.assert_allclose(read_bag_poses(bag, "/tf", frame).poses, self.truth.poses,
                                       atol=1e-7)
        self.assertFalse(read_bag_poses(bag, "/gps").has_heading)

    def test_gives_the_same_figures_in_each_form(self):
        code, own, _ = self.evaluate()
        self.assertEqual(code, 0)
        copy = self.folder / "copy.tum"
        copy.write_bytes(self.own.read_bytes())
        for arguments in (["--truth", copy],
                          ["--truth", self.folder / "truth.bag", "--truth-topic", "odometry"],
                          ["--truth", self.folder / "truth.bag", "--truth-topic", "/tf",
                           "--truth-frame", "mocap_base"]):
            code, found, said = self.evaluate(*arguments)
            self.assertEqual(code, 0, said)
            for key in ("ate_rmse_m", "ate_max_m", "nees_mean", "rpe_trans_1m_m"):
                self.assertAlmostEqual(found[key], own[key], places=5, msg=key)

    def test_gives_the_error_of_another_implementation(self):
        """The alignment by an optimiser instead of a decomposition."""
        _, own, _ = self.evaluate()
        estimate = read_trajectory(self.run_folder / "trajectory.tum")
        true, valid = interpolate(self.truth, estimate.stamps)
        estimate, true = estimate.poses[valid, :2], true[valid, :2]

        def residuals(T):
            turn = np.array([[np.cos(T[2]), -np.sin(T[2])], [np.sin(T[2]), np.cos(T[2])]])
            return (estimate @ turn.T + T[:2] - true).ravel()

        best = min((least_squares(residuals, (0.0, 0.0, angle), xtol=1e-14, ftol=1e-14)
                    for angle in (0.0, 2.0, -2.0)), key=lambda result: result.cost)
        self.assertAlmostEqual(own["ate_rmse_m"], np.sqrt(2.0 * best.cost / len(true)), places=8)


class BadTruth(InFolder):
    def refuses(self, says, *arguments):
        code, _, said = self.evaluate(*arguments)
        self.assertEqual(code, 1, said)
        self.assertEqual(said.count("\n"), 1, said)
        self.assertIn(says, said)

    def test_is_refused_with_a_sentence(self):
        bag = self.folder / "truth.bag"
        self.refuses("there is no topic 'odometri' (did you mean '/odometry'?)", "--truth", bag,
                     "--truth-topic", "odometri")
        self.refuses("is of std_msgs/String, which holds no poses", "--truth", bag, "--truth-topic",
                     "/robot")
        self.refuses("--truth-frame", "--truth", bag, "--truth-topic", "/tf")
        self.refuses("holds no pose that was asked for", "--truth", bag, "--truth-topic", "/tf",
                     "--truth-frame", "nobody")
        self.refuses("not finite", "--truth", bag, "--truth-topic", "/broken")
        self.refuses("no such file", "--truth", self.folder / "nothing.tum")
        self.refuses("cannot be read as a bag", "--truth", self.folder / "nothing.bag")
        (self.folder / "text.bag").write_text("no bag", encoding="utf-8")
        self.refuses("cannot be read as a bag", "--truth", self.folder / "text.bag")

    def test_with_headings_in_some_lines_only_is_refused(self):
        lines = self.own.read_text(encoding="utf-8").splitlines()
        fields = lines[-1].split()
        lines[-1] = " ".join([*fields[:4], "0", "0", "0", "0"])
        half = self.folder / "half.tum"
        half.write_text("\n".join(lines), encoding="utf-8")
        self.refuses("some poses have a heading and others none", "--truth", half)

    def test_that_knows_fewer_than_two_poses_gives_no_figures(self):
        second, millisecond = 1_000_000_000, 1_000_000
        first = self.truth.stamps[0] + millisecond
        for stamps in ((first - 2 * millisecond, first), first + second * np.arange(10)):
            few = self.folder / "few.tum"
            few.write_text("\n".join(f"{stamp / second:.9f} 0 0 0 0 0 0 1" for stamp in stamps),
                           encoding="utf-8")
            code, found, _ = self.evaluate("--truth", few)
            self.assertEqual(code, 0)
            for key in ("ate_rmse_m", "nees_mean", "confidently_wrong_s"):
                self.assertNotIn(key, found)

    def test_options_that_contradict_each_other_are_wrong_use(self):
        topic = ["--truth-topic", "/pose"]
        for arguments in (topic, ["--truth", self.own, *topic]):
            code, _, said = self.evaluate(*arguments)
            self.assertEqual(code, 2)
            self.assertIn("--truth-topic", said)

    def test_leaves_what_is_there(self):
        _, before, _ = self.evaluate()
        self.refuses("no such file", "--truth", self.folder / "nothing.tum")
        with self.assertRaises(InputError):
            read_bag_poses(self.folder / "truth.bag", "/broken")
        after = json.loads((self.run_folder / "metrics.json").read_text(encoding="utf-8"))
        self.assertEqual(before, after)


if __name__ == "__main__":
    unittest.main()
