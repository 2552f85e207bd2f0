# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are killed at random moments and resumed: their files must be those of a run that was
never stopped, byte by byte."""
import dataclasses
import json
import random
import re
import shutil
import subprocess
import time

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.hall_drives import Drives, product_command, sensor_of
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import Section, table

AUTOSAVE = 1.0  # [s] of stamps
PATIENCE = 600.0  # [s]: a run that takes longer hangs
POLL = 0.0005  # [s], much less than a checkpoint takes to be written
OF_TIME = {"wall_s", "cpu_s", "realtime_factor", "max_rss_mb"}  # of metrics.json, or they hold _ms
TOLD = re.compile(r"goes on after (\d+) messages, at [\d.]+ s")
HEADER = ["product", "kills", "in a step", "as it saves", "as it ends", "resumed", "anew", "runs",
          "same bytes", "most kills of one", "verdict"]


@dataclasses.dataclass
class Tally:
    """What was done to the runs of a product, and what came of them."""

    kills: dict = dataclasses.field(default_factory=lambda: dict.fromkeys(MOMENTS, 0))
    resumed: int = 0
    anew: int = 0  # killed before the first checkpoint
    same: int = 0  # runs that were killed and have the files of a whole one
    most: int = 0  # kills of one run
    faults: list = dataclasses.field(default_factory=list)

    def killed(self):
        """How often a run was killed."""
        return sum(self.kills.values())


def any_moment(folder, rng, took):
    """Waits for a random moment of a run."""
    del folder
    limit = time.monotonic() + rng.uniform(0.0, took)
    return lambda: time.monotonic() >= limit


def while_it_saves(folder, rng, took):
    """Waits until one of the run's checkpoints is being written."""
    start = time.monotonic() + rng.uniform(0.0, took)
    parts = folder / "unfinished_run"
    return lambda: time.monotonic() >= start and any(parts.glob("checkpoint.part*"))


def as_it_ends(folder, rng, took):
    """Waits until the run's files come into their folder, and then up to 10 ms."""
    del took
    delay = rng.uniform(0.0, 0.01)

    def is_now():
        if not any(folder.glob("*.tum")):
            return False
        time.sleep(delay)
        return True

    return is_now


MOMENTS = {any_moment: 0.6, while_it_saves: 0.3, as_it_ends: 0.1}  # and how often


def metrics_of(folder):
    """The figures of a run without those of time, and without how it was called."""
    figures = json.loads((folder / "metrics.json").read_text(encoding="utf-8"))
    return {key: value for key, value in figures.items()
            if key not in OF_TIME and key != "run" and "_ms" not in key}


def difference(run, whole):
    """What differs first between the files of two runs; empty where they are the same."""
    names = [sorted(path.name for path in folder.iterdir() if path.is_file())
             for folder in (run, whole)]
    if names[0] != names[1]:
        return f"it has {', '.join(names[0])} instead of {', '.join(names[1])}"
    for name in names[1]:
        if name != "metrics.json" and (run / name).read_bytes() != (whole / name).read_bytes():
            return f"{name} differs"
    ours, theirs = metrics_of(run), metrics_of(whole)
    differing = sorted(key for key in ours.keys() | theirs.keys()
                       if ours.get(key) != theirs.get(key))
    return f"metrics.json differs: {', '.join(differing)}" if differing else ""


def is_complete(folder):
    """Whether all files of a run are in their places, of which this one comes last."""
    return (folder / "config.yaml").is_file() and not has_checkpoint(folder)


def has_checkpoint(folder):
    """Whether a run was cut off and can be resumed."""
    return (folder / "unfinished_run" / "checkpoint").is_file()


class KilledRuns:
    """Runs of a product on a bag that are killed, resumed and compared."""

    def __init__(self, context, product, bag):
        self._context, self._product = context, product
        self._rng = random.Random(f"{context.options.seed} {product}")
        self._command = product_command(product, bag, context.options.seed)
        self._whole = context.work / f"kills_{product}_whole"
        self._run = context.work / f"kills_{product}"
        self.tally = Tally()
        usage = call(context, product, [*self._command, "--out", self._whole],
                     context.work / f"kills_{product}.log")
        self._took = usage.wall_s

    def _start(self):
        """A run from its checkpoint, or anew where it has none."""
        is_resumed = has_checkpoint(self._run)
        self.tally.resumed += is_resumed
        options = ("--resume", self._run) if is_resumed else ("--out", self._run)
        process = subprocess.Popen(
            [str(word) for word in (*self._command, *options, "--autosave", AUTOSAVE)],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return process, is_resumed

    def _end(self, process, is_resumed, is_killed):
        """Waits for a run's end; notes what it should not have said. Returns whether it is through."""
        said, _ = process.communicate()
        if process.returncode == 0:
            if is_resumed and not TOLD.search(said):
                self.tally.faults.append("a resumed run does not tell from where it goes on")
            return True
        if not is_killed or process.returncode != -9:
            lines = said.strip().splitlines() or ["nothing"]
            raise BenchError(f"{self._product} ended with {process.returncode}: {lines[-1]}")
        return False

    def _kill_once(self):
        """Runs until a moment and kills. Returns whether the run was killed before it ended."""
        moment = self._rng.choices(list(MOMENTS), list(MOMENTS.values()))[0]
        process, is_resumed = self._start()
        try:
            is_now = moment(self._run, self._rng, self._took)
            limit = time.monotonic() + PATIENCE
            while process.poll() is None and not is_now():
                if time.monotonic() > limit:
                    raise BenchError(f"{self._product} hangs")
                time.sleep(POLL)
        finally:
            process.kill()
        if self._end(process, is_resumed, True):
            return False
        self.tally.kills[moment] += 1
        self.tally.anew += not has_checkpoint(self._run) and not is_complete(self._run)
        return True

    def _compare(self, kills):
        """Compares a run that is through, if it was killed on its way, and removes it."""
        if kills:
            fault = difference(self._run, self._whole)
            self.tally.same += not fault
            self.tally.faults += [fault] if fault else []
            self.tally.most = max(self.tally.most, kills)
        shutil.rmtree(self._run)

    def kill(self, times):
        """Kills so often; the last run then goes on to its end."""
        kills = 0
        while self.tally.killed() < times:
            self._context.progress.update(lambda: f"{self.tally.killed()} of {times} kills")
            kills += self._kill_once()
            if is_complete(self._run):
                self._compare(kills)
                kills = 0
        if kills:
            process, is_resumed = self._start()
            self._end(process, is_resumed, False)
            self._compare(kills)


def row_of(product, tally):
    """A product's line of the table, and whether all of its runs have the same bytes."""
    runs = tally.same + len(tally.faults)
    is_reached = not tally.faults
    return [product, str(tally.killed()), *(str(count) for count in tally.kills.values()),
            str(tally.resumed), str(tally.anew), str(runs), str(tally.same), str(tally.most),
            "reached" if is_reached else "MISSED"], is_reached


def measure(context):
    """The section of this benchmark."""
    options = context.options
    section = Section("Runs that are killed and resumed")
    drives, lines = Drives(context), []
    for i, product in enumerate(options.products):
        times = options.kills * (i + 1) // len(options.products) \
            - options.kills * i // len(options.products)
        try:
            bag = options.bag or drives.bag(options.seed, sensor_of(product))
            runs = KilledRuns(context, product, bag)
            runs.kill(times)
        except BenchError as error:
            section.failures.append(f"{product}: {error}")
            continue
        line, _ = row_of(product, runs.tally)
        lines.append(line)
        section.failures += [f"{product}: {fault}" for fault in runs.tally.faults]
    section.paragraphs += [
        table(HEADER, lines),
        f"`kill -9`, a checkpoint each {AUTOSAVE:g} s of stamps; moments from seed {options.seed}: "
        "any moment of a run, one at which a checkpoint is being written, and the one at which the "
        "files take their places. A run may be killed several times before it is through. All of "
        "its files are compared with those of a run that was never stopped, in `metrics.json` all "
        "but times and memory."]
    return section
