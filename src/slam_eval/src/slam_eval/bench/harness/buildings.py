# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Buildings drawn at random for the simulator: rooms at both sides of a corridor, with furniture, and
a way through all of them that is driven twice."""
import dataclasses
import math
import random

import yaml

CLEARANCE = 0.55  # of furniture from the way [m]
DOOR = 1.2        # [m]


@dataclasses.dataclass(frozen=True)
class Room:
    """A room at a corridor: its walls' places and the middle of its door, all in [m]."""

    left: float
    right: float
    near: float   # the wall with the door
    far: float
    door: float

    def walls(self):
        """Lines of points: the wall with the door in two parts, and the other three."""
        return [[[self.left, self.near], [self.door - DOOR / 2, self.near]],
                [[self.door + DOOR / 2, self.near], [self.right, self.near]],
                [[self.left, self.near], [self.left, self.far], [self.right, self.far],
                 [self.right, self.near]]]

    def way(self, forward):
        """Through the door, round the room, and out again. forward: 1 along x, -1 against it."""
        up = math.copysign(1.0, self.far - self.near)
        middle, half = (self.left + self.right) / 2, (self.right - self.left) / 2 - 0.8
        depth = abs(self.far - self.near)
        points = [(self.door - 0.2 * forward, self.near - 0.2 * up),
                  (self.door - 0.2 * forward, self.near + 0.7 * up),
                  (middle - half * forward, self.near + 0.5 * depth * up),
                  (middle - 0.4 * half * forward, self.near + (depth - 0.8) * up),
                  (middle + 0.4 * half * forward, self.near + (depth - 0.8) * up),
                  (middle + half * forward, self.near + 0.5 * depth * up),
                  (self.door + 0.2 * forward, self.near + 0.7 * up),
                  (self.door + 0.2 * forward, self.near - 0.2 * up)]
        return points


def _rooms(chance, length, near, up):
    rooms, left = [], 0.0
    while length - left > 3.5:
        right = left + chance.uniform(3.4, 5.5)
        if length - right < 3.5:
            right = length
        rooms.append(Room(left, right, near, near + up * chance.uniform(3.2, 5.0),
                          (left + right) / 2 + chance.uniform(-0.3, 0.3)))
        left = right
    return rooms


def _distance(point, start, end):
    """Of a point from a line [m]."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    along = ((point[0] - start[0]) * dx + (point[1] - start[1]) * dy) / (dx * dx + dy * dy)
    along = min(1.0, max(0.0, along))
    return math.dist(point, (start[0] + along * dx, start[1] + along * dy))


def _furniture(chance, room, way):
    boxes = []
    for _ in range(chance.randint(8, 20)):
        size = (chance.uniform(0.15, 1.4), chance.uniform(0.15, 0.8))
        if chance.random() < 0.5:
            size = size[::-1]
        low, high = sorted((room.near, room.far))
        centre = (chance.uniform(room.left + size[0] / 2, room.right - size[0] / 2),
                  chance.uniform(low + size[1] / 2, high - size[1] / 2))
        corners = [(centre[0] + i * size[0] / 2, centre[1] + j * size[1] / 2)
                   for i in (-1, -0.5, 0, 0.5, 1) for j in (-1, 0, 1)]
        if min(_distance(c, *line) for c in corners for line in zip(way, way[1:])) > CLEARANCE:
            boxes.append({"centre": [round(x, 3) for x in centre],
                          "size": [round(x, 3) for x in (*size, 1.5)]})
    return boxes


def building(seed):
    """A world of slam_sim as a dictionary; the same for the same seed."""
    chance = random.Random(seed)
    length, width = chance.uniform(11.0, 16.0), chance.uniform(1.8, 2.6)
    above, below = _rooms(chance, length, width, 1), _rooms(chance, length, 0.0, -1)
    walls = [[[0, 0], [0, width]], [[length, 0], [length, width]]]
    there, back = 0.5 * width - 0.1, 0.5 * width + 0.1
    way, boxes = [(0.8, there)], []
    for forward, y, rooms in ((1, there, below), (-1, back, above[::-1])):
        for room in rooms:
            way += [(room.door - 0.9 * forward, y), *room.way(forward),
                    (room.door + 0.9 * forward, y)]
        way.append((length - 0.7, width / 2) if forward > 0 else (0.7, width / 2))
    for room in above + below:
        walls += room.walls()
        boxes += _furniture(chance, room, [*way, way[0]])
    return {"version": 1, "world": f"building_{seed}",
            "walls": [{"points": [[float(x) for x in point] for point in line]} for line in walls],
            "furniture": boxes,
            "path": {"speed": 0.6, "laps": 2, "points": [[float(x), float(y)] for x, y in way]}}


def write_building(path, seed):
    """Write the building as a file for slam_sim."""
    path.write_text(yaml.safe_dump(building(seed)), encoding="utf-8")
    return path
