# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Recognised places: their file, and precision and recall against the truth."""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402, F401 - it makes slam_eval importable
from slam_eval.io.errors import InputError  # noqa: E402
from slam_eval.io.places import NOWHERE, PlaceVisits, read_places  # noqa: E402
from slam_eval.io.trajectory import Trajectory  # noqa: E402
from slam_eval.metrics.place_recognition import place_recognition  # noqa: E402

SECOND = 1_000_000_000


def ring(laps=2, lap=60, radius=5.0):
    """Truth of a robot that drives round and round, a pose a second."""
    angles = 2.0 * np.pi * np.arange(laps * lap) / lap
    headings = np.arctan2(np.sin(angles + np.pi / 2), np.cos(angles + np.pi / 2))
    poses = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), headings])
    return Trajectory(np.arange(len(poses), dtype=np.int64) * SECOND, poses, None)


def visits(first):
    return PlaceVisits(np.arange(len(first), dtype=np.int64) * SECOND,
                       np.array(first, dtype=np.int64))


class PlaceRecognition(unittest.TestCase):

    def setUp(self):
        self.truth = ring()
        self.ideal = [i % 60 * SECOND for i in range(120)]

    def figures(self, first):
        return place_recognition(visits(first), self.truth).metrics

    def test_who_recognises_all_is_right_everywhere(self):
        found = self.figures(self.ideal)
        self.assertEqual(found["places_recognised"], 60)
        self.assertEqual(found["place_precision"], 1.0)
        self.assertEqual(found["place_recall"], 1.0)
        self.assertLess(found["place_error_max_m"], 1e-6)

    def test_who_recognises_nothing_has_no_precision(self):
        found = self.figures([i * SECOND for i in range(120)])
        self.assertEqual(found["places_recognised"], 0)
        self.assertIsNone(found["place_precision"])
        self.assertEqual(found["place_recall"], 0.0)
        self.assertEqual(self.figures([NOWHERE] * 120)["place_recall"], 0.0)

    def test_a_wrong_place_lowers_both(self):
        first = list(self.ideal)
        for i in range(60, 75):
            first[i] = (i % 60 + 20) % 60 * SECOND
        found = self.figures(first)
        self.assertAlmostEqual(found["place_precision"], 45 / 60)
        self.assertAlmostEqual(found["place_recall"], 45 / 60)
        self.assertGreater(found["place_error_max_m"], 5.0)

    def test_the_same_place_the_other_way_round_is_none_that_could_be_recognised(self):
        self.truth.poses[60:, 2] += np.pi
        self.assertIsNone(self.figures(self.ideal)["place_recall"])

    def test_steps_without_truth_do_not_count(self):
        late = PlaceVisits(np.array([500 * SECOND]), np.array([0]))
        self.assertIsNone(place_recognition(late, self.truth))


class ReadPlaces(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "places.csv"

    def read(self, text):
        self.path.write_text(text)
        return read_places(self.path)

    def refused(self, text, *parts):
        with self.assertRaises(InputError) as raised:
            self.read(text)
        for part in (str(self.path), *parts):
            self.assertIn(part, str(raised.exception))

    def test_reads_visits_and_steps_without_a_place(self):
        found = self.read("stamp,first_visit\n1.000000000,1.000000000\n2.500000000,\n"
                          "3.000000000,1.000000000\n")
        self.assertEqual(found.stamps.tolist(), [SECOND, 5 * SECOND // 2, 3 * SECOND])
        self.assertEqual(found.first.tolist(), [SECOND, NOWHERE, SECOND])
        self.assertEqual(len(self.read("stamp,first_visit\n")), 0)

    def test_refuses_what_it_cannot_be(self):
        self.refused("stamp,first\n", ":1:", "header")
        self.refused("stamp,first_visit\n1.0\n", ":2:", "1 fields where 2 belong")
        self.refused("stamp,first_visit\nx,1.0\n", ":2:", "no number")
        self.refused("stamp,first_visit\n1.0,2.0\n", ":2:", "after this visit")


if __name__ == "__main__":
    unittest.main()
