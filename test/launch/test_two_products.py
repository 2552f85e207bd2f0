# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two products on one master, each in a namespace: each does what it does alone."""

from contextlib import contextmanager
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

import rosgraph

from launching import (cut_bag, free_port, make_demo_bag, run_offline, SameAsOffline, start_launch,
                       wait_for_last_step)

SECONDS = 5  # of the log
PRODUCTS = {"left": "ekf_wheel", "right": "pf_wheel"}
TOPICS = "/odom", "/observations"


@contextmanager
def master():
    """A master of nobody's: launches come and go. Yields its port."""
    port = free_port()
    environment = {**os.environ, "ROS_MASTER_URI": f"http://localhost:{port}"}
    core = subprocess.Popen(["roscore", "-p", str(port)], env=environment,
                            stdout=subprocess.DEVNULL)
    try:
        while subprocess.call(["rosparam", "get", "/run_id"], env=environment,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL):
            time.sleep(0.2)
        yield port
    finally:
        core.send_signal(signal.SIGINT)
        core.wait(timeout=40)


def wait_for_both(port, timeout=40):
    """Waits until both products listen: rosbag itself waits for one of them."""
    state = rosgraph.Master("/two_products", f"http://localhost:{port}").getSystemState
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        listeners = dict(state()[1])
        if all(len(listeners.get(topic, ())) == len(PRODUCTS) for topic in TOPICS):
            return
        time.sleep(0.2)


class TwoProductsTest(SameAsOffline, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)
        cls.bag = cls.root / "short.bag"
        make_demo_bag(cls.root / "whole.bag")
        cut_bag(cls.root / "whole.bag", cls.bag, 0, SECONDS)
        for name, product in PRODUCTS.items():
            run_offline(cls.bag, cls.root / name, product=product)

    def start(self, port, kind, *arguments, apart=0):
        """Starts both, seconds apart; returns their processes and environments by namespace."""
        launches = {}
        for name, product in PRODUCTS.items():
            run = self.root / kind / name
            launches[name] = start_launch(f"product:={product}", f"output_dir:={run}", *arguments,
                                          port=port, namespace=f"/{name}")
            time.sleep(apart)  # so that their clocks differ
        return launches

    def assert_same(self, kind, outputs):
        for name, output in outputs.items():
            self.assert_same_runs(self.root / kind / name, self.root / name, output)

    def test_two_replays_do_not_stir_each_other(self):
        with master() as port:
            launches = self.start(port, "replays", f"bag:={self.bag}", "rate:=1", apart=2)
            outputs = {name: launch.communicate(timeout=100)[0]
                       for name, (launch, _) in launches.items()}
        self.assert_same("replays", outputs)

    def test_two_live_products_of_one_robot(self):
        with master() as port:
            launches = self.start(port, "live", "use_sim_time:=true", "unsafe_paths:=true",
                                  "robot:=mrpt_demo", "odom_topic:=/odom",
                                  "observations_topic:=/observations")
            outputs = self.play(port, launches)
        self.assert_same("live", outputs)

    def play(self, port, launches):
        environment = {**os.environ, "ROS_MASTER_URI": f"http://localhost:{port}"}
        wait_for_both(port)
        subprocess.run(["rosbag", "play", "-q", "--wait-for-subscribers", "--clock", "-r", "2",
                        self.bag, "--topics", *TOPICS], env=environment,
                       check=True, timeout=60, stdout=subprocess.DEVNULL)
        for name, (launch, own) in launches.items():
            wait_for_last_step(own, self.root / name)
            launch.send_signal(signal.SIGINT)
        return {name: launch.communicate(timeout=40)[0] for name, (launch, _) in launches.items()}


if __name__ == "__main__":
    unittest.main()
