# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The robot file that a bag names."""
import rosbag

from slam_eval.bench.harness.error import BenchError


def robot_of(path):
    """The name in the bag's topic robot, or None. Raises BenchError where it is no bag."""
    try:
        with rosbag.Bag(str(path)) as bag:
            for _, message, _ in bag.read_messages(topics=["robot", "/robot"]):
                return str(message.data)
    except (rosbag.ROSBagException, OSError) as error:
        raise BenchError(f"{path} cannot be read as a bag ({' '.join(str(error).split())}); "
                         "'rosbag reindex' mends one that was cut off") from None
    return None
