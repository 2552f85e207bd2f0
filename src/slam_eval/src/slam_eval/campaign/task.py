# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""One drive or one run of a campaign, wherever it is executed. It is there completely or not at
all: it is made in a folder of its own, which is renamed at the end."""
import argparse
import json
import os
import pathlib
import re
import shutil
import signal
import sys
import tempfile
import time

from slam_eval.bench.harness import process
from slam_eval.bench.harness.error import BenchError, ProgramError
from slam_eval.campaign import plan as plans
from slam_eval.campaign.folder import Folder, locked, RESULT
from slam_eval.campaign.inputs import hash_of_file, program
from slam_eval.foreign.driver import Job
from slam_eval.foreign.registry import find_system
from slam_eval.io.atomic_file import write_atomically
from slam_eval.io.errors import exit_code_of, InputError
from slam_eval.io.run_folder import read_run
from slam_eval.io.world_plan import read_world
from slam_eval.metrics.evaluation import evaluate
from slam_eval.metrics.map_agreement import judge_map
from slam_eval.metrics.relations import judge_run, TOLERANCE
from slam_eval.report.metric_table import merge

# Ended from outside, which says nothing of the run itself: it is tried again.
FROM_OUTSIDE = {-signal.SIGKILL, -signal.SIGTERM, -signal.SIGINT, -signal.SIGHUP, -signal.SIGPIPE,
                128 + signal.SIGINT, 128 + signal.SIGTERM}
TWICE = re.compile(r"^(\w+) ended with exit code \d+: \1: ")  # who says it


class Interrupted(InputError):
    """A run that somebody ended."""


def deadline(limit):
    """What watches the programs of a run, which share a limit [s] of the wall clock from now on."""
    end = time.monotonic() + limit

    def watch(_):
        if time.monotonic() > end:
            raise BenchError(f"it took longer than {limit:g} s, the campaign's time_limit")
    return watch


def call(command, log, watch=None):
    """Runs a program. Raises BenchError with what it said, Interrupted where it was ended from
    outside. watch: a deadline."""
    try:
        return process.run(command, log, watch=watch)
    except ProgramError as error:
        if error.code in FROM_OUTSIDE:
            raise Interrupted(f"{error}; it was ended from outside and is run again by the next "
                              "call") from None
        raise


def _run_ours(run, bag, work):
    command = [program("slam_ros", "slam_offline"), run.product, "--bag", bag, "--out", work,
               "--seed", run.seed, "--origin", json.dumps(
                   {"bag": {"name": pathlib.Path(run.bag).name, "sha256": run.bag_sha256}})]
    command += ["--robot", run.robot] if run.robot else []
    command += [word for setting in run.settings for word in ("--set", setting)]
    command += [word for remap in run.remap for word in ("--remap", remap)]
    call(command, work / "log.txt", deadline(run.time_limit))


def _run_foreign(run, bag, work):
    system, watch = find_system(run.product, run.product), deadline(run.time_limit)
    system.run(Job(bag, work, run.seed, run.robot, run.settings,
                   lambda command, log: call(command, log, watch)))
    call([program("slam_ros", "slam_ground_truth"), bag, work], work / "ground_truth.txt")


def judge(folder, world, relations):
    """Adds the figures of a run to its metrics.json. Raises InputError."""
    run = read_run(folder)
    plan = read_world(pathlib.Path(world)) if world else None
    errors = judge_run(run, pathlib.Path(relations), None, TOLERANCE) if relations else None
    result = evaluate(run, errors, judge_map(run, plan, world))
    write_atomically(folder / "metrics.json",
                     json.dumps(merge(run.metrics, result.metrics), indent=2) + "\n")


def said(error, work, folder, name, bag=None):
    """What an error says, without folders and names that differ from host to host."""
    text = " ".join(str(error).split()).replace(str(work), f"runs/{name}")
    text = text.replace(f"{folder.path}/", "")
    if bag is not None and bag.startswith("bags/"):
        text = text.replace(f"the bag {bag}", "the drive's bag")
    return TWICE.sub(r"\1: ", text)


def make_run(folder, name):
    """Makes a run, or notes why it failed."""
    run = plans.read_run(folder.plan, name)
    for left in folder.work.glob(f"{name}.*.part"):  # of a process that was killed
        shutil.rmtree(left, ignore_errors=True)
    work = pathlib.Path(tempfile.mkdtemp(prefix=f"{name}.", suffix=".part", dir=folder.work))
    work.chmod(0o755)
    failure = None
    try:
        (_run_foreign if run.is_foreign else _run_ours)(run, folder.path / run.bag, work)
        judge(work, run.world, run.relations)
    except Interrupted:
        shutil.rmtree(work, ignore_errors=True)
        raise
    except (BenchError, InputError) as error:
        failure = said(error, work, folder, name, run.bag)
    write_atomically(work / RESULT, json.dumps({"failure": failure}) + "\n")
    if not folder.result(name).exists():
        shutil.rmtree(folder.run(name), ignore_errors=True)  # it has lost its result
    try:
        os.rename(work, folder.run(name))
    except OSError:
        shutil.rmtree(work, ignore_errors=True)
        if not folder.result(name).exists():  # else another host was faster
            raise


def make_drive(folder, name):
    """Simulates a drive, or notes why that failed."""
    drive = plans.read_drive(folder.plan, name)
    bag = folder.drive(name)
    command = [program("slam_sim", "slam_sim"), bag, "--world", drive.world, "--robot", drive.robot,
               "--seed", drive.seed, "--threads", 1]
    command += ["--duration", drive.duration] if drive.duration else []
    command += ["--only", ",".join(drive.only)] if drive.only else []
    log = folder.work / f"{name}.drive.txt"
    try:
        call(command, log)
        result = {"sha256": hash_of_file(bag)}
    except BenchError as error:
        result = {"failure": f"the drive cannot be simulated: {said(error, log, folder, name)}"}
    write_atomically(folder.drive_result(name), json.dumps(result) + "\n")


def make(kind, folder, name):
    """Makes what is not there yet; two that are asked for the same wait for one another."""
    done = {"drive": folder.drive_result, "run": folder.result}[kind](name)
    with locked(folder.work / f"{name}.lock", wait=True):
        if not done.exists():
            {"drive": make_drive, "run": make_run}[kind](folder, name)


def main(arguments=None):
    """Entry point: exit code 0 where a result was noted, be it a failure."""
    parser = argparse.ArgumentParser(prog="slam_campaign_task", description="Makes one drive or "
                                                                            "run of a campaign; "
                                                                            "Snakemake calls it.")
    parser.add_argument("kind", choices=("drive", "run"))
    parser.add_argument("folder", type=pathlib.Path, help="the campaign's")
    parser.add_argument("name", help="of the drive or run in plan.json")
    options = parser.parse_args(arguments)
    folder = Folder(options.folder)
    return exit_code_of("slam_campaign_task",
                        lambda: make(options.kind, folder, options.name), folder.path)


if __name__ == "__main__":
    sys.exit(main())
