# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""All that slam.launch asks before any node starts, in one answer: a program a question would take
half a second of a robot's computer each."""

import pathlib
import time

import yaml

from . import launch_checks, machines, overrides, robot_models
from .errors import ProductError
from .feature_model import FeatureModel

OLD = 60  # [s], after which nobody reads a launch's files any more
# Arguments that count instead of a value of the files, where they are given.
OVERRIDING = {"seed": "seed", "detector": "detector", "second_detector": "second_detector",
              "association": "association", "odom_topic": "topics.odom",
              "commands_topic": "topics.commands",
              "observations_topic": "topics.observations", "camera_topic": "topics.camera",
              "rear_camera_topic": "topics.rear_camera",
              "ceiling_camera_topic": "topics.ceiling_camera", "scan_topic": "topics.scan",
              "rear_scan_topic": "topics.rear_scan",
              "map_folder": "files.map_folder", "unsafe_paths": "files.unsafe_paths",
              "map_frame": "frames.map", "jump_limit": "frames.jump_limit"}


def prepare(arguments):
    """Checks a launch's arguments; returns the product's content, and writes the file that
    slam.launch includes next: it sets the other parameters and starts the product's parts."""
    launch_checks.check_values(arguments)
    model = FeatureModel()
    product = launch_checks.product_for(arguments, model)
    content = launch_checks.configured(product, arguments, model)
    robot = launch_checks.robot_for(arguments, product)
    parameters = {"checkpoints": launch_checks.checkpoints_for(arguments), "robot": robot,
                  "overrides": overriding(arguments)}
    if launch_checks.is_true(arguments["rviz"]):
        parameters["robot_description"] = robot_models.description_for(robot)
    groups = machines.groups(launch_checks.parts(product, arguments, model), arguments)
    common = {**launch_checks.common_arguments(product, arguments),
              "remaps": in_one_line(remaps(arguments["remap"]))}
    write(pathlib.Path(arguments["parts"]), parameters,
          machines.include_tags(groups, common, arguments["env_loader"]))
    return content


def overriding(arguments):
    """Returns the list of SECTION.KEY=VALUE; an empty argument means that the file's own counts."""
    words = [f"{key}={arguments[name]}" for name, key in OVERRIDING.items() if arguments[name]]
    words += arguments["set"].split()
    overrides.split(words)  # refuses what an argument sets as well
    return words


def remaps(text):
    """Returns the list of INPUT:=TOPIC, which roslaunch's command line would take for its own."""
    entries = [entry.strip() for entry in text.split(",") if entry.strip()]
    return [entry.replace("=", ":=", 1) for entry in entries]


def in_one_line(value):
    """Returns YAML for an attribute of XML."""
    return yaml.safe_dump(value, default_flow_style=True, width=float("inf")).strip()


def write(path, parameters, parts):
    """Writes the file that slam.launch includes, and the parameters beside it, which roslaunch takes
    from files as they are; removes what earlier launches left."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        for other in path.parent.iterdir():
            remove_if_old(other)
        tags = ""
        for name, value in parameters.items():
            file = path.with_name(f"{path.stem}_{name}.yaml")
            file.write_text(yaml.safe_dump(value), encoding="utf-8")
            tags += machines.param_tag(name, file)
        path.write_text(f"<launch>\n{tags}{parts}</launch>\n", encoding="utf-8")
    except OSError as error:
        raise ProductError(f"cannot write {path}, the list of the product's parts: "
                           f"{error.strerror}") from error


def remove_if_old(path):
    """Removes a file that nobody reads any more; another launch may do so at the same time."""
    try:
        if path.suffix in (".launch", ".yaml") and path.stat().st_mtime < time.time() - OLD:
            path.unlink()
    except FileNotFoundError:
        pass
