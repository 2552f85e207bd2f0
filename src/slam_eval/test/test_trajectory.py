# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading trajectories and interpolating truth."""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.io.errors import InputError  # noqa: E402
from slam_eval.io.trajectory import (  # noqa: E402
    interpolate, parse_stamp, read_trajectory, read_truth, Trajectory)

GOOD = "1.000000000 0 0 0 0 0 0 1\n2.000000000 1 0 0 0 0 0 1\n"


def truth(seconds, poses):
    """A truth trajectory."""
    stamps = [round(t * 1e9) for t in seconds]
    return Trajectory(np.array(stamps, dtype=np.int64), np.array(poses, dtype=float))


class ReadTrajectory(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name) / "trajectory.tum"

    def refused(self, text, *parts):
        """The reader refuses the text with a sentence that holds the parts."""
        self.path.write_text(text)
        with self.assertRaises(InputError) as caught:
            read_trajectory(self.path)
        for part in (str(self.path),) + parts:
            self.assertIn(part, str(caught.exception))

    def test_reads_back_stamps_to_the_nanosecond_and_poses(self):
        poses = np.array([[1.0, 2.0, 3.1], [-1.0, 0.5, -3.1]])
        self.path.write_text("# comment\n" + run_maker.tum_lines([0.25, 0.5], poses).replace(
            "0.250000000", "1288971842.161000003").replace("0.500000000 -1", "1288971842.5 -1"))
        found = read_trajectory(self.path)
        self.assertEqual(found.stamps.tolist(), [1288971842161000003, 1288971842500000000])
        np.testing.assert_allclose(found.poses, poses, atol=1e-8)

    def test_stamps_are_exact_integers(self):
        self.assertEqual(parse_stamp("1288971842.161000003"), 1288971842161000003)
        self.assertRaises(ValueError, parse_stamp, "nan")

    def test_refuses_a_missing_file(self):
        with self.assertRaisesRegex(InputError, "no such file"):
            read_trajectory(self.path)

    def test_refuses_an_empty_file(self):
        self.refused("", "empty")
        self.refused("\n\n", "empty")

    def test_refuses_a_file_with_comments_only(self):
        self.refused("# stamp tx ty tz qx qy qz qw\n", "no pose")

    def test_refuses_a_line_that_is_cut_off_and_names_it(self):
        self.refused(GOOD + "3.000000000 1 0 0 0", ":3:", "5 fields where 8 belong")

    def test_refuses_a_last_number_that_is_cut_off(self):
        self.refused("1.000000000 0 0 0 0 0 0.6 0", ":1:", "quaternion")

    def test_only_truth_may_have_no_heading(self):
        text = "# point of the robot: 3.78 0.5\n1.0 4 5 0 0 0 0 0\n2.0 4 5 0 0 0 0 0\n"
        self.refused(text, "no pose has a heading")
        found = read_truth(self.path)
        self.assertFalse(found.has_heading)
        self.assertEqual(found.point, (3.78, 0.5))
        np.testing.assert_array_equal(found.poses[:, :2], [[4, 5], [4, 5]])
        self.path.write_text(GOOD)
        self.assertTrue(read_truth(self.path).has_heading)

    def test_refuses_a_point_of_the_robot_that_is_none(self):
        self.path.write_text("# point of the robot: 3.78\n" + GOOD)
        with self.assertRaisesRegex(InputError, "two numbers"):
            read_truth(self.path)

    def test_refuses_nan_and_infinity_and_names_the_line(self):
        self.refused(GOOD + "3.0 nan 0 0 0 0 0 1\n", ":3:", "not finite")
        self.refused(GOOD + "3.0 0 inf 0 0 0 0 1\n", ":3:", "not finite")
        self.refused(GOOD + "nan 0 0 0 0 0 0 1\n", ":3:")

    def test_refuses_words(self):
        self.refused(GOOD + "3.0 0 zero 0 0 0 0 1\n", ":3:", "no number")

    def test_refuses_stamps_that_do_not_rise(self):
        self.refused(GOOD + "2.0 0 0 0 0 0 0 1\n", ":3:", "stamps have to rise")
        self.refused(GOOD + "1.5 0 0 0 0 0 0 1\n", ":3:", "stamps have to rise")

    def test_refuses_a_binary_file(self):
        self.path.write_bytes(b"\x80\xff\x00\x01" * 20)
        self.assertRaises(InputError, read_trajectory, self.path)


class Interpolate(unittest.TestCase):

    def poses_at(self, reference, seconds):
        return interpolate(reference, [round(t * 1e9) for t in seconds])

    def test_position_is_linear_and_heading_takes_the_shorter_way(self):
        reference = truth([0.0, 0.4], [[0.0, 0.0, 3.0], [2.0, -4.0, -3.0]])
        poses, valid = self.poses_at(reference, [0.1])
        self.assertTrue(valid[0])
        turn = 2.0 * np.pi - 6.0
        np.testing.assert_allclose(poses[0], [0.5, -1.0, 3.0 + 0.25 * turn], atol=1e-9)

    def test_stamps_outside_truth_are_left_out(self):
        reference = truth([1.0, 1.4], np.zeros((2, 3)))
        _, valid = self.poses_at(reference, [0.9, 1.0, 1.2, 1.4, 1.5])
        self.assertEqual(valid.tolist(), [False, True, True, True, False])

    def test_stamps_inside_a_gap_over_half_a_second_are_left_out(self):
        reference = truth([0.0, 0.5, 1.1, 1.2], np.zeros((4, 3)))
        _, valid = self.poses_at(reference, [0.25, 0.5, 0.8, 1.1, 1.15])
        self.assertEqual(valid.tolist(), [True, True, False, True, True])

    def test_a_single_truth_pose_serves_its_own_stamp_only(self):
        _, valid = self.poses_at(truth([1.0], np.zeros((1, 3))), [0.9, 1.0, 1.1])
        self.assertEqual(valid.tolist(), [False, True, False])


if __name__ == "__main__":
    unittest.main()
