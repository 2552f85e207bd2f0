# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What each key of metrics.json means, and the table a terminal shows."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Key:
    """Name on paper, unit, number format and a one-sentence definition of a metric."""

    label: str
    unit: str
    form: str
    meaning: str
    group: str
    of_eval: bool = False


KEYS = {
    "ate_rmse_m": Key(
        "Absolute trajectory error", "m", ".4f",
        "Root mean square distance between estimated and true positions after a rigid alignment "
        "(no scale); poses in gaps of truth over 0.5 s are left out. Of truth without headings, such "
        "as GPS: at each fix, at the antenna.", "Accuracy", True),
    "ate_max_m": Key(
        "Largest trajectory error", "m", ".4f",
        "The largest of these distances.", "Accuracy", True),
    "ate_unaligned_rmse_m": Key(
        "Trajectory error, not aligned", "m", ".4f",
        "The same mean where truth is moved onto the estimate by its first pose, without a fit.",
        "Accuracy", True),
    "scale_error": Key(
        "Error of the scale", "", ".4f",
        "By which share the path is too large (negative: too small): 1 / s - 1, where s scales it in "
        "the similarity that fits it to truth best (Umeyama 1991).", "Accuracy", True),
    "ate_final_rmse_m": Key(
        "Trajectory error of the revised path", "m", ".4f",
        "The absolute trajectory error of the path as the back-end saw it at the end of the run.",
        "Accuracy", True),
    "rpe_trans_1s_m": Key(
        "Relative error, a second", "m", ".4f",
        "Relative pose error (Sturm et al. 2012): root mean square distance between estimated and "
        "true motion over all pieces of one second. Needs no alignment.", "Accuracy", True),
    "rpe_rot_1s_deg": Key(
        "Relative heading error, a second", "deg", ".3f",
        "Root mean square rotation error over the same pieces.", "Accuracy", True),
    "rpe_trans_1m_m": Key(
        "Relative error, a metre", "m", ".4f",
        "The same distance over all pieces of one metre of the true way.", "Accuracy", True),
    "rpe_rot_1m_deg": Key(
        "Relative heading error, a metre", "deg", ".3f",
        "Root mean square rotation error over the pieces of one metre.", "Accuracy", True),
    "odometry_ate_rmse_m": Key(
        "Dead reckoning", "m", ".4f",
        "The same error of the odometry alone: what the map has to improve on.", "Accuracy", True),
    "odometry_drift_percent": Key(
        "Drift of the odometry", "%", ".3f",
        "Mean translation error of the odometry over all pieces of 2 m of the true way, relative "
        "to them.", "Accuracy", True),
    "odometry_drift_deg_per_m": Key(
        "Drift of its heading", "deg/m", ".4f",
        "Mean rotation error of the odometry over the same pieces.", "Accuracy", True),
    "wheel_odometry_ate_rmse_m": Key(
        "Dead reckoning of the wheels", "m", ".4f",
        "The error of the wheels' odometry, which this run did not use.", "Accuracy", True),
    "wheel_odometry_drift_percent": Key(
        "Drift of the wheels", "%", ".3f",
        "As that of the odometry, of the wheels.", "Accuracy", True),
    "wheel_odometry_drift_deg_per_m": Key(
        "Drift of their heading", "deg/m", ".4f",
        "As that of the odometry, of the wheels.", "Accuracy", True),
    "landmark_rmse_m": Key(
        "Landmark error", "m", ".4f",
        "Root mean square distance between estimated and true landmarks, matched by id, after "
        "their own rigid alignment.", "Accuracy", True),
    "landmark_precision_percent": Key(
        "Landmarks that are there", "%", ".1f",
        "Share of the map's landmarks that are paired with a true one at most 0.5 m away, the map moved "
        "onto the truth by the alignment of the path; each in one pair at most, whatever their ids.",
        "Accuracy", True),
    "landmark_recall_percent": Key(
        "Landmarks that were found", "%", ".1f",
        "Share of all true landmarks, seen or not, that are in such a pair.", "Accuracy", True),
    "landmarks": Key(
        "Landmarks", "", "d", "Number of landmarks in the map at the end.", "Accuracy", True),
    "nees_mean": Key(
        "Mean NEES", "", ".2f",
        "Mean squared pose error in units of the covariance the filter claims; 3 is expected of a "
        "consistent filter, more means it is too sure of itself.", "Consistency", True),
    "nis_mean": Key(
        "Mean NIS per degree of freedom", "", ".3f",
        "Sum of the squared innovations in units of their covariance over the sum of their "
        "degrees of freedom; 1 is expected.", "Consistency", True),
    "places_recognised": Key(
        "Recognised places", "", "d",
        "Steps at which the run took itself to be where it had been more than 10 s before.",
        "Accuracy", True),
    "place_precision": Key(
        "Precision of recognised places", "", ".4f",
        "The share of these steps where the truth of both stamps is within 1 m.", "Accuracy", True),
    "place_recall": Key(
        "Recall of places", "", ".4f",
        "Of the steps whose true pose was within 0.5 m and 30 degrees of one more than 10 s before: "
        "the share that recognised the place rightly.", "Accuracy", True),
    "place_error_max_m": Key(
        "Largest error of a recognised place", "m", ".3f",
        "The largest true distance of a recognised place.", "Accuracy", True),
    "relations": Key(
        "Relations", "", "d",
        "Reference relations between two poses that the run has (Kuemmerle et al. 2009).",
        "Accuracy", True),
    "relations_trans_mean_m": Key(
        "Relations, translation", "m", ".4f",
        "Mean absolute translation error over the reference relations.",
        "Accuracy", True),
    "relations_trans_std_m": Key(
        "Relations, translation spread", "m", ".4f",
        "Standard deviation of the translation errors over the reference relations.",
        "Accuracy", True),
    "relations_rot_mean_deg": Key(
        "Relations, rotation", "deg", ".3f",
        "Mean absolute rotation error over the reference relations.",
        "Accuracy", True),
    "relations_unambiguous": Key(
        "Unambiguous relations", "", "d",
        "Those of the relations whose two stamps can mean one scan each only: exactly one lies "
        "within 10 ms.", "Accuracy", True),
    "relations_unambiguous_trans_mean_m": Key(
        "Unambiguous relations, translation", "m", ".4f",
        "Mean absolute translation error over the unambiguous relations.", "Accuracy", True),
    "relations_unambiguous_rot_mean_deg": Key(
        "Unambiguous relations, rotation", "deg", ".3f",
        "Mean absolute rotation error over the unambiguous relations.", "Accuracy", True),
    "relations_revisit": Key(
        "Revisit relations", "", "d",
        "Those of the relations that do not join neighbouring stamps: the robot came back.",
        "Accuracy", True),
    "relations_revisit_trans_mean_m": Key(
        "Revisit relations, translation", "m", ".4f",
        "Mean absolute translation error over the revisit relations.", "Accuracy", True),
    "relations_revisit_rot_mean_deg": Key(
        "Revisit relations, rotation", "deg", ".3f",
        "Mean absolute rotation error over the revisit relations.", "Accuracy", True),
    "map_area_m2": Key(
        "Area of the map", "m2", ".1f",
        "Area of the grid's cells that are free or occupied.", "Map", True),
    "map_entropy_bits": Key(
        "Entropy of the map", "bit", ".3f",
        "Mean entropy of the grid's known cells: 0 where all is certain, 1 where nothing is.",
        "Map"),
    "map_cells_on_walls_percent": Key(
        "Occupied cells on walls", "%", ".1f",
        "Occupied cells whose centre lies at most one cell from a true surface, the map moved onto "
        "the truth by a rigid fit of its path.", "Map", True),
    "map_walls_found_percent": Key(
        "Walls found", "%", ".1f",
        "The part of the true surfaces seen by the laser on its true way that has an occupied cell "
        "at most one cell away.", "Map", True),
    "points": Key("Points", "", "d", "Number of points in the point map at the end.", "Map", True),
    "points_wall_thickness_m": Key(
        "Thickness of the walls", "m", ".4f",
        "Width of the band across a true wall that holds the middle 90 % of its points, mean over "
        "the walls by their points.", "Map", True),
    "points_wall_error_m": Key(
        "Points off the walls", "m", ".4f",
        "Root mean square distance of the points from the nearest true surface; those more than "
        "0.3 m away belong to none.", "Map", True),
    "confidently_wrong_s": Key(
        "Confidently wrong", "s", ".2f",
        "Time for which the position was more than 0.3 m off and, by the covariance that was "
        "reported with it, more than 5 standard deviations (Mahalanobis distance); truth is moved "
        "onto the estimate by its first pose, without a fit.", "Consistency", True),
    "lost_s": Key(
        "Time lost", "s", ".2f",
        "Time for which the run reported the robot as lost, by its events.", "Consistency", True),
    "lost_missed": Key(
        "Losses that were missed", "", "d",
        "How often the pose was confidently wrong for more than 5 s on end.", "Consistency", True),
    "lost_false": Key(
        "False losses", "", "d",
        "How often the run reported the robot as lost while its position was at most 0.3 m off.",
        "Consistency", True),
    "doubtful_s": Key(
        "Time in doubt", "s", ".2f",
        "Time for which the run reported the pose as doubtful, by its events.", "Consistency"),
    "lost_alarms": Key(
        "Alarms that the robot is lost", "", "d",
        "How often the scans told that the pose is lost or the map wrong.", "Consistency"),
    "lost_first_s": Key(
        "First of these alarms", "s", ".1f",
        "When the first of them was raised, since the first step.", "Consistency"),
    "lost_share_of_time": Key(
        "Share of time lost", "", ".4f",
        "Share of the run's time for which such an alarm lasted.", "Consistency"),
    "doubtful_share_of_time": Key(
        "Share of time in doubt", "", ".4f",
        "Share of the run's time for which something spoke against the pose.", "Consistency"),
    "events": Key(
        "Events", "", "d",
        "Jumps, loops that moved the pose or were taken back, and times at which the robot was "
        "lost or found, or its pose in doubt.", "Consistency"),
    "largest_jump_m": Key(
        "Largest jump", "m", ".3f",
        "By how much one step moved the pose at most, beyond what odometry says.", "Consistency"),
    "updates": Key("Updates", "", "d", "Steps the back-end made.", "Cost"),
    "update_ms_p50": Key("Update time, median", "ms", ".3f",
                         "Half of the steps took less time than this.", "Cost"),
    "update_ms_p99": Key("Update time, 99 %", "ms", ".3f",
                         "99 of 100 steps took less time than this.", "Cost"),
    "latency_ms_p50": Key("Latency, median", "ms", ".2f",
                          "Work from an image, a scan or an array of observations to its pose: "
                          "detector and back-end. Half of the steps took less; waiting for motion "
                          "is not in it.", "Cost"),
    "latency_ms_p99": Key("Latency, 99 %", "ms", ".2f",
                          "99 of 100 steps took less than this.", "Cost"),
    "cpu_s": Key("CPU time", "s", ".2f",
                 "User and system time of the estimating process, reading the bag included.",
                 "Cost"),
    "wall_s": Key("Wall time", "s", ".2f", "Time from start to end of the run.", "Cost"),
    "realtime_factor": Key("Real-time factor", "", ".1f",
                           "Seconds of recorded data worked off in a second.", "Cost"),
    "max_rss_mb": Key("Memory", "MB", ".1f", "Largest resident memory of the process.", "Cost"),
    "dropped_messages": Key("Dropped messages", "", "d",
                            "Messages that were lost or came too late.", "Cost"),
}
GROUPS = ("Accuracy", "Map", "Consistency", "Cost")


def merge(stored, computed):
    """Stored metrics with the computed ones; a figure of an earlier evaluation does not survive."""
    kept = {k: v for k, v in stored.items() if not (k in KEYS and KEYS[k].of_eval)}
    return {**kept, **computed}


def format_value(key, value):
    """A value as text, without its unit."""
    form = KEYS[key].form
    if form == "d" and not float(value).is_integer():
        form = "g"
    return format(int(value) if form == "d" else float(value), form)


def rows(metrics, group):
    """(key, value) of one group, in the order of KEYS; values that are no number are left out."""
    return [(k, metrics[k]) for k, spec in KEYS.items() if spec.group == group
            and isinstance(metrics.get(k), (int, float)) and not isinstance(metrics[k], bool)]


def terminal_table(metrics):
    """The metrics as aligned lines of plain text."""
    lines = []
    for group in GROUPS:
        for key, value in rows(metrics, group):
            lines.append(f"  {KEYS[key].label:<32}{format_value(key, value):>12} {KEYS[key].unit}"
                         .rstrip())
    return "\n".join(lines)
