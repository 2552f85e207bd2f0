# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What associations.csv holds, and how it is judged."""
import pathlib
import tempfile
import unittest

from slam_eval.io.associations import Associated, read_associations
from slam_eval.io.errors import InputError
from slam_eval.metrics.association import as_revised, judge

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

    def test_two_observations_without_ids_cannot_be_judged(self):
        a = judge(rows((-1, "new", 0), (-1, "landmark", 0), (7, "landmark", 0)))
        self.assertEqual((a.unjudged, a.wrong, a.right), (1, 1, 0))

    def test_a_second_landmark_of_an_id_and_one_of_none_are_ghosts(self):
        all_of_them = rows((7, "new", 0), (7, "new", 1), (-1, "new", 2), (8, "new", 3))
        self.assertEqual(judge(all_of_them).ghosts, 2)
        self.assertEqual(judge(all_of_them, final_ids={0, 1, 3}).ghosts, 1)

    def test_only_what_comes_before_a_stamp_is_judged(self):
        self.assertEqual(judge(rows((7, "new", 0), (7, "landmark", 0), (8, "landmark", 0)),
                               before=2).wrong, 0)


class RevisedTest(unittest.TestCase):
    FIRST = [Associated(1, 7, "new", 0), Associated(2, 7, "landmark", 0),
             Associated(2, 8, "ambiguous", -1), Associated(5, 7, "landmark", 0)]

    def test_what_is_decided_later_replaces_what_was_left_out(self):
        later = Associated(2, 8, "landmark", 3)
        self.assertEqual(as_revised(self.FIRST + [later]),
                         [*self.FIRST[:2], later, self.FIRST[3]])

    def test_what_is_taken_back_is_no_pairing_and_may_become_one_again(self):
        back = Associated(2, 7, "taken_back", 0)
        self.assertEqual(as_revised(self.FIRST + [back]),
                         [self.FIRST[0], back, *self.FIRST[2:]])
        again = Associated(2, 7, "landmark", 3)
        self.assertEqual(as_revised(self.FIRST + [back, again])[1], again)

    def test_what_is_decided_later_may_be_of_a_landmark_that_is_mapped_later(self):
        decided = [Associated(1, 7, "landmark", 0), Associated(2, 7, "new", 0)]
        self.assertEqual((judge(decided).right, judge(decided).wrong), (1, 0))

    def test_another_landmark_of_the_same_stamp_is_not_taken_back(self):
        back = Associated(2, 7, "taken_back", 4)
        self.assertEqual(as_revised(self.FIRST + [back]), self.FIRST)

    def test_rows_without_a_revision_stay(self):
        self.assertEqual(as_revised(self.FIRST), self.FIRST)


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
