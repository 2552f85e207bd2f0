# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where cameras sit on the robot, by its transforms or its robot file."""
import dataclasses
import math

import numpy as np

STILL = 1e-6  # a transform on /tf that has changed by no more has stood still [m, 1]
NORMAL = 0.01  # a quaternion's length may differ from 1 by so much


@dataclasses.dataclass(frozen=True)
class Pose:
    """A frame's pose in another one."""

    rotation: np.ndarray     # 3 x 3
    translation: np.ndarray  # [m]

    def __matmul__(self, other):
        """The pose of a frame that `other` has in this frame."""
        return Pose(self.rotation @ other.rotation, self.apply(other.translation))

    def apply(self, point):
        """A point of this frame, seen from the other one [m]."""
        return self.rotation @ point + self.translation

    def is_near(self, other):
        """Whether both are the same but for rounding."""
        return bool(np.abs(self.rotation - other.rotation).max() < 10 * STILL and
                    np.abs(self.translation - other.translation).max() < 10 * STILL)


def pose_of_quaternion(values):
    """The Pose of (x, y, z [m], quaternion x, y, z, w)."""
    x, y, z, w = np.array(values[3:]) / np.linalg.norm(values[3:])
    return Pose(np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                          [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                          [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]),
                np.array(values[:3], float))


def pose_of_angles(values):
    """The Pose of (x, y, z [m], roll, pitch, yaw [rad]), as robot files give it."""
    (sr, sp, sy), (cr, cp, cy) = np.sin(values[3:]), np.cos(values[3:])
    return Pose(np.array([[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                          [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
                          [-sp, cp * sr, cp * cr]]), np.array(values[:3], float))


IDENTITY = Pose(np.eye(3), np.zeros(3))


@dataclasses.dataclass
class Edge:
    """The transform from a frame to its child."""

    parent: str
    values: tuple  # x, y, z [m], quaternion x, y, z, w
    is_static: bool
    moved: bool = False


class Mounts:
    """The poses of sensors in the robot's base frame.

    base: the robot's base frame; fixed: the Pose of every camera there, where the robot file gives
    it; account: an Account of what is wrong with transforms.
    """

    def __init__(self, base, account, fixed=None):
        self.base, self._account, self._fixed = base, account, fixed
        self._edges = {}  # child: Edge

    def take(self, message, is_static):
        """Takes a tf2_msgs/TFMessage, of /tf_static or of /tf."""
        for each in message.transforms:
            t, q = each.transform.translation, each.transform.rotation
            self._add(each.header.frame_id.lstrip("/"), each.child_frame_id.lstrip("/"),
                      (t.x, t.y, t.z, q.x, q.y, q.z, q.w), is_static)

    def _add(self, parent, child, values, is_static):
        known = self._edges.get(child)
        if not all(map(math.isfinite, values)) or abs(math.hypot(*values[3:]) - 1) > NORMAL:
            self._account.add("bad_transform", parent=parent, child=child)
        elif known is None or is_static:
            self._edges[child] = Edge(parent, values, is_static)
        elif not known.is_static:
            apart = max(abs(a - b) for a, b in zip(known.values, values))
            known.moved |= parent != known.parent or apart > STILL

    def of(self, frame):
        """The Pose of a frame in the base frame; None, and a count, where there is none."""
        if self._fixed is not None:
            return self._fixed
        pose, child, passed = IDENTITY, frame, set()
        while child != self.base:
            edge = self._edges.get(child)
            if edge is None or child in passed:
                self._account.add("no_mount", base=self.base, frame=frame)
                return None
            if edge.moved:
                self._account.add("moving_mount", parent=edge.parent, child=child)
                return None
            passed.add(child)
            pose, child = pose_of_quaternion(edge.values) @ pose, edge.parent
        return pose
