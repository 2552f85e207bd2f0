# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""`./slam compare RUN RUN ...`: the figures, settings and pictures of runs side by side."""
import argparse
import contextlib
import html
import os
import pathlib

from slam_eval.io.atomic_file import write_atomically
from slam_eval.io.errors import exit_code_of, InputError
from slam_eval.io.run_folder import read_run
from slam_eval.report.cli import evaluate_folder
from slam_eval.report.metric_table import format_value, GROUPS, KEYS
from slam_eval.report.page import page, picture
from slam_eval.report.run_origin import origin_rows
from slam_eval.report.run_report import CAPTIONS

NO_VALUE = "–"
LEAST, MOST = 2, 12  # runs on a page


def names_of(folders):
    """The shortest ends of the paths that tell the runs apart."""
    parts = [folder.resolve().parts for folder in folders]
    for depth in range(1, max(map(len, parts)) + 1):
        names = ["/".join(p[-depth:]) for p in parts]
        if len(set(names)) == len(names):
            return names
    raise InputError("the same run is given twice; name each folder once")


def settings(config, prefix=""):
    """A nested configuration as flat names and texts."""
    flat = {}
    for key, value in config.items():
        if isinstance(value, dict) and value:
            flat.update(settings(value, f"{prefix}{key}."))
        else:
            flat[f"{prefix}{key}"] = str(value)
    return flat


def differences(configs):
    """The settings in which the runs differ: name and the value of each run. Where they come from
    is no setting."""
    flat = [settings({key: value for key, value in config.items() if key != "run"})
            for config in configs]
    names = sorted(set().union(*flat))
    found = {name: [f.get(name, NO_VALUE) for f in flat] for name in names}
    return {name: values for name, values in found.items() if len(set(values)) > 1}


def figures(metrics, group):
    """The rows of a group: label with unit, and the text of each run."""
    lines = []
    for key, spec in KEYS.items():
        values = [m.get(key) for m in metrics]
        is_number = [isinstance(v, (int, float)) and not isinstance(v, bool) for v in values]
        if spec.group == group and any(is_number):
            unit = f" [{spec.unit}]" if spec.unit else ""
            lines.append((spec.label + unit, [format_value(key, v) if known else NO_VALUE
                                              for v, known in zip(values, is_number)]))
    return lines


def text_table(names, lines):
    """Aligned lines of plain text."""
    rows = [("", names), *lines]
    first = max(len(label) for label, _ in rows)
    widths = [max(len(cells[i]) for _, cells in rows) for i in range(len(names))]
    return "\n".join("  ".join([label.ljust(first), *(
        cell.rjust(width) for cell, width in zip(cells, widths))]).rstrip()
        for label, cells in rows)


def _table(names, groups):
    """One that is scrolled where the screen is narrow. groups: title and rows of each."""
    head = "".join(f"<th>{html.escape(name)}</th>" for name in ("", *names))
    text = ""
    for title, lines in groups:
        if title and lines:
            text += f'<tr><th colspan="{1 + len(names)}">{html.escape(title)}</th></tr>'
        for label, cells in lines:
            text += f"<tr><td>{html.escape(label)}</td>" + "".join(
                f"<td>{html.escape(cell)}</td>" for cell in cells) + "</tr>"
    return f'<div class="scroll"><table class="compare"><tr>{head}</tr>{text}</table></div>'


def origins(runs):
    """The rows of where each run comes from; empty where none has noted it."""
    known = [dict(origin_rows(run.metrics)) for run in runs]
    names = dict.fromkeys(name for each in known for name in each)
    return [(name, [each.get(name, NO_VALUE) for each in known]) for name in names]


def _origin_section(names, runs):
    rows = origins(runs)
    return f"<section><h2>Origin</h2>{_table(names, [('', rows)])}</section>" if rows else ""


def _pictures(name, folders, names):
    title, caption = CAPTIONS[name]
    shown = [picture(folder / name, f"{title} of {run}", run)
             for folder, run in zip(folders, names) if (folder / name).exists()]
    if not shown:
        return ""
    return (f"<section><h2>{title}</h2><p>{caption}</p>"
            f'<div class="pair">{"".join(shown)}</div></section>')


def render(folders, names, runs):
    """The page as HTML text."""
    groups = [(group, figures([run.metrics for run in runs], group)) for group in GROUPS]
    unlike = differences([run.config for run in runs])
    changed = (_table(names, [("", list(unlike.items()))]) if unlike
               else "<p>The configuration is the same in all of them.</p>")
    sections = [f"<section><h2>Figures</h2>{_table(names, groups)}</section>",
                f"<section><h2>Settings that differ</h2>{changed}</section>",
                *(_pictures(name, folders, names) for name in CAPTIONS),
                _origin_section(names, runs)]
    remark = " · ".join(f"{name}: {run.title}" for name, run in zip(names, runs))
    return page("Runs side by side", remark, sections, "wide")


def evaluated(folder):
    """The run, with the figures and pictures of `./slam eval`, which is called where it was not."""
    if not (folder / "report.html").exists() and folder.is_dir():
        with open(os.devnull, "w", encoding="ascii") as silence, \
                contextlib.redirect_stdout(silence):
            evaluate_folder(folder)
    return read_run(folder)


def compare(folders, out):
    """Writes the page, and prints the figures."""
    names = names_of(folders)
    runs = [evaluated(folder) for folder in folders]
    write_atomically(out, render(folders, names, runs))
    lines = [line for group in GROUPS for line in figures([run.metrics for run in runs], group)]
    print(text_table(names, lines))
    print(f"report: {out}")


def main(arguments=None):
    """Entry point: exit code 0 done, 1 the comparison failed, 2 wrong use."""
    parser = argparse.ArgumentParser(
        prog="slam_compare", description="Shows the figures, settings and pictures of runs side "
        "by side, on one page. A run that was not evaluated yet is.")
    parser.add_argument("folders", metavar="RUN", nargs="+", type=pathlib.Path,
                        help="folder that a run wrote")
    parser.add_argument("--out", metavar="FILE", type=pathlib.Path,
                        default=pathlib.Path("comparison.html"),
                        help="the page to write (%(default)s)")
    options = parser.parse_args(arguments)
    if not LEAST <= len(options.folders) <= MOST:
        parser.error(f"give {LEAST} to {MOST} folders of runs")
    return exit_code_of("slam_compare", lambda: compare(options.folders, options.out), options.out)
