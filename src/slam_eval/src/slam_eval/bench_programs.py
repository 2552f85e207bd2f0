# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where programs are: those of the sourced workspaces by package, others on PATH."""
import os
import pathlib
import shutil

from slam_eval.bench_error import BenchError


def workspace_program(package, name):
    """The program of a package of the sourced workspaces. Raises BenchError."""
    for prefix in filter(None, os.environ.get('CMAKE_PREFIX_PATH', '').split(os.pathsep)):
        path = pathlib.Path(prefix) / 'lib' / package / name
        if os.access(path, os.X_OK) and path.is_file():
            return path
    raise BenchError(f'the program {name} of {package} is in no workspace of CMAKE_PREFIX_PATH; '
                     'build it and source its setup.bash')


def system_program(name):
    """The path of a program on PATH, or None."""
    found = shutil.which(name)
    return None if found is None else pathlib.Path(found)


def data_folder(name):
    """A folder of data: under $SLAM_DATA_DIR, else under shared/data beside the repository."""
    root = os.environ.get('SLAM_DATA_DIR')
    if root:
        return pathlib.Path(root) / name
    # In an install space this leads nowhere, and the folder counts as absent.
    repository = pathlib.Path(__file__).resolve().parents[4]
    return repository.parent / 'shared' / 'data' / name
