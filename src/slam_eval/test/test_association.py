# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What associations.csv holds, and how it is judged."""
import pathlib
import tempfile
import unittest

from slam_eval.io.associations import Associated, read_associations
from slam_eval.io.errors import InputError
from slam_eval.metrics.association import judge

HEADER = "stamp,own_id,taken_for,landmark\n"


def rows(*values):
    return [Associated(stamp, *value) for stamp, value in enumerate(values)]


class JudgeTest(unittest.TestCase):
    def test_pairings_with_the_landmark_of_the_id_are_right(self):
        a = judge(rows((7, "new", 0), (7, "landmark", 0), (8, "landmark", 0), (7, "ambiguous", -1)))
        self.assertEqual((a.paired, a.right, a.wrong, a.observations), (2, 1, 1, 2))
        self.assertEqual((a.precision, a.recall, a.wrong_rows), (0.5, 0.5, (2,)))

    def test_what_is_not_mapped_yet_cannot_be_recalled(self):
        a = judge(rows((7, "on_trial", -1), (7, "on_trial", -1), (7, "new", 0)))
        self.assertEqual((a.observations, a.recall, a.precision), (0, None, None))

    def test_clutter_that_is_paired_is_wrong(self):
        a = judge(rows((7, "new", 0), (-1, "landmark", 0)))
        self.assertEqual((a.wrong, a.observations), (1, 0))

    def test_a_second_landmark_of_an_id_and_one_of_none_are_ghosts(self):
        all_of_them = rows((7, "new", 0), (7, "new", 1), (-1, "new", 2), (8, "new", 3))
        self.assertEqual(judge(all_of_them).ghosts, 2)
        self.assertEqual(judge(all_of_them, final_ids={0, 1, 3}).ghosts, 1)

    def test_only_what_comes_before_a_stamp_is_judged(self):
        self.assertEqual(judge(rows((7, "new", 0), (7, "landmark", 0), (8, "landmark", 0)),
                               before=2).wrong, 0)


class ReadTest(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "associations.csv"
            path.write_text(text, encoding="utf-8")
            return read_associations(path)

    def test_reads_what_a_run_writes(self):
        self.assertEqual(self.read(HEADER + "12.000000003,-1,new,4\n"),
                         [Associated(12 * 10**9 + 3, -1, "new", 4)])

    def test_names_the_line_that_is_cut_off(self):
        with self.assertRaisesRegex(InputError, ":3: not 4 values"):
            self.read(HEADER + "12.0,1,new,4\n12.1,1")

    def test_another_header_is_told(self):
        with self.assertRaisesRegex(InputError, "the header is not"):
            self.read("stamp,id\n")


if __name__ == "__main__":
    unittest.main()
