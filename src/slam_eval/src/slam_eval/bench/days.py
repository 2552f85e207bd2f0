# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Memory of products over days of stamps: what a process takes beyond its map must not grow."""
import csv
import pathlib

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import package_folder, workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import Section, table

LARGEST_GROWTH = 1.0  # [MB/h], beyond the map
SETTLED = 3  # [h]: the map of the way is made then, and the allocator has what it needs
HEADER = ["product", "steps", "CPU [s]", "resident [MB]", "at the end", "growth [MB/h]",
          "checkpoint [MB]", "at the end", "growth [MB/h]", "beyond [MB/h]", "goal"]


def read_hours(path):
    """The rows of the program as dictionaries of numbers. Raises BenchError."""
    with open(path, encoding="utf-8") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    if len(rows) <= SETTLED:
        raise BenchError(f"{path} has {len(rows)} hours; more than {SETTLED} are needed")
    return rows


def slope(rows, key):
    """Growth of a column in an hour from SETTLED on, by least squares."""
    settled = [row for row in rows if row["hour"] >= SETTLED]
    hours = [row["hour"] for row in settled]
    values = [row[key] for row in settled]
    mean_hour, mean_value = sum(hours) / len(hours), sum(values) / len(values)
    spread = sum((hour - mean_hour) ** 2 for hour in hours)
    return sum((hour - mean_hour) * (value - mean_value)
               for hour, value in zip(hours, values)) / spread if spread else 0.0


def row_of(product, rows):
    """A product's line of the table, and whether it keeps the goal."""
    begin = next(row for row in rows if row["hour"] >= SETTLED)
    end = rows[-1]
    resident, checkpoint = slope(rows, "resident_mb"), slope(rows, "checkpoint_mb")
    beyond = resident - max(0.0, checkpoint)
    is_reached = beyond <= LARGEST_GROWTH
    return [product, f"{end['steps']:.0f}", f"{end['cpu_s']:.0f}",
            f"{begin['resident_mb']:.1f}", f"{end['resident_mb']:.1f}", f"{resident:.3f}",
            f"{begin['checkpoint_mb']:.2f}", f"{end['checkpoint_mb']:.2f}", f"{checkpoint:.3f}",
            f"{beyond:.3f}", "reached" if is_reached else "MISSED"], is_reached


def _run(context, product):
    path = pathlib.Path(product)
    if path.suffix != ".yaml":
        path = package_folder("slam_launch") / "products" / f"{product}.yaml"
    if not path.is_file():
        raise BenchError(f"there is no product {product}; name one of slam_launch/products, or a file")
    log = context.work / f"days_{path.stem}.csv"
    call(context, product,
         [workspace_program("slam_eval", "slam_eval_days"), path, "--out",
          context.work / f"days_{path.stem}", "--hours", str(context.options.hours),
          "--interval", str(context.options.interval)], log)
    return read_hours(log)


def measure(context):
    """The section of this benchmark."""
    section = Section("Memory over days")
    lines = []
    for product in context.options.products:
        try:
            line, is_reached = row_of(product, _run(context, product))
        except BenchError as error:
            section.failures.append(f"{product}: {error}")
            continue
        lines.append(line)
        if not is_reached:
            section.failures.append(f"{product} grows by more than {LARGEST_GROWTH:.0f} MB/h")
    section.paragraphs += [
        table(HEADER, lines),
        f"{context.options.hours} h of stamps, a message of each sensor every "
        f"{context.options.interval} s; the robot drives rounds and stands still every other "
        f"hour. Growth is that from {SETTLED} h on. A checkpoint holds map and state; "
        "beyond it the process must not grow."]
    return section
