# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tests that run without sanitizers only are those that CMake builds for it: else they would
run nowhere."""

import fnmatch
import pathlib
import re
import unittest

from runner.suites import STATISTICS

CORE = pathlib.Path(__file__).resolve().parents[2] / "src/slam_core"


def names_in(path):
    """Returns the tests of a file and of the suites that it includes, as Suite.Name; of those with
    parameters without the values."""
    source = (CORE / path).read_text(encoding="utf-8")
    names = [f"{suite}.{name}" for suite, name in re.findall(
        r"^(?:TYPED_TEST_P|TEST(?:_[FP])?)\((\w+),\s*(\w+)\)", source, re.MULTILINE)]
    for header in re.findall(r'^#include "slam_core/(\w+/test/\w+\.hpp)"', source, re.MULTILINE):
        names += names_in(header)
    return names


class Statistics(unittest.TestCase):
    def setUp(self):
        lists = (CORE / "CMakeLists.txt").read_text(encoding="utf-8")
        files = set(re.findall(r"[\w/]+/test/\w+_test\.cpp", lists))
        of_statistics = set()
        for block in re.findall(r"STATISTICS([^)]*)", lists):
            of_statistics |= set(re.findall(r"[\w/]+/test/\w+_test\.cpp", block.split("LINK")[0]))
        self.with_sanitizers_only = [name for path in files - of_statistics
                                     for name in names_in(path)]
        self.without_too = [name for path in of_statistics for name in names_in(path)]
        self.assertGreater(len(self.without_too), 50)

    def test_each_pattern_names_tests_that_run_without_sanitizers(self):
        for pattern in STATISTICS.split(":"):
            with self.subTest(pattern=pattern):
                self.assertTrue(fnmatch.filter(self.without_too, pattern))

    def test_no_test_is_left_out_of_both_runs(self):
        for pattern in STATISTICS.split(":"):
            with self.subTest(pattern=pattern):
                self.assertEqual(fnmatch.filter(self.with_sanitizers_only, pattern), [])


if __name__ == "__main__":
    unittest.main()
