# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""keep_alive starts again what was killed, and nothing that ends by itself or will never run."""

import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

KEEP_ALIVE = pathlib.Path(__file__).resolve().parents[1] / "scripts" / "keep_alive"


class KeepAlive(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.starts = pathlib.Path(folder.name) / "starts"

    def start(self, script, *arguments):
        """Starts a command that notes each start in a line."""
        return subprocess.Popen([KEEP_ALIVE, "sh", "-c", f"echo $$ >> {self.starts}; {script}", "sh",
                                 *arguments], stderr=subprocess.PIPE, text=True,
                                start_new_session=True)

    def count(self):
        return len(self.starts.read_text(encoding="ascii").split()) if self.starts.exists() else 0

    def wait_for_start(self, number):
        end = time.monotonic() + 10
        while self.count() < number:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)

    def test_what_was_killed_is_started_again_and_ends_with_a_signal_to_the_group(self):
        process = self.start("exec sleep 60")
        self.wait_for_start(1)
        os.kill(int(self.starts.read_text(encoding="ascii")), signal.SIGKILL)
        self.wait_for_start(2)
        os.killpg(process.pid, signal.SIGINT)
        process.communicate(timeout=10)
        self.assertNotEqual(process.returncode, 0)
        self.assertEqual(self.count(), 2)

    def test_what_ends_by_itself_is_not_started_again(self):
        process = self.start("exit 0")
        process.communicate(timeout=10)
        self.assertEqual(process.returncode, 0)
        self.assertEqual(self.count(), 1)

    def test_a_nodelet_loader_ends_by_itself_when_its_manager_has_gone(self):
        process = self.start("exit 0", "load", "package/Nodelet", "manager")
        self.assertIn("not started again", process.communicate(timeout=20)[1])
        self.assertEqual(self.count(), 3)

    def test_what_cannot_run_is_given_up_with_its_exit_code(self):
        process = self.start("exit 7")
        said = process.communicate(timeout=20)[1]
        self.assertEqual(process.returncode, 7)
        self.assertIn("sh has ended 3 times within 10 s of its start; it is not started again", said)
        self.assertEqual(self.count(), 3)


if __name__ == "__main__":
    unittest.main()
