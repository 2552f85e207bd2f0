# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Drives a differential robot along a way: a small stand-in for move_base's local planner."""

import math

from geometry_msgs.msg import PoseWithCovarianceStamped, Twist
from nav_msgs.msg import Path
import rospy

AHEAD = 0.3                # of the robot on the way, where it steers to [m]
TURN = 0.8                 # at most [rad/s]
STRAIGHT = 0.4             # it turns on the spot when the way is farther off its heading [rad]


def heading_of(orientation):
    return 2.0 * math.atan2(orientation.z, orientation.w)


def wrapped(angle):
    return math.remainder(angle, 2.0 * math.pi)


def steering(pose, way, speed):
    """Returns the (speed [m/s], turn [rad/s]) for a pose (x, y, heading) and the points of a way.
    speed: at most [m/s]."""
    if not way:
        return 0.0, 0.0
    distances = [math.hypot(x - pose[0], y - pose[1]) for x, y in way]
    nearest = distances.index(min(distances))
    ahead = next((i for i in range(nearest, len(way)) if distances[i] >= AHEAD), len(way) - 1)
    if distances[ahead] < 0.05:
        return 0.0, 0.0
    off = wrapped(math.atan2(way[ahead][1] - pose[1], way[ahead][0] - pose[0]) - pose[2])
    turn = max(-TURN, min(TURN, 2.0 * off))
    return (0.0 if abs(off) > STRAIGHT else min(speed, distances[-1])), turn


class Follower:
    """Follows `active_path/way` by `pose`, and remembers where it has been."""

    def __init__(self, speed):
        self.speed = speed
        self.way, self.driven = [], []
        self.command = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        self.subscribers = [
            rospy.Subscriber("active_path/way", Path, self.on_way, queue_size=1),
            rospy.Subscriber("pose", PoseWithCovarianceStamped, self.on_pose, queue_size=1)]

    def on_way(self, message):
        self.way = [(stamped.pose.position.x, stamped.pose.position.y) for stamped in message.poses]

    def on_pose(self, message):
        pose = message.pose.pose
        here = pose.position.x, pose.position.y, heading_of(pose.orientation)
        self.driven.append(here)
        command = Twist()
        command.linear.x, command.angular.z = steering(here, self.way, self.speed)
        self.command.publish(command)
