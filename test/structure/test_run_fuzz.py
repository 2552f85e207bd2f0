# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""test/run_fuzz keeps an input that ends a fuzz target, and says how to repeat it."""

import contextlib
import importlib.util
from importlib.machinery import SourceFileLoader
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[1] / "run_fuzz"
# This program behaves as a libFuzzer target that an input has ended.
ENDS = """#!/bin/bash
for argument; do case $argument in -artifact_prefix=*) echo input >"${argument#*=}crash-7f"; esac; done
echo "broken: a pose that is not finite" >&2
exit 77
"""
GOES_ON = """#!/bin/bash
echo "$@" >"$(dirname "$0")/called"
echo "#20 DONE cov: 31 ft: 41" >&2
echo "stat::number_of_executed_units: 20" >&2
"""


def load():
    loader = SourceFileLoader("run_fuzz", str(SCRIPT))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("run_fuzz", loader))
    loader.exec_module(module)
    return module


class Fuzz(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.module = load()
        self.folder = self.module.BUILD = pathlib.Path(folder.name)

    def fuzz(self, script):
        """Returns whether a target passed, and what was printed."""
        program = self.folder / "slam_core_fuzz_landmark_drive"
        program.write_text(script, encoding="utf-8")
        program.chmod(0o755)
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            passed = self.module.fuzz(program, pathlib.Path("seeds/landmark_drive"), 7)
        return passed, printed.getvalue()

    def test_of_a_target_that_an_input_ends_fails_and_prints_the_command(self):
        passed, printed = self.fuzz(ENDS)
        self.assertFalse(passed)
        self.assertIn("landmark_drive ... FAILED", printed)
        self.assertIn("broken: a pose that is not finite", printed)
        found = self.folder / "findings/landmark_drive/crash-7f"
        self.assertIn(f"repeat it with: {self.folder}/slam_core_fuzz_landmark_drive {found}",
                      printed)
        self.assertEqual(found.read_text(encoding="utf-8"), "input\n")

    def test_goes_on_for_so_long_with_what_was_learnt_before(self):
        passed, printed = self.fuzz(GOES_ON)
        self.assertTrue(passed)
        self.assertIn("landmark_drive ... ok (20 inputs, 31 branches)", printed)
        called = (self.folder / "called").read_text(encoding="utf-8")
        for word in ("-max_total_time=7", "corpus/landmark_drive", "seeds/landmark_drive"):
            self.assertIn(word, called)


class Arguments(unittest.TestCase):

    def test_that_are_no_seconds_are_refused(self):
        for word in ("0", "-3", "1.5", "soon"):
            run = subprocess.run([sys.executable, SCRIPT, "--", word], capture_output=True,
                                 text=True, check=False)
            self.assertEqual(run.returncode, 2)
            self.assertIn("is no whole number of seconds above 0", run.stderr)


if __name__ == "__main__":
    unittest.main()
