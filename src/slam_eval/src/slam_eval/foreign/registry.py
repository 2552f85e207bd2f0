# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Foreign systems by their names or files."""
import dataclasses
import importlib
import importlib.util
import pathlib
import sys
import traceback

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import package_folder
from slam_eval.foreign.driver import Driver
from slam_eval.io.errors import did_you_mean, InputError, UsageError
from slam_eval.io.strict_yaml import is_path, load, Reader

_KEYS = ("version", "system", "title", "driver", "parameters")
_VERSION = 1
TRACEBACK = "driver.txt"  # in the run's folder


def _said(error):
    """An exception of somebody's driver in one line: its type and text."""
    return " ".join(f"{type(error).__name__}: {error}".split())


@dataclasses.dataclass(frozen=True)
class System:
    """A foreign system: its file, its driver's class and the file of that, its parameters."""

    path: pathlib.Path
    title: str
    driver: type
    driver_path: pathlib.Path
    parameters: dict

    def require_settings(self, settings, where):
        """Refuses KEY=VALUE of which the system has no KEY, values that it cannot use, and programs
        that are missing."""
        for key, _ in (setting.split("=", 1) for setting in settings):
            if key not in self.parameters:
                raise UsageError(f"{where}: {self.path.stem} has no parameter '{key}'"
                                 f"{did_you_mean(key, self.parameters)}; it has: "
                                 f"{', '.join(self.parameters) or 'none'}")
        try:
            driver = self.make(settings)
            driver.check()
            _ = [pathlib.Path(path) for path in driver.programs()]
        except (BenchError, InputError) as error:
            raise UsageError(f"{where}: {self.path.stem} cannot be run: {error}") from None
        except Exception as error:  # whatever somebody's driver stumbles over
            raise UsageError(f"{where}: {self.path.stem} cannot be run: its driver "
                             f"{self.driver_path} fails ({_said(error)})") from None

    def files(self, settings):
        """The files that a result depends on."""
        return [self.path, self.driver_path, *self.make(settings).programs()]

    def make(self, settings):
        """The driver, with KEY=VALUE for some parameters. folder: where relative files are."""
        values = dict(setting.split("=", 1) for setting in settings)
        return self.driver({**self.parameters, **values, "folder": str(self.path.parent)})

    def run(self, job):
        """Runs the system on a bag. Raises BenchError, also for what somebody's driver stumbles
        over, of which the run's folder holds the traceback."""
        try:
            return self.make(job.settings).run(job)
        except (BenchError, InputError):
            raise
        except Exception as error:
            (job.folder / TRACEBACK).write_text(traceback.format_exc(), encoding="utf-8")
            raise BenchError(f"the driver of {self.path.stem} failed ({_said(error)}); the run's "
                             f"{TRACEBACK} says where") from None


def shipped():
    """The files of the systems that come with slam_eval, by name."""
    folder = package_folder("slam_eval") / "foreign"
    return {path.stem: path for path in sorted(folder.glob("*.yaml"))}


def _loaded(path):
    """The module of a file."""
    spec = importlib.util.spec_from_file_location(f"slam_foreign_{path.stem}", path)
    module = sys.modules[spec.name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _module(reader, text, folder):
    """The module of a name, or of a FILE.py beside the system's own."""
    path = folder / text
    if text.endswith(".py") and not path.is_file():
        raise reader.error(f"there is no {path}, which the driver is to be in")
    try:
        return _loaded(path) if text.endswith(".py") else importlib.import_module(text)
    except Exception as error:  # whatever somebody's file raises
        raise reader.error(f"the driver's module {text} cannot be imported "
                           f"({_said(error)})") from None


def _driver(reader, folder):
    """(class, file) of MODULE:CLASS or FILE.py:CLASS."""
    text, colon, name = reader.text("driver", "").partition(":")
    if not colon:
        raise reader.error(f"driver is '{text}', where MODULE:CLASS or FILE.py:CLASS belongs")
    module = _module(reader, text, folder)
    found = getattr(module, name, None)
    if not isinstance(found, type) or not issubclass(found, Driver):
        raise reader.error(f"{text} has no class '{name}' that is a Driver")
    return found, pathlib.Path(module.__file__)


def find_system(text, where):
    """The foreign system of a name or file. Raises UsageError, which says where it was named."""
    known = shipped()
    path = pathlib.Path(text) if is_path(text) else known.get(text)
    if path is None:
        near = did_you_mean(text, known)
        raise UsageError(f"{where}: there is no foreign system '{text}'{near}; there are: "
                         f"{', '.join(known)}; a file's name holds a / or ends with .yaml")
    reader = Reader(path, load(path), _KEYS)
    if reader.raw("version") != _VERSION:
        raise reader.error(f"the version is {reader.raw('version', 'not given')}, this program "
                           f"reads 'version: {_VERSION}'")
    driver, driver_path = _driver(reader, path.parent)
    parameters = {str(key): value for key, value in reader.map("parameters").items()}
    return System(path, reader.text("title", path.stem), driver, driver_path, parameters)
