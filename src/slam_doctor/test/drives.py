# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bags of the simulator with faults put into them, and what the doctor says of them."""
import atexit
import functools
import pathlib
import shutil
import subprocess
import tempfile

from catkin.find_in_workspaces import find_in_workspaces
from slam_doctor.case import Case
from slam_doctor.cli import examine
from slam_doctor.expectations import (all_products, Expectations, NO_ROBOT, read_product,
                                      read_robot)
from slam_doctor.record.bag import read_bag
from slam_eval.bench.harness import bag_edit

ODOMETRY, SCAN, IMU = bag_edit.ODOMETRY, bag_edit.SCAN, "sensor_msgs/Imu"
FOLDER = pathlib.Path(tempfile.mkdtemp(prefix="slam_doctor_test_"))
atexit.register(shutil.rmtree, FOLDER, ignore_errors=True)


def simulate(name, *options):
    """A bag of the simulator."""
    bag = FOLDER / f"{name}.bag"
    if not bag.exists():
        program = find_in_workspaces(["libexec"], "slam_sim", "slam_sim", first_match_only=True)[0]
        subprocess.run([program, str(bag), *options], check=True, capture_output=True)
    return bag


def drive(seed=1):
    """A drive round the office with wheels and laser, 54 s."""
    return simulate(f"drive_{seed}", "--seed", str(seed), "--only", "odom,scan")


def views(seed=1):
    """The first seconds of it with both cameras."""
    return simulate(f"views_{seed}", "--seed", str(seed), "--duration", "6")


class Edit:
    """Makes a change for bag_edit.edit() of a function (kind, message, time)."""

    def __init__(self, kinds, function):
        self.kinds, self._function = kinds, function

    def __call__(self, kind, message, time):
        self._function(kind, message, time)


def edited(name, change, source=None, left_out=()):
    """A bag with a fault in it."""
    return bag_edit.edit(source or drive(), FOLDER / f"{name}.bag", change, left_out)


@functools.lru_cache(maxsize=None)
def products():
    """All products; their ports take seconds to be asked for."""
    return tuple(all_products())


def diagnose(bag, robot="sim_segway", product=None):
    """The findings about a bag by check; a product is a name or a file."""
    file = read_robot(str(robot)) if robot else NO_ROBOT
    chosen = read_product(str(product)) if product else None
    known = (chosen,) if chosen else products()
    groups = examine(Case(read_bag(bag), Expectations(file, chosen, known)))
    return {each.check: each for findings in groups.values() for each in findings}


def faults(findings):
    """{check: level} of what is WARN or ERROR."""
    return {name: each.level.name for name, each in findings.items()
            if each.level.name in ("WARN", "ERROR")}
