# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the parts of this benchmark share: the map of a drive, and the section of some cases."""
from slam_eval.bench.harness.runs import run_ours
from slam_eval.bench.harness.table import Section, table, verdict
from slam_eval.bench.relocalisation.judge import DEFINITIONS, Outcome
from slam_eval.bench.relocalisation.starts import (draw, HEADER, is_in_time, places_of, row,
                                                   run_starts, write_csv)
from slam_eval.geometry import se2
from slam_eval.io.run_folder import read_run
from slam_eval.io.trajectory import Trajectory
from slam_eval.metrics.evaluation import trajectory_error
from slam_eval.plot.relocalisation import plot_starts


def map_of(context, name, bag, product, settings=(), robot=None):
    """(folder, truth) of the run that maps a drive. Truth is in the frame of its map; where the bag
    has none, it is the path of the run itself."""
    folder, _ = run_ours(context, name, bag, robot, product, settings, f"map of {name}")
    run = read_run(folder)
    error = run.truth and trajectory_error(run.trajectory, run.truth)
    if error is None:
        return folder, run.final
    T_map_truth = se2.inverse(error.T_truth_map)
    return folder, Trajectory(run.truth.stamps, se2.transform_poses(T_map_truth, run.truth.poses))


class Cases:
    """Runs cases one after the other and collects their rows and pictures in a section."""

    def __init__(self, context, title):
        self._context, self._rows, self._lines = context, [], []
        self.section = Section(title)

    def add(self, case, start_of, least=None, most_wrong=0):
        """Run a case; least: of its starts that must be right in time, as a share."""
        options = self._context.options
        starts = draw(options.starts, options.seed, case.log, start_of)
        verdicts = run_starts(self._context, case, starts)
        self._rows.append(row(case, verdicts))
        stem = f"relocalisation_{case.name}".replace(" ", "_")
        write_csv(self._context.out / f"{stem}.csv", case, starts, verdicts)
        path = self._context.out / f"{stem}.png"
        plot_starts(f"Relocalisation · {case.name}", read_run(case.map_folder), case.truth,
                    places_of(case, starts), [v.outcome.value for v in verdicts], path)
        self.section.pictures[case.name] = path
        self._goals(case, verdicts, least, most_wrong)

    def _goals(self, case, verdicts, least, most_wrong):
        wrong = sum(v.outcome is Outcome.WRONG for v in verdicts)
        goals = [f"wrong {wrong} ({verdict(wrong, most_wrong, True)})"]
        if least is not None:
            share = sum(is_in_time(case, v) for v in verdicts) / len(verdicts)
            goals.insert(0, f"right within {case.limit:g} s {share:.0%} "
                         f"({verdict(share, least, False)})")
        self._lines.append(f"- {case.name}: {', '.join(goals)}")

    def finished(self, *remarks):
        """The section."""
        self.section.paragraphs = [table(HEADER, self._rows), "\n".join(self._lines), *remarks,
                                   DEFINITIONS]
        return self.section
