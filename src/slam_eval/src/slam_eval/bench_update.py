# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part update: time of one update against map size and number of observations."""
import dataclasses
import json
import re

from slam_eval.bench_error import BenchError
from slam_eval.bench_plots import plot_updates
from slam_eval.bench_programs import workspace_program
from slam_eval.bench_runs import call
from slam_eval.bench_table import Section, number, table

_NAME = re.compile(r'/landmarks:(\d+)/observations:(\d+)')
_MILLISECONDS = {'ns': 1e-6, 'us': 1e-3, 'ms': 1.0, 's': 1e3}


@dataclasses.dataclass
class Size:
    """Time of an update [ms, CPU] by number of observations, and peak memory [MB]."""

    landmarks: int
    times: dict
    max_rss_mb: float


def parse_sizes(text):
    """Numbers of landmarks in a list of benchmark names, rising."""
    return sorted({int(match.group(1)) for match in _NAME.finditer(text)})


def parse_times(text):
    """CPU time of an update [ms] by number of observations, from the benchmark's JSON."""
    times = {}
    try:
        for entry in json.loads(text)['benchmarks']:
            match = _NAME.search(entry['name'])
            if match and not entry.get('error_occurred'):
                times[int(match.group(2))] = entry['cpu_time'] * _MILLISECONDS[entry['time_unit']]
    except (json.JSONDecodeError, KeyError, TypeError):
        raise BenchError('slam_eval_backend_update printed no JSON of Google Benchmark; build it '
                         'again') from None
    return times


def _run(context, landmarks, program):
    log = context.work / f'update_{landmarks}.json'
    usage = call(context, f'time of an update, {landmarks} landmarks',
                 [program, f'--benchmark_filter=landmarks:{landmarks}/',
                  '--benchmark_format=json'], log)
    return Size(landmarks, parse_times(log.read_text(encoding='utf-8')), usage.max_rss_mb)


def rows(sizes):
    """(header, lines) of the table."""
    counts = sorted({count for size in sizes for count in size.times})
    header = ['landmarks', *(f'{n} observation{"s" * (n > 1)} [ms]' for n in counts),
              'memory [MB]']
    lines = [[str(size.landmarks), *(number(size.times.get(n), '.3f') for n in counts),
              number(size.max_rss_mb, '.1f')] for size in sizes]
    return header, lines


def measure(context):
    """The section of this part."""
    program = workspace_program('slam_eval', 'slam_eval_backend_update')
    log = context.work / 'update_list.txt'
    call(context, 'list of the update benchmarks', [program, '--benchmark_list_tests=true'], log)
    sizes = [_run(context, landmarks, program)
             for landmarks in parse_sizes(log.read_text(encoding='utf-8'))]
    if not any(size.times for size in sizes):
        raise BenchError('slam_eval_backend_update has no benchmark of landmarks and observations; '
                         'build it again')
    section = Section('Time of one update')
    section.paragraphs += [
        table(*rows(sizes)),
        'CPU time of one step (prediction, then all observations jointly) in a map of so many '
        'landmarks. Memory: peak of a process that holds that map; its first step sees all of it '
        'at once.']
    path = context.out / 'update_time.png'
    plot_updates(sizes, path)
    section.pictures['time of an update against landmarks'] = path
    return section
