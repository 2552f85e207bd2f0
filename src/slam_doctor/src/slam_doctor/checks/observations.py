# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Are observations of landmarks usable?"""
from slam_doctor.finding import error, ok, warn

FEW_INVALID = 0.001  # share of the observations, above: ERROR


def check(case):
    """Findings about the landmark sensor."""
    sensor = case.sensors.get("observations")
    if sensor is None:
        return []
    record, name = sensor.topic.record, sensor.topic.name
    if not record.seen:
        return [warn("observations.seen", f"{name}: no landmark is seen in {record.count} messages",
                     "Are landmarks in view, and does the detector know their family?", 0)]
    found = []
    for count, check_name, what in ((record.invalid, "observations.range", "ranges or bearings"),
                                    (record.bad_covariances, "observations.covariance",
                                     "covariances")):
        if count:
            make = error if count > FEW_INVALID * record.seen else warn
            found.append(make(check_name, f"{name}: {count} of {record.seen} observations have "
                              f"{what} that cannot be", "Correct the detector: they are left "
                              "out.", count,
                              "observations"))
    mean = record.seen / record.count
    return found or [ok("observations.seen", f"{name}: {mean:.1f} landmarks in a message, "
                        f"{len(record.ids)} ids", mean, "landmarks")]
