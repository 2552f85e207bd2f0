# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The lines of benchmark laser's tables, and what the figures are held to."""
import fnmatch

from slam_eval.bench.harness.goals import Goal, verdicts
from slam_eval.bench.harness.table import lines_of, table

HEADER = ["product", "seed", "relations", "[m]", "[deg]", "unambiguous", "u. [m]", "u. [deg]",
          "revisits", "r. [m]", "r. [deg]", "CPU [s]", "memory [MB]"]
FORMS = ["d", "d", ".4f", ".3f", "d", ".4f", ".3f", "d", ".4f", ".3f", ".1f", ".0f"]
PARTS = ("unambiguous", "revisit")  # of the relations

# By the log's name and the product.
GOALS = {
    "intel": {"scan_grid": (Goal("u. [m]", 0.06),),
              "scan_grid_wheel": (Goal("u. [m]", 0.020), Goal("u. [deg]", 0.28),
                                  Goal("CPU [s]", 5.0)),
              "pf_wheel_grid": (Goal("u. [m]", 0.024), Goal("u. [deg]", 0.35),
                                Goal("CPU [s]", 20.0), Goal("memory [MB]", 120.0))},
    "fr079": {"pf_wheel_grid": (Goal("[m]", 0.080),)},
    "key-*": {"pf_wheel_grid": (Goal("r. [m]", 0.30),)},
}


def row(product, seed, errors, usage):
    """The numbers of a line. errors: RelationErrors or None; a part of the relations that holds
    all of them or none is left out."""
    m = errors.metrics if errors is not None else {}
    line = [product, seed, m.get("relations"), m.get("relations_trans_mean_m"),
            m.get("relations_rot_mean_deg")]
    for part in PARTS:
        keys = [f"relations_{part}{end}" for end in ("", "_trans_mean_m", "_rot_mean_deg")]
        is_part = 0 < m.get(keys[0], 0) < m["relations"] if m else False
        line += [m[key] for key in keys] if is_part else [None] * len(keys)
    return [*line, usage.cpu_s, usage.max_rss_mb]


def _of_product(rows, product):
    return [line for line in rows if line[0] == product]


def judged(name, rows):
    """A line for each goal of this log that has a figure, with the product's name."""
    lines = []
    for pattern, goals in GOALS.items():
        for product, held_to in goals.items() if fnmatch.fnmatch(name, pattern) else ():
            found = _of_product(rows, product)
            words = verdicts(held_to, HEADER, found) if found else ""
            lines += [line.replace("- ", f"- {product}: ", 1) for line in words.splitlines()]
    return "\n".join(lines)


def describe(name, rows):
    """The table of a log and its verdicts, as paragraphs."""
    return [*([table(HEADER, lines_of(rows, FORMS))] if rows else []),
            *filter(None, [judged(name, rows)])]


def overview(rows_of):
    """All logs in one table: mean error of all relations [m], of the worst seed. rows_of: the rows
    by the log's name."""
    names = [name for name, rows in rows_of.items() if any(line[3] is not None for line in rows)]
    if len(names) < 2:
        return []
    column = HEADER.index("[m]")
    lines = []
    for product in dict.fromkeys(line[0] for rows in rows_of.values() for line in rows):
        errors = [[line[column] for line in _of_product(rows_of[name], product)] for name in names]
        lines.append([product, *(max(e) if e and None not in e else None for e in errors)])
    return [table(["all relations [m], worst seed", *names],
                  lines_of(lines, [".3f"] * len(names)))]
