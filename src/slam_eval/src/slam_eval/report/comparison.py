# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several products on the same data: a table of their figures and a page with all pictures."""
import dataclasses
import html
import pathlib

from slam_eval.report.metric_table import KEYS, format_value
from slam_eval.report.page import page, picture

COLUMNS = {"odometry_ate_rmse_m": "dead reckoning [m]", "ate_rmse_m": "ATE [m]",
           "landmark_rmse_m": "landmark RMSE [m]", "landmarks": "landmarks", "nees_mean": "NEES",
           "cpu_s": "CPU [s]", "max_rss_mb": "memory [MB]",
           "latency_ms_p50": "latency, median [ms]", "latency_ms_p99": "latency, 99 % [ms]"}
_NO_VALUE = "–"


@dataclasses.dataclass(frozen=True)
class Picture:
    """A figure of the page: a file (PNG or SVG), what it is called and what it shows."""

    path: pathlib.Path
    title: str
    caption: str


@dataclasses.dataclass(frozen=True)
class Chapter:
    """What the page says of one product."""

    name: str
    title: str
    text: str
    metrics: dict
    diagram: Picture
    pictures: list


def cells(metrics):
    """The texts of a row, in the order of COLUMNS."""
    return [format_value(key, metrics[key]) if key in metrics else _NO_VALUE for key in COLUMNS]


def text_table(chapters):
    """The table as aligned lines of plain text."""
    rows = [["", *COLUMNS.values()]] + [[c.name, *cells(c.metrics)] for c in chapters]
    turned = list(zip(*rows))  # a line a figure: nine columns do not fit a terminal
    widths = [max(map(len, column)) for column in zip(*turned)]
    return "\n".join("  ".join([row[0].ljust(widths[0]), *(
        text.rjust(width) for text, width in zip(row[1:], widths[1:]))]) for row in turned)


def _table(chapters):
    head = "".join(f"<th>{html.escape(name)}</th>" for name in ("product", *COLUMNS.values()))
    lines = "".join(
        f'<tr><td><a href="#{chapter.name}">{html.escape(chapter.name)}</a></td>'
        + "".join(f"<td>{text}</td>" for text in cells(chapter.metrics)) + "</tr>"
        for chapter in chapters)
    return (f'<section><h2>Results</h2><table class="compare"><tr>{head}</tr>{lines}</table>'
            '<p class="small"><a href="#meanings">What the columns mean</a></p></section>')


def _meanings():
    lines = "".join(f'<tr><td class="n">{html.escape(COLUMNS[key])}</td>'
                    f'<td class="m">{html.escape(KEYS[key].meaning)}</td></tr>' for key in COLUMNS)
    return f'<section id="meanings"><h2>The columns</h2><table>{lines}</table></section>'


def _chapter(chapter):
    shown = "".join(picture(p.path, p.title, f"{p.title}. {p.caption}") for p in chapter.pictures)
    shown = f'<div class="{"pair" if len(chapter.pictures) > 1 else "single"}">{shown}</div>'
    diagram = chapter.diagram
    return (f'<section id="{chapter.name}"><h2>{html.escape(chapter.title)}</h2>'
            f"<p>{html.escape(chapter.text)}</p>"
            + picture(diagram.path, diagram.title, f"{diagram.title}. {diagram.caption}", "diagram")
            + f'{shown}<p class="small"><a href="{chapter.name}/report.html">'
            "The whole report of this run</a></p></section>")


def render(title, remark, chapters):
    """The page as HTML text; it lies beside the runs' folders, which are named as the chapters."""
    return page(title, remark, [_table(chapters), *map(_chapter, chapters), _meanings()], "wide")
