# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""MRPT's rbpf-slam as a foreign system."""
from matplotlib import image
import numpy as np

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.peers.bag_rawlog import BagRawlog, parse_scans, read_path
from slam_eval.bench.peers.rbpf_slam import configuration, CONFIGURATIONS, map_picture
from slam_eval.foreign.bag_data import robot_of
from slam_eval.foreign.driver import Driver
from slam_eval.foreign.mrpt import program
from slam_eval.foreign.results import (
    with_odometry_between, write_about, write_grid, write_trajectory)
from slam_eval.io.trajectory import Trajectory

_WAY = "log_estimated_path.txt"


def read_way(folder, rawlog):
    """The poses as rbpf-slam estimated them frame by frame."""
    stamps = rawlog.odometry.stamps[rawlog.is_frame]
    try:
        poses = np.loadtxt(folder / _WAY, ndmin=2)[:, [1, 2, 4]]
    except (OSError, ValueError, IndexError):
        poses = np.empty((0, 3))
    if len(poses) != len(stamps):
        raise BenchError(f"{folder / _WAY} holds {len(poses)} poses for {len(stamps)} frames: "
                         "rbpf-slam is of another version")
    return Trajectory(stamps, poses)


def read_grid_picture(path):
    """(probabilities of being free, the top row first, resolution, origin) of MRPT's final map."""
    free = image.imread(path)
    free = free if free.ndim == 2 else free[:, :, 0]
    low_x, high_x, low_y, _ = np.loadtxt(path.with_name(path.stem + "_limits.txt"), comments="%")
    return free, (high_x - low_x) / free.shape[1], (low_x, low_y)


class MrptRbpf(Driver):
    """A particle filter with grids; its trajectory.tum is what it estimated frame by frame, with
    odometry between, its trajectory_final.tum the path of the most likely particle at the end."""

    required = ("configuration",)
    positive = ("distance", "angle")
    counts = ("particles",)

    def programs(self):
        configured = CONFIGURATIONS / str(self.parameters["configuration"])
        if not configured.is_file():
            raise BenchError(f"there is no {configured}; install mrpt-common")
        exporter = workspace_program("slam_eval", "slam_eval_rawlog")
        return [program("rbpf-slam"), exporter, configured]

    def _rawlog(self, job):
        path, log = job.folder / "bag.rawlog", job.folder / "rawlog.txt"
        job.call([workspace_program("slam_eval", "slam_eval_rawlog"), job.bag, path, "--distance",
                  self.number("distance"), "--angle", self.number("angle")], log)
        return BagRawlog(path, *parse_scans(log.read_text(encoding="utf-8")))

    def _configure(self, job):
        text = configuration(self.parameters["configuration"], {
            "SHOW_PROGRESS_IN_WINDOW": 0, "SAVE_3D_SCENE": 0, "SAVE_MAP_IMAGES": 0,
            "SAVE_POSE_LOG": 0, "LOG_FREQUENCY": 1, "logOutput_dir": job.folder / "map",
            "localizeLinDistance": 0, "localizeAngDistance_deg": 0,
            "sampleSize": int(self.number("particles"))})
        head = "[MappingApplication]\n"
        text = text.replace(head, f"{head}RANDOM_SEED = {job.seed}\n")
        path = job.folder / "rbpf-slam.ini"
        path.write_text(text, encoding="utf-8")
        return path

    def run(self, job):
        rawlog = self._rawlog(job)
        usage = job.call([program("rbpf-slam"), self._configure(job), rawlog.path],
                         job.folder / "log.txt")
        made = job.folder / "map"
        for name, path in (("trajectory", read_way(made, rawlog)),
                           ("trajectory_final", read_path(made, rawlog))):
            write_trajectory(job.folder / f"{name}.tum",
                             with_odometry_between(path, rawlog.odometry))
        write_trajectory(job.folder / "odometry.tum", rawlog.odometry)
        if (picture := map_picture(made)) is not None:
            write_grid(job.folder, *read_grid_picture(picture))
        write_about(job, "mrpt_rbpf", job.robot or robot_of(job.bag), usage,
                    int(np.count_nonzero(rawlog.is_frame)))
        rawlog.path.unlink()
        return usage
