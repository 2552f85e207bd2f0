# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables that a run writes: a header, and a line for each stamp."""
from slam_eval.io.errors import InputError, read_text


def table_lines(path, columns):
    """(place for messages, line) of each line below the header. Raises InputError where the header
    is another one."""
    lines = read_text(path).splitlines()
    if not lines or lines[0].strip().split(",") != columns:
        raise InputError(f'{path}:1: the header is not "{",".join(columns)}"; '
                         "run the product again with this release")
    return [(f"{path}:{number}", line.strip())
            for number, line in enumerate(lines[1:], start=2) if line.strip()]
