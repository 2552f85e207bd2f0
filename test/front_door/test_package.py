# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of ./slam package, as far as nothing is built, and of the command that packages install."""

import shutil

from test_front_door import ABSENT, call, FrontDoorTest, make_clone, REPO


class Package(FrontDoorTest):
    def setUp(self):
        super().setUp()
        self.clone = make_clone(self.folder / "a clone")
        self.slam = self.clone / "slam"
        self.set_machine("debian 12", ABSENT)

    def set_machine(self, release, tools):
        (self.clone / "tools/package_tools.txt").write_text(f"{tools}\n", encoding="utf-8")
        with (self.clone / "tools/package.sh").open("a", encoding="utf-8") as file:
            file.write(f"debian_release() {{ echo '{release}'; }}\n")

    def test_refuses_an_argument_that_it_does_not_take(self):
        for arguments in (["--fast"], ["--out"], ["--out", ""], ["--out", "a", "b"], ["a"]):
            self.expect(call(self.slam, "package", *arguments), 2, "package takes --out DIR only")

    def test_refuses_another_system(self):
        self.set_machine("ubuntu 20.04", ABSENT)
        self.expect(call(self.slam, "package", "--yes"), 1,
                    "packages are built on Debian 12, and this is ubuntu 20.04")

    def test_refuses_a_folder_that_cannot_be_written(self):
        (self.folder / "file").touch()
        out = self.folder / "file/packages"
        self.expect(call(self.slam, "package", "--out", out), 1, f"cannot write to {out}")

    def test_without_a_terminal_asks_for_yes_to_install_its_tools(self):
        result = call(self.slam, "package", "--out", self.folder / "out")
        self.expect(result, 2, ABSENT, "add --yes to install these packages")
        self.assertFalse((self.clone / ".slam/package_build").exists())

    def test_shows_the_log_of_a_build_that_failed(self):
        self.set_machine("debian 12", "bash")
        for name in ("LICENSE", "README.md"):
            shutil.copy(REPO / name, self.clone)
        for name in ("debian", "docs", "test/toys"):
            (self.clone / name).mkdir(parents=True)
        with (self.clone / "tools/package.sh").open("a", encoding="utf-8") as file:
            file.write("build_packages() { ls \"$1\" && echo wheels fell off && false; }\n")
        self.expect(call(self.slam, "package"), 1, "slam_launch", "wheels fell off",
                    str(self.clone / ".slam/package.log"))


class Installed(FrontDoorTest):
    """The command as debian/rules installs it, below a prefix that is not /usr."""

    def setUp(self):
        super().setUp()
        place = self.folder / "share/ros-slam"
        (place / "tools").mkdir(parents=True)
        shutil.copy(REPO / "slam", place)
        shutil.copy(REPO / "tools/installed.sh", place / "tools/build.sh")
        self.slam = self.folder / "bin/slam"
        self.slam.parent.mkdir()
        self.slam.symlink_to("../share/ros-slam/slam")

    def install_program(self, package, name, says="$@"):
        path = self.folder / "lib" / package / name
        path.parent.mkdir(parents=True)
        path.write_text(f'#!/bin/sh\necho {name}: "{says}"\n', encoding="utf-8")
        path.chmod(0o755)

    def test_names_the_commands_that_need_no_clone(self):
        result = call(self.slam, "help")
        self.expect(result, 0, "Usage: slam COMMAND", "\n  demo [PRODUCT] ", "\n  eval DIR ")
        for absent in ("./slam", "--yes", "\n  setup", "\n  test", "\n  docs", "\n  package"):
            self.assertNotIn(absent, result.stdout)

    def test_refuses_the_others(self):
        for command in ("setup", "test", "docs", "package"):
            self.expect(call(self.slam, command), 2,
                        f"'{command}' works in a clone of the repository")

    def test_is_named_as_it_is_called(self):
        self.expect(call(self.slam, "evla"), 2, "did you mean eval? (slam help lists them all)")
        self.install_program("slam_launch", "products", "$SLAM_COMMAND")
        self.expect(call(self.slam, "products"), 0, "products: slam\n")

    def test_leaves_a_workspace_on_top_of_the_packages_as_it_is_sourced(self):
        self.install_program("slam_launch", "products", "$ROS_PACKAGE_PATH:$CMAKE_PREFIX_PATH")
        (self.folder / "mine").mkdir()
        (self.folder / "mine/.catkin").touch()
        result = call(self.slam, "products", ROS_PACKAGE_PATH="/mine/src",
                      CMAKE_PREFIX_PATH=str(self.folder / "mine"))
        self.expect(result, 0)
        self.assertEqual(result.stdout, f"products: /mine/src:{self.folder}/mine\n")

    def test_calls_the_installed_programs(self):
        self.install_program("slam_eval", "slam_import")
        self.expect(call(self.slam, "import", "mrclam", "a b"), 0, "slam_import: mrclam a b\n")

    def test_keeps_the_demonstration_s_files_among_the_user_s(self):
        self.install_program("slam_launch", "demo")
        self.expect(call(self.slam, "demo", "--yes", XDG_DATA_HOME="/home/of/mine"), 0,
                    "demo: --dir /home/of/mine/slam\n")

    def test_says_so_where_a_program_is_not_installed(self):
        self.expect(call(self.slam, "eval", "runs/a"), 1, "there is no program")


if __name__ == "__main__":
    import unittest
    unittest.main()
