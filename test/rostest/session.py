#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The services that save a session of the graph and go on from it, in either composition."""

import os
import pathlib
import sys
import tempfile
import time
import unittest

import rospy
import rostest
from slam_msgs.srv import LoadMap, SaveMap
from std_srvs.srv import Trigger
from player import Player, wait_for


class SessionTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.player = Player()
        cls.player.begin(40)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "a.session"

    def call(self, service, kind, *arguments):
        return rospy.ServiceProxy(service, kind)(*map(str, arguments))

    def save(self, path):
        answer = self.call("save_session", SaveMap, path)
        self.assertTrue(answer.success, answer.message)
        self.assertIn(str(path), answer.message)
        return path.read_bytes()

    def save_when_quiet(self):
        """Saves until nothing has changed for a second: what the test before has played may still
        be on its way."""
        saved = [self.save(self.path)]

        def is_quiet():
            time.sleep(1)
            saved.append(self.save(self.path))
            return saved[-1] == saved[-2]
        self.assertTrue(wait_for(is_quiet))
        return saved[-1]

    def landmarks(self):
        return {mark.id for mark in self.player.get("landmarks")[-1].landmarks}

    def test_a_session_comes_back_after_a_reset_and_goes_on(self):
        self.player.begin(40)
        saved, known = self.save(self.path), self.landmarks()
        self.call("reset", Trigger)
        answer = self.call("load_session", LoadMap, self.path)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(self.save(self.path.with_name("b.session")), saved)
        self.player.clear()
        self.player.play(self.player.part(40, 60))
        self.assertTrue(wait_for(lambda: len(self.player.get("pose")) >= 19))
        self.assertTrue(wait_for(lambda: self.player.get("landmarks")))
        self.assertGreaterEqual(self.landmarks(), known)
        self.assertGreater(len(self.save(self.path)), len(saved))

    def test_another_drive_is_merged_when_it_is_recognised(self):
        self.player.begin(60)
        self.save(self.path)
        self.call("reset", Trigger)
        self.player.clear()
        answer = self.call("merge_session", LoadMap, self.path)
        self.assertTrue(answer.success, answer.message)
        self.player.play(self.player.part(60, 140))
        self.assertTrue(wait_for(lambda: len(self.player.get("pose")) >= 79))
        alone = self.path.stat().st_size
        self.assertTrue(wait_for(
            lambda: len(self.save(self.path.with_name("both.session"))) > 1.5 * alone))

    def test_what_cannot_be_used_is_told_and_all_stays_as_it_is(self):
        saved = self.save_when_quiet()
        damaged = self.path.with_name("damaged.session")
        damaged.write_bytes(saved[:-1] + bytes([saved[-1] ^ 1]))
        pipe = self.path.with_name("pipe")
        os.mkfifo(pipe)
        for path, sentence in ((damaged, "damaged.session: it is damaged"),
                               (self.path.with_name("none"), "does it exist?"),
                               ("/etc/passwd", "/etc/passwd is not below /tmp"),
                               (pipe, "is a device or a pipe"), ("", "names no file")):
            answer = self.call("load_session", LoadMap, path)
            self.assertFalse(answer.success)
            self.assertIn(sentence, answer.message)
        answer = self.call("save_session", SaveMap, "/proc/a.session")
        self.assertFalse(answer.success)
        self.assertIn("/proc/a.session is not below /tmp", answer.message)
        self.assertEqual(self.save(self.path.with_name("b.session")), saved)


if __name__ == "__main__":
    rospy.init_node("session_test")
    rostest.rosrun("slam_tests", "session", SessionTest, sys.argv)
