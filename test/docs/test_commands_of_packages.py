# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands of the packages' texts run."""

import unittest

from command_runs import CommandRuns
from doc_commands import texts_of_packages


class PackagesCommands(CommandRuns, unittest.TestCase):
    def test_run_as_they_stand_in_the_texts(self):
        self.assert_run(texts_of_packages())


if __name__ == "__main__":
    unittest.main()
