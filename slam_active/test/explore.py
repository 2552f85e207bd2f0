#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A simulated robot that knows nothing of its world explores it, following the goals of slam_active."""

import math
import sys
import time
import unittest

from follower import Follower, heading_of
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import OccupancyGrid
import rospy
import rostest
from std_msgs.msg import Bool
from std_srvs.srv import SetBool, Trigger
import yaml

ROBOT_RADIUS = 0.22  # of the simulated robot [m]
STEP = 0.1           # of the points of the floor whose coverage is measured [m]
MOST_FREE = 25       # [%]


class World:
    """The walls and the furniture of a world of slam_sim."""

    def __init__(self, file):
        with open(file, encoding="utf-8") as stream:
            document = yaml.safe_load(stream)
        self.boxes = document.get("furniture", [])
        self.walls = []
        for wall in document.get("walls", []):
            points = wall["points"]
            ends = points[1:] + (points[:1] if wall.get("closed") else [])
            self.walls += list(zip(points, ends))

    def distance(self, x, y):
        """Returns how far a point is from the nearest wall or box; 0 inside of a box [m]."""
        distances = [self.to_wall(x, y, *wall) for wall in self.walls]
        return min(distances + [self.to_box(x, y, box) for box in self.boxes])

    @staticmethod
    def to_wall(x, y, begin, end):
        dx, dy = end[0] - begin[0], end[1] - begin[1]
        along = ((x - begin[0]) * dx + (y - begin[1]) * dy) / (dx * dx + dy * dy)
        along = max(0.0, min(1.0, along))
        return math.hypot(x - begin[0] - along * dx, y - begin[1] - along * dy)

    @staticmethod
    def to_box(x, y, box):
        yaw = box.get("yaw", 0.0)
        dx, dy = x - box["centre"][0], y - box["centre"][1]
        along = abs(dx * math.cos(yaw) + dy * math.sin(yaw)) - 0.5 * box["size"][0]
        across = abs(dy * math.cos(yaw) - dx * math.sin(yaw)) - 0.5 * box["size"][1]
        return math.hypot(max(along, 0.0), max(across, 0.0))

    def floor(self):
        """Returns the points of the floor on which nothing stands."""
        xs = [point[0] for wall in self.walls for point in wall]
        ys = [point[1] for wall in self.walls for point in wall]
        grid = [(min(xs) + (i + 0.5) * STEP, min(ys) + (j + 0.5) * STEP)
                for i in range(int((max(xs) - min(xs)) / STEP))
                for j in range(int((max(ys) - min(ys)) / STEP))]
        return [point for point in grid if self.distance(*point) > STEP]


def place_in(start, x, y):
    """Returns a point of the world in the frame of a pose (x, y, heading) of the world."""
    dx, dy, heading = x - start[0], y - start[1], start[2]
    return (dx * math.cos(heading) + dy * math.sin(heading),
            dy * math.cos(heading) - dx * math.sin(heading))


def cell_at(grid, x, y):
    """Returns what a map says of a point of its frame; -1 beyond its edge."""
    info = grid.info
    column = math.floor((x - info.origin.position.x) / info.resolution)
    row = math.floor((y - info.origin.position.y) / info.resolution)
    is_inside = 0 <= column < info.width and 0 <= row < info.height
    return grid.data[row * info.width + column] if is_inside else -1


def draw(file, grid, driven, goals):
    """Writes a picture of the map, the way that was driven and the goals."""
    import matplotlib  # only for the picture
    matplotlib.use("Agg")
    from matplotlib import pyplot
    info = grid.info
    cells = [grid.data[row * info.width:(row + 1) * info.width] for row in range(info.height)]
    grey = [[205 if cell < 0 else round(254 * (1 - cell / 100)) for cell in row] for row in cells]
    left, bottom = info.origin.position.x, info.origin.position.y
    figure, axes = pyplot.subplots(figsize=(6, 5))
    axes.imshow(grey, cmap="gray", vmin=0, vmax=255, origin="lower",
                extent=(left, left + info.width * info.resolution,
                        bottom, bottom + info.height * info.resolution))
    axes.plot([pose[0] for pose in driven], [pose[1] for pose in driven], color="tab:blue",
              label="driven")
    axes.plot([goal[0] for goal in goals], [goal[1] for goal in goals], "o", color="tab:green",
              label="goals")
    for number, goal in enumerate(goals, 1):
        axes.annotate(str(number), goal, textcoords="offset points", xytext=(5, 4))
    axes.plot(*driven[0][:2], "s", color="tab:red", label="start")
    axes.set(xlabel="x [m]", ylabel="y [m]")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=3, frameon=False)
    figure.savefig(file, dpi=100, bbox_inches="tight")


class Explore(unittest.TestCase):
    """The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        cls.world = World(rospy.get_param("~world"))
        cls.truth, cls.maps, cls.goals, cls.explored = [], [], [], []
        cls.subscribers = [
            rospy.Subscriber("ground_truth/pose", PoseStamped, cls.on_truth),
            rospy.Subscriber("map", OccupancyGrid, lambda grid: cls.maps.append(grid)),
            rospy.Subscriber("move_base_simple/goal", PoseStamped, cls.on_goal),
            rospy.Subscriber("explored", Bool, lambda message: cls.explored.append(message.data))]
        cls.follower = Follower(rospy.get_param("~speed"))

    @classmethod
    def on_truth(cls, message):
        position = message.pose.position
        cls.truth.append((position.x, position.y, heading_of(message.pose.orientation)))

    @classmethod
    def on_goal(cls, message):
        cls.goals.append((message.pose.position.x, message.pose.position.y))

    def wait_for(self, condition, seconds):
        end = time.monotonic() + seconds
        while not condition() and time.monotonic() < end:
            time.sleep(0.1)
        return condition()

    def coverage(self):
        """Returns which share of the free floor the last map knows to be free."""
        floor = self.world.floor()
        cells = [cell_at(self.maps[-1], *place_in(self.truth[0], *point)) for point in floor]
        return sum(0 <= cell <= MOST_FREE for cell in cells) / len(cells)

    def test_1_the_world_is_explored_without_a_touch(self):
        begin = time.monotonic()
        is_done = self.wait_for(lambda: self.explored and self.explored[-1],
                                rospy.get_param("~seconds"))
        seconds = time.monotonic() - begin
        driven = sum(math.dist(a[:2], b[:2]) for a, b in zip(self.truth, self.truth[1:]))
        nearest = min(self.world.distance(*pose[:2]) for pose in self.truth[::5])
        coverage = self.coverage()
        print(f"coverage {coverage:.1%} of the floor, {driven:.1f} m driven in {seconds:.0f} s, "
              f"{len(self.goals)} goals, never nearer than {nearest:.2f} m to an obstacle")
        if rospy.get_param("~picture"):
            draw(rospy.get_param("~picture"), self.maps[-1], self.follower.driven, self.goals)
        self.assertTrue(is_done, "it says so")
        self.assertGreater(nearest, ROBOT_RADIUS)
        self.assertGreater(coverage, 0.9)
        self.assertFalse(self.explored[0], "not from the start")

    def test_2_there_are_no_goals_after_it(self):
        count = len(self.goals)
        time.sleep(3.0)
        self.assertEqual(len(self.goals), count)
        self.assertEqual(self.follower.way, [])

    def test_3_it_can_be_paused_and_asked_to_look_again(self):
        self.assertTrue(rospy.ServiceProxy("active_path/pause", SetBool)(True).success)
        self.assertTrue(rospy.ServiceProxy("active_path/restart", Trigger)().success)
        time.sleep(3.0)
        self.assertTrue(self.explored[-1], "paused: it decides nothing")
        self.assertTrue(rospy.ServiceProxy("active_path/pause", SetBool)(False).success)

    def test_4_it_starts_over_with_the_product(self):
        time.sleep(3.0)
        self.assertTrue(self.wait_for(lambda: self.explored[-1], 60), "what was left out as well")
        count = len(self.goals)
        self.assertTrue(rospy.ServiceProxy("reset", Trigger)().success)
        self.assertTrue(self.wait_for(lambda: len(self.goals) > count, 30), "another goal")
        self.assertFalse(self.explored[-1])


if __name__ == "__main__":
    rospy.init_node("explore_test")
    rostest.rosrun("slam_active", "explore", Explore, sys.argv)
