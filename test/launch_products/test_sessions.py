# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A run that stops half way and goes on with the rest of the bag, one that localises there, and two
that become one."""

import math
import pathlib
import subprocess
import tempfile
import unittest

import rosbag
import rospy

from launching import program

SECONDS = 30  # of the office
LATCHED = ("/tf_static", "/robot")


def split(bag, first, second):
    """Writes the halves of a bag; what is latched stands in both."""
    with rosbag.Bag(bag) as whole, rosbag.Bag(first, "w") as before, \
            rosbag.Bag(second, "w") as after:
        start, end = whole.get_start_time(), whole.get_end_time()
        middle = rospy.Time.from_sec((start + end) / 2)
        for topic, message, stamp, header in whole.read_messages(return_connection_header=True):
            if topic in LATCHED or topic.endswith("camera_info") and stamp < middle:
                after.write(topic, message, max(stamp, middle), connection_header=header)
            half = before if stamp < middle else after
            if half is before or topic not in LATCHED:
                half.write(topic, message, stamp, connection_header=header)


def positions(run):
    """Returns the positions of the path as known at the end, by stamp."""
    lines = (run / "trajectory_final.tum").read_text(encoding="ascii").splitlines()
    return {line.split()[0]: tuple(map(float, line.split()[1:3])) for line in lines}


def furthest(run, other):
    """Returns the largest distance between two paths at stamps that they have in common."""
    ours, theirs = positions(run), positions(other)
    common = ours.keys() & theirs.keys()
    assert len(common) > 5 * SECONDS / 2, f"only {len(common)} stamps in common"
    return max(math.dist(ours[stamp], theirs[stamp]) for stamp in common)


class SessionsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)
        cls.bag, cls.first, cls.second = (cls.root / f"{name}.bag"
                                          for name in ("office", "first", "second"))
        subprocess.run([program("slam_sim", "slam_sim"), cls.bag, "--duration", str(SECONDS)],
                       check=True, stdout=subprocess.DEVNULL)
        split(cls.bag, cls.first, cls.second)
        for product in ("graph_wheel", "graph_wheel_grid"):
            cls.run_on(product, cls.first, "first", "--save-session", cls.session(product))

    @classmethod
    def session(cls, product):
        return cls.root / f"{product}.session"

    @classmethod
    def run_on(cls, product, bag, name, *options):
        """Runs a product on a bag; returns the folder of the run and what was said."""
        run = cls.root / f"{product}_{name}"
        done = subprocess.run([program("slam_ros", "slam_run"), product, "--bag", bag,
                               "--out", run, *options], check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        assert done.returncode == 0, done.stdout
        return run, done.stdout

    def refusal(self, product, *options):
        done = subprocess.run([program("slam_ros", "slam_run"), product, "--bag", self.second,
                               "--out", self.root / "refused", *options], check=False, text=True,
                              stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
        self.assertNotEqual(done.returncode, 0)
        self.assertFalse((self.root / "refused").exists())
        return done.stderr

    def test_the_second_half_leads_where_the_whole_leads(self):
        for product in ("graph_wheel", "graph_wheel_grid"):
            with self.subTest(product):
                whole, _ = self.run_on(product, self.bag, "whole")
                session = self.session(product)
                second, said = self.run_on(product, self.second, "second",
                                           "--load-session", session)
                self.assertNotIn("warning", said)
                self.assertLess(furthest(second, whole), 0.03)
                again, _ = self.run_on(product, self.second, "again", "--load-session", session)
                self.assertEqual((again / "trajectory_final.tum").read_bytes(),
                                 (second / "trajectory_final.tum").read_bytes())

    def test_localises_in_a_session(self):
        for product in ("graph_wheel", "graph_wheel_grid"):
            with self.subTest(product):
                whole, _ = self.run_on(product, self.bag, "whole")
                run, _ = self.run_on(product, self.second, "localised", "--load-session",
                                     self.session(product), "--set", "graph.mode=localization")
                self.assertLess(furthest(run, whole), 0.1)

    def merge(self, *arguments):
        return subprocess.run([program("slam_ros", "slam_merge"), *arguments], check=False,
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def test_two_drives_become_one_map(self):
        session = self.session("graph_wheel")
        drive, both = self.root / "drive.session", self.root / "both.session"
        self.run_on("graph_wheel", self.bag, "drive", "--save-session", drive)
        done = self.merge(session, drive, "--out", both)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"recognised by ([3-9]|\d\d) landmarks")
        self.run_on("graph_wheel", self.second, "after", "--load-session", both)
        run, _ = self.run_on("graph_wheel", self.bag, "merging", "--merge-session", session)
        self.assertIn(",merged,", (run / "events.csv").read_text(encoding="utf-8"))

    def test_sessions_that_cannot_be_merged_are_refused(self):
        session, both = self.session("graph_wheel"), self.root / "none.session"
        for other, sentence in ((self.session("graph_wheel_grid"), "one session has a grid"),
                                ("/no/such", "/no/such")):
            done = self.merge(session, other, "--out", both)
            self.assertEqual(done.returncode, 1)
            self.assertIn(sentence, done.stderr)
        self.assertEqual(self.merge(session, "--out", both).returncode, 2)
        self.assertFalse(both.exists())
        self.assertIn("merges no sessions",
                      self.refusal("ekf_wheel", "--merge-session", session))

    def test_what_cannot_be_used_is_refused_before_anything_is_written(self):
        session = self.session("graph_wheel")
        self.assertIn("it has no grid and this product makes one",
                      self.refusal("graph_wheel_grid", "--load-session", session))
        self.assertIn("grid_map.resolution is 0.1 m",
                      self.refusal("graph_wheel_grid", "--load-session",
                                   self.session("graph_wheel_grid"), "--set",
                                   "grid_map.resolution=0.1"))
        self.assertIn("keeps no session", self.refusal("ekf_wheel", "--load-session", session))
        self.assertIn("keeps no session",
                      self.refusal("ekf_wheel", "--save-session", self.root / "x"))
        self.assertIn("not both", self.refusal("graph_wheel", "--load-session", session,
                                               "--load-map", session))
        damaged = self.root / "damaged.session"
        damaged.write_bytes(session.read_bytes()[:-1])
        self.assertIn("damaged.session: it is cut",
                      self.refusal("graph_wheel", "--load-session", damaged))
        self.assertIn("cannot write /proc/x",
                      self.refusal("graph_wheel", "--save-session", "/proc/x"))
        self.assertIn("nothing is added to a session",
                      self.refusal("graph_wheel", "--load-session", session, "--save-session",
                                   self.root / "x", "--set", "graph.mode=localization"))


if __name__ == "__main__":
    unittest.main()
