# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of a campaign, its pictures and its table on a terminal."""
import collections
import html
import math

from slam_eval.campaign.results import DONE, FAILED, MISSING
from slam_eval.io.run_folder import read_run
from slam_eval.plot.campaign import plot_paths, plot_values
from slam_eval.report.metric_table import format_value, KEYS
from slam_eval.report.page import page, picture

NO_VALUE = "–"
_LEVEL = 0.05  # of the corrected p below which a line is marked


def _label(metric):
    unit = KEYS[metric].unit
    return KEYS[metric].label + (f" [{unit}]" if unit else "")


def _number(metric, value):
    """A median need not be whole where its values are."""
    if KEYS[metric].form == "d" and not float(value).is_integer():
        return format(value, ".1f")
    return format_value(metric, value)


def cell_text(metric, made):
    """Median and quartiles, and how many runs have none."""
    if made.quartiles is None:
        return "failed" if made.failed else NO_VALUE
    middle, low, high = (_number(metric, value) for value in made.quartiles)
    text = middle if made.count == 1 else f"{middle} [{low}, {high}]"
    return text + (f", {made.failed} failed" if made.failed else "")


def _counted(things, name):
    return f"{len(things)} {name}" + ("" if len(things) == 1 else "s")


def _rows(tables, metric):
    return [[product, *(cell_text(metric, tables.cells[metric, product, bag])
                        for bag in tables.bags)] for product in tables.products]


def text_table(tables, metric):
    """A metric's table for a terminal."""
    rows = [["", *tables.bags], *_rows(tables, metric)]
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join([row[0].ljust(widths[0]), *(text.rjust(width) for text, width in
                                                   zip(row[1:], widths[1:]))]).rstrip()
             for row in rows]
    title = f"{_label(metric)}: median [quartiles] over {_counted(tables.seeds, 'seed')}"
    return "\n".join([title, *lines])


def _html_table(header, rows):
    head = "".join(f"<th>{html.escape(name)}</th>" for name in header)
    body = "".join("<tr>" + "".join(f"<td>{html.escape(text)}</td>" for text in row) + "</tr>"
                   for row in rows)
    return f'<div class="scroll"><table class="compare"><tr>{head}</tr>{body}</table></div>'


def _test_rows(comparisons):
    rows = []
    for c in comparisons:
        ratio = NO_VALUE if math.isnan(c.ratio) else f"{c.ratio:.3g}"
        mark = " *" if c.p_holm < _LEVEL else ""
        rows.append([c.first, c.second, str(c.smaller), str(c.larger), str(c.same), ratio,
                     f"{c.p:.2g}", f"{c.p_holm:.2g}{mark}"])
    return rows


def _tests(tables, metric):
    comparisons = tables.comparisons[metric]
    if not comparisons:
        return ""
    table = _html_table(["", "compared with", "smaller", "larger", "same", "median ratio", "p",
                         "p, Holm"], _test_rows(comparisons))
    return (f"<h3>Pairs of products</h3><p>On how many drives (bag and seed) the first has the "
            "smaller or the larger value, the median of its value over the other's, and the p of "
            f"an exact two-sided sign test, also corrected for the {len(comparisons)} pairs after "
            f"Holm; * below {_LEVEL:g}. The p is about drives like these, on these bags.</p>"
            f"{table}")


def _metric_section(folder, tables, metric):
    path = folder.path / f"values_{metric}.png"
    values = tables.values(metric)
    by_bag = {bag: {product: [value for (of, _), value in values[product].items() if of == bag]
                    for product in tables.products} for bag in tables.bags}
    plot_values(by_bag, _label(metric), path)
    return (f"<section><h2>{html.escape(_label(metric))}</h2>"
            f"<p>{html.escape(KEYS[metric].meaning)} The table holds the median and, in brackets, "
            "the first and third quartile over the seeds.</p>"
            + _html_table(["product", *tables.bags], _rows(tables, metric))
            + picture(path, _label(metric), "A dot is a run, the line is the median.")
            + _tests(tables, metric) + "</section>")


def _middle_run(folder, tables, product, bag):
    """The run of the median of the first metric, the smaller of two in the middle; or None."""
    metric = tables.metrics[0] if tables.metrics else ""
    done = [line for line in tables.lines
            if (line.bag, line.product, line.outcome) == (bag, product, DONE)]
    if not done:
        return None
    done.sort(key=lambda line: (line.metrics.get(metric, math.inf), line.seed))
    return read_run(folder.run(done[(len(done) - 1) // 2].run))


def _paths_section(folder, tables):
    text = ""
    for number, bag in enumerate(tables.bags, 1):
        runs = {product: _middle_run(folder, tables, product, bag) for product in tables.products}
        if any(runs.values()):
            path = folder.path / f"paths_{number}.png"
            plot_paths(runs, path)
            caption = (f"{bag}. Blue: the path of the run with the median error, moved onto the "
                       "true one (grey), as the error is reckoned.")
            text += picture(path, f"Paths on {bag}", caption)
    return f"<section><h2>Paths</h2>{text}</section>" if text else ""


def _failure_section(tables):
    """What failed, the same reason once for all seeds."""
    found = collections.defaultdict(list)
    for line in tables.lines:
        if line.outcome != DONE:
            found[line.outcome, line.product, line.bag, line.why].append(str(line.seed))
    rows = [[product, bag, ", ".join(seeds), outcome, why]
            for (outcome, product, bag, why), seeds in found.items()]
    if not rows:
        return "<section><h2>What failed</h2><p>Nothing: every run is complete.</p></section>"
    head = "".join(f"<th>{name}</th>" for name in ("product", "bag", "seeds", "", "why"))
    body = "".join("<tr>" + "".join(f'<td class="{kind}">{html.escape(text)}</td>' for kind, text in
                                    zip(("n", "n", "n", "n", "t"), row)) + "</tr>" for row in rows)
    return ('<section id="failed"><h2>What failed</h2><div class="scroll"><table>'
            f"<tr>{head}</tr>{body}</table></div></section>")


def _file_section(campaign):
    return ("<section><h2>The campaign</h2><p>Beside this page: runs.csv, a line for each run with "
            "all figures; table.csv and tests.csv, what is above; costs.csv, time and memory of "
            "the runs, which differ from host to host; runs/NAME, the files of a run, which "
            "slam_eval makes pictures of.</p><pre>"
            f"{html.escape(campaign.path.read_text(encoding='utf-8'))}</pre></section>")


def summary(tables):
    """How the runs came out, in words."""
    parts = [f"{tables.count(DONE)} of {len(tables.lines)} runs are complete"]
    parts += [f"{tables.count(outcome)} {word}" for outcome, word in
              ((FAILED, "failed"), (MISSING, "are missing")) if tables.count(outcome)]
    return ", ".join(parts)


def render(campaign, folder, tables):
    """The page as HTML text; its pictures are written into the folder."""
    sections = [*(_metric_section(folder, tables, metric) for metric in tables.metrics),
                _paths_section(folder, tables), _failure_section(tables), _file_section(campaign)]
    remark = (f"{_counted(tables.products, 'product')} on {_counted(tables.bags, 'bag')} with "
              f"{_counted(tables.seeds, 'seed')}: {summary(tables)}.")
    return page(f"Campaign {campaign.name}", remark, sections, "wide")
