#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The map of the back-ends that make a grid, as map_server and costmap_2d have it: topics, services
and files."""

import copy
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from catkin.find_in_workspaces import find_in_workspaces
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import MapMetaData, OccupancyGrid, Odometry
from nav_msgs.srv import GetMap, SetMap
from player import wait_for
import rosbag
import rospy
import rostest
from sensor_msgs.msg import LaserScan
from slam_msgs.srv import LoadMap, SaveMap
from std_srvs.srv import Empty, Trigger
from tf2_msgs.msg import TFMessage
import yaml

SECONDS = 8
TOPICS = {"/odom": Odometry, "/scan": LaserScan, "/tf_static": TFMessage}
FREE, OCCUPIED, UNKNOWN = 254, 0, 205  # of map_saver's images
MOST_FREE, LEAST_OCCUPIED = 25, 65     # its thresholds [%]


def read_simulation():
    """Returns the (topic, message) of some seconds in the office."""
    program = find_in_workspaces(["libexec"], "slam_sim", "slam_sim", first_match_only=True)[0]
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "office.bag"
        subprocess.run([program, path, "--duration", str(SECONDS), "--only", "odom,scan"],
                       check=True, stdout=subprocess.DEVNULL)
        with rosbag.Bag(str(path)) as bag:
            return [(topic, message) for topic, message, _ in
                    bag.read_messages(topics=list(TOPICS))]


def latched(topic, kind):
    """Returns what a late subscriber gets at once, or None."""
    received = []
    subscriber = rospy.Subscriber(topic, kind, received.append)
    wait_for(lambda: received, 10)
    subscriber.unregister()
    return received[0] if received else None


def read_image(path):
    """Returns a PGM's size and rows of grey values, the top row first."""
    data = path.read_bytes()
    kind, _, size, most, rows = data.split(b"\n", 4)  # the second line is a comment
    width, height = map(int, size.split())
    assert (kind, most, len(rows)) == (b"P5", b"255", width * height)
    return width, height, [rows[i * width:(i + 1) * width] for i in range(height)]


def grey_of(cell):
    if 0 <= cell <= MOST_FREE:
        return FREE
    return OCCUPIED if cell >= LEAST_OCCUPIED else UNKNOWN


class GridMapTest(unittest.TestCase):
    """The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        cls.log = read_simulation()
        cls.publishers = {topic: rospy.Publisher(topic, kind, queue_size=1000,
                                                 latch=topic == "/tf_static")
                          for topic, kind in TOPICS.items()}
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.connected = wait_for(lambda: all(p.get_num_connections() > 0
                                             for p in cls.publishers.values()), 30)
        for service in ("dynamic_map", "static_map", "set_map", "save_map", "load_map", "reset",
                        "global_localization", "request_nomotion_update"):
            rospy.wait_for_service(service, 10)

    def call(self, name, kind, **request):
        return rospy.ServiceProxy(name, kind)(**request)

    def play(self):
        for topic, message in self.log:
            self.publishers[topic].publish(message)
            time.sleep(0.003)

    def grid(self):
        return self.call("dynamic_map", GetMap).map

    def wait_for_map(self):
        """Until nothing changes it any more; returns it."""
        last = self.grid()
        while True:
            time.sleep(0.5)
            grid = self.grid()
            if grid.data and grid.header.stamp == last.header.stamp:
                return grid
            last = grid

    def test_1_a_map_that_knows_nothing_is_no_error(self):
        self.assertTrue(self.connected)
        self.assertEqual(len(self.grid().data), 0)
        answer = self.call("save_map", SaveMap, path=str(self.folder / "early.yaml"))
        self.assertTrue(answer.success, answer.message)
        self.assertIn("early.landmarks.yaml; there is no grid yet", answer.message)
        with self.assertRaises(rospy.ServiceException):  # there is nothing to look in
            self.call("global_localization", Empty)

    def test_2_the_service_gives_the_map_as_it_is(self):
        self.play()
        grid = self.wait_for_map()
        self.assertEqual(grid.header.frame_id, "map")
        self.assertEqual(len(grid.data), grid.info.width * grid.info.height)
        self.assertAlmostEqual(grid.info.resolution, 0.05, 6)
        self.assertEqual(grid.info.origin.orientation.w, 1.0)
        self.assertTrue(set(grid.data) <= set(range(-1, 101)))
        count = {value: sum(grey_of(cell) == value for cell in grid.data)
                 for value in (FREE, OCCUPIED, UNKNOWN)}
        self.assertGreater(count[FREE], 1000, "2.5 m^2")
        self.assertGreater(count[OCCUPIED], 100, "5 m of walls")

    def test_3_the_topics_are_latched(self):
        grid, info = latched("map", OccupancyGrid), latched("map_metadata", MapMetaData)
        self.assertIsNotNone(grid)
        self.assertEqual(grid._connection_header["latching"], "1")
        self.assertEqual(info._connection_header["latching"], "1")
        self.assertEqual(grid.info, info)
        self.assertEqual(grid.header.frame_id, "map")

    def test_4_the_files_are_those_of_map_saver(self):
        grid = self.wait_for_map()
        answer = self.call("save_map", SaveMap, path=str(self.folder))
        self.assertTrue(answer.success, answer.message)
        document = yaml.safe_load((self.folder / "map.yaml").read_text(encoding="ascii"))
        self.assertEqual({key: document[key] for key in ("image", "negate", "occupied_thresh",
                                                         "free_thresh")},
                         {"image": "map.pgm", "negate": 0, "occupied_thresh": 0.65,
                          "free_thresh": 0.196})
        self.assertAlmostEqual(document["origin"][0], grid.info.origin.position.x, 6)
        width, height, rows = read_image(self.folder / "map.pgm")
        self.assertEqual((width, height), (grid.info.width, grid.info.height))
        expected = [bytes(grey_of(cell) for cell in grid.data[y * width:(y + 1) * width])
                    for y in reversed(range(height))]
        self.assertEqual(rows, expected, "the image's top row is the grid's last")

    def test_5_a_saved_map_comes_back(self):
        before = self.grid()
        self.assertTrue(self.call("reset", Trigger).success)
        self.assertTrue(wait_for(lambda: not self.grid().data))
        (self.folder / "landmarks.yaml").unlink()  # its pose is not where the log begins
        answer = self.call("load_map", LoadMap, path=str(self.folder / "map.yaml"))
        self.assertTrue(answer.success, answer.message)
        self.play()  # what is loaded is taken up by the next step
        after = self.wait_for_map()
        self.assertGreater(sum(a >= LEAST_OCCUPIED for a in after.data),
                           0.8 * sum(b >= LEAST_OCCUPIED for b in before.data))

    def test_5b_the_services_are_those_of_amcl_and_map_server(self):
        grid = self.wait_for_map()
        self.assertEqual(self.call("static_map", GetMap).map.data, grid.data)
        self.call("global_localization", Empty)
        self.call("request_nomotion_update", Empty)
        pose = PoseWithCovarianceStamped()
        pose.pose.pose.orientation.w = 1.0
        pose.pose.covariance[0] = pose.pose.covariance[7] = pose.pose.covariance[35] = 0.01
        self.assertTrue(self.call("set_map", SetMap, map=grid, initial_pose=pose).success)
        for spoil in (lambda m: m.header.__setattr__("frame_id", "elsewhere"),
                      lambda m: m.info.__setattr__("resolution", 0.0),
                      lambda m: m.info.__setattr__("width", m.info.width + 1),
                      lambda m: m.info.origin.orientation.__setattr__("z", 0.5)):
            wrong = copy.deepcopy(grid)
            spoil(wrong)
            self.assertFalse(self.call("set_map", SetMap, map=wrong, initial_pose=pose).success)
        pose.pose.covariance[0] = -1.0
        self.assertFalse(self.call("set_map", SetMap, map=grid, initial_pose=pose).success)

    def test_6_a_map_is_saved_while_the_filter_runs(self):
        self.call("reset", Trigger)
        (self.folder / "running").mkdir()
        player = threading.Thread(target=self.play)
        player.start()
        saved = 0
        while player.is_alive():
            answer = self.call("save_map", SaveMap, path=str(self.folder / "running"))
            if answer.success and (self.folder / "running" / "map.yaml").exists():
                read_image(self.folder / "running" / "map.pgm")  # is whole
                saved += 1
            time.sleep(0.05)
        player.join()
        self.assertGreater(saved, 3)

    def test_7_a_yaml_without_its_image_is_refused_and_the_filter_goes_on(self):
        (self.folder / "map.pgm").unlink()
        answer = self.call("load_map", LoadMap, path=str(self.folder / "map.yaml"))
        self.assertFalse(answer.success)
        self.assertIn("map.pgm; does it exist?", answer.message)
        self.assertGreater(len(self.wait_for_map().data), 0)

    def write_map(self, name, edge, origin=0.0):
        """Returns the path of a free square of edge [m], with its left corner at origin [m]."""
        cells = int(edge / 0.5)
        (self.folder / "square.pgm").write_bytes(b"P5\n%d %d\n255\n" % (cells, cells)
                                                 + b"\xfe" * cells * cells)
        (self.folder / name).write_text(
            f"image: square.pgm\nresolution: 0.5\norigin: [{origin}, 0.0, 0.0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n", encoding="ascii")
        return str(self.folder / name)

    def test_8_a_map_that_is_none_is_refused_and_one_that_is_cut_is_told(self):
        before = self.wait_for_map()
        answer = self.call("load_map", LoadMap, path=self.write_map("far.yaml", 2.0, 1e9))
        self.assertFalse(answer.success)
        self.assertIn("the grid's origin is more than 100000 km from the map's origin", answer.message)
        self.assertEqual(self.wait_for_map().data, before.data)
        answer = self.call("load_map", LoadMap, path=self.write_map("large.yaml", 1100.0))
        self.assertTrue(answer.success, answer.message)
        self.assertIn("not all of it is used", answer.message)
        self.assertIn("too large to be searched", answer.message)

    def test_9_a_grid_that_was_not_saved_is_told_to_be_missing(self):
        answer = self.call("load_map", LoadMap, path=str(self.folder / "early.yaml"))
        if rospy.get_param("~backend") != "pf":  # they have no use for landmarks alone
            self.assertFalse(answer.success)
            self.assertIn("the map holds no occupancy grid", answer.message)
            return
        self.assertTrue(answer.success, answer.message)
        self.assertIn("no grid found; 0 landmarks", answer.message)


if __name__ == "__main__":
    rospy.init_node("grid_map_test")
    rostest.rosrun("slam_tests", "grid_map", GridMapTest, sys.argv)
