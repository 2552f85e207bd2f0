# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which machine slam.launch gives each node, and the environment that it finds there."""

import getpass
import os
import pathlib
import subprocess
import unittest

from launching import free_port, program, Refusals
import roslaunch

ROBOT, DESK = "192.0.2.1", "192.0.2.2"
FRONT_END = {"/slam_manager", "/wheel_odometry", "/fiducial_detector"}
BACK_END = {"/slam_manager_backend", "/slam_backend"}


def nodes(*arguments):
    """Returns the nodes of a launch by name."""
    file = roslaunch.rlutil.resolve_launch_arguments(["slam_launch", "slam.launch"])[0]
    config = roslaunch.config.load_config_default(
        [(file, ["robot:=sim_segway", *arguments])], free_port(), verbose=False)
    return {node.namespace + node.name: node for node in config.nodes}


def machines(*arguments):
    return {name: node.machine.address for name, node in nodes(*arguments).items()}


class MachinesTest(Refusals, unittest.TestCase):
    def test_without_machines_all_is_here_in_one_manager(self):
        self.assertEqual(machines(), dict.fromkeys(FRONT_END | {"/slam_backend"}, "localhost"))

    def test_the_back_end_goes_to_its_machine(self):
        self.assertEqual(machines(f"backend_machine:={DESK}"),
                         {**dict.fromkeys(FRONT_END, "localhost"), **dict.fromkeys(BACK_END, DESK)})

    def test_each_half_goes_to_its_machine_and_rviz_stays_here(self):
        self.assertEqual(machines(f"frontend_machine:={ROBOT}", f"backend_machine:={DESK}",
                                  "rviz:=true"),
                         {**dict.fromkeys(FRONT_END, ROBOT), **dict.fromkeys(BACK_END, DESK),
                          "/rviz": "localhost"})

    def test_nodelets_are_loaded_into_the_manager_beside_them(self):
        for name, node in nodes(f"backend_machine:={DESK}").items():
            if node.args:
                manager = "/" + node.args.split()[-1]
                self.assertEqual(manager in BACK_END, name in BACK_END, node.args)

    def test_what_looks_at_images_is_front_end_what_draws_is_not(self):
        self.assertEqual({name for name, address in
                          machines("product:=pf_visual", "pointmap:=true",
                                   f"backend_machine:={DESK}").items() if address == DESK},
                         BACK_END | {"/pointmap"})

    def test_stages_are_in_the_manager_of_the_back_end_whose_checkpoints_hold_them(self):
        there = {name: node for name, node in nodes("product:=rat_wheel",
                                                    f"backend_machine:={DESK}").items()
                 if node.machine.address == DESK}
        self.assertEqual(set(there), BACK_END | {"/local_view", "/pose_cells"})

    def test_both_halves_on_one_other_machine_share_a_manager(self):
        both = [f"frontend_machine:={DESK}", f"backend_machine:={DESK}"]
        self.assertEqual(set(machines(*both)), FRONT_END | {"/slam_backend"})
        self.assertEqual(set(machines(*both, "composition:=inprocess").values()), {DESK})

    def test_a_launch_of_one_half_starts_that_half(self):
        self.assertEqual(set(machines("only:=frontend")), FRONT_END)
        self.assertEqual(set(machines("only:=backend")), BACK_END)

    def test_files_of_another_machine_need_not_be_here(self):
        there = machines(f"backend_machine:={DESK}", "load_map:=/only/there/landmarks.yaml")
        self.assertIn("/slam_backend", there)
        self.assertIn("/bag_source", machines(f"frontend_machine:={ROBOT}", "bag:=/only/there.bag"))
        self.assert_refused("there is no such file", f"backend_machine:={DESK}",
                            "bag:=/only/there.bag")

    def test_a_user_and_an_env_loader_are_passed_on(self):
        node = nodes(f"backend_machine:=anna@{DESK}", "env_loader:=/there/env_loader")[
            "/slam_backend"]
        self.assertEqual((node.machine.user, node.machine.env_loader),
                         ("anna", "/there/env_loader"))

    def test_one_nodelet_cannot_be_divided(self):
        for argument in (f"backend_machine:={DESK}", "only:=backend"):
            with self.subTest(argument):
                self.assert_refused("is one nodelet, which cannot be divided",
                                    "composition:=inprocess", "robot:=sim_segway", argument)

    def test_machines_and_halves_that_are_none_are_named(self):
        self.assert_refused("only:=bakcend is not one of: frontend, backend", "only:=bakcend",
                            "robot:=sim_segway")
        self.assert_refused("backend_machine:=anna@ is not of the form [USER@]ADDRESS",
                            "backend_machine:=anna@", "robot:=sim_segway")


class EnvLoaderTest(unittest.TestCase):
    """The environment of a shell that ssh opens: next to none."""

    @classmethod
    def setUpClass(cls):
        cls.loader = nodes(f"backend_machine:={DESK}")["/slam_backend"].machine.env_loader

    def call(self, *command, **environment):
        bare = {"HOME": str(pathlib.Path.home()), "USER": getpass.getuser(),
                "PATH": "/usr/bin:/bin", "SSH_CONNECTION": f"{ROBOT} 50000 {DESK} 22"}
        return subprocess.run([self.loader, *command], env={**bare, **environment},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=False)

    def test_it_is_the_one_of_this_workspace(self):
        self.assertTrue(os.path.samefile(self.loader, program("slam_launch", "env_loader")))

    def test_ros_knows_the_packages_there(self):
        done = self.call("rospack", "find", "slam_backend_ekf")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertTrue(pathlib.Path(done.stdout.strip()).is_dir())

    def test_arguments_and_exit_code_pass_through(self):
        done = self.call("sh", "-c", 'printf "[%s]" "$@"; exit 7', "sh", "two words", "--local")
        self.assertEqual((done.stdout, done.returncode), ("[two words][--local]", 7))

    def test_the_machine_is_known_by_the_address_that_was_called(self):
        self.assertEqual(self.call("printenv", "ROS_IP").stdout.strip(), DESK)

    def test_a_name_that_is_set_already_stays(self):
        done = self.call("env", ROS_HOSTNAME="desk.example")
        self.assertIn("ROS_HOSTNAME=desk.example", done.stdout)
        self.assertNotIn("ROS_IP=", done.stdout)

    def test_without_a_command_it_says_how_it_is_called(self):
        done = self.call()
        self.assertEqual(done.returncode, 2)
        self.assertIn("usage: env_loader COMMAND", done.stdout)


if __name__ == "__main__":
    unittest.main()
