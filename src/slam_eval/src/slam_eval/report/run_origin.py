# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where a run comes from, for reports: `run` in metrics.json, as `./slam run` has noted it."""

DATE = "Date of the run"
_SHOWN_DIGITS = 12  # of a bag's hash


def _bag(about):
    parts = [str(about.get("name", ""))]
    if isinstance(about.get("bytes"), int):
        parts.append(f"{about['bytes'] / 1e6:.1f} MB")
    if about.get("sha256"):
        parts.append(f"sha256 {str(about['sha256'])[:_SHOWN_DIGITS]}…")
    return ", ".join(part for part in parts if part)


def origin_rows(metrics):
    """(name, text) of what is known; empty where the run notes nothing."""
    origin = metrics.get("run")
    if not isinstance(origin, dict):
        return []
    version = str(origin.get("version", ""))
    if origin.get("commit"):
        version += f" (commit {origin['commit']})"
    bag = origin.get("bag")
    found = [("Bag", _bag(bag) if isinstance(bag, dict) else ""),
             (DATE, str(origin.get("date", ""))),
             ("Version", version.strip()),
             ("Command", str(origin.get("command", "")))]
    return [(name, text) for name, text in found if text]
