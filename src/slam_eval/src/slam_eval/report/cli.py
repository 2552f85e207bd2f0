# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program behind `./slam eval DIR`."""
import argparse
import dataclasses
import json
import pathlib

from slam_eval.io.atomic_file import write_atomically
from slam_eval.io.bag_poses import DEFAULT_TOPIC, read_bag_poses
from slam_eval.io.errors import exit_code_of, InputError
from slam_eval.io.run_folder import read_run
from slam_eval.io.trajectory import LONGEST_GAP, NANOSECONDS, read_truth
from slam_eval.io.world_plan import read_world
from slam_eval.metrics.evaluation import evaluate
from slam_eval.metrics.honesty import frame_of_map
from slam_eval.metrics.map_agreement import judge_map
from slam_eval.metrics.relations import judge_run, TOLERANCE
from slam_eval.plot.consistency import plot_consistency
from slam_eval.plot.graph import plot_graph
from slam_eval.plot.landmark_errors import plot_landmark_errors
from slam_eval.plot.map import plot_map, plot_trajectory
from slam_eval.plot.odometry import plot_beside_wheels
from slam_eval.plot.relations import plot_relations
from slam_eval.plot.seen import plot_seen
from slam_eval.report.metric_table import merge, terminal_table
from slam_eval.report.run_report import render

MOST_TOLERANCE = 10.0  # [s]; beyond it any scan would do


def missing_parts(run, result):
    """A sentence for each figure that the run has not the files for."""
    notes = []
    if run.truth is None:
        notes.append("The run has no ground truth of the poses (ground_truth.tum): no trajectory "
                     "error and no NEES.")
    elif result.ate is None:
        between = ("poses of the run lie between true poses" if run.truth.has_heading else
                   "true positions lie between poses of the run")
        notes.append(f"Fewer than two {between} that are at most {LONGEST_GAP:g} s apart: no "
                     "trajectory error and no NEES.")
    if run.landmarks is not None and run.maps_ceiling:
        notes.append("The landmarks of the run are spots of the ceiling, of which there is no "
                     "ground truth: no landmark error.")
    elif run.landmarks is not None and run.true_landmarks is None:
        notes.append("The run has no ground truth of the landmarks (ground_truth_landmarks.yaml): "
                     "no landmark error.")
    elif run.landmarks is not None and run.landmarks.has_own_ids:
        notes.append("The run has associated landmarks by position, so that their ids are not those "
                     "of ground truth: no landmark error.")
    elif run.landmarks is not None and result.landmark_error is None:
        notes.append("Fewer than two landmarks have an id that ground truth has too: no landmark "
                     "error.")
    if run.updates is None:
        notes.append("The run has no updates.csv: no NEES and no NIS.")
    return notes


def missing_relations(errors):
    """A sentence where the run has not all that the relations are about."""
    if errors is None or errors.missing == 0:
        return []
    total = len(errors.translation) + errors.missing
    return [f"{errors.missing} of {total} relations were left out: the run has no pose at their "
            "stamps, or no scan has them within the --tolerance."]


def draw(run, result, reference, world):
    """Write the pictures the run allows; returns their paths."""
    pictures = []
    if run.landmarks is not None or run.grid is not None or run.points is not None:
        pictures.append(run.path / "map.png")
        plot_map(run, result, pictures[-1], reference, world)
    pictures.append(run.path / "trajectory.png")
    plot_trajectory(run, result, pictures[-1], reference, world)
    if plot_beside_wheels(run, result, run.path / "odometry.png", reference, world):
        pictures.append(run.path / "odometry.png")
    for plot, name in ((plot_graph, "graph.png"), (plot_landmark_errors, "landmark_errors.png"),
                       (plot_consistency, "consistency.png"), (plot_seen, "seen.png")):
        if plot(run, result, run.path / name):
            pictures.append(run.path / name)
    if result.relations is not None:
        pictures.append(run.path / "relations.png")
        plot_relations(run.title, result.relations, pictures[-1])
    return pictures


def frame_of_run(folder):
    """T_truth_map of the map that a run has made. Raises InputError."""
    run = read_run(folder)
    T_truth_map = run.truth and frame_of_map(run.trajectory, run.truth)
    if T_truth_map is None:
        raise InputError(f"{folder}: this run has no true poses with headings "
                         "(ground_truth.tum), so that nobody knows where its map lies; name the run "
                         "that made the map, of a bag with ground truth")
    return T_truth_map


def evaluate_folder(folder, reference="ground truth", world_file=None, judge_relations=None,
                    truth=None, map_run=None):
    """Evaluate a run folder: metrics.json, pictures, report and a table on stdout.

    judge_relations returns the RelationErrors of a run; truth: true poses instead of the run's own;
    map_run: folder of the run that made the map which this one has loaded.
    """
    run = read_run(folder)
    if truth is not None:
        run.truth, run.truth_is_given = truth, True
    if map_run is not None and run.truth is not None:
        run.truth = dataclasses.replace(run.truth, T_truth_map=frame_of_run(map_run))
    world = read_world(world_file) if world_file else None
    relations = judge_relations(run) if judge_relations else None
    result = evaluate(run, relations, judge_map(run, world, world_file))
    metrics = merge(run.metrics, result.metrics)
    notes = missing_parts(run, result) + missing_relations(relations)
    pictures = draw(run, result, reference, world)
    write_atomically(run.path / "metrics.json", json.dumps(metrics, indent=2) + "\n")
    write_atomically(run.path / "report.html", render(run, metrics, pictures, notes, relations))
    print(run.title)
    print(terminal_table(metrics))
    for note in notes:
        print(f"  ({note})")
    print(f"report: {run.path / 'report.html'}")


def seconds(text):
    """The positive number [s] that an argument gives, in nanoseconds."""
    value = float(text)
    if not 0 < value <= MOST_TOLERANCE:
        raise ValueError
    return round(value * NANOSECONDS)


def relation_judge(options):
    """What holds a run against the relations that the options name."""
    return lambda run: judge_run(run, options.relations, options.stamps,
                                 options.tolerance or TOLERANCE)


def given_truth(options):
    """The true poses that the options name, or None. Raises InputError."""
    if options.truth is None:
        return None
    if options.truth.suffix != ".bag":
        return read_truth(options.truth)
    return read_bag_poses(options.truth, options.truth_topic or DEFAULT_TOPIC, options.truth_frame)


def require_together(parser, options):
    """Refuses options that go with another one."""
    for option, other in (("stamps", "relations"), ("tolerance", "relations"),
                          ("truth_topic", "truth"), ("truth_frame", "truth")):
        if getattr(options, option) and not getattr(options, other):
            parser.error(f"--{option.replace('_', '-')} goes with --{other}")
    if (options.truth_topic or options.truth_frame) and options.truth.suffix != ".bag":
        parser.error("--truth-topic and --truth-frame go with a bag")


def main(arguments=None):
    """Entry point: exit code 0 done, 1 the evaluation failed, 2 wrong use."""
    parser = argparse.ArgumentParser(
        prog="slam_eval", description="Adds error figures, pictures and a report to a run.")
    parser.add_argument("folder", metavar="DIR", type=pathlib.Path,
                        help="folder that a run wrote (with trajectory.tum)")
    parser.add_argument("--reference-title", default="ground truth", metavar="TEXT",
                        help="what the reference is called in the pictures (%(default)s)")
    parser.add_argument("--world", metavar="FILE", type=pathlib.Path,
                        help="world file of the simulation: its walls are drawn behind the map")
    parser.add_argument("--relations", metavar="FILE", type=pathlib.Path,
                        help="reference relations between poses of the log (Kuemmerle et al. 2009)")
    parser.add_argument("--stamps", metavar="FILE", type=pathlib.Path,
                        help="table of the stamps that the log had; default: stamps.csv of the run")
    parser.add_argument("--tolerance", metavar="SECONDS", type=seconds,
                        help="largest difference between a relation's stamp and its scan's; "
                        "default: 0.01, as logs round")
    parser.add_argument("--truth", metavar="FILE", type=pathlib.Path,
                        help="true poses instead of the run's own: lines 'stamp tx ty tz qx qy qz qw', "
                        "or a bag")
    parser.add_argument("--truth-topic", metavar="TOPIC",
                        help="of that bag: odometry, poses, points, a path or transforms; default: "
                        + DEFAULT_TOPIC)
    parser.add_argument("--truth-frame", metavar="FRAME",
                        help="of transforms the robot's frame, as a child")
    parser.add_argument("--map-run", metavar="DIR", type=pathlib.Path,
                        help="run that made the map which this one has loaded: errors that are not "
                        "aligned, NEES and 'confidently wrong' are those in this map, and not from "
                        "the first pose on")
    options = parser.parse_args(arguments)
    require_together(parser, options)
    judge = relation_judge(options) if options.relations else None
    return exit_code_of("slam_eval", lambda: evaluate_folder(
        options.folder, options.reference_title, options.world, judge, given_truth(options),
        options.map_run), options.folder)
