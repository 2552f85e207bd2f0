# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark fiducial: time of the detectors beside the bare libraries, and what they detect."""
import json

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import Section, number, table, verdict
from slam_eval.plot.detection import plot_detection_rates

PROGRAM = "slam_eval_fiducial"
TIME_LIMIT = 1.10   # of the bare call
RANGE_LIMIT = 0.01  # mean error of the range over the range
RANGES = (0.5, 4.0)  # [m], where the goal holds

TIMING = ["detector", "setting", "image", "ours [ms]", "bare call [ms]", "ratio", "goal"]


def read_result(text):
    """(timing, detection) of the program's JSON: lists of dictionaries."""
    try:
        result = json.loads(text)
        for entry in result["timing"]:
            entry["ratio"] = entry["ours_ms"] / entry["bare_ms"]
        for entry in result["detection"]:
            entry["rate"] = entry["detected"] / entry["trials"]
        return result["timing"], result["detection"]
    except (json.JSONDecodeError, KeyError, TypeError, ZeroDivisionError):
        raise BenchError(f"{PROGRAM} printed no JSON of times and detections; build it "
                         "again") from None


def timing_table(timing):
    """Time per frame of ours and of the bare library."""
    return table(TIMING, [[e["detector"], e.get("setting", "-"), e.get("image", "-"),
                           number(e["ours_ms"], ".2f"), number(e["bare_ms"], ".2f"),
                           number(e["ratio"], ".3f"), verdict(e["ratio"], TIME_LIMIT, True)]
                          for e in timing])


def detectors(entries):
    """Names of the detectors, each once, in their order."""
    return list(dict.fromkeys(entry["detector"] for entry in entries))


def grid(entries, key):
    """(distances, obliquenesses, values[obliqueness][distance]) of one detector's entries."""
    distances = sorted({entry["distance_m"] for entry in entries})
    angles = sorted({entry["obliqueness_deg"] for entry in entries})
    cells = {(entry["obliqueness_deg"], entry["distance_m"]): entry.get(key) for entry in entries}
    return distances, angles, [[cells.get((a, d)) for d in distances] for a in angles]


def rate_table(entries):
    """Detection rate against distance and obliqueness."""
    distances, angles, rates = grid(entries, "rate")
    return table(["obliqueness", *(f"{d:g} m" for d in distances)],
                 [[f"{a:g} deg", *(number(rate, ".0%") for rate in row)]
                  for a, row in zip(angles, rates)])


def bias_sentence(name, entries):
    """The largest mean error of the range in the distances of the goal."""
    biases = [abs(e["range_bias"]) for e in entries
              if e.get("range_bias") is not None and RANGES[0] <= e["distance_m"] <= RANGES[1]]
    if not biases:
        return f"{name}: no marker detected."
    return (f"{name}: largest mean error of the range from {RANGES[0]:g} to {RANGES[1]:g} m "
            f"{max(biases):.2%} ({verdict(max(biases), RANGE_LIMIT, True)}).")


def measure(context):
    """The section of this benchmark."""
    log = context.work / "fiducial.json"
    command = [workspace_program("slam_eval", PROGRAM)]
    if context.options.image is not None:
        command += ["--image", context.options.image]
    call(context, "fiducial detectors", command, log)
    timing, detection = read_result(log.read_text(encoding="utf-8"))
    section = Section("Time of a frame")
    section.paragraphs += [timing_table(timing),
                           "CPU time, one thread. Ours: from the grey image to the array of "
                           "observations."]
    for name in detectors(detection):
        entries = [entry for entry in detection if entry["detector"] == name]
        section.paragraphs += [f"## What {name} detects", rate_table(entries),
                               bias_sentence(name, entries)]
    if detection:
        path = context.out / "fiducial_detection.png"
        plot_detection_rates({name: grid([e for e in detection if e["detector"] == name], "rate")
                              for name in detectors(detection)}, path)
        section.pictures["detection rate against distance and obliqueness"] = path
    return section
