# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The faults of the benchmark adverse by name: what is wrong, from when on, for which sensor."""
import dataclasses
import math
import shutil

from slam_eval.bench.adverse import changes
from slam_eval.bench.harness import bag_edit, miscalibration
from slam_eval.bench.harness.hall_drives import LANDMARKS, SCANS, truth_of

BEGIN = 20.0     # of faults that are not there from the start [s]
STUCK = 10.0     # how long the odometry stands still [s]
CARRIED = 10.0   # the robot is carried as far as it would have driven in that time [s]
JUMP = 1e9       # [m]
FALSE = 0.5      # share of the ids
MOVED = 0.5      # [m]
TURNED = 0.1     # [rad]
CONSTANT = 2.0   # [m]


@dataclasses.dataclass(frozen=True)
class Fault:
    """What is wrong, in words; from when on [s]; put(source, target, seed) makes the bag of a drive
    with the fault of one without; sensors of the products that it concerns."""

    title: str
    begin: float
    put: object
    sensors: tuple = (LANDMARKS, SCANS)


def _edited(change_of):
    """put() of a Fault that changes messages. change_of(source, seed) makes a change."""
    def put(source, target, seed):
        return bag_edit.edit(source, target, change_of(source, seed))
    return put


def _always(change, *arguments):
    return _edited(lambda *_: change(*arguments))


def _carried(source, target, _):
    carried = bag_edit.Carried(BEGIN, BEGIN + CARRIED, math.inf)
    bag_edit.rewrite(source, target, carried=carried)


def _false_ids(bag, seed):
    return changes.FalseIds(changes.ids_in(bag), FALSE, seed, BEGIN)


def _moved(bag, seed):
    return changes.MovedLandmarks(truth_of(bag), MOVED, seed, BEGIN)


FAULTS = {
    "clean": Fault("nothing", 0.0, lambda source, target, _: shutil.copy(source, target)),
    "carried": Fault("the robot is carried 10 s of its way further on", BEGIN, _carried),
    "wheels_0.7": Fault("wheels measure 0.7 times each motion", 0.0,
                        _always(miscalibration.ScaledOdometry, 0.7)),
    "wheels_1.3": Fault("wheels measure 1.3 times each motion", 0.0,
                        _always(miscalibration.ScaledOdometry, 1.3)),
    "ranges_0.8": Fault("ranges are 0.8 times the true ones", 0.0,
                        _always(miscalibration.ScaledRanges, 0.8)),
    "ranges_1.2": Fault("ranges are 1.2 times the true ones", 0.0,
                        _always(miscalibration.ScaledRanges, 1.2)),
    "bearings": Fault("bearings are 0.1 rad too large", 0.0,
                      _always(miscalibration.TurnedBearings, TURNED)),
    "odometry_stuck": Fault("odometry stands still for 10 s", BEGIN,
                            _always(miscalibration.ScaledOdometry, 0.0, BEGIN, BEGIN + STUCK)),
    "odometry_jump": Fault("one message of odometry is 1e9 m off", BEGIN,
                           _always(changes.OdometryJump, JUMP, BEGIN)),
    "false_ids": Fault("half of the ids are those of other landmarks", BEGIN,
                       _edited(_false_ids), (LANDMARKS,)),
    "landmarks_moved": Fault("each landmark moves by 0.5 m in a direction of its own", BEGIN,
                             _edited(_moved), (LANDMARKS,)),
    "laser_frozen": Fault("the laser repeats one scan", BEGIN,
                          _always(changes.FrozenLaser, BEGIN), (SCANS,)),
    "laser_mirrored": Fault("the laser's beams come in the reverse order", BEGIN,
                            _always(changes.MirroredLaser, BEGIN), (SCANS,)),
    "laser_constant": Fault("all beams of the laser measure 2 m", BEGIN,
                            _always(changes.ConstantLaser, CONSTANT, BEGIN), (SCANS,)),
}
