# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part worlds of benchmark graph: drives through simulated cities of some sizes."""
from slam_eval.bench.graph.figures import describe
from slam_eval.bench.graph.solve import draw, solve
from slam_eval.bench.harness.table import Section


def measure(context):
    """The section of this part."""
    section, reports = Section("Simulated cities"), []
    sizes, seed = context.options.poses, context.options.seed
    for i, poses in enumerate(sizes):
        name = f"world_{seed}_{poses}"
        report = solve(context, name, ["--world", seed, "--poses", poses],
                       f"city {i + 1} of {len(sizes)}, {poses} poses")
        draw(context, name, report, section)
        reports.append(report)
    section.paragraphs += describe(reports)
    return section
