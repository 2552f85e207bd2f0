# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A campaign on a cluster of two nodes with Slurm gives the bytes of one on this host."""
import pathlib
import tempfile
import unittest

from campaigns import InFolder, require_snakemake, TINY
import slurm_cluster


class Cluster(InFolder):
    @classmethod
    def setUpClass(cls):
        require_snakemake()
        if missing := slurm_cluster.missing():
            raise unittest.SkipTest(f"{', '.join(missing)} of Slurm are not installed")
        folder = tempfile.TemporaryDirectory(prefix="slam_slurm_")
        cls.addClassCleanup(folder.cleanup)
        cls.cluster = slurm_cluster.Cluster(pathlib.Path(folder.name))
        cls.addClassCleanup(cls.cluster.close)

    def test_gives_the_same_tables(self):
        path = self.write(TINY.replace("[segway, turtlebot3]", "[segway]"))
        self.run_campaign(path, self.folder / "here")
        self.run_campaign(path, self.folder / "there", "--profile", "slurm",
                          **self.cluster.environment)
        self.assert_same_tables(self.folder / "here", self.folder / "there")
        jobs = self.cluster.said("scontrol", "--oneliner", "show", "jobs")
        for node in ("NodeList=one", "NodeList=two"):
            self.assertIn(f" {node} ", jobs)
        self.assertEqual(jobs.count("JobState=COMPLETED"), 2 + 6)


if __name__ == "__main__":
    unittest.main()
