# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program behind `./slam bench`: tables on stdout, progress on stderr, a page with pictures."""
import contextlib
import dataclasses
import datetime
import os
import pathlib
import shutil
import signal
import sys
import tempfile

from slam_eval.bench import (carried, command_line, days, fiducial, imu, kills, office, online, pointmap,
                             threads, vo)
from slam_eval.bench.adverse import drives as adverse_drives
from slam_eval.bench.association import circles as association_circles
from slam_eval.bench.association import forest as association_forest
from slam_eval.bench.association import mrclam as association_mrclam
from slam_eval.bench.association import office as association_office
from slam_eval.bench.association import time as association_time
from slam_eval.bench.calibration import drives as calibration_drives
from slam_eval.bench.ekf import commands, consistency, demo, growth, landmarks
from slam_eval.bench.ekf import mrclam as ekf_mrclam
from slam_eval.bench.ekf import update as ekf_update
from slam_eval.bench.graph import false_loops as graph_false_loops
from slam_eval.bench.graph import files as graph_files
from slam_eval.bench.graph import worlds as graph_worlds
from slam_eval.bench.grid import intel, scan, sena
from slam_eval.bench.grid import office as grid_office
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.progress import Progress
from slam_eval.bench.harness.runs import Context
from slam_eval.bench.harness.table import Section
from slam_eval.bench.laser import logs as laser_logs
from slam_eval.bench.laser import odometry as laser_odometry
from slam_eval.bench.lost import drives as lost_drives
from slam_eval.bench.pf import circles
from slam_eval.bench.pf import mrclam as pf_mrclam
from slam_eval.bench.pf import office as pf_office
from slam_eval.bench.pf import update as pf_update
from slam_eval.bench.relocalisation import forest, grids, markers
from slam_eval.io.atomic_file import write_atomically
from slam_eval.io.errors import InputError


@dataclasses.dataclass(frozen=True)
class Benchmark:
    """A benchmark: what it is, its parts by name, and what adds its options to a parser."""

    title: str
    summary: str
    parts: dict
    add_options: object


BENCHMARKS = {
    "ekf": Benchmark(
        "the back-end ekf", "the EKF on logs and simulations, beside MRPT's and the back-end seif; a "
        "quarter of an hour",
        {"demo": demo.measure, "mrclam": ekf_mrclam.measure,
         "consistency": consistency.measure, "commands": commands.measure,
         "landmarks": landmarks.measure, "update": ekf_update.measure,
         "growth": growth.measure}, command_line.add_ekf),
    "pf": Benchmark(
        "the back-end pf", "the particle filter beside the EKF, and what its updates cost",
        {"mrclam": pf_mrclam.measure, "office": pf_office.measure,
         "circles": circles.measure, "update": pf_update.measure,
         "threads": threads.measure}, command_line.add_pf),
    "association": Benchmark(
        "association without ids",
        "which landmark is which by place alone, judged by ids that are withheld, and in parks; "
        "half an hour",
        {"mrclam": association_mrclam.measure, "circles": association_circles.measure,
         "office": association_office.measure, "forest": association_forest.measure,
         "time": association_time.measure},
        command_line.add_association),
    "grid": Benchmark(
        "grid maps", "the particle filter with grid maps on real logs and simulations, beside "
        "MRPT's",
        {"intel": intel.measure, "sena": sena.measure,
         "office": grid_office.measure, "scan": scan.measure,
         "threads": threads.measure_grid}, command_line.add_grid),
    "laser": Benchmark(
        "products that map with a laser",
        "all products that make a grid of a laser's scans on logs, beside MRPT's rbpf-slam; time "
        "and drift of laser odometry",
        {"logs": laser_logs.measure, "odometry": laser_odometry.measure},
        command_line.add_laser),
    "lost": Benchmark(
        "whether a robot is lost", "false alarms, and what is told of wrong maps and of robots that "
        "were carried away, over drives through random buildings",
        {"drives": lost_drives.measure}, command_line.add_lost),
    "adverse": Benchmark(
        "adverse drives", "how long products are confidently wrong where something is wrong that "
        "they do not know: wheels, ranges, ids, a laser, a robot that is carried; a few minutes",
        adverse_drives.PARTS, command_line.add_adverse),
    "days": Benchmark(
        "runs of days", "whether the memory of products grows over days of stamps, beyond their "
        "map; a few minutes", {"memory": days.measure}, command_line.add_days),
    "kills": Benchmark(
        "runs that are killed", "whether runs that are killed at random moments and resumed leave "
        "the same bytes as runs that were never stopped; a few minutes",
        {"resumed": kills.measure}, command_line.add_kills),
    "calibration": Benchmark(
        "self-calibration", "what EKF and graph find out of wheels and sensor that the robot file has "
        "wrong, whether it knows how well, and what its pose is worth then; a few minutes",
        calibration_drives.PARTS, command_line.add_calibration),
    "relocalisation": Benchmark(
        "relocalisation", "robots that are switched on anywhere in their map: how many are found, "
        "how soon, and how many believe a wrong place; an hour",
        {"office": markers.measure_office, "corridor": markers.measure_corridor,
         "repeated": markers.measure_repeated, "forest": forest.measure, "grid": grids.measure},
        command_line.add_relocalisation),
    "graph": Benchmark(
        "graphs of poses",
        "graphs of poses solved at every pose, beside Ceres, which solves them at once: time, "
        "chi2, errors; and with false loops",
        {"worlds": graph_worlds.measure, "files": graph_files.measure,
         "false_loops": graph_false_loops.measure},
        command_line.add_graph),
    "pointmap": Benchmark(
        "the point map", "what a scan into a point map costs, and how thick its walls are",
        {"scan": pointmap.measure_scan, "office": pointmap.measure_office},
        command_line.add_pointmap),
    "office": Benchmark(
        "a product in the simulated office", "a product in the simulated office, many seeds",
        {"office": office.measure}, command_line.add_office),
    "carried": Benchmark(
        "robots that are carried on", "a product in a simulated world in which the robot is "
        "carried on: when it is reported lost, and whether it is ever wrong and sure of itself",
        {"carried": carried.measure}, command_line.add_carried),
    "fiducial": Benchmark(
        "the fiducial detectors", "time of the detectors, and what they see from where",
        {"fiducial": fiducial.measure}, command_line.add_fiducial),
    "vo": Benchmark(
        "visual odometry", "drift and time of visual odometry in the simulated office",
        {"time": vo.measure_time, "drive": vo.measure_drives,
         "still": vo.measure_still}, command_line.add_vo),
    "imu": Benchmark(
        "wheels with an IMU", "drift of the heading beside that of the wheels alone, in simulated "
        "worlds; a minute", {"heading": imu.measure}, command_line.add_imu),
    "online": Benchmark(
        "a product online", "latency, losses and CPU of a product as nodes, in real time",
        {"online": online.measure}, command_line.add_online),
}


def _processor():
    with contextlib.suppress(OSError):
        for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return " ".join(line.partition(":")[2].split())
    return os.uname().machine


def heading(title):
    """Title of the page and where and when it was measured."""
    return (f"# Benchmark of {title}\n\n{datetime.date.today()}, {_processor()}, "
            f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} at the start.\n")


@contextlib.contextmanager
def _work_folder(keep):
    """The folder for temporary files: removed at the end unless it was asked for."""
    if keep is not None:
        keep.mkdir(parents=True, exist_ok=True)
        yield keep.absolute()
        return
    path = pathlib.Path(tempfile.mkdtemp(prefix="slam_bench_"))
    try:
        yield path
    finally:
        shutil.rmtree(path, ignore_errors=True)


def sections_of(made):
    """A part's only section, or its sections as they come."""
    return [made] if isinstance(made, Section) else made


def run_parts(parts, names, context, page, text):
    """Measure the named parts, print each section when it is done; returns the names of the parts
    that failed, or in which something did."""
    failed = []
    for name in names:
        try:
            for section in sections_of(parts[name](context)):
                context.progress.end()
                print(f"\n{section.markdown()}", end="", flush=True)
                text += f"\n{section.markdown(context.out)}"
                write_atomically(page, text)
                failed += [name] if section.failures else []
        except (BenchError, InputError) as error:
            context.progress.end()
            print(f"slam_bench: part {name}: {error}", file=sys.stderr)
            failed.append(name)
    return failed


def bench(options):
    """Run what was asked for; returns the exit code."""
    out = options.out.absolute()
    out.mkdir(parents=True, exist_ok=True)
    benchmark = BENCHMARKS[options.benchmark]
    page, text = out / f"bench_{options.benchmark}.md", heading(benchmark.title)
    print(text, end="", flush=True)
    write_atomically(page, text)
    with _work_folder(options.keep) as work:
        context = Context(out, work, Progress(), options)
        failed = run_parts(benchmark.parts, options.only, context, page, text)
    print(f"\nTables and pictures: {page}")
    return 1 if failed else 0


def main(arguments=None):
    """Entry point: exit code 0 done, 1 a part failed, 2 wrong use."""
    options = command_line.parse(sys.argv[1:] if arguments is None else arguments, BENCHMARKS)
    # A stop from outside ends the running program and removes the temporary files as well.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    try:
        return bench(options)
    except OSError as error:
        print(f"slam_bench: {error.filename or options.out}: cannot be written "
              f"({error.strerror}); check space and permissions", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
