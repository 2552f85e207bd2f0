# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part demo: our map of kf-slam_demo.rawlog beside that of MRPT's kf-slam."""
import pathlib

from slam_eval.bench.harness.products import EKF_WHEEL
from slam_eval.bench.harness.table import Section, number, table, verdict
from slam_eval.bench.peers import mrpt_config as mrpt
from slam_eval.bench.peers.kf_slam import kf_slam_on_rawlog, ours_on_rawlog
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import evaluate
from slam_eval.plot.landmark_errors import plot_landmark_errors

LOG = pathlib.Path("/usr/share/mrpt/datasets/kf-slam_demo.rawlog")
TRUTH = LOG.with_name("kf-slam_demo_ground_truth.txt")
LAST_STEP = 248
LIMIT = 1.05

HEADER = ["on kf-slam_demo.rawlog", "mean error [mm]", "rmse [mm]", "max [mm]", "landmarks",
          "CPU [s]", "wall [s]", "memory [MB]"]


def row(name, result):
    """A line of the table."""
    e, u = result.errors, result.usage
    return [name, *(number(1e3 * e[key], ".3f") for key in ("mean_m", "rmse_m", "max_m")),
            number(e["matched"], "d"), number(u.cpu_s, ".3f"), number(u.wall_s, ".3f"),
            number(u.max_rss_mb, ".1f")]


def _picture(folder, path):
    run = read_run(folder)
    plot_landmark_errors(run, evaluate(run), path)
    return path


def measure(context):
    """The section of this part."""
    section = Section("Accuracy: MRPT's demonstration")
    if not LOG.exists():
        section.paragraphs.append(f"Left out: there is no {LOG} (Debian package mrpt-common).")
        return section
    ours, folder = ours_on_rawlog(context, "kf-slam_demo", LOG, TRUTH)
    theirs = kf_slam_on_rawlog(context, "kf-slam_demo", LOG, TRUTH, mrpt.kf_slam_ini(LAST_STEP),
                               LAST_STEP)
    rows = [row(EKF_WHEEL, ours)]
    if theirs is None:
        remark = "kf-slam is not installed (Debian package mrpt-apps): nothing to compare with."
    else:
        rows.append(row("kf-slam, 2-D", theirs))
        ratio = ours.errors["mean_m"] / theirs.errors["mean_m"]
        remark = (
            f"Ratio of the mean errors {ratio:.4f} ({verdict(ratio, LIMIT, True)}). kf-slam with "
            f"its 2-D configuration as shipped (range sigma {mrpt.SHIPPED_RANGE_SIGMA} m, the log "
            "has 0.01 m). Both maps compared with the truth by one rule, in the frame of the "
            "start.")
    section.paragraphs += [table(HEADER, rows), remark]
    section.pictures["map of kf-slam_demo.rawlog"] = _picture(folder, context.out / "demo_map.png")
    return section
