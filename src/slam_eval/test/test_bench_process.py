# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs are found and called, and their cost is measured."""
import io
import os
import pathlib
import tempfile
import unittest
from unittest import mock

from slam_eval.bench.harness import process, programs
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.progress import Progress


class Folder(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_shell(self, script, watch=None):
        """Run a script as a benchmark's program."""
        return process.run(["/bin/sh", "-c", script], self.folder / "log", watch=watch)


class Process(Folder):

    def test_output_goes_to_the_log(self):
        self.run_shell("echo out; echo err >&2")
        self.assertEqual((self.folder / "log").read_text(encoding="ascii"), "out\n")
        self.assertEqual((self.folder / "log.err").read_text(encoding="ascii"), "err\n")

    def test_cpu_time_is_what_the_program_used_not_how_long_it_took(self):
        usage = self.run_shell("sleep 0.5")
        self.assertGreaterEqual(usage.wall_s, 0.5)
        self.assertLess(usage.cpu_s, 0.25)

    def test_memory_is_the_programs_own_not_that_of_python(self):
        ballast = bytearray(100_000_000)
        ballast[::4096] = b"x" * len(ballast[::4096])
        usage = self.run_shell("sleep 0.3")
        self.assertGreater(usage.max_rss_mb, 0.1)
        self.assertLess(usage.max_rss_mb, 50.0)

    def test_a_failure_says_the_programs_last_words(self):
        with self.assertRaisesRegex(BenchError, "sh ended with exit code 3: no such map"):
            self.run_shell("echo hello; echo no such map >&2; exit 3")

    def test_a_killed_program_is_a_failure(self):
        with self.assertRaisesRegex(BenchError, "signal 9"):
            self.run_shell("kill -9 $$")

    def test_a_program_that_is_not_there_is_a_failure(self):
        with self.assertRaisesRegex(BenchError, "/nowhere/x cannot be run"):
            process.run(["/nowhere/x"], self.folder / "log")

    def leaves_nothing_behind(self, script):
        """The process whose id a script prints is gone when the script is given up."""
        pids = []

        def give_up(_):
            pids.append(int((self.folder / "log").read_text(encoding="ascii") or 0))
            if pids[-1]:
                raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            self.run_shell(script, give_up)
        with self.assertRaises(ProcessLookupError):
            os.kill(pids[-1], 0)

    def test_a_benchmark_that_is_given_up_leaves_no_program_behind(self):
        self.leaves_nothing_behind("echo $$; exec sleep 60")

    def test_a_program_that_is_given_up_has_time_to_end_what_it_started(self):
        self.leaves_nothing_behind("sleep 60 & trap 'kill $!; wait; exit 1' TERM; echo $!; wait")


class Programs(Folder):

    def make_program(self, prefix):
        """A program of the package pkg in a workspace."""
        path = self.folder / prefix / "lib" / "pkg" / "prog"
        path.parent.mkdir(parents=True)
        path.write_text("#!/bin/sh\n", encoding="ascii")
        path.chmod(0o755)
        return path

    def test_the_first_workspace_wins(self):
        first = self.make_program("a")
        self.make_program("b")
        prefixes = f"{self.folder}/none:{self.folder}/a:{self.folder}/b"
        with mock.patch.dict(os.environ, CMAKE_PREFIX_PATH=prefixes):
            self.assertEqual(programs.workspace_program("pkg", "prog"), first)

    def test_an_installed_program_is_found_where_no_workspace_has_it(self):
        installed = self.make_program("usr")
        with mock.patch.object(programs, "SYSTEM", str(self.folder / "usr")):
            with mock.patch.dict(os.environ, CMAKE_PREFIX_PATH=""):
                self.assertEqual(programs.workspace_program("pkg", "prog"), installed)
            own = self.make_program("a")
            with mock.patch.dict(os.environ, CMAKE_PREFIX_PATH=str(self.folder / "a")):
                self.assertEqual(programs.workspace_program("pkg", "prog"), own)

    def test_a_program_that_is_not_built_is_named(self):
        with mock.patch.dict(os.environ, CMAKE_PREFIX_PATH=str(self.folder)):
            with self.assertRaisesRegex(BenchError, "prog of pkg"):
                programs.workspace_program("pkg", "prog")

    def test_data_are_looked_for_where_the_environment_says(self):
        with mock.patch.dict(os.environ, SLAM_DATA_DIR="/data"):
            self.assertEqual(programs.data_folder("set"), pathlib.Path("/data/set"))


class ProgressInALog(unittest.TestCase):

    def test_a_task_gives_one_line_however_often_it_reports(self):
        stream = io.StringIO()
        progress = Progress(stream)
        progress.begin("kf-slam")
        for step in range(1000):
            progress.update(f"step {step}")
        progress.end()
        self.assertEqual(stream.getvalue(), "kf-slam ...\n")


if __name__ == "__main__":
    unittest.main()
