# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Do laser and odometry agree: direction, scale of ways and turns, the laser's heading, time?"""
import dataclasses

from slam_doctor.checks.laser import LASERS, named
from slam_doctor.finding import error, judged, ok, unknown, warn

FIRST = LASERS[0]
SCALE = (0.1, 0.2)      # of odometry, its distance from 1: WARN, ERROR
TURN_SCALE = (0.12, 0.25)
HEADING = (0.06, 0.2)   # of the laser's mount [rad]: WARN, ERROR
OFFSET = (0.05, 0.25)   # between the stamps [s]: WARN, ERROR
SURE = 3.0              # standard deviations that a difference must exceed
VAGUE = 0.03            # an offset that is known less well is not told [s]
MOST_VAGUE = 0.1        # and a scale [1]


def check(case):
    """Findings about scans against odometry. The scales of odometry are told of the first laser."""
    return [finding for name in LASERS if name in case.sensors and "odom" in case.sensors
            for finding in named(name, of_laser(case.laser(name), case))
            if name == FIRST or finding.check.startswith(name)]


def of_laser(laser, case):
    """Findings about the scans of one laser against odometry."""
    if laser.scans is None:
        return [unknown("scan.odometry", "scans cannot be held against odometry",
                        "Record both for longer.")]
    return [*turning(laser, case), *driving(laser, case), timing(laser)]


def turning(laser, case):
    """The direction of the laser and the scale of turns."""
    turns = laser.turns
    if turns is None:
        return [unknown("scan.direction", "too few turns on the spot to see the laser's direction",
                        "Turn by half a turn either way, slowly, while recording.")]
    total = turns.same + turns.opposite
    if turns.opposite >= 0.7 * total:
        return [error("scan.direction", f"the scans turn against odometry in {turns.opposite} of "
                      f"{total} turns: the laser is mirrored, or odometry's sign is wrong", "Is "
                      "the laser mounted upside down (give its mount a roll of pi), are its beams "
                      "in reverse order, or are the wheels exchanged?", -turns.turn.value, "1")]
    if turns.same < 0.7 * total:
        return [warn("scan.direction", f"the scans turn with odometry in only {turns.same} of "
                     f"{total} turns", "Look at the scans in RViz in the frame odom while the "
                     "robot turns: walls must stand still.", turns.same / total, "1")]
    return [ok("scan.direction", f"laser and odometry turn the same way in {turns.same} of {total} "
               "turns"),
            scale("odom.turn_scale", "turn", "rotation_scale", turns.turn, TURN_SCALE, case)]


def scale(check_name, what, key, ratio, limits, case):
    """Odometry's ways or turns over those of the scans. ratio: true over odometry's, which is what
    the robot file's scale is."""
    if ratio.value < 0:
        return error(check_name, "odometry drives backwards while the scans drive forwards",
                     "Exchange the sign of the wheels, or turn the laser's mount by pi.",
                     1.0 / ratio.value, "1")
    told = float(case.robot.value("wheel_odometry", key) or 1.0)
    # The ratio is that of odometry, after the robot file's scale, to the scans.
    measured = told / ratio.value
    sigma = ratio.sigma * measured / ratio.value
    text = (f"odometry tells {measured:.3f} +- {sigma:.3f} times the {what} that the scans show "
            f"({ratio.count} pairs)")
    if sigma > MOST_VAGUE:
        return unknown(check_name, text, f"Record more {what}s among walls and furniture.")
    off = abs(measured - 1.0)
    sure = off if off > SURE * sigma else 0.0
    finding = judged(check_name, text, f"Set wheel_odometry.{key}: {ratio.value:.3f} in the robot "
                     "file, or correct the radius and distance of the wheels in the driver.", sure,
                     limits)
    return dataclasses.replace(finding, value=measured, unit="1")


def driving(laser, case):
    """The scale of ways and the heading of the laser's mount."""
    drives = laser.drives
    if drives is None:
        return [unknown("odom.scale", "too few straight drives to compare odometry's ways with the "
                        "scans",
                        "Drive two metres straight on towards something that is not a bare "
                        "corridor.")]
    found = [scale("odom.scale", "way", "translation_scale", drives.way, SCALE, case)]
    heading = drives.heading
    if heading is not None and drives.way.value > 0:
        value, sure = heading.value, abs(heading.value) > SURE * heading.sigma
        text = f"straight drives point {value:+.3f} +- {heading.sigma:.3f} rad off in the scans"
        found.append(judged("scan.heading", text, "Turn the laser's mount by "
                            f"{-value:+.3f} rad (yaw), or look whether the robot pulls to one "
                            "side.", abs(value) if sure else 0.0, HEADING, "rad"))
    return found


def timing(laser):
    """The offset in time between the stamps of scans and odometry."""
    offset = laser.offset
    if offset is None or offset.sigma > VAGUE:
        return unknown("scan.offset", "the turns do not tell the offset in time between scans and "
                       "odometry", "Turn left and right some times while recording, with scans at "
                       "5 Hz or more.")
    value = 1000 * offset.value
    text = (f"scans are stamped {abs(value):.0f} +- {1000 * offset.sigma:.0f} ms "
            f"{'later' if value > 0 else 'earlier'} than odometry for the same moment")
    sure = abs(offset.value) if abs(offset.value) > SURE * offset.sigma else 0.0
    finding = judged("scan.offset", text, "Stamp data when they are taken, not when they arrive; a "
                     "serial laser comes late by the time of its transmission.", sure, OFFSET)
    return dataclasses.replace(finding, value=value, unit="ms")
