#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what the back-end tells as lines of JSON: its poses, its state and, once both halves have
found each other, the topics that go from the front-end to it."""

import json
import time

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseWithCovarianceStamped
import rosgraph
import rospy

FRONT_END, BACK_END = "/slam_manager", "/slam_manager_backend"


def tell(**event):
    print(json.dumps({"time": time.monotonic(), **event}), flush=True)


def on_diagnostics(array):
    for status in array.status:
        if status.name.startswith("slam_backend: state"):
            tell(state=status.message, level=status.level,
                 values={entry.key: entry.value for entry in status.values})


def crossing():
    """Returns the topics of the front-end that the back-end has subscribed to."""
    publishers, subscribers, _ = rosgraph.Master("/monitor").getSystemState()
    return sorted({topic for topic, nodes in publishers if FRONT_END in nodes} &
                  {topic for topic, nodes in subscribers if BACK_END in nodes})


def main():
    rospy.init_node("monitor")
    rospy.Subscriber("/diagnostics", DiagnosticArray, on_diagnostics)
    rospy.Subscriber("pose", PoseWithCovarianceStamped,
                     lambda pose: tell(pose=pose.header.stamp.to_nsec()))
    topics = []
    while not rospy.is_shutdown() and len(topics) < 2:
        time.sleep(0.2)
        topics = crossing()
    tell(crossing=topics)
    rospy.spin()


if __name__ == "__main__":
    main()
