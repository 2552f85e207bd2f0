# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Limits of the figures in a table, and whether they are kept."""
import dataclasses

from slam_eval.bench.harness.table import verdict


@dataclasses.dataclass(frozen=True)
class Goal:
    """A limit of a column of a table, for its worst line unless said otherwise."""

    column: str
    limit: float
    at_most: bool = True
    name: str = ""
    of_mean: bool = False

    def line(self, value):
        """What is said of the value."""
        return (f"- {self.name or f'worst {self.column}'} {value:.3g} "
                f"({verdict(value, self.limit, self.at_most)})")


def verdicts(goals, header, rows):
    """A line for each goal, by the worst of the rows."""
    lines = []
    for goal in goals:
        values = [row[header.index(goal.column)] for row in rows]
        if None in values:
            continue
        lines.append(goal.line(max(values) if goal.at_most else min(values)))
    return "\n".join(lines)
