# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Does an IMU measure how the robot turns: numbers, rest, units, direction?"""
import math

import numpy as np

from slam_doctor.finding import error, judged, ok, unknown, warn

BIAS = (0.05, 0.3)  # at rest, above: WARN, ERROR [rad/s]
RESTS = 2           # pieces of a rest that say something
TURNED = 0.1        # of odometry in a piece that counts [rad]
TURNS = 5           # such pieces that say something
DEGREES = 10.0      # times the turns of odometry: no wheels are wrong by so much
SAME = 0.2          # times, below it the gyro does not measure these turns


def check(case):
    """Findings about the IMU."""
    sensor = case.sensors.get("imu")
    if sensor is None or not sensor.topic.record.count:
        return []
    record = sensor.topic.record
    return [*numbers(record), *against_odometry(record, case)]


def numbers(record):
    """Readings that are no numbers."""
    if record.not_finite:
        return [error("imu.numbers", f"{record.not_finite} of {record.count} readings hold no "
                      "numbers", "Correct the driver: such readings are left out.",
                      record.not_finite, "readings")]
    if record.says_none:
        return [warn("imu.numbers", f"{record.says_none} of {record.count} readings say that there "
                     "is no angular velocity (covariance -1)", "Of those, readings of zero about all "
                     "axes are left out; does this IMU have a gyro?", record.says_none, "readings")]
    return [ok("imu.numbers", "all readings hold numbers")]


def against_odometry(record, case):
    """Rest and turns, where odometry says when those are."""
    frame = sorted(record.frames)[0]
    mount = case.mount("imu", frame)
    if case.path is None or mount is None:
        return []
    scale = math.pi / 180.0 if case.robot.value("imu", "units") == "deg" else 1.0
    pieces = [(turn, scale * float(mount[2, :3] @ turn.rates()),
               case.path.motion(turn.begin, turn.end)) for turn in record.turns.items]
    pieces = [piece for piece in pieces if np.isfinite(piece[2]).all()]
    rests = [rate for _, rate, motion in pieces if np.abs(motion).max() < 1e-3]
    bias = float(np.median(rests)) if len(rests) >= RESTS else None
    return [at_rest(bias), turns(pieces, bias or 0.0)]


def at_rest(bias):
    """The gyro's bias."""
    if bias is None:
        return unknown("imu.rest", "the robot does not rest, so that the gyro's bias is not known",
                       "Let it stand for a second or more at the start of each drive.")
    return judged("imu.rest", f"at rest the gyro measures {bias:.4f} rad/s",
                  "Let the IMU's driver calibrate it at rest; does it count in degrees "
                  "(imu.units)?", abs(bias), BIAS, "rad/s")


def turns(pieces, bias):
    """Units and direction, against odometry's turns."""
    ratios = [(rate - bias) * (turn.end - turn.begin) / motion[2] for turn, rate, motion in pieces
              if abs(motion[2]) >= TURNED]
    if len(ratios) < TURNS:
        return unknown("imu.turns", "odometry turns too little to compare the gyro with",
                       "Turn both ways while recording.")
    ratio = float(np.median(ratios))
    text = f"the gyro measures {ratio:.2f} times the turns of odometry"
    if abs(ratio) > DEGREES:
        return error("imu.turns", text, "Does the driver count in degrees? Correct it, or set "
                     "imu.units: deg in the robot file.", ratio)
    if ratio < -SAME:
        return error("imu.turns", text, "Is the IMU upside down, or do the wheels turn the wrong "
                     "way? Correct the mount (imu.sensor_pose), or the wheel driver.", ratio)
    if ratio < SAME:
        return error("imu.turns", text, "Is it mounted as its transform says? Correct the "
                     "transform, or give imu.sensor_pose.", ratio)
    return ok("imu.turns", text, ratio)
