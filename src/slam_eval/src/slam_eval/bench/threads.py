# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part threads of benchmarks pf and grid: the files of a run for other numbers of threads, byte
by byte."""
import hashlib

from slam_eval.bench.harness.products import SENSORS
from slam_eval.bench.harness.runs import run_ours, simulate
from slam_eval.bench.harness.table import Section, table

THREADS = (1, 2, 4)
FILES = ("trajectory.tum", "trajectory_final.tum", "landmarks.yaml")
GRID_FILES = (*FILES, "map.pgm", "map.yaml")


def digests(folder, files=FILES):
    """The SHA-256 of each file of a run that its result is in."""
    return tuple(hashlib.sha256((folder / name).read_bytes()).hexdigest() for name in files)


def verdict(rows):
    """Whether the files of all rows (threads, digests) are the same, in words."""
    same = len({digest for _, digest in rows}) == 1
    return f"- the same bytes for any number of threads: {'reached' if same else 'MISSED'}"


def _measure(context, product, sensors, files):
    bag = simulate(context, "threads", "office", 1, sensors)
    rows = [(threads, digests(run_ours(context, f"threads_{threads}", bag, product=product,
                                       settings=(f"pf.threads={threads}",))[0], files))
            for threads in THREADS]
    section = Section("Threads")
    section.paragraphs += [
        table(["threads", *files], [[str(threads), *(d[:12] for d in digest)]
                                    for threads, digest in rows]),
        verdict(rows), "The beginning of the SHA-256 of the files of a run, office, seed 1."]
    return section


def measure(context):
    """The section of this part of benchmark pf."""
    return _measure(context, "pf_wheel", SENSORS, FILES)


def measure_grid(context):
    """The section of this part of benchmark grid."""
    return _measure(context, "pf_wheel_grid", f"{SENSORS},scan", GRID_FILES)
