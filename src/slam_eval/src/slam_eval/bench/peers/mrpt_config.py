# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Configuration files of MRPT's kf-slam and simul-landmarks (2.x)."""
import dataclasses

# The 2-D configuration that MRPT ships for kf-slam.
SHIPPED_RANGE_SIGMA = 0.03  # [m]
SHIPPED_BEARING_SIGMA_DEG = 0.1


@dataclasses.dataclass(frozen=True)
class World:
    """A simulated world; noise as in MRPT's own 2-D demonstration."""

    landmarks: int
    steps: int = 600
    seed: int = 123
    path_side: int = 100           # steps a side of the square
    low: float = -10.0             # [m] of the box, in x and y
    high: float = 20.0             # [m]
    view_range: float = 6.0        # [m]
    view_angle_deg: float = 180.0
    odometry_sigma: float = 0.04   # [m] a step
    odometry_sigma_deg: float = 0.01
    range_sigma: float = 0.01      # [m]
    bearing_sigma_deg: float = 0.1

    @property
    def last_step(self):
        """Number of kf-slam's last step: actions are one fewer than frames, counted from 0."""
        return self.steps - 2


def _ini(sections):
    blocks = []
    for name, values in sections.items():
        blocks.append("\n".join([f"[{name}]", *(f"{k} = {v}" for k, v in values.items())]))
    return "\n\n".join(blocks) + "\n"


def simulation_ini(world, rawlog_name):
    """Configuration of simul-landmarks that writes rawlog_name into the current folder."""
    params = {
        "random_seed": world.seed, "nSteps": world.steps, "circularPath": 0,
        "squarePathLength": world.path_side, "loadLandmarksFromFile": "",
        "odometryNoiseXY_std": world.odometry_sigma,
        "odometryNoisePhi_std_deg": world.odometry_sigma_deg,
        "minSensorDistance": 0, "maxSensorDistance": world.view_range,
        "fieldOfView_deg": world.view_angle_deg, "stdRange": world.range_sigma,
        "stdYaw_deg": world.bearing_sigma_deg, "stdPitch_deg": 0.0,
        "outFile": rawlog_name, "outDir": ".", "show_in_3d": "false",
    }
    box = {"nLandmarks": world.landmarks, "min_x": world.low, "max_x": world.high,
           "min_y": world.low, "max_y": world.high, "min_z": 0, "max_z": 0}
    return _ini({"Params": params, "RANDOMSET_1": box})


def kf_slam_ini(last_step, range_sigma=SHIPPED_RANGE_SIGMA,
                bearing_sigma_deg=SHIPPED_BEARING_SIGMA_DEG):
    """Configuration of kf-slam: the shipped 2-D one, silent, saving only the last map in `map`."""
    application = {
        "kf_implementation": "CRangeBearingKFSLAM2D", "ground_truth_file": "",
        "ground_truth_file_robot": "", "logOutput_dir": "map", "SAVE_LOG_FREQUENCY": last_step,
        "SAVE_DA_LOG": "false", "SAVE_MAP_REPRESENTATIONS": "false", "SHOW_3D_LIVE": "false",
    }
    model = {
        "stdXY_no_odo": 0.1, "stdPhi_no_odo_deg": 2, "std_odo_z_additional": 0,
        "force_ignore_odometry": "false", "std_sensor_range": range_sigma,
        "std_sensor_yaw_deg": bearing_sigma_deg, "std_sensor_pitch_deg": 0.1,
        "quantiles_3D_representation": 3,
    }
    return _ini({"MappingApplication": application,
                 "RangeBearingKFSLAM_KalmanFilter": {"method": 0, "verbose": 0},
                 "RangeBearingKFSLAM": model})


def scene_name(last_step):
    """The file of kf-slam's folder that holds the map of the last step."""
    return f"kf_state_{last_step:05d}.3Dscene"
