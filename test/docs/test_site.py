# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""./slam docs: the site holds the documents and the headers, and Doxygen has nothing to complain of:
no link that leads nowhere, no parameter that a function does not have."""

import pathlib
import subprocess
import tempfile
import unittest

from doc_commands import REPO


class Site(unittest.TestCase):

    def test_is_made_without_a_warning(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "a site"
            made = subprocess.run([REPO / "slam", "docs", "--out", out], text=True,
                                  capture_output=True, check=False)
            self.assertEqual((made.returncode, made.stderr), (0, ""))
            html = out / "html"
            self.assertIn("A product line of SLAM systems",
                          (html / "index.html").read_text(encoding="utf-8"))
            for page in ("md_docs_architecture.html", "classslam_1_1ekf_1_1EkfSlam.html"):
                self.assertTrue((html / page).exists(), sorted(p.name for p in html.iterdir())[:50])


if __name__ == "__main__":
    unittest.main()
