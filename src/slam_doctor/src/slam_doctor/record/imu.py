# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What an IMU says of the robot's rotation."""
import dataclasses

import numpy as np

from slam_doctor.record.thinned import Thinned

PIECE = 0.5  # in which readings are added up [s]
HOLE = 0.15  # over which nothing is added up [s]


@dataclasses.dataclass(frozen=True)
class Turn:
    """What the gyro measured from one stamp to another [s], about its own axes [rad]."""

    begin: float
    end: float
    angles: np.ndarray

    def rates(self):
        """The mean angular velocity [rad/s]."""
        return self.angles / (self.end - self.begin)


class ImuRecord:
    """The angular velocities of one topic."""

    def __init__(self, start):
        self._start = start
        self._last = None   # (stamp, angular velocity)
        self._open = None   # (begin, angles so far)
        self.count = self.not_finite = self.says_none = 0
        self.frames = set()
        self.turns = Thinned(20_000)

    def take(self, message):
        """Takes a message."""
        self.count += 1
        self.frames.add(message.header.frame_id.lstrip("/"))
        # Drivers mark so that they give no covariance; by the message's definition there is no gyro.
        self.says_none += message.angular_velocity_covariance[0] == -1
        velocity = message.angular_velocity
        rate = np.array([velocity.x, velocity.y, velocity.z])
        if np.isfinite(rate).all():
            self._add((message.header.stamp.to_nsec() - self._start) / 1e9, rate)
        else:
            self.not_finite += 1

    def _add(self, stamp, rate):
        last, self._last = self._last, (stamp, rate)
        if last is None or not 0.0 < stamp - last[0] <= HOLE:
            self._open = None
            return
        begin, angles = self._open or (last[0], np.zeros(3))
        angles = angles + 0.5 * (stamp - last[0]) * (rate + last[1])
        self._open = (begin, angles)
        if stamp - begin >= PIECE:
            self.turns.append(Turn(begin, stamp, angles))
            self._open = None
