# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The other ways to build that the documents name, each from a clean copy."""

import pathlib
import re
import shutil
import xml.etree.ElementTree as ElementTree

from runner.suites import JOBS


def copy_sources(repository, target):
    """Copies what a clone would hold: neither builds nor hidden folders."""
    def ignored(folder, names):
        at_root = pathlib.Path(folder) == repository
        return [name for name in names if name == "__pycache__" or at_root and
                re.match(r"\.|build|devel|install|CMakeLists.txt", name)]
    shutil.copytree(repository, target, ignore=ignored)


def unbuilt_packages(source, space):
    """Catkin reports success for packages it has not seen; returns their names."""
    names = [ElementTree.parse(path).findtext("name") for path in source.rglob("package.xml")
             if "toys" not in path.parts]
    built = {path.stem for path in space.rglob("share/*/cmake/*Config.cmake")}
    return [name for name in names if f"{name}Config" not in built]


def run_layouts(report, repository, root):
    """Builds below the folder `root`, which is removed before and after."""
    shutil.rmtree(root, ignore_errors=True)
    flags = [JOBS, "-DCMAKE_BUILD_TYPE=Release"]
    for title, clone, workspace, command, space in (
            ("catkin_make at the root", "root", "root",
             ["catkin_make", "--source", root / "root"], "devel"),
            ("catkin_make_isolated at the root", "isolated", "isolated",
             ["catkin_make_isolated", "--source", root / "isolated"], "devel_isolated"),
            ("catkin_make in a workspace", "ws/src/slam", "ws", ["catkin_make"], "devel")):
        copy_sources(repository, root / clone)
        if report.run(title, [*command, "-C", root / workspace, *flags]):
            unbuilt = unbuilt_packages(root / clone, root / workspace / space)
            report.run(f"{title}: builds every package",
                       ["sh", "-c", f"echo not built: {' '.join(unbuilt)}; exit {len(unbuilt)}"])
        shutil.rmtree(root / workspace)
