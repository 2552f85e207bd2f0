# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The node behind `latency_probe`: notes when images and poses arrive, and the manager's CPU."""
import argparse
import dataclasses
import json
import os
import pathlib
import time
import xmlrpc.client

import rospy

from slam_eval.io.atomic_file import write_atomically
from slam_eval.metrics.latency import latency, stamp_of

_PERIOD = 0.25  # [s], between two looks at the CPU time


class Arrivals:
    """When the messages of a topic arrived [s], by stamp [ns]."""

    def __init__(self, topic):
        self.times = {}
        # Not deserialised: an image would take longer than what is measured.
        self._subscriber = rospy.Subscriber(topic, rospy.AnyMsg, self._note, queue_size=1000,
                                            tcp_nodelay=True)

    def _note(self, message):
        now = time.monotonic()
        self.times.setdefault(stamp_of(message._buff), now)


class NodeCpu:
    """CPU time of a node's process, from its first look on."""

    def __init__(self, name):
        self._name, self._pid, self._looks = name, None, []

    def _find(self):
        master = xmlrpc.client.ServerProxy(os.environ["ROS_MASTER_URI"])
        try:
            _, _, uri = master.lookupNode(rospy.get_name(), rospy.resolve_name(self._name))
            _, _, self._pid = xmlrpc.client.ServerProxy(uri).getPid(rospy.get_name())
        except (OSError, ValueError, xmlrpc.client.Error):
            self._pid = None  # not there yet

    def look(self):
        """Note the CPU time up to now."""
        if not self._pid:
            self._find()
        try:
            fields = pathlib.Path(f"/proc/{self._pid}/stat").read_text("ascii").rpartition(")")[2]
        except OSError:
            return  # not there yet, or no more
        user, system = fields.split()[11:13]
        self._looks.append((time.monotonic(),
                            (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")))

    def share(self):
        """CPU time over the time watched, or None."""
        if len(self._looks) < 2 or self._looks[-1][0] <= self._looks[0][0]:
            return None
        (start, first), (end, last) = self._looks[0], self._looks[-1]
        return (last - first) / (end - start)


def main():
    """Entry point: runs until it is told to end, then writes the JSON file."""
    parser = argparse.ArgumentParser(
        prog="latency_probe", description="Measures the time from image to pose until it is ended.")
    parser.add_argument("out", metavar="OUT.json", type=pathlib.Path)
    parser.add_argument("--image", default="camera/image_raw/compressed", metavar="TOPIC")
    parser.add_argument("--pose", default="pose", metavar="TOPIC")
    parser.add_argument("--node", default="slam_manager", metavar="NAME",
                        help="the node whose CPU time is taken (%(default)s)")
    options = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("latency_probe", anonymous=True)
    images, poses = Arrivals(options.image), Arrivals(options.pose)
    cpu = NodeCpu(options.node)
    while not rospy.is_shutdown():
        cpu.look()
        time.sleep(_PERIOD)
    result = latency(images.times, poses.times)
    figures = dataclasses.asdict(result) if result else {
        "images": len(images.times), "poses": len(poses.times)}
    write_atomically(options.out, json.dumps({**figures, "cpu": cpu.share()}, indent=2) + "\n")
    return 0
