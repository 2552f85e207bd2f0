# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part scan of benchmark grid: time of one scan and memory against particles, threads, beams and
size of the map."""
import dataclasses
import re

from slam_eval.bench.harness.google import list_cases, parse_figures, run_case
from slam_eval.bench.harness.table import Section, number, table

PROGRAM = "slam_eval_grid_update"
CORRIDOR_AREA = 3.5  # of a metre of corridor with its niches [m^2]
_NAME = re.compile(r"/particles:(\d+)/threads:(\d+)/beams:(\d+)/metres:(\d+)")
_NAMES = ("particles", "threads", "beams", "metres")
BASE = {"particles": 30, "threads": 1, "beams": 180, "metres": 50}


@dataclasses.dataclass
class Case:
    """Wall and CPU time of a scan [ms], peak memory [MB]."""

    size: dict
    wall_ms: float
    cpu_ms: float
    max_rss_mb: float


def parse_cases(text):
    """The sizes of the benchmarks in a list of names, by the names of their numbers."""
    return [dict(zip(_NAMES, map(int, match.groups()))) for match in _NAME.finditer(text)]


def _run(context, size):
    name = "/".join(f"{key}:{value}" for key, value in size.items())
    text, usage = run_case(context, PROGRAM, f"{name}/", f"time of a scan, {name}",
                           "_".join(map(str, size.values())))
    return Case(size, *parse_figures(text, PROGRAM, ("real_time", "cpu_time")), usage.max_rss_mb)


def against(cases, varied):
    """The cases in which only one number differs from BASE, by that number."""
    chosen = [case for case in cases if all(case.size[name] == BASE[name]
                                            for name in _NAMES if name != varied)]
    return sorted(chosen, key=lambda case: case.size[varied])


def _table(cases, varied):
    """Lines against one number."""
    header = [varied, "a scan [ms]", "CPU [ms]", "memory [MB]", "area [m2]"]
    lines = [[str(case.size[varied]), f"{case.wall_ms:.2f}", f"{case.cpu_ms:.2f}",
              f"{case.max_rss_mb:.0f}",
              number(CORRIDOR_AREA * case.size["metres"] if varied == "metres" else None, ".0f")]
             for case in against(cases, varied)]
    return table(header, lines)


def measure(context):
    """The section of this part."""
    cases = [_run(context, size) for size in list_cases(context, PROGRAM, parse_cases)]
    section = Section("Time of one scan")
    section.paragraphs += [_table(cases, varied) for varied in _NAMES]
    section.paragraphs.append(
        "One number varies, the others are "
        + ", ".join(f"{value} {name}" for name, value in BASE.items())
        + ". A corridor of so many metres is mapped before; every scan is used, 0.1 m after the "
        "last. CPU: of all threads. Memory: the peak of the process.")
    return section
