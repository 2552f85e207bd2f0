# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The node landmark_labels: the map's landmarks in, their labels out."""
import pathlib
import sys
import threading

import rospy
from slam_msgs.msg import LandmarkLabels, LandmarkMap
from slam_msgs.srv import LabelLandmark, LabelLandmarkResponse
from std_srvs.srv import Trigger, TriggerResponse
from visualization_msgs.msg import Marker, MarkerArray

from slam_labels import file
from slam_labels.labels import LabelError, Labels

TEXT_HEIGHT = 0.25  # [m], as that of the ids
BESIDE = 0.08       # [m], from the landmark


class LandmarkLabelsNode:
    """Raises LabelError where the file cannot be used."""

    def __init__(self, labels, save, radius):
        """labels, save: paths, or empty; radius: [m]."""
        if not (file.is_finite(radius) and radius > 0):
            raise LabelError(f"radius is {radius}; it has to be a number larger than 0 m")
        self._lock = threading.Lock()
        self._labels = Labels(file.read(file.path_of(labels)) if labels else [], radius)
        self._save_to = save
        self._header, self._landmarks = None, {}
        self._said = set()
        self._labels_out = rospy.Publisher("landmark_labels", LandmarkLabels, queue_size=1,
                                           latch=True)
        self._markers_out = rospy.Publisher("landmark_label_markers", MarkerArray, queue_size=1,
                                            latch=True)
        self._subscriber = rospy.Subscriber("landmarks", LandmarkMap, self._take, queue_size=1)
        self._services = [rospy.Service("label_landmark", LabelLandmark, self._on_label),
                          rospy.Service("save_labels", Trigger, self._on_save)]

    def _take(self, message):
        with self._lock:
            self._header = message.header
            self._landmarks = {each.id: (each.x, each.y) for each in message.landmarks}
            sentences = self._labels.update(self._landmarks)
            self._publish()
        for sentence in sentences:
            if sentence not in self._said:
                self._said.add(sentence)
                rospy.logwarn(sentence)

    def _publish(self):
        named = self._labels.of_map()
        self._labels_out.publish(LandmarkLabels(self._header, list(named), list(named.values())))
        markers = [Marker(header=self._header, action=Marker.DELETEALL)]
        markers += [self._marker(number, identity, text)
                    for number, (identity, text) in enumerate(named.items())]
        self._markers_out.publish(MarkerArray(markers))

    def _marker(self, number, identity, text):
        """number: of the marker, whose id has 32 bits; that of a landmark has 64."""
        x, y = self._landmarks[identity]
        marker = Marker(header=self._header, ns="label", id=number, text=text,
                        type=Marker.TEXT_VIEW_FACING, action=Marker.ADD)
        marker.pose.position.x, marker.pose.position.y = x + BESIDE, y - TEXT_HEIGHT
        marker.pose.position.z, marker.pose.orientation.w = 0.1, 1.0
        marker.scale.z = TEXT_HEIGHT
        marker.color.r, marker.color.g, marker.color.b, marker.color.a = 0.1, 0.1, 0.5, 1.0
        return marker

    def _on_label(self, request):
        with self._lock:
            try:
                said = self._labels.give(request.id, request.label, self._landmarks)
            except LabelError as fault:
                return LabelLandmarkResponse(False, str(fault))
            self._publish()
        return LabelLandmarkResponse(True, said)

    def _on_save(self, _):
        try:
            return TriggerResponse(True, f"the labels are in {self.save()}")
        except LabelError as fault:
            return TriggerResponse(False, str(fault))

    def save(self):
        """Writes the labels; returns where. Raises LabelError."""
        if not self._save_to:
            raise LabelError("there is no file for the labels: start the node with save:=FOLDER")
        with self._lock:
            path = file.path_of(self._save_to)
            file.write(path, self._labels.all)
        return path

    def end(self):
        """Saves what is to be saved at the end."""
        if self._save_to:
            self.save()


def path_from(name):
    """The path that a parameter means, or none: a relative one is seen from ~folder."""
    path = str(rospy.get_param(name, ""))
    return pathlib.Path(rospy.get_param("~folder", "").strip()) / path if path else None


def main():
    """Runs the node until ROS ends it; returns its exit code."""
    rospy.init_node("landmark_labels")
    try:
        node = LandmarkLabelsNode(path_from("~labels"), path_from("~save"),
                                  rospy.get_param("~radius", 1.0))
        rospy.spin()
        node.end()
    except LabelError as fault:
        print(f"landmark_labels: {fault}", file=sys.stderr)
        return 1
    return 0
