# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Are the topics there that products need, and do robot file and recording go together?"""
from slam_doctor.finding import error, ok, unknown, warn
from slam_doctor.sensors import MESSAGES


def check(case):
    """Findings about robot file, topics and products."""
    found = [robot_file(case), *marker_size(case)]
    found += [named(case.sensors[name], case) for name in case.sensors]
    found += needs_of(case) if case.expectations.product else [products(case)]
    found += unreadable(case)
    return found


def robot_file(case):
    """Which robot file counts."""
    robot = case.robot
    if not robot.name:
        return unknown("robot", f"{robot.fault or 'no robot file is named'}; defaults count",
                       "Name the robot with --robot NAME or FILE, so that its topics, mounts and "
                       "sizes are checked.")
    if robot.fault:
        return error("robot", f"robot file {robot.name}: {robot.fault}",
                     "Correct the robot file; docs/parameters.md lists what it may hold.")
    return ok("robot", f"robot file {robot.name}")


def marker_size(case):
    """Whether the edge of a marker is one in metres."""
    size = (case.robot.content.get("fiducial") or {}).get("marker_size")
    if not isinstance(size, (int, float)) or isinstance(size, bool):
        return []
    text = f"fiducial.marker_size: {size:g} m"
    meant = meant_size(size)
    if meant:
        return [error("marker.size", f"{text} is no size of a marker",
                      f"Did you mean {meant:.3f} m? Sizes are in metres, measured along the edge "
                      "of the black square.", size, "m")]
    if not 0.01 <= size <= 1.0:
        return [warn("marker.size", f"{text} is unusual",
                     "Measure the edge of the black square; the size is in metres.", size, "m")]
    return [ok("marker.size", text, size, "m")]


def meant_size(size):
    """The size in metres that was given in millimetres or centimetres, or None."""
    if size >= 20:
        return size / 1000.0
    return size / 100.0 if size > 2 else None


def named(sensor, case):
    """Where an input was found."""
    text = f"{sensor.name}: {sensor.topic.name} ({sensor.topic.kind})"
    if sensor.topic.name.startswith("/tf "):
        return ok(f"{sensor.name}.topic", text)
    if sensor.is_elsewhere() and case.recording.is_live:
        return warn(f"{sensor.name}.topic", f"{text}, expected on {sensor.expected}",
                    f"Give {sensor.name}_topic:={sensor.topic.name} to slam.launch, or name it in "
                    "the section topics of the robot file.")
    if sensor.is_elsewhere():
        text += f", the only one of its type; expected on {sensor.expected}"
    return ok(f"{sensor.name}.topic", text)


def missing(product, case):
    """The needs of a product that nothing fills."""
    there = {kind for kind, types in MESSAGES.items()
             if any(sensor.topic.kind in types for sensor in case.sensors.values())}
    there |= {kind for kind, types in MESSAGES.items() if case.recording.of_kind(*types)
              and kind in ("slam::Motion", "slam::LandmarkObservationArray")}
    return [need for need in product.needs if need.is_mandatory and
            need.input not in case.sensors and not need.replaced_by & there]


def needs_of(case):
    """What the chosen product lacks."""
    product = case.expectations.product
    lacks = missing(product, case)
    topics = case.expectations.inputs()
    if not lacks:
        return [ok("product", f"{product.name} has all inputs that it needs")]
    return [error(f"{need.input}.topic", f"{product.name} needs {need.sentence} on "
                  f"{topics[need.input]}, nothing comes there",
                  candidates(need, case)) for need in lacks]


def candidates(need, case):
    """What to do about a missing input."""
    kinds = MESSAGES.get(need.kind, ())
    names = [topic.name for topic in case.recording.of_kind(*kinds)]
    if names:
        return f"Choose one of {', '.join(names)} with --remap {need.input}:={names[0]}."
    return "Start its driver and record its topic, or take a product that does without."


def products(case):
    """Which products the recording suffices for."""
    able = [product.name for product in case.expectations.products if not missing(product, case)]
    if not able:
        return error("product", "no product can run on these topics",
                     "Record odometry (nav_msgs/Odometry), a laser (sensor_msgs/LaserScan), or a "
                     "camera with its camera_info; ask for one product with --product NAME.")
    return ok("product", f"inputs suffice for {', '.join(able)}", len(able), "products")


def unreadable(case):
    """Messages that could not be unpacked."""
    return [error("messages", f"{count} messages of {topic} cannot be read",
                  "The recording is damaged, or its messages are of another version; record it "
                  "anew.", count, "messages")
            for topic, count in case.recording.unreadable.items()]
