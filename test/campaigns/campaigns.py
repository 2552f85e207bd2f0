# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns on short simulated drives, for tests."""
import contextlib
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from catkin.find_in_workspaces import find_in_workspaces

TABLES = ("runs.csv", "table.csv", "tests.csv", "report.html")
WITHIN = 400  # [s]
TINY = """
version: 1
campaign: tiny
bags:
  - {world: office, robot: [segway, turtlebot3], only: [odom, scan], duration: 5}
products: [scan_grid, scan_grid_wheel, ekf_wheel]
seeds: 2
metrics: [ate_rmse_m, map_walls_found_percent]
"""
RUNS = 12  # of these, of which those of ekf_wheel fail: the drives have no images


def program(name):
    return find_in_workspaces(["libexec"], "slam_eval", name, first_match_only=True)[0]


def require_snakemake():
    """Skips a test where campaigns cannot be run."""
    if shutil.which("snakemake") is None:
        raise unittest.SkipTest("snakemake is not installed")


def command_lines(folder):
    """Returns the command lines that name a folder, by process (/proc)."""
    found = {}
    for path in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):
            line = path.read_bytes()
            if str(folder).encode() in line:
                found[int(path.parent.name)] = line
    return found


def processes_of(folder, name=""):
    """The processes that name a folder in their command line; of a program alone."""
    return [process for process, line in command_lines(folder).items()
            if line.split(b"\0")[0].endswith(name.encode())]


def kill_one(name, folder, process):
    """Kills the first process of a program that a campaign (process) runs in its folder; whether
    there was one."""
    while process.poll() is None:
        for each in processes_of(folder, name):
            with contextlib.suppress(ProcessLookupError):
                os.kill(each, signal.SIGKILL)
                return True
        time.sleep(0.005)
    return False


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="slam_campaigns_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, text, name="tiny.yaml"):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    @staticmethod
    def call(*arguments, **environment):
        """The program's exit code and what it printed."""
        return subprocess.run([program("slam_campaign"), *map(str, arguments)], text=True,
                              env={**os.environ, **environment}, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=WITHIN,
                              check=False)

    def run_campaign(self, path, out, *arguments, **environment):
        done = self.call(path, "--out", out, *arguments, **environment)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def refuses(self, *arguments, says, **environment):
        """Wrong use: one sentence, and nothing was made."""
        done = self.call(*arguments, **environment)
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertEqual(done.stdout.count("\n"), 1, done.stdout)
        for part in says:
            self.assertIn(part, done.stdout)

    def assert_same_tables(self, one, other):
        pictures = sorted(path.name for path in one.glob("*.png"))
        self.assertEqual(pictures, sorted(path.name for path in other.glob("*.png")))
        for name in (*TABLES, *pictures):
            self.assertEqual((one / name).read_bytes(), (other / name).read_bytes(), name)

    def kill_at(self, path, out, count):
        """Starts a campaign, and kills all that belongs to it once so many runs are complete."""
        command = [program("slam_campaign"), path, "--out", out]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              start_new_session=True) as process:
            limit = time.monotonic() + WITHIN
            while len(results(out)) < count and process.poll() is None and time.monotonic() < limit:
                time.sleep(0.02)
            while left := processes_of(out):
                for each in left:
                    with contextlib.suppress(ProcessLookupError):
                        os.kill(each, signal.SIGKILL)
                time.sleep(0.05)
            process.wait()


def results(out):
    """The file of each complete run, by its name: one that is made again is another one. Its time
    says nothing, since Snakemake sets it anew."""
    return {path.parent.name: path.stat().st_ino for path in out.glob("runs/*/result.json")}
