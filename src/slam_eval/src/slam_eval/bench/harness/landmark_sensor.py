# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a sensor of landmarks with ids sees on a simulated drive, made from the truth in its bag: no
image is rendered, so that a drive takes a second."""
import numpy as np
import rosbag
from slam_msgs.msg import LandmarkObservation, LandmarkObservationArray

from slam_eval.bench.harness.bag_edit import POSE, read_place
from slam_eval.bench.harness.error import BenchError
from slam_eval.geometry import se2

TOPIC, FRAME = "/observations", "landmark_sensor"
MOUNT = (0.12, 0.0, 0.0)                   # in the robot's base frame [m, m, rad]
EVERY = 5                                  # poses of the truth, which has 50 a second
RANGE, VIEW = 6.0, np.radians(240.0)       # up to which, and the field of view [m], [rad]
SIGMA_RANGE, SIGMA_BEARING = 0.03, 0.01    # [m], [rad]


def seen_from(pose, points):
    """(ranges [m], bearings [rad]) of points (N x 2) for the sensor of a robot at a pose."""
    sensor = se2.compose(np.asarray(pose), np.array(MOUNT))
    local = se2.transform_points(se2.inverse(sensor), points)
    return np.hypot(*local.T), np.arctan2(local[:, 1], local[:, 0])


def place_of(pose, distance, bearing):
    """The point (x, y) that the sensor of a robot at a pose sees at a range and bearing."""
    sensor = se2.compose(np.asarray(pose), np.array(MOUNT))
    angle = sensor[2] + bearing
    return sensor[:2] + distance * np.array([np.cos(angle), np.sin(angle)])


def _observation(identity, distance, bearing):
    return LandmarkObservation(
        id=identity, range=distance, bearing=bearing,
        covariance=[SIGMA_RANGE ** 2, 0.0, 0.0, SIGMA_BEARING ** 2])


class Sensor:
    """Looks at the landmarks of a world from true poses."""

    def __init__(self, ids, points, seed):
        self._ids, self._points = ids, np.array(points)
        self._random, self._sequence = np.random.default_rng(seed), 0

    def look(self, stamp, pose):
        """The message of what is seen from a pose (x, y, theta)."""
        ranges, bearings = seen_from(pose, self._points)
        noise = self._random.normal(size=(2, len(ranges)))
        in_view = (ranges < RANGE) & (np.abs(bearings) < VIEW / 2)
        ranges, bearings = ranges + SIGMA_RANGE * noise[0], bearings + SIGMA_BEARING * noise[1]
        message = LandmarkObservationArray(sequence=self._sequence)
        message.header.stamp, message.header.frame_id = stamp, FRAME
        message.sensor_pose.x, message.sensor_pose.y, message.sensor_pose.theta = MOUNT
        message.observations = [_observation(self._ids[i], float(ranges[i]), float(bearings[i]))
                                for i in np.flatnonzero(in_view)]
        self._sequence += 1
        return message


def _landmarks(bag):
    for _, message, _ in bag.read_messages(topics=["/ground_truth/landmarks"]):
        return ([landmark.id for landmark in message.landmarks],
                [(landmark.x, landmark.y) for landmark in message.landmarks])
    raise BenchError("the simulated drive has no ground_truth/landmarks; build slam_sim again")


def observe(source, target, seed):
    """A bag like that of a simulated drive with observations of its landmarks in the place of the
    laser's scans; transforms of motion are left out."""
    with rosbag.Bag(str(source)) as bag, rosbag.Bag(str(target), "w") as out:
        sensor, count = Sensor(*_landmarks(bag), seed), 0
        for topic, raw, time in bag.read_messages(raw=True):
            if topic in ("/tf", "/scan"):
                continue
            out.write(topic, raw, time, raw=True)
            if raw[0] == POSE:
                if count % EVERY == 0:
                    stamp = raw[-1]().deserialize(raw[1]).header.stamp
                    out.write(TOPIC, sensor.look(stamp, read_place(POSE, raw[1])), time)
                count += 1
    return target
