# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of ./slam in small clones that hold the front door and the package slam_launch."""

import fcntl
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

REPO = pathlib.Path(__file__).resolve().parents[2]
ABSENT = "slam-no-such-package"


def make_clone(folder):
    folder.mkdir(parents=True)
    shutil.copy(REPO / "slam", folder)
    shutil.copytree(REPO / "tools", folder / "tools")
    shutil.copytree(REPO / "slam_launch", folder / "slam_launch")
    (folder / "tools/packages.txt").write_text("bash\n", encoding="utf-8")
    return folder


def call(*command, cwd=None, **environment):
    """Runs a command without a terminal; its standard error is part of stdout."""
    clean = {name: value for name, value in os.environ.items() if name not in ("CI", "SUDO_USER")}
    clean["XDG_CONFIG_HOME"] = "/nowhere"  # not the products of who runs the tests
    return subprocess.run([str(word) for word in command], cwd=cwd, env={**clean, **environment},
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False, timeout=300)


class FrontDoorTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def expect(self, result, code, *texts):
        self.assertEqual(result.returncode, code, result.stdout)
        for text in texts:
            self.assertIn(text, result.stdout)


class WithoutBuild(FrontDoorTest):
    def setUp(self):
        super().setUp()
        self.clone = make_clone(self.folder / "a clone")
        self.slam = self.clone / "slam"

    def require_absent_package(self):
        (self.clone / "tools/packages.txt").write_text(f"bash # a shell\n{ABSENT}\n",
                                                       encoding="utf-8")

    def test_names_every_command_when_called_without_one(self):
        commands = ("setup demo test products parameters check new menu new-component import sim run "
                    "doctor merge tune eval campaign docs package bench")
        self.expect(call(self.slam), 0, *[f"\n  {command} " for command in commands.split()])

    def test_names_the_commands_that_explain_their_arguments(self):
        sentence = call(self.slam, "help").stdout.rsplit("\n\n", 1)[-1]
        self.assertIn("--help", sentence)
        for command in "products new-component import sim run doctor merge tune eval bench".split():
            self.assertIn(command, sentence.split("arguments of")[-1])

    def test_suggests_the_nearest_name_for_an_unknown_command(self):
        self.expect(call(self.slam, "prodcuts"), 2, "unknown command 'prodcuts'", "products")

    def test_refuses_an_argument_that_a_command_does_not_take(self):
        self.expect(call(self.slam, "test", "--fast"), 2, "--fast")
        self.expect(call(self.slam, "test", "--fuzz", "soon"), 2, "--fuzz soon")
        self.expect(call(self.slam, "test", "--all", "--fuzz"), 2, "--all --fuzz")

    def test_names_missing_packages_and_installs_nothing(self):
        self.require_absent_package()
        result = call(self.slam, "products")
        self.expect(result, 1, f"missing packages: {ABSENT};", "./slam setup")
        self.assertFalse((self.clone / ".slam").exists())

    def test_setup_without_a_terminal_asks_for_yes(self):
        self.require_absent_package()
        self.expect(call(self.slam, "setup"), 2, ABSENT, "--yes")
        self.assertFalse((self.clone / ".slam").exists())

    def test_says_so_when_it_cannot_write(self):
        self.folder.chmod(0o755)
        self.clone.chmod(0o555)
        self.addCleanup(self.clone.chmod, 0o755)
        drop = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
        user = drop if os.geteuid() == 0 else []
        self.expect(call(*user, self.slam, "products"), 1, "cannot write to", ".slam")

    def test_shows_the_log_of_a_failed_build(self):
        with (self.clone / "slam_launch/CMakeLists.txt").open("a", encoding="utf-8") as file:
            file.write('message(FATAL_ERROR "wheels fell off")\n')
        log = self.clone / ".slam/build.log"
        self.expect(call(self.slam, "products"), 1, "wheels fell off", str(log))
        self.expect(call(self.slam, "products"), 1, "wheels fell off")

    def test_ends_a_test_whose_build_failed_with_the_sum(self):
        (self.clone / "slam_launch/CMakeLists.txt").write_text("no CMake\n", encoding="utf-8")
        result = call(self.slam, "test")
        self.expect(result, 1)
        self.assertEqual(result.stdout.splitlines()[-1], "0 passed, 1 failed")

    def test_uses_the_enclosing_workspace_once_that_is_built(self):
        clone = make_clone(self.folder / "ws/src/clone")
        self.expect(call("catkin_make", "-C", self.folder / "ws"), 0)
        self.expect(call(clone / "slam", "products"), 0, "ekf_wheel  ")
        self.assertFalse((clone / ".slam/build").exists())


class WithBuild(FrontDoorTest):
    """One clone, built once, for all tests; each leaves it as it was."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.clone = make_clone(pathlib.Path(folder.name) / "a clone")
        cls.slam = cls.clone / "slam"
        cls.first = call(cls.slam, "products")

    def test_builds_before_the_first_product_list(self):
        self.expect(self.first, 0, "ekf_wheel  ")
        self.assertTrue((self.clone / ".slam/CATKIN_IGNORE").exists())

    def test_builds_again_only_what_changed(self):
        log = self.clone / ".slam/build.log"
        built = log.stat().st_mtime_ns
        self.expect(call(self.slam, "products"), 0, "ekf_wheel  ")
        self.assertEqual(log.stat().st_mtime_ns, built)
        product = self.clone / "slam_launch/products/other.yaml"
        self.addCleanup(product.unlink)
        product.write_text("version: 1\nproduct: other\nsentence: Another one.\nbackend: ekf\n"
                           "odometry: wheel\n", encoding="utf-8")
        self.assertRegex(call(self.slam, "products").stdout, "(?m)^other +Another one[.]$")
        self.assertNotEqual(log.stat().st_mtime_ns, built)

    def test_does_not_build_again_for_what_commands_leave_in_the_clone(self):
        call(self.slam, "products")
        built = (self.clone / ".slam/build.log").stat().st_mtime_ns
        for name in ("office.bag", "mine.svg", "tuned.yaml", "runs/office/trajectory.tum"):
            left = self.clone / name
            left.parent.mkdir(parents=True, exist_ok=True)
            left.touch()
        self.expect(call(self.slam, "products"), 0, "ekf_wheel  ")
        self.assertEqual((self.clone / ".slam/build.log").stat().st_mtime_ns, built)

    def test_what_it_prints_holds_no_word_of_the_build(self):
        cmake = self.clone / "slam_launch/CMakeLists.txt"
        self.addCleanup(cmake.write_text, cmake.read_text(encoding="utf-8"), encoding="utf-8")
        with cmake.open("a", encoding="utf-8") as file:
            file.write("add_custom_target(wheels ALL COMMAND true COMMENT wheels)\n")
        done = subprocess.run([str(self.slam), "products"], stdin=subprocess.DEVNULL, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=True)
        self.assertIn("building: 100%", done.stderr)
        self.assertTrue(done.stdout.startswith("ekf_"), done.stdout)

    def test_names_the_demonstrations_beside_a_product_that_is_none(self):
        self.expect(call(self.slam, "demo", "al", "--yes"), 2, "there is no product 'al'",
                    "all are the thesis's five", "sena is a real robot's log")

    def test_programs_are_told_how_it_was_called(self):
        self.expect(call(self.slam, "products"), 0, "'./slam new NAME key=value ...' gives one a")

    def test_is_found_through_a_link_from_another_folder(self):
        link = self.folder / "link"
        link.symlink_to(self.slam)
        self.expect(call(link, "products", cwd=self.folder), 0, "ekf_wheel  ")

    def test_needs_no_other_python_than_debian_s(self):
        wrong = self.folder / "python3"
        wrong.write_text("#!/bin/sh\nexit 99\n", encoding="utf-8")
        wrong.chmod(0o755)
        path = f"{self.folder}:{os.environ['PATH']}"
        self.expect(call(self.slam, "products", PATH=path), 0, "ekf_wheel  ")

    def test_builds_from_scratch_where_the_clone_has_moved(self):
        moved = self.folder / "moved"
        shutil.copytree(self.clone, moved, symlinks=True)
        self.expect(call(moved / "slam", "products"), 0, "from scratch", "ekf_wheel  ")

    def test_waits_for_another_call_that_builds(self):
        (self.clone / ".slam/built.all").unlink()
        with (self.clone / ".slam/lock").open("a", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            with subprocess.Popen([str(self.slam), "products"], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True) as waiting:
                self.assertEqual(waiting.stderr.readline(), "waiting for another ./slam\n")
                self.assertIsNone(waiting.poll())
                fcntl.flock(lock, fcntl.LOCK_UN)
                self.assertIn("ekf_wheel  ", waiting.communicate(timeout=300)[0])


class WithOverlay(FrontDoorTest):
    """A user's workspace on top of a clone's, or beside it, which brings a product."""

    OUTSIDE = {name: "" for name in ("CMAKE_PREFIX_PATH", "ROS_PACKAGE_PATH", "PYTHONPATH",
                                     "LD_LIBRARY_PATH")}

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        root = pathlib.Path(folder.name)
        cls.slam = make_clone(root / "a clone") / "slam"
        call(cls.slam, "products", **cls.OUTSIDE)
        cls.space = root / "a clone/.slam/devel"
        cls.overlay = cls.make_workspace(root / "on top")
        cls.calls(cls.space, "catkin_make", "-C", cls.overlay)
        cls.beside = cls.make_workspace(root / "beside it")
        call("catkin_make", "-C", cls.beside, **cls.OUTSIDE)

    @staticmethod
    def make_workspace(folder):
        package = folder / "src/my_slam"
        (package / "products").mkdir(parents=True)
        (package / "package.xml").write_text(
            "<package format=\"2\"><name>my_slam</name><version>1.0.0</version><description>Mine."
            "</description><maintainer email=\"me@slam.invalid\">me</maintainer>"
            "<license>BSD</license><buildtool_depend>catkin</buildtool_depend><exec_depend>slam_launch</exec_depend>"
            "<export><slam_launch products=\"${prefix}/products\"/></export></package>\n",
            encoding="utf-8")
        (package / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.10)\nproject(my_slam)\n"
            "find_package(catkin REQUIRED)\ncatkin_package()\n", encoding="utf-8")
        (package / "products/my_product.yaml").write_text(
            "version: 1\nproduct: my_product\nsentence: A product of mine.\nbackend: ekf\n"
            "odometry: wheel\n", encoding="utf-8")
        return folder

    @classmethod
    def calls(cls, space, *command):
        """Runs a command where a workspace's setup.bash is sourced, as a user does."""
        return call("bash", "-c", 'source "$0/setup.bash" && exec "$@"', space, *command,
                    **cls.OUTSIDE)

    def test_lists_the_products_of_a_workspace_on_top_that_is_sourced(self):
        result = self.calls(self.overlay / "devel", self.slam, "products")
        self.expect(result, 0, "ekf_wheel  ", "my_product ")
        self.assertNotIn("left out", result.stdout)
        self.assertNotIn("my_product", self.calls(self.space, self.slam, "products").stdout)

    def test_leaves_out_a_workspace_beside_it_and_says_so_in_one_line(self):
        result = self.calls(self.beside / "devel", self.slam, "products")
        self.expect(result, 0, "ekf_wheel  ")
        self.assertNotIn("my_product", result.stdout)
        said = [line for line in result.stdout.splitlines() if line.startswith("slam: ")]
        self.assertEqual(len(said), 1, result.stdout)
        for text in (f"{self.beside}/devel is sourced", "left out",
                     f"source {self.space}/setup.bash"):
            self.assertIn(text, said[0])

    def test_is_not_built_on_what_lies_on_top_of_it(self):
        (self.slam.parent / ".slam/built.all").unlink()
        (self.slam.parent / "slam_launch/products/other.yaml").write_text(
            "version: 1\nproduct: other\nsentence: Another one.\nbackend: ekf\nodometry: wheel\n",
            encoding="utf-8")
        (self.slam.parent / "slam_launch/CMakeLists.txt").touch()
        self.expect(self.calls(self.overlay / "devel", self.slam, "products"), 0, "my_product ")
        log = (self.slam.parent / ".slam/build.log").read_text(encoding="utf-8")
        self.assertIn("Using CMAKE_PREFIX_PATH: \n", log)
        self.assertNotIn(str(self.overlay), log)
        of_tests = self.slam.parent / ".slam/build/catkin_generated/setup_cached.sh"
        self.assertIn("PYTHONPATH=", of_tests.read_text(encoding="utf-8"))


class WithAllPrograms(FrontDoorTest):
    """In front of the build under test: a clone of slam_launch alone cannot ask for ports."""

    def setUp(self):
        super().setUp()
        clone = make_clone(self.folder / "a clone")
        with (clone / "tools/build.sh").open("a", encoding="utf-8") as file:
            file.write(f"build() {{ :; }}\nenclosing_workspace() {{ echo '{REPO}/.slam'; }}\n")
        self.slam = clone / "slam"

    def test_refuses_what_makes_no_product(self):
        self.expect(call(self.slam, "check", "backend=ekf", "odometry=weel"), 1,
                    "did you mean 'wheel'?")
        self.expect(call(self.slam, "check", "backend=ekf", "odometry=wheel"), 0, "(ekf_wheel)")

    def test_tells_what_a_diagram_lacks(self):
        self.expect(call(self.slam, "products", "--diagram", "ekf_whel"), 1,
                    "did you mean 'ekf_wheel'?")
        self.expect(call(self.slam, "products", "--diagram", "ekf_wheel", "--out", "a.gif",
                         cwd=self.folder), 1, "a.gif ends with none of: .svg")
        self.expect(call(self.slam, "products", "--out", "a.svg"), 2, "go with --diagram")
        self.assertEqual(list(self.folder.glob("*.*")), [])

    def test_lists_a_product_that_it_has_written(self):
        home = self.folder / "config of mine"
        written = call(self.slam, "new", "mine", "backend=pf", "odometry=wheel", "detector=none",
                       XDG_CONFIG_HOME=str(home))
        self.expect(written, 0, f"{home}/slam/products/mine.yaml")
        self.expect(call(self.slam, "products", XDG_CONFIG_HOME=str(home)), 0, "\nmine  ")


if __name__ == "__main__":
    unittest.main()
