# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relations between poses as the reference of a run."""
import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.geometry import se2  # noqa: E402
from slam_eval.io.errors import InputError  # noqa: E402
from slam_eval.io.relations import (  # noqa: E402
    read_relations, read_source_stamps, Relations, SourceStamps)
from slam_eval.io.trajectory import NANOSECONDS, read_trajectory, Trajectory  # noqa: E402
from slam_eval.metrics.relations import (  # noqa: E402
    means_one_scan, nearest_written, poses_at, relation_errors)
from slam_eval.report.cli import main  # noqa: E402


def seconds(values):
    """Stamps [s] as integers [ns]."""
    return np.array([round(value * NANOSECONDS) for value in values], dtype=np.int64)


class Files(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        """Write a file; its path."""
        (self.folder / name).write_text(text)
        return self.folder / name

    def fails(self, reader, path, *parts):
        """The reader refuses the file with one sentence that holds the parts."""
        with self.assertRaises(InputError) as caught:
            reader(path)
        for part in parts:
            self.assertIn(part, str(caught.exception))

    def test_reads_relations_exactly(self):
        relations = read_relations(self.write("a", "# comment\n976052905.167303 976052911.885496 "
                                              "1.5 -0.5 9 0.1 0.2 -1.68\n"))
        self.assertEqual(relations.stamps.tolist(), [[976052905167303000, 976052911885496000]])
        self.assertEqual(relations.deltas.tolist(), [[1.5, -0.5, -1.68]])

    def test_refuses_bad_relations(self):
        self.fails(read_relations, self.write("a", "1 2 3\n"), "a:1: 3 fields")
        self.fails(read_relations, self.write("a", "\n1 2 0 0 0 0 0 x\n"), "a:2:", "no number")
        self.fails(read_relations, self.write("a", "1 2 0 0 0 0 0 nan\n"), "not finite")
        self.fails(read_relations, self.write("a", "# nothing\n"), "holds no relation")
        self.fails(read_relations, self.write("a", ""), "empty")
        self.fails(read_relations, self.folder / "none", "no such file")

    def test_of_several_scans_of_one_stamp_the_last_counts(self):
        table = read_source_stamps(self.write(
            "a", "source_stamp,written_stamp\n2.0,2.0\n2.5,2.5\n2.0,2.5001\n"))
        self.assertEqual(table.source.tolist(), seconds([2.0, 2.5]).tolist())
        self.assertEqual(table.written.tolist(), seconds([2.5001, 2.5]).tolist())

    def test_refuses_bad_tables_of_stamps(self):
        header = "source_stamp,written_stamp\n"
        self.fails(read_source_stamps, self.write("a", header), "holds no stamps")
        self.fails(read_source_stamps, self.write("a", header + "1,2,3\n"), "a:2: 3 fields")
        self.fails(read_source_stamps, self.write("a", header + "1,b\n"), "a:2:", "no number")

    def test_takes_the_nearest_scan_within_the_rounding_of_the_log(self):
        table = read_source_stamps(self.write("a", "1.00,1\n1.02,2\n2.00,3\n"))
        written, valid = nearest_written(table, seconds([0.995, 1.012, 1.03, 1.031, 1.9, 2.009]))
        self.assertEqual(valid.tolist(), [True, True, True, False, False, True])
        self.assertEqual(written[valid].tolist(), seconds([1, 2, 2, 3]).tolist())


    def test_a_stamp_is_ambiguous_where_several_scans_or_none_are_near(self):
        table = read_source_stamps(self.write("a", "1.00,1\n1.015,2\n2.00,3\n3.00,4\n3.00,5\n"))
        self.assertEqual(means_one_scan(table, seconds([1.0, 1.007, 2.01, 2.011, 3.0])).tolist(),
                         [True, False, True, False, False])


class Errors(unittest.TestCase):

    def setUp(self):
        self.poses = run_maker.ring(count=50)
        self.stamps = seconds(100.0 + 0.2 * np.arange(50))
        self.final = Trajectory(self.stamps, self.poses)

    def relation(self, i, j, offset=(0.0, 0.0, 0.0)):
        """The true relation between two poses, with an error in the frame of its end."""
        delta = se2.compose(se2.compose(se2.inverse(self.poses[i]), self.poses[j]), offset)
        return Relations(self.stamps[[[i, j]]], np.array([delta]))

    def test_are_zero_for_the_truth_and_known_for_a_known_offset(self):
        errors = relation_errors(self.relation(3, 40), self.final, None)
        self.assertAlmostEqual(errors.translation[0], 0.0)
        self.assertAlmostEqual(errors.rotation[0], 0.0)
        errors = relation_errors(self.relation(40, 3, (0.3, -0.4, -0.1)), self.final, None)
        self.assertAlmostEqual(errors.translation[0], 0.5)
        self.assertAlmostEqual(errors.rotation[0], 0.1)

    def test_do_not_depend_on_the_frame_of_the_map(self):
        moved = Trajectory(self.stamps, se2.transform_poses([5.0, -3.0, 2.5], self.poses))
        errors = relation_errors(self.relation(3, 40), moved, None)
        self.assertAlmostEqual(errors.translation[0], 0.0)
        self.assertAlmostEqual(errors.rotation[0], 0.0)

    def test_compose_odometry_between_the_poses_of_the_trajectory(self):
        every_fifth = Trajectory(self.stamps[::5], self.poses[::5])
        drifted = Trajectory(self.stamps, se2.transform_poses([9.0, 1.0, -1.0], self.poses))
        errors = relation_errors(self.relation(3, 42), every_fifth, drifted)
        self.assertAlmostEqual(errors.translation[0], 0.0)
        self.assertAlmostEqual(errors.rotation[0], 0.0)
        self.assertIsNone(relation_errors(self.relation(3, 42), every_fifth, None))

    def test_tell_unambiguous_relations_and_revisits_apart(self):
        pairs = np.array([[0, 10], [10, 20], [20, 0]])
        deltas = [se2.compose(self.relation(i, j).deltas[0], (0.1 * n, 0.0, 0.0))
                  for n, (i, j) in enumerate(pairs, start=1)]
        table = SourceStamps(self.stamps, self.stamps, 1 + (np.arange(50) == 20))
        metrics = relation_errors(Relations(self.stamps[pairs], np.array(deltas)), self.final, None,
                                  table).metrics
        self.assertEqual((metrics["relations_unambiguous"], metrics["relations_revisit"]), (1, 1))
        self.assertAlmostEqual(metrics["relations_unambiguous_trans_mean_m"], 0.1)
        self.assertAlmostEqual(metrics["relations_revisit_trans_mean_m"], 0.3)
        self.assertAlmostEqual(metrics["relations_revisit_rot_mean_deg"], 0.0)
        metrics = relation_errors(self.relation(3, 4), self.final, None).metrics
        self.assertEqual(metrics["relations_revisit"], 0)
        self.assertNotIn("relations_revisit_trans_mean_m", metrics)

    def test_have_no_pose_before_the_first(self):
        late = Trajectory(self.stamps[10:], self.poses[10:])
        _, valid = poses_at(late, self.final, self.stamps[8:12])
        self.assertEqual(valid.tolist(), [False, False, True, True])
        relations = Relations(self.stamps[[[3, 40], [12, 40]]], np.zeros((2, 3)))
        errors = relation_errors(relations, late, None)
        self.assertEqual((len(errors.translation), errors.missing), (1, 1))


class SlamEval(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.run_folder = pathlib.Path(folder.name) / "run"
        run_maker.make_run(self.run_folder, count=120, truth=False)
        text = (self.run_folder / "trajectory.tum").read_text()
        (self.run_folder / "trajectory_final.tum").write_text(text)
        self.relations = self.run_folder.parent / "a.relations"
        self.final = read_trajectory(self.run_folder / "trajectory_final.tum")

    def write_relations(self, shift=0.0, others=0):
        """A relation for every tenth pose, 0.1 m off, and some of another time."""
        lines = []
        for i in range(0, 100, 10):
            delta = se2.compose(se2.inverse(self.final.poses[i]), self.final.poses[i + 10])
            start, end = self.final.stamps[[i, i + 10]] / NANOSECONDS + shift
            lines.append("%.6f %.6f %.9f %.9f 0 0 0 %.9f"
                         % (start, end, delta[0] + 0.1, delta[1], delta[2]))
        lines += ["5.0 6.0 0 0 0 0 0 0"] * others
        self.relations.write_text("\n".join(lines) + "\n")

    def evaluate(self, *arguments):
        """Run the program; exit code, output and errors."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                code = main([str(self.run_folder), *map(str, arguments)])
            except SystemExit as wrong_use:
                code = wrong_use.code
        return code, out.getvalue(), err.getvalue()

    def test_adds_figures_table_and_histogram(self):
        self.write_relations(others=2)
        code, out, err = self.evaluate("--relations", self.relations)
        self.assertEqual(code, 0, err)
        metrics = json.loads((self.run_folder / "metrics.json").read_text())
        self.assertEqual(metrics["relations"], 10)
        self.assertAlmostEqual(metrics["relations_trans_mean_m"], 0.1, places=6)
        self.assertAlmostEqual(metrics["relations_trans_std_m"], 0.0, places=6)
        self.assertAlmostEqual(metrics["relations_rot_mean_deg"], 0.0, places=6)
        self.assertIn("2 of 12 relations were left out", out)
        self.assertTrue((self.run_folder / "relations.png").exists())
        report = (self.run_folder / "report.html").read_text()
        self.assertIn("10 used, 2 left out", report)
        self.assertIn("Errors of the relations", report)
        self.evaluate()
        self.assertNotIn("relations", (self.run_folder / "metrics.json").read_text())

    def test_finds_the_stamps_of_the_log_beside_the_run(self):
        self.write_relations(shift=1000.0)
        self.assertEqual(self.evaluate("--relations", self.relations)[0], 1)
        table = "".join("%.6f,%.6f\n" % (t / NANOSECONDS + 1000.0, t / NANOSECONDS)
                        for t in self.final.stamps)
        (self.run_folder / "stamps.csv").write_text(table)
        self.assertEqual(self.evaluate("--relations", self.relations)[0], 0)
        (self.run_folder / "stamps.csv").rename(self.run_folder.parent / "elsewhere.csv")
        elsewhere = self.run_folder.parent / "elsewhere.csv"
        code, _, err = self.evaluate("--relations", self.relations, "--stamps", elsewhere)
        self.assertEqual(code, 0, err)

    def test_the_tolerance_of_stamps_can_be_set(self):
        self.write_relations(shift=0.03)
        self.assertEqual(self.evaluate("--relations", self.relations)[0], 1)
        code, out, err = self.evaluate("--relations", self.relations, "--tolerance", "0.04")
        self.assertEqual(code, 0, err)
        for wrong in ("0", "-1", "nan", "11", "much"):
            code, _, err = self.evaluate("--relations", self.relations, "--tolerance", wrong)
            self.assertEqual(code, 2)
            self.assertIn("--tolerance", err)
        self.assertEqual(self.evaluate("--tolerance", "0.04")[0], 2)

    def test_names_the_tolerance_that_takes_stamps_which_are_a_little_off(self):
        self.write_relations(shift=1000.03)
        table = "".join("%.6f,%.6f\n" % (t / NANOSECONDS + 1000.0, t / NANOSECONDS)
                        for t in self.final.stamps)
        (self.run_folder / "stamps.csv").write_text(table)
        code, _, err = self.evaluate("--relations", self.relations)
        self.assertEqual(code, 1)
        self.assertIn("stamped up to 0.03 s apart: --tolerance 0.1 takes them", err)
        self.assertEqual(self.evaluate("--relations", self.relations, "--tolerance", "0.1")[0], 0)

    def test_refuses_relations_of_another_log(self):
        self.write_relations(shift=500.0)
        code, _, err = self.evaluate("--relations", self.relations)
        self.assertEqual(code, 1)
        self.assertIn("poses for none of its 10 relations", err)
        self.assertIn("--stamps", err)
        self.assertEqual(err.count("\n"), 1)
        self.assertEqual(self.evaluate("--stamps", self.relations)[0], 2)
        (self.run_folder / "trajectory_final.tum").unlink()
        self.assertIn("trajectory_final.tum", self.evaluate("--relations", self.relations)[2])


if __name__ == "__main__":
    unittest.main()
