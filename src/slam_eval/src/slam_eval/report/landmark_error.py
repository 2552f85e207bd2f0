# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program landmark_error: maps against one truth file, ours and MRPT's in the same way."""
import argparse
import json
import pathlib
import sys

from slam_eval.io.errors import InputError
from slam_eval.io.mrpt_files import read_map
from slam_eval.metrics.landmark_comparison import compare


def _parse(arguments):
    parser = argparse.ArgumentParser(
        prog="landmark_error", description="Landmark errors of maps against one truth file, "
        "matched by id, in the frame of the start unless --align is given.")
    parser.add_argument("truth", metavar="TRUTH", type=pathlib.Path,
                        help="landmarks.yaml or the ground truth table of simul-landmarks")
    parser.add_argument("maps", metavar="MAP", type=pathlib.Path, nargs="+",
                        help="landmarks.yaml, or kf_state_NNNNN.3Dscene of kf-slam")
    parser.add_argument("--rawlog", metavar="FILE", type=pathlib.Path,
                        help="rawlog kf-slam was run on: gives its landmarks their ids")
    parser.add_argument("--align", action="store_true",
                        help="align each map rigidly to the truth first")
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    return parser.parse_args(arguments)


def _print_table(results):
    print(f"{'mean [m]':>10} {'rmse [m]':>10} {'max [m]':>10} {'matched':>9}  map")
    for path, r in results.items():
        print(f"{r['mean_m']:10.6f} {r['rmse_m']:10.6f} {r['max_m']:10.6f} "
              f"{r['matched']:4d}/{r['landmarks']:<4d}  {path}")


def main(arguments=None):
    """Entry point: exit code 0 done, 1 the comparison failed, 2 wrong use."""
    options = _parse(arguments)
    results = {}
    try:
        truth = read_map(options.truth)
        for path in options.maps:
            try:
                results[str(path)] = compare(read_map(path, options.rawlog), truth, options.align)
            except InputError as error:
                text = str(error)
                named = text if text.startswith(str(path)) else f"{path}: {text}"
                raise InputError(named) from None
    except InputError as error:
        print(f"landmark_error: {error}", file=sys.stderr)
        return 1
    if options.json:
        print(json.dumps(results, indent=2))
    else:
        _print_table(results)
    return 0
