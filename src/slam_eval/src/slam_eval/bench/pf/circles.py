# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part circles of benchmark pf: both back-ends on DLR's circles, half a kilometre of loops."""
import numpy as np

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import data_folder
from slam_eval.bench.harness.runs import import_log, run_ours
from slam_eval.bench.harness.table import lines_of, Section, table
from slam_eval.bench.pf.variants import DEFAULT, EKF
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import evaluate
from slam_eval.metrics.loop_consistency import consistency, map_by_odometry
from slam_eval.plot.map import plot_map

GAP = 200  # steps of 0.15 m between first sights, from which on a loop lies between them

HEADER = ["map", "steps", "landmarks", "of", "near: median [m]", "RMS", "across loops: median [m]",
          "RMS", "NIS/dof", "gated", "CPU [s]"]
FORMS = ["d", "d", "d", ".3f", ".3f", ".3f", ".3f", ".3f", "d", ".1f"]


def read_bag(bag):
    """What the log holds: the sights {id: (x, y)} of its steps, and the poses of dead reckoning."""
    import rosbag  # takes a while, and few benchmarks need it
    sights, poses = [], []
    with rosbag.Bag(str(bag)) as log:
        for topic, message, _ in log.read_messages(["/observations", "/motion"]):
            if topic == "/motion":
                end = message.odometry_end
                poses.append((end.x, end.y, end.theta))
                continue
            sights.append({z.id: (z.range * np.cos(z.bearing), z.range * np.sin(z.bearing))
                           for z in message.observations if z.id >= 0})
    return sights, poses


def _line(name, steps, positions, sights, run=None, usage=None):
    c = consistency(sights, positions, GAP)
    there = len(set().union(*sights))
    nis = evaluate(run).metrics.get("nis_mean") if run else None
    gated = int(run.updates.counts["gated"].sum()) if run and run.updates else None
    values = [steps, len(positions), there, c.near.median, c.near.rms, c.seam.median, c.seam.rms,
              nis, gated, usage.cpu_s if usage else None]
    return [name, *values], c


def run_backend(context, variant, bag, sights, section):
    """Run a back-end on the log; its line, and the picture of its map into the section."""
    folder, usage = run_ours(context, variant.run_name("circles"), bag, "circles", variant.product,
                             variant.settings)
    run = read_run(folder)
    if run.landmarks is None or not len(run.landmarks.ids):
        raise BenchError(f"{variant.name} made no map of {bag}: does the log hold landmarks with "
                         "ids?")
    path = context.out / f"circles_{variant.product}.png"
    plot_map(run, evaluate(run), path)
    section.pictures[f"map of {variant.name}"] = path
    positions = dict(zip(run.landmarks.ids, run.landmarks.positions))
    return _line(variant.name, len(run.trajectory), positions, sights, run, usage)[0]


def measure(context):
    """The section of this part."""
    section = Section("Loops: circles on a floor")
    file = (context.options.circles or data_folder("circles") / "map.circles")
    if not file.is_file():
        section.paragraphs.append(f"Left out: there is no file {file} of the DLR data set "
                                  "(--circles FILE or $SLAM_DATA_DIR name another one).")
        return section
    bag = import_log(context, "circles", ["circles", file])
    sights, poses = read_bag(bag)
    line, c = _line("dead reckoning", len(poses), map_by_odometry(sights, poses), sights)
    lines = [line, *(run_backend(context, variant, bag, sights, section)
                     for variant in (EKF, DEFAULT))]
    section.paragraphs += [
        table(HEADER, lines_of(lines, FORMS)),
        "Error of the distance between two landmarks in the map, against the distance at which "
        f"they were seen together: {c.near.pairs} pairs first seen within {GAP} steps, and "
        f"{c.seam.pairs} with a loop between their first sights. The log has no truth."]
    return section
