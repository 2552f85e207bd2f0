# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Is a laser's data usable by itself: angles, ranges, beams that tell something, frozen scans?"""
import dataclasses
import math
import re

import numpy as np

from slam_doctor.finding import error, judged, ok, unknown, warn

LASERS = ("scan", "rear_scan")  # the inputs that bring scans
USABLE = (0.1, 0.02)     # share of the beams that tell something, below: WARN, ERROR
FROZEN = 0.3             # odometry moves so far while a scan is repeated: ERROR [m or rad]
REPEATED = 2.0           # so long a repeat is told where nothing says whether the robot moved [s]


def check(case):
    """Findings about the lasers."""
    return [finding for name in LASERS for finding in of_laser(name, case)]


def of_laser(name, case):
    """Findings about the laser of an input."""
    record = case.record(name)
    if record is None or not record.count:
        return []
    return named(name, [geometry(record), beams(record), *constant(record),
                        *frozen(record, case)])


def named(name, findings):
    """Findings about scans, as those of the laser of an input."""
    return [dataclasses.replace(finding, check=re.sub("^scan(?=[.])", name, finding.check))
            for finding in findings]


def fault_of(shape):
    """What contradicts itself in a scan's header, or nothing."""
    values = (shape.angle_min, shape.angle_max, shape.increment, shape.range_min, shape.range_max)
    if not all(math.isfinite(value) for value in values[:4]) or math.isnan(shape.range_max):
        return "angles or range limits are no numbers"
    if shape.beams == 0:
        return "scans have no beams"
    if shape.increment == 0:
        return "angle_increment is zero"
    span = shape.angle_min + shape.increment * (shape.beams - 1)
    if abs(span - shape.angle_max) > 1.5 * abs(shape.increment) + 1e-4:
        return (f"{shape.beams} beams of {shape.increment:.4g} rad end at {span:.3f} rad, "
                f"angle_max is {shape.angle_max:.3f}")
    if abs(shape.increment) * (shape.beams - 1) > 2 * math.pi + 0.05:
        return "the beams go round more than once: are the angles in degrees?"
    if not 0 <= shape.range_min < shape.range_max:
        return (f"range_min {shape.range_min:g} m and range_max {shape.range_max:g} m enclose "
                "nothing")
    return ""


def geometry(record):
    """Whether the header's angles and limits agree with the ranges."""
    shape = record.geometry()
    bad = [(fault_of(each), count) for each, count in record.geometries.items() if fault_of(each)]
    if bad:
        count = sum(number for _, number in bad)
        return error("scan.angles", f"{bad[0][0]} ({count} of {record.count} scans)",
                     "Correct the laser's driver or its parameters; the map would be bent.", count,
                     "scans")
    degrees = math.degrees(abs(shape.increment) * (shape.beams - 1))
    text = (f"{shape.beams} beams over {degrees:.0f} deg, {shape.range_min:.2g} to "
            f"{shape.range_max:.3g} m")
    if record.geometries[shape] < 0.9 * record.count:
        return warn("scan.angles", f"{text}; scans have {len(record.geometries)} different headers",
                    "Look for two lasers on one topic.", len(record.geometries), "headers")
    return ok("scan.angles", text, degrees, "deg")


def beams(record):
    """How many beams tell something."""
    share = float(np.median(record.usable.array()))
    text = f"{100 * share:.0f} % of the beams hit something within range"
    if record.without_points:
        text += f", {record.without_points} of {record.count} scans have none that does"
    return judged("scan.beams", text, "Is the laser covered, are range_min and range_max right, is "
                  "the room larger than its range?", 1.0 - share, (1 - USABLE[0], 1 - USABLE[1]))


def constant(record):
    """Scans whose beams all measure the same."""
    if record.constant <= 0.01 * record.count:
        return []
    return [error("scan.constant", f"in {record.constant} of {record.count} scans all beams "
                  "measure the same", "The driver makes data up, or the laser is covered: look at "
                  "the scans in RViz.", record.constant, "scans")]


def frozen(record, case):
    """Scans that are repeated while the robot moves."""
    repeats = [(end - begin, begin, end) for begin, end in record.repeats()]
    if not repeats:
        return [ok("scan.frozen", "no scan is repeated")]
    longest, begin, _ = max(repeats)
    if case.path is None:
        if longest < REPEATED:
            return [ok("scan.frozen", "no scan is repeated for long")]
        return [unknown("scan.frozen", f"the same scan comes for {longest:.1f} s at {begin:.1f} s",
                        "Did the robot stand? Noise makes scans differ even then: look at the "
                        "driver.")]
    moved = [moved_in(case.path, *times) for _, *times in repeats]
    worst = int(np.argmax(moved))
    if moved[worst] > FROZEN:
        time, begin, _ = repeats[worst]
        return [error("scan.frozen", f"the laser repeats one scan for {time:.1f} s at {begin:.1f} "
                      f"s, while odometry moves by {moved[worst]:.2f} m or rad", "Restart the "
                      "laser's driver and look at its cable.", time, "s")]
    return [ok("scan.frozen", "scans are repeated only where the robot stands")]


def moved_in(path, begin, end):
    """The way and turn of odometry between two stamps, the larger of both [m or rad]."""
    at = (path.stamps >= begin) & (path.stamps <= end)
    if at.sum() < 2:
        return 0.0
    way = float(np.hypot(np.diff(path.x[at]), np.diff(path.y[at])).sum())
    return max(way, float(np.ptp(path.heading[at])))
