# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a task of a campaign notes of a program that fails, and what it does not."""
import pathlib
import tempfile
import unittest

import run_maker  # noqa: F401, before slam_eval: it finds the source tree
from slam_eval.bench.harness.error import BenchError
from slam_eval.campaign import task
from slam_eval.campaign.folder import Folder


class Programs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.log = self.folder / "log.txt"

    def test_that_fail_are_failures(self):
        for script in ("echo no scan >&2; exit 1", "echo no scan; exit 1", "echo no scan; kill "
                                                                           "-SEGV $$"):
            with self.assertRaisesRegex(BenchError, "no scan"):
                task.call(["sh", "-c", script], self.log)

    def test_that_are_ended_from_outside_are_none(self):
        for signal in ("KILL", "TERM", "INT", "HUP"):
            with self.assertRaises(task.Interrupted):
                task.call(["sh", "-c", f"kill -{signal} $$"], self.log)

    def test_that_take_too_long_are_ended(self):
        with self.assertRaisesRegex(BenchError, "longer than 0.2 s, the campaign's time_limit"):
            task.call(["sleep", "60"], self.log, task.deadline(0.2))

    def test_share_the_limit_of_their_run(self):
        watch = task.deadline(2.0)
        task.call(["sleep", "1.2"], self.log, watch)
        with self.assertRaisesRegex(BenchError, "longer than 2 s, the campaign's time_limit"):
            task.call(["sleep", "1.2"], self.log, watch)

    def test_are_quoted_without_what_differs_from_host_to_host(self):
        folder = Folder(self.folder)
        work = folder.work / "abc.x7.part"
        error = ("slam_offline ended with exit code 1: slam_offline: the bag bags/12.bag has\nno "
                 f"scan, see {work}/log.txt and {self.folder}/bags/12.bag")
        said = task.said(error, work, folder, "abc", "bags/12.bag")
        self.assertEqual(said, "slam_offline: the drive's bag has no scan, see runs/abc/log.txt "
                               "and bags/12.bag")


if __name__ == "__main__":
    unittest.main()
