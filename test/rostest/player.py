# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plays a recorded log into the nodelets and collects what they publish."""

import copy
import os
import subprocess
import tempfile
import threading
import time

from catkin.find_in_workspaces import find_in_workspaces
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseArray, PoseWithCovarianceStamped
from nav_msgs.msg import Odometry, Path
import rosbag
from rosgraph_msgs.msg import Clock, Log
import rospy
from slam_msgs.msg import Consistency, LandmarkMap, LandmarkObservationArray, Motion
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

RAWLOG = "/usr/share/mrpt/datasets/kf-slam_demo.rawlog"
OUTPUTS = {"pose": PoseWithCovarianceStamped, "path": Path, "landmarks": LandmarkMap,
           "landmark_markers": MarkerArray, "particlecloud": PoseArray,
           "consistency": Consistency, "motion": Motion,
           "/tf": TFMessage, "/diagnostics": DiagnosticArray, "/rosout": Log}


def read_log():
    """Returns the (topic, message) of a bag made now from MRPT's demonstration log."""
    program = find_in_workspaces(["libexec"], "slam_eval", "slam_import", first_match_only=True)[0]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "log.bag")
        subprocess.run([program, "rawlog", RAWLOG, path], check=True, stdout=subprocess.DEVNULL)
        with rosbag.Bag(path) as bag:
            return [(topic, message) for topic, message, _ in
                    bag.read_messages(topics=["/odom", "/observations"])]


def wait_for(condition, timeout=10.0):
    """Waits by the wall clock; returns whether the condition came true."""
    end = time.monotonic() + timeout
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.02)
    return True


class Player:
    """The inputs of a product and all that it has published since clear()."""

    def __init__(self):
        self.log = read_log()
        self.lock = threading.Lock()
        self.now = rospy.Time(0)  # of the clock; to set it to zero lets it jump back
        self.received = {}
        self.clear()
        self.clock = rospy.Publisher("/clock", Clock, queue_size=100)
        self.publishers = {
            "/odom": self.advertise_odometry(),
            "/observations": rospy.Publisher("observations", LandmarkObservationArray,
                                             queue_size=1000),
            "initialpose": rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=1)}
        self.subscribers = [rospy.Subscriber(topic, kind, self.keep, topic, queue_size=10000)
                            for topic, kind in OUTPUTS.items()]
        self.connected = wait_for(lambda: all(p.get_num_connections() > 0
                                              for p in self.publishers.values()), 30)
        rospy.wait_for_service("reset", 10)

    def advertise_odometry(self):
        return rospy.Publisher("odom", Odometry, queue_size=1000)

    def keep(self, message, topic):
        with self.lock:
            self.received[topic].append(message)

    def get(self, topic):
        with self.lock:
            return list(self.received[topic])

    def clear(self):
        with self.lock:
            self.received = {topic: [] for topic in OUTPUTS}

    def send(self, topic, message):
        self.now = max(self.now, message.header.stamp)
        self.clock.publish(Clock(clock=self.now))
        self.publishers[topic].publish(message)
        time.sleep(0.004)

    def play(self, messages=None):
        for topic, message in self.log if messages is None else messages:
            self.send(topic, message)

    def advance(self, seconds):
        """Lets the clock run on after the last message."""
        end = self.log[-1][1].header.stamp
        for step in range(20):
            self.clock.publish(Clock(clock=end + rospy.Duration(seconds * (step + 1) / 20)))
            time.sleep(0.02)

    def begin(self, observations=20):
        """A fresh start: plays the beginning of the log; returns its messages."""
        rospy.ServiceProxy("reset", Trigger)()
        part = self.part(0, observations)
        self.turn_back(part[0][1].header.stamp)
        self.clear()
        self.play(part)
        assert wait_for(lambda: len(self.get("pose")) >= observations), \
            f"of {observations} poses at the beginning {len(self.get('pose'))} came"
        return part

    def turn_back(self, stamp):
        """Lets the clock jump to a stamp; nodelets hear of it on another connection than data."""
        self.now = stamp
        self.clock.publish(Clock(clock=stamp))
        wait_for(lambda: rospy.Time.now() == stamp, 1.0)
        time.sleep(0.3)

    def part(self, first, last):
        """The messages from the observation array `first` up to `last`."""
        marks = [i for i, (topic, _) in enumerate(self.log) if topic == "/observations"]
        start = marks[first - 1] + 1 if first else 0
        # the increment that leads to an array may stand behind it
        return [(topic, copy.deepcopy(message)) for topic, message in self.log[start:marks[last]]]

    def warnings(self):
        return [log.msg for log in self.get("/rosout") if log.level >= Log.WARN]

    def counters(self, nodelet):
        """The values of a nodelet's newest diagnostic."""
        for array in reversed(self.get("/diagnostics")):
            for status in array.status:
                if status.name.startswith(nodelet):
                    return {"level": status.level, "message": status.message,
                            **{entry.key: entry.value for entry in status.values}}
        return {}
