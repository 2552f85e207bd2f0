# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part threads of benchmark pf: the files of a run for other numbers of threads, byte by byte."""
import hashlib

from slam_eval.bench_office import SENSORS
from slam_eval.bench_runs import run_ours, simulate
from slam_eval.bench_table import Section, table

THREADS = (1, 2, 4)
FILES = ('trajectory.tum', 'trajectory_final.tum', 'landmarks.yaml')


def digests(folder):
    """The SHA-256 of each file of a run that its result is in."""
    return tuple(hashlib.sha256((folder / name).read_bytes()).hexdigest() for name in FILES)


def verdict(rows):
    """Whether the files of all rows (threads, digests) are the same, in words."""
    same = len({digest for _, digest in rows}) == 1
    return f'- the same bytes for any number of threads: {"reached" if same else "MISSED"}'


def measure(context):
    """The section of this part."""
    bag = simulate(context, 'threads', 'office', 1, SENSORS)
    rows = [(threads, digests(run_ours(context, f'threads_{threads}', bag, product='pf_wheel',
                                       settings=(f'pf.threads={threads}',))[0]))
            for threads in THREADS]
    section = Section('Threads')
    section.paragraphs += [
        table(['threads', *FILES], [[str(threads), *(d[:12] for d in digest)]
                                    for threads, digest in rows]),
        verdict(rows), 'The beginning of the SHA-256 of the files of a run, office, seed 1.']
    return section
