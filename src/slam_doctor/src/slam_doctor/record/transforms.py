# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The transforms that were published, and by whom."""
import dataclasses
import math

import numpy as np

STILL = 1e-6  # a mount that has moved by no more has stood still [m, rad]


@dataclasses.dataclass
class Edge:
    """The transform from a frame to its child."""

    parent: str
    child: str
    is_static: bool
    pose: tuple            # x, y, z [m], quaternion x, y, z, w
    moved: bool = False
    publishers: set = dataclasses.field(default_factory=set)

    def matrix(self):
        """The child's pose in the parent's frame, 4 x 4."""
        x, y, z, w = self.pose[3:] / np.linalg.norm(self.pose[3:])
        out = np.eye(4)
        out[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                       [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                       [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
        out[:3, 3] = self.pose[:3]
        return out


class TransformRecord:
    """The edges of /tf and /tf_static."""

    def __init__(self):
        self.edges = {}  # (parent, child): Edge
        self.not_finite = self.not_normal = 0

    def take(self, message, is_static, publisher):
        """Takes a message; publisher: the name of its node. Returns the transforms with stamps."""
        for each in message.transforms:
            t, q = each.transform.translation, each.transform.rotation
            self._add(each.header.frame_id.lstrip("/"), each.child_frame_id.lstrip("/"),
                      (t.x, t.y, t.z, q.x, q.y, q.z, q.w), is_static, publisher)

    def _add(self, parent, child, pose, is_static, publisher):
        if not all(map(math.isfinite, pose)):
            self.not_finite += 1
            return
        length = math.hypot(*pose[3:])
        if abs(length - 1.0) > 0.01:
            self.not_normal += 1
            if length < 1e-6:
                return
        pose = np.array(pose)
        edge = self.edges.setdefault((parent, child), Edge(parent, child, is_static, pose))
        edge.moved |= bool(np.abs(pose - edge.pose).max() > STILL)
        edge.pose, edge.is_static = pose, edge.is_static or is_static
        edge.publishers.add(publisher)

    def parents(self, child):
        """The frames that a frame is said to be mounted in."""
        return [edge.parent for edge in self.edges.values() if edge.child == child]

    def frames(self):
        """All frames."""
        return {name for pair in self.edges for name in pair}

    def chain(self, frame, base):
        """The edges from a frame down to the base frame; None where there is no way."""
        edges = []
        while frame != base:
            edge = next((e for e in self.edges.values() if e.child == frame), None)
            if edge is None or edge in edges:
                return None
            edges.append(edge)
            frame = edge.parent
        return edges

    def mount(self, frame, base):
        """The pose of a frame in the base frame, 4 x 4; None where there is none."""
        edges = self.chain(frame, base)
        if edges is None:
            return None
        out = np.eye(4)
        for edge in edges:
            out = edge.matrix() @ out
        return out
