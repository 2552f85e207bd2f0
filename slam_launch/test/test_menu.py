# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The menu in a terminal, driven by keys."""

import os
import pathlib
import pty
import select
import subprocess
import sys
import tempfile
import time
import unittest

MENU = pathlib.Path(__file__).resolve().parents[1] / "scripts" / "menu"
DOWN, ENTER = "j", "\r"
QUIET = 0.3  # [s] without output: the menu waits for a key


class Terminal:
    """Runs the menu in a terminal of its own."""

    def __init__(self, name, home):
        self.master, slave = pty.openpty()
        environment = {**os.environ, "TERM": "xterm", "XDG_CONFIG_HOME": home, "LINES": "40",
                       "COLUMNS": "100", "ESCDELAY": "25"}
        self.process = subprocess.Popen([sys.executable, MENU, name], stdin=slave, stdout=slave,
                                        stderr=slave, env=environment, start_new_session=True)
        os.close(slave)
        self.said = ""

    def listen(self, first):
        """Reads until nothing comes any more."""
        wait = first
        while select.select([self.master], [], [], wait)[0]:
            try:
                self.said += os.read(self.master, 4096).decode(errors="replace")
            except OSError:  # the other end is closed
                return
            wait = QUIET

    def press(self, *keys):
        for key in keys:
            self.listen(first=10)
            os.write(self.master, key.encode())

    def end(self):
        end = time.monotonic() + 20
        while self.process.poll() is None and time.monotonic() < end:
            self.listen(first=QUIET)
        self.process.kill()
        self.listen(first=QUIET)
        os.close(self.master)
        return self.process.wait()


class Menu(unittest.TestCase):
    def setUp(self):
        home = tempfile.TemporaryDirectory()
        self.addCleanup(home.cleanup)
        self.home = home.name
        self.product = pathlib.Path(self.home) / "slam" / "products" / "mine.yaml"

    def test_writes_the_product_that_was_chosen(self):
        terminal = Terminal("mine", self.home)
        # the back-end, its strategy, the fourth choice; save to the proposed file; quit
        terminal.press(ENTER, ENTER, DOWN, DOWN, DOWN, " ", "S", ENTER, " ", "Q")
        self.assertEqual(terminal.end(), 0, terminal.said)
        self.assertIn("backend: pf", self.product.read_text(encoding="utf-8"), terminal.said)

    def test_writes_nothing_when_it_is_left_without_saving(self):
        terminal = Terminal("mine", self.home)
        terminal.press("Q", "n")  # no, it shall not be saved
        self.assertEqual(terminal.end(), 1, terminal.said)
        self.assertIn("nothing was saved in the menu: no product is written", terminal.said)
        self.assertNotIn("Configuration (", terminal.said)
        self.assertFalse(self.product.exists(), terminal.said)

    def test_needs_a_terminal(self):
        done = subprocess.run([sys.executable, MENU, "mine"], stdin=subprocess.DEVNULL, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("needs a terminal", done.stdout)


if __name__ == "__main__":
    unittest.main()
