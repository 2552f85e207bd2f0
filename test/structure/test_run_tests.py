# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""test/run_tests leaves nothing behind of a test, neither of one that hangs nor after Ctrl-C, and
tells a test that failed from a sanitizer that crashed."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from runner import processes
from runner.report import Report

processes.GRACE = 1
WITHIN = 60  # [s]
# As a launch does: one process in a session of its own, which the script writes down, and it does
# not listen.
HANGS = ('setsid bash -c "trap : INT TERM; echo \\$\\$ > {0}.part; mv {0}.part {0}; '
         'while :; do sleep 1; done"')
CALLS = """
import pathlib, signal, sys
from runner import processes
signal.signal(signal.SIGHUP, signal.SIG_DFL)  # nohup has it ignored
processes.GRACE = 1
processes.heed_interrupts()
processes.call(["bash", "-c", sys.argv[1]], pathlib.Path(sys.argv[2]))
"""


def is_alive(process):
    """Whether a process runs; one that has ended may wait for its parent to take note."""
    try:
        state = pathlib.Path(f"/proc/{process}/stat").read_text(encoding="ascii")
    except FileNotFoundError:
        return False
    return state.rpartition(")")[2].split()[0] != "Z"


class Leftovers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.log = pathlib.Path(folder.name) / "log"
        self.note = pathlib.Path(folder.name) / "process"

    def noted(self):
        """Returns the id of the process that does not listen, once it runs."""
        limit = time.monotonic() + WITHIN
        while not self.note.exists() and time.monotonic() < limit:
            time.sleep(0.05)
        return int(self.note.read_text(encoding="ascii"))

    def test_a_test_that_hangs_is_ended_with_all_that_it_has_started(self):
        command = ["bash", "-c", HANGS.format(self.note) + " & wait"]
        self.assertEqual(processes.call(command, self.log, timeout=3), 124)
        self.assertFalse(is_alive(self.noted()))
        self.assertIn("it took longer than 3 s", self.log.read_text(encoding="utf-8"))

    def test_a_node_that_outlives_its_test_is_ended(self):
        wait = f" & while [ ! -e {self.note} ]; do sleep 0.1; done; exit 3"
        command = ["bash", "-c", HANGS.format(self.note) + wait]
        self.assertEqual(processes.call(command, self.log), 3)
        self.assertFalse(is_alive(self.noted()))

    def test_a_test_beside_it_is_left_alone(self):
        with subprocess.Popen(["sleep", "100"],
                              env={**os.environ, processes.MARK: f"{os.getpid()}.10"}) as other:
            processes.call(["true"], self.log)  # number 0
            processes.end(f"{os.getpid()}.1", signal.SIGTERM)
            self.assertIsNone(other.poll())
            processes.end(str(os.getpid()), signal.SIGTERM)
            self.assertEqual(other.wait(WITHIN), -signal.SIGTERM)

    def test_ctrl_c_ends_all(self):
        self.assert_ends_all(signal.SIGINT)

    def test_a_kill_and_a_closed_terminal_end_all(self):
        self.assert_ends_all(signal.SIGTERM)
        self.note.unlink()
        self.assert_ends_all(signal.SIGHUP)

    def assert_ends_all(self, request):
        command = HANGS.format(self.note) + " & wait"
        with subprocess.Popen([sys.executable, "-c", CALLS, command,
                               str(self.log)]) as tests:
            hanging = self.noted()
            tests.send_signal(request)
            self.assertEqual(tests.wait(WITHIN), 128 + request)
        self.assertFalse(is_alive(hanging))


class TimeThatIsOver(unittest.TestCase):
    def test_nothing_begins_any_more(self):
        with tempfile.TemporaryDirectory() as folder:
            report = Report(pathlib.Path(folder), time.monotonic() + 3600)
            self.assertTrue(report.run("first", ["true"]))
            report.latest = time.monotonic() - 1
            self.assertFalse(report.run("second", ["false"]))
            self.assertEqual((report.passed, report.failed), (1, []))
            self.assertEqual(report.skipped, ["second: the time was over"])


class BrokenTracer(unittest.TestCase):
    PROGRAM = ("case $ASAN_OPTIONS in *=0) exit {0};; esac; "
               'echo "==1==LeakSanitizer has encountered a fatal error."; exit 1')

    def report_on(self, code_without_leaks):
        with tempfile.TemporaryDirectory() as folder:
            report = Report(pathlib.Path(folder))
            report.run("some", ["bash", "-c", self.PROGRAM.format(code_without_leaks)],
                       env={**os.environ, "ASAN_OPTIONS": "detect_leaks=1"})
        return report

    def test_a_good_test_passes_and_its_leaks_are_skipped(self):
        report = self.report_on(code_without_leaks=0)
        self.assertEqual((report.passed, report.failed), (1, []))
        self.assertEqual([skip.split(",")[0] for skip in report.skipped],
                         ["some: leaks: the sanitizer's search for them crashed"])

    def test_a_bad_test_fails(self):
        self.assertEqual(self.report_on(code_without_leaks=3).failed, ["some"])


if __name__ == "__main__":
    unittest.main()
