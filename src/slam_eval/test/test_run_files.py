# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading landmark maps, updates and whole run folders."""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.io.errors import InputError  # noqa: E402
from slam_eval.io.events import read_events  # noqa: E402
from slam_eval.io.graph import read_graph  # noqa: E402
from slam_eval.io.landmarks import read_labels, read_landmarks  # noqa: E402
from slam_eval.io.run_folder import read_run  # noqa: E402
from slam_eval.io.updates import read_updates  # noqa: E402

MAP = run_maker.landmark_lines([7, 3], [[1.0, 2.0], [-3.0, 0.5]],
                               np.array([[[1e-4, 2e-5], [2e-5, 3e-4]]] * 2), [0.1, 0.2, 0.3])


class InFolder(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refused(self, reader, name, text, *parts):
        """The reader refuses a file of this text with a sentence that holds the parts."""
        path = self.folder / name
        path.write_text(text)
        with self.assertRaises(InputError) as caught:
            reader(path)
        self.assertEqual(str(caught.exception).count("\n"), 0)
        for part in (name,) + parts:
            self.assertIn(part, str(caught.exception))


class ReadLandmarks(InFolder):

    def refuses(self, text, *parts):
        self.refused(read_landmarks, "landmarks.yaml", text, *parts)

    def test_reads_ids_positions_covariances_and_pose(self):
        (self.folder / "map.yaml").write_text(MAP)
        found = read_landmarks(self.folder / "map.yaml")
        self.assertEqual(found.ids, [7, 3])
        np.testing.assert_allclose(found.positions, [[1.0, 2.0], [-3.0, 0.5]])
        np.testing.assert_allclose(found.covariances[1], [[1e-4, 2e-5], [2e-5, 3e-4]])
        np.testing.assert_allclose(found.pose, [0.1, 0.2, 0.3])

    def test_reads_labels_of_landmarks_with_an_id(self):
        path = self.folder / "labels.yaml"
        path.write_text("version: 1\nlandmarks:\n- {id: 3, x: 1.0, y: 2.0, label: door}\n"
                        "- {x: 1.0, y: 2.0, label: waits}\n")
        self.assertEqual(read_labels(path), {3: "door"})
        for text in ("landmarks: 3", "landmarks: [3]", "landmarks: [{id: a, label: b}]",
                     "landmarks: [{id: 1}]", "landmarks: ["):
            self.refused(read_labels, "labels.yaml", text, "no labels as slam_labels saves them")

    def test_reads_lines_beside_points(self):
        line = ("  - {id: 9, x: 1.0, y: 2.0, covariance: [1e-4, 0, 0, 1e-4], kind: line, "
                "direction: 1.5707963267948966, begin: -3.0, end: 1.0}\n")
        text = MAP.replace("landmarks:\n", "landmarks:\n" + line)
        self.assertIn(line, text)
        (self.folder / "map.yaml").write_text(text)
        found = read_landmarks(self.folder / "map.yaml")
        self.assertEqual(found.ids, [7, 3])
        self.assertEqual(len(found), 3)
        np.testing.assert_allclose(found.lines, [[[4.0, 2.0], [0.0, 2.0]]], atol=1e-12)
        self.refuses(text.replace("end: 1.0", "end: far"), "landmark 9: end", "finite number")

    def test_leaves_the_joint_covariance_out_wherever_it_stands(self):
        joint = "joint_covariance: # lower triangle\n  [1.0,\n   2.0, 3.0]\n"
        block = "joint_covariance:\n- 1.0\n- 2.0\n"
        for text in (MAP + joint, MAP + block, MAP.replace("landmarks:", joint + "landmarks:"),
                     MAP.rstrip("\n") + "\njoint_covariance: [1.0, 2.0]"):
            (self.folder / "map.yaml").write_text(text)
            self.assertEqual(read_landmarks(self.folder / "map.yaml").ids, [7, 3])

    def test_reads_numbers_that_yaml_takes_for_text(self):
        (self.folder / "map.yaml").write_text(
            "version: 1\nlandmarks:\n"
            "  - {id: 1, x: 1e-05, y: -2E+03, covariance: [1e-6, 0, 0, 1]}\n")
        found = read_landmarks(self.folder / "map.yaml")
        np.testing.assert_allclose(found.positions, [[1e-5, -2000.0]])

    def test_an_empty_map_is_a_map(self):
        (self.folder / "map.yaml").write_text("version: 1\nlandmarks: []\n")
        self.assertEqual(len(read_landmarks(self.folder / "map.yaml")), 0)

    def test_refuses_an_empty_file(self):
        self.refuses("", "empty")

    def test_refuses_a_file_that_is_cut_off_and_names_the_line(self):
        self.refuses(MAP[:-30], "landmarks.yaml:", "cut off")

    def test_refuses_another_version(self):
        self.refuses(MAP.replace("version: 1", "version: 2"), "version is 2")

    def test_refuses_nan(self):
        self.refuses(MAP.replace("x: -3.000000000", "x: .nan"), "landmark 3", "finite")

    def test_refuses_a_missing_coordinate_and_a_short_covariance(self):
        self.refuses(MAP.replace("x: -3.000000000, ", ""), "landmark 3")
        self.refuses("version: 1\nlandmarks:\n  - {id: 1, x: 0, y: 0, covariance: [1, 0]}\n",
                     "landmark 1", "covariance")

    def test_refuses_an_id_twice_and_an_id_that_is_no_number(self):
        self.refuses(MAP.replace("id: 3", "id: 7"), "landmark 7", "twice")
        self.refuses(MAP.replace("id: 3", "id: door"), "id")

    def test_refuses_something_else(self):
        self.refuses("just words\n", "no landmark map")
        self.refuses("version: 1\nframe: map\n", "landmarks")


class ReadUpdates(InFolder):

    def setUp(self):
        super().setUp()
        self.text = run_maker.update_lines([1.0, 2.0], np.array([np.diag([1.0, 2.0, 3.0])] * 2),
                                           [3.5, 0.0], [4, 0], 6)

    def refuses(self, text, *parts):
        self.refused(read_updates, "updates.csv", text, *parts)

    def test_reads_covariances_and_nis(self):
        (self.folder / "updates.csv").write_text(self.text)
        found = read_updates(self.folder / "updates.csv")
        np.testing.assert_allclose(found.covariances[1], np.diag([1.0, 2.0, 3.0]))
        self.assertEqual(found.nis.tolist(), [3.5, 0.0])
        self.assertEqual(found.nis_dof.tolist(), [4, 0])
        self.assertEqual(found.counts["landmarks"].tolist(), [6, 6])

    def test_refuses_a_wrong_header_a_cut_line_nan_and_emptiness(self):
        self.refuses(self.text.replace("nis_dof", "dof"), ":1:", "header")
        self.refuses(self.text[:-14], ":3:", "8 fields where 14 belong")
        self.refuses(self.text.replace("3.5", "nan"), ":2:", "not finite")
        self.refuses(self.text.replace("3.5", "x"), ":2:", "no number")
        self.refuses("", "empty")
        self.refuses(self.text.splitlines()[0] + "\n", "no update")


class ReadEvents(InFolder):

    def refuses(self, text, *parts):
        self.refused(read_events, "events.csv", text, *parts)

    def test_reads_kinds_sizes_and_reasons(self):
        (self.folder / "events.csv").write_text(run_maker.EVENTS)
        jump, loop = read_events(self.folder / "events.csv")
        self.assertEqual((jump.kind, jump.stamp, jump.reason),
                         ("jump", 1001500000000, "the robot was put there"))
        self.assertEqual((loop.kind, loop.distance, loop.reason),
                         ("loop_closed", 0.3, "1 loop newly believed, 0 loops taken back"))

    def test_reads_that_nothing_happened(self):
        (self.folder / "events.csv").write_text(run_maker.EVENTS.splitlines()[0] + "\n")
        self.assertEqual(read_events(self.folder / "events.csv"), [])

    def test_refuses_a_wrong_header_a_cut_line_and_what_is_no_number(self):
        self.refuses(run_maker.EVENTS.replace("turn", "angle"), ":1:", "header")
        self.refuses(run_maker.EVENTS.replace('0.200000,"the robot was put there"', "0.2"), ":2:",
                     "4 fields where 5 belong")
        self.refuses(run_maker.EVENTS.replace("0.300000", "x"), ":3:", "no number")
        self.refuses(run_maker.EVENTS.replace("0.300000", "nan"), ":3:", "not finite")
        self.refuses("", "empty")


class ReadGraph(InFolder):

    def refuses(self, text, *parts):
        self.refused(read_graph, "graph.csv", text, *parts)

    def test_reads_places_edges_and_weights(self):
        (self.folder / "graph.csv").write_text(run_maker.GRAPH)
        found = read_graph(self.folder / "graph.csv")
        np.testing.assert_allclose(found.places["node"], [[0, 0], [1, 0], [1, 1]])
        np.testing.assert_allclose(found.edges["loop"], [[[0, 0], [1, 1]]])
        self.assertEqual(found.weights["loop"].tolist(), [0.5])
        self.assertEqual(len(found.edges["sighting"]), 0)

    def test_refuses_a_wrong_header_a_cut_line_unknown_kinds_and_what_is_no_number(self):
        self.refuses(run_maker.GRAPH.replace("weight", "w"), ":1:", "header")
        self.refuses(run_maker.GRAPH + "loop,1,2\n", ":9:", "3 fields where 6 belong")
        self.refuses(run_maker.GRAPH.replace("submap", "chart"), ":5:", '"chart" is none of')
        self.refuses(run_maker.GRAPH.replace("0.5000", "half"), ":8:", "no number")
        self.refuses(run_maker.GRAPH.replace("0.5000", "inf"), ":8:", "not finite")
        self.refuses("", "empty")


class ReadRun(InFolder):

    def refuses(self, *parts):
        with self.assertRaises(InputError) as caught:
            read_run(self.folder)
        for part in parts:
            self.assertIn(part, str(caught.exception))

    def test_reads_a_whole_run(self):
        run_maker.make_run(self.folder, count=60)
        run = read_run(self.folder)
        self.assertEqual(run.title, "ekf_wheel on ring")
        self.assertEqual(len(run.updates), 60)
        self.assertEqual(len(run.true_landmarks), 18)

    def test_compares_spots_of_the_ceiling_with_no_landmarks(self):
        run_maker.make_run(self.folder, count=60)
        with open(self.folder / "config.yaml", "a", encoding="utf-8") as config:
            config.write("detector: ceiling_features\n")
        self.assertIsNone(read_run(self.folder).true_landmarks)

    def test_refuses_a_folder_that_is_not_there(self):
        with self.assertRaisesRegex(InputError, "no such folder"):
            read_run(self.folder / "nowhere")

    def test_refuses_a_folder_without_trajectory(self):
        self.refuses("trajectory.tum", "no folder of a run")

    def test_refuses_updates_of_another_run(self):
        run_maker.make_run(self.folder, count=60)
        lines = (self.folder / "updates.csv").read_text().splitlines(keepends=True)
        (self.folder / "updates.csv").write_text("".join(lines[:-1]))
        self.refuses("updates.csv", "59 lines against 60")

    def test_refuses_broken_metrics_and_configuration(self):
        run_maker.make_run(self.folder, count=60)
        (self.folder / "metrics.json").write_text('{"cpu_s": 1')
        self.refuses("metrics.json:1", "JSON")
        (self.folder / "metrics.json").write_text("{}")
        (self.folder / "config.yaml").write_text("ekf: [1\n")
        self.refuses("config.yaml", "YAML")


if __name__ == "__main__":
    unittest.main()
