# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""All that a bag or a running robot has said."""
from slam_doctor.record.camera import CalibrationRecord, ImageRecord
from slam_doctor.record.imu import ImuRecord
from slam_doctor.record.laser import LaserRecord
from slam_doctor.record.observations import ObservationRecord
from slam_doctor.record.odometry import heading_of, OdometryRecord
from slam_doctor.record.stream import Stream
from slam_doctor.record.transforms import TransformRecord

ODOMETRY, SCAN, IMU = "nav_msgs/Odometry", "sensor_msgs/LaserScan", "sensor_msgs/Imu"
IMAGE, COMPRESSED = "sensor_msgs/Image", "sensor_msgs/CompressedImage"
CALIBRATION, OBSERVATIONS = "sensor_msgs/CameraInfo", "slam_msgs/LandmarkObservationArray"
COMMANDS = "geometry_msgs/TwistStamped"
MOTION, TEXT = "slam_msgs/Motion", "std_msgs/String"
SENSORS = (ODOMETRY, COMMANDS, SCAN, IMU, IMAGE, COMPRESSED, OBSERVATIONS)
TRANSFORMS = ("tf2_msgs/TFMessage", "tf/tfMessage")
ROBOT = "robot"  # the topic that names the robot file


class Topic:
    """A topic with its type, the times of its messages, and what they say where that is known.
    arrival_start, start: of the recording by arrivals and by stamps [ns]."""

    def __init__(self, name, kind, arrival_start, start):
        self.name, self.kind = name, kind
        self.stream = Stream(arrival_start, start)
        self.record = None
        if kind == ODOMETRY:
            self.record = OdometryRecord(start)
        elif kind == SCAN:
            self.record = LaserRecord(start)
        elif kind == IMU:
            self.record = ImuRecord(start)
        elif kind in (IMAGE, COMPRESSED):
            self.record = ImageRecord(start, kind == COMPRESSED)
        elif kind == CALIBRATION:
            self.record = CalibrationRecord()
        elif kind == OBSERVATIONS:
            self.record = ObservationRecord()


def stamp_of(raw):
    """The stamp [ns] of a packed message that begins with a header."""
    return (int.from_bytes(raw[4:8], "little") * 10**9 + int.from_bytes(raw[8:12], "little")
            if len(raw) >= 12 else None)


class Recording:
    """Takes messages as they come. Times are seconds: of arrivals since the first one, of stamps
    since the first stamp of a sensor, as a replayed bag's stamps may be years old."""

    def __init__(self, name, is_live=False):
        self.name, self.is_live = name, is_live
        self.start, self.end = None, None  # arrival [ns]
        self.stamp_start = None            # [ns]
        self.topics = {}
        self.transforms = TransformRecord()
        self.odometry_of_edges = {}  # (parent, child): OdometryRecord of transforms that move
        self.robot = None
        self.unreadable = {}  # how many messages of a topic could not be read

    def take(self, topic, kind, raw, message_class, arrival, publisher=""):
        """Takes a packed message. arrival [ns]; publisher: the node's name."""
        if self.start is None:
            self.start = arrival
        self.end = max(arrival, self.end or arrival)
        stamp = stamp_of(raw) if getattr(message_class, "_has_header", False) else None
        if self.stamp_start is None and stamp and kind in SENSORS:
            self.stamp_start = stamp
        known = self.topics.get(topic)
        if known is None:
            known = self.topics[topic] = Topic(topic, kind, self.start,
                                               self.stamp_start or arrival)
        known.stream.add(arrival, stamp)
        try:
            self._look(known, raw, message_class, publisher)
        except Exception:  # genpy raises whatever damaged bytes lead to
            self.unreadable[topic] = self.unreadable.get(topic, 0) + 1

    def _look(self, topic, raw, message_class, publisher):
        if isinstance(topic.record, ImageRecord):
            topic.record.take_raw(raw, message_class)
        elif topic.record is not None:
            topic.record.take(message_class().deserialize(raw))
        elif topic.kind in TRANSFORMS:
            self._take_transforms(topic, message_class().deserialize(raw), publisher)
        elif topic.kind == TEXT and topic.name.lstrip("/") == ROBOT:
            self.robot = message_class().deserialize(raw).data

    def _take_transforms(self, topic, message, publisher):
        is_static = topic.name.lstrip("/") == "tf_static"
        self.transforms.take(message, is_static, publisher)
        for each in [] if is_static else message.transforms:
            pair = (each.header.frame_id.lstrip("/"), each.child_frame_id.lstrip("/"))
            if pair not in self.odometry_of_edges and len(self.odometry_of_edges) >= 20:
                continue
            stamp = each.header.stamp.to_nsec()
            self.stamp_start = self.stamp_start or stamp
            record = self.odometry_of_edges.setdefault(pair, OdometryRecord(self.stamp_start))
            t, q = each.transform.translation, each.transform.rotation
            record.add(stamp, t.x, t.y, heading_of(q), 0.0, 0.0)

    def duration(self):
        """From the first arrival to the last [s]."""
        return (self.end - self.start) / 1e9 if self.start is not None else 0.0

    def of_kind(self, *kinds):
        """The topics of some types that are no truth."""
        return [topic for topic in self.topics.values() if topic.kind in kinds and
                not topic.name.lstrip("/").startswith("ground_truth")]

    def topic(self, name):
        """A topic by its name, with or without a slash before it, or None."""
        return next((topic for topic in self.topics.values()
                     if topic.name.lstrip("/") == name.lstrip("/")), None)
