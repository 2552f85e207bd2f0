# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cases of the benchmark calibration by name: what is wrong that the robot file does not know,
and what is estimated then."""
import dataclasses

from slam_eval.bench.harness import miscalibration
from slam_eval.bench.harness.products import GRAPH_WHEEL


@dataclasses.dataclass(frozen=True)
class Wrong:
    """What the messages of a drive have wrong; by default nothing."""

    wheels: float = 1.0          # measured over true motion, way and turn
    ranges: float = 1.0          # measured over true range
    bearings: float = 0.0        # too large by [rad]
    mount: tuple = (0.0, 0.0)    # the sensor is said to stand ahead, and to the left, by [m]
    late: float = 0.0            # stamps of observations after their time [s]

    def change(self):
        """The change of messages that makes a right drive wrong."""
        changes = []
        if self.wheels != 1.0:
            changes.append(miscalibration.ScaledOdometry(self.wheels))
        if self.ranges != 1.0:
            changes.append(miscalibration.ScaledRanges(self.ranges))
        if self.bearings:
            changes.append(miscalibration.TurnedBearings(self.bearings))
        if any(self.mount):
            changes.append(miscalibration.MovedMount(*self.mount))
        if self.late:
            changes.append(miscalibration.LateStamps(self.late))
        return miscalibration.Together(changes)

    def true_values(self, wheels):
        """{parameter: what a calibration should find}. wheels: TrueWheels of the drive."""
        return {"wheel_scale": wheels.scale / self.wheels, "wheel_base": wheels.base,
                "wheel_drift": wheels.drift, "sensor_yaw": 0.0 - self.bearings,
                "sensor_x": 0.0 - self.mount[0], "sensor_y": 0.0 - self.mount[1],
                "range_scale": 1.0 / self.ranges, "time_offset": 0.0 - self.late}


@dataclasses.dataclass(frozen=True)
class Case:
    """What is wrong, in words and as numbers; the names that calibration.estimate has."""

    title: str
    wrong: Wrong = Wrong()
    estimate: tuple = ()
    is_observable: bool = True  # else no drive tells all that is estimated

    def estimated_by(self, product):
        """What of it the product can estimate."""
        left_out = LEFT_OUT.get(product, ())
        return tuple(name for name in self.estimate if name not in left_out)

    def is_for(self, product):
        """Whether the product can estimate anything of it, or nothing is to be estimated."""
        return not self.estimate or bool(self.estimated_by(product))


LEFT_OUT = {GRAPH_WHEEL: ("time_offset",)}  # what a product cannot estimate
WHEELS = ("wheel_scale", "wheel_base", "wheel_drift")
# Wheels tell the scale of ranges; these two of them are seldom known to a twentieth of their priors.
RANGES = ("wheel_base", "wheel_drift", "range_scale")
MOUNT = ("sensor_yaw", "sensor_offset")
OFF = (0.2, -0.1)  # a mount [m]
RIGHT, BOTH_SCALES = "right", "both_scales"

CASES = {
    RIGHT: Case("nothing wrong, nothing estimated"),
    "clean": Case("nothing wrong, all but the ranges estimated", Wrong(),
                  (*WHEELS, *MOUNT, "time_offset")),
    "wheels_0.7": Case("wheels measure 0.7 times each motion", Wrong(wheels=0.7),
                       ("wheel_scale",)),
    "wheels_1.3": Case("wheels measure 1.3 times each motion", Wrong(wheels=1.3),
                       ("wheel_scale",)),
    "ranges_0.8": Case("ranges are 0.8 times the true ones", Wrong(ranges=0.8), RANGES),
    "ranges_1.2": Case("ranges are 1.2 times the true ones", Wrong(ranges=1.2), RANGES),
    "bearings_0.1": Case("bearings are 0.1 rad too large", Wrong(bearings=0.1), ("sensor_yaw",)),
    "bearings_-0.2": Case("bearings are 0.2 rad too small", Wrong(bearings=-0.2),
                          ("sensor_yaw",)),
    "mount_0.2": Case("the sensor is said to stand 0.2 m too far ahead and 0.1 m too far to the "
                      "right", Wrong(mount=OFF), MOUNT),
    "late": Case("observations are stamped 0.1 s late", Wrong(late=0.1), ("time_offset",)),
    "all": Case("wheels measure 1.2 times each motion, bearings are 0.1 rad too large, and the "
                "mount is off as with `mount_0.2`", Wrong(wheels=1.2, bearings=0.1, mount=OFF),
                (*WHEELS, *MOUNT)),
    BOTH_SCALES: Case("ranges are 1.2 times the true ones, and wheels are not trusted either",
                      Wrong(ranges=1.2), (*WHEELS, "sensor_offset", "range_scale"), False),
}
