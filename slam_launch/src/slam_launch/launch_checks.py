# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What must hold of slam.launch's arguments: is it a product, which robot, which parts."""

import os
import pathlib
import urllib.parse

from catkin.find_in_workspaces import find_in_workspaces

from . import config_files, machines, overrides, packages, parameters, ports, products
from .errors import did_you_mean, ProductError
from .feature_model import text

CHOICES = {"composition": ("pubsub", "inprocess"), "mode": ("slam", "localization"),
           "camera_transport": ("auto", "raw", "compressed"), "publish_tf": ("", "true", "false")}
DEFAULTS = {"backend": "ekf", "odometry": "wheel"}  # of a launch without a product
PATHS = {"bag": "frontend", "load_map": "backend", "load_session": "backend",
         "output_dir": "backend", "save_on_exit": "backend"}  # and the half that reads or writes there
URI = "file://"  # and an absolute path, percent-encoded


def check_values(arguments):
    """Refuses values that no product could make good."""
    for key, choices in CHOICES.items():
        if arguments[key] not in choices:
            known = list(filter(None, choices))
            raise ProductError(f"{key}:={arguments[key]} is not one of: {', '.join(known)}"
                               f"{did_you_mean(arguments[key], known)}")
    if is_true(arguments["rviz"]):
        require_rviz()
    require_map("mode:=", arguments["mode"], arguments)
    machines.check_machines(arguments)
    if arguments["load_map"] and arguments["load_session"]:
        raise ProductError("a session holds its map: give load_map:= or load_session:=, not both")
    for key, half in (("load_map", "backend"), ("load_session", "backend"), ("bag", "frontend")):
        if arguments[key] and machines.runs_here(half, arguments):
            config_files.require_regular(f"{key}:={arguments[key]}", arguments[key],
                                         folder=key == "load_map")
    for key, number in (("rate", float), ("seed", int), ("jump_limit", float)):
        try:
            if arguments[key] and not 0 <= number(arguments[key]) < float("inf"):
                raise ValueError
        except ValueError:
            raise ProductError(f"{key}:={arguments[key]} is not a number >= 0") from None


def is_true(value):
    """Whether roslaunch takes an argument for true."""
    return value.lower() in ("true", "1")


def require_rviz():
    """Refuses rviz:=true where it is not installed: a robot without a screen does without."""
    lacking = packages.lacking_for_rviz()
    if lacking:
        raise ProductError(f"rviz:=true needs the package {lacking[0]}, which is not installed: "
                           "install it (beside the command slam: 'sudo apt install "
                           "ros-slam-rviz'), or leave out rviz:=true")


def require_map(key, mode, arguments):
    if mode == "localization" and not (arguments["load_map"] or arguments["load_session"]):
        raise ProductError(f"{key}{mode} keeps a map fixed and needs one: load_map:=FILE")


def choose_product(arguments, model):
    """Returns the product that the arguments name, by its name or by its features."""
    given = {key: arguments[key].lower() for key in model.groups if arguments.get(key)}
    if not arguments["product"]:
        return products.with_features(model.require_valid({**DEFAULTS, **given}), model)
    product = products.find(arguments["product"], model)
    model.require_known(given)
    product = products.swapped(product, {**product.features, **given})
    if {**product.features, **given} != product.features:
        raise ProductError(f"the product {arguments['product']} is {text(product.features)}, the "
                           f"launch says {text(given)}; leave out the one or the other")
    model.require_valid(product.features)
    return product


def configured(product, arguments, model):
    """Returns the content for the parameter server; the mode is the launch's."""
    words = arguments["set"].split()
    given = overrides.split(words)
    overrides.require_no_feature(given, model)
    products.require_sections(overrides.sections(given), product.features, model)
    products.require_parameters(product, words)
    ports.require_joined(product)
    backend = product.features["backend"]
    require_map(f"set:={backend}.mode=", given.get(f"{backend}.mode"), arguments)
    section = {**(product.content.get(backend) or {}), "mode": arguments["mode"]}
    return {**product.content, backend: section}


def require_session_keeper(product, model):
    """Refuses a session for a back-end whose launch file takes none."""
    for name in model.launch_files(product.features)["backend"]:
        for path in find_in_workspaces(["share"], *name.split("/", 1), first_match_only=True):
            if 'name="load_session"' in pathlib.Path(path).read_text(encoding="utf-8"):
                return
    raise ProductError(f"the back-end {product.features['backend']} keeps no session: leave out "
                       "load_session:= or take backend:=graph")


def parts(product, arguments, model):
    """Returns PACKAGE/FILE of the launch files that make up the halves of the product."""
    if arguments["composition"] == "pubsub":
        files = model.launch_files(product.features)
    else:
        files = {"frontend": [], "backend": ["slam_launch/launch/inprocess.launch"]}
    if arguments["bag"]:
        files["frontend"].append("slam_launch/launch/bag_source.launch")
    return files


def with_plain_paths(arguments):
    """Returns the arguments with each file: URI as the path that it stands for. roslaunch cannot
    pass on a path with a ':=' in it, nor one with a quote to this program."""
    plain = dict(arguments)
    for key in {*PATHS, "checkpoints", "product", "robot"} & arguments.keys():
        if arguments[key].startswith(URI):
            plain[key] = urllib.parse.unquote(arguments[key][len(URI):])
            if "$(" in plain[key]:
                raise ProductError(f"{key}:={plain[key]}: roslaunch takes a '$(' in a path for its "
                                   "own; give the file or folder another name")
    return plain


def absolute_paths(arguments):
    """Returns the paths for this machine, where nodes start in another folder than roslaunch, and
    those that are absolute anyway."""
    return {key: os.path.abspath(arguments[key]) for key, half in PATHS.items()
            if arguments[key] and (machines.runs_here(half, arguments) or
                                   os.path.isabs(arguments[key]))}


def common_arguments(product, arguments):
    """Returns the arguments of the parts beyond those of slam.launch itself."""
    keep_alive = "rosrun slam_launch keep_alive" if is_kept_alive(arguments) else ""
    with_pointmap = product.features.get("pointmap") == "true"
    is_pubsub = arguments["composition"] == "pubsub"
    return {**absolute_paths(arguments), "keep_alive": keep_alive,
            "transport": arguments["camera_transport"],
            "waits_for_pointmap": "true" if with_pointmap and is_pubsub else "false",
            "waits_for_components": "true" if is_pubsub else "false",
            "publish_tf": arguments["publish_tf"] or publishes_edge(product, arguments)}


def is_kept_alive(arguments):
    """Whether nodes that die are started again: they go on from their checkpoint. Of a replay
    nothing would be left to go on with."""
    return bool(arguments.get("checkpoints")) and not arguments["bag"]


def publishes_edge(product, arguments):
    """Whether the odometry publishes odom -> base_link where nobody says: for a bag, whose own is
    left out, and where no driver does."""
    owns = arguments["bag"] or ports.of_product(product).owns_odometry_edge
    return "true" if owns else "false"


def product_for(arguments, model):
    """Returns the product that a launch's arguments choose."""
    product = choose_product(arguments, model)
    if arguments["load_session"]:
        require_session_keeper(product, model)
    return product


def checkpoints_for(arguments):
    """Returns the parameters of the checkpoints; the folder is seen from where roslaunch is called,
    nodes start in another one."""
    folder, resume = arguments["checkpoints"], arguments["resume"].lower()
    if resume not in ("true", "false"):
        raise ProductError(f"resume:={arguments['resume']} is not one of: true, false")
    if resume == "true" and not folder:
        raise ProductError("resume:=true needs the folder of a checkpoint: checkpoints:=DIR")
    try:
        autosave = float(arguments["autosave"])
        if not 0 < autosave < float("inf"):
            raise ValueError
    except ValueError:
        raise ProductError(f"autosave:={arguments['autosave']} is not a number > 0") from None
    return {"folder": folder and os.path.abspath(folder), "autosave": autosave,
            "resume": resume == "true"}


def robot_of_bag(path):
    """Returns the robot that a bag names, or None."""
    import rosbag  # takes a while, and is seldom needed
    try:
        with rosbag.Bag(path) as bag:
            return next((m.data for _, m, _ in bag.read_messages(topics=["/robot", "robot"])), None)
    except Exception as error:  # of a damaged bag the library throws whatever it stumbles over
        cause = " ".join(str(error).split()) or type(error).__name__
        raise ProductError(f"cannot read the bag {path}, is it damaged? ({cause})") from error


def robot_for(arguments, product):
    """Returns the content of the robot file that is given, or that the bag names. It may hold
    parameters of all components that the product brings."""
    name = arguments["robot"]
    if not name and os.path.isfile(arguments["bag"]):  # it may lie on another machine
        name = robot_of_bag(arguments["bag"])
    if not name:
        raise ProductError("no robot is given and no bag names one; give robot:=NAME or "
                           f"robot:=FILE, there are: {', '.join(config_files.files('robots'))}")
    path = config_files.find("robots", name)
    content = config_files.load(path)
    parameters.require_valid_robot(path, product.content.get("libraries") or [])
    return content
