# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a robot file says of the base frame and of the camera's mount."""
import math

from slam_launch import config_files
from slam_launch.errors import ProductError

from slam_bridges.mounts import Mounts, pose_of_angles


def mounts_of(name, account):
    """The Mounts of a robot NAME or FILE, or those of the defaults where it is empty.

    Raises ProductError where the file cannot be used.
    """
    content = config_files.load(config_files.find("robots", name)) if name else {}
    base = value(content, "frames", "base") or "base_link"
    return Mounts(str(base), account, fixed_pose(value(content, "camera", "sensor_pose")))


def value(content, section, key):
    """A value of a robot file; None where it is not there."""
    values = content.get(section)
    return values.get(key) if isinstance(values, dict) else None


def fixed_pose(numbers):
    """The Pose that camera.sensor_pose gives; None where it is not set."""
    if not numbers:
        return None
    try:
        pose = [float(number) for number in numbers]
    except (TypeError, ValueError):
        pose = []
    if len(pose) != 6 or not all(map(math.isfinite, pose)):
        raise ProductError("camera.sensor_pose of the robot file needs 6 numbers, "
                           "[x, y, z, roll, pitch, yaw]")
    return pose_of_angles(pose)
