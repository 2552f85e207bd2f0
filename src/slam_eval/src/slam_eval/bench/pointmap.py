# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark pointmap: what a scan into a point map costs, and what the fusion policies make of the
walls of the simulated office."""
import re

from slam_eval.bench.harness.google import list_cases, parse_figures, run_case
from slam_eval.bench.harness.programs import simulation_file
from slam_eval.bench.harness.runs import run_ours, simulate
from slam_eval.bench.harness.table import (
    lines_of, mean_row, number, Section, table, verdict)
from slam_eval.io.run_folder import read_run
from slam_eval.io.world_plan import read_world
from slam_eval.metrics.evaluation import evaluate
from slam_eval.metrics.map_agreement import judge_map
from slam_eval.plot.map import plot_map

PROGRAM = "slam_eval_pointmap"
PRODUCT = "ekf_wheel_pointmap"
SENSORS = "odom,scan,camera"
FUSIONS = ("euclidean", "aligned")
TIME_GOAL = (100000, 2.0)  # points, ms
_NAME = re.compile(r"scanOfPointMap/(\w+)/points:(\d+)")

HEADER = ["seed", "ATE [m]", *(f"{what}, {fusion}" for what in ("thickness [m]", "off walls [m]",
                                                                "points") for fusion in FUSIONS)]
FORMS = [".4f", ".4f", ".4f", ".4f", ".4f", ".0f", ".0f"]


def parse_cases(text):
    """(fusion, points) of the benchmarks in a list of names."""
    return [(match.group(1), int(match.group(2))) for match in _NAME.finditer(text)]


def _run(context, fusion, points):
    text, usage = run_case(context, PROGRAM, f"scanOfPointMap/{fusion}/points:{points}/",
                           f"time of a scan, {fusion}, {points} points", f"{fusion}_{points}")
    return *parse_figures(text, PROGRAM, ("cpu_time",)), usage.max_rss_mb


def time_verdicts(times):
    """A line for each fusion; times: CPU time [ms] by (fusion, points)."""
    return "\n".join(f"- {fusion}, {TIME_GOAL[0]} points: {times[fusion, TIME_GOAL[0]]:.2f} ms "
                     f"({verdict(times[fusion, TIME_GOAL[0]], TIME_GOAL[1], True)})"
                     for fusion in FUSIONS if (fusion, TIME_GOAL[0]) in times)


def measure_scan(context):
    """The section of part scan."""
    cases = list_cases(context, PROGRAM, parse_cases)
    done = {case: _run(context, *case) for case in cases}
    times = {case: time for case, (time, _) in done.items()}
    lines = [[str(points), *(number(times.get((fusion, points)), ".3f") for fusion in FUSIONS),
              number(done.get((FUSIONS[0], points), (None, None))[1], ".0f")]
             for points in sorted({points for _, points in cases})]
    section = Section("Time of one scan into a point map")
    section.paragraphs += [
        table(["points", *(f"{fusion} [ms]" for fusion in FUSIONS), "memory [MB]"], lines),
        time_verdicts(times),
        "CPU time of a scan of 682 beams through a corridor that is mapped already."]
    return section


def _office_seed(context, seed, section):
    name = f"pointmap_office_{seed}"
    bag = simulate(context, name, "office", seed, SENSORS)
    path = simulation_file("worlds", "office")
    world, found, ate = read_world(path), {}, None
    for fusion in FUSIONS:
        folder, _ = run_ours(context, f"{name}_{fusion}", bag, product=PRODUCT,
                             settings=(f"point_map.fusion={fusion}",))
        run = read_run(folder)
        result = evaluate(run, agreement=judge_map(run, world, path))
        found[fusion], ate = result.metrics, result.metrics.get("ate_rmse_m")
        if seed == 1:
            picture = context.out / f"pointmap_office_{fusion}.png"
            plot_map(run, result, picture, world=world)
            section.pictures[f"points of the office, {fusion}, seed 1"] = picture
    keys = ("points_wall_thickness_m", "points_wall_error_m", "points")
    return [str(seed), ate, *(found[fusion].get(key) for key in keys for fusion in FUSIONS)]


def measure_office(context):
    """The section of part office."""
    section = Section("Walls of the simulated office")
    rows = [_office_seed(context, seed, section) for seed in range(1, context.options.seeds + 1)]
    section.paragraphs += [
        table(HEADER, lines_of([*rows, mean_row("mean", rows)], FORMS)),
        "Thickness: width of the band across a wall that holds the middle 90 % of its points. Off "
        "walls: root mean square distance of the points from the true walls, the map moved onto "
        "the truth by a rigid fit of its path."]
    return section
