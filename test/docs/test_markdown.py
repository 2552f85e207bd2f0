# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks of commands say what they are, and why they cannot be run where they cannot."""

import unittest

from doc_commands import blocks, shell_blocks, texts


class Markdown(unittest.TestCase):
    def test_every_block_names_its_language(self):
        self.assertEqual([str(block) for path in texts() for block in blocks(path)
                          if not block.language], [])

    def test_what_is_not_run_says_why(self):
        left_out = [block for block in shell_blocks() if block.not_run]
        print("not run:", *(f"{block}: {block.not_run}" for block in left_out), sep="\n  ")
        self.assertLess(len(left_out), len(shell_blocks()) / 2)
        for block in left_out:
            self.assertGreater(len(block.not_run.split()), 2, str(block))


if __name__ == "__main__":
    unittest.main()
