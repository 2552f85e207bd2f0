# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark online: a log in real time through the nodes; time from image to pose, losses, CPU."""
import contextlib
import json
import os
import pathlib
import shutil
import socket
import subprocess
import time

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.products import sensors_for, twin_of
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.runs import call, simulate
from slam_eval.bench.harness.table import Section, number, table, verdict
from slam_eval.io.run_folder import read_metrics

LATENCY_LIMIT = 50.0  # [ms], of 99 of 100 images
CEILING_PERIOD = 1000.0 / 15.0  # [ms], for which a pose may wait where images are the odometry
PATIENCE = 15.0       # [s], for a process to start or to end

HEADER = ["product", "images", "without pose", "dropped", "p50 [ms]", "p99 [ms]", "max [ms]",
          "CPU of the manager"]


def _free_port():
    with socket.socket() as listener:
        listener.bind(("localhost", 0))
        return listener.getsockname()[1]


def _wait(condition, what):
    deadline = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > deadline:
            raise BenchError(f"{what} did not come within {PATIENCE:g} s; look at its log "
                             "(call again with --keep DIR)")
        time.sleep(0.1)


def _listens(port):
    with socket.socket() as client:
        return client.connect_ex(("localhost", port)) == 0


@contextlib.contextmanager
def _background(command, log):
    """A program that is told to end afterwards."""
    with open(log, "wb") as out:
        try:
            process = subprocess.Popen([str(word) for word in command], stdout=out,
                                       stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        except OSError as error:
            raise BenchError(f"{command[0]} cannot be run ({error.strerror})") from None
        try:
            yield process
        finally:
            process.terminate()
            try:
                process.wait(PATIENCE)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


@contextlib.contextmanager
def ros_master(log):
    """A ROS master of its own, so that a running robot is not disturbed."""
    port, before = _free_port(), os.environ.get("ROS_MASTER_URI")
    os.environ["ROS_MASTER_URI"] = f"http://localhost:{port}"
    try:
        with _background([shutil.which("roscore") or "roscore", "-p", port], log):
            _wait(lambda: _listens(port), "roscore")
            yield
    finally:
        if before is None:
            del os.environ["ROS_MASTER_URI"]
        else:
            os.environ["ROS_MASTER_URI"] = before


def _duration(bag):
    import rosbag  # takes a while, and only this benchmark needs it
    with rosbag.Bag(str(bag)) as log:
        return log.get_end_time() - log.get_start_time()


def replay(context, bag):
    """The figures of the probe and of the run's metrics.json, of a replay at the log's speed."""
    options, seconds = context.options, _duration(bag)
    figures, folder = context.work / "online_latency.json", context.work / "online_run"
    figures.unlink(missing_ok=True)  # of an earlier call with the same --keep
    command = [workspace_program("slam_ros", "slam_run"), options.product, "--bag", bag, "--out",
               folder, "--online", "--rate", "1", "--composition", options.composition]
    command += ["--set", f"detector={options.detector}"] if options.detector else []
    with ros_master(context.work / "online_roscore.log"):
        with _background([workspace_program("slam_eval", "latency_probe"), figures],
                         context.work / "online_probe.log"):
            call(context, f"{options.product} online, {seconds:.0f} s of data", command,
                 context.work / "online_run.log")
        _wait(figures.exists, "the result of latency_probe")
    return {**read_metrics(folder / "metrics.json"),
            **json.loads(figures.read_text(encoding="utf-8"))}


def row(product, figures):
    """The line of the table."""
    return [product, number(figures["images"], "d"), number(figures.get("unanswered"), "d"),
            number(figures.get("dropped_messages"), "d"), number(figures.get("p50_ms"), ".1f"),
            number(figures.get("p99_ms"), ".1f"), number(figures.get("max_ms"), ".1f"),
            number(figures.get("cpu"), ".0%")]


def measure(context):
    """The section of this benchmark."""
    options = context.options
    bag = options.bag or simulate(context, pathlib.Path(options.world).stem, options.world, 1,
                                  sensors_for(options.product))
    figures = replay(context, bag)
    if "p99_ms" not in figures:
        raise BenchError(f"of {figures['images']} images none got a pose; look at online_run.log "
                         "(call again with --keep DIR)")
    limit = LATENCY_LIMIT + (CEILING_PERIOD if twin_of(options.product) else 0.0)
    lost = figures["unanswered"] + figures.get("dropped_messages", 0)
    section = Section(f"{options.product} online, {options.composition}")
    section.paragraphs += [
        table(HEADER, [row(options.product, figures)]),
        f"p99 {figures['p99_ms']:.1f} ms ({verdict(figures['p99_ms'], limit, True)}); "
        f"lost {lost} ({verdict(lost, 0, True)}).",
        "Latency: from the arrival of an image at a subscriber to that of the pose with its stamp, "
        "the wait for odometry that covers the stamp included. Without pose: images between the "
        "first pose and the last that got none. CPU: share of one core."]
    return section
