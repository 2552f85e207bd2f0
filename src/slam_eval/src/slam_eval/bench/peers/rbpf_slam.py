# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""MRPT's rbpf-slam beside our grid product."""
import pathlib
import re

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import system_program
from slam_eval.bench.harness.runs import call

CONFIGURATIONS = pathlib.Path("/usr/share/mrpt/config_files/rbpf-slam")


def configuration(name, changes):
    """A configuration that MRPT ships, with other values for some keys. Raises BenchError."""
    path = CONFIGURATIONS / name
    if not path.is_file():
        raise BenchError(f"there is no {path}; install mrpt-common")
    text = path.read_text(encoding="utf-8", errors="replace")
    for key, value in changes.items():
        text, count = re.subn(rf"^{key}\s*=.*$", f"{key} = {value}", text, flags=re.MULTILINE)
        if count == 0:
            raise BenchError(f"{path} has no {key}: it is of another version of MRPT")
    return text


def run_rbpf_slam(context, name, shipped, rawlog, changes=None):
    """(folder of the results, usage) of rbpf-slam, or None where it is not installed.

    Without windows and pictures on the way: only what it costs to make the map counts.
    """
    program = system_program("rbpf-slam")
    if program is None:
        return None
    folder = context.folder(f"{name}_rbpf_slam")
    text = configuration(shipped, {
        "SHOW_PROGRESS_IN_WINDOW": 0, "SAVE_3D_SCENE": 0, "SAVE_MAP_IMAGES": 0,
        "LOG_FREQUENCY": 1000000, "logOutput_dir": "map", **(changes or {})})
    (folder / "rbpf-slam.ini").write_text(text, encoding="utf-8")
    usage = call(context, f"rbpf-slam on {name}", [program, "rbpf-slam.ini", rawlog],
                 folder / "rbpf-slam.log", folder)
    return folder / "map", usage


def map_picture(folder):
    """The picture of its final map, or None."""
    pictures = sorted(folder.glob("finalMap*OccupancyGridMap2D*.png"))
    return pictures[0] if pictures else None


def particles_of(folder):
    """How many particles a run of rbpf-slam was configured for."""
    text = (folder.parent / "rbpf-slam.ini").read_text(encoding="utf-8")
    return int(re.search(r"^sampleSize\s*=\s*(\d+)", text, re.MULTILINE).group(1))
