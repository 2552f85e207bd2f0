# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program behind `./slam campaign FILE`."""
import argparse
import os
import pathlib
import shutil
import signal
import sys

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import package_folder
from slam_eval.campaign import page, results
from slam_eval.campaign.campaign_file import read_campaign
from slam_eval.campaign.executor import Executor
from slam_eval.campaign.folder import Folder, locked
from slam_eval.campaign.plan import read_result
from slam_eval.campaign.planner import Planner
from slam_eval.io.atomic_file import write_atomically
from slam_eval.io.errors import did_you_mean, exit_code_of, InputError, UsageError

_FILES = ("runs.csv", "table.csv", "tests.csv", "costs.csv", "report.html")


def _command():
    """What people call: `./slam` of a clone or the installed `slam`, which say so in the
    environment, else rosrun."""
    front_door = os.environ.get("SLAM_COMMAND")
    return f"{front_door} campaign" if front_door else "rosrun slam_eval slam_campaign"


def campaign_file(text):
    """The path of a file, or of a campaign that comes with slam_eval. Raises UsageError."""
    path = pathlib.Path(text)
    if path.exists() or "/" in text or path.suffix:
        return path
    shipped = {file.stem: file for file in
               sorted((package_folder("slam_eval") / "campaigns").glob("*.yaml"))}
    if text not in shipped:
        raise UsageError(f"there is no campaign '{text}'{did_you_mean(text, shipped)}; there are: "
                         f"{', '.join(shipped)}; or give a file")
    return shipped[text]


def _forget_failures(paths):
    """Removes the results that are failures, to be made again."""
    for path in paths:
        if path.exists() and read_result(path).get("failure"):
            shutil.rmtree(path.parent) if path.parent.parent.name == "runs" else path.unlink()


def _make(planner, folder, executor, retry):
    """Simulates the drives, then makes the runs; returns the plan of the runs."""
    plan = planner.drives_plan()
    drives = {name: folder.drive_result(name) for name in plan.drives}
    if retry:
        _forget_failures(drives.values())
    if drives:
        write_atomically(folder.plan, plan.text())
        executor.make("drives", drives)
    plan = planner.runs_plan()
    runs = {name: folder.result(name) for name in plan.runs}
    if retry:
        _forget_failures(runs.values())
    write_atomically(folder.plan, plan.text())
    executor.make("runs", runs)
    return plan


def write_results(campaign, folder, tables):
    """Tables and page into the campaign's folder."""
    texts = (results.runs_csv(tables.lines), tables.table_csv(), tables.tests_csv(),
             results.costs_csv(tables.lines), page.render(campaign, folder, tables))
    for name, text in zip(_FILES, texts):
        write_atomically(folder.path / name, text)


def _report(folder, tables):
    for metric in tables.metrics:
        print(f"\n{page.text_table(tables, metric)}")
    failed = {(line.product, line.bag, line.why) for line in tables.lines
              if line.outcome == results.FAILED}
    for product, bag, why in sorted(failed):
        print(f"\nfailed: {product} on {bag}: {why}")
    print(f"\n{page.summary(tables)}\nreport: {folder.path / 'report.html'}")
    if tables.count(results.MISSING):
        raise InputError(f"{tables.count(results.MISSING)} runs are missing, since they were ended "
                         f"from outside; call the campaign again ({folder.log} has Snakemake's "
                         "words)")


def run_campaign(options):
    """All of it. Raises InputError."""
    campaign = read_campaign(campaign_file(options.file))
    folder = Folder(options.out or pathlib.Path("campaigns") / campaign.path.stem)
    executor = Executor(folder, options.jobs, options.profile)
    try:
        planner = Planner(campaign, folder)
    except BenchError as error:
        raise UsageError(str(error)) from None
    folder.take_for(campaign.name)
    with locked(folder.path / "lock", wait=False, refusal=f"another call of {_command()} works "
                f"in {folder.path}; wait for its end, or name another folder with --out"):
        plan = _make(planner, folder, executor, options.retry)
        tables = results.Tables(campaign, results.read_lines(folder, plan.rows))
        write_results(campaign, folder, tables)
        if not tables.count(results.MISSING):
            folder.tidy()
    _report(folder, tables)


def _jobs(text):
    value = int(text)
    if value < 1:
        raise ValueError
    return value


def main(arguments=None):
    """Entry point: exit code 0 done (also where runs failed, which the page says), 1 the campaign
    could not be made, 2 wrong use."""
    parser = argparse.ArgumentParser(
        prog="slam_campaign",
        description="Runs products on bags with several seeds, as a file says, and puts the "
        "results on one page. Called again it goes on where it was.")
    parser.add_argument("file", metavar="FILE", help="the campaign's YAML, or the name of one that "
                        "comes with slam_eval")
    parser.add_argument("--out", metavar="DIR", type=pathlib.Path,
                        help="takes bags, runs and the page; default: campaigns/FILE")
    parser.add_argument("--jobs", metavar="N", type=_jobs,
                        help="at a time; default: a job for each core, or what the profile says")
    parser.add_argument("--profile", metavar="NAME",
                        help="of Snakemake, for a cluster: slurm, a folder with a config.yaml, or "
                        "one of ~/.config/snakemake")
    parser.add_argument("--retry", action="store_true", help="run again what failed")
    options = parser.parse_args(arguments)
    for request in (signal.SIGTERM, signal.SIGHUP):  # ends what was started as well, as Ctrl-C does
        signal.signal(request, lambda number, _: sys.exit(128 + number))
    try:
        return exit_code_of("slam_campaign", lambda: run_campaign(options), options.out or ".")
    except KeyboardInterrupt:
        return 130
