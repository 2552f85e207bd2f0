# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames, mounts, and who publishes what on /tf."""
import math

import numpy as np

from slam_doctor.finding import error, ok, unknown, warn
from slam_doctor.record.recording import SCAN

TILT = 0.1  # of a laser's plane, above which scans are refused (slam_ros, README: Lasers) [rad]
FAR = 3.0   # a mount farther from the base than this is asked about [m]


def check(case):
    """Findings about frames."""
    return [*odometry_frames(case), *parents(case), *quaternions(case), *mounts(case), *edge(case)]


def odometry_frames(case):
    """Whether odometry moves the base frame."""
    record, base = case.record("odom"), case.expectations.base()
    edges = sorted(getattr(record, "edges", ()))
    if not edges:
        return []
    if len(edges) > 1:
        return [error("odom.frames", "odometry names several frames: "
                      + ", ".join(f"{parent} -> {child}" for parent, child in edges),
                      "Look for two publishers of odometry.")]
    (parent, child), = edges
    if child and child != base:
        return [warn("odom.frames", f"odometry moves {child}, the robot's frame is {base}",
                     f"Set frames.base: {child} in the robot file, or child_frame_id in the "
                     "driver.")]
    return [ok("odom.frames", f"odometry moves {child or base} in {parent or '(no name)'}")]


def parents(case):
    """Frames with two parents."""
    transforms = case.recording.transforms
    found = []
    for frame in sorted(transforms.frames()):
        above = sorted(transforms.parents(frame))
        if len(above) > 1:
            found.append(error("frames.parents", f"the frame {frame} has {len(above)} parents: "
                               f"{', '.join(above)}", "Let only one node publish this frame; a "
                               "frame has one parent in tf.", len(above), "parents"))
    return found


def quaternions(case):
    """Transforms that are no poses."""
    transforms, found = case.recording.transforms, []
    if transforms.not_finite:
        found.append(error("frames.numbers", f"{transforms.not_finite} transforms hold NaN or "
                           "infinity", "Find their publisher with rosrun tf tf_monitor.",
                           transforms.not_finite, "transforms"))
    if transforms.not_normal:
        found.append(warn("frames.numbers", f"{transforms.not_normal} transforms have a quaternion "
                          "whose length is not 1", "Give the rotation as a unit quaternion, or as "
                          "yaw, pitch, roll.", transforms.not_normal, "transforms"))
    return found


def mounts(case):
    """The mounts of lasers and cameras."""
    found = []
    for sensor in case.sensors.values():
        for frame in sorted(getattr(sensor.topic.record, "frames", ())):
            found.append(mount(case, sensor, frame))
    return found


def mount(case, sensor, frame):
    """The mount of a sensor's frame."""
    name, base = f"{sensor.name}.mount", case.expectations.base()
    pose = case.mount(sensor.name, frame)
    section = "laser" if sensor.name == "scan" else sensor.name
    if pose is None:
        return error(name, f"no transform leads from {base} to {frame or '(no frame)'}, the frame "
                     f"of {sensor.topic.name}", "Publish it with static_transform_publisher, or "
                     f"give {section}.sensor_pose in the robot file.")
    edges = case.recording.transforms.chain(frame, base) or []
    moving = [edge for edge in edges if edge.moved]
    if moving:
        return error(name, f"the mount of {frame} moves ({moving[0].parent} -> {moving[0].child})",
                     "A sensor's mount must stand still; fix the sensor, or its transform.")
    return placed(name, sensor, frame, pose, all(edge.is_static for edge in edges))


def placed(name, sensor, frame, pose, is_static):
    """Whether a mount is one that can be."""
    x, y, z = pose[:3, 3]
    yaw = math.atan2(pose[1, 0], pose[0, 0])
    text = f"{frame} at ({x:.2f}, {y:.2f}, {z:.2f}) m, yaw {yaw:.2f} rad"
    text += "" if is_static else ", from /tf, where it stands still"
    if np.linalg.norm(pose[:3, 3]) > FAR:
        return warn(name, f"{text}: far from the robot's base", "Translations are in metres; are "
                    "these millimetres, or is it another "
                    "frame?", float(np.linalg.norm(pose[:3, 3])),
                    "m")
    if sensor.topic.kind == SCAN:
        tilt = math.acos(min(1.0, abs(pose[2, 2])))
        text += ", upside down" if pose[2, 2] < 0 else ""
        if tilt > TILT:
            return error(name, f"{text}: its plane is tilted by {tilt:.2f} rad",
                         f"The scan plane must be horizontal within {TILT:g} rad; correct the "
                         "mount.",
                         tilt, "rad")
    return ok(name, text)


def edge(case):
    """Who publishes odom -> base_link."""
    transforms, base = case.recording.transforms, case.expectations.base()
    above = [e for e in transforms.edges.values() if e.child == base]
    if not above:
        if case.recording.is_live and case.record("odom"):
            return [unknown("frames.odom", f"nobody publishes the transform to {base}",
                            "The wheel driver should; else give publish_tf:=true to slam.launch.")]
        return []
    publishers = sorted({name for e in above for name in e.publishers if name})
    if len(publishers) > 1:
        return [error("frames.odom", f"{' and '.join(publishers)} publish the transform to {base}",
                      "Let only one of them do it: give publish_tf:=false to the other.",
                      len(publishers), "publishers")]
    return [ok("frames.odom", f"{above[0].parent} -> {base} is published"
               + (f" by {publishers[0]}" if publishers else ""))]
