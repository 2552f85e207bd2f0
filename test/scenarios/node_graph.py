# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the components of a product and their topics, as the master knows them, as JSON.

The nodelets run as processes of their own here: those of one manager are one node to the master.
"""

import json
import os
import sys
import time

from launching import free_port
import rosgraph
import roslaunch

# What is no data between components.
ASIDE = ("/rosout", "/clock", "/diagnostics", "/tf", "/ground_truth", "/progress", "/consistency")
# Nodelets that drive the component which the product names.
NAMED_BY = {"slam_frontend/FiducialDetector": "detector", "slam_frontend/WheelOdometry": "odometry"}
PATIENCE = 90  # [s] until every nodelet is there
QUIET = 4      # [s] without a change: all have subscribed


def load(product, robot, port):
    """Returns a launch of the product whose nodelets stand alone."""
    arguments = [f"product:={product}", f"robot:={robot}"]
    file = roslaunch.rlutil.resolve_launch_arguments(["slam_launch", "slam.launch"])[0]
    parent = roslaunch.parent.ROSLaunchParent(f"scenarios{port}", [(file, arguments)], port=port,
                                              verbose=False)
    parent._load_config()
    nodelets = [node for node in parent.config.nodes if node.args.startswith("load ")]
    for node in nodelets:
        node.args = "standalone " + node.args.split()[1]
    parent.config.nodes = nodelets
    return parent


def settled(master, names):
    """Waits until all are there and nothing changes any more; returns the master's state."""
    last, since = None, time.monotonic()
    end = since + PATIENCE
    while time.monotonic() < end:
        state = master.getSystemState()
        if state != last:
            last, since = state, time.monotonic()
        known = {node for entries in state[:2] for _, nodes in entries for node in nodes}
        if names <= known and time.monotonic() - since > QUIET:
            return state
        time.sleep(0.2)
    raise RuntimeError(f"not all of {', '.join(sorted(names))} came up")


def topics_of(node, entries):
    """Returns the data topics that a node has in a list of (topic, nodes)."""
    return sorted(topic for topic, nodes in entries if node in nodes and is_data(topic))


def is_data(topic):
    return not topic.startswith(ASIDE) and not topic.endswith("/bond")


def component(plugin, product):
    """Returns the name of what runs in a nodelet."""
    key = NAMED_BY.get(plugin)
    return f"{plugin} {product[key]}" if key else plugin


def main(product, robot="sim_segway"):
    port = free_port()
    os.environ["ROS_MASTER_URI"] = f"http://localhost:{port}"
    parent = load(product, robot, port)
    chosen = parent.config.params["/product"].value
    plugins = {node.namespace + node.name: component(node.args.split()[1], chosen)
               for node in parent.config.nodes}
    parent.start()
    try:
        state = settled(rosgraph.Master("/scenarios"), set(plugins))
    finally:
        parent.shutdown()
    print(json.dumps({name: {"plugin": plugin, "in": topics_of(name, state[1]),
                             "out": topics_of(name, state[0])}
                      for name, plugin in plugins.items()}))


if __name__ == "__main__":
    roslaunch.pmon._init_signal_handlers()
    main(*sys.argv[1:])
