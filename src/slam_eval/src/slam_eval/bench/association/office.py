# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part office: the simulated office, its markers' ids not looked at."""
from slam_eval.bench.association.policies import DEFINITIONS, run_all, table_of
from slam_eval.bench.harness.runs import simulate
from slam_eval.bench.harness.table import Section


def measure(context):
    """The section of this part."""
    section = Section("Simulated office, ids withheld")
    bag = simulate(context, "office", "office", 1, "odom,camera")
    section.paragraphs += [table_of(run_all(context, "office", bag, section, detector="apriltag")), DEFINITIONS]
    return section
