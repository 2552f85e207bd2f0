# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The programs of ours that a benchmark calls: importers, the simulator, a product."""
import dataclasses
import pathlib

from slam_eval.bench.harness import process
from slam_eval.bench.harness.products import EKF_WHEEL
from slam_eval.bench.harness.programs import workspace_program


@dataclasses.dataclass
class Context:
    """What all parts share: folders for pictures and for temporary files, progress, options, and what
    a part has made that others use as well, by name."""

    out: pathlib.Path
    work: pathlib.Path
    progress: object
    options: object
    made: dict = dataclasses.field(default_factory=dict)

    def folder(self, name):
        """A folder for temporary files."""
        path = self.work / name
        path.mkdir(parents=True, exist_ok=True)
        return path


def call(context, task, command, log, cwd=None, state=None):
    """Run a command as a task. state() tells how far it is, instead of the seconds."""
    context.progress.begin(task)
    return process.run(command, log, cwd=cwd, watch=lambda seconds: context.progress.update(
        lambda: f"{seconds:.0f} s" + (f", {state()}" if state else "")))


def import_log(context, name, arguments):
    """Import a foreign log as NAME.bag; returns the bag."""
    bag = context.work / f"{name}.bag"
    command = [workspace_program("slam_eval", "slam_import"), *arguments, bag]
    call(context, f"import of {name}", command, context.work / f"{name}_import.log")
    return bag


def simulate(context, name, world, seed, sensors, label=None, robot="segway", duration=None):
    """Simulate a drive through a world with the sensors given as NAME.bag; returns the bag. duration: of
    the drive [s], instead of the whole path."""
    bag = context.work / f"{name}.bag"
    command = [workspace_program("slam_sim", "slam_sim"), bag, "--world", world,
               "--robot", robot, "--seed", str(seed), "--only", sensors]
    command += ["--duration", str(duration)] if duration else []
    call(context, f"{label or name}: simulation", command, context.work / f"{name}_simulation.log")
    return bag


def run_ours(context, name, bag, robot=None, product=EKF_WHEEL, settings=(),
             label=None, load_map=None):
    """Run a product offline on a bag; returns (folder of the run, usage).

    robot: its name or file, instead of the one that the bag names.
    settings: section.key=value, instead of the files' values.
    load_map: the folder of another run, to start with its map.
    """
    folder = context.work / f"{name}_run"
    command = [workspace_program("slam_ros", "slam_offline"), product, "--bag", bag,
               "--out", folder]
    command += ["--robot", robot] if robot else []
    command += ["--load-map", load_map] if load_map else []
    command += [word for setting in settings for word in ("--set", setting)]
    usage = call(context, f"{label or name}: {product}", command,
                 context.work / f"{name}_run.log")
    return folder, usage
