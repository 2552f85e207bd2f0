# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The lines of benchmark graph's tables, and what the figures are held to."""
from slam_eval.bench.harness.table import lines_of, table, verdict

HEADER = ["graph", "poses", "edges", "CPU [s]", "mean [ms]", "p99 [ms]", "worst [ms]",
          "memory [MB]", "chi2", "Ceres chi2", "ratio", "Ceres CPU [s]", "error [m]",
          "Ceres error [m]", "odometry [m]"]
FORMS = ["d", "d", ".3f", ".3f", ".2f", ".2f", ".0f", ".2f", ".2f", ".5f", ".3f", ".3f", ".3f",
         ".2f"]
MOST_EXCESS = 0.1  # of chi2 over Ceres' [%]

REMARK = ("CPU time of a step: the next pose and its edges to earlier ones are added, the graph is "
          "solved, and the covariance of the pose is computed. Ceres solves the whole graph once, "
          "from the odometry on. Its chi2 is the lower one of what it comes to from there and from "
          "our result. Errors: root mean square of the positions after a rigid alignment with the "
          "truth, where that is known; odometry: the same of the way without loops.")


def row(report):
    """The numbers of a line, of what the program printed."""
    batches = [report["ceres"], report["ceres_from_result"]]
    return [report["name"], report["poses"], report["edges"], report["cpu_s"], report["mean_ms"],
            report["p99_ms"], report["worst_ms"], report["memory_mb"], report["chi2"],
            min(batch["chi2"] for batch in batches), report.get("chi2_ratio"),
            report["ceres"]["cpu_s"], report.get("error_m"), report.get("ceres_error_m"),
            report.get("dead_reckoning_error_m")]


def notes(report):
    """Sentences on what the numbers of a graph do not say."""
    lines = [f"- {report['name']}: records of type {kind} are not used ({count})."
             for kind, count in report["left_out"].items()]
    if not report["ceres"]["has_converged"]:
        lines.append(f"- {report['name']}: Ceres has not converged from the odometry on.")
    return lines


def goal_line(rows):
    """Whether chi2 comes near enough to Ceres' in the worst of the graphs; empty where there is no
    ratio."""
    ratios = [line[HEADER.index("ratio")] for line in rows]
    excess = [100.0 * (ratio - 1.0) for ratio in ratios if ratio is not None]
    if not excess:
        return ""
    return (f"- chi2 above Ceres', worst: {max(excess):.3f} % "
            f"({verdict(max(excess), MOST_EXCESS, True)})")


def describe(reports):
    """The table of the graphs and its verdicts, as paragraphs."""
    rows = [row(report) for report in reports]
    said = [line for report in reports for line in notes(report)]
    blocks = [table(HEADER, lines_of(rows, FORMS)), goal_line(rows),
              "\n".join(said), REMARK]
    return [block for block in blocks if block]
