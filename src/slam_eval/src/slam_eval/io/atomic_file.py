# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that are there completely or not at all."""
import contextlib
import os
import secrets


@contextlib.contextmanager
def replaced(path):
    """The path of a file to write, which takes the place of `path` at the end."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.{secrets.token_hex(4)}")
    try:
        yield temporary
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def write_atomically(path, text):
    """Write a text file completely or not at all."""
    # a new file: no link is followed that somebody has put there
    with replaced(path) as temporary, open(temporary, "x", encoding="utf-8") as stream:
        stream.write(text)
        stream.flush()
        os.fsync(stream.fileno())
