# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are killed and resumed leave the same bytes as one that was never stopped."""

import json
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from launching import program

SECONDS = 20  # of the office
KILLS = 10
PRODUCTS = ("ekf_wheel", "pf_wheel_grid", "graph_wheel_grid", "scan_grid")
TIMES = {"wall_s", "cpu_s", "realtime_factor", "max_rss_mb"}  # of metrics.json


def is_of_call(key):
    """Whether a figure is of how long it took or how it was called."""
    return key in TIMES or "_ms" in key or key == "run"


class ResumeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)
        cls.bag, cls.other = cls.root / "office.bag", cls.root / "other.bag"
        for bag, seconds in ((cls.bag, SECONDS), (cls.other, 5)):
            subprocess.run([program("slam_sim", "slam_sim"), bag, "--duration", str(seconds)],
                           check=True, stdout=subprocess.DEVNULL)
        cls.whole, cls.took = {}, {}
        for product in PRODUCTS:
            start = time.monotonic()
            run = cls.whole[product] = cls.root / f"{product}_whole"
            cls.finish(cls.start(product, "--out", run))
            cls.took[product] = time.monotonic() - start

    @classmethod
    def start(cls, product, *options, bag=None, **popen):
        command = [program("slam_ros", "slam_run"), product, "--bag", bag or cls.bag, *options]
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                **popen)

    @classmethod
    def finish(cls, process, code=0):
        said, _ = process.communicate()
        assert process.returncode == code, said
        return said

    def assert_same_files(self, run, whole):
        files = sorted(path.name for path in whole.iterdir())
        self.assertEqual(sorted(path.name for path in run.iterdir()), files)
        for name in files:
            if name != "metrics.json":
                self.assertEqual((run / name).read_bytes(), (whole / name).read_bytes(), name)
        ours, theirs = (json.loads((path / "metrics.json").read_text()) for path in (run, whole))
        for key in theirs:
            if not is_of_call(key):
                self.assertEqual(ours.get(key), theirs[key], key)

    def interrupt(self, product, run, number, moments):
        """Starts a run or resumes it, and sends it a signal. Returns whether it was through."""
        unfinished = run / "unfinished_run" / "checkpoint"
        options = ("--resume", run) if unfinished.exists() else ("--out", run)
        process = self.start(product, *options, "--autosave", "1")
        time.sleep(moments.uniform(0.0, self.took[product]))
        process.send_signal(number)
        said, _ = process.communicate()
        if process.returncode == 0:
            return True
        self.assertIn(process.returncode, (-number, 1), said)
        if number != signal.SIGKILL and process.returncode == 1:
            self.assertIn("go on with --resume", said)
        return False

    def survive(self, product, number, times):
        """Interrupts runs so often; each run that is through must be as a whole one."""
        moments = random.Random(product)
        run = self.root / f"{product}_{number}"
        for _ in range(times):
            if self.interrupt(product, run, number, moments):
                self.assert_same_files(run, self.whole[product])
                shutil.rmtree(run)
        if (run / "unfinished_run" / "checkpoint").exists():
            said = self.finish(self.start(product, "--resume", run))
            self.assertIn("goes on after", said)
            self.assert_same_files(run, self.whole[product])

    def test_killed_at_random_moments_they_end_with_the_same_bytes(self):
        for product in PRODUCTS:
            with self.subTest(product):
                self.survive(product, signal.SIGKILL, max(1, KILLS // len(PRODUCTS)))

    def test_a_signal_saves_the_run_first(self):
        self.survive("ekf_wheel", signal.SIGTERM, 2)

    def unfinished(self, product, name):
        """Returns the folder of a run that has a checkpoint and was killed."""
        run = self.root / name
        process = self.start(product, "--out", run, "--autosave", "1")
        checkpoint = run / "unfinished_run" / "checkpoint"
        while not checkpoint.exists() and process.poll() is None:
            time.sleep(0.01)
        process.kill()
        process.communicate()
        self.assertTrue(checkpoint.exists())
        return run

    def test_another_bag_product_or_configuration_is_refused_and_nothing_is_lost(self):
        run = self.unfinished("ekf_wheel", "refused")
        for sentence, product, options, bag in (
                ("another bag", "ekf_wheel", (), self.other),
                ("another product", "pf_wheel", (), None),
                ("another configuration", "ekf_wheel", ("--set", "ekf.gate_probability=0.9"), None),
                ("leave out --load-map", "ekf_wheel", ("--load-map", self.whole["ekf_wheel"]),
                 None)):
            with self.subTest(sentence):
                process = self.start(product, "--resume", run, *options, bag=bag)
                self.assertIn(sentence, self.finish(process, 1))
        self.finish(self.start("ekf_wheel", "--resume", run))
        self.assert_same_files(run, self.whole["ekf_wheel"])

    def test_a_damaged_checkpoint_is_refused(self):
        run = self.unfinished("ekf_wheel", "damaged")
        checkpoint = run / "unfinished_run" / "checkpoint"
        content = checkpoint.read_bytes()
        for sentence, damaged in (("it is cut", content[:-1]), ("no checkpoint", b"x" + content),
                                  ("it is damaged", content[:-20] + b"x" * 20)):
            checkpoint.write_bytes(damaged)
            self.assertIn(sentence, self.finish(self.start("ekf_wheel", "--resume", run), 1))
        checkpoint.unlink()
        self.assertIn("there is no checkpoint",
                      self.finish(self.start("ekf_wheel", "--resume", run), 1))

    def test_a_second_run_into_the_folder_is_refused(self):
        run = self.root / "locked"
        first = self.start("ekf_wheel", "--out", run, "--autosave", "1")
        while not (run / "unfinished_run" / "checkpoint").exists():
            self.assertIsNone(first.poll())
            time.sleep(0.01)
        said = self.finish(self.start("ekf_wheel", "--resume", run), 1)
        self.assertIn("another run is writing into the folder", said)
        self.finish(first)
        self.assert_same_files(run, self.whole["ekf_wheel"])

    def test_a_checkpoint_that_does_not_fit_on_the_disk_ends_no_run(self):
        """A limit of the files' size shows as a full disk does."""
        run = self.root / "full"
        limit = max(path.stat().st_size for path in self.whole["pf_wheel_grid"].iterdir()) + 1
        process = self.start("pf_wheel_grid", "--out", run, "--autosave", "1",
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE,
                                                                   (limit, limit)))
        said = self.finish(process)
        self.assertEqual(said.count("no checkpoint could be written"), 1, said)
        self.assert_same_files(run, self.whole["pf_wheel_grid"])


if __name__ == "__main__":
    unittest.main()
