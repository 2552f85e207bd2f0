# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The folder of a campaign: where its bags, runs and results are, and that it belongs to one."""
import contextlib
import fcntl
import json
import os
import pathlib
import shutil

from slam_eval.io.atomic_file import write_atomically
from slam_eval.io.errors import UsageError

RESULT = "result.json"  # of a run or a drive: it is there as soon as that is complete
_ABOUT = "campaign.json"


class Folder:
    """The paths in a campaign's folder."""

    def __init__(self, path):
        self.path = pathlib.Path(path).absolute()

    def run(self, identity):
        """The folder of a complete run."""
        return self.path / "runs" / identity

    def result(self, identity):
        """What became of a run."""
        return self.run(identity) / RESULT

    def drive(self, identity):
        """The bag of a simulated drive."""
        return self.path / "bags" / f"{identity}.bag"

    def drive_result(self, identity):
        """What became of a drive: the bag's SHA-256, or why there is none."""
        return self.path / "bags" / f"{identity}.json"

    @property
    def plan(self):
        """What is to be run."""
        return self.path / "plan.json"

    @property
    def log(self):
        """What Snakemake said."""
        return self.path / "snakemake.log"

    @property
    def work(self):
        """Takes the folders of runs that are not complete."""
        return self.path / "unfinished"

    def tidy(self):
        """Removes what served unfinished runs, once there are none."""
        for path in self.work.iterdir():
            shutil.rmtree(path) if path.is_dir() else path.unlink()

    def take_for(self, name):
        """Makes the folder that of a campaign. Raises UsageError where it is something else's."""
        about = self.path / _ABOUT
        if about.exists():
            try:
                owner = json.loads(about.read_text(encoding="utf-8"))["campaign"]
            except (OSError, ValueError, KeyError, TypeError):
                raise UsageError(f"{about}: cannot be read as a campaign's; name another "
                                    "folder with --out") from None
            if owner != name:
                raise UsageError(f"the folder {self.path} holds the campaign '{owner}', not "
                                    f"'{name}'; name another one with --out")
            return
        if self.path.exists() and (not self.path.is_dir() or any(self.path.iterdir())):
            raise UsageError(f"{self.path} is there and holds no campaign; name a new folder "
                                "with --out")
        for folder in (self.path / "runs", self.path / "bags", self.work):
            folder.mkdir(parents=True, exist_ok=True)
        write_atomically(about, json.dumps({"campaign": name}) + "\n")


@contextlib.contextmanager
def locked(path, wait, refusal=""):
    """Holds a lock that ends with this process. Raises UsageError where another one has it and it
    is not to be waited for. On file systems without locks nothing is held."""
    path.parent.mkdir(parents=True, exist_ok=True)
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
        except BlockingIOError:
            raise UsageError(refusal) from None
        except OSError:
            pass
        yield
    finally:
        os.close(descriptor)
