# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages of detectors whose packages are not installed, their types made of the definitions."""
import math
import random

import genpy.dynamic
from geometry_msgs.msg import PoseWithCovarianceStamped, Transform
import rosbag
from std_msgs.msg import Header

APRILTAG, FIDUCIAL = "apriltag_ros/AprilTagDetectionArray", "fiducial_msgs/FiducialTransformArray"
LINE = "=" * 80
CAMERA = "camera_optical_frame"
SIZE = 0.16                # of a marker [m]
RATE, FARTHEST = 8.0, 4.0  # of the images [Hz], of a marker that is detected [m]
HALF_VIEW = 0.5            # of the camera [rad]
SIGMAS = (0.01, 0.002)     # of the distance, and across it, as shares of the distance


def joined(*parts):
    """A full definition: the text of the message, then (name, text) of those that it uses."""
    first, *others = parts
    return "\n".join([first, *(f"{LINE}\nMSG: {name}\n{text}" for name, text in others)])


DEFINITIONS = {
    APRILTAG: joined(
        "std_msgs/Header header\nAprilTagDetection[] detections\n",
        ("apriltag_ros/AprilTagDetection",
         "int32[] id\nfloat64[] size\ngeometry_msgs/PoseWithCovarianceStamped pose\n"),
        ("geometry_msgs/PoseWithCovarianceStamped", PoseWithCovarianceStamped._full_text)),
    FIDUCIAL: joined(
        "Header header\nint32 image_seq\nFiducialTransform[] transforms\n",
        ("fiducial_msgs/FiducialTransform",
         "int32 fiducial_id\ngeometry_msgs/Transform transform\nfloat64 image_error\n"
         "float64 object_error\nfloat64 fiducial_area\n"),
        ("std_msgs/Header", Header._full_text),
        ("geometry_msgs/Transform", Transform._full_text))}
CLASSES = {kind: genpy.dynamic.generate_dynamic(kind, text) for kind, text in DEFINITIONS.items()}


def empty_array(kind, stamp, frame):
    """An array without markers, and the class of what it holds by name."""
    array = CLASSES[kind][kind]()
    array.header.stamp, array.header.frame_id = stamp, frame
    return array, CLASSES[kind]


def apriltag_array(stamp, markers, frame=CAMERA):
    """An array of apriltag_ros; markers: (id or list of ids, (x, y, z) [m]), ..."""
    array, kinds = empty_array(APRILTAG, stamp, frame)
    for ids, position in markers:
        detection = kinds["apriltag_ros/AprilTagDetection"]()
        detection.id = ids if isinstance(ids, list) else [ids]
        detection.size = [SIZE] * len(detection.id)
        detection.pose.header = array.header
        pose = detection.pose.pose.pose
        pose.position.x, pose.position.y, pose.position.z = position
        pose.orientation.w = 1.0
        array.detections.append(detection)
    return array


def fiducial_array(stamp, markers, frame=CAMERA):
    """An array of aruco_detect; markers: (id, (x, y, z) [m]), ..."""
    array, kinds = empty_array(FIDUCIAL, stamp, frame)
    for identity, position in markers:
        each = kinds["fiducial_msgs/FiducialTransform"]()
        each.fiducial_id = identity
        at = each.transform.translation
        at.x, at.y, at.z = position
        each.transform.rotation.w = 1.0
        array.transforms.append(each)
    return array


def seen_from(pose, landmarks, chance):
    """(id, position in the optical frame) of what the simulated robot's camera detects, with noise.

    pose: the true (x, y, heading) of the robot; landmarks: {id: (x, y)} [m]. The camera looks ahead
    0.1 m before the middle of the robot, 0.3 m above the middles of the markers.
    """
    x, y, heading = pose
    found = []
    for identity, (at_x, at_y) in landmarks.items():
        dx, dy = at_x - x, at_y - y
        ahead = math.cos(heading) * dx + math.sin(heading) * dy - 0.1
        left = -math.sin(heading) * dx + math.cos(heading) * dy
        if ahead > 0.3 and math.hypot(ahead, left) < FARTHEST and \
                abs(math.atan2(left, ahead)) < HALF_VIEW:
            distance = math.hypot(ahead, left)
            scale = 1.0 + chance.gauss(0.0, SIGMAS[0])
            across = [chance.gauss(0.0, SIGMAS[1] * distance) for _ in range(2)]
            found.append((identity, (scale * -left + across[0], scale * 0.3 + across[1],
                                     scale * ahead)))
    return found


def with_detections(source, target, make=apriltag_array, topic="/tag_detections", seed=1):
    """A copy of a simulated drive that has the detections of a camera that looks ahead as well."""
    chance, landmarks, next_time = random.Random(seed), {}, 0.0
    with rosbag.Bag(str(source)) as bag, rosbag.Bag(str(target), "w") as out:
        for at, message, time in bag.read_messages():
            out.write(at, message, time)
            if at == "/ground_truth/landmarks":
                landmarks = {each.id: (each.x, each.y) for each in message.landmarks}
            if at == "/ground_truth/pose" and time.to_sec() >= next_time:
                next_time = time.to_sec() + 1.0 / RATE
                p, q = message.pose.position, message.pose.orientation
                pose = (p.x, p.y, 2.0 * math.atan2(q.z, q.w))
                out.write(topic, make(message.header.stamp, seen_from(pose, landmarks, chance)),
                          time)
    return target
