# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs made with Google Benchmark: which cases they have, and the times of one."""
import json

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.runs import call


def list_cases(context, program, parse):
    """What parse makes of the names of a program's benchmarks. Raises BenchError where that is
    nothing."""
    log = context.work / f"{program}_list.txt"
    call(context, f"list of the benchmarks of {program}",
         [workspace_program("slam_eval", program), "--benchmark_list_tests=true"], log)
    cases = parse(log.read_text(encoding="utf-8"))
    if not cases:
        raise BenchError(f"{program} has no benchmark whose name is known here; build it again")
    return cases


def run_case(context, program, pattern, task, name):
    """(JSON, usage) of the benchmarks whose names match; name: of the case, for the log."""
    log = context.work / f"{program}_{name}.json"
    usage = call(context, task, [workspace_program("slam_eval", program),
                                 f"--benchmark_filter={pattern}", "--benchmark_format=json"], log)
    return log.read_text(encoding="utf-8"), usage


def parse_figures(text, program, keys):
    """The figures of these keys in the first entry of the JSON. Raises BenchError."""
    try:
        entry = json.loads(text)["benchmarks"][0]
        if entry["time_unit"] != "ms" or "error_message" in entry:
            raise ValueError(entry["time_unit"])
        return tuple(entry[key] for key in keys)
    except (json.JSONDecodeError, KeyError, IndexError, TypeError, ValueError):
        raise BenchError(f"{program} printed no JSON of Google Benchmark in milliseconds; build it "
                         "again") from None
