# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the parts of a product run: the front-end at the sensors, the back-end elsewhere."""

import dataclasses
import os
import re
from xml.sax.saxutils import quoteattr

from catkin.find_in_workspaces import find_in_workspaces

from .errors import ProductError

HALVES = ("frontend", "backend")
MANAGER = "slam_launch/launch/manager.launch"
HERE = "localhost"


@dataclasses.dataclass(frozen=True)
class Group:
    """Launch files that share a machine and a nodelet manager."""

    half: str       # "all" where the product is not divided
    machine: str    # [USER@]ADDRESS, or empty: where roslaunch is called
    files: list     # PACKAGE/FILE


def runs_here(half, arguments):
    """Whether a half, or all of it, is started by this launch and on this machine."""
    return arguments["only"] in ("", half) and not arguments[f"{half}_machine"]


def check_machines(arguments):
    """Refuses machines that no launch could reach, and a product that cannot be divided."""
    if arguments["only"] not in ("", *HALVES):
        raise ProductError(f"only:={arguments['only']} is not one of: {', '.join(HALVES)}")
    for half in HALVES:
        machine = arguments[f"{half}_machine"]
        if machine and not re.fullmatch(r"([\w.-]+@)?[\w.:-]+", machine, re.ASCII):
            raise ProductError(f"{half}_machine:={machine} is not of the form [USER@]ADDRESS")
    if arguments["composition"] == "inprocess" and is_divided(arguments):
        raise ProductError("composition:=inprocess is one nodelet, which cannot be divided: give "
                           "composition:=pubsub, or the same machine for both halves and no only:=")


def is_divided(arguments):
    return bool(arguments["only"]) or (arguments["frontend_machine"] !=
                                       arguments["backend_machine"])


def groups(files, arguments):
    """Returns the groups of a product's files, {half: [PACKAGE/FILE]}, that this launch starts."""
    if not is_divided(arguments):
        both = [file for half in HALVES for file in files[half]]
        return [Group("all", arguments["frontend_machine"], both)]
    return [Group(half, arguments[f"{half}_machine"], files[half]) for half in HALVES
            if arguments["only"] in ("", half)]


def include_tags(chosen, common, env_loader):
    """Returns the tags that start groups; `common` are the arguments of all their files."""
    remote = any(group.machine for group in chosen)
    content = ""
    for group in chosen:
        arguments = dict(common)
        if group.half == "backend":
            arguments["manager"] = "$(arg manager)_backend"
        if remote:
            content += machine_tag(f"slam_{group.half}", group.machine, env_loader)
        content += "".join(include_tag(name, arguments) for name in [MANAGER, *group.files])
    if remote:  # a default holds beyond its group and file
        content += machine_tag("slam_launching", "", env_loader)
    return content


def param_tag(name, file):
    """Returns the tag of a parameter that stands in a YAML file."""
    return f"  <param name={quoteattr(name)} type=\"yaml\" textfile={quoteattr(str(file))}/>\n"


def include_tag(name, arguments):
    package, _, file = name.partition("/")
    given = "".join(f"    <arg name={quoteattr(key)} value={quoteattr(value)}/>\n"
                    for key, value in arguments.items())
    return (f"  <include file={quoteattr(f'$(find {package})/{file}')} pass_all_args=\"true\">\n"
            f"{given}  </include>\n")


def machine_tag(name, machine, env_loader):
    """Returns the tag that makes a machine that of all nodes behind it."""
    user, _, address = machine.rpartition("@")
    attributes = {"name": name, "address": address or HERE, "default": "true"}
    if machine:
        attributes["env-loader"] = env_loader or own_env_loader()
    if user:
        attributes["user"] = user
    words = " ".join(f"{key}={quoteattr(value)}" for key, value in attributes.items())
    return f"  <machine {words}/>\n"


def own_env_loader():
    """Returns the env_loader of this workspace, which has the same path on the other machine."""
    found = find_in_workspaces(["libexec"], "slam_launch", "env_loader", first_match_only=True)
    if not found:
        raise ProductError("there is no env_loader of slam_launch in this workspace; source its "
                           "setup.bash, or give env_loader:=FILE")
    return os.path.realpath(found[0])
