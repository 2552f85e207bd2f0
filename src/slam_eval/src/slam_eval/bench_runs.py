# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The programs a benchmark calls: importer, our product, MRPT's kf-slam and simulator."""
import dataclasses
import pathlib
import re

from slam_eval import bench_mrpt_config as mrpt
from slam_eval import bench_process
from slam_eval.bench_error import BenchError
from slam_eval.bench_programs import system_program, workspace_program
from slam_eval.landmark_comparison import compare, read_map

PRODUCT = 'ekf_wheel'


@dataclasses.dataclass
class Context:
    """What all parts share: folders for pictures and for temporary files, progress, options."""

    out: pathlib.Path
    work: pathlib.Path
    progress: object
    options: object

    def folder(self, name):
        """A folder for temporary files."""
        path = self.work / name
        path.mkdir(parents=True, exist_ok=True)
        return path


@dataclasses.dataclass(frozen=True)
class Result:
    """Cost of a run and the errors of its map: the figures of `compare`, and `aligned_mean_m`."""

    usage: bench_process.Usage
    errors: dict


def call(context, task, command, log, cwd=None, state=None):
    """Run a command as a task. state() tells how far it is, instead of the seconds."""
    context.progress.begin(task)
    return bench_process.run(command, log, cwd=cwd, watch=lambda seconds: context.progress.update(
        lambda: f'{seconds:.0f} s' + (f', {state()}' if state else '')))


def import_log(context, name, arguments):
    """Import a foreign log as NAME.bag; returns the bag."""
    bag = context.work / f'{name}.bag'
    command = [workspace_program('slam_eval', 'slam_import'), *arguments, bag]
    call(context, f'import of {name}', command, context.work / f'{name}_import.log')
    return bag


def simulate(context, name, world, seed, sensors, label=None):
    """Simulate a drive through a world with the sensors given as NAME.bag; returns the bag."""
    bag = context.work / f'{name}.bag'
    command = [workspace_program('slam_sim', 'slam_sim'), bag, '--world', world,
               '--seed', str(seed), '--only', sensors]
    call(context, f'{label or name}: simulation', command, context.work / f'{name}_simulation.log')
    return bag


def run_ours(context, name, bag, robot=None, product=PRODUCT, settings=(),
             label=None):
    """Run a product offline on a bag; returns (folder of the run, usage).

    robot: its name or file, instead of the one that the bag names.
    settings: section.key=value, instead of the files' values.
    """
    folder = context.work / f'{name}_run'
    command = [workspace_program('slam_ros', 'slam_offline'), product, '--bag', bag,
               '--out', folder]
    command += ['--robot', robot] if robot else []
    command += [word for setting in settings for word in ('--set', setting)]
    usage = call(context, f'{label or name}: {product}', command,
                 context.work / f'{name}_run.log')
    return folder, usage


def landmark_result(usage, path, truth, rawlog=None):
    """The result of a run by its map: the same rule for our maps and kf-slam's."""
    estimate, true = read_map(path, rawlog), read_map(truth)
    aligned = compare(estimate, true, align=True)['mean_m']
    return Result(usage, {**compare(estimate, true), 'aligned_mean_m': aligned})


def ours_on_rawlog(context, name, rawlog, truth):
    """Our result on a rawlog of MRPT's demonstrations."""
    bag = import_log(context, name, ['rawlog', rawlog])
    folder, usage = run_ours(context, name, bag, 'mrpt_demo')
    return landmark_result(usage, folder / 'landmarks.yaml', truth), folder


def _last_step(log):
    """The step kf-slam has come to, from the end of its output."""
    with open(log, 'rb') as stream:
        stream.seek(max(0, log.stat().st_size - 2000))
        steps = re.findall(rb'Step (\d+)', stream.read())
    return int(steps[-1]) if steps else 0


def kf_slam_on_rawlog(context, name, rawlog, truth, ini, last_step):
    """kf-slam's result on a rawlog, or None where it is not installed."""
    program = system_program('kf-slam')
    if program is None:
        return None
    folder = context.folder(f'{name}_kf_slam')
    (folder / 'kf-slam.ini').write_text(ini, encoding='ascii')
    log, scene = folder / 'kf-slam.log', folder / 'map' / mrpt.scene_name(last_step)
    scene.unlink(missing_ok=True)  # of an earlier call with the same --keep
    usage = call(context, f'kf-slam on {name}', [program, 'kf-slam.ini', rawlog], log, folder,
                 lambda: f'step {_last_step(log)} of {last_step}')
    if not scene.exists():
        raise BenchError(f'kf-slam wrote no {scene.name} for {rawlog}; its output is {log} '
                         '(call again with --keep DIR)')
    return landmark_result(usage, scene, truth, rawlog)
