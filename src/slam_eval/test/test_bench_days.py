# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the benchmark days makes of the hours of a run, and that its program writes them."""
import pathlib
import subprocess
import tempfile
import unittest

from slam_eval.bench import days
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import package_folder, workspace_program


def hours(resident, checkpoint=lambda hour: 1.0, count=24):
    """Rows of a run."""
    return [{"hour": float(hour), "resident_mb": resident(hour),
             "checkpoint_mb": checkpoint(hour), "steps": 10.0 * hour, "cpu_s": 1.0}
            for hour in range(1, count + 1)]


class Growth(unittest.TestCase):

    def test_what_grows_before_the_map_is_made_does_not_count(self):
        rows = hours(lambda hour: 50.0 if hour >= days.SETTLED else 10.0 * hour)
        self.assertAlmostEqual(days.slope(rows, "resident_mb"), 0.0)

    def test_what_grows_beyond_the_map_misses_the_goal(self):
        line, is_reached = days.row_of("x", hours(lambda hour: 50.0 + 1.5 * hour))
        self.assertFalse(is_reached)
        self.assertEqual(line[-2:], ["1.500", "MISSED"])

    def test_what_the_map_grows_by_does_not_count(self):
        _, is_reached = days.row_of("x", hours(lambda hour: 50.0 + 1.5 * hour,
                                               lambda hour: 1.0 + hour))
        self.assertTrue(is_reached)

    def test_a_map_that_shrinks_excuses_nothing_and_accuses_of_nothing(self):
        _, is_reached = days.row_of("x", hours(lambda hour: 50.0 + 0.9 * hour,
                                               lambda hour: 30.0 - hour))
        self.assertTrue(is_reached)

    def test_too_few_hours_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "hours.csv"
            path.write_text("hour,resident_mb\n1,2\n", encoding="utf-8")
            with self.assertRaisesRegex(BenchError, "has 1 hours; more than 3 are needed"):
                days.read_hours(path)


class Program(unittest.TestCase):

    def _run(self, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            return subprocess.run(
                [workspace_program("slam_eval", "slam_eval_days"), *arguments, "--out",
                 f"{folder}/run"], capture_output=True, text=True, check=False)

    def test_prints_a_line_for_each_hour(self):
        product = package_folder("slam_launch") / "products/ekf_wheel.yaml"
        run = self._run(product, "--hours", "2", "--interval", "4")
        self.assertEqual(run.returncode, 0, run.stderr)
        lines = run.stdout.splitlines()
        self.assertEqual(lines[0], "hour,resident_mb,checkpoint_mb,steps,cpu_s")
        self.assertEqual([line.split(",")[0] for line in lines[1:]], ["1", "2"])
        self.assertEqual(lines[2].split(",")[3], "1800", "a step for each message")

    def test_refuses_a_product_that_needs_other_sensors(self):
        product = package_folder("slam_launch") / "products/ekf_wheel_pointmap.yaml"
        run = self._run(product, "--hours", "2", "--interval", "4")
        self.assertEqual(run.returncode, 1)
        self.assertIn("it needs other sensors", run.stderr)

    def test_refuses_wrong_use(self):
        self.assertEqual(self._run("/no/product.yaml").returncode, 2)
        product = package_folder("slam_launch") / "products/ekf_wheel.yaml"
        run = self._run(product, "--set", "product.seed=x")
        self.assertNotEqual(run.returncode, 0)
        self.assertTrue(run.stderr)


if __name__ == "__main__":
    unittest.main()
