# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Detections become observations: by geometry done by hand, and what cannot be used is counted."""
import io
import math
import pathlib
import tempfile
import unittest

from detections_made import APRILTAG, apriltag_array, CAMERA, CLASSES, FIDUCIAL, fiducial_array
import genpy
from geometry_msgs.msg import TransformStamped
import numpy as np
from slam_bridges.account import Account, SENTENCES
from slam_bridges.converter import Converter
from slam_bridges.detections import Types
from slam_bridges.mounts import Mounts, pose_of_angles, pose_of_quaternion
from slam_bridges.robot import mounts_of
from slam_launch.errors import ProductError
from tf2_msgs.msg import TFMessage

STAMP = genpy.Time(1000, 5)
LOOKS_AHEAD = (-0.5, 0.5, -0.5, 0.5)  # quaternion of an optical frame whose z axis is the robot's x


def transform(parent, child, translation=(0.0, 0.0, 0.0), rotation=(0.0, 0.0, 0.0, 1.0)):
    """A message with one transform."""
    edge = TransformStamped(child_frame_id=child)
    edge.header.frame_id = parent
    for axis, number in zip("xyz", translation):
        setattr(edge.transform.translation, axis, number)
    for axis, number in zip("xyzw", rotation):
        setattr(edge.transform.rotation, axis, number)
    return TFMessage([edge])


class Bridge:
    """A Converter with what it says; its camera looks ahead, 0.2 m ahead and 0.1 m to the left."""

    def __init__(self, with_mount=True, fixed=None):
        self.sentences = []
        self.account = Account(lambda reason, sentence: self.sentences.append(sentence))
        self.mounts = Mounts("base_link", self.account, fixed)
        self.converter = Converter(self.mounts, self.account)
        if with_mount:
            self.mounts.take(transform("base_link", "head", (0.2, 0.1, 0.9)), True)
            self.mounts.take(transform("head", CAMERA, rotation=LOOKS_AHEAD), True)

    def take(self, *markers, stamp=STAMP, frame=CAMERA):
        """What becomes of a message of apriltag_ros."""
        return self.converter.convert("/tag_detections", APRILTAG,
                                      apriltag_array(stamp, markers, frame))


class Geometry(unittest.TestCase):
    def assert_seen(self, array, distance, bearing):
        self.assertEqual(len(array.observations), 1)
        self.assertAlmostEqual(array.observations[0].range, distance, places=9)
        self.assertAlmostEqual(array.observations[0].bearing, bearing, places=9)

    def test_straight_ahead(self):
        array = Bridge().take((7, (0.0, 0.0, 2.0)))
        self.assert_seen(array, 2.0, 0.0)
        self.assertEqual((array.header.stamp, array.header.frame_id), (STAMP, CAMERA))
        pose = array.sensor_pose
        self.assertEqual((round(pose.x, 9), round(pose.y, 9), pose.theta), (0.2, 0.1, 0.0))
        z = array.observations[0]
        self.assertEqual((z.id, z.kind, z.covariance[0]), (7, z.POINT, -1.0))
        self.assertEqual(list(z.descriptor), [])

    def test_to_the_right_and_below(self):
        # 3 m ahead, 4 m to the right: 5 m away in the plane, however far below
        self.assert_seen(Bridge().take((7, (4.0, 1.5, 3.0))), 5.0, -math.atan2(4.0, 3.0))

    def test_a_camera_that_looks_to_the_left_and_down(self):
        # about the robot's z axis by 90 degrees, and pitched down by 30
        bridge = Bridge(with_mount=False)
        turned = pose_of_angles((0.0, 0.3, 0.5, 0.0, math.pi / 6, math.pi / 2))
        optical = turned @ pose_of_quaternion((0.0, 0.0, 0.0, *LOOKS_AHEAD))
        bridge.mounts = Mounts("base_link", bridge.account, optical)
        bridge.converter = Converter(bridge.mounts, bridge.account)
        # 2 m along the axis of the camera: 2 cos 30 in the plane, to the left
        self.assert_seen(bridge.take((1, (0.0, 0.0, 2.0))), math.sqrt(3.0), math.pi / 2)

    def test_a_camera_that_looks_up(self):
        # a marker on the ceiling 2 m above, 1 m to the right in the image of a camera whose image's
        # right is the robot's right (-y) and whose z axis is the robot's: x ahead is image's up
        up = pose_of_angles((0.0, 0.0, 0.0, 0.0, 0.0, -math.pi / 2))
        bridge = Bridge(with_mount=False, fixed=up)
        self.assert_seen(bridge.take((1, (1.0, 0.0, 2.0))), 1.0, -math.pi / 2)
        self.assertEqual(bridge.take((1, (0.05, 0.0, 2.0))).observations, [])
        self.assertEqual(bridge.account.counters, {"too_steep": 1})

    def test_the_mount_of_a_robot_file_is_that_of_the_transform(self):
        fixed = pose_of_angles((0.2, 0.1, 0.9, -math.pi / 2, 0.0, -math.pi / 2))
        given = Bridge(with_mount=False, fixed=fixed).take((7, (0.3, 0.1, 2.0)))
        published = Bridge().take((7, (0.3, 0.1, 2.0)))
        self.assertAlmostEqual(given.observations[0].bearing, published.observations[0].bearing)
        self.assertAlmostEqual(given.sensor_pose.y, published.sensor_pose.y)

    def test_both_packages_say_the_same(self):
        markers = [(3, (0.5, 0.2, 2.0)), (4, (-0.5, 0.2, 1.0))]
        bridges = Bridge(), Bridge()
        first = bridges[0].take(*markers)
        second = bridges[1].converter.convert("/fiducial_transforms", FIDUCIAL,
                                              fiducial_array(STAMP, markers))
        self.assertEqual(first, second)
        self.assertEqual([z.id for z in second.observations], [3, 4])

    def test_empty_arrays_are_passed_on_and_all_are_numbered(self):
        bridge = Bridge()
        arrays = [bridge.take(), bridge.take((7, (0.0, 0.0, 2.0))), bridge.take()]
        self.assertEqual([len(array.observations) for array in arrays], [0, 1, 0])
        self.assertEqual([array.sequence for array in arrays], [0, 1, 2])
        self.assertEqual(arrays[2].header.frame_id, CAMERA)

    def test_an_empty_array_without_a_frame_is_of_the_camera_before(self):
        bridge = Bridge()
        bridge.take((7, (0.0, 0.0, 2.0)))
        self.assertEqual(bridge.take(frame="").header.frame_id, CAMERA)
        self.assertEqual(bridge.sentences, [])

    def test_rotations_of_angles_and_quaternions_agree(self):
        random = np.random.default_rng(1)
        for roll, pitch, yaw in random.uniform(-1.5, 1.5, (20, 3)):
            half = np.array([[math.cos(a / 2), math.sin(a / 2)] for a in (roll, pitch, yaw)])
            (cr, sr), (cp, sp), (cy, sy) = half
            quaternion = (sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
                          cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy)
            one = pose_of_angles((1.0, 2.0, 3.0, roll, pitch, yaw))
            self.assertTrue(one.is_near(pose_of_quaternion((1.0, 2.0, 3.0, *quaternion))))


class BadInput(unittest.TestCase):
    def assert_counted(self, bridge, reason, words, count=1):
        self.assertEqual(bridge.account.counters, {reason: count})
        self.assertIn(words, bridge.sentences[0])

    def test_markers_that_cannot_be_used_are_left_out_alone(self):
        nan = float("nan")
        for marker, reason, words in (
                ((7, (nan, 0.0, 2.0)), "not_finite", "marker 7 has a position that is not a"),
                ((7, (0.0, float("inf"), 2.0)), "not_finite", "marker 7"),
                ((7, (0.1, 0.0, -2.0)), "behind_camera", "marker 7 lies behind the camera"),
                ((7, (0.1, 0.0, 0.0)), "behind_camera", "whose z axis points ahead"),
                ((7, (0.0, 2.0, 0.01)), "too_steep", "marker 7 is straight above or below"),
                ((-1, (0.0, 0.0, 2.0)), "bad_id", "a marker has the id -1")):
            bridge = Bridge()
            array = bridge.take(marker, (8, (0.0, 0.0, 1.0)))
            self.assertEqual([z.id for z in array.observations], [8], reason)
            self.assert_counted(bridge, reason, words)

    def test_bundles_are_counted_and_said_once(self):
        bridge = Bridge()
        for _ in range(3):
            array = bridge.take(([1, 2, 3], (0.0, 0.0, 2.0)), (8, (0.0, 0.0, 1.0)))
            self.assertEqual([z.id for z in array.observations], [8])
        self.assert_counted(bridge, "bundle", "bundles of several tags", 3)
        self.assertEqual(len(bridge.sentences), 1)

    def test_a_marker_in_another_frame_than_its_array(self):
        message = apriltag_array(STAMP, [(7, (0.0, 0.0, 2.0)), (8, (0.0, 0.0, 1.0))])
        message.detections[0].pose.header = type(message.header)(frame_id="map")
        bridge = Bridge()
        array = bridge.converter.convert("/tag_detections", APRILTAG, message)
        self.assertEqual([z.id for z in array.observations], [8])
        self.assert_counted(bridge, "other_frame", "marker 7 is in the frame map and its array in")

    def test_another_type_of_message(self):
        bridge = Bridge()
        self.assertIsNone(bridge.converter.convert("/tags", "std_msgs/String", None))
        self.assert_counted(bridge, "other_type", "/tags carries std_msgs/String; a bridge takes")

    def test_a_message_of_a_known_name_with_other_fields(self):
        bridge = Bridge()
        self.assertIsNone(bridge.converter.convert("/tags", APRILTAG, fiducial_array(STAMP, [])))
        self.assert_counted(bridge, "unreadable", "cannot be read")

    def test_neither_stamp_nor_frame(self):
        for array, reason, words in (({"stamp": genpy.Time()}, "no_stamp", "have no stamp"),
                                     ({"frame": ""}, "no_frame", "name no frame")):
            bridge = Bridge()
            self.assertIsNone(bridge.take(**array))
            self.assert_counted(bridge, reason, words)

    def test_no_mount(self):
        bridge = Bridge(with_mount=False)
        self.assertIsNone(bridge.take((7, (0.0, 0.0, 2.0))))
        self.assert_counted(bridge, "no_mount", f"no transform leads from base_link to {CAMERA}")
        bridge.mounts.take(transform("base_link", "/" + CAMERA, rotation=LOOKS_AHEAD), True)
        self.assertEqual(bridge.take((7, (0.0, 0.0, 2.0))).sequence, 0, "none was lost")

    def test_transforms_in_a_circle_are_no_mount(self):
        bridge = Bridge(with_mount=False)
        bridge.mounts.take(transform("a", CAMERA), True)
        bridge.mounts.take(transform(CAMERA, "a"), True)
        self.assertIsNone(bridge.take())
        self.assert_counted(bridge, "no_mount", "no transform leads")

    def test_a_mount_on_tf_counts_while_it_stands_still(self):
        bridge = Bridge(with_mount=False)
        for _ in range(3):
            bridge.mounts.take(transform("base_link", CAMERA, rotation=LOOKS_AHEAD), False)
        self.assertIsNotNone(bridge.take())
        bridge.mounts.take(transform("base_link", CAMERA, (0.01, 0.0, 0.0), LOOKS_AHEAD), False)
        self.assertIsNone(bridge.take())
        self.assert_counted(bridge, "moving_mount", f"from base_link to {CAMERA} moves")

    def test_a_static_mount_that_changes(self):
        bridge = Bridge()
        bridge.take()
        bridge.mounts.take(transform("base_link", "head", (0.5, 0.1, 0.9)), True)
        self.assertAlmostEqual(bridge.take().sensor_pose.x, 0.5)
        self.assert_counted(bridge, "mount_change", f"the mount of {CAMERA} has changed")

    def test_two_cameras_on_one_topic(self):
        bridge = Bridge()
        bridge.mounts.take(transform("base_link", "rear", (-0.3, 0.0, 0.9), LOOKS_AHEAD), True)
        bridge.take()
        self.assertAlmostEqual(bridge.take(frame="rear").sensor_pose.x, -0.3)
        self.assert_counted(bridge, "frame_change", f"in the frame rear and were in {CAMERA}")

    def test_transforms_that_are_none(self):
        for values in ({"translation": (float("nan"), 0.0, 0.0)},
                       {"rotation": (0.0, 0.0, 0.0, 0.0)}, {"rotation": (1.0, 0.0, 0.0, 1.0)}):
            bridge = Bridge()
            bridge.mounts.take(transform("base_link", "head", **values), True)
            self.assertIsNotNone(bridge.take(), "the one before still counts")
            self.assert_counted(bridge, "bad_transform", "from base_link to head holds no rotation")

    def test_every_sentence_has_a_test_here(self):
        text = pathlib.Path(__file__).read_text(encoding="utf-8")
        self.assertEqual([reason for reason in SENTENCES if f'"{reason}"' not in text], [])


class Definitions(unittest.TestCase):
    def test_make_classes_of_packages_that_are_not_installed(self):
        for kind, make in ((APRILTAG, apriltag_array), (FIDUCIAL, fiducial_array)):
            message = make(STAMP, [(7, (0.1, 0.2, 0.3))])
            packed = packed_of(message)
            known = CLASSES[kind][kind]
            for _ in range(2):  # the second time by the class that is there
                again = Types().unpack(kind, known._md5sum, known._full_text, packed)
            self.assertEqual(packed_of(again), packed)

    def test_that_are_none_raise(self):
        for text in ("what is this", "Nothing[] of_this\n", "a/b/c d\n"):
            with self.assertRaises(genpy.MessageException):
                Types().unpack(APRILTAG, "*", text, b"")

    def test_that_are_empty_make_messages_that_are_counted(self):
        bridge = Bridge()
        message = Types().unpack(APRILTAG, "*", "", b"")
        self.assertIsNone(bridge.converter.convert("/tags", APRILTAG, message))
        self.assertEqual(bridge.account.counters, {"unreadable": 1})

    def test_data_that_are_cut_raise(self):
        known = CLASSES[APRILTAG][APRILTAG]
        data = packed_of(apriltag_array(STAMP, [(7, (0.1, 0.2, 0.3))]))
        with self.assertRaises(genpy.MessageException):
            Types().unpack(APRILTAG, known._md5sum, known._full_text, data[:-9])


def packed_of(message):
    """A message as it travels."""
    out = io.BytesIO()
    message.serialize(out)
    return out.getvalue()


class RobotFile(unittest.TestCase):
    def mounts(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "robot.yaml"
            path.write_text(f"version: 1\nrobot: r\n{text}\n", encoding="utf-8")
            return mounts_of(str(path), Account())

    def test_names_base_frame_and_mount(self):
        mounts = self.mounts("frames: {base: base_footprint}\n"
                             "camera: {sensor_pose: [0.1, 0.2, 0.3, 0, 0, 0]}")
        self.assertEqual(mounts.base, "base_footprint")
        self.assertAlmostEqual(mounts.of("any").translation[1], 0.2)

    def test_that_names_neither(self):
        for mounts in (self.mounts(""), mounts_of("", Account()), mounts_of(None, Account())):
            self.assertEqual(mounts.base, "base_link")
            self.assertIsNone(mounts.of("any"))

    def test_with_a_mount_that_is_none(self):
        for pose in ("[0.1, 0.2]", "[0, 0, 0, 0, 0, x]", "3", "[0, 0, 0, 0, 0, .nan]"):
            with self.assertRaisesRegex(ProductError, "camera.sensor_pose .* needs 6 numbers"):
                self.mounts(f"camera: {{sensor_pose: {pose}}}")

    def test_that_is_not_there(self):
        with self.assertRaisesRegex(ProductError, "there is no robot 'nobody'"):
            mounts_of("nobody", Account())


if __name__ == "__main__":
    unittest.main()
