# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Drives through random halls as bags, and products that are run on them as they are shipped."""
import pathlib

import numpy as np
import rosbag
import yaml

from slam_eval.bench.harness import bag_edit, process
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.halls import write_hall
from slam_eval.bench.harness.landmark_sensor import observe
from slam_eval.bench.harness.products import makes_a_grid
from slam_eval.bench.harness.programs import package_folder, workspace_program
from slam_eval.bench.harness.runs import simulate
from slam_eval.io.trajectory import Trajectory

LANDMARKS, SCANS = "landmarks", "scans"  # what a product sees the world by


class Nothing:
    """A change that changes nothing."""

    kinds = ()


class Drives:
    """The drive of each seed, simulated once, as a bag for each sensor."""

    def __init__(self, context):
        self._context, self._bags = context, {}

    def bag(self, seed, sensor):
        """The bag without any fault."""
        if (seed, sensor) not in self._bags:
            self._make(seed)
        return self._bags[seed, sensor]

    def _make(self, seed):
        name = f"hall_{seed}"
        world = write_hall(self._context.work / f"{name}.yaml", seed)
        bag = simulate(self._context, name, world, seed, "odom,scan")
        self._bags[seed, SCANS] = bag_edit.edit(bag, bag.with_name(f"{name}_scans.bag"), Nothing())
        self._bags[seed, LANDMARKS] = observe(bag, bag.with_name(f"{name}_landmarks.bag"), seed)
        bag.unlink()


def sensor_of(product):
    """What a product, by its name or file, sees the world by. Raises BenchError."""
    path = pathlib.Path(product)
    if path.suffix != ".yaml":
        path = package_folder("slam_launch") / "products" / f"{product}.yaml"
    try:
        features = yaml.safe_load(path.read_text(encoding="utf-8"))
    except OSError:
        raise BenchError(f"there is no product {product}; name one of slam_launch/products, or a "
                         "file") from None
    if makes_a_grid(features):
        return SCANS
    if features.get("map") == "landmarks" and features.get("odometry") == "wheel":
        return LANDMARKS
    raise BenchError(f"the product {product} does not make its map of landmarks or of scans with "
                     "wheel odometry; give others with --products")


def truth_of(bag_file):
    """The true poses in a bag as a Trajectory."""
    stamps, poses = [], []
    with rosbag.Bag(str(bag_file)) as bag:
        for _, raw, _ in bag.read_messages(raw=True):
            if raw[0] == bag_edit.POSE:
                stamps.append(raw[-1]().deserialize(raw[1]).header.stamp.to_nsec())
                poses.append(bag_edit.read_place(bag_edit.POSE, raw[1]))
    return Trajectory(np.array(stamps, dtype=np.int64), np.array(poses))


def run_product(folder, product, bag, seed, robot=None, settings=()):
    """Run a product on a bag into a folder; returns its CPU time [s]. Raises BenchError.

    robot: a robot file, instead of the one that the bag names.
    settings: section.key=value, instead of the files' values.
    """
    command = product_command(product, bag, seed, settings)
    command += ["--robot", robot] if robot else []
    return process.run([*command, "--out", folder], log_of(folder)).cpu_s


def product_command(product, bag, seed, settings=()):
    """What runs a product on a bag, without the folder."""
    command = [workspace_program("slam_ros", "slam_offline"), product, "--bag", bag]
    for setting in ("detector=none", f"seed={seed}", *settings):
        command += ["--set", setting]
    return command


def log_of(folder):
    """What the run of this folder has printed."""
    return folder.with_name(f"{folder.name}.log")
