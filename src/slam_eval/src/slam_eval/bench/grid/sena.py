# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part sena of benchmark grid: the real loop of MRPT's robot SENA, beside rbpf-slam."""
import pathlib
import shutil

import numpy as np

from slam_eval.bench.harness.products import PF_WHEEL_GRID
from slam_eval.bench.harness.runs import import_log, run_ours
from slam_eval.bench.harness.table import lines_of, Section, table
from slam_eval.bench.peers.rbpf_slam import map_picture, particles_of, run_rbpf_slam
from slam_eval.geometry import se2
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import evaluate
from slam_eval.plot.map import plot_map

LOG = pathlib.Path("/usr/share/mrpt/datasets/"
                   "2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog")
SHIPPED = "gridmapping_optimal_sampling.ini"  # MRPT's configuration for this log

HEADER = ["system", "particles", "scans", "CPU [s]", "wall [s]", "memory [MB]",
          "dead reckoning off at the end [m]"]
FORMS = ["d", "d", ".2f", ".2f", ".0f", ".2f"]


def odometry_error(run):
    """How far [m] dead reckoning is from the estimate at the end, both from the same start."""
    if run.odometry is None:
        return None
    start = se2.compose(run.trajectory.poses[0], se2.inverse(run.odometry.poses[0]))
    end = se2.compose(start, run.odometry.poses[-1])
    return float(np.linalg.norm(end[:2] - run.trajectory.poses[-1, :2]))


def _ours(context, section):
    bag = import_log(context, "sena", ["rawlog", LOG])
    folder, usage = run_ours(context, "sena", bag, product=PF_WHEEL_GRID)
    run = read_run(folder)
    path = context.out / "sena_map.png"
    plot_map(run, evaluate(run), path)
    section.pictures["our map of the loop"] = path
    particles = run.config.get("pf", {}).get("particles")
    return [PF_WHEEL_GRID, particles, len(run.trajectory), usage.cpu_s, usage.wall_s,
            usage.max_rss_mb, odometry_error(run)]


def _theirs(context, section):
    done = run_rbpf_slam(context, "sena", SHIPPED, LOG)
    if done is None:
        return []
    folder, usage = done
    picture = map_picture(folder)
    if picture is not None:
        path = context.out / "sena_rbpf_slam.png"
        shutil.copyfile(picture, path)
        section.pictures["the map of rbpf-slam"] = path
    return [["rbpf-slam", particles_of(folder), None, usage.cpu_s, usage.wall_s, usage.max_rss_mb,
             None]]


def measure(context):
    """The section of this part."""
    section = Section("SENA, one loop")
    if not LOG.is_file():
        section.paragraphs.append(f"Left out: there is no {LOG}; install mrpt-common.")
        return section
    rows = [_ours(context, section), *_theirs(context, section)]
    section.paragraphs += [
        table(HEADER, lines_of(rows, FORMS)),
        f"A real robot, 59 s, without truth. rbpf-slam with the configuration {SHIPPED} that MRPT "
        "ships for this log, windows and pictures on the way left out; it looks at a scan for each "
        "metre, ours for each 0.3 m."]
    return section
