# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""MRPT's kf-slam beside our EKF on the same rawlog, both maps judged by one rule."""
import dataclasses
import re

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.process import Usage
from slam_eval.bench.harness.programs import system_program
from slam_eval.bench.harness.runs import call, import_log, run_ours
from slam_eval.bench.peers import mrpt_config as mrpt
from slam_eval.io.mrpt_files import read_map
from slam_eval.metrics.landmark_comparison import compare


@dataclasses.dataclass(frozen=True)
class Result:
    """Cost of a run and the errors of its map: the figures of `compare`, and `aligned_mean_m`."""

    usage: Usage
    errors: dict


def landmark_result(usage, path, truth, rawlog=None):
    """The result of a run by its map: the same rule for our maps and kf-slam's."""
    estimate, true = read_map(path, rawlog), read_map(truth)
    aligned = compare(estimate, true, align=True)["mean_m"]
    return Result(usage, {**compare(estimate, true), "aligned_mean_m": aligned})


def ours_on_rawlog(context, name, rawlog, truth):
    """Our result on a rawlog of MRPT's demonstrations."""
    bag = import_log(context, name, ["rawlog", rawlog])
    folder, usage = run_ours(context, name, bag, "mrpt_demo")
    return landmark_result(usage, folder / "landmarks.yaml", truth), folder


def _last_step(log):
    """The step kf-slam has come to, from the end of its output."""
    with open(log, "rb") as stream:
        stream.seek(max(0, log.stat().st_size - 2000))
        steps = re.findall(rb"Step (\d+)", stream.read())
    return int(steps[-1]) if steps else 0


def kf_slam_on_rawlog(context, name, rawlog, truth, ini, last_step):
    """kf-slam's result on a rawlog, or None where it is not installed."""
    program = system_program("kf-slam")
    if program is None:
        return None
    folder = context.folder(f"{name}_kf_slam")
    (folder / "kf-slam.ini").write_text(ini, encoding="ascii")
    log, scene = folder / "kf-slam.log", folder / "map" / mrpt.scene_name(last_step)
    scene.unlink(missing_ok=True)  # of an earlier call with the same --keep
    usage = call(context, f"kf-slam on {name}", [program, "kf-slam.ini", rawlog], log, folder,
                 lambda: f"step {_last_step(log)} of {last_step}")
    if not scene.exists():
        raise BenchError(f"kf-slam wrote no {scene.name} for {rawlog}; its output is {log} "
                         "(call again with --keep DIR)")
    return landmark_result(usage, scene, truth, rawlog)
