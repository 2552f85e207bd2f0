# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Occupancy grids as map_server reads them: a YAML file and its PGM image."""
import dataclasses

import numpy as np
import yaml

from slam_eval.io.errors import InputError, read_text

FREE, OCCUPIED, UNKNOWN = 0, 100, -1
_REMEDY = "run the product again"


@dataclasses.dataclass
class GridMap:
    """Cells (rows from the least y, columns from the least x): FREE, OCCUPIED or UNKNOWN."""

    cells: np.ndarray
    resolution: float     # edge of a cell [m]
    origin: np.ndarray    # corner of the first cell (x, y) [m]

    def centres(self, value):
        """Centres (N x 2) [m] of the cells of a value."""
        rows, columns = np.nonzero(self.cells == value)
        return self.origin + self.resolution * (np.column_stack([columns, rows]) + 0.5)

    @property
    def known_area(self):
        """Area of the cells that are not unknown [m^2]."""
        return float(np.count_nonzero(self.cells != UNKNOWN)) * self.resolution ** 2

    def known_part(self):
        """The grid without the unknown margin around it; None where it knows nothing."""
        rows = np.flatnonzero(np.any(self.cells != UNKNOWN, axis=1))
        columns = np.flatnonzero(np.any(self.cells != UNKNOWN, axis=0))
        if not len(rows):
            return None
        cells = self.cells[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]
        corner = self.origin + self.resolution * np.array([columns[0], rows[0]])
        return GridMap(cells, self.resolution, corner)

    def coarser(self, most):
        """The grid in at most so many cells a side: a wall is kept, a known cell as well."""
        factor = -(-max(self.cells.shape) // most)
        if factor <= 1:
            return self
        rows, columns = (-(-size // factor) for size in self.cells.shape)
        padded = np.full((rows * factor, columns * factor), UNKNOWN, self.cells.dtype)
        padded[:self.cells.shape[0], :self.cells.shape[1]] = self.cells
        blocks = padded.reshape(rows, factor, columns, factor)
        return GridMap(blocks.max(axis=(1, 3)), self.resolution * factor, self.origin)


def _read_pgm(path):
    """Grey values of a binary PGM, the top row first."""
    try:
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path}: the image of the map cannot be read ({error.strerror}); "
                         f"{_REMEDY}") from None
    try:
        fields, at = [], 0
        while len(fields) < 4:
            end = data.index(b"\n", at) + 1
            fields += data[at:end].split(b"#")[0].split()
            at = end
        kind, width, height, largest = fields[0], *map(int, fields[1:4])
        if kind != b"P5" or len(fields) != 4 or largest != 255 or len(data) != at + width * height:
            raise ValueError
    except ValueError:
        raise InputError(f"{path}: no whole PGM image of 8 bits; {_REMEDY}") from None
    return np.frombuffer(data, np.uint8, offset=at).reshape(height, width)


def read_grid(path):
    """Read a map by its YAML file. Raises InputError."""
    try:
        document = yaml.safe_load(read_text(path))
        image = path.parent / document["image"]
        resolution, origin = float(document["resolution"]), document["origin"]
        negate = bool(int(document["negate"]))
        free, occupied = float(document["free_thresh"]), float(document["occupied_thresh"])
        origin = np.array([float(origin[0]), float(origin[1])])
        if not (np.isfinite(resolution) and resolution > 0.0 and np.all(np.isfinite(origin))):
            raise ValueError
    except (yaml.YAMLError, KeyError, IndexError, TypeError, ValueError):
        raise InputError(f"{path}: no map as map_server reads it; {_REMEDY}") from None
    grey = _read_pgm(image)[::-1].astype(float)
    probability = (grey if negate else 255.0 - grey) / 255.0
    cells = np.full(grey.shape, UNKNOWN, np.int8)
    cells[probability < free] = FREE
    cells[probability > occupied] = OCCUPIED
    return GridMap(cells, resolution, origin)
