# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What was left out, counted by reason, with the sentence for each reason."""
import collections

SENTENCES = {
    "other_type": "{topic} carries {kind}; a bridge takes apriltag_ros/AprilTagDetectionArray or "
                  "fiducial_msgs/FiducialTransformArray",
    "unreadable": "a message of {kind} on {topic} cannot be read: {cause}",
    "no_stamp": "detections have no stamp; their detector must copy the stamp of the image",
    "no_frame": "detections name no frame; their detector must copy the frame of the image",
    "frame_change": "detections are in the frame {frame} and were in {before}: are there two "
                    "cameras on one topic?",
    "no_mount": "no transform leads from {base} to {frame}; publish the mount of the camera on "
                "/tf_static, or set camera.sensor_pose in the robot file",
    "moving_mount": "the transform from {parent} to {child} moves; only a camera that is fixed to "
                    "the robot can be used",
    "mount_change": "the mount of {frame} has changed; the new one is used",
    "bad_transform": "the transform from {parent} to {child} holds no rotation or no numbers; it "
                     "is left out",
    "bundle": "bundles of several tags have no id of their own and are left out",
    "bad_id": "a marker has the id {id}, and ids are not negative; it is left out",
    "other_frame": "marker {id} is in the frame {other} and its array in {frame}; it is left out",
    "not_finite": "marker {id} has a position that is not a number; it is left out",
    "behind_camera": "marker {id} lies behind the camera; positions must be in its optical frame, "
                     "whose z axis points ahead. It is left out",
    "too_steep": "marker {id} is straight above or below the camera, where its bearing cannot be "
                 "known; it is left out",
}
ONCE = {"bundle"}  # what a configuration causes with every image


class Account:
    """Counts by reason; say(reason, sentence) is called for each that is new or not in ONCE."""

    def __init__(self, say=lambda reason, sentence: None):
        self.counters = collections.Counter()
        self._say = say

    def add(self, reason, **values):
        """Counts what was left out; values: those that the reason's sentence names."""
        self.counters[reason] += 1
        if self.counters[reason] == 1 or reason not in ONCE:
            self._say(reason, SENTENCES[reason].format(**values))
