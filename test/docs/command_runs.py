# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of Markdown files: block by block in one folder, on short drives."""

import os
import pathlib
import shutil
import subprocess
import tempfile

from catkin.find_in_workspaces import find_in_workspaces
from doc_commands import REPO, shell_blocks
from launching import free_port

DRIVE = 8  # [s] of the office
WITHIN = 200  # [s], of a block
# The front door stays itself, but installs and builds nothing: the programs are those under test.
FRONT_DOOR = """
missing() { :; }
build() { :; }
enclosing_workspace() { echo "$TESTED_WORKSPACE"; }
"""
# It leaves a launch without a bag running for some seconds, then ends it.
SHELL = """
set -emo pipefail
lives=()
roslaunch() {
  if [[ $* == *bag:=* ]]; then command roslaunch "$@"; return; fi
  command roslaunch "$@" & lives+=($!)
  sleep 6
}
end_lives() {
  for life in "${lives[@]}"; do kill -0 "$life"; done
  for life in "${lives[@]}"; do
    # a launch that was too busy to listen is asked once more
    (while kill -INT "$life"; do sleep 20; done) >/dev/null 2>&1 &
    wait "$life" || [[ $? == 130 ]]
    kill -- -$! || true
  done
}
"""


def workspace():
    """Returns the folder that holds the devel space under test."""
    devel = os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep)[0]
    return pathlib.Path(devel).parent


def data_folder():
    return pathlib.Path(os.environ.get("SLAM_DATA_DIR", REPO.parent / "shared" / "data"))


def program(package, name):
    return find_in_workspaces(["libexec"], package, name, first_match_only=True)[0]


class CommandRuns:
    """For a TestCase of the commands in some files."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.home = pathlib.Path(folder.name) / "clone"
        (cls.home / "tools").mkdir(parents=True)
        shutil.copy(REPO / "slam", cls.home)
        build = (REPO / "tools" / "build.sh").read_text(encoding="utf-8")
        (cls.home / "tools" / "build.sh").write_text(build + FRONT_DOOR, encoding="utf-8")
        bags = cls.home / ".slam" / "bags"
        bags.mkdir(parents=True)
        (cls.home / ".slam" / "devel").mkdir()
        (cls.home / ".slam" / "devel" / "setup.bash").write_text(
            f'source "{workspace()}/devel/setup.bash"\nPATH=/usr/bin:$PATH\n', encoding="utf-8")
        subprocess.run([program("slam_sim", "slam_sim"), bags / "office.bag", "--duration",
                        str(DRIVE)], check=True, stdout=subprocess.DEVNULL)

    def environment(self):
        return {**os.environ, "TESTED_WORKSPACE": str(workspace()),
                "XDG_CONFIG_HOME": str(self.home / "config"), "ROS_HOME": str(self.home / "ros"),
                "ROS_MASTER_URI": f"http://localhost:{free_port()}", "DISPLAY": ""}

    def run_block(self, block):
        """Runs a block; what it printed is told where it fails."""
        script = self.home / "block.sh"
        script.write_text(f"{SHELL}{self.shortened(block.text)}end_lives\n", encoding="utf-8")
        done = subprocess.run(["bash", script], cwd=self.home, env=self.environment(),
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=WITHIN, check=False)
        self.assertEqual(done.returncode, 0, f"{block}\n{block.text}\n{done.stdout[-6000:]}")

    @staticmethod
    def shortened(text):
        """A simulation that names no duration drives a short while."""
        lines = []
        for line in text.splitlines():
            command, mark, comment = line.partition(" #")
            if command.startswith("./slam sim ") and "--duration" not in command:
                command = f"{command.rstrip()} --duration {DRIVE}"
            lines.append(command + mark + comment + "\n")
        return "".join(lines)

    def link_data(self, name):
        """Whether the data that a block needs are there; they then are in its folder, too."""
        source = next((path for path in data_folder().glob("*")
                       if path.name.lower() == name.lower()), None)
        if source and not (self.home / name).exists():
            (self.home / name).symlink_to(source)
        return source is not None

    def has(self, name):
        """Whether the program or the data that a block needs are there."""
        return bool(shutil.which(name)) or self.link_data(name)

    def assert_run(self, files):
        """Asserts that the blocks of Markdown files run, one after the other in one folder."""
        for block in shell_blocks(files):
            if block.not_run or (block.needs and not self.has(block.needs)):
                continue
            with self.subTest(str(block)):
                self.run_block(block)
