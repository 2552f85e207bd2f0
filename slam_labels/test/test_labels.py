# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels while the map changes, and their file."""
import pathlib
import tempfile
import unittest

from slam_labels import file
from slam_labels.labels import Label, LabelError, Labels

MAP = {1: (0.0, 0.0), 2: (2.0, 0.0), 3: (2.5, 0.1)}


class WhileTheMapChanges(unittest.TestCase):
    def test_goes_with_the_id(self):
        labels = Labels([Label("door", 2)])
        self.assertEqual(labels.update({}), [])
        self.assertEqual(labels.of_map(), {})
        labels.update(MAP)
        labels.update({**MAP, 2: (7.0, 7.0)})  # the map was corrected
        self.assertEqual(labels.of_map(), {2: "door"})
        self.assertEqual(labels.all[0].place, (7.0, 7.0))

    def test_given_by_a_position_goes_to_the_nearest_landmark_within_the_radius(self):
        labels = Labels([Label("door", None, (2.1, 0.0)), Label("far", None, (9.0, 9.0))])
        self.assertEqual(labels.update(MAP), [])
        self.assertEqual(labels.of_map(), {2: "door"})
        labels.update({**MAP, 4: (9.5, 9.0)})  # seen later
        self.assertEqual(labels.of_map(), {2: "door", 4: "far"})

    def test_of_a_landmark_that_was_merged_goes_to_the_one_that_is_left(self):
        labels = Labels([Label("door", 2)])
        labels.update(MAP)
        self.assertEqual(labels.update({1: (0.0, 0.0), 3: (2.3, 0.0)}), [])
        self.assertEqual(labels.of_map(), {3: "door"})

    def test_of_a_landmark_that_was_removed_waits_for_it(self):
        labels = Labels([Label("door", 1)])
        labels.update(MAP)
        for landmarks in ({2: (2.0, 0.0)}, {}, {2: (2.0, 0.0)}):
            labels.update(landmarks)
            self.assertEqual(labels.of_map(), {})
        labels.update(MAP)
        self.assertEqual(labels.of_map(), {1: "door"})

    def test_says_where_a_landmark_would_have_two(self):
        labels = Labels([Label("door", 2), Label("gate", 3)])
        labels.update(MAP)
        said = labels.update({1: (0.0, 0.0), 3: (2.3, 0.0)})
        self.assertEqual(said, ["the label 'door' has no landmark: landmark 3, which is there, is "
                                "called 'gate'"])
        self.assertEqual(labels.of_map(), {3: "gate"})

    def test_says_where_an_id_may_be_that_of_another_landmark(self):
        labels = Labels([Label("door", 2, (9.0, 0.0)), Label("gate", 3, (2.6, 0.1))])
        self.assertEqual(labels.update(MAP), [
            "the label 'door' goes with landmark 2, which is 7.0 m from the label's last place: if "
            "this is another landmark, take the ids out of the file"])
        self.assertEqual(labels.of_map(), {2: "door", 3: "gate"})
        self.assertEqual(labels.update({**MAP, 3: (7.0, 7.0)}), [])  # the map was corrected

    def test_nearer_ones_come_first_whatever_the_order(self):
        first, second = Label("door", None, (2.2, 0.0)), Label("gate", None, (2.45, 0.1))
        for order in ([first, second], [second, first]):
            labels = Labels([Label(each.text, None, each.place) for each in order])
            labels.update(MAP)
            self.assertEqual(labels.of_map(), {2: "door", 3: "gate"})

    def test_can_be_given_and_taken_away(self):
        labels = Labels()
        labels.update(MAP)
        self.assertEqual(labels.give(3, " a  door ", MAP), "landmark 3 is called 'a door'")
        self.assertEqual(labels.give(3, "a door", MAP), "landmark 3 is called 'a door'")
        self.assertEqual(labels.of_map(), {3: "a door"})
        self.assertEqual(labels.give(3, "", MAP), "landmark 3 is no longer called 'a door'")
        self.assertEqual(labels.of_map(), {})

    def test_refuses_what_cannot_be_given(self):
        labels = Labels([Label("door", 2)])
        labels.update(MAP)
        for identity, text, sentence in (
                (9, "x", "there is no landmark 9 in the map; there are: 1, 2, 3"),
                (2, "gate", "landmark 2 is called 'door' already"),
                (1, "", "landmark 1 has no label")):
            with self.assertRaises(LabelError) as caught:
                labels.give(identity, text, MAP)
            self.assertIn(sentence, str(caught.exception))
        self.assertEqual(labels.of_map(), {2: "door"})


class File(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "map" / "labels.yaml"

    def refusal(self, text):
        self.path.parent.mkdir(exist_ok=True)
        self.path.write_text(text, encoding="utf-8")
        with self.assertRaises(LabelError) as caught:
            file.read(self.path)
        said = str(caught.exception)
        self.assertIn(str(self.path), said)
        self.assertNotIn("\n", said)
        return said

    def test_brings_back_what_was_saved(self):
        labels = [Label("Tür, groß", 2, (2.0, 0.5)), Label("seen never", 7),
                  Label("by place", None, (1.0, -1e-7))]
        file.write(self.path, labels)
        self.assertEqual(file.read(file.path_of(self.path.parent)), labels)
        self.assertEqual(file.path_of(self.path), self.path)
        self.assertEqual([path.name for path in self.path.parent.iterdir()], ["labels.yaml"])

    def test_refuses_other_keys(self):
        for text in ("version: 1", "[1]", "version: 1\nlandmarks: []\nmore: 1", "", "a: &a [*a]"):
            self.assertIn("the keys version and landmarks", self.refusal(text))
        self.assertIn("not lable", self.refusal("version: 1\nlandmarks: [{id: 1, lable: a}]"))
        self.assertIn("entry 2 has the keys", self.refusal(
            "version: 1\nlandmarks: [{id: 1, label: a}, 3]"))
        self.assertIn("reads version 1", self.refusal("version: 2\nlandmarks: []"))
        self.assertIn("no list", self.refusal("version: 1\nlandmarks: {a: 1}"))

    def test_refuses_two_labels_of_one_landmark(self):
        self.assertIn("landmark 1 has two labels, 'a' and 'b'", self.refusal(
            "version: 1\nlandmarks: [{id: 1, label: a}, {id: 1, label: b}]"))

    def test_refuses_what_is_no_label_and_no_landmark(self):
        for entry, sentence in (("{id: 1}", "has no label"), ("{id: 1, label: 5}", "has no label"),
                                ("{id: 1, label: ' '}", "has no label"),
                                ("{label: a}", "names no landmark"),
                                ("{label: a, x: 1}", "names no landmark"),
                                ("{id: 1.5, label: a}", "no whole number"),
                                ("{id: true, label: a}", "no whole number"),
                                ("{id: 9223372036854775808, label: a}", "no whole number"),
                                ("{x: .nan, y: 1, label: a}", "finite numbers"),
                                ("{x: a, y: 1, label: a}", "finite numbers"),
                                (f"{{x: 1{'0' * 400}, y: 1, label: a}}", "finite numbers"),
                                ("{id: 1, x: 1, label: a}", "finite numbers")):
            self.assertIn(sentence, self.refusal(f"version: 1\nlandmarks: [{entry}]"), entry)

    def test_refuses_what_cannot_be_read_or_written(self):
        for text in ("landmarks: [", "landmarks: 2024-13-45", "[" * 10000):
            self.assertIn("cannot be read", self.refusal(text))
        self.path.unlink()
        with self.assertRaisesRegex(LabelError, "no such file"):
            file.read(self.path)
        with self.assertRaisesRegex(LabelError, "no such file"):
            file.read(self.path.parent)
        with self.assertRaisesRegex(LabelError, "cannot write the labels to /proc/no"):
            file.write(pathlib.Path("/proc/no/labels.yaml"), [])


if __name__ == "__main__":
    unittest.main()
