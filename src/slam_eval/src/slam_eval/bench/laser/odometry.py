# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part odometry of benchmark laser: laser odometry by itself on simulated drives."""
import json
import math

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.goals import Goal, verdicts
from slam_eval.bench.harness.programs import simulation_file, workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import lines_of, Section, table

PROGRAM = "slam_eval_laser_odometry"
WORLDS = ("office", "corridor")
RATE = 40      # [Hz]
SECONDS = 120  # of a drive, at most
# What the robot file of the simulated robot says of its laser and its wheels.
ROBOT = ("laser.relative_sigma=0.01", "wheel_odometry.drive=differential",
         "wheel_odometry.alpha1=1e-4", "wheel_odometry.alpha2=2e-5",
         "wheel_odometry.alpha3=2e-3", "wheel_odometry.alpha4=2.5e-3")

HEADER = ["odometry", "world", "seed", "scans", "mean [ms]", "p99 [ms]", "max [ms]", "drift [%]",
          "heading [deg/m]", "NEES"]
FORMS = ["s", "d", "d", ".2f", ".2f", ".2f", ".2f", ".3f", ".2f"]
GOALS = (Goal("mean [ms]", 2.0), Goal("p99 [ms]", 5.0))


def parse_result(text):
    """The program's JSON. Raises BenchError."""
    keys = ("name", "ms_mean", "ms_p99", "ms_max")
    try:
        result = json.loads(text)
        if result["scans"] > 0 and all(key in entry for entry in result["odometry"]
                                       for key in keys):
            return result
    except (json.JSONDecodeError, KeyError, TypeError):
        pass
    raise BenchError(f"{PROGRAM} printed no JSON of times; build it again")


def rows_of(result, seed):
    """The lines of a drive."""
    return [[entry["name"], result["world"], seed, result["scans"], entry["ms_mean"],
             entry["ms_p99"], entry["ms_max"],
             100.0 * entry["translation"] if "translation" in entry else None,
             math.degrees(entry["rotation_rad_per_m"]) if "rotation_rad_per_m" in entry else None,
             entry.get("nees")] for entry in result["odometry"]]


def _drive(context, world, seed):
    log = context.work / f"laser_odometry_{world}_{seed}.json"
    command = [workspace_program("slam_eval", PROGRAM),
               "--world", simulation_file("worlds", world),
               "--robot", simulation_file("robots", "segway"), "--seed", seed, "--rate", RATE,
               "--duration", SECONDS, "--set", *ROBOT]
    call(context, f"laser odometry, {world}, seed {seed} of {context.options.seeds}", command, log)
    return rows_of(parse_result(log.read_text(encoding="utf-8")), seed)


def measure(context):
    """The section of this part."""
    rows = [row for world in WORLDS for seed in range(1, context.options.seeds + 1)
            for row in _drive(context, world, seed)]
    section = Section("Laser odometry alone")
    section.paragraphs += [
        table(HEADER, lines_of(sorted(rows, key=lambda row: row[0]), FORMS)),
        verdicts(GOALS, HEADER, rows),
        f"CPU time of a scan of 682 beams at {RATE} Hz, one thread, in the first {SECONDS} s of a "
        "drive at most. Drift: mean over all pieces of 2 m of the true way. NEES of the increments: "
        "3 is expected, less is cautious."]
    return section
