# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark vo: drift of visual odometry beside that of the wheels, and its time."""
import json
import math

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import simulation_file, workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import lines_of, mean_row, number, Section, table, verdict
from slam_eval.plot.odometry import plot_odometry

PROGRAM = "slam_eval_vo"
FEATURES = ("orb", "klt", "akaze", "sift")
TIMED_IMAGES = 150
TIME_LIMITS = {"orb": 15.0, "klt": 15.0}  # [ms]
TRANSLATION_LIMIT = 1.0   # [%] of 2 m
ROTATION_LIMIT = 0.1      # [deg/m]
TURN_LIMIT = 1.0          # [%] of the angle turned on the spot
STAND_LIMITS = (0.002, 0.1)  # after a minute [m], [deg]
WRONG_HEIGHT = 1.02       # told over true height of the ceiling
HEIGHT = 1.7              # of the ceiling above the camera of the simulated robots [m]


def run(context, name, scenario, *arguments, features=("orb",), seed=1):
    """Result of one call of the program."""
    options = context.options
    log = context.work / f"vo_{name}.json"
    command = [workspace_program("slam_eval", PROGRAM),
               "--world", options.world or simulation_file("worlds", "office"),
               "--robot", options.robot or simulation_file("robots", "segway"),
               "--scenario", scenario, "--seed", str(seed), "--features", *features,
               "--set", "visual_odometry.alpha_translation=1e-6",
               "visual_odometry.alpha_rotation=1e-7", *arguments]
    call(context, f"visual odometry, {name}", command, log)
    return read_result(log.read_text(encoding="utf-8"))


def read_result(text):
    """The program's JSON. Raises BenchError."""
    try:
        result = json.loads(text)
        if all("features" in entry for entry in result["visual"]) and "wheels" in result:
            return result
    except (json.JSONDecodeError, KeyError, TypeError):
        pass
    raise BenchError(f"{PROGRAM} printed no JSON of drifts; build it again")


def percent(entry, key="translation"):
    """A relative drift in percent, or None."""
    return None if entry.get(key) is None else 100.0 * entry[key]


def degrees(entry, key="rotation_rad_per_m"):
    """A drift of the heading in degrees, or None."""
    return None if entry.get(key) is None else math.degrees(entry[key])


def measure_time(context):
    """Time of an image for each kind of features, accuracy beside it."""
    result = run(context, "time", "drive", "--images", str(TIMED_IMAGES), features=FEATURES)
    rows = [[e["features"], number(e["ms_p50"], ".1f"), number(e["ms_p99"], ".1f"),
             number(percent(e), ".3f"), number(degrees(e), ".4f"), number(e["nees_1"], ".2f"),
             verdict(e["ms_p50"], TIME_LIMITS[e["features"]], True)
             if e["features"] in TIME_LIMITS else "-"] for e in result["visual"]]
    section = Section("Time of an image")
    section.paragraphs += [
        table(["features", "p50 [ms]", "p99 [ms]", "drift [%]", "heading [deg/m]", "NEES/3",
               "goal of p50"], rows),
        f"CPU time of a VGA image, one thread, over {TIMED_IMAGES} images of the drive. NEES/3: "
        "squared error of an increment in units of its covariance, for each degree of freedom; 1 "
        "is right, less is cautious."]
    return section


def drive_rows(results):
    """Rows of numbers: seed, drift and heading of visual odometry, then of the wheels."""
    rows = []
    for seed, result in results.items():
        visual, wheels = result["visual"][0], result["wheels"]
        rows.append([str(seed), percent(visual), degrees(visual), percent(wheels), degrees(wheels),
                     visual["nees_1"], visual["nees_100"]])
    return rows


def measure_drives(context):
    """Drift over pieces of 2 m, seed by seed."""
    seeds = range(1, context.options.seeds + 1)
    results = {seed: run(context, f"seed {seed} of {len(seeds)}", "drive", "--track", seed=seed)
               for seed in seeds}
    rows = drive_rows(results)
    mean = mean_row("mean", rows)
    wrong = run(context, "wrong height", "drive", "--ceiling-height", str(WRONG_HEIGHT * HEIGHT))
    section = Section("Odometry alone in the office")
    forms = [".3f", ".4f", ".2f", ".3f", ".2f", ".2f"]
    better = all(row[1] < row[3] and row[2] < row[4] for row in rows)
    section.paragraphs += [
        table(["seed", "visual [%]", "[deg/m]", "wheels [%]", "[deg/m] ", "NEES/3",
               "of 100 images"],
              lines_of([*rows, mean], forms)),
        "Mean errors over all pieces of 2 m of the true way, features orb.",
        f"- worst translation {max(r[1] for r in rows):.3f} % "
        f"({verdict(max(r[1] for r in rows), TRANSLATION_LIMIT, True)})\n"
        f"- worst rotation {max(r[2] for r in rows):.4f} deg/m "
        f"({verdict(max(r[2] for r in rows), ROTATION_LIMIT, True)})\n"
        f"- better than the wheels on every seed: {'reached' if better else 'MISSED'}\n"
        f"- with the ceiling told {WRONG_HEIGHT - 1:.0%} too high: "
        f"{percent(wrong['visual'][0]):.3f} %, {degrees(wrong['visual'][0]):.4f} deg/m"]
    picture = context.out / "vo_paths.png"
    first = results[1]
    plot_odometry(first["truth"], {"visual odometry": first["visual"][0]["track"],
                                   "wheel odometry": first["wheels"]["track"]}, picture)
    section.pictures["visual and wheel odometry against truth, seed 1"] = picture
    return section


def measure_still(context):
    """Turning on the spot, and standing for a minute."""
    turn = run(context, "turn", "turn", features=("orb", "klt"))["visual"]
    stand = run(context, "stand", "stand", features=("orb", "klt"))["visual"]
    rows = [[t["features"], number(percent(t, "turning"), ".3f"),
             verdict(percent(t, "turning"), TURN_LIMIT, True), number(1e3 * s["end_m"], ".2f"),
             number(math.degrees(s["end_rad"]), ".4f"),
             "reached" if s["end_m"] <= STAND_LIMITS[0] and
             math.degrees(s["end_rad"]) <= STAND_LIMITS[1] else "MISSED"]
            for t, s in zip(turn, stand)]
    section = Section("Turning on the spot and standing")
    section.paragraphs += [
        table(["features", "turn [%]", "goal", "after 60 s [mm]", "[deg]",
               f"<= {1e3 * STAND_LIMITS[0]:g} mm, {STAND_LIMITS[1]:g} deg"], rows),
        "Turn: mean error over quarter turns relative to the angle. Standing: where the odometry "
        "says it is after a minute."]
    return section
