# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program that solves a graph at every pose, and draws what it made."""
import json

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.plot.pose_graph import plot_graph

PROGRAM = "slam_eval_graph"
_NUMBERS = ("poses", "edges", "cpu_s", "mean_ms", "p99_ms", "worst_ms", "memory_mb", "chi2")
_LISTS = ("trajectory", "loop_edges", "steps_ms", "truth")
_BATCHES = ("ceres", "ceres_from_result")


def parse_report(text):
    """The program's JSON. Raises BenchError."""
    try:
        report = json.loads(text)
        is_whole = (all(isinstance(report[key], (int, float)) for key in _NUMBERS)
                    and all(isinstance(report[key], list) for key in _LISTS)
                    and all({"chi2", "cpu_s", "has_converged"} <= set(report[key])
                            for key in _BATCHES)
                    and len(report["trajectory"]) == len(report["steps_ms"])
                    and isinstance(report["name"], str) and isinstance(report["left_out"], dict))
        if is_whole:
            return report
    except (json.JSONDecodeError, KeyError, TypeError):
        pass
    raise BenchError(f"{PROGRAM} printed no JSON of a graph; build it again")


def last_line(path):
    """The last line of a program's log, which says how far it is; empty where there is none."""
    try:
        lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return ""
    return lines[-1].strip() if lines else ""


def solve(context, name, arguments, label):
    """What the program printed of a graph. name: of the log; label: of the task."""
    log = context.work / f"graph_{name}.json"
    errors = log.with_name(log.name + ".err")
    command = [workspace_program("slam_eval", PROGRAM), *arguments, "--detail"]
    call(context, f"{label}: solved at every pose", command, log, state=lambda: last_line(errors))
    return parse_report(log.read_text(encoding="utf-8"))


def draw(context, name, report, section):
    """The picture of a graph, into the section."""
    path = context.out / f"graph_{name}.png"
    plot_graph(report, path)
    section.pictures[f"{report['name']}: poses and loops, time of each step"] = path
