# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark carried shows outcomes and its goals right; no product runs."""
import unittest

from slam_eval.bench import carried
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.judge import Outcome
from slam_eval.bench.harness.products import map_sensors_for


def outcome(told=0.2, wrong=0.0, false=0):
    """Returns the outcome for a robot that was reported lost some time after it was lifted."""
    return Outcome(0.4, 2.5, 3.0, wrong, told, 1.5, false)


class Carried(unittest.TestCase):

    def text(self, *outcomes):
        """The benchmark's text of outcomes, one for each seed."""
        rows = [carried.row(seed, found) for seed, found in enumerate(outcomes, start=1)]
        return carried.section("ekf_ceiling", rows).markdown()

    def test_robots_are_lifted_while_they_drive_and_at_different_times(self):
        times = {carried.lifted_at(seed) for seed in range(1, 16)}
        self.assertEqual(times, set(range(carried.FIRST, carried.LAST)))

    def test_what_keeps_to_the_goals(self):
        text = self.text(outcome(), outcome(0.1))
        self.assertNotIn("MISSED", text)
        self.assertNotIn("never", text)

    def test_each_goal_can_be_missed(self):
        for missed in (outcome(told=6.0), outcome(wrong=0.02), outcome(false=1)):
            self.assertEqual(self.text(outcome(), missed).count("MISSED"), 1)

    def test_a_robot_that_is_never_reported_lost_is_counted(self):
        self.assertIn("never reported lost: 1 of 2 (MISSED)", self.text(outcome(), outcome(None)))
        self.assertIn("never reported lost: 1 of 1 (MISSED)", self.text(outcome(None)))

    def test_the_world_and_how_far_it_was_carried_are_named(self):
        text = carried.section("ekf_wheel_trunks", [carried.row(1, outcome())], "forest", 30.0).markdown()
        self.assertIn("ekf_wheel_trunks, carried on in the world forest", text)
        self.assertIn("30 s later", text)

    def test_a_drive_holds_what_the_products_map_comes_from(self):
        self.assertEqual(map_sensors_for("ekf_wheel_trunks"), "odom,scan")
        self.assertEqual(map_sensors_for("pf_wheel_grid"), "odom,scan")
        self.assertEqual(map_sensors_for("graph_ceiling"), "odom,ceiling_camera")
        self.assertEqual(map_sensors_for("ekf_wheel"), "odom,camera")

    def test_a_product_that_there_is_not(self):
        with self.assertRaisesRegex(BenchError, "there is no product nothing"):
            map_sensors_for("nothing")


if __name__ == "__main__":
    unittest.main()
