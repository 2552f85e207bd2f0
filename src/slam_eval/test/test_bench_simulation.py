# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figures of the benchmarks office, fiducial and online, without running any of them."""
import json
import pathlib
import struct
import tempfile
import types
import unittest

import numpy as np

from slam_eval.bench import fiducial, office
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.process import Usage
from slam_eval.bench.harness.products import sensors_for, Twin, twin_of
from slam_eval.bench.harness.table import mean_row
from slam_eval.io.landmarks import LandmarkMap
from slam_eval.metrics import latency
from slam_eval.plot.benchmarks import plot_seeds
from slam_eval.plot.detection import plot_detection_rates


def landmark_map(ids):
    """A map of these landmarks."""
    return LandmarkMap(list(ids), np.zeros((len(ids), 2)), np.zeros((len(ids), 2, 2)))


def seed_row(seed, ate, mapped, true, nees=3.0, drift=0.4, twin=None, own_ids=False):
    """The numbers of a seed's line."""
    run = types.SimpleNamespace(landmarks=landmark_map(mapped), true_landmarks=landmark_map(true),
                                metrics={"update_ms_p50": 2.0, "update_ms_p99": 3.0})
    run.landmarks.has_own_ids = own_ids
    result = types.SimpleNamespace(metrics={
        "ate_rmse_m": ate, "odometry_ate_rmse_m": drift, "landmark_rmse_m": 0.01,
        "nees_mean": nees, "nis_mean": 1.0})
    return office.values(seed, run, result, Usage(5.0, 6.0, 30.0), twin)


class Office(unittest.TestCase):

    def verdicts(self, rows, world="office", twin=None, product="ekf_wheel"):
        """The lines below the table."""
        return office.verdicts(office.goals_of(world, product), mean_row("mean", rows),
                               office.worst_row(rows), twin)

    def cell(self, row, column):
        """A number of a line."""
        return row[office.HEADER.index(column)]

    def test_a_marker_that_does_not_exist_is_false_and_not_mapped(self):
        row = seed_row(1, 0.02, [1, 2, 99], [1, 2, 3])
        self.assertEqual([self.cell(row, c) for c in ("mapped", "of", "false markers")], [2, 3, 1])

    def test_landmarks_with_ids_of_their_own_are_no_markers(self):
        row = seed_row(1, 0.02, [1, 2], [1, 2], own_ids=True)
        self.assertEqual([self.cell(row, c) for c in ("mapped", "of", "false markers")],
                         [None, None, None])
        self.assertNotIn("markers", self.verdicts([row]))

    def test_a_run_without_a_map_has_mapped_nothing(self):
        run = types.SimpleNamespace(landmarks=None, true_landmarks=landmark_map([1, 2]), metrics={})
        row = office.values(1, run, types.SimpleNamespace(metrics={}), Usage(1.0, 1.0, 1.0))
        self.assertEqual([self.cell(row, c) for c in ("mapped", "of", "ATE [m]")], [0, 2, None])

    def test_the_worst_is_the_largest_error_but_the_fewest_markers_and_the_least_drift(self):
        worst = office.worst_row([seed_row(1, 0.02, [1, 2], [1, 2], drift=0.5),
                                        seed_row(2, 0.01, [1], [1, 2], drift=0.3)])
        self.assertEqual([self.cell(worst, c) for c in ("ATE [m]", "mapped", "dead reckoning [m]")],
                         [0.02, 1, 0.3])

    def test_all_goals_are_reached_by_good_seeds(self):
        text = self.verdicts([seed_row(1, 0.02, [1, 2], [1, 2]), seed_row(2, 0.03, [1, 2], [1, 2])])
        self.assertNotIn("MISSED", text)
        self.assertEqual(text.count("reached"), 7)

    def test_one_bad_seed_misses_the_goal(self):
        good = seed_row(1, 0.02, [1, 2], [1, 2])
        for bad, what in ((seed_row(2, 0.031, [1, 2], [1, 2]), "worst ATE"),
                          (seed_row(2, 0.02, [1], [1, 2]), "fewest markers"),
                          (seed_row(2, 0.02, [1, 2, 9], [1, 2]), "false markers"),
                          (seed_row(2, 0.02, [1, 2], [1, 2], nees=9.0), "mean NEES"),
                          (seed_row(2, 0.02, [1, 2], [1, 2], drift=0.2), "least drift")):
            missed = [part for part in self.verdicts([good, bad]).split("\n") if "MISSED" in part]
            self.assertEqual([part.startswith("- " + what) for part in missed], [True], missed)

    def test_a_path_that_is_too_large_or_too_small_misses_the_goal_of_the_gallery(self):
        for scale, word in ((0.009, "reached"), (-0.009, "reached"), (-0.011, "MISSED")):
            run = types.SimpleNamespace(landmarks=None, true_landmarks=None, metrics={})
            result = types.SimpleNamespace(metrics={"ate_rmse_m": 0.02, "scale_error": scale})
            row = office.values(1, run, result, Usage(5.0, 6.0, 30.0))
            line = [line for line in self.verdicts([row], "gallery").split("\n") if "scale" in line]
            self.assertIn(word, line[0])

    def test_a_product_may_have_goals_of_its_own(self):
        row = seed_row(1, 0.02, [], [], nees=0.5, own_ids=True)
        missed = {product: [line for line in self.verdicts([row], "gallery", product=product)
                            .split("\n") if "MISSED" in line]
                  for product in ("ekf_mono", "graph_mono")}
        self.assertIn("mean NEES", missed["ekf_mono"][0])
        self.assertIn("worst ATE", missed["graph_mono"][0])
        self.assertEqual([len(lines) for lines in missed.values()], [1, 1])

    def test_a_product_that_looks_up_is_measured_by_that_with_wheels(self):
        for name, twin in (("pf_visual", Twin("pf_wheel", 1.1)),
                           ("ekf_visual_wheel", Twin("ekf_wheel", 1.1)),
                           ("graph_ceiling", Twin("pf_visual", 1.5)),
                           ("pf_wheel", None), ("/tmp/mine.yaml", None)):
            self.assertEqual(twin_of(name), twin)
            self.assertEqual("ceiling_camera" in sensors_for(name), twin is not None)
        for wheels, word in ((0.019, "reached"), (0.018, "MISSED")):
            text = self.verdicts([seed_row(1, 0.02, [1], [1], drift=0.01,
                                           twin={"ate_rmse_m": wheels})],
                                 twin=Twin("pf_wheel", 1.1))
            self.assertIn(f"<= 1.1: {word}", text)
            self.assertNotIn("dead reckoning", text)  # it is to be good

    def test_a_world_of_ones_own_has_no_goals(self):
        self.assertEqual(self.verdicts([seed_row(1, 5.0, [], [1])], "mine"), "")

    def test_the_remaining_time_is_that_of_the_seeds_done(self):
        remaining = office.RemainingTime(3)
        self.assertEqual(str(remaining), "1 of 3")
        remaining.finished()
        self.assertRegex(str(remaining), "^2 of 3, about 0 s left$")


class Fiducial(unittest.TestCase):

    def entry(self, **values):
        """A cell of the detection table."""
        return {"detector": "apriltag", "distance_m": 1.0, "obliqueness_deg": 0, "trials": 20,
                "detected": 10, "range_bias": 0.002, **values}

    def read(self, timing=(), detection=()):
        """What the program's JSON says."""
        return fiducial.read_result(json.dumps({"timing": list(timing),
                                                      "detection": list(detection)}))

    def test_ratio_and_rate_are_computed(self):
        timing, detection = self.read(
            [{"detector": "aruco", "ours_ms": 11.0, "bare_ms": 10.0}], [self.entry()])
        self.assertAlmostEqual(timing[0]["ratio"], 1.1)
        self.assertEqual(detection[0]["rate"], 0.5)

    def test_other_output_is_an_error(self):
        for text in ("", "{}", "[1]", '{"timing": [{}], "detection": []}'):
            with self.subTest(text), self.assertRaises(BenchError):
                fiducial.read_result(text)

    def test_the_table_has_a_line_an_angle_and_a_dash_where_nothing_was_measured(self):
        _, detection = self.read(detection=[self.entry(), self.entry(
            distance_m=2.0, obliqueness_deg=60, detected=20)])
        cells = [[cell.strip() for cell in line.strip("|").split("|")]
                 for line in fiducial.rate_table(detection).split("\n")]
        self.assertEqual(cells[0], ["obliqueness", "1 m", "2 m"])
        self.assertEqual(cells[2:], [["0 deg", "50%", "-"], ["60 deg", "-", "100%"]])

    def test_a_bias_counts_only_where_the_goal_holds(self):
        far = self.entry(distance_m=6.0, range_bias=0.5)
        self.assertIn("reached", fiducial.bias_sentence("apriltag", [self.entry(), far]))
        near = self.entry(range_bias=-0.02)
        self.assertIn("MISSED", fiducial.bias_sentence("apriltag", [self.entry(), near]))


class Latency(unittest.TestCase):

    def test_the_stamp_is_read_to_the_nanosecond(self):
        message = struct.pack("<IIII", 7, 1600000000, 123456789, 6) + b"camera"
        self.assertEqual(latency.stamp_of(message), 1600000000123456789)

    def test_times_are_taken_by_stamp_in_any_order_of_arrival(self):
        result = latency.latency({1: 10.0, 2: 11.0, 3: 12.0}, {3: 12.030, 1: 10.010, 2: 11.020})
        self.assertAlmostEqual(result.p50_ms, 20.0)
        self.assertAlmostEqual(result.max_ms, 30.0)
        self.assertEqual(result.unanswered, 0)

    def test_images_without_pose_count_only_between_the_first_and_the_last_pose(self):
        images = {stamp: float(stamp) for stamp in range(10)}
        result = latency.latency(images, {2: 2.01, 3: 3.01, 6: 6.01})
        self.assertEqual((result.images, result.poses, result.unanswered), (10, 3, 2))

    def test_without_a_pair_there_is_no_latency(self):
        self.assertIsNone(latency.latency({1: 0.0}, {2: 0.0}))


class Pictures(unittest.TestCase):

    def test_both_are_png_files(self):
        with tempfile.TemporaryDirectory() as folder:
            seeds, rates = pathlib.Path(folder) / "seeds.png", pathlib.Path(folder) / "rates.png"
            plot_seeds({"SLAM": [0.01, 0.02], "dead reckoning": [0.3, 0.4]}, 0.03, seeds)
            plot_detection_rates({"apriltag": ([0.5, 1.0], [0, 60], [[1.0, 0.5], [None, 0.0]])},
                                 rates)
            for path in (seeds, rates):
                self.assertEqual(path.read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
