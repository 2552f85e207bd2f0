# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part consistency: NEES over a simulated loop, averaged over seeds."""
import json

import numpy as np

from slam_eval.bench_error import BenchError
from slam_eval.bench_plots import plot_average_nees
from slam_eval.bench_programs import workspace_program
from slam_eval.bench_runs import call
from slam_eval.bench_table import Section, number, table
from slam_eval.chi_square import two_sided_bounds

LOOPS = (60, 120)  # [m]
FIRST_STEP = 20    # the map is young before, and NEES says little
POSE_DOF = 3

HEADER = ['loop', 'steps', 'in bounds', 'mean NEES', 'NIS/dof', 'position rmse [m]']


def bounds(seeds, probability=0.95):
    """Bounds of the average over seeds of a NEES of three degrees of freedom."""
    low, high = two_sided_bounds(POSE_DOF * seeds, probability)
    return low / seeds, high / seeds


def summary(result):
    """(share of steps inside the bounds, mean NEES), both after the first steps."""
    values = np.array(result['average_nees'][FIRST_STEP:])
    if not len(values) or not np.all(np.isfinite(values)):
        raise BenchError('slam_eval_consistency printed no finite NEES after step '
                         f'{FIRST_STEP}; the filter failed on this case')
    low, high = bounds(result['seeds'])
    return float(np.mean((values >= low) & (values <= high))), float(np.mean(values))


def run_loop(context, loop):
    """What slam_eval_consistency says of a loop [m]."""
    log = context.work / f'consistency_{loop}.json'
    command = [workspace_program('slam_eval', 'slam_eval_consistency'), '--loop', str(loop),
               '--seeds', str(context.options.seeds)]
    call(context, f'consistency, loop of {loop} m, {context.options.seeds} seeds', command, log)
    try:
        return json.loads(log.read_text(encoding='utf-8'))
    except json.JSONDecodeError:
        raise BenchError('slam_eval_consistency printed no JSON; build it again') from None


def row(loop, result):
    """A line of the table."""
    inside, nees = summary(result)
    return [f'{loop} m', number(len(result['average_nees']), 'd'), number(inside, '.1%'),
            number(nees, '.2f'), number(result['nis_mean'], '.3f'),
            number(result['position_rmse_m'], '.3f')]


def measure(context):
    """The section of this part."""
    seeds = context.options.seeds
    results = {loop: run_loop(context, loop) for loop in LOOPS}
    low, high = bounds(seeds)
    section = Section('Consistency: a simulated loop')
    section.paragraphs += [
        table(HEADER, [row(loop, result) for loop, result in results.items()]),
        f'Three laps past 20 landmarks, {seeds} seeds. "In bounds": share of the steps '
        f'after the first {FIRST_STEP} whose NEES, averaged over the seeds, lies inside its 95 % '
        f'bounds ({low:.2f} to {high:.2f}; 3 and 1 are expected of NEES and NIS/dof).']
    path = context.out / 'consistency_nees.png'
    plot_average_nees(results, (low, high), path)
    section.pictures['average NEES over time'] = path
    return section
