# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parks drawn at random for the simulator: trees on a lawn, and a way around that is driven twice."""
import dataclasses
import math
import random

import yaml

LENGTH, WIDTH = 240.0, 170.0  # [m]
CORNERS = 24                  # of the way
CLEARANCE = 4.5               # of trees from the way [m]
SPACING = 1.5                 # of trees [m]


@dataclasses.dataclass(frozen=True)
class Park:
    """Trees (x, y, radius) and the corners of the way, all in [m]."""

    trees: list
    way: list

    def write(self, path):
        """As a world of slam_sim."""
        world = {"version": 1, "world": path.stem, "floor_gray": 0.35,
                 "ceiling": {"height": 12.0, "texture": "plain"},
                 "trees": [{"centre": [round(x, 2), round(y, 2)], "radius": round(radius, 2)}
                           for x, y, radius in self.trees],
                 "path": {"speed": 3.0, "laps": 2,
                          "points": [[round(x, 1), round(y, 1)] for x, y in self.way]}}
        path.write_text(yaml.safe_dump(world), encoding="utf-8")


def _way(chance):
    """A ring that swings in and out."""
    waves = [(n, size, chance.uniform(0.0, 2.0 * math.pi))
             for n, size in ((2, 0.25), (3, 0.18), (5, 0.10))]
    points = []
    for corner in range(CORNERS):
        angle = 2.0 * math.pi * corner / CORNERS
        swing = 1.0 + sum(size * math.sin(n * angle + phase) for n, size, phase in waves)
        points.append((0.31 * LENGTH * swing * math.cos(angle),
                       0.31 * WIDTH * swing * math.sin(angle)))
    return points


def _distance(point, start, end):
    (px, py), (ax, ay), (bx, by) = point, start, end
    dx, dy = bx - ax, by - ay
    t = ((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy)
    t = min(1.0, max(0.0, t))
    return math.hypot(px - ax - t * dx, py - ay - t * dy)


def park(seed, per_hectare):
    """A park of so many trees per hectare."""
    chance = random.Random(seed)
    way = _way(chance)
    trees = []
    while len(trees) < per_hectare * LENGTH * WIDTH / 1e4:
        x = chance.uniform(-LENGTH / 2, LENGTH / 2)
        y = chance.uniform(-WIDTH / 2, WIDTH / 2)
        is_free = all(_distance((x, y), start, end) > CLEARANCE
                      for start, end in zip(way, way[1:] + way[:1]))
        if is_free and all(math.hypot(x - a, y - b) > SPACING for a, b, _ in trees):
            trees.append((x, y, chance.uniform(0.08, 0.45)))
    return Park(trees, way)
