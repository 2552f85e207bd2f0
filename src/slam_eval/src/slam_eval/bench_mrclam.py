# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part mrclam: the five robots of a MRCLAM set with one configuration."""
import dataclasses
from typing import Optional

import numpy as np

from slam_eval.bench_plots import plot_trajectories
from slam_eval.bench_programs import data_folder
from slam_eval.bench_runs import import_log, run_ours
from slam_eval.bench_table import Section, mean_row, number, table, verdict
from slam_eval.metrics import evaluate, inside_bounds
from slam_eval.run_folder import read_run

ROBOTS = (1, 2, 3, 4, 5)
ATE_LIMIT, LANDMARK_LIMIT = 0.25, 0.09  # [m]

HEADER = ['robot', 'ATE [m]', 'landmarks [m]', 'dead reckoning [m]', 'NEES', 'in bounds',
          'NIS/dof', 'updates', 'wall [s]', 'CPU [s]', 'memory [MB]']
FORMS = ['.3f', '.3f', '.3f', '.2f', '.1%', '.3f', '.0f', '.2f', '.2f', '.1f']


@dataclasses.dataclass
class Robot:
    """A robot's run with its evaluation and cost."""

    name: str
    run: object
    result: object
    usage: object

    @property
    def inside(self) -> Optional[float]:
        """Share of the steps whose NEES lies inside its 95 % bounds."""
        pose = self.result.consistency
        if pose is None:
            return None
        return float(np.mean(inside_bounds(pose.nees, np.full(len(pose.nees), 3))))

    def values(self):
        """The numbers of a line of the table."""
        m, u = self.result.metrics, self.usage
        return [self.name, m.get('ate_rmse_m'), m.get('landmark_rmse_m'),
                m.get('odometry_ate_rmse_m'), m.get('nees_mean'), self.inside, m.get('nis_mean'),
                len(self.run.trajectory), u.wall_s, u.cpu_s, u.max_rss_mb]


def run_robot(context, data, robot):
    """Import, run and evaluate one robot."""
    name = f'robot{robot}'
    bag = import_log(context, name, ['mrclam', data, '--robot', str(robot)])
    folder, usage = run_ours(context, name, bag, 'mrclam')
    run = read_run(folder)
    return Robot(str(robot), run, evaluate(run), usage)


def measure(context):
    """The section of this part."""
    section = Section('Accuracy: MRCLAM')
    data = context.options.data or data_folder('mrclam_dataset6')
    if not data.is_dir():
        section.paragraphs.append(f'Left out: there is no folder {data} with a MRCLAM data '
                                  'set (--data DIR or $SLAM_DATA_DIR name another one).')
        return section
    robots = [run_robot(context, data, robot) for robot in ROBOTS]
    values = [robot.values() for robot in robots]
    mean = mean_row('mean', values)
    rows = [[v[0], *(number(x, f) for x, f in zip(v[1:], FORMS))] for v in [*values, mean]]
    remarks = [f'{what} {value:.3f} m ({verdict(value, limit, True)})' for what, value, limit in (
        ('mean ATE', mean[1], ATE_LIMIT), ('mean landmark RMSE', mean[2], LANDMARK_LIMIT))
        if value is not None]
    section.paragraphs += [table(HEADER, rows), f'{data.name}: ' + '; '.join(remarks)
                           + '. Errors after a rigid alignment; "in bounds" is the share of steps '
                           'whose NEES lies inside its 95 % bounds. Import not counted.']
    path = context.out / 'mrclam_trajectories.png'
    plot_trajectories(robots, path)
    section.pictures['trajectories of the MRCLAM robots'] = path
    return section
