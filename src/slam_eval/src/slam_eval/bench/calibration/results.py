# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the benchmark calibration, and what they are to reach."""
import numpy as np

from slam_eval.bench.calibration.cases import BOTH_SCALES, CASES, RIGHT
from slam_eval.bench.harness.error import Failure
from slam_eval.bench.harness.table import number, table

WRONG, CALIBRATING, WRITTEN = "as_it_is", "calibrating", "written"  # runs of a case
MOST_RATIO = 1.3      # of ATE to that of the right robot file
SIGMAS = 3.0          # within which a parameter is right
LEAST_WITHIN = 0.95   # of all parameters
LEAST_SIGMA = 0.9     # of the sigma that the priors leave to scales that no drive tells

RUN_HEADER = ["case", "run", "ATE [m]", "to right", "worst", "NEES", "worst NEES", "wrong [s]",
              "worst [s]", "revised [m]", "revised to right", "failed"]
PARAMETER_HEADER = ["case", "parameter", "true", "found", "sigma", "sigma before", "error [sigmas]",
                    "worst", "within 3"]
REMARK = (
    f"Medians over the seeds, but for the worst. Runs: `{WRONG}`: nothing is estimated; "
    f"`{CALIBRATING}`: the robot file is wrong and what the case names is estimated; `{WRITTEN}`: "
    "again with the robot file that this run wrote, nothing estimated. ATE: aligned; to right: "
    f"over that of the case `{RIGHT}` with the same seed. NEES: its mean over time; 3 is expected. "
    "Revised: ATE of the path as known at the end, where the product has one. "
    "Wrong: time confidently wrong, as `confidently_wrong_s` of the evaluation. Of parameters: "
    "what is right, what was found, and its reported standard deviation; error [sigmas]: root mean "
    f"square over the seeds; within 3: in how many runs the error is at most {SIGMAS:g} sigmas. "
    "Where base and drift of the wheels are not estimated, they are wrong besides, as the wheels "
    "of the simulated robot are: by the true values that the case `clean` has.")


def _median(values):
    return float(np.median(values)) if values else None


def outcomes(seeds, run):
    """[(index of the seed, Outcome)] of the runs of that kind that came to their end."""
    return [(i, seed.runs[run]) for i, seed in enumerate(seeds)
            if not isinstance(seed.runs.get(run, Failure("")), Failure)]


def failures(seeds, run):
    """The Failures among the runs of that kind."""
    return [seed.runs[run] for seed in seeds if isinstance(seed.runs.get(run), Failure)]


def ratios(seeds, run, right):
    """[(ratio of ATE to that of the right robot file, number of the seed)]; right: the Outcome or
    Failure of each seed."""
    return [(outcome.ate / right[i].ate, i + 1) for i, outcome in outcomes(seeds, run)
            if not isinstance(right[i], Failure)]


def revised_ratios(seeds, run, right):
    """The same of ATE of the revised paths, where there are any."""
    return [(outcome.revised / right[i].revised, i + 1) for i, outcome in outcomes(seeds, run)
            if outcome.revised is not None and not isinstance(right[i], Failure)]


def _run_row(name, run, seeds, right):
    ended = [outcome for _, outcome in outcomes(seeds, run)]
    of_right = [ratio for ratio, _ in ratios(seeds, run, right)]
    nees, wrong = [o.nees for o in ended], [o.wrong for o in ended]
    return [name, run, number(_median([o.ate for o in ended]), ".4f"),
            number(_median(of_right), ".2f"), number(max(of_right, default=None), ".2f"),
            number(_median(nees), ".3g"), number(max(nees, default=None), ".3g"),
            number(_median(wrong), ".1f"), number(max(wrong, default=None), ".1f"),
            number(_median([o.revised for o in ended if o.revised is not None]), ".4f"),
            number(_median([ratio for ratio, _ in revised_ratios(seeds, run, right)]), ".2f"),
            number(len(failures(seeds, run)) or None, "d")]


def run_table(results, right):
    """A line for each kind of run of each case. results: {case: [Seed]}."""
    return table(RUN_HEADER, [_run_row(name, run, seeds, right) for name, seeds in results.items()
                              for run in (WRONG, CALIBRATING, WRITTEN)
                              if any(run in seed.runs for seed in seeds)])


def errors_of(results):
    """{(case, parameter): [(error in sigmas, number of the seed)]}."""
    errors = {}
    for name, seeds in results.items():
        for i, seed in enumerate(seeds):
            for parameter, estimate in seed.estimates.items():
                errors.setdefault((name, parameter), []).append((estimate.sigmas, i + 1))
    return errors


def _within(errors):
    return sum(abs(error) <= SIGMAS for error, _ in errors)


def _parameter_row(name, parameter, seeds, errors):
    found = [seed.estimates[parameter] for seed in seeds if parameter in seed.estimates]
    return [name, parameter, number(_median([e.true for e in found]), ".4f"),
            number(_median([e.reported.value for e in found]), ".4f"),
            number(_median([e.reported.sigma for e in found]), ".2g"),
            number(found[0].reported.before, ".2g"),
            number(float(np.sqrt(np.mean([error ** 2 for error, _ in errors]))), ".2f"),
            number(max(errors, key=lambda e: abs(e[0]))[0], "+.2f"),
            f"{_within(errors)} of {len(errors)}"]


def parameter_table(results):
    """A line for each estimated parameter of each case."""
    return table(PARAMETER_HEADER, [_parameter_row(name, parameter, results[name], errors)
                                    for (name, parameter), errors in errors_of(results).items()])


def _word(is_reached):
    return "reached" if is_reached else "MISSED"


def _ratio_lines(results, run, right, what):
    """Whether the ATE of these runs keeps to its limit where what is wrong is observable."""
    of = {name: ratios(seeds, run, right) for name, seeds in results.items()
          if CASES[name].estimate and CASES[name].is_observable}
    single = [(ratio, name, seed) for name, found in of.items() for ratio, seed in found]
    if not single:
        return []
    medians = {name: _median([ratio for ratio, _ in found]) for name, found in of.items()}
    missed = [name for name, median in medians.items() if median is None or median > MOST_RATIO]
    kept = sum(ratio <= MOST_RATIO for ratio, *_ in single)
    worst, name, seed = max(single)
    lines = [f"- ATE {what} at most {MOST_RATIO:g} times that of the right robot file, median of "
             f"the seeds: {len(of) - len(missed)} of {len(of)} cases ({_word(not missed)}); of "
             f"single runs {kept} of {len(single)}, the worst {worst:.2f} times: {name}, seed {seed}"]
    return lines + [f"- above: {name}: {number(medians[name], '.2f')} times" for name in missed]


def _error_text(results, name, parameter, seed):
    estimate = results[name][seed - 1].estimates[parameter]
    return (f"seed {seed}: {estimate.reported.value:.5g} instead of {estimate.true:.5g}, sigma "
            f"{estimate.reported.sigma:.2g}, {estimate.sigmas:+.1f} sigmas")


def _parameter_lines(results):
    errors = errors_of(results)
    count, within = sum(map(len, errors.values())), sum(map(_within, errors.values()))
    if not count:
        return []
    share = within / count
    lines = [f"- parameters within {SIGMAS:g} reported standard deviations: {within} of {count}, "
             f"{100 * share:.1f} %, at least {100 * LEAST_WITHIN:g} % "
             f"({_word(share >= LEAST_WITHIN)})"]
    for (name, parameter), of in errors.items():
        if _within(of) < len(of):
            _, seed = max(of, key=lambda e: abs(e[0]))
            lines.append(f"- beyond {SIGMAS:g}: {name}, {parameter}: {len(of) - _within(of)} of "
                         f"{len(of)}; {_error_text(results, name, parameter, seed)}")
    return lines


def open_share(before):
    """What is left open of scales of which only the ratios are seen, as a share: the standard
    deviation by all of their priors together."""
    return float(np.sum(np.array(before) ** -2.0) ** -0.5)


def _scale_lines(results):
    """Observations tell how the scales of ranges and wheels, and the distance of the wheels, go
    together, and no more: all may be off by one factor."""
    tied = ("wheel_scale", "wheel_base", "range_scale")
    found = [[seed.estimates[name].reported for name in tied]
             for seed in results.get(BOTH_SCALES, ()) if seed.estimates]
    if not found:
        return []
    best = open_share([scale.before for scale in found[0]])
    least = min(scale.sigma / scale.value for of_seed in found for scale in of_seed)
    return [f"- {BOTH_SCALES}: sigmas of the scales and the base, as shares of them, at least "
            f"{LEAST_SIGMA:g} of {best:.3f}, which their priors together leave open: the smallest "
            f"is {least:.3f} ({_word(least >= LEAST_SIGMA * best)})"]


def _failed_lines(results):
    return [f"- failed: {name}, {run}: {len(failed)} of {len(seeds)} runs: {failed[0].sentence}"
            for name, seeds in results.items() for run in (WRONG, CALIBRATING, WRITTEN)
            if (failed := failures(seeds, run))]


def verdict_lines(results, right):
    """What is reached and what is not."""
    return "\n".join(_ratio_lines(results, CALIBRATING, right, "while it calibrates") +
                     _ratio_lines(results, WRITTEN, right, "with the written robot file") +
                     _parameter_lines(results) + _scale_lines(results) + _failed_lines(results))
