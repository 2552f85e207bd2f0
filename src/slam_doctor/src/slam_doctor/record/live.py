# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Listens to a running robot for some seconds."""
import queue
import sys
import time

import rosgraph
import roslib.message
import rospy

from slam_doctor.errors import InputError
from slam_doctor.record.recording import (CALIBRATION, COMMANDS, COMPRESSED, IMAGE, IMU, MOTION,
                                          OBSERVATIONS, ODOMETRY, Recording, SCAN, TEXT,
                                          TRANSFORMS)

KINDS = {CALIBRATION, COMMANDS, COMPRESSED, IMAGE, IMU, MOTION, OBSERVATIONS, ODOMETRY, SCAN,
         TEXT, *TRANSFORMS}
MOST_WAITING = 2000  # messages that have not been looked at


class Listener:
    """Subscribes to all topics of the types that SLAM knows, also to those that appear later."""

    def __init__(self):
        self.messages = queue.Queue(MOST_WAITING)
        self.lost = 0  # messages for which there was no time
        self._subscribers = {}

    def look_for_topics(self):
        """Subscribes to what has appeared."""
        for topic, kind in rospy.get_published_topics():
            if kind in KINDS and topic not in self._subscribers:
                self._subscribers[topic] = rospy.Subscriber(
                    topic, rospy.AnyMsg, self._take, (topic, kind), queue_size=100)

    def _take(self, message, about):
        header = message._connection_header or {}
        try:
            self.messages.put_nowait((*about, message._buff, rospy.get_rostime().to_nsec(),
                                      header.get("callerid", "")))
        except queue.Full:
            self.lost += 1


def listen(seconds):
    """The Recording of what a running robot publishes. Raises InputError."""
    if not rosgraph.is_master_online():
        raise InputError("no ROS master answers at $ROS_MASTER_URI; start the robot first, or name "
                         "a bag instead of 'live'")
    rospy.init_node("slam_doctor", anonymous=True, disable_signals=True)
    listener, recording = Listener(), Recording("live", is_live=True)
    end, look = time.monotonic() + seconds, 0.0
    while time.monotonic() < end:
        if time.monotonic() >= look:
            listener.look_for_topics()
            look = time.monotonic() + 1.0
        take_next(listener.messages, recording)
    if recording.start is None:
        raise InputError(f"in {seconds:g} s no message came on any topic that SLAM could use; are "
                         "the drivers running, and is a bag being played with --clock if "
                         "use_sim_time is set?")
    if listener.lost:
        print(f"slam_doctor: {listener.lost} messages were left out, this machine is too slow for "
              "them; gaps may be the doctor's own", file=sys.stderr)
    return recording


def take_next(messages, recording):
    """Looks at the next message, where there is one."""
    try:
        topic, kind, raw, arrival, publisher = messages.get(timeout=0.1)
    except queue.Empty:
        return
    message_class = roslib.message.get_message_class(kind)
    if message_class is not None:
        recording.take(topic, kind, raw, message_class, arrival, publisher)
