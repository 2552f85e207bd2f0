# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A campaign on a cluster of two nodes with Slurm gives the bytes of one on this host."""
import contextlib
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

from campaigns import InFolder, program, require_snakemake, results, TINY, WITHIN
import slurm_cluster

SMALL = TINY.replace("[segway, turtlebot3]", "[segway]")
DRIVES, RUNS = 2, 6


def children(process):
    """The processes that one has started."""
    with contextlib.suppress(OSError):
        path = pathlib.Path(f"/proc/{process}/task/{process}/children")
        return [int(word) for word in path.read_text(encoding="ascii").split()]
    return []


class Cluster(InFolder):
    @classmethod
    def setUpClass(cls):
        require_snakemake()
        if missing := slurm_cluster.missing():
            raise unittest.SkipTest(f"{', '.join(missing)} of Slurm are not installed")
        cls.home = tempfile.TemporaryDirectory(prefix="slam_slurm_")
        cls.cluster = slurm_cluster.Cluster(pathlib.Path(cls.home.name))

    @classmethod
    def tearDownClass(cls):  # nose calls no class cleanups
        cls.cluster.close()
        cls.home.cleanup()

    def setUp(self):
        super().setUp()
        self.path = self.write(SMALL)
        self.run_campaign(self.path, self.folder / "here")

    def submit(self, out):
        """Calls the campaign and kills the call, not the jobs, once a run is complete."""
        command = [program("slam_campaign"), self.path, "--out", out, "--profile", "slurm"]
        with subprocess.Popen(command, env=self.cluster.environment, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as process:
            limit = time.monotonic() + WITHIN
            while not results(out) and process.poll() is None and time.monotonic() < limit:
                time.sleep(0.05)
            for each in [process.pid, *children(process.pid)]:
                os.kill(each, signal.SIGKILL)

    def test_gives_the_same_tables_on_both_nodes(self):
        out = self.folder / "there"
        self.run_campaign(self.path, out, "--profile", "slurm", **self.cluster.environment)
        self.assert_same_tables(self.folder / "here", out)
        jobs = self.cluster.said("scontrol", "--oneliner", "show", "jobs")
        for node in ("NodeList=one", "NodeList=two"):
            self.assertIn(f" {node} ", jobs)
        self.assertGreaterEqual(jobs.count("JobState=COMPLETED"), DRIVES + RUNS)

    def test_goes_on_where_a_call_was_killed_while_jobs_run(self):
        out = self.folder / "killed"
        self.submit(out)
        before = results(out)
        self.assertTrue(0 < len(before) < RUNS, before)
        self.run_campaign(self.path, out, "--profile", "slurm", **self.cluster.environment)
        after = results(out)
        self.assertEqual({name: after[name] for name in before}, before)
        self.assert_same_tables(self.folder / "here", out)


if __name__ == "__main__":
    unittest.main()
