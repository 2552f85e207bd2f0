# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part time: what it costs to associate 20 observations in a map of 1000 landmarks."""
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import Section, table

LARGEST_P99 = 5.0  # [ms], of jcbb
HEADER = ["association", "policy alone: p50 [ms]", "p99 [ms]", "with the search: p50 [ms]",
          "p99 [ms]"]


def measure(context):
    """The section of this part."""
    section = Section("Time of an association")
    log = context.work / "association_time.log"
    call(context, "time", [workspace_program("slam_eval", "slam_eval_association")], log)
    lines = [line.split(",") for line in log.read_text(encoding="utf-8").splitlines()
             if line.count(",") == len(HEADER) - 1]
    section.paragraphs += [
        table(HEADER, lines),
        "15 landmarks and 5 strays seen at once, in an EKF with 1000 landmarks, at 300 places. "
        f"jcbb has to stay below {LARGEST_P99:.0f} ms at p99."]
    return section
