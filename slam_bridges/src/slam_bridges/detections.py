# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The messages of other packages' detectors, of which none has to be installed."""
import dataclasses

import genmsg
import genpy.dynamic


@dataclasses.dataclass(frozen=True)
class Marker:
    """A marker that a camera has seen."""

    id: int
    frame: str       # of the position; empty: that of the array
    position: tuple  # of its middle in the camera's optical frame: x right, y down, z ahead [m]


def of_apriltag_ros(message, account):
    """The Markers of an apriltag_ros/AprilTagDetectionArray; account counts the bundles in it."""
    for detection in message.detections:
        if len(detection.id) != 1:
            account.add("bundle")
            continue
        at = detection.pose.pose.pose.position
        yield Marker(detection.id[0], detection.pose.header.frame_id.lstrip("/"),
                     (at.x, at.y, at.z))


def of_fiducial_msgs(message, account):
    """The Markers of a fiducial_msgs/FiducialTransformArray, as aruco_detect publishes it."""
    for each in message.transforms:
        at = each.transform.translation
        yield Marker(each.fiducial_id, "", (at.x, at.y, at.z))


READERS = {"apriltag_ros/AprilTagDetectionArray": of_apriltag_ros,
           "fiducial_msgs/FiducialTransformArray": of_fiducial_msgs}


class Types:
    """The classes of messages, made of the definitions that connections carry."""

    def __init__(self):
        self._classes = {}  # (type, MD5 sum): class

    def unpack(self, kind, md5, definition, data):
        """The message of a type in serialised data. Raises genpy.MessageException."""
        key = (kind, md5)
        if key not in self._classes:
            self._classes[key] = class_of(kind, definition)
        return self._classes[key]().deserialize(data)


def class_of(kind, definition):
    """The class of a type. Raises genpy.MessageException where the definition makes none."""
    try:
        return genpy.dynamic.generate_dynamic(kind, definition)[kind]
    except (genmsg.InvalidMsgSpec, genmsg.MsgNotFound, ValueError) as fault:
        raise genpy.MessageException(str(fault)) from fault
