# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a wheel driver, or another source of nav_msgs/Odometry, says."""
import math

import numpy as np

from slam_doctor.record.thinned import ThinnedRows

HUGE = 1e6  # variance of x, y or the heading above which it means "not known" [m^2, rad^2]
PLANE = [0, 1, 5]  # x, y and the heading among the six of a covariance


class Covariances:
    """How many covariances are which way."""

    def __init__(self):
        self.count = self.zero = self.invalid = self.huge = 0

    def add(self, values):
        """Looks at the 36 values of a covariance: those of x, y and the heading count."""
        self.count += 1
        if not any(values) or values[0] == -1:  # ROS's ways to say that none is given
            self.zero += 1
            return
        matrix = np.array(values).reshape(6, 6)[np.ix_(PLANE, PLANE)]
        if not np.isfinite(matrix).all() or is_negative(matrix):
            self.invalid += 1
        elif (np.diag(matrix) > HUGE).any():
            self.huge += 1


def is_negative(matrix):
    """Whether a matrix is no covariance: not symmetric, or some variance is negative."""
    scale = np.abs(matrix).max()
    if np.abs(matrix - matrix.T).max() > 1e-6 * scale:
        return True
    return np.linalg.eigvalsh((matrix + matrix.T) / 2)[0] < -1e-9 * scale


def heading_of(q):
    """The angle about the vertical axis of a quaternion [rad]; NaN where it is no rotation."""
    if not 0.5 < q.x ** 2 + q.y ** 2 + q.z ** 2 + q.w ** 2 < 2.0:
        return math.nan
    return math.atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y ** 2 + q.z ** 2))


class OdometryRecord:
    """The odometry of one topic."""

    def __init__(self, start):
        self._start = start
        self._rows = ThinnedRows(6)
        self.not_finite = self.count = 0
        self.pose_covariances, self.twist_covariances = Covariances(), Covariances()
        self.edges = set()  # (frame_id, child_frame_id)

    def take(self, message):
        """Takes a message."""
        self.count += 1
        self.edges.add((message.header.frame_id.lstrip("/"), message.child_frame_id.lstrip("/")))
        pose, twist = message.pose.pose, message.twist.twist
        self.add(message.header.stamp.to_nsec(), pose.position.x, pose.position.y,
                 heading_of(pose.orientation), twist.linear.x, twist.angular.z)
        self.pose_covariances.add(message.pose.covariance)
        self.twist_covariances.add(message.twist.covariance)

    def add(self, stamp, *values):
        """Takes a sample: stamp [ns], x, y [m], heading [rad], speed [m/s], turn rate [rad/s]."""
        if all(map(math.isfinite, values)):
            self._rows.append(((stamp - self._start) / 1e9, *values))
        else:
            self.not_finite += 1

    def samples(self):
        """Rows of stamp [s], x, y, heading, speed, turn rate, as they came."""
        return self._rows.array()


def pose_is_constant(rows):
    """Whether the pose of all samples is one, although the twist says that the robot moves."""
    return len(rows) > 1 and not np.ptp(rows[:, 1:4], axis=0).any() and \
        np.abs(rows[:, 4:]).max() > 1e-3


def integrated(rows):
    """The samples with the pose that their twist leads to."""
    steps = np.clip(np.diff(rows[:, 0], prepend=rows[0, 0]), 0.0, 1.0)
    heading = np.cumsum(rows[:, 5] * steps)
    way = rows[:, 4] * steps
    out = rows.copy()
    out[:, 1], out[:, 2] = np.cumsum(way * np.cos(heading)), np.cumsum(way * np.sin(heading))
    out[:, 3] = heading
    return out


class Path:
    """Where odometry says that the robot was, by stamp."""

    def __init__(self, rows):
        rows = integrated(rows) if pose_is_constant(rows) else rows
        _, first = np.unique(rows[:, 0], return_index=True)
        rows = rows[first]
        self.stamps, self.x, self.y = rows[:, 0], rows[:, 1], rows[:, 2]
        self.heading = np.unwrap(rows[:, 3])

    def __len__(self):
        return len(self.stamps)

    def poses(self, stamps):
        """Rows x, y, heading at stamps [s]; NaN before the first sample and behind the last."""
        columns = (np.interp(stamps, self.stamps, values, left=np.nan, right=np.nan)
                   for values in (self.x, self.y, self.heading))
        return np.stack(list(columns), axis=-1)

    def motion(self, begin, end):
        """The motion (x, y, turn) from one stamp to another, seen from the first pose."""
        (x0, y0, a0), (x1, y1, a1) = self.poses(np.array([begin, end]))
        cosine, sine = math.cos(a0), math.sin(a0)
        dx, dy = x1 - x0, y1 - y0
        return np.array([cosine * dx + sine * dy, cosine * dy - sine * dx, a1 - a0])
