# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mean landmark error of maps against one truth file, for ours and for MRPT's in the same way."""
import argparse
import json
import pathlib
import sys

import numpy as np

from slam_eval import se2
from slam_eval.errors import InputError
from slam_eval.landmarks import match_by_id, read_landmarks
from slam_eval.mrpt_files import read_kf_slam_map, read_truth_table


def read_map(path, rawlog=None):
    """A map by the ending of its name: .yaml (ours), .3Dscene (kf-slam), else MRPT's table."""
    if path.suffix in ('.yaml', '.yml'):
        return read_landmarks(path)
    if path.suffix == '.3Dscene':
        if rawlog is None:
            raise InputError(f'{path}: holds no landmark ids; give the rawlog kf-slam was run on '
                             'with --rawlog')
        return read_kf_slam_map(path, rawlog)
    return read_truth_table(path)


def compare(estimate, truth, align=False):
    """Error figures [m] of the landmarks both maps hold, as a dictionary."""
    ids, positions, true = match_by_id(estimate, truth)
    if len(ids) < (2 if align else 1):
        raise InputError('too few landmarks have an id that the truth file has too; '
                         'check that both belong to the same run')
    if align:
        positions = se2.transform_points(se2.align_rigid(positions, true), positions)
    errors = np.linalg.norm(positions - true, axis=1)
    return {'landmarks': len(estimate), 'matched': len(ids), 'mean_m': float(np.mean(errors)),
            'rmse_m': float(np.sqrt(np.mean(errors ** 2))), 'max_m': float(np.max(errors))}


def _parse(arguments):
    parser = argparse.ArgumentParser(
        prog='landmark_error', description='Landmark errors of maps against one truth file, '
        'matched by id, in the frame of the start unless --align is given.')
    parser.add_argument('truth', metavar='TRUTH', type=pathlib.Path,
                        help='landmarks.yaml or the ground truth table of simul-landmarks')
    parser.add_argument('maps', metavar='MAP', type=pathlib.Path, nargs='+',
                        help='landmarks.yaml, or kf_state_NNNNN.3Dscene of kf-slam')
    parser.add_argument('--rawlog', metavar='FILE', type=pathlib.Path,
                        help='rawlog kf-slam was run on: gives its landmarks their ids')
    parser.add_argument('--align', action='store_true',
                        help='align each map rigidly to the truth first')
    parser.add_argument('--json', action='store_true', help='print JSON instead of a table')
    return parser.parse_args(arguments)


def _print_table(results):
    print(f'{"mean [m]":>10} {"rmse [m]":>10} {"max [m]":>10} {"matched":>9}  map')
    for path, r in results.items():
        print(f'{r["mean_m"]:10.6f} {r["rmse_m"]:10.6f} {r["max_m"]:10.6f} '
              f'{r["matched"]:4d}/{r["landmarks"]:<4d}  {path}')


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
                named = text if text.startswith(str(path)) else f'{path}: {text}'
                raise InputError(named) from None
    except InputError as error:
        print(f'landmark_error: {error}', file=sys.stderr)
        return 1
    if options.json:
        print(json.dumps(results, indent=2))
    else:
        _print_table(results)
    return 0
