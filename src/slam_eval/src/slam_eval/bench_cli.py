# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program behind `./slam bench`: tables on stdout, progress on stderr, a page with pictures."""
import argparse
import contextlib
import datetime
import os
import pathlib
import shutil
import signal
import sys
import tempfile

from slam_eval import bench_consistency, bench_demo, bench_landmarks, bench_mrclam, bench_update
from slam_eval.bench_error import BenchError
from slam_eval.bench_progress import Progress
from slam_eval.bench_programs import data_folder
from slam_eval.bench_runs import Context
from slam_eval.cli import write_atomically
from slam_eval.errors import InputError

PARTS = {
    'demo': bench_demo.measure,
    'mrclam': bench_mrclam.measure,
    'consistency': bench_consistency.measure,
    'landmarks': bench_landmarks.measure,
    'update': bench_update.measure,
}


def _positive(text):
    value = int(text)
    if value < 1:
        raise ValueError(text)
    return value


def number_list(text):
    """Whole numbers above 0, separated by commas, rising; each once."""
    try:
        return tuple(sorted({_positive(part) for part in text.split(',')}))
    except ValueError:
        raise argparse.ArgumentTypeError(
            f'"{text}" is no list of whole numbers above 0, like 100,300') from None


def seed_count(text):
    """A whole number above 0."""
    try:
        return _positive(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f'"{text}" is no whole number above 0') from None


def part_list(text):
    """Names of parts, separated by commas, in the order in which they run."""
    names = text.split(',')
    for name in names:
        if name not in PARTS:
            raise argparse.ArgumentTypeError(
                f'there is no part "{name}"; the parts are {", ".join(PARTS)}')
    return [name for name in PARTS if name in names]


def _folder(text):
    path = pathlib.Path(text)
    if not path.is_dir():
        raise argparse.ArgumentTypeError(f'there is no folder {text}')
    return path.absolute()


def _default_out():
    """Beside the front door's other files where called from the clone, else in `bench`."""
    return pathlib.Path('.slam/bench' if pathlib.Path('.slam').is_dir() else 'bench')


def parse(arguments):
    """The options of the call."""
    parser = argparse.ArgumentParser(
        prog='slam_bench', description='Accuracy, consistency, time and memory of a back-end as '
        f'tables and pictures. Parts: {", ".join(PARTS)}. All of them take some ten minutes.')
    parser.add_argument('backend', nargs='?', choices=['ekf'], default='ekf',
                        help='what is measured (%(default)s)')
    parser.add_argument('--data', metavar='DIR', type=_folder,
                        help='MRCLAM data set (default: mrclam_dataset6 in $SLAM_DATA_DIR, else in '
                        'shared/data beside the repository)')
    parser.add_argument('--sizes', metavar='N,...', type=number_list, default=(100, 300, 1000),
                        help='numbers of landmarks of the part landmarks (100,300,1000)')
    parser.add_argument('--seeds', metavar='N', type=seed_count, default=50,
                        help='runs of the part consistency (%(default)s)')
    parser.add_argument('--only', metavar='PART,...', type=part_list, default=list(PARTS),
                        help='only these parts')
    parser.add_argument('--out', metavar='DIR', type=pathlib.Path, default=_default_out(),
                        help='folder for the page and the pictures (%(default)s)')
    parser.add_argument('--keep', metavar='DIR', type=pathlib.Path,
                        help='keep bags, runs and logs in this folder')
    return parser.parse_args(arguments)


def _processor():
    with contextlib.suppress(OSError):
        for line in pathlib.Path('/proc/cpuinfo').read_text(encoding='utf-8').splitlines():
            if line.startswith('model name'):
                return ' '.join(line.partition(':')[2].split())
    return os.uname().machine


def heading(backend):
    """Title of the page and where and when it was measured."""
    return (f'# Benchmark of the back-end {backend}\n\n{datetime.date.today()}, {_processor()}, '
            f'{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} at the start.\n')


@contextlib.contextmanager
def _work_folder(keep):
    """The folder for temporary files: removed at the end unless it was asked for."""
    if keep is not None:
        keep.mkdir(parents=True, exist_ok=True)
        yield keep.absolute()
        return
    path = pathlib.Path(tempfile.mkdtemp(prefix='slam_bench_'))
    try:
        yield path
    finally:
        shutil.rmtree(path, ignore_errors=True)


def run_parts(names, context, page, text):
    """Measure the parts, print each when it is done; returns the names of those that failed."""
    failed = []
    for name in names:
        try:
            section = PARTS[name](context)
        except (BenchError, InputError) as error:
            context.progress.end()
            print(f'slam_bench: part {name}: {error}', file=sys.stderr)
            failed.append(name)
            continue
        context.progress.end()
        print(f'\n{section.markdown()}', end='', flush=True)
        text += f'\n{section.markdown(context.out)}'
        write_atomically(page, text)
    return failed


def bench(options):
    """Run what was asked for; returns the exit code."""
    out = options.out.absolute()
    out.mkdir(parents=True, exist_ok=True)
    page, text = out / f'bench_{options.backend}.md', heading(options.backend)
    print(text, end='', flush=True)
    with _work_folder(options.keep) as work:
        context = Context(out, work, Progress(), options.data or data_folder('mrclam_dataset6'),
                          options.sizes, options.seeds)
        failed = run_parts(options.only, context, page, text)
    if len(failed) < len(options.only):
        print(f'\nTables and pictures: {page}')
    return 1 if failed else 0


def main(arguments=None):
    """Entry point: exit code 0 done, 1 a part failed, 2 wrong use."""
    options = parse(arguments)
    # A stop from outside ends the running program and removes the temporary files as well.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    try:
        return bench(options)
    except OSError as error:
        print(f'slam_bench: {error.filename or options.out}: cannot be written '
              f'({error.strerror}); check space and permissions', file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
