# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The faults of the benchmark adverse by name: what is wrong, from when on, and for which sensor."""
import dataclasses
import math
import shutil

from slam_eval.bench.adverse import changes
from slam_eval.bench.harness import bag_edit

LANDMARKS, SCANS = "landmarks", "scans"  # what a product sees the world by
BEGIN = 20.0     # of faults that are not there from the start [s]
STUCK = 10.0     # how long the odometry stands still [s]
CARRIED = 10.0   # the robot is carried as far as it would have driven in that time [s]
JUMP = 1e9       # [m]
MOVED = 0.5      # [m]
TURNED = 0.1     # [rad]
CONSTANT = 2.0   # [m]


@dataclasses.dataclass(frozen=True)
class Fault:
    """What is wrong, in words; from when on [s]; change(bag, seed) makes a change for
    bag_edit.edit(). A robot that is carried has none."""

    title: str
    begin: float
    change: object = None
    sensors: tuple = (LANDMARKS, SCANS)

    def write(self, source, target, seed):
        """The bag of a drive with this fault."""
        if self.change is not None:
            bag_edit.edit(source, target, self.change(source, seed))
        elif self.begin > 0.0:
            carried = bag_edit.Carried(self.begin, self.begin + CARRIED, math.inf)
            bag_edit.rewrite(source, target, carried=carried)
        else:
            shutil.copy(source, target)
        return target


def _false_ids(bag, seed):
    return changes.FalseIds(changes.ids_in(bag), 0.5, seed, BEGIN)


def _moved(bag, seed):
    return changes.MovedLandmarks(changes.truth_of(bag), MOVED, seed, BEGIN)


FAULTS = {
    "clean": Fault("nothing", 0.0),
    "carried": Fault("the robot is carried 10 s of its way further on", BEGIN),
    "wheels_0.7": Fault("wheels measure 0.7 times of each motion", 0.0,
                        lambda *_: changes.ScaledOdometry(0.7)),
    "wheels_1.3": Fault("wheels measure 1.3 times of each motion", 0.0,
                        lambda *_: changes.ScaledOdometry(1.3)),
    "ranges_0.8": Fault("ranges are 0.8 times the true ones", 0.0,
                        lambda *_: changes.ScaledRanges(0.8)),
    "ranges_1.2": Fault("ranges are 1.2 times the true ones", 0.0,
                        lambda *_: changes.ScaledRanges(1.2)),
    "bearings": Fault("bearings are 0.1 rad too large", 0.0,
                      lambda *_: changes.TurnedBearings(TURNED)),
    "odometry_stuck": Fault("odometry stands still for 10 s", BEGIN,
                            lambda *_: changes.ScaledOdometry(0.0, BEGIN, BEGIN + STUCK)),
    "odometry_jump": Fault("one message of odometry is 1e9 m off", BEGIN,
                           lambda *_: changes.OdometryJump(JUMP, BEGIN)),
    "false_ids": Fault("half of the ids are those of other landmarks", BEGIN, _false_ids,
                       (LANDMARKS,)),
    "landmarks_moved": Fault("each landmark moves by 0.5 m in a direction of its own", BEGIN, _moved,
                             (LANDMARKS,)),
    "laser_frozen": Fault("the laser repeats one scan", BEGIN,
                          lambda *_: changes.FrozenLaser(BEGIN), (SCANS,)),
    "laser_mirrored": Fault("the laser's beams come in the reverse order", BEGIN,
                            lambda *_: changes.MirroredLaser(BEGIN), (SCANS,)),
    "laser_constant": Fault("all beams of the laser have 2 m", BEGIN,
                            lambda *_: changes.ConstantLaser(CONSTANT, BEGIN), (SCANS,)),
}
