# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Has this machine time for SLAM?"""
import os
import pathlib

from slam_doctor.finding import ok, warn

GOVERNORS = "devices/system/cpu/cpu*/cpufreq/scaling_governor"
LOAD = 0.8       # of each core, above: WARN
MEMORY = 500.0   # available, below: WARN [MB]


def check(case):
    """Findings about this machine; where a bag is looked at, only what it is."""
    return computer(len(os.sched_getaffinity(0)), os.getloadavg()[0], governors(), memory(),
                    case.recording.is_live)


def governors(root=pathlib.Path("/sys")):
    """The names of the clock governors; empty where the kernel tells none. A processor that sets
    its clock itself (intel_pstate, amd-pstate) calls powersave what others call schedutil."""
    found = set()
    for path in root.glob(GOVERNORS):
        driver = path.with_name("scaling_driver")
        by_itself = driver.exists() and "pstate" in driver.read_text(encoding="utf-8")
        name = path.read_text(encoding="utf-8").strip()
        found.add(f"{name} of the processor" if by_itself else name)
    return found


def memory(path=pathlib.Path("/proc/meminfo")):
    """The available memory [MB]."""
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("MemAvailable:"):
            return int(line.split()[1]) / 1024.0
    return float("inf")


def computer(cores, load, names, free, is_live):
    """Findings about cores, load, clock and memory."""
    text = f"{cores} cores, load {load:.1f}, {free / 1024:.1f} GB of memory free"
    text += f", clock governor {', '.join(sorted(names))}" if names else ""
    if is_live and load > LOAD * cores:
        return [warn("computer", text, "Stop what else runs, or run SLAM on another machine "
                     "(docs/architecture.md, Two machines).", load, "load")]
    if is_live and names & {"powersave", "conservative"}:
        return [warn("computer", text, "Set the governor to performance or schedutil (cpupower "
                     "frequency-set -g performance).", load, "load")]
    if is_live and free < MEMORY:
        return [warn("computer", text, "Close other programs: maps and particles need memory.",
                     free, "MB")]
    return [ok("computer", text, load, "load")]
