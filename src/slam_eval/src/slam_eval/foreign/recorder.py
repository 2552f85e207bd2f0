# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A node that replays a bag to whoever listens, and writes down map -> odom and the grid that come
back."""
import pathlib
import subprocess
import sys
import time

from nav_msgs.msg import OccupancyGrid
import numpy as np
import rospy
from tf2_msgs.msg import TFMessage

from slam_eval.foreign.bag_data import planar, planar_transform
from slam_eval.foreign.results import write_grid, write_trajectory
from slam_eval.foreign.ros_node import MAP_ODOM, UNREPLAYED
from slam_eval.io.bag import open_bag
from slam_eval.io.trajectory import Trajectory

_AFTERWARDS = 1.0  # [s] of the wall clock, for what is on its way when the bag ends
_UNKNOWN = 0.5


class Recorder:
    """Listens until write() is called."""

    def __init__(self, map_frame, odom_frame):
        self._frames = map_frame, odom_frame
        self._poses, self._grid = {}, None
        self._subscribers = [rospy.Subscriber("/tf", TFMessage, self._hear, queue_size=1000),
                             rospy.Subscriber("map", OccupancyGrid, self._take, queue_size=1)]

    def _hear(self, message):
        for transform in message.transforms:
            frames = transform.header.frame_id.lstrip("/"), transform.child_frame_id.lstrip("/")
            if frames == self._frames:
                stamp = transform.header.stamp.to_nsec()
                self._poses[stamp] = planar_transform(transform.transform)

    def _take(self, grid):
        self._grid = grid

    def _write_grid(self, folder):
        about = self._grid.info
        x, y, yaw = planar(about.origin)
        if abs(yaw) > 1e-6:
            rospy.logwarn("the grid is turned by %g rad, which map.yaml cannot say: left out", yaw)
            return
        cells = np.array(self._grid.data, dtype=float).reshape(about.height, about.width)
        free = np.where(cells < 0, _UNKNOWN, 1.0 - cells / 100.0)
        write_grid(folder, free[::-1], about.resolution, (x, y))

    def write(self, folder):
        """The files of what was heard."""
        for subscriber in self._subscribers:
            subscriber.unregister()
        stamps = sorted(self._poses)
        write_trajectory(folder / MAP_ODOM, Trajectory(
            stamps, np.array([self._poses[stamp] for stamp in stamps]).reshape(-1, 3)))
        if self._grid is not None and self._grid.info.width:
            self._write_grid(folder)


def _unheard(topics, patience):
    """Those of the topics to which no other node listens when time is over; patience: [s] of the
    wall clock."""
    end, own = time.monotonic() + patience, {rospy.get_name()}
    while True:
        _, _, (_, subscribed, _) = rospy.get_master().getSystemState()
        heard = {topic for topic, nodes in subscribed if set(nodes) - own}
        missing = [topic for topic in topics if rospy.resolve_name(topic) not in heard]
        if not missing or time.monotonic() > end:
            return missing
        time.sleep(0.2)


def _topics_of(bag, topics):
    """Those of the topics that are in a bag, as it names them."""
    with open_bag(bag) as opened:
        there = opened.get_type_and_topic_info().topics
    return [name for topic in topics for name in (topic.lstrip("/"), f"/{topic.lstrip('/')}")
            if name in there]


def _fault(topics, patience):
    """Why the bag cannot be replayed to the nodes, in a sentence; None where it can."""
    if not topics:
        return "the bag has none of the topics; under 'topics' name those that it has"
    unheard = _unheard(topics, patience)
    return unheard and (f"nobody listened to {', '.join(unheard)} {patience:g} s after the start; "
                        "under 'topics' name those to which the nodes listen")


def main():
    """Entry point: BAG FOLDER MAP_FRAME ODOM_FRAME RATE PATIENCE TOPIC..."""
    bag, folder, map_frame, odom_frame, rate, patience, *topics = rospy.myargv(sys.argv)[1:]
    rospy.init_node("foreign_recorder")
    recorder = Recorder(map_frame, odom_frame)
    topics = _topics_of(bag, topics)
    fault = _fault(topics, float(patience))
    if fault:
        pathlib.Path(folder, UNREPLAYED).write_text(fault, encoding="utf-8")
        return 1
    code = subprocess.call(["rosbag", "play", "--quiet", "--clock", "--wait-for-subscribers",
                            "--rate", rate, bag, "--topics", *topics])
    time.sleep(_AFTERWARDS)
    recorder.write(pathlib.Path(folder))
    return code
