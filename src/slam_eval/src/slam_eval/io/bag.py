# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opens bags. The only module of io that needs ROS, which it imports when it is called."""
import contextlib
import math

from slam_eval.io.errors import InputError


@contextlib.contextmanager
def open_bag(path):
    """The bag, to be read in a `with`. Raises InputError where it is none, or ends too early."""
    import rosbag
    try:
        with rosbag.Bag(str(path)) as bag:
            yield bag
    except (rosbag.ROSBagException, OSError) as error:
        raise InputError(f"{path}: cannot be read as a bag ({' '.join(str(error).split())}); check "
                         "the path, or mend it with 'rosbag reindex'") from None


def yaw(q):
    """The heading [rad] of a geometry_msgs/Quaternion, whatever its length."""
    return math.atan2(2.0 * (q.w * q.z + q.x * q.y), q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z)
