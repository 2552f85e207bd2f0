# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which topic of a recording is which input of the products."""
import dataclasses
import posixpath
from typing import Optional

from slam_doctor.expectations import SECOND_SENSORS
from slam_doctor.record.recording import (CALIBRATION, COMMANDS, COMPRESSED, IMAGE, IMU, MOTION,
                                          OBSERVATIONS, ODOMETRY, SCAN, Topic)

# The messages that bring a kind of data (slam_ros, README: Bindings).
MESSAGES = {"slam::OdometrySample": (ODOMETRY,), "slam::LaserScan": (SCAN,),
            "slam::ImuSample": (IMU,), "slam::VelocityCommand": (COMMANDS,),
            "slam::CameraView": (IMAGE, COMPRESSED), "slam::Motion": (MOTION,),
            "slam::LandmarkObservationArray": (OBSERVATIONS,)}
# Topics that a product publishes.
OF_A_RUN = ("detections/", "visual_odometry/", "laser_odometry/", "command_odometry/")


@dataclasses.dataclass(frozen=True)
class Sensor:
    """An input with the topics that bring it."""

    name: str
    topic: Topic
    expected: str                       # the topic where it was looked for
    calibration: Optional[Topic] = None  # of a camera

    def is_elsewhere(self):
        """Whether its topic is another than the expected one."""
        return plain(self.topic.name).removesuffix("/compressed") != plain(self.expected)


def plain(topic):
    """A topic's name without the slash before it."""
    return topic.lstrip("/")


def kinds_of_inputs(expectations):
    """{name of an input: types of its messages}; those of other packages' kinds are empty."""
    return {**{name: MESSAGES[kind] for name, kind in SECOND_SENSORS.items()},
            **{need.input: MESSAGES.get(need.kind, ()) for product in expectations.products
               for need in product.needs}}


def find_sensors(recording, expectations):
    """{name of an input: Sensor} of what was recorded."""
    topics, kinds = expectations.inputs(), kinds_of_inputs(expectations)
    found = {}
    for name, expected in topics.items():
        taken = [sensor.topic for sensor in found.values()]
        topic = find_topic(recording, name, topics, kinds[name], taken)
        if topic is not None:
            found[name] = Sensor(name, topic, expected, calibration_of(recording, topic))
    if "odom" in topics and "odom" not in found:
        from_transforms = odometry_of_transforms(recording, expectations)
        if from_transforms is not None:
            found["odom"] = Sensor("odom", from_transforms, topics["odom"])
    return found


def find_topic(recording, name, topics, kinds, taken=()):
    """The topic of an input: that of its name, else the only one of its type that is not taken."""
    candidates = [topic for topic in recording.of_kind(*kinds)
                  if topic not in taken and not plain(topic.name).startswith(OF_A_RUN)]
    expected = plain(topics[name])
    for wanted in (expected, f"{expected}/compressed", plain(name)):
        for topic in candidates:
            if plain(topic.name) == wanted:
                return topic
    others = {plain(text) for other, topic in topics.items() if other != name
              for text in (other, topic, f"{topic}/compressed")}
    rest = [topic for topic in candidates if plain(topic.name) not in others]
    return rest[0] if len(rest) == 1 else None


def calibration_of(recording, topic):
    """The camera_info beside an image's topic, or None."""
    if topic.kind not in (IMAGE, COMPRESSED):
        return None
    name = topic.name.removesuffix("/compressed")
    beside = recording.topic(posixpath.join(posixpath.dirname(name), "camera_info"))
    return beside if beside is not None and beside.kind == CALIBRATION else None


def odometry_of_transforms(recording, expectations):
    """Odometry made of the transform odom -> base_link, where no message brings it."""
    edge = (expectations.odom(), expectations.base())
    record = recording.odometry_of_edges.get(edge)
    if record is None or not len(record.samples()):
        return None
    start = recording.stamp_start
    topic = Topic(f"/tf {edge[0]} -> {edge[1]}", ODOMETRY, start, start)
    topic.record = record
    for row in record.samples():
        stamp = start + round(row[0] * 1e9)
        topic.stream.add(stamp, stamp)
    return topic
