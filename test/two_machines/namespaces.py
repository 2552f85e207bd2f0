# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two machines on one: network namespaces with a link between them that can be cut."""

import json
import os
import shutil
import subprocess

IP = shutil.which("ip", path=f"/usr/sbin:/sbin:{os.environ.get('PATH', '')}")
ADDRESSES = {"robot": "192.0.2.1", "desk": "192.0.2.2"}  # for documentation, routed nowhere
MASTER = f"http://{ADDRESSES['robot']}:11311"


def ip(*words):
    return subprocess.run([IP, *words], check=True, stdout=subprocess.PIPE, text=True).stdout


def why_not():
    """Returns why this machine lets nobody make namespaces, or nothing."""
    if os.geteuid() != 0:
        return "only root can make network namespaces"
    if IP is None:
        return "there is no program ip (package iproute2)"
    name = f"slam_try_{os.getpid()}"
    made = subprocess.run([IP, "netns", "add", name], stderr=subprocess.PIPE, text=True,
                          check=False)
    if made.returncode != 0:
        return f"this machine does not let root make network namespaces: {made.stderr.strip()}"
    ip("netns", "delete", name)
    return ""


class Link:
    """A machine `robot` and a machine `desk` with one cable."""

    def __init__(self):
        self.names = {machine: f"slam_{machine}_{os.getpid()}" for machine in ADDRESSES}
        for name in self.names.values():
            ip("netns", "add", name)
        robot, desk = self.names.values()
        ip("link", "add", "eth0", "netns", robot, "type", "veth", "peer", "name", "eth0",
           "netns", desk)
        for machine, address in ADDRESSES.items():
            name = self.names[machine]
            ip("-n", name, "address", "add", f"{address}/24", "dev", "eth0")
            for device in ("lo", "eth0"):
                ip("-n", name, "link", "set", device, "up")

    def close(self):
        for name in self.names.values():
            ip("netns", "delete", name)

    def cut(self):
        ip("-n", self.names["robot"], "link", "set", "eth0", "down")

    def mend(self):
        ip("-n", self.names["robot"], "link", "set", "eth0", "up")

    def bytes(self):
        """Returns how many have left the robot and how many have come to it."""
        shown = json.loads(ip("-n", self.names["robot"], "-json", "-statistics", "link", "show",
                              "eth0"))
        counters = shown[0].get("stats64") or shown[0]["stats"]
        return counters["tx"]["bytes"], counters["rx"]["bytes"]

    def command(self, machine, *words):
        """Returns a command that runs on a machine, and its environment."""
        environment = {key: value for key, value in os.environ.items() if key != "ROS_HOSTNAME"}
        environment.update(ROS_MASTER_URI=MASTER, ROS_IP=ADDRESSES[machine])
        return ([IP, "netns", "exec", self.names[machine], *map(str, words)], environment)

    def start(self, machine, *words, **options):
        command, environment = self.command(machine, *words)
        return subprocess.Popen(command, env=environment, text=True, **options)
