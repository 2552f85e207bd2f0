# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark imu: drift of the heading of wheels with an IMU beside that of the wheels alone."""
import json
import math

import numpy as np

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.goals import Goal, verdicts
from slam_eval.bench.harness.programs import simulation_file, workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import lines_of, Section, table

PROGRAM = "slam_eval_imu_odometry"
WORLDS = ("office", "corridor", "hall")
LEVERS = (0.71, 0.98, 1.4)  # what the driver believes of the base, in parts of the truth
SECONDS = 300               # of a drive, at most
# The random part of the way's noise is that of the wheels; all else has the defaults.
ROBOT = ("wheel_odometry.alpha1=5e-4", "wheel_odometry.alpha2=2e-4")

HEADER = ["world", "turns measured", "wheels [deg/m]", "with IMU [deg/m]", "share",
          "NEES of motions", "NEES of 100 motions"]
FORMS = [".2f", ".3f", ".3f", ".3f", ".2f", ".2f"]
GOALS = (Goal("share", 0.2),)


def parse_result(text):
    """{name of the odometry: its figures} of the program's JSON. Raises BenchError."""
    try:
        found = {entry["name"]: entry for entry in json.loads(text)["odometry"]}
        if all("rotation_rad_per_m" in found[name] for name in ("wheel", "wheel_imu")):
            return found
    except (json.JSONDecodeError, KeyError, TypeError):
        pass
    raise BenchError(f"{PROGRAM} printed no JSON of drifts; build it again")


def row_of(world, lever, drives):
    """The line of a world and a base, means over the seeds' drives."""
    def mean(name, key):
        return float(np.mean([drive[name][key] for drive in drives]))

    wheels, with_imu = (math.degrees(mean(name, "rotation_rad_per_m"))
                        for name in ("wheel", "wheel_imu"))
    return [world, 1.0 / lever, wheels, with_imu, with_imu / wheels, mean("wheel_imu", "nees"),
            mean("wheel_imu", "nees_of_pieces")]


def _drive(context, world, lever, seed):
    log = context.work / f"imu_{world}_{lever}_{seed}.json"
    command = [workspace_program("slam_eval", PROGRAM),
               "--world", simulation_file("worlds", world),
               "--robot", simulation_file("robots", "skid"), "--seed", seed,
               "--duration", SECONDS, "--lever-scale", lever, "--set", *ROBOT]
    call(context, f"wheels with an IMU, {world}, lever {lever}, seed {seed} of "
         f"{context.options.seeds}", command, log)
    return parse_result(log.read_text(encoding="utf-8"))


def measure(context):
    """The section of this benchmark."""
    rows = [row_of(world, lever, [_drive(context, world, lever, seed)
                                  for seed in range(1, context.options.seeds + 1)])
            for world in WORLDS for lever in LEVERS]
    section = Section("Heading of wheels with an IMU")
    section.paragraphs += [
        table(HEADER, lines_of(rows, FORMS)), verdicts(GOALS, HEADER, rows),
        f"The robot skid, means over {context.options.seeds} seeds, the first {SECONDS} s of each "
        "drive; of heading and gyro the robot file says nothing, so that the defaults count. Drift: "
        "mean over all pieces of 2 m of the true way. NEES: 3 is expected, less is cautious."]
    return section
