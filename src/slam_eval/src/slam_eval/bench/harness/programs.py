# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where programs are: those of the sourced workspaces by package, others on PATH."""
import os
import pathlib
import shutil

from slam_eval.bench.harness.error import BenchError

SYSTEM = "/usr"  # where Debian packages are installed; nobody sources that


def workspace_program(package, name):
    """The program of a package of the sourced workspaces, else of Debian's. Raises BenchError."""
    workspaces = os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep)
    for prefix in [*filter(None, workspaces), SYSTEM]:
        path = pathlib.Path(prefix) / "lib" / package / name
        if os.access(path, os.X_OK) and path.is_file():
            return path
    raise BenchError(f"the program {name} of {package} is in no workspace of CMAKE_PREFIX_PATH; "
                     "build it and source its setup.bash")


def package_folder(name):
    """The folder of a package of ours, in its source folder or installed. Raises BenchError."""
    import rospkg  # only here: the rest of slam_eval needs no ROS
    try:
        return pathlib.Path(rospkg.RosPack().get_path(name))
    except rospkg.ResourceNotFound:
        raise BenchError(f"the package {name} is not there; source the workspace's "
                         "setup.bash") from None


def simulation_file(kind, name):
    """A file of the package slam_sim (kind: worlds, robots)."""
    return package_folder("slam_sim") / kind / f"{name}.yaml"


def system_program(name):
    """The path of a program on PATH, or None."""
    found = shutil.which(name)
    return None if found is None else pathlib.Path(found)


def data_folder(name):
    """A folder of data: under $SLAM_DATA_DIR, else under shared/data beside the repository."""
    root = os.environ.get("SLAM_DATA_DIR")
    if root:
        return pathlib.Path(root) / name
    # In an install space this leads nowhere, and the folder counts as absent.
    repository = pathlib.Path(__file__).resolve().parents[6]
    return repository.parent / "shared" / "data" / name
