# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tests of a build: those of catkin packages, and slam_core's as a plain CMake project."""

import functools
import os
import pathlib
import re
import shutil
import subprocess

from runner.results import list_tests, read_catkin, read_junit

JOBS = f"-j{len(os.sched_getaffinity(0))}"
TIMEOUT = 900  # [s], a test that takes longer hangs
PART_SIZE = 60  # cases of a sanitized program that run together
LIVE = r"_rostest_|_nosetests_(test\.)?(launch|two_machines|docs\.test_commands)"  # by the wall clock
# Long drives and many runs, for the sake of what comes of them in the mean: left out of the
# sanitized core, where they take minutes and other tests of the same code serve as well.
STATISTICS = ("*FindsTheNoiseOfASimulatedLog*:*TellsUncertaintiesThatHoldTheTruth*:"
              "*MarkerPoseMonteCarlo*:FastSlamConsistency.*:*IsAsWrongAsItSays*:"
              "NoiseTunerTest.FindsTheSame*:NoiseTunerTest.KeepsWhat*:NoiseTunerTest.IsNotMisled*:"
              "*SelfCalibration*.IsNearly*:*SelfCalibration*.KnowsHowWell*:"
              "SystematicErrorTest.*:LostOnAGrid.*:MatchingInARoom.ARobotCarried*:"
              "Aisles.*:*WoodOfPairs.*:*LostByPlace.*:*LyingMarkers.*:HeadingDrift.*:"
              "PixelNoise.IsFound*:PixelNoise.Follows*:MonoState.IsConsistent*:"
              "*BackendContract.StaysWithTheRobot*:*LandmarkContract.ConvergesToAStaticWorld*")
# Gives way to tests that run by the wall clock. Each test has a session of its own; where the
# kernel groups processes by session, the nice value of the group counts.
BACKGROUND = ["sh", "-c", 'echo 19 2>/dev/null >/proc/$$/autogroup; exec nice -n 19 "$@"',
              "background"]


def in_space(space, command):
    """Returns a command that runs with a catkin space's setup.bash sourced."""
    return ["bash", "-c", 'source "$0/setup.bash" && PATH=/usr/bin:$PATH && exec "$@"', space,
            *command]


def catkin_tests(build, space=None):
    """Returns a build folder's tests, to run in the environment of a catkin space where one is
    given: catkin knows that of an overlay's underlay only where it was sourced."""
    results = build / "test_results"
    shutil.rmtree(results, ignore_errors=True)
    results.mkdir()
    tests = []
    for name, command, folder in list_tests(build):
        summary = next(pathlib.Path(word) for word in command if word.endswith(".xml"))
        tests.append({"name": name.replace("_ctest_", ""), "cwd": folder, "timeout": TIMEOUT,
                      "command": in_space(space, command) if space else command,
                      "read_cases": functools.partial(read_catkin, summary),
                      "live": bool(re.search(LIVE, name))})
    return tests


def build_core(report, title, source, build, options, target="all"):
    """Builds slam_core, or a target of it, as a plain CMake project, as where there is no ROS;
    returns whether it could."""
    options = [*options, "-DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON"]
    steps = (("configure", ["cmake", "-S", source, "-B", build, *options]),
             ("build", ["cmake", "--build", build, JOBS, "--target", target]))
    return all(report.run(f"{title}: {step}", BACKGROUND + command) for step, command in steps)


def core_tests(title, build, program="", **environment):
    """Returns the tests of a plain build of slam_core, or of one program. The parts of the largest
    programs come first, so that none of them is alone at the end."""
    parts = [part for test in list_tests(build) if program in ("", test[0])
             for part in program_tests(title, build, environment, *test)]
    return sorted(parts, key=lambda part: -int(part["env"]["GTEST_TOTAL_SHARDS"]))


def program_tests(title, build, environment, name, command, folder):
    """A program's tests in parts of about PART_SIZE, each a run of its own."""
    # a workspace that is sourced has libraries of the same names
    outside = {key: value for key, value in os.environ.items() if key != "LD_LIBRARY_PATH"}
    cases = subprocess.run([*command, "--gtest_list_tests"], env={**outside, **environment},
                           check=False, capture_output=True, text=True).stdout.count("\n  ")
    count = max(1, round(cases / PART_SIZE))
    tests = []
    for part in range(count):
        results = build / "test_results" / f"{name}_{part}.xml"
        results.unlink(missing_ok=True)
        extent = f" {part + 1}/{count}" if count > 1 else ""
        tests.append({"name": f"{title}: {name}{extent}", "command": BACKGROUND + command,
                      "cwd": folder, "timeout": TIMEOUT, "read_cases": functools.partial(
                          lambda path: read_junit(path) if path.exists() else [], results),
                      "env": {**outside, **environment, "GTEST_OUTPUT": f"xml:{results}",
                              "GTEST_TOTAL_SHARDS": str(count), "GTEST_SHARD_INDEX": str(part)}})
    return tests
