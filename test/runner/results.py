# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What CTest knows of a build folder, and what a test that has run leaves behind."""

import json
import subprocess
import xml.etree.ElementTree as ElementTree


def list_tests(build):
    """Returns name, command and folder of each test that CTest knows in a build folder."""
    output = subprocess.run(["ctest", "--test-dir", str(build), "--show-only=json-v1"],
                            check=True, capture_output=True, text=True).stdout
    tests = []
    for test in json.loads(output)["tests"]:
        folder = [entry["value"] for entry in test["properties"]
                  if entry["name"] == "WORKING_DIRECTORY"]
        tests.append((test["name"], test.get("command", []), folder[0]))
    return tests


def read_junit(path):
    """Returns (name, passed|failed|skipped) of each test case in a JUnit XML file."""
    try:
        root = ElementTree.parse(path).getroot()
    except (OSError, ElementTree.ParseError) as error:
        return [(f"{path.name}: {error}", "failed")]
    cases = []
    for case in root.iter("testcase"):
        children = {child.tag for child in case}
        name = f"{case.get('classname', '')}.{case.get('name', '')}"
        if children & {"failure", "error"}:
            cases.append((name, "failed"))
        elif "skipped" in children or case.get("status") == "notrun":
            cases.append((name, "skipped"))
        else:
            cases.append((name, "passed"))
    return cases


def read_catkin(summary):
    """The cases of a catkin test; a rostest's summary only names its nodes, each with a file."""
    cases = read_junit(summary)
    if not summary.name.startswith("rostest-"):
        return cases
    nodes = [name.rpartition(".test")[2] for name, _ in cases]
    return [case for node in nodes for case in read_junit(summary.parent / f"rosunit-{node}.xml")]
