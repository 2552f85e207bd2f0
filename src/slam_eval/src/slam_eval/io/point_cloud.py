# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points as a run's points.pcd holds them."""
import numpy as np

from slam_eval.io.errors import InputError, read_text


def read_points(path):
    """The x and y (N x 2) [m] of a PCD file in ASCII. Raises InputError."""
    fields, count, lines = None, None, iter(read_text(path).splitlines())
    try:
        for line in lines:
            words = line.split()
            if words[:1] == ["FIELDS"]:
                fields = words[1:]
            elif words[:1] == ["POINTS"]:
                count = int(words[1])
            elif words[:1] == ["DATA"]:
                if words[1] != "ascii":
                    raise ValueError
                break
        columns = fields.index("x"), fields.index("y")
        rows = [line.split() for line in lines]
        points = np.array([[float(row[i]) for i in columns] for row in rows]).reshape(-1, 2)
        if len(points) != count or any(len(row) != len(fields) for row in rows):
            raise ValueError
    except (AttributeError, IndexError, ValueError):
        raise InputError(f"{path}: no whole point cloud in ASCII with x and y; run the product "
                         "again") from None
    return points[np.all(np.isfinite(points), axis=1)]
