# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Detections of markers become observations of landmarks."""
import math

from geometry_msgs.msg import Pose2D
import numpy as np
from slam_msgs.msg import LandmarkObservation, LandmarkObservationArray

from slam_bridges.detections import READERS

STEEPEST = 0.05  # the range in the plane over the distance, at least
UNKNOWN = [-1.0, 0.0, 0.0, 0.0]  # covariance: the robot file's sigmas apply


class Converter:
    """Converts the messages of one topic in their order.

    Range and bearing are those of the product's own detector: in the robot's horizontal plane, from
    the place of the camera, bearing 0 along the robot's x axis.
    """

    def __init__(self, mounts, account):
        self._mounts, self._account = mounts, account
        self._frame, self._pose = "", None
        self._sequence = 0

    def convert(self, topic, kind, message):
        """The LandmarkObservationArray of a message; empty where nothing was seen, None, and a
        count, where it cannot be used."""
        if kind not in READERS:
            self._account.add("other_type", topic=topic, kind=kind)
            return None
        try:
            header, markers = message.header, list(READERS[kind](message, self._account))
        except AttributeError as fault:  # the package has changed its message
            self._account.add("unreadable", kind=kind, topic=topic, cause=fault)
            return None
        pose = self._mount_of(header, markers)
        if pose is None:
            return None
        array = LandmarkObservationArray(sequence=self._sequence)
        array.header.stamp, array.header.frame_id = header.stamp, self._frame
        array.sensor_pose = Pose2D(pose.translation[0], pose.translation[1], 0.0)
        array.observations = [z for z in (self._observe(marker, pose) for marker in markers) if z]
        self._sequence += 1
        return array

    def _mount_of(self, header, markers):
        """The Pose of the camera on the robot; None where it or the stamp is not known."""
        frames = [header.frame_id.lstrip("/"), *(marker.frame for marker in markers), self._frame]
        frame = next(filter(None, frames), "")
        if header.stamp.is_zero():
            self._account.add("no_stamp")
            return None
        if not frame:
            self._account.add("no_frame")
            return None
        pose = self._mounts.of(frame)
        if pose is not None:
            self._watch(frame, pose)
        return pose

    def _watch(self, frame, pose):
        """Reports a camera that is another one, or elsewhere, than before."""
        if self._frame and frame != self._frame:
            self._account.add("frame_change", frame=frame, before=self._frame)
        elif self._pose is not None and not pose.is_near(self._pose):
            self._account.add("mount_change", frame=frame)
        self._frame, self._pose = frame, pose

    def _observe(self, marker, pose):
        """The LandmarkObservation of a marker; None, and a count, where it cannot be used."""
        fault = self._fault_of(marker, pose)
        if fault:
            self._account.add(fault, id=marker.id, other=marker.frame, frame=self._frame)
            return None
        x, y, _ = pose.rotation @ np.array(marker.position)
        return LandmarkObservation(id=marker.id, range=math.hypot(x, y), bearing=math.atan2(y, x),
                                   covariance=UNKNOWN)

    def _fault_of(self, marker, pose):
        """The reason for which a marker cannot be used; empty where it can."""
        if marker.id < 0:
            return "bad_id"
        if marker.frame not in ("", self._frame):
            return "other_frame"
        if not all(map(math.isfinite, marker.position)):
            return "not_finite"
        if marker.position[2] <= 0.0:
            return "behind_camera"
        offset = pose.rotation @ np.array(marker.position)
        is_steep = math.hypot(*offset[:2]) < STEEPEST * np.linalg.norm(offset)
        return "too_steep" if is_steep else ""
