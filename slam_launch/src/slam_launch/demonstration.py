# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the demonstrations have in common: programs of other packages, and the data."""

import pathlib
import subprocess

import rospkg

from . import packages
from .errors import ProductError

WORLD, SEED = "office", 1
SENA_LOG = pathlib.Path("/usr/share/mrpt/datasets/"
                        "2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog")


class DemoError(Exception):
    """A step of the demonstration failed; the message says which and why."""


def command(package, program, *arguments):
    """Returns the call of a program of a package."""
    try:
        return [packages.program(package, program), *map(str, arguments)]
    except ProductError as error:
        raise DemoError(str(error)) from error


def call(package, program, *arguments):
    """Runs a program of a package."""
    code = subprocess.call(command(package, program, *arguments))
    if code != 0:
        raise DemoError(f"'{program}' ended with exit code {code}")


def call_quietly(package, program, *arguments):
    """Runs a program; what it printed is told only where it fails."""
    done = subprocess.run(command(package, program, *arguments), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
    if done.returncode != 0:
        raise DemoError(f"'{program}' ended with exit code {done.returncode}:\n{done.stdout}")


def make_bag(bag):
    """Simulates the office once; the simulation leaves no half bag."""
    if bag.exists():
        print(f"the office of an earlier call: {bag}", flush=True)
        return
    bag.parent.mkdir(parents=True, exist_ok=True)
    call("slam_sim", "slam_sim", bag, "--world", WORLD, "--seed", SEED)


def import_sena(bag):
    """Imports the real log once, as above."""
    if bag.exists():
        print(f"the log of an earlier call: {bag}", flush=True)
        return
    if not SENA_LOG.is_file():
        raise DemoError(f"there is no {SENA_LOG}; install mrpt-common")
    bag.parent.mkdir(parents=True, exist_ok=True)
    call("slam_eval", "slam_import", "rawlog", SENA_LOG, bag)


def world_file():
    return pathlib.Path(rospkg.RosPack().get_path("slam_sim")) / "worlds" / f"{WORLD}.yaml"
