# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The list of findings for people."""
import textwrap

from slam_doctor.finding import Level

WIDTH, INDENT = 100, 13
COLOURS = {Level.OK: "32", Level.WARN: "33", Level.ERROR: "31", Level.UNKNOWN: "36"}


def lines(finding, with_colour=False):
    """The lines of one finding: its level and what was found, then what to do."""
    level = f"{finding.level.value:<{INDENT}}"
    wrapped = textwrap.wrap(finding.text, WIDTH - INDENT) or [""]
    if with_colour:
        level = f"\x1b[{COLOURS[finding.level]}m{level}\x1b[0m"
    out = [level + wrapped[0], *(" " * INDENT + line for line in wrapped[1:])]
    if finding.advice:
        advice = textwrap.wrap(finding.advice, WIDTH - INDENT - 3)
        out.append(" " * INDENT + "-> " + advice[0])
        out += [" " * (INDENT + 3) + line for line in advice[1:]]
    return out


def summary(findings):
    """How many findings there are of each level."""
    counts = {level: sum(finding.level is level for finding in findings) for level in Level}
    return ", ".join(f"{count} {level.value}" for level, count in counts.items())


def text(groups, with_colour=False):
    """The whole list of {title: [Finding]}, titles as headings."""
    out = []
    for title, findings in groups.items():
        if findings:
            out += [title, *(line for each in findings for line in lines(each, with_colour)), ""]
    out.append(summary([each for findings in groups.values() for each in findings]))
    return "\n".join(out)
