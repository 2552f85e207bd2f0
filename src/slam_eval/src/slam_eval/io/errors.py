# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The errors of this package, and how programs report them."""
import difflib
import sys


class InputError(Exception):
    """A file that cannot be evaluated. Its text is one sentence: file, line, remedy."""


class UsageError(InputError):
    """What was asked for cannot be, and nothing was started."""


def did_you_mean(name, candidates):
    """" (did you mean 'x'?)", or nothing where none is near."""
    near = difflib.get_close_matches(str(name), list(candidates), 1)
    return f" (did you mean '{near[0]}'?)" if near else ""


def read_text(path):
    """Return the text of a file, or raise InputError."""
    if path.exists() and not path.is_file():
        raise InputError(f"{path}: a folder, a pipe or a device, no regular file; check the path")
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise InputError(f"{path}: no such file; check the path") from None
    except UnicodeDecodeError:
        raise InputError(f"{path}: not a text file; check the path") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror}); check the path") from None
    if not text.strip():
        raise InputError(f"{path}: the file is empty; run the product again") from None
    return text


def exit_code_of(program, action, output):
    """Calls `action`, and reports in one sentence what it could not read or write.

    output: what is written, for errors that do not name it. Returns 0, or 1 where it failed, or 2
    after wrong use.
    """
    try:
        action()
    except InputError as error:
        print(f"{program}: {error}", file=sys.stderr)
        return 2 if isinstance(error, UsageError) else 1
    except OSError as error:
        print(f"{program}: {error.filename or output}: cannot be written "
              f"({error.strerror}); check space and permissions", file=sys.stderr)
        return 1
    return 0
