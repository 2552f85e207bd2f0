# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What rviz shows as the robot: its own robot_description where the master has one, else a simple
model of the folder models/, made of one link, the frame that odometry moves."""

import xml.etree.ElementTree as ElementTree

import rosgraph

from . import packages

PARAMETER = "robot_description"
OURS = "slam_launch/"  # before the name in a model of ours, which is not taken for the robot's own
UNKNOWN = "any_robot"  # the model of robots that have none


def path_of(robot):
    """Returns the path of the model of a robot, by the name in its robot file."""
    folder = packages.share() / "models"
    path = folder / f"{robot}.urdf"
    return path if path.parent == folder and path.is_file() else folder / f"{UNKNOWN}.urdf"


def model_of(robot, base):
    """Returns the URDF of a robot, whose only link is the frame `base`."""
    tree = ElementTree.parse(path_of(robot)).getroot()
    tree.set("name", OURS + tree.get("name"))
    tree.find("link").set("name", base)
    return ElementTree.tostring(tree, encoding="unicode")


def is_own(description):
    """Whether a description is the robot's, and not one that an earlier launch has set here."""
    try:
        return not ElementTree.fromstring(description).get("name", "").startswith(OURS)
    except (ElementTree.ParseError, TypeError):
        return True  # rviz says what is wrong with it


def own_description():
    """Returns the description that the robot's bringup has set, or None."""
    master = rosgraph.Master("slam_launch")
    try:
        found = master.getParam(master.searchParam(PARAMETER))
    except (OSError, rosgraph.MasterException):  # no master yet, or no such parameter
        return None
    return found if is_own(found) else None


def description_for(robot):
    """Returns the description to show, for the content of a robot file."""
    base = (robot.get("frames") or {}).get("base", "base_link")
    return own_description() or model_of(robot.get("robot"), base)
