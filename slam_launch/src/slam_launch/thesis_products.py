# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The thesis's five products (6.2.1 to 6.2.5) on the same office data: its figures 6.1 to 6.10
with the truth beside them, and a table, on one page."""

import dataclasses
import json
import shutil
import sys
import time

from slam_eval.report import comparison

from . import diagram, products
from .demonstration import call_quietly, SEED, world_file


@dataclasses.dataclass(frozen=True)
class Experiment:
    """A section of the thesis: the product, its diagram's number, and pictures of the run by
    number with what they show."""

    product: str
    title: str
    text: str
    diagram: str
    pictures: dict
    changed_from: str = ""
    detector: str = ""  # another than the product file's


EXPERIMENTS = (
    Experiment(
        "ekf_wheel", "6.2.1 Extended Kalman filter, landmarks",
        "Wheel odometry and the markers that a front camera sees go into an extended Kalman "
        "filter.", "6.1",
        {"6.2a": ("map.png", "Path and landmarks with their 95 % ellipses. The robot drove round "
                             "twice; both laps lie on the true path."),
         "6.2b": ("trajectory.png", "The same path beside that of the wheels alone, whose second "
                                    "lap is turned against the first.")}),
    Experiment(
        "pf_wheel", "6.2.2 Particle filter, landmarks",
        "The particle filter takes the place of the Kalman filter; nothing else changes.", "6.3",
        {"6.4": ("map.png", "Path and landmarks of the particle filter, on the same images and "
                            "the same wheels.")}, "ekf_wheel"),
    Experiment(
        "pf_visual", "6.2.3 Visual odometry",
        "A camera that looks at the ceiling takes the wheels' place.", "6.5",
        {"6.6a": ("map.png", "Path and landmarks, without wheels."),
         "6.6b": ("odometry.png", "Visual and wheel odometry, both uncorrected: each drifts in its "
                                  "own way, the wheels far more.")}, "pf_wheel"),
    Experiment(
        "ekf_wheel_pointmap", "6.2.4 A map of points, to look at",
        "A component of its own collects where a laser's beams ended, at the Kalman filter's "
        "poses; the filter knows nothing of it.", "6.7",
        {"6.8": ("map.png", "The points over the true walls and furniture. Each scan is aligned to "
                            "the map first, as the thesis proposes; with its own way of fusing, "
                            "point_map.fusion: euclidean, walls come out as thick as poses err.")},
        "ekf_wheel"),
    Experiment(
        "pf_wheel_grid", "6.2.5 Particle filter, occupancy grid",
        "Each particle carries an occupancy grid that the laser's scans are drawn into; as in the "
        "thesis the markers that the camera sees weigh in as well (detector: apriltag).", "6.9",
        {"6.10": ("map.png", "Occupied and free cells, the path, and the landmarks; the thin green "
                             "lines are the true walls and furniture.")}, "pf_wheel", "apriltag"),
)
COLOURED = "Coloured: what {} has not."


def product_of(experiment, model):
    """Returns the Product of an experiment, with its detector."""
    product = products.find(experiment.product, model)
    if not experiment.detector:
        return product
    return products.swapped(product, {**product.features, "detector": experiment.detector})


def draw_diagram(experiment, path, model):
    former = experiment.changed_from and products.find(experiment.changed_from, model)
    diagram.draw(product_of(experiment, model), path, model, former)
    caption = COLOURED.format(experiment.changed_from) if former else (
        "Boxes are nodelets, arrows topics.")
    return comparison.Picture(path, f"Figure {experiment.diagram}", caption)


def run(experiment, bag, folder):
    """Runs and evaluates a product; returns its metrics."""
    run_folder = folder / experiment.product
    choice = ["--set", f"detector={experiment.detector}"] if experiment.detector else []
    call_quietly("slam_ros", "slam_run", experiment.product, "--bag", bag, "--out", run_folder,
                 *choice)
    call_quietly("slam_eval", "slam_eval", run_folder, "--world", world_file())
    return json.loads((run_folder / "metrics.json").read_text(encoding="utf-8"))


def chapter(experiment, bag, folder, model):
    metrics = run(experiment, bag, folder)
    drawn = draw_diagram(experiment, folder / experiment.product / "components.svg", model)
    pictures = [comparison.Picture(folder / experiment.product / file, f"Figure {number}", caption)
                for number, (file, caption) in experiment.pictures.items()]
    return comparison.Chapter(experiment.product, experiment.title, experiment.text, metrics, drawn,
                              pictures)


def told(experiment, metrics, seconds):
    """The line that a terminal shows of a product."""
    width = max(len(other.product) for other in EXPERIMENTS)
    return (f"{experiment.product:{width}}  ATE {metrics['ate_rmse_m']:.4f} m, landmarks "
            f"{metrics['landmark_rmse_m']:.4f} m, CPU {metrics['cpu_s']:.1f} s ({seconds:.0f} s)")


def show_all(bag, folder, model):
    """Runs the five products on the bag; writes the page and prints the table."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    chapters = []
    for number, experiment in enumerate(EXPERIMENTS, 1):
        start = time.monotonic()
        if sys.stdout.isatty():
            print(f"{number} of {len(EXPERIMENTS)}: {experiment.product} ...", end="", flush=True)
        chapters.append(chapter(experiment, bag, folder, model))
        cleared = "\r\x1b[K" if sys.stdout.isatty() else ""
        print(cleared + told(experiment, chapters[-1].metrics, time.monotonic() - start),
              flush=True)
    page = folder / "report.html"
    page.write_text(comparison.render(
        "Five products of one line", f"the simulated office, seed {SEED}, the same drive for each; "
        "chapters and figures are numbered as in the thesis", chapters), encoding="utf-8")
    print(f"\n{comparison.text_table(chapters)}\n\nreport: {page}")
