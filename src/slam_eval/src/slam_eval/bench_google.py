# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What Google Benchmark prints."""
import json

from slam_eval.bench_error import BenchError


def parse_entry(text, program):
    """The first entry of Google Benchmark's JSON. Raises BenchError."""
    try:
        entry = json.loads(text)['benchmarks'][0]
        if entry['time_unit'] != 'ms' or 'error_message' in entry:
            raise ValueError(entry['time_unit'])
        return entry
    except (json.JSONDecodeError, KeyError, IndexError, TypeError, ValueError):
        raise BenchError(f'{program} printed no JSON of Google Benchmark in milliseconds; build it '
                         'again') from None
