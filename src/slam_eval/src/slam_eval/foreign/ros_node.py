# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Any ROS node that publishes map -> odom as a foreign system: started by its launch file, it gets
the bag replayed, and its transform is recorded."""
import pathlib
import re
import shlex
import socket
from xml.sax.saxutils import quoteattr

import numpy as np

from slam_eval.bench.harness.error import BenchError, ProgramError
from slam_eval.bench.harness.process import without_colours
from slam_eval.bench.harness.programs import system_program, workspace_program
from slam_eval.foreign.bag_data import messages, read_odometry, robot_of
from slam_eval.foreign.driver import Driver
from slam_eval.foreign.results import write_about, write_trajectory
from slam_eval.geometry import se2
from slam_eval.io.errors import InputError
from slam_eval.io.trajectory import interpolate, read_trajectory, Trajectory

MAP_ODOM = "map_odom.tum"  # what the recorder has heard
UNREPLAYED = "unreplayed.txt"  # why the recorder did not replay the bag
_LONGEST_GAP = 5.0  # [s] between two transforms
_PATIENCE = 60.0    # [s] for the nodes to start, where the system's file says nothing else
# of roslaunch; what differs from call to call, as the process id, is left out
_COMPLAINT = re.compile(r"^(?:(?P<start>ERROR: cannot launch node.*|Value error:.*)|"
                        r"\[(?P<died>(?!foreign_recorder)\S+)-\d+\] process has died"
                        r"(?: \[pid \d+, (?P<code>exit code -?\d+))?.*)$", re.MULTILINE)
_ARGUMENT = "arg."  # before the name of an argument of the launch file
_LAUNCH = """<launch>
  <param name="/use_sim_time" value="true"/>
  <include file={launch}>{arguments}</include>
  <node pkg="slam_eval" type="foreign_recorder" name="foreign_recorder" required="true"
        output="screen" args={recorder}/>
</launch>
"""


def free_port():
    """A port that nobody listens on, for a master of our own."""
    with socket.socket() as listener:
        listener.bind(("", 0))
        return listener.getsockname()[1]


def map_base(map_odom, odometry, stamps):
    """The robot's poses in the map at stamps: what tf would answer for map -> base there, of the
    transforms map -> odom that were published and the bag's odometry."""
    corrections, known = interpolate(map_odom, stamps, _LONGEST_GAP)
    poses, covered = interpolate(odometry, stamps)
    valid = known & covered
    poses = [se2.compose(a, b) for a, b in zip(corrections[valid], poses[valid])]
    return Trajectory(np.asarray(stamps)[valid], np.array(poses).reshape(-1, 3))


def complaint(log):
    """What roslaunch said first of a node of the system that did not start or has died, else where
    to look."""
    said = without_colours(log.with_name(log.name + ".err").read_text("utf-8", errors="replace"))
    found = _COMPLAINT.search(said)
    if not found:
        return "; the run's log.txt says more"
    if found["start"]:
        return f"; roslaunch said: {found['start']}"
    code = f" with {found['code']}" if found["code"] else ""
    return f"; its node {found['died']} has died{code}"


def _filled(name, text, seed, robot):
    """The value of an argument for a run. Raises BenchError."""
    try:
        return text.format(seed=seed, robot=robot)
    except (AttributeError, LookupError, TypeError, ValueError):
        raise BenchError(f"the parameter {name} is '{text}', in which braces stand for something "
                         "else than {seed} and {robot}; write {{ and }} for braces") from None


class RosNode(Driver):
    """Its parameters: launch (a file beside the system's own), frames, topics that are replayed,
    stamps (the topic whose stamps the trajectory has), rate, patience (how long nodes may take to
    subscribe [s]), and arg.NAME of the launch file, in which {seed} and {robot} stand for the
    run's."""

    required = ("launch", "map_frame", "odom_frame", "topics", "stamps")
    positive = ("rate", "patience")
    optional = ("patience",)

    def check(self):
        super().check()
        self._arguments(0, "")

    def _launch(self):
        return pathlib.Path(self.parameters["folder"]) / str(self.parameters["launch"])

    def programs(self):
        if not self._launch().is_file():
            raise BenchError(f"there is no launch file {self._launch()}")
        if system_program("roslaunch") is None:
            raise BenchError("there is no roslaunch; source ROS's setup.bash")
        return [self._launch(), workspace_program("slam_eval", "foreign_recorder")]

    def _arguments(self, seed, robot):
        values = {name[len(_ARGUMENT):]: _filled(name, str(value), seed, robot)
                  for name, value in self.parameters.items() if name.startswith(_ARGUMENT)}
        return "".join(f"<arg name={quoteattr(name)} value={quoteattr(value)}/>"
                       for name, value in values.items())

    def _write_launch(self, job, robot):
        topics = str(self.parameters["topics"]).split()
        words = [str(job.bag), str(job.folder), str(self.parameters["map_frame"]),
                 str(self.parameters["odom_frame"]), str(self.number("rate")),
                 str(self.parameters.get("patience") or _PATIENCE), *topics]
        path = job.folder / "foreign.launch"
        path.write_text(_LAUNCH.format(
            launch=quoteattr(str(self._launch())), arguments=self._arguments(job.seed, robot),
            recorder=quoteattr(shlex.join(words))), encoding="utf-8")
        return path

    def _heard(self, job, robot):
        """The transform map -> odom while the bag is replayed. Raises BenchError."""
        log = job.folder / "log.txt"
        try:
            job.call([system_program("roslaunch"), "-p", free_port(),
                      self._write_launch(job, robot)], log)
        except ProgramError as error:
            raise ProgramError(f"{error}{complaint(log)}", error.code) from None
        unreplayed = job.folder / UNREPLAYED
        if unreplayed.exists():
            raise BenchError(unreplayed.read_text(encoding="utf-8").strip() + complaint(log))
        try:
            return read_trajectory(job.folder / MAP_ODOM)
        except InputError:
            raise BenchError("it published no transform "
                             f"{self.parameters['map_frame']} -> {self.parameters['odom_frame']} "
                             f"while the bag was replayed{complaint(log)}") from None

    def run(self, job):
        robot = job.robot or robot_of(job.bag)
        heard = self._heard(job, robot)
        odometry = read_odometry(job.bag)
        stamps = [stamp for stamp, _ in messages(job.bag, str(self.parameters["stamps"]))]
        found = map_base(heard, odometry, stamps)
        if len(found) < 2:
            raise BenchError(f"its transform is known at {len(found)} stamps of the bag's "
                             f"{self.parameters['stamps']} only")
        write_trajectory(job.folder / "trajectory.tum", found)
        write_trajectory(job.folder / "odometry.tum",
                         Trajectory(found.stamps, interpolate(odometry, found.stamps)[0]))
        write_about(job, "ros_node", robot, None, len(found))
