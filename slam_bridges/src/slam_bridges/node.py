# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The node fiducial_bridge: detections in, observations out."""
import sys
import threading
import time

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
import genpy
import rospy
from slam_launch.errors import ProductError
from slam_msgs.msg import LandmarkObservationArray
from tf2_msgs.msg import TFMessage

from slam_bridges.account import Account
from slam_bridges.converter import Converter
from slam_bridges.detections import READERS, Types
from slam_bridges.robot import mounts_of

QUIET = 5.0  # a warning is repeated after, and an input missed after so long [s of the wall]
QUEUE = 1000  # messages


class Warnings:
    """The sentences that go to the console, each kind at most every QUIET seconds."""

    def __init__(self):
        self.last, self.at = "", -QUIET
        self._said = {}  # reason: when

    def say(self, reason, sentence):
        """Takes a sentence."""
        self.last, self.at = sentence, time.monotonic()
        if self.at - self._said.get(reason, -QUIET) >= QUIET:
            self._said[reason] = self.at
            rospy.logwarn(sentence)

    def are_recent(self):
        """Whether there was a warning in the last QUIET seconds."""
        return time.monotonic() - self.at < QUIET


class FiducialBridge:
    """Subscribes to one topic, whatever its type, and publishes what it brings.

    robot: NAME or FILE of a robot file, or empty. Raises ProductError where it cannot be used.
    """

    def __init__(self, robot):
        self._lock = threading.Lock()
        self._warnings = Warnings()
        self._account = Account(self._warnings.say)
        self._mounts = mounts_of(robot, self._account)
        self._converter = Converter(self._mounts, self._account)
        self._types = Types()
        self._arrays = self._observations = 0
        self._came = time.monotonic()
        self._topic = rospy.resolve_name("tag_detections")
        self._out = rospy.Publisher("observations", LandmarkObservationArray, queue_size=QUEUE)
        self._diagnostics = rospy.Publisher("/diagnostics", DiagnosticArray, queue_size=10)
        self._subscribers = [
            rospy.Subscriber("/tf_static", TFMessage, self._take_transforms, True),
            rospy.Subscriber("/tf", TFMessage, self._take_transforms, False, queue_size=QUEUE),
            rospy.Subscriber("tag_detections", rospy.AnyMsg, self._take, queue_size=QUEUE)]

    def _take_transforms(self, message, is_static):
        with self._lock:
            self._mounts.take(message, is_static)

    def _take(self, packed):
        with self._lock:
            self._came = time.monotonic()
            array = self._convert(packed)
            if array is None:
                return
            self._arrays += 1
            self._observations += len(array.observations)
        self._out.publish(array)

    def _convert(self, packed):
        """The observations of a message that is still packed; None where it cannot be used."""
        header = packed._connection_header
        kind, message = header["type"], None
        try:
            if kind in READERS:
                message = self._types.unpack(kind, header["md5sum"],
                                             header.get("message_definition", ""), packed._buff)
        except (genpy.MessageException, KeyError) as fault:
            self._account.add("unreadable", kind=kind, topic=self._topic, cause=fault)
            return None
        return self._converter.convert(self._topic, kind, message)

    def report(self):
        """Publishes the state; called about once a second."""
        with self._lock:
            if time.monotonic() - self._came > QUIET:
                self._warnings.say("waiting", f"waiting for detections on {self._topic}")
            is_well = not self._warnings.are_recent()
            status = DiagnosticStatus(
                name=f"{rospy.get_name().lstrip('/')}: state", hardware_id="none",
                level=DiagnosticStatus.OK if is_well else DiagnosticStatus.WARN,
                message="detections are converted" if is_well else self._warnings.last)
            figures = {"arrays": self._arrays, "observations": self._observations,
                       **self._account.counters, "last warning": self._warnings.last}
            status.values = [KeyValue(key, str(value)) for key, value in figures.items()]
        array = DiagnosticArray(status=[status])
        array.header.stamp = rospy.Time.now()
        self._diagnostics.publish(array)


def main():
    """Runs the node until ROS ends it; returns its exit code."""
    rospy.init_node("fiducial_bridge")
    try:
        bridge = FiducialBridge(rospy.get_param("~robot", ""))
    except ProductError as fault:
        print(f"fiducial_bridge: {fault}", file=sys.stderr)
        return 1
    while not rospy.is_shutdown():
        bridge.report()
        time.sleep(1.0)
    return 0
