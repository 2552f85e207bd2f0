# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is kept of a recording: bounded, evenly, in order."""
import math
import pathlib
import tempfile
import unittest

import numpy as np
from slam_doctor.checks.machine import computer, governors
from slam_doctor.record.laser import LaserRecord
from slam_doctor.record.observations import is_bad
from slam_doctor.record.odometry import Covariances, OdometryRecord, Path
from slam_doctor.record.stream import BINS, Stream
from slam_doctor.record.thinned import Blocks, Thinned, ThinnedRows
from sensor_msgs.msg import LaserScan

SECOND = 10**9


class Keeping(unittest.TestCase):
    def test_few_items_are_all_kept(self):
        kept = Thinned(10)
        for item in range(9):
            kept.append(item)
        self.assertEqual(kept.items, list(range(9)))

    def test_many_are_kept_evenly(self):
        kept, rows = Thinned(100), ThinnedRows(2, 100)
        for item in range(100_000):
            kept.append(item)
            rows.append((item, -item))
        for items in (kept.items, rows.array()[:, 0]):
            self.assertLess(len(items), 101)
            self.assertGreater(len(items), 40)
            self.assertEqual(len(set(np.diff(items))), 1)
            self.assertEqual(items[0], 0)
        np.testing.assert_array_equal(rows.array()[:, 0], -rows.array()[:, 1])

    def test_runs_hold_successive_items(self):
        kept = Blocks(10, 8)
        for item in range(5000):
            kept.append(item)
        self.assertLess(len(kept.runs()), 10)
        for run in kept.runs():
            self.assertEqual(run, list(range(run[0], run[0] + len(run))))


class Times(unittest.TestCase):
    def stream(self, stamps, delay=0):
        out = Stream(0, 0)
        for stamp in stamps:
            out.add(int(stamp * SECOND) + delay, int(stamp * SECOND))
        return out

    def test_the_longest_gap(self):
        self.assertEqual(self.stream([1, 2, 3, 7, 8]).longest_gap, (4.0, 3.0, 7.0))

    def test_stamps_that_do_not_grow(self):
        out = self.stream([1, 2, 2, 1.5, 3, 0])
        self.assertEqual((out.equal, out.back, out.zero), (1, 1, 1))
        self.assertAlmostEqual(out.largest_step_back, 0.5)

    def test_one_message_has_no_interval(self):
        self.assertTrue(math.isnan(self.stream([1]).interval()))
        self.assertTrue(math.isnan(Stream(0, 0).offset()))

    def test_the_timeline_stays_short_and_counts_all(self):
        out = self.stream(np.arange(0, 5000, 0.5))
        self.assertLessEqual(len(out.timeline.counts), BINS)
        self.assertEqual(sum(out.timeline.counts), 10_000)
        self.assertGreaterEqual(len(out.timeline.counts) * out.timeline.width, 4999)


class Odometry(unittest.TestCase):
    def test_the_motion_is_seen_from_the_first_pose(self):
        rows = np.array([[0, 1, 1, math.pi / 2, 0, 0], [1, 1, 3, math.pi / 2, 0, 0]])
        np.testing.assert_allclose(Path(rows).motion(0, 1), (2, 0, 0), atol=1e-9)

    def test_headings_go_on_beyond_half_a_turn(self):
        rows = np.array([[t, 0, 0, math.remainder(t, 2 * math.pi), 0, 0] for t in range(9)])
        self.assertAlmostEqual(Path(rows).motion(0, 8)[2], 8.0)

    def test_unknown_before_the_first_sample(self):
        rows = np.array([[0.0, 0, 0, 0, 0, 0], [1, 1, 0, 0, 0, 0]])
        self.assertTrue(np.isnan(Path(rows).motion(-1, 1)).any())

    def test_a_driver_that_tells_only_the_twist(self):
        record = OdometryRecord(0)
        for i in range(101):
            record.add(i * SECOND // 10, 0.0, 0.0, 0.0, 0.5, 0.0)
        self.assertAlmostEqual(Path(record.samples()).motion(0, 10)[0], 5.0)

    def test_covariances(self):
        def counts(diagonal, other=0.0):
            values = [0.0] * 36
            values[0], values[7], values[35], values[1] = *diagonal, other
            told = Covariances()
            told.add(values)
            return told.zero, told.invalid, told.huge
        self.assertEqual(counts((0, 0, 0)), (1, 0, 0))
        self.assertEqual(counts((-1, 0, 0)), (1, 0, 0))
        self.assertEqual(counts((0.1, 0.1, 0.1)), (0, 0, 0))
        self.assertEqual(counts((0.1, -0.1, 0.1)), (0, 1, 0))
        self.assertEqual(counts((0.1, 0.1, 0.1), 0.05), (0, 1, 0))  # not symmetric
        self.assertEqual(counts((0.1, math.nan, 0.1)), (0, 1, 0))
        self.assertEqual(counts((0.1, 0.1, 1e9)), (0, 0, 1))


class Laser(unittest.TestCase):
    def record(self, *all_ranges):
        out = LaserRecord(0)
        for number, ranges in enumerate(all_ranges):
            message = LaserScan(angle_min=0.0, angle_max=0.1 * (len(ranges) - 1),
                                angle_increment=0.1, range_min=0.1, range_max=10.0, ranges=ranges)
            message.header.stamp.secs = number + 1
            out.take(message)
        return out

    def test_beams_that_tell_nothing_are_left_out(self):
        out = self.record([1.0, math.nan, math.inf, -math.inf, 0.0, 0.05, 10.0, 2.0])
        self.assertEqual(out.usable.items, [0.25])

    def test_repeats(self):
        a, b = [1.0, 2.0, math.nan], [1.0, 2.5, math.nan]
        self.assertEqual(self.record(a, b, b, b, a, a).repeats(), [(2.0, 4.0), (5.0, 6.0)])

    def test_no_beams(self):
        out = self.record([])
        self.assertEqual((out.usable.items, out.without_points), ([0.0], 1))


class Observations(unittest.TestCase):
    def test_covariances(self):
        self.assertFalse(is_bad([-1, 0, 0, 0]))
        self.assertFalse(is_bad([0.1, 0.01, 0.01, 0.1]))
        for bad in ([0, 0, 0, 0], [0.1, 0.2, 0.2, 0.1], [math.nan, 0, 0, 1], [0.1, 0, 0, -0.1]):
            self.assertTrue(is_bad(bad), bad)


class Computer(unittest.TestCase):
    def level(self, load=0.5, names=(), free=8000.0, is_live=True):
        return computer(4, load, set(names), free, is_live)[0].level.name

    def test_what_leaves_no_room(self):
        self.assertEqual(self.level(), "OK")
        self.assertEqual(self.level(names=["performance"]), "OK")
        for bad in ({"load": 3.9}, {"names": ["powersave"]}, {"free": 100.0}):
            self.assertEqual(self.level(**bad), "WARN")
            self.assertEqual(self.level(**bad, is_live=False), "OK")

    def test_governors(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            self.assertEqual(governors(root), set())
            for number, driver in enumerate(("acpi-cpufreq", "intel_pstate")):
                folder = root / f"devices/system/cpu/cpu{number}/cpufreq"
                folder.mkdir(parents=True)
                (folder / "scaling_governor").write_text("powersave\n", encoding="utf-8")
                (folder / "scaling_driver").write_text(driver, encoding="utf-8")
            self.assertEqual(governors(root), {"powersave", "powersave of the processor"})


if __name__ == "__main__":
    unittest.main()
