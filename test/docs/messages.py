# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the sources can report: counters and sentences of the C++ code, of the bridges and of the labels,
checks of slam_doctor."""

import ast
import re

from doc_commands import REPO

LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
ADJACENT = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
ASIDE = {"test", "tools", "tuning"}  # no running product has these
PROGRAM = re.compile(r"slam_\w+\.cpp|command_line\.[ch]pp")  # arguments that --help explains
NAME = re.compile(r"[a-z]+(?:_[a-z]+)*_?")
# Where a counter is named: in the call that counts, or by who gives a reason to such a call.
COUNTED = re.compile(r"\b\w*(?:counters?_?|held|all|sinks)\.(?:add|count)\(")
BY_REASON = re.compile(r"counters?_?\.add\((?:\w*->reason|rejection|hindrance|fault|reason\b)|"
                       r"counters_\.add\(\w+\.rejection")
REASON = re.compile(r'Fault\{"|\brejection = |\bre(?:ject|fuse)\("|'
                    r'\breturn (?:[^;{}"]*\? )?"\w*"(?: : "\w*")?;')
REASONS = re.compile(r"std::string \w*[rR]easonOf\(.*?\n\}", re.DOTALL)
# Who passes on a sentence that users see.
SAYS = re.compile(r"Status::(?:warning|alarm|error)\(|\b(?:warn_?|fail|tell)\(|"
                  r"warnings_?\.push_back\(|\bfault_ ?=\s|\bFault\{\s*\"\w+\",|"
                  r"\breject\(\s*\"\w+\",|_STREAM(?:_NAMED)?\(|_WARN\(|_THROTTLE_NAMED\(")
SENTENCES = re.compile(r"std::string (?:\w+::)?(?:finding|reason|sentence(?:Of)?|meaning\w*|"
                       r"starving|\w*[fF]aultOf\w*|heard|unknownMount|missing|admit\w*)"
                       r"\([^)]*\)[^{;]*\{\n(.*?)\n\}", re.DOTALL)
CONSTANT = re.compile(r"\bk[A-Z]\w+\b")
PLACEHOLDER = re.compile(r"\{[^{}]*\}")
CHECK = re.compile(r"\b(?:error|warn|unknown|ok)\(\s*\"(\w+)\"|"
                   r"\"(\w+\.(?!png|yaml|families|dict)[a-z_]+)\"|"
                   r"f\"\{[\w.]+\}(\.(?!png)[a-z_]+)\"")


def cpp_files():
    """Returns the text of each C++ file of the product line by its path."""
    found = {}
    for pattern in ("src/slam_core/*/**/*.?pp", "src/slam_ros/**/*.?pp", "slam_*/src/*.?pp",
                    "src/slam_pipes/src/*.?pp", "src/slam_sim/src/*nodelet.cpp"):
        for path in sorted(REPO.glob(pattern)):
            parts = set(path.relative_to(REPO).parts)
            if not ASIDE & parts and not PROGRAM.fullmatch(path.name):
                text = path.read_text(encoding="utf-8")
                found[path] = re.sub(r"^\s*(?://|#include).*$", "", text, flags=re.MULTILINE)
    return found


def argument(text, begin, ends=",)};"):
    """Returns what stands from `begin` up to the end of an argument or statement."""
    depth, quoted, position = 0, False, begin
    while position < len(text):
        letter = text[position]
        if letter == "\\" and quoted:
            position += 1
        elif letter == '"':
            quoted = not quoted
        elif not quoted:
            if depth == 0 and letter in ends:
                break
            depth += (letter in "({[") - (letter in ")}]")
        position += 1
    return text[begin:position]


def joined(text):
    """Returns the literals of a piece of code, those that stand side by side as one."""
    return ["".join(LITERAL.findall(match)) for match in ADJACENT.findall(text)]


def counters_in(text, counts_by_reason=False):
    """Returns the counters that a file names. counts_by_reason: whether its component counts by a
    reason that it is given."""
    pieces = [argument(text, match.end()) for match in COUNTED.finditer(text)]
    pieces += REASONS.findall(text)
    if counts_by_reason:
        pieces += [argument(text, match.start(), ends=",;") for match in REASON.finditer(text)]
    names = {literal for piece in pieces for literal in joined(piece)}
    return {name for name in names if NAME.fullmatch(name)}


def counters():
    """Returns {counter: files that name it}; a name that ends with _ is a prefix."""
    files, found = cpp_files(), {}
    by_reason = {path.parent for path, text in files.items() if BY_REASON.search(text)}
    for path, text in files.items():
        is_given = path.parent in by_reason and path.suffix == ".cpp" and "slam_core" in path.parts
        for name in counters_in(text, is_given):
            found.setdefault(name, []).append(path.relative_to(REPO))
    return found


def key_of(literal):
    """Returns the words by which a sentence is looked up: its first 25 letters, or the longest
    piece between values that stand in it. Empty where it is hardly a sentence."""
    pieces = [piece.strip(" :;,.'(") for piece in PLACEHOLDER.split(literal)]
    first = next((piece for piece in pieces if len(piece) >= 15), max(pieces, key=len))
    return first[:25].strip() if len(literal.split()) > 2 and len(first) > 7 else ""


def sentences_in(text, has_functions=True):
    """Returns the keys of the sentences that a file reports, of each by its first words.
    has_functions: whether functions that are named after sentences count as well."""
    pieces = [argument(text, match.end(), ends=");") for match in SAYS.finditer(text)]
    pieces += [piece for body in SENTENCES.findall(text) if has_functions
               for piece in re.findall(r"return ([^;]*);", body)]
    found = set()
    for piece in pieces:
        keys = [key_of(literal) for literal in joined(piece)]
        for name in CONSTANT.findall(piece):
            value = re.search(rf"\b{name}(?:\[\])? ?=\s*((?:\"[^;]*\"\s*)+);", text)
            keys += [key_of(literal) for literal in joined(value.group(1))] if value else []
        found.add(next(filter(None, keys), ""))
    return found - {""}


def sentences():
    """Returns {key of a sentence: files that report it}."""
    found = {}
    for path, text in cpp_files().items():
        for key in sentences_in(text, path.suffix == ".cpp"):
            found.setdefault(key, []).append(path.relative_to(REPO))
    return found


def doctor_files():
    return sorted(REPO.glob("src/slam_doctor/src/slam_doctor/**/*.py"))


def doctor_checks():
    """Returns the names of slam_doctor's checks; one that each sensor has begins with a dot."""
    found = set()
    for path in REPO.glob("src/slam_doctor/src/slam_doctor/checks/*.py"):
        for names in CHECK.findall(path.read_text(encoding="utf-8")):
            found.update(filter(None, names))
    return found


def bridge_files():
    return sorted(REPO.glob("slam_bridges/src/slam_bridges/*.py"))


def label_files():
    return sorted(REPO.glob("slam_labels/src/slam_labels/*.py"))


def bridge_sentences():
    """Returns {reason: sentence} of the bridges."""
    tree = ast.parse((REPO / "slam_bridges/src/slam_bridges/account.py").read_text("utf-8"))
    return next(ast.literal_eval(node.value) for node in tree.body
                if isinstance(node, ast.Assign) and node.targets[0].id == "SENTENCES")


def known_pieces():
    """Returns all texts of the sources, at values cut in pieces, as one text to search in."""
    texts = list(cpp_files().values())
    texts += [path.read_text(encoding="utf-8")
              for path in doctor_files() + bridge_files() + label_files()]
    texts = [re.sub(r'"\s*\n?\s*f?"', "", text) for text in texts]  # side by side: one
    pieces = [piece for text in texts for literal in LITERAL.findall(text)
              for piece in [literal, *PLACEHOLDER.split(literal)]]
    return "\n".join(pieces)
