# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Foreign systems by their names or files."""
import dataclasses
import importlib
import importlib.util
import pathlib
import sys

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import package_folder
from slam_eval.io.errors import did_you_mean, UsageError
from slam_eval.io.strict_yaml import load, Reader

_KEYS = ("version", "system", "title", "driver", "parameters")
_VERSION = 1


@dataclasses.dataclass(frozen=True)
class System:
    """A foreign system: its file, its driver's class and the file of that, its parameters."""

    path: pathlib.Path
    title: str
    driver: type
    driver_path: pathlib.Path
    parameters: dict

    def require_settings(self, settings, where):
        """Refuses KEY=VALUE of which the system has no KEY, and programs that are missing."""
        for key, _ in (setting.split("=", 1) for setting in settings):
            if key not in self.parameters:
                raise UsageError(f"{where}: {self.path.stem} has no parameter '{key}'"
                                 f"{did_you_mean(key, self.parameters)}; it has: "
                                 f"{', '.join(self.parameters) or 'none'}")
        try:
            self.make({}).programs()
        except BenchError as error:
            raise UsageError(f"{where}: {self.path.stem} cannot be run: {error}") from None

    def files(self):
        """The files that a result depends on."""
        return [self.path, self.driver_path, *self.make({}).programs()]

    def make(self, values):
        """The driver, with other values for some parameters. folder: where relative files are."""
        return self.driver({**self.parameters, **values, "folder": str(self.path.parent)})

    def run(self, job):
        """Runs the system on a bag. Raises BenchError."""
        values = dict(setting.split("=", 1) for setting in job.settings)
        return self.make(values).run(job)


def shipped():
    """The files of the systems that come with slam_eval, by name."""
    folder = package_folder("slam_eval") / "foreign"
    return {path.stem: path for path in sorted(folder.glob("*.yaml"))}


def _module(reader, text, folder):
    """The module of a name, or of a FILE.py beside the system's own."""
    if not text.endswith(".py"):
        try:
            return importlib.import_module(text)
        except ImportError as error:
            raise reader.error(f"the driver's module {text} cannot be imported ({error})") from None
    path = folder / text
    if not path.is_file():
        raise reader.error(f"there is no {path}, which the driver is to be in")
    spec = importlib.util.spec_from_file_location(f"slam_foreign_{path.stem}", path)
    module = sys.modules[spec.name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _driver(reader, folder):
    """(class, file) of MODULE:CLASS or FILE.py:CLASS."""
    text, colon, name = reader.text("driver", "").partition(":")
    if not colon:
        raise reader.error(f"driver is '{text}', where MODULE:CLASS or FILE.py:CLASS belongs")
    module = _module(reader, text, folder)
    if not hasattr(module, name):
        raise reader.error(f"{module.__file__} has no class '{name}'")
    return getattr(module, name), pathlib.Path(module.__file__)


def find_system(text, where):
    """The foreign system of a name or file. Raises UsageError, which says where it was named."""
    known = shipped()
    path = pathlib.Path(text) if "/" in text or text.endswith(".yaml") else known.get(text)
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
