# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A package for a component of one's own: it builds, passes the contract of its role, and is a
product already.

Its files are those of the example of its role (`test/toys` of the repository), where the name of the
example is replaced. So what is written here is what the tests build and run.
"""

import pathlib
import re
import shutil

import rospkg

from . import packages, parameters, ports
from .errors import did_you_mean, ProductError

EXAMPLE = "toy"  # the name of each example's component
ROLES = {"backend": "estimates pose and map: the textbook's EKF-SLAM to begin with",
         "odometry": "makes motion of what sensors give: the wheels' increments to begin with",
         "detector": "finds landmarks: edges in a laser's scans to begin with",
         "map": "an additional module, which draws something of what the back-end says: the cells "
                "where the robot was to begin with"}
LONGEST_NAME = 50  # characters; paths in a build are a few times as long
TOP_LEVEL = ("version", "product", "sentence", "libraries", "seed")  # keys of product files


def write(name, role, into, model):
    """Writes the package of a component and returns its folder."""
    require_role(role)
    require_name(name, role, model)
    example = example_of(role)
    target = pathlib.Path(into) / example.name.replace(EXAMPLE, name)
    if not target.parent.is_dir():
        raise ProductError(f"there is no folder {target.parent} to write the package into; make it, "
                           "or name another one with --into")
    if target.exists():
        raise ProductError(f"{target} is there already; remove it, or give the component another "
                           "name")
    try:
        copy(example, target, name)
    except OSError as error:
        shutil.rmtree(target, ignore_errors=True)
        raise ProductError(f"cannot write {error.filename or target}: {error.strerror}") from error
    return target


def require_role(role):
    if role not in ROLES:
        raise ProductError(f"there is no role '{role}'{did_you_mean(role, ROLES)}; the roles are: "
                           f"{', '.join(ROLES)}")


def require_name(name, role, model):
    """Refuses what cannot be the name of a package, and what has that name already."""
    is_short = len(name) <= LONGEST_NAME
    if not is_short or not re.fullmatch(r"[a-z](_?[a-z0-9])*", name):
        shown = name if is_short else f"{name[:LONGEST_NAME]}..."
        raise ProductError(f"'{shown}' is no name of a ROS package: small letters, "
                           f"digits and single _ between them, a letter first, {LONGEST_NAME} "
                           "characters at most")
    package = f"slam_{role}_{name}"
    if package in rospkg.RosPack().list():
        raise ProductError(f"there is a package {package} already; give another name")
    registered = ports.components()["modules" if role == "map" else role]
    if f"{role}_{name}".upper() in model.kconfig.syms or name in registered:
        raise ProductError(f"there is a component '{name}' of the role {role} already; give another "
                           "name")
    section = name if role == "backend" else f"{name}_{role}"
    if section in (*parameters.tables(), *model.groups, *TOP_LEVEL):
        raise ProductError(f"'{section}', its section of parameters, stands for something else in "
                           "product files; give another name")


def example_of(role):
    """Returns the folder of a role's example: installed, or in the repository."""
    for folder in (packages.share() / "components", packages.share().parent / "test" / "toys"):
        example = folder / f"slam_{role}_{EXAMPLE}"
        if example.is_dir():
            return example
    raise ProductError(f"the example of the role {role} is not installed with slam_launch")


def copy(example, target, name):
    """Copies an example under another name, in its files' names and in what they say."""
    for path in sorted(example.rglob("*")):
        if path.is_dir() or "__pycache__" in path.parts:
            continue
        copied = target / renamed(str(path.relative_to(example)), name)
        copied.parent.mkdir(parents=True, exist_ok=True)
        copied.write_text(renamed(path.read_text(encoding="utf-8"), name), encoding="utf-8")


def renamed(text, name):
    """Puts a name in the example's place: as it is, in capitals, or as that of a class."""
    camel = "".join(part.capitalize() for part in name.split("_"))
    for old, new in ((EXAMPLE, name), (EXAMPLE.upper(), name.upper()),
                     (EXAMPLE.capitalize(), camel)):
        text = text.replace(old, new)
    return text
