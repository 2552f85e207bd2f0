# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part update of benchmark pf: time of one update against particles and size of the map."""
import dataclasses
import re

from slam_eval.bench.harness.google import list_cases, parse_figures, run_case
from slam_eval.bench.harness.table import Section, number, table, verdict

PROGRAM = "slam_eval_pf_update"
FIGURES = ("cpu_time", "resampled")
_NAME = re.compile(r"/particles:(\d+)/landmarks:(\d+)")
UPDATES_GOAL = (100, 1000, 100.0)  # particles, landmarks, updates a second
MEMORY_GOAL = (1000, 1000, 300.0)  # particles, landmarks, MB


@dataclasses.dataclass
class Size:
    """Time of an update [ms, CPU], share of the steps that resampled, and peak memory [MB]."""

    particles: int
    landmarks: int
    time_ms: float
    resampled: float
    max_rss_mb: float


def parse_sizes(text):
    """(particles, landmarks) of the benchmarks in a list of names, rising."""
    return sorted({(int(m.group(1)), int(m.group(2))) for m in _NAME.finditer(text)})


def _run(context, particles, landmarks):
    text, usage = run_case(context, PROGRAM, f"particles:{particles}/landmarks:{landmarks}$",
                           f"time of an update, {particles} particles, {landmarks} landmarks",
                           f"{particles}_{landmarks}")
    return Size(particles, landmarks, *parse_figures(text, PROGRAM, FIGURES), usage.max_rss_mb)


def _matrix(sizes, form, value):
    """Table of one figure: a line for each number of particles."""
    landmarks = sorted({size.landmarks for size in sizes})
    header = ["particles", *(f"{n} landmarks" for n in landmarks)]
    lines = []
    for particles in sorted({size.particles for size in sizes}):
        of = {size.landmarks: value(size) for size in sizes if size.particles == particles}
        lines.append([str(particles), *(number(of.get(n), form) for n in landmarks)])
    return table(header, lines)


def verdicts(sizes):
    """A line for each goal whose size was measured."""
    of = {(size.particles, size.landmarks): size for size in sizes}
    lines = []
    if UPDATES_GOAL[:2] in of:
        rate = 1e3 / of[UPDATES_GOAL[:2]].time_ms
        lines.append(f"- {UPDATES_GOAL[0]} particles, {UPDATES_GOAL[1]} landmarks: {rate:.0f} "
                     f"updates a second ({verdict(rate, UPDATES_GOAL[2], False)})")
    if MEMORY_GOAL[:2] in of:
        memory = of[MEMORY_GOAL[:2]].max_rss_mb
        lines.append(f"- {MEMORY_GOAL[0]} particles, {MEMORY_GOAL[1]} landmarks: {memory:.0f} MB "
                     f"({verdict(memory, MEMORY_GOAL[2], True)})")
    return "\n".join([*lines, *_growth(of)])


def _growth(of):
    """A line for each direction in which the time may grow."""
    def line(few, many, what, limit):
        if few not in of or many not in of:
            return []
        ratio = of[many].time_ms / of[few].time_ms
        return [f"- {what}: {ratio:.2f} times the time ({verdict(ratio, limit, True)})"]
    return [*line((100, 1000), (1000, 1000), "10 times the particles, 1000 landmarks", 10),
            # the logarithm of 10000 is twice that of 100
            *line((100, 100), (100, 10000), "100 times the landmarks, 100 particles", 2)]


def measure(context):
    """The section of this part."""
    sizes = [_run(context, *size) for size in list_cases(context, PROGRAM, parse_sizes)]
    section = Section("Time of one update")
    section.paragraphs += [
        "CPU time of one step with 50 observations, on one core [ms]:",
        _matrix(sizes, ".3f", lambda size: size.time_ms),
        "Peak memory of the process [MB]:",
        _matrix(sizes, ".1f", lambda size: size.max_rss_mb),
        "Share of the steps that resampled:",
        _matrix(sizes, ".2f", lambda size: size.resampled),
        verdicts(sizes),
        "Each particle has built a map of its own before; the observations of a step are spread "
        "over the whole map."]
    return section
