# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where this package is, and what other packages add to the product line.

A package adds features or products by an export in its package.xml, beside an exec_depend on
slam_launch: <slam_launch features="${prefix}/features/Kconfig" products="${prefix}/products"/>.
"""

import os
import pathlib
import subprocess

from catkin.find_in_workspaces import find_in_workspaces
import rospkg

from .errors import ProductError


def share():
    """Returns the folder of slam_launch's features, products, robots and launch files."""
    try:
        return pathlib.Path(rospkg.RosPack().get_path("slam_launch"))
    except rospkg.ResourceNotFound as error:
        raise ProductError("the package slam_launch is not in ROS_PACKAGE_PATH; source the "
                           "workspace's setup.bash") from error


def lacking_for_rviz():
    """Returns the packages that rviz:=true needs and that are not installed."""
    there = rospkg.RosPack().list()
    return [name for name in ("rviz", "slam_rviz") if name not in there]


def program(package, name):
    """Returns the path of a package's program; rosrun would stumble over a space in it."""
    found = find_in_workspaces(["libexec"], package, name, first_match_only=True)
    if not found:
        raise ProductError(f"the program '{name}' of {package} is not built")
    return found[0]


def exported(attribute):
    """Returns the paths that packages export under an attribute, sorted by the package's name."""
    command = ["rospack", "plugins", f"--attrib={attribute}", "slam_launch"]
    try:
        # no cache: a package that has just been built counts
        lines = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True,
                               env={**os.environ, "ROS_CACHE_TIMEOUT": "0"}).stdout.splitlines()
    except (OSError, subprocess.CalledProcessError) as error:
        raise ProductError(f"'{' '.join(command)}' failed: {error}") from error
    return [pathlib.Path(line.split(" ", 1)[1]) for line in sorted(lines)]
