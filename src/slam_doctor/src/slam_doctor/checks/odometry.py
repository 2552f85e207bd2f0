# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Is odometry plausible by itself: numbers, covariances, speeds, jumps, resets, standstill?"""
import math

import numpy as np

from slam_doctor.finding import error, ok, unknown, warn

JUMP, JUMP_TURN = 0.3, 0.5  # beyond what the robot can do between two samples [m], [rad]
SPEED_OVER = 0.5            # [s]
AT_ZERO = 1e-9              # a pose this near to zero is zero [m, rad]
STUCK = 3.0                 # time in which scans move and odometry does not: ERROR [s]
APART = 2.0                 # of images that are compared [s]
CHANGED = 0.7               # images with a lower correlation have changed [1]


def check(case):
    """Findings about odometry."""
    sensor = case.sensors.get("odom")
    if sensor is None:
        return []
    record = sensor.topic.record
    found = [*numbers(record), *covariances(record, case)]
    if case.path is None:
        return [*found, unknown("odom.motion", "odometry has too few samples",
                                "Record for longer.")]
    return [*found, *motion(case), *stuck(case)]


def numbers(record):
    """Samples that are no numbers."""
    if not record.not_finite:
        return []
    total = record.not_finite + len(record.samples())
    return [error("odom.numbers", f"{record.not_finite} of {total} samples hold no numbers or no "
                  "rotation",
                  "Correct the driver: such samples are left out, and the motion in them is lost.",
                  record.not_finite, "samples")]


def covariances(record, case):
    """Covariances that are none, or that are not given."""
    found = []
    for kind, told in (("pose", record.pose_covariances), ("twist", record.twist_covariances)):
        if told.invalid:
            found.append(error("odom.covariance", f"{told.invalid} of {told.count} {kind} "
                               "covariances of x, y and heading are negative, not symmetric or no "
                               "numbers",
                               "Correct the driver, or fill them with zeros: then the robot file's "
                               "motion model counts.", told.invalid, "messages"))
        elif told.huge:
            found.append(warn("odom.covariance", f"{told.huge} of {told.count} {kind} covariances "
                              "are huge", "The driver does not know its errors; leave "
                              "wheel_odometry.covariance at model.", told.huge, "messages"))
    if found:
        return found
    is_used = case.robot.value("wheel_odometry", "covariance") == "twist"
    twist = record.twist_covariances
    if is_used and twist.zero:
        return [error("odom.covariance", f"{twist.zero} of {twist.count} twist covariances are "
                      "zero, and the robot file wants them", "Set wheel_odometry.covariance: "
                      "model, or have the driver fill them in.", twist.zero, "messages")]
    given = "given" if record.pose_covariances.zero < record.pose_covariances.count else \
        "not given, the robot file's motion model counts"
    return [ok("odom.covariance", f"covariances are {given}")] if record.count else []


def motion(case):
    """Speed, jumps, resets."""
    path = case.path
    most = float(case.robot.value("wheel_odometry", "max_speed") or 10.0)
    most_turn = float(case.robot.value("wheel_odometry", "max_turn_rate") or 10.0)
    steps = np.diff(path.stamps)
    ways = np.hypot(np.diff(path.x), np.diff(path.y))
    turns = np.abs(np.diff(path.heading))
    jumps = np.flatnonzero((ways > JUMP + most * steps) | (turns > JUMP_TURN + most_turn * steps))
    resets = [i for i in range(len(steps)) if is_reset(path, i, ways[i], steps[i])]
    if resets:
        return [error("odom.reset", f"odometry is reset to zero {len(resets)} times, first at "
                      f"{path.stamps[resets[0] + 1]:.1f} s", "The driver restarts (power, USB, "
                      "watchdog); SLAM bridges it, but the motion meanwhile is lost.", len(resets),
                      "times")]
    if len(jumps):
        i = int(jumps[0])
        return [error("odom.jump", f"odometry jumps {len(jumps)} times, first by {ways[i]:.3g} m "
                      f"and {turns[i]:.2g} rad at {path.stamps[i + 1]:.1f} s", "Look for lost "
                      "encoder counts, a driver that restarts, or one that publishes map poses as "
                      "odometry.",
                      len(jumps), "times")]
    return [speed(path, ways, turns, most)]


def is_reset(path, i, way, step):
    """Whether the sample behind i is zero after one that was not."""
    there = max(abs(path.x[i + 1]), abs(path.y[i + 1]), abs(math.remainder(path.heading[i + 1],
                                                                          2 * math.pi)))
    return there < AT_ZERO and way > 0.05 + 2.0 * step


def speeds(path):
    """Speeds over pieces of SPEED_OVER [s] or more, as stamps may be rounded [m/s]."""
    ends = np.searchsorted(path.stamps, path.stamps + SPEED_OVER)
    begins = np.flatnonzero(ends < len(path))
    ends = ends[begins]
    if not len(begins):
        return np.zeros(1)
    ways = np.hypot(path.x[ends] - path.x[begins], path.y[ends] - path.y[begins])
    return ways / (path.stamps[ends] - path.stamps[begins])


def speed(path, ways, turns, most):
    """How fast and how far the robot goes."""
    way = float(ways.sum())
    turn = float(turns.sum())
    usual = float(np.quantile(speeds(path), 0.99))
    text = f"{way:.1f} m driven and {turn:.1f} rad turned, speed up to {usual:.2f} m/s"
    if way < 0.1 and turn < 0.1:
        return unknown("odom.motion", f"odometry stands still ({text})",
                       "Drive a few metres and turn both ways while recording: most checks need "
                       "it.")
    if usual > most:
        return error("odom.motion", text, f"The robot file says at most {most:g} m/s "
                     "(wheel_odometry.max_speed): does odometry come in millimetres?", usual, "m/s")
    return ok("odom.motion", text, usual, "m/s")


def stuck(case):
    """Odometry that stands still while scans or images say that the robot moves."""
    moved = [stand for stand in case.stands if stand.motion is not None]
    time = sum(stand.end - stand.begin for stand in moved)
    if time > STUCK:
        return [error("odom.stuck", f"odometry stands still for {time:.1f} s while the scans move, "
                      f"first at {moved[0].begin:.1f} s", "Look at the wheel encoders' cable and "
                      "at the driver: it repeats its last pose.", time, "s")]
    if case.stands:
        return [ok("odom.stuck", "where odometry stands still, the scans do too")]
    return [] if "scan" in case.sensors else stuck_by_images(case)


def stuck_by_images(case):
    """The same by images; people who walk by may change them, hence WARN."""
    for camera in case.cameras():
        pairs = [(a, b) for a, b in apart(camera.topic.record.measures.items)
                 if is_still(case.path.motion(a.stamp, b.stamp))]
        changed = sum(correlation(a.thumbnail, b.thumbnail) < CHANGED for a, b in pairs)
        if len(pairs) >= 4 and changed > len(pairs) / 2:
            return [warn("odom.stuck", f"odometry stands still while {changed} of {len(pairs)} "
                         f"pairs of images of {camera.topic.name} change", "Look at the wheel "
                         "encoders' cable and at the driver.", changed, "pairs")]
    return []


def apart(measures):
    """(one, another) of the images' measures that are APART or more from one another."""
    stamps = np.array([each.stamp for each in measures])
    others = np.searchsorted(stamps, stamps + APART)
    return [(measures[i], measures[j]) for i, j in enumerate(others) if j < len(measures)]


def is_still(change):
    """Whether a motion is none; not where it is unknown."""
    return bool(np.isfinite(change).all() and np.abs(change).max() < 1e-3)


def correlation(a, b):
    """Of two thumbnails: 1 where they show the same, whatever the exposure."""
    a, b = a - a.mean(), b - b.mean()
    size = math.sqrt(float((a * a).sum() * (b * b).sum()))
    return float((a * b).sum()) / size if size > 1e-6 else 1.0
