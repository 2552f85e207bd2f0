# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Markdown tables that are aligned for a terminal too, and the sections of the result."""
import dataclasses
import pathlib

ABSENT = "-"


@dataclasses.dataclass
class Section:
    """A part of the result: title, paragraphs (tables are paragraphs) and pictures by caption; a
    sentence for each thing that failed while others did not."""

    title: str
    paragraphs: list = dataclasses.field(default_factory=list)
    pictures: dict = dataclasses.field(default_factory=dict)
    failures: list = dataclasses.field(default_factory=list)

    def markdown(self, folder=None):
        """The section as text; pictures only where the folder of the text is given."""
        blocks = [f"## {self.title}", *self.paragraphs,
                  *(f"Failed: {failure}" for failure in self.failures)]
        if folder is not None:
            blocks += [f"![{caption}]({pathlib.Path(path).relative_to(folder)})"
                       for caption, path in self.pictures.items()]
        return "\n\n".join(blocks) + "\n"


def number(value, form):
    """A number in the given format, or a dash where there is none."""
    return ABSENT if value is None else format(value, form)


def drop_empty(header, rows):
    """Header and rows without the columns that hold nothing but dashes."""
    kept = [i for i in range(len(header)) if not rows or any(row[i] != ABSENT for row in rows)]
    return [header[i] for i in kept], [[row[i] for i in kept] for row in rows]


def table(header, rows):
    """A Markdown table: first column to the left, numbers to the right."""
    header, rows = drop_empty(list(header), [list(row) for row in rows])
    widths = [max(len(row[i]) for row in [header, *rows]) for i in range(len(header))]

    def line(cells):
        first = cells[0].ljust(widths[0])
        return "| " + " | ".join([first] + [c.rjust(w) for c, w in
                                            zip(cells[1:], widths[1:])]) + " |"

    rule = "|" + "|".join(["-" * (widths[0] + 2)] + ["-" * (w + 1) + ":" for w in widths[1:]]) + "|"
    return "\n".join([line(header), rule, *(line(row) for row in rows)])


def lines_of(rows, forms):
    """Rows of a name and numbers as text."""
    return [[row[0], *(number(x, form) for x, form in zip(row[1:], forms))] for row in rows]


def mean_row(name, rows):
    """The mean of each column of numbers; None where a value is missing."""
    columns = list(zip(*rows))
    return [name] + [None if None in c else sum(c) / len(c) for c in columns[1:]]


def verdict(value, limit, at_most):
    """Whether a value keeps to its limit, in words."""
    sign = "<=" if at_most else ">="
    kept = value <= limit if at_most else value >= limit
    return f"{sign} {limit:g}: {'reached' if kept else 'MISSED'}"
