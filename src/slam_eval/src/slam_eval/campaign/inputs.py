# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What runs depend on, found and reduced to hashes: programs, products, robots, worlds, bags."""
import functools
import hashlib
import json
import os
import pathlib
import re
import subprocess

import yaml

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import package_folder, SYSTEM, workspace_program
from slam_eval.io.errors import did_you_mean, read_text, UsageError
from slam_eval.io.strict_yaml import is_path

LIBRARY = re.compile(r"lib(?:slam_|mrpt)\S+ => (\S+)")  # ours, MRPT's
DIGITS = 16  # of a run's name
JUDGES = ("geometry", "io", "metrics")  # the folders of slam_eval that figures come from


def hash_of(values):
    """A name for values that JSON can hold."""
    text = json.dumps(values, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:DIGITS]


@functools.lru_cache(maxsize=None)
def hash_of_file(path):
    """The SHA-256 of a file. Raises UsageError."""
    try:
        with open(path, "rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise UsageError(f"{path}: cannot be read ({error.strerror}); check the path") from None


def hash_of_files(paths):
    """One hash of what files hold, by their names."""
    return hash_of([[pathlib.Path(path).name, hash_of_file(path)] for path in paths])


@functools.lru_cache(maxsize=None)
def libraries_of(program):
    """The libraries of ours, and MRPT's, that a program is linked with; none of other files."""
    told = subprocess.run(["ldd", str(program)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True, check=False).stdout
    return tuple(sorted(set(LIBRARY.findall(told))))


def program(package, name):
    """The path of a program of ours. Raises UsageError."""
    try:
        return workspace_program(package, name)
    except BenchError as error:
        raise UsageError(str(error)) from None


def _library_file(name):
    """The library that a product names, or None where it is linked in anyhow."""
    folders = [pathlib.Path(prefix) / "lib" for prefix in
               [*filter(None, os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep)), SYSTEM]]
    for folder in folders:
        for path in (folder / f"lib{name}.so", *folder.glob(f"*/lib{name}.so")):
            if path.is_file():
                return path
    return None


def estimators(libraries=()):
    """The hash of what estimates: the program, our libraries in it, those that a product names."""
    path = program("slam_ros", "slam_offline")
    named = [file for file in map(_library_file, libraries) if file]
    return hash_of_files(sorted({path, *map(pathlib.Path, libraries_of(path)), *named}))


def simulators():
    """The hash of what simulates."""
    path = program("slam_sim", "slam_sim")
    return hash_of_files([path, *libraries_of(path)])


def foreign(files):
    """The hash of a foreign system: its files, with the libraries of programs, and our side of it."""
    libraries = {path for file in files for path in libraries_of(file)}
    return hash_of([hash_of_files([*files, *sorted(libraries)]), modules("foreign")])


@functools.lru_cache(maxsize=None)
def modules(*folders):
    """The hash of folders of slam_eval's modules."""
    root = pathlib.Path(__file__).resolve().parents[1]
    return hash_of_files([path for folder in folders
                          for path in sorted((root / folder).glob("*.py"))])


def _product_folders():
    """Where products are found by name, as slam_launch has it."""
    told = subprocess.run(["rospack", "plugins", "--attrib=products", "slam_launch"],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
    exported = [line.split(maxsplit=1)[1] for line in told.stdout.splitlines() if " " in line]
    config = os.environ.get("XDG_CONFIG_HOME") or pathlib.Path.home() / ".config"
    return [package_folder("slam_launch") / "products", *map(pathlib.Path, exported),
            pathlib.Path(config) / "slam" / "products"]


def _file_of(text, kind, folders, where):
    """The file that a name stands for in folders, or a file's path. Raises UsageError."""
    if is_path(text):
        path = pathlib.Path(text)
        if not path.is_file():
            raise UsageError(f"{where}: there is no {kind} {path}; check the path, which is "
                                "relative to the campaign's file")
        return path
    found = {}
    for folder in folders:
        for path in sorted(folder.glob("*.yaml")):
            found.setdefault(path.stem, path)
    if text not in found:
        raise UsageError(f"{where}: there is no {kind} '{text}'{did_you_mean(text, found)}; "
                            f"there are: {', '.join(found)}")
    return found[text]


def product_file(text, where):
    return _file_of(text, "product", _product_folders(), where)


def robot_file(text, where):
    return _file_of(text, "robot", [package_folder("slam_launch") / "robots"], where)


def world_file(text, where):
    return _file_of(text, "world", [package_folder("slam_sim") / "worlds"], where)


def simulated_robot_file(text, where):
    return _file_of(text, "simulated robot", [package_folder("slam_sim") / "robots"], where)


def libraries_named_by(path):
    """The libraries that a product file names."""
    try:
        content = yaml.safe_load(read_text(path))
    except yaml.YAMLError:
        return []  # `check` says what is wrong with it
    names = content.get("libraries") if isinstance(content, dict) else None
    return [str(name) for name in names or []]


def require_product(product, settings, where):
    """Refuses what is no valid product, and parameters that it has not, in the words of
    `./slam check`."""
    command = [program("slam_launch", "check"), "--quiet", product,
               *(["--set", *settings] if settings else [])]
    done = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise UsageError(f"{where}: {done.stderr.strip().replace('check: ', '', 1)}")
