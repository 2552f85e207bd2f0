# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The graph of poses at the end of a run (graph.csv)."""
import dataclasses

import numpy as np

from slam_eval.io.errors import InputError, read_text

COLUMNS = ["kind", "x0", "y0", "x1", "y1", "weight"]
PLACES = ("node", "submap")
EDGES = ("motion", "sighting", "loop", "waiting_loop")


@dataclasses.dataclass
class Graph:
    """Places (N x 2) [m] by kind; edges (N x 2 x 2) [m] and their weights by kind. Map frame."""

    places: dict
    edges: dict
    weights: dict


def _row(where, line):
    fields = line.split(",")
    if len(fields) != len(COLUMNS):
        raise InputError(f"{where}: {len(fields)} fields where {len(COLUMNS)} belong "
                         f"({' '.join(COLUMNS)}): the line is cut off or of another format; "
                         "run the product again")
    if fields[0] not in PLACES + EDGES:
        raise InputError(f'{where}: "{fields[0]}" is none of {", ".join(PLACES + EDGES)}; '
                         "run the product again with this release")
    try:
        values = [float(field) for field in fields[1:]]
    except ValueError:
        raise InputError(f'{where}: "{line[:60]}" holds something that is no number; '
                         "run the product again") from None
    if not np.all(np.isfinite(values)):
        raise InputError(f"{where}: a value is not finite (NaN or infinite); the run that wrote "
                         "it failed, look at its messages")
    return fields[0], values


def read_graph(path):
    """Read graph.csv. Raises InputError that names file and line."""
    lines = read_text(path).splitlines()
    if not lines or lines[0].strip().split(",") != COLUMNS:
        raise InputError(f'{path}:1: the header is not "{",".join(COLUMNS)}"; '
                         "run the product again with this release")
    found = {kind: [] for kind in PLACES + EDGES}
    for number, line in enumerate(lines[1:], start=2):
        if line.strip():
            kind, values = _row(f"{path}:{number}", line.strip())
            found[kind].append(values)
    table = {kind: np.array(rows).reshape(-1, 5) for kind, rows in found.items()}
    return Graph({kind: table[kind][:, :2] for kind in PLACES},
                 {kind: table[kind][:, :4].reshape(-1, 2, 2) for kind in EDGES},
                 {kind: table[kind][:, 4] for kind in EDGES})
