# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading MRPT's files and comparing maps by one script."""
import gzip
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.io.errors import InputError  # noqa: E402
from slam_eval.io.mrpt_files import (  # noqa: E402
    read_id_order, read_kf_slam_map, read_map, read_scene, read_truth_table)
from slam_eval.metrics.landmark_comparison import compare  # noqa: E402

DEMO = pathlib.Path("/usr/share/mrpt/datasets/kf-slam_demo.rawlog")
DEMO_TRUTH = DEMO.with_name("kf-slam_demo_ground_truth.txt")


def ellipse(name, x, y):
    """A CEllipsoid2D as MRPT 2.5 serialises its first fields."""
    name = name.encode()
    return (b"\x9amrpt::opengl::CEllipsoid2D\x00\xff\xc1" + struct.pack("<H", len(name)) + name
            + b"\x00\x00\xff\xff" + struct.pack("<6f", x, y, 0, 0, 0, 0) + bytes(30) + b"\x88")


def observation(ids, own_covariances=False):
    """A CObservationBearingRange as MRPT 2.5 serialises it."""
    data = b"\xa3mrpt::obs::CObservationBearingRange\x03" + struct.pack("<4f", 0, 6, 3, 3)
    data += b"\x94mrpt::poses::CPose3D\x03" + bytes(96) + b"\x88" + bytes(8)
    data += struct.pack("<?3fI", own_covariances, 0.01, 0.01, 0.0, len(ids))
    return data + b"".join(struct.pack("<3fi", 1.0, 0.5, 0.0, i) for i in ids) + bytes(4) + b"\x88"


class InFolder(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, data):
        """Write a file and return its path."""
        (self.folder / name).write_bytes(data)
        return self.folder / name


class MrptFiles(InFolder):

    def test_a_landmark_gets_the_id_that_the_rawlog_shows_at_its_turn(self):
        scene = self.write("kf.3Dscene", gzip.compress(
            b"scene" + ellipse("", 9, 9) + ellipse("0", 1, 2) + ellipse("1", 3, 4)
            + ellipse("2", 5, 6)))
        rawlog = self.write("log.rawlog", gzip.compress(
            observation([12, 5]) + b"between" + observation([5, 12]) + observation([40, 5])))
        found = read_kf_slam_map(scene, rawlog)
        self.assertEqual(found.ids, [12, 5, 40])
        np.testing.assert_allclose(found.positions, [[1, 2], [3, 4], [5, 6]])

    def test_refuses_scenes_that_are_cut_off_or_hold_no_landmarks(self):
        whole = ellipse("", 0, 0) + ellipse("0", 1, 2)
        for data in (whole[:len(ellipse("", 0, 0)) + 33], b"nothing", ellipse("1", 1, 2),
                     gzip.compress(whole)[:-9]):
            with self.assertRaises(InputError):
                read_scene(self.write("kf.3Dscene", data))

    def test_refuses_rawlogs_without_usable_ids(self):
        for data in (b"", observation([-1]), observation([3, 4])[:-30],
                     observation([3], own_covariances=True)):
            with self.assertRaises(InputError):
                read_id_order(self.write("log.rawlog", data))

    def test_refuses_a_rawlog_that_shows_fewer_ids_than_the_map_has(self):
        scene = self.write("kf.3Dscene", ellipse("0", 1, 2) + ellipse("1", 3, 4))
        with self.assertRaisesRegex(InputError, "shows only 1 ids"):
            read_kf_slam_map(scene, self.write("log.rawlog", observation([3])))

    def test_a_scene_without_a_rawlog_is_refused(self):
        with self.assertRaisesRegex(InputError, "--rawlog"):
            read_map(self.write("kf.3Dscene", ellipse("0", 1, 2)))

    def test_truth_tables_give_id_and_position(self):
        path = self.write("t.txt", b"% x y z\n 0.5 7.6 0 5 0 0 17\n\n -1 2 0 5 0 0.0 3 \n")
        found = read_truth_table(path)
        self.assertEqual(found.ids, [17, 3])
        np.testing.assert_allclose(found.positions, [[0.5, 7.6], [-1.0, 2.0]])

    def test_refuses_a_broken_truth_table_and_names_the_line(self):
        for row in (b"1 2 0 5 0 0", b"1 nan 0 5 0 0 3", b"1 2 0 5 0 0 x"):
            with self.assertRaisesRegex(InputError, "t.txt:2:"):
                read_truth_table(self.write("t.txt", b"1 2 0 5 0 0 1\n" + row + b"\n"))

    @unittest.skipUnless(DEMO.exists(), f"{DEMO} is absent (package mrpt-common)")
    def test_the_demo_of_mrpt_has_70_landmarks_in_rawlog_and_truth(self):
        order, truth = read_id_order(DEMO), read_truth_table(DEMO_TRUTH)
        self.assertEqual(len(order), 70)
        self.assertEqual(set(order), set(truth.ids))
        self.assertEqual(order[:3], [7, 17, 18])


class Compare(InFolder):

    def run_script(self, *arguments):
        """Run the program as a user does."""
        return subprocess.run(
            [sys.executable, run_maker.PACKAGE / "scripts" / "landmark_error", *arguments],
            env={"PYTHONPATH": str(run_maker.PACKAGE / "src")}, capture_output=True, text=True,
            check=False)

    def setUp(self):
        super().setUp()
        self.truth = self.write("truth.txt", b"0 0 0 5 0 0 1\n3 0 0 5 0 0 2\n0 4 0 5 0 0 3\n")
        self.ours = self.write("landmarks.yaml", run_maker.landmark_lines(
            [3, 1, 2], [[0.0, 4.3], [0.0, 0.0], [3.0, 0.3]]).encode())

    def test_mean_error_is_taken_in_the_frame_of_the_start(self):
        result = compare(read_map(self.ours), read_map(self.truth))
        self.assertAlmostEqual(result["mean_m"], 0.2)
        self.assertAlmostEqual(result["max_m"], 0.3)
        self.assertAlmostEqual(result["rmse_m"], np.sqrt(0.06))
        self.assertEqual(result["matched"], 3)

    def test_alignment_is_an_option(self):
        moved = self.write("moved.yaml", run_maker.landmark_lines(
            [1, 2, 3], [[5.0, 5.0], [5.0, 8.0], [1.0, 5.0]]).encode())
        estimate, truth = read_map(moved), read_map(self.truth)
        self.assertLess(compare(estimate, truth, align=True)["max_m"], 1e-9)
        self.assertGreater(compare(estimate, truth)["mean_m"], 1.0)

    def test_one_call_compares_ours_and_kf_slams_in_the_same_way(self):
        scene = self.write("kf.3Dscene", ellipse("0", 0.0, 4.3) + ellipse("1", 3.0, 0.3)
                           + ellipse("2", 0.0, 0.0))
        rawlog = self.write("log.rawlog", observation([3, 2, 1]))
        done = self.run_script(self.truth, self.ours, scene, "--rawlog", rawlog, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(done.stdout)
        self.assertAlmostEqual(found[str(scene)]["mean_m"], 0.2, places=6)
        self.assertAlmostEqual(found[str(self.ours)]["mean_m"], 0.2)

    def test_exit_codes_tell_wrong_use_from_bad_files(self):
        self.assertEqual(self.run_script(self.truth).returncode, 2)
        bad = self.run_script(self.truth, self.folder / "none.yaml")
        self.assertEqual(bad.returncode, 1)
        self.assertEqual(bad.stderr.count("\n"), 1)
        self.assertIn("no such file", bad.stderr)

    def test_maps_without_a_common_id_are_refused(self):
        other = self.write("other.yaml", run_maker.landmark_lines([8], [[0.0, 0.0]]).encode())
        done = self.run_script(self.truth, other)
        self.assertEqual(done.returncode, 1)
        self.assertIn("other.yaml", done.stderr)


if __name__ == "__main__":
    unittest.main()
