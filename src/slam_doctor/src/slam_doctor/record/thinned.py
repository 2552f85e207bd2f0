# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lists that stay short however much is appended."""
import array

import numpy as np


class Thinned:
    """Keeps an even selection: when `limit` items are full, every second one is dropped, and from
    then on only every second (fourth, ...) is taken. The first item always stays."""

    def __init__(self, limit=4096):
        self._limit, self._stride, self._count = limit, 1, 0
        self.items = []

    def wants_next(self):
        """Whether the next item will be kept: an item that costs much need not be made else."""
        return self._count % self._stride == 0

    def append(self, item):
        """Takes or passes over an item."""
        if self.wants_next():
            self.items.append(item)
            if len(self.items) >= self._limit:
                del self.items[1::2]
                self._stride *= 2
        self._count += 1

    def lower(self, limit):
        """Keeps at most so many from now on; where fewer were allowed, nothing changes."""
        self._limit = min(self._limit, limit)

    def array(self):
        """The items as an array of floating-point numbers."""
        return np.array(self.items, dtype=float)


class Blocks:
    """Keeps whole runs of `length` successive items, at most `limit` runs, evenly selected."""

    def __init__(self, length=100, limit=60):
        self._length, self._open = length, []
        self._full = Thinned(limit)

    def append(self, item):
        """Takes an item."""
        self._open.append(item)
        if len(self._open) == self._length:
            self._full.append(self._open)
            # The next run begins with this item, so that no pair of successive items is lost.
            self._open = [item]

    def runs(self):
        """The runs, lists of items that came one after another."""
        return [*self._full.items, *([self._open] if len(self._open) > 1 else [])]


class ThinnedRows:
    """As Thinned, of rows of `width` numbers, in little memory."""

    def __init__(self, width, limit=400_000):
        self._width, self._limit = width, limit
        self._stride = 1
        self._count = 0
        self._values = array.array("d")

    def append(self, row):
        """Takes or passes over a row."""
        if self._count % self._stride == 0:
            self._values.extend(row)
            if len(self._values) >= self._limit * self._width:
                self._values = array.array("d", self.array()[::2].ravel())
                self._stride *= 2
        self._count += 1

    def array(self):
        """The rows, N x width."""
        return np.array(self._values).reshape(-1, self._width)
