# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part update: time of an update against the size of the map, and of the global update apart."""
import dataclasses
import json
import re

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.google import list_cases, run_case
from slam_eval.bench.harness.table import Section, number, table
from slam_eval.plot.benchmarks import plot_updates

PROGRAM = "slam_eval_backend_update"
_NAME = re.compile(r"(\w+)/landmarks:(\d+)(?:/observations:(\d+))?")
_MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}
_FILTERS = {"updateOfUnscentedFilter": ", unscented"}
_WHOLE_MAP = {"globalUpdateOfEkf": "global update", "marginalsOfEkf": "all marginals"}


@dataclasses.dataclass
class Size:
    """Times [ms, CPU] by what was measured, and peak memory [MB]."""

    landmarks: int
    times: dict
    max_rss_mb: float


def parse_sizes(text):
    """Numbers of landmarks in a list of benchmark names, rising."""
    return sorted({int(match.group(2)) for match in _NAME.finditer(text)})


def _task(match):
    """What a benchmark measures, as the head of a column."""
    if match.group(3) is None:
        return _WHOLE_MAP.get(match.group(1), match.group(1))
    count = int(match.group(3))
    return f"{count} observation{'s' * (count > 1)}{_FILTERS.get(match.group(1), '')}"


def parse_times(text):
    """CPU time [ms] by what was measured, from the benchmark's JSON."""
    times = {}
    try:
        for entry in json.loads(text)["benchmarks"]:
            match = _NAME.search(entry["name"])
            if match and not entry.get("error_occurred"):
                times[_task(match)] = entry["cpu_time"] * _MILLISECONDS[entry["time_unit"]]
    except (json.JSONDecodeError, KeyError, TypeError):
        raise BenchError(f"{PROGRAM} printed no JSON of Google Benchmark; build it "
                         "again") from None
    return times


def _run(context, landmarks):
    text, usage = run_case(context, PROGRAM, f"landmarks:{landmarks}(/|$)",
                           f"time of an update, {landmarks} landmarks", landmarks)
    return Size(landmarks, parse_times(text), usage.max_rss_mb)


def rows(sizes):
    """(header, lines) of the table, columns in the order in which they were measured."""
    tasks = list(dict.fromkeys(task for size in sizes for task in size.times))
    header = ["landmarks", *(f"{task} [ms]" for task in tasks), "memory [MB]"]
    lines = [[str(size.landmarks), *(number(size.times.get(task), ".3f") for task in tasks),
              number(size.max_rss_mb, ".1f")] for size in sizes]
    return header, lines


def measure(context):
    """The section of this part."""
    sizes = [_run(context, landmarks)
             for landmarks in list_cases(context, PROGRAM, parse_sizes)]
    if not any(size.times for size in sizes):
        raise BenchError(f"{PROGRAM} has no benchmark of landmarks and observations; "
                         "build it again")
    section = Section("Time of one update")
    section.paragraphs += [
        table(*rows(sizes)),
        "CPU time of one step (prediction, then all observations jointly) in a map of so many "
        "landmarks, while the robot stays among 60 of them, by the extended and by the unscented "
        "filter; of the global update when it leaves them; and of a look at the marginals of all "
        "landmarks without it. Memory: peak of a process that holds that map."]
    path = context.out / "update_time.png"
    plot_updates(sizes, path)
    section.pictures["time of an update against landmarks"] = path
    return section
