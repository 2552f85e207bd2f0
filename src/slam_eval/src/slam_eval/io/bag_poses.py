# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Poses out of a bag, whatever message they come in."""
import numpy as np

from slam_eval.io.bag import open_bag, yaw
from slam_eval.io.errors import did_you_mean, InputError
from slam_eval.io.trajectory import require_headings_alike, Trajectory

DEFAULT_TOPIC = "/ground_truth/pose"
_PATH, _TRANSFORMS = "nav_msgs/Path", "tf2_msgs/TFMessage"


def _stamp(header):
    return header.stamp.to_nsec()


def _poses_of(kind, message, frame):
    """(stamp [ns], position, quaternion or None) of each pose in a message."""
    if kind in ("nav_msgs/Odometry", "geometry_msgs/PoseWithCovarianceStamped"):
        return [(_stamp(message.header), message.pose.pose.position, message.pose.pose.orientation)]
    if kind == "geometry_msgs/PoseStamped":
        return [(_stamp(message.header), message.pose.position, message.pose.orientation)]
    if kind == "geometry_msgs/PointStamped":
        return [(_stamp(message.header), message.point, None)]
    if kind == _PATH:
        return [(_stamp(each.header), each.pose.position, each.pose.orientation)
                for each in message.poses]
    found = message.transforms if kind == _TRANSFORMS else [message]
    return [(_stamp(each.header), each.transform.translation, each.transform.rotation)
            for each in found
            if frame is None or each.child_frame_id.lstrip("/") == frame.lstrip("/")]


KINDS = ("nav_msgs/Odometry", _PATH, "geometry_msgs/PoseStamped",
         "geometry_msgs/PoseWithCovarianceStamped", "geometry_msgs/PointStamped",
         "geometry_msgs/TransformStamped", _TRANSFORMS)


def _planar(where, position, q):
    """x, y, heading; no heading (NaN) where there is no quaternion or one of zeros."""
    rotation = (0.0, 0.0, 0.0, 0.0) if q is None else (q.x, q.y, q.z, q.w)
    if not np.all(np.isfinite((position.x, position.y, *rotation))):
        raise InputError(f"{where}: a pose is not finite (NaN or infinite); mend what writes it")
    if rotation == (0.0, 0.0, 0.0, 0.0):
        return position.x, position.y, np.nan
    return position.x, position.y, yaw(q)


def _chosen(path, topics, topic, frame):
    """The topic with or without a slash, and its kind of message. Raises InputError."""
    usable = sorted(name for name, about in topics.items() if about.msg_type in KINDS)
    name = next((each for each in (topic, f"/{topic}") if each in topics), None)
    if name is None:
        raise InputError(f"{path}: there is no topic '{topic}'{did_you_mean(topic, usable)}; those "
                         f"with poses are: {', '.join(usable) or 'none'}")
    kind = topics[name].msg_type
    if kind not in KINDS:
        raise InputError(f"{path}: {name} is of {kind}, which holds no poses; those with poses "
                         f"are: {', '.join(usable) or 'none'}")
    if kind == _TRANSFORMS and frame is None:
        raise InputError(f"{path}: {name} holds transforms of many frames; name the robot's, as a "
                         "child, with --truth-frame")
    return name, kind


def _trajectory(path, name, found):
    """The poses by their stamps; of two with one stamp the first."""
    if not found:
        raise InputError(f"{path}: {name} holds no pose that was asked for; check topic and frame")
    rows = {}
    for stamp, position, quaternion in found:
        rows.setdefault(stamp, _planar(f"{path}: {name}", position, quaternion))
    stamps = sorted(rows)
    poses = np.array([rows[stamp] for stamp in stamps], dtype=float)
    require_headings_alike(f"{path}: {name}", poses)
    return Trajectory(np.array(stamps, dtype=np.int64), poses)


def read_bag_poses(path, topic=DEFAULT_TOPIC, frame=None):
    """The poses of a bag's topic as a Trajectory; of transforms those to a child frame, of a path
    the last one that was published. Raises InputError."""
    with open_bag(path) as bag:
        name, kind = _chosen(path, bag.get_type_and_topic_info().topics, topic, frame)
        found = []
        for _, message, _ in bag.read_messages(topics=[name]):
            if kind == _PATH:
                found.clear()
            found.extend(_poses_of(kind, message, frame))
    return _trajectory(path, name, found)
