# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Halls drawn at random for the simulator: furniture along the walls and in the middle, 20
landmarks, and a ring around the middle that is driven four times, in 70 to 95 s."""
import math
import random

import yaml

LANDMARKS = 20
LAPS, SPEED = 4, 0.75  # [1], [m/s]
CORNERS = 16           # of the way
CLEARANCE = 0.6        # of furniture and landmarks from the way [m]
SPACING = 0.7          # of landmarks [m]
WALL = 0.3             # of landmarks from walls, at least [m]
HEIGHT = 2.1           # of landmarks, above all furniture: nothing hides them [m]


def _way(chance, width, depth):
    """A ring that swings in and out."""
    waves = [(n, size, chance.uniform(0.0, 2.0 * math.pi)) for n, size in ((2, 0.06), (3, 0.07))]
    points = []
    for corner in range(CORNERS):
        angle = 2.0 * math.pi * corner / CORNERS
        swing = 1.0 + sum(size * math.sin(n * angle + phase) for n, size, phase in waves)
        points.append((width / 2 + (width / 2 - 1.6) * swing * math.cos(angle),
                       depth / 2 + (depth / 2 - 1.6) * swing * math.sin(angle)))
    return points


def _finer(way):
    """The points of a closed way and those half way between them."""
    ends = way[1:] + way[:1]
    return way + [((a + c) / 2, (b + d) / 2) for (a, b), (c, d) in zip(way, ends)]


def _furniture(chance, width, depth, way):
    boxes = []
    while len(boxes) < 9:
        size = (chance.uniform(0.3, 1.2), chance.uniform(0.3, 0.8))
        size = size if chance.random() < 0.5 else size[::-1]
        centre = (chance.uniform(size[0] / 2, width - size[0] / 2),
                  chance.uniform(size[1] / 2, depth - size[1] / 2))
        away = min(math.hypot(max(0.0, abs(x - centre[0]) - size[0] / 2),
                              max(0.0, abs(y - centre[1]) - size[1] / 2)) for x, y in _finer(way))
        if away > CLEARANCE:
            boxes.append({"centre": [round(x, 3) for x in centre],
                          "size": [round(x, 3) for x in (*size, 1.5)]})
    return boxes


def _markers(chance, width, depth, way):
    places = []
    while len(places) < LANDMARKS:
        place = (chance.uniform(WALL, width - WALL), chance.uniform(WALL, depth - WALL))
        if min(math.dist(place, point) for point in _finer(way)) > CLEARANCE and all(
                math.dist(place, other) > SPACING for other in places):
            places.append(place)
    return [{"id": i, "position": [round(x, 3), round(y, 3), HEIGHT],
             "facing": round(math.atan2(depth / 2 - y, width / 2 - x), 4)}
            for i, (x, y) in enumerate(places)]


def hall(seed):
    """A world of slam_sim as a dictionary; the same for the same seed."""
    chance = random.Random(seed)
    width, depth = chance.uniform(7.5, 9.0), chance.uniform(6.5, 8.0)
    way = _way(chance, width, depth)
    corners = [[0.0, 0.0], [width, 0.0], [width, depth], [0.0, depth]]
    return {"version": 1, "world": f"hall_{seed}", "walls": [{"points": corners, "closed": True}],
            "furniture": _furniture(chance, width, depth, way),
            "marker": {"family": "36h11", "size": 0.16},
            "markers": _markers(chance, width, depth, way),
            "path": {"speed": SPEED, "laps": LAPS,
                     "points": [[round(x, 3), round(y, 3)] for x, y in way]}}


def write_hall(path, seed):
    """Write the hall as a file for slam_sim."""
    path.write_text(yaml.safe_dump(hall(seed)), encoding="utf-8")
    return path
