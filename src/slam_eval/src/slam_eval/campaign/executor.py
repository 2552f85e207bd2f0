# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Has Snakemake make what a campaign lacks, on this host or on a cluster, and reports how far it
is."""
import collections
import json
import os
import pathlib
import shutil
import signal
import subprocess
import time

from slam_eval.bench.harness.programs import package_folder
from slam_eval.bench.harness.progress import Progress
from slam_eval.campaign.inputs import program
from slam_eval.campaign.plan import read_result
from slam_eval.io.atomic_file import write_atomically
from slam_eval.io.errors import InputError, UsageError

_POLL = 0.2       # [s]
_PATIENCE = 60.0  # [s] for Snakemake, whose programs end what they have started
_RETRIES = 1  # of a job that was killed
_SAID = 400  # characters of Snakemake's last words


def snakemake():
    """The program. Raises UsageError."""
    path = shutil.which("snakemake")
    if path is None:
        raise UsageError("campaigns are run by Snakemake, which is not there: install Debian's "
                         "package snakemake ('sudo apt install --no-install-recommends snakemake')")
    return path


def profile_folder(name):
    """A shipped profile by its name, else what Snakemake knows or a folder. Raises UsageError."""
    shipped = package_folder("slam_eval") / "profiles"
    if (shipped / name / "config.yaml").is_file():
        return str(shipped / name)
    own = pathlib.Path(os.environ.get("XDG_CONFIG_HOME") or pathlib.Path.home() / ".config")
    for path in (pathlib.Path(name), own / "snakemake" / name):
        if (path / "config.yaml").is_file():
            return str(path.absolute())
    names = ", ".join(sorted(path.parent.name for path in shipped.glob("*/config.yaml")))
    raise UsageError(f"there is no profile '{name}': neither a folder with a config.yaml nor one "
                     f"of {names}")


class Executor:
    """Calls Snakemake in a campaign's folder."""

    def __init__(self, folder, jobs, profile):
        self._folder, self._jobs, self._profile = folder, jobs, profile
        self._program = snakemake()
        self._profile_folder = profile_folder(profile) if profile else None

    def _command(self):
        where = ["--profile", self._profile_folder] if self._profile_folder else []
        if not where or self._jobs is not None:
            jobs = self._jobs or os.cpu_count() or 1
            where += ["--jobs", str(jobs)] if where else ["--cores", str(jobs)]
        snakefile = package_folder("slam_eval") / "campaign" / "Snakefile"
        # Snakemake ends when the campaign is killed: two at a time would take their runs from one
        # another.
        return ["setpriv", "--pdeathsig", "KILL", self._program, "--snakefile", str(snakefile),
                "--directory", str(self._folder.path), *where,
                # The campaign's own lock and its complete results count, not Snakemake's notes of
                # them, which a kill leaves behind.
                "--nolock", "--ignore-incomplete", "--rerun-triggers", "mtime", "--keep-going",
                "--retries", str(_RETRIES), "--scheduler", "greedy", "--nocolor",
                "--config", f"folder={self._folder.path}",
                f"task={program('slam_eval', 'slam_campaign_task')}"]

    def make(self, what, results):
        """Makes the results (a path by name) that are not there yet; what: drives or runs.

        What Snakemake could not make is not there afterwards. Raises InputError where it failed for
        a reason of its own.
        """
        missing = {name: path for name, path in results.items() if not path.exists()}
        print(f"{what}: {len(results)}, of which {len(results) - len(missing)} are there",
              flush=True)
        if not missing:
            return
        write_atomically(self._folder.path / "targets.json", json.dumps(
            [str(path.relative_to(self._folder.path)) for path in missing.values()]) + "\n")
        watch = Watch(what, results, missing)
        with open(self._folder.log, "ab") as log:
            started = log.tell()
            process = subprocess.Popen(self._command(), stdin=subprocess.DEVNULL, stdout=log,
                                       stderr=subprocess.STDOUT, start_new_session=True)
            try:
                while process.poll() is None:
                    watch.look()
                    time.sleep(_POLL)
            finally:
                _end(process)
                watch.close()
        if process.returncode != 0 and not watch.has_seen_some:
            raise InputError(f"Snakemake could make none of the {what}; it said: "
                             f"{_last_words(self._folder.log, started)} (all of it is in "
                             f"{self._folder.log})")


def _end(process):
    """Ends Snakemake and all that it started, where it is still there."""
    if process.poll() is None:
        os.killpg(process.pid, signal.SIGINT)
        try:
            process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()


def _last_words(log, start):
    with open(log, "rb") as stream:
        stream.seek(start)
        words = stream.read().decode("utf-8", "replace").split()
    return " ".join(words)[-_SAID:] or "nothing"


class Watch:
    """Looks which results have come, and reports them."""

    def __init__(self, what, results, missing):
        self._what, self._all, self._missing = what, len(results), dict(missing)
        self._done = collections.Counter()
        self._progress = Progress()
        self._progress.begin(f"{what}: {len(missing)} to be made")
        self._start = time.monotonic()

    @property
    def has_seen_some(self):
        return bool(self._done)

    def look(self):
        """Takes note of what has come since the last call."""
        for name, path in list(self._missing.items()):
            if not path.exists():
                continue
            del self._missing[name]
            failure = read_result(path).get("failure")
            self._done["failed" if failure else "made"] += 1
        self._progress.update(self._state)

    def _state(self):
        made = sum(self._done.values())
        rate = made / max(time.monotonic() - self._start, 1e-3)
        rest = f", about {len(self._missing) / rate / 60:.1f} min to go" if made else ""
        failed = f", {self._done['failed']} failed" if self._done["failed"] else ""
        return f"{self._all - len(self._missing)} of {self._all}{failed}{rest}"

    def close(self):
        """The last look."""
        self.look()
        self._progress.end()
        print(f"{self._what}: {self._all - len(self._missing)} of {self._all} are there",
              flush=True)
