# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part landmarks: CPU time and memory against map size, beside MRPT's kf-slam."""
import dataclasses
from typing import Optional

from slam_eval import bench_mrpt_config as mrpt
from slam_eval.bench_plots import plot_cpu
from slam_eval.bench_programs import system_program
from slam_eval.bench_runs import PRODUCT, Result, call, kf_slam_on_rawlog, ours_on_rawlog
from slam_eval.bench_table import ABSENT, Section, number, table, verdict

GOALS = {300: 15.0, 1000: 30.0}  # times less CPU than kf-slam

HEADER = ['landmarks', 'seen', 'ours CPU [s]', 'kf-slam CPU [s]', 'ratio', 'goal',
          'ours error [mm]', 'kf-slam error [mm]', 'ours memory [MB]', 'kf-slam memory [MB]']


@dataclasses.dataclass
class Size:
    """Both results in a world of so many landmarks."""

    landmarks: int
    ours: Result
    theirs: Optional[Result]

    @property
    def ratio(self):
        """How many times less CPU ours takes, or None."""
        return None if self.theirs is None else self.theirs.usage.cpu_s / self.ours.usage.cpu_s


def row(size):
    """A line of the table."""
    ours, theirs = size.ours, size.theirs
    goal = GOALS.get(size.landmarks) if size.ratio is not None else None

    def of_theirs(pick, form):
        return number(None if theirs is None else pick(theirs), form)

    return [
        str(size.landmarks), number(ours.errors['matched'], 'd'),
        number(ours.usage.cpu_s, '.2f'), of_theirs(lambda r: r.usage.cpu_s, '.2f'),
        number(size.ratio, '.1f'), ABSENT if goal is None else verdict(size.ratio, goal, False),
        number(1e3 * ours.errors['mean_m'], '.2f'),
        of_theirs(lambda r: 1e3 * r.errors['mean_m'], '.2f'),
        number(ours.usage.max_rss_mb, '.1f'), of_theirs(lambda r: r.usage.max_rss_mb, '.1f')]


def simulate(context, world):
    """(rawlog, truth) of a world that simul-landmarks makes."""
    folder = context.folder(f'world_{world.landmarks}')
    (folder / 'world.ini').write_text(mrpt.simulation_ini(world, 'world.rawlog'), encoding='ascii')
    call(context, f'simulation of {world.landmarks} landmarks',
         [system_program('simul-landmarks'), 'world.ini'], folder / 'world.log', folder)
    return folder / 'world.rawlog', folder / 'world.rawlog_ground_truth.txt'


def measure_size(context, world):
    """Ours and kf-slam in turn on the same log."""
    rawlog, truth = simulate(context, world)
    name = f'{world.landmarks} landmarks'.replace(' ', '_')
    ours, _ = ours_on_rawlog(context, name, rawlog, truth)
    ini = mrpt.kf_slam_ini(world.last_step, world.range_sigma, world.bearing_sigma_deg)
    theirs = kf_slam_on_rawlog(context, name, rawlog, truth, ini, world.last_step)
    return Size(world.landmarks, ours, theirs)


def _remark(world, with_kf_slam):
    side = world.high - world.low
    text = (f'simul-landmarks: seed {world.seed}, {world.steps} steps, square path of '
            f'{world.path_side}, {side:g} m x {side:g} m, view {world.view_range:g} m and '
            f'{world.view_angle_deg:g} deg. CPU of the whole process, for ours with reading the bag '
            '(import not counted); error: mean over the landmarks, by one rule. ')
    if with_kf_slam:
        return text + (f'kf-slam\'s sensor sigmas are those simulated ({world.range_sigma:g} m, '
                       f'{world.bearing_sigma_deg:g} deg), as ours.')
    return text + 'kf-slam is not installed (Debian package mrpt-apps): its columns are left out.'


def measure(context):
    """The section of this part."""
    section = Section('Cost against the number of landmarks')
    if system_program('simul-landmarks') is None:
        section.paragraphs.append('Left out: simul-landmarks is not installed (Debian package '
                                  'mrpt-apps).')
        return section
    worlds = [mrpt.World(size) for size in context.sizes]
    sizes = [measure_size(context, world) for world in worlds]
    section.paragraphs += [table(HEADER, [row(size) for size in sizes]),
                           _remark(worlds[0], sizes[0].theirs is not None)]
    path = context.out / 'cpu_of_landmarks.png'
    plot_cpu(sizes, PRODUCT, path)
    section.pictures['CPU time against landmarks'] = path
    return section
