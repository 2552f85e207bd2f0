# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts intel and office of benchmark grid: the grid product on the standard log and in the
simulated office."""
import dataclasses

from slam_eval.bench_programs import data_folder, simulation_file
from slam_eval.bench_runs import import_log, run_ours, simulate
from slam_eval.bench_table import lines_of, mean_row, Section, table, verdict
from slam_eval.cli import judge_map
from slam_eval.metrics import evaluate
from slam_eval.plot_map import plot_map
from slam_eval.relations import judge_run
from slam_eval.run_folder import read_run
from slam_eval.world_plan import read_world

PRODUCT = 'pf_wheel_grid'
PARTICLES = 30
SENSORS = 'odom,scan,camera'

INTEL_HEADER = ['seed', 'relations', 'translation [m]', '+-', 'rotation [deg]', 'CPU [s]',
                'wall [s]', 'memory [MB]']
INTEL_FORMS = ['g', '.4f', '.4f', '.3f', '.1f', '.1f', '.0f']
# gmapping with as many particles and its defaults on such a machine, by the same rule; as published
# (Kuemmerle et al. 2009); MRPT's there on a part of the log
GMAPPING = ['gmapping', 2984, 0.067, 0.069, 2.49, 140.0, None, 470.0]
RBPF_SLAM = ['rbpf-slam, 1/5 of the scans, 10 particles', None, None, None, None, 190.0, None, None]
PUBLISHED = ['gmapping, published', None, 0.070, 0.083, None, None, None, None]

OFFICE_HEADER = ['seed', 'ATE [m]', 'NEES', 'cells on walls [%]', 'walls found [%]', 'CPU [s]',
                 'memory [MB]']
OFFICE_FORMS = ['.4f', '.2f', '.1f', '.1f', '.1f', '.0f']


@dataclasses.dataclass(frozen=True)
class Goal:
    """A limit that each line of a table has to keep to."""

    column: str
    limit: float
    at_most: bool = True


INTEL_GOALS = (Goal('translation [m]', 0.067), Goal('rotation [deg]', 2.5), Goal('CPU [s]', 45.0),
               Goal('memory [MB]', 200.0))
OFFICE_GOALS = (Goal('cells on walls [%]', 95.0, False), Goal('walls found [%]', 90.0, False))


@dataclasses.dataclass(frozen=True)
class OfficeCase:
    """What the product sees of the office, and how far it may be off."""

    name: str
    detector: str
    ate: float  # [m]

    @property
    def goals(self):
        """The limits of its table."""
        return (Goal('ATE [m]', self.ate), *OFFICE_GOALS)


OFFICE_CASES = (OfficeCase('laser alone', 'none', 0.06),
                OfficeCase('laser and landmarks', 'apriltag', 0.03))


def verdicts(goals, header, rows):
    """A line for each goal, by the worst of the rows."""
    lines = []
    for goal in goals:
        values = [row[header.index(goal.column)] for row in rows]
        if None in values:
            continue
        worst = max(values) if goal.at_most else min(values)
        lines.append(f'- worst {goal.column} {worst:.3g} '
                     f'({verdict(worst, goal.limit, goal.at_most)})')
    return '\n'.join(lines)


def _intel_seed(context, bag, relations, seed, section):
    folder, usage = run_ours(context, f'intel_{seed}', bag, product=PRODUCT,
                             settings=(f'seed={seed}', f'pf.particles={PARTICLES}'))
    run = read_run(folder)
    errors = judge_run(run, relations)
    if seed == 1:
        path = context.out / 'intel_map.png'
        plot_map(run, evaluate(run, errors), path)
        section.pictures['map of the Intel Research Lab, seed 1'] = path
    m = errors.metrics
    return [str(seed), m['relations'], m['relations_trans_mean_m'], m['relations_trans_std_m'],
            m['relations_rot_mean_deg'], usage.cpu_s, usage.wall_s, usage.max_rss_mb]


def measure_intel(context):
    """The section of part intel."""
    section = Section('Intel Research Lab')
    folder = context.options.laser or data_folder('laser')
    log, relations = folder / 'intel.clf', folder / 'intel.relations'
    missing = [path for path in (log, relations) if not path.is_file()]
    if missing:
        section.paragraphs.append(f'Left out: there is no file {missing[0]} (--laser DIR or '
                                  '$SLAM_DATA_DIR name another folder).')
        return section
    bag = import_log(context, 'intel', ['carmen', log])
    rows = [_intel_seed(context, bag, relations, seed, section)
            for seed in range(1, context.options.seeds + 1)]
    beside = [GMAPPING, PUBLISHED, RBPF_SLAM]
    section.paragraphs += [
        table(INTEL_HEADER, lines_of([*rows, mean_row('mean', rows), *beside], INTEL_FORMS)),
        verdicts(INTEL_GOALS, INTEL_HEADER, rows),
        f'{PARTICLES} particles; errors of the relations of Kuemmerle et al. 2009. The lines of '
        'others were measured elsewhere, by the same rule, and published.']
    return section


def _office_seed(context, case, seed, section):
    name = f'grid_office_{seed}'
    bag = simulate(context, name, 'office', seed, SENSORS)
    folder, usage = run_ours(context, f'{name}_{case.detector}', bag, product=PRODUCT,
                             settings=(f'detector={case.detector}',))
    run, path = read_run(folder), simulation_file('worlds', 'office')
    world = read_world(path)
    result = evaluate(run, agreement=judge_map(run, world, path))
    if seed == 1:
        picture = context.out / f'grid_office_{case.detector}.png'
        section.pictures[f'map of the office, {case.name}, seed 1'] = picture
        plot_map(run, result, picture, world=world)
    m = result.metrics
    return [str(seed), m.get('ate_rmse_m'), m.get('nees_mean'),
            m.get('map_cells_on_walls_percent'), m.get('map_walls_found_percent'), usage.cpu_s,
            usage.max_rss_mb]


def measure_office(context):
    """The section of part office."""
    section = Section('Simulated office')
    for case in OFFICE_CASES:
        rows = [_office_seed(context, case, seed, section)
                for seed in range(1, context.options.drives + 1)]
        section.paragraphs += [
            f'{case.name.capitalize()}:',
            table(OFFICE_HEADER, lines_of([*rows, mean_row('mean', rows)], OFFICE_FORMS)),
            verdicts(case.goals, OFFICE_HEADER, rows)]
    section.paragraphs.append(
        'Cells on walls and walls found: within one cell, the map moved onto the truth by a rigid '
        'fit of its path. NEES: 3 expected, less is cautious. CPU time includes the detection of '
        'landmarks.')
    return section
