# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""docs/troubleshooting.md has a row for what is counted, warned of and checked, in its words."""

import re
import unittest

from doc_commands import REPO
import messages

PAGE = REPO / "docs" / "troubleshooting.md"
ROW = re.compile(r"^\| (.*) \|$")
CODE = re.compile(r"`([^`]+)`")
QUOTE = re.compile(r'(?<!\w)"([^"]+)"')


def rows(title):
    """Returns the first cells of all tables whose heading's first cell has this title, with the
    rest of the row."""
    found, is_inside = [], False
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        row = ROW.match(line)
        is_inside = is_inside and line.startswith("|")
        if not row:
            continue
        first, *rest = [cell.strip() for cell in row.group(1).split(" | ")]
        if first == title:
            is_inside = True
        elif is_inside:
            found.append((first, rest))
    return found


def codes(cells):
    return [name for cell, _ in cells for name in CODE.findall(cell)]


def quotes():
    """Returns all sentences that the page quotes, wherever in a row."""
    lines = [line for line in PAGE.read_text(encoding="utf-8").splitlines() if ROW.match(line)]
    return [quote for line in lines for quote in QUOTE.findall(line)
            if quote != "2D Pose Estimate"]


def list_of(missing, known):
    return "\n".join(f"{name}: {known[name][0]}" for name in sorted(missing))


class Counters(unittest.TestCase):
    def test_have_a_row_each(self):
        known, told = messages.counters(), set(codes(rows("counter")))
        self.assertGreater(len(known), 80)
        missing = set(known) - told
        self.assertFalse(missing, "docs/troubleshooting.md has no row for the counters\n"
                         + list_of(missing, known))

    def test_of_the_page_exist(self):
        self.assertEqual(set(codes(rows("counter"))) - set(messages.counters()), set())

    def test_are_explained_once(self):
        told = codes(rows("counter"))
        self.assertEqual({name for name in told if told.count(name) > 1}, set())

    def test_that_the_console_explains_are_among_them(self):
        text = (REPO / "src/slam_ros/src/diagnostics.cpp").read_text(encoding="utf-8")
        names = re.findall(r'\{"(\w+)",\s*"', text)
        self.assertGreater(len(names), 15)
        told = set(codes(rows("counter")))
        self.assertEqual([name for name in names if name not in told and
                          not (name.partition("_")[2] in told)], [])

    def test_are_found_however_they_are_counted(self):
        for text in ('counters_.add("some_reason");', 'account.counters.add("some_reason", 3);',
                     'counters.add(is_new ? "some_reason" : "other");',
                     'counters.add(told.kind == Kind::kNew ? "some_reason"\n : "other");',
                     'sinks.count("some_reason");',
                     'std::string reasonOf(Kind kind) {\n  return "some_reason";\n}'):
            self.assertIn("some_reason", messages.counters_in(text), text)
        for text in ('return Fault{"some_reason", "an image is bad"};', 'return "some_reason";',
                     'marker.rejection = "some_reason";', 'return reject("some_reason", "it is");',
                     'return is_thin ? "some_reason" : "";'):
            self.assertIn("some_reason", messages.counters_in(text, True), text)
        self.assertEqual(messages.counters_in('values["figure"] = 1; name("some_reason");'), set())


class Sentences(unittest.TestCase):
    def test_that_are_reported_have_a_row(self):
        known, told = messages.sentences(), "\n".join(quotes())
        self.assertGreater(len(known), 100)
        missing = {key for key in known if key not in told}
        self.assertFalse(missing, "docs/troubleshooting.md has no row for the sentences\n"
                         + list_of(missing, known))

    def test_that_the_page_quotes_are_those_of_the_code(self):
        pieces = messages.known_pieces()
        unknown = [quote for quote in quotes()
                   if not all(piece.strip(" '") in pieces for piece in quote.split("…"))]
        self.assertGreater(len(quotes()), 200)
        self.assertEqual(unknown, [])

    def test_are_found_however_they_are_reported(self):
        sentence = "the robot has a wheel too few"
        for text in (f'return Status::warning("{sentence}: add one");',
                     f'return Status::alarm(name +\n "{sentence}"\n " to drive");',
                     f'return Status::error(fmt::format("{sentence}: {{}}", n));',
                     f'fault_ =\n "{sentence}";', f'warn("{sentence}");',
                     f'Fault{{"few_wheels", "{sentence}"}}', f'reject("few", "{sentence}");',
                     f'constexpr char kFew[] =\n "{sentence}";\nStatus::warning(kFew);',
                     f'std::string A::finding() const {{\n  return "{sentence}";\n}}'):
            self.assertEqual(messages.sentences_in(text), {sentence[:25].strip()}, text)
        self.assertEqual(messages.key_of("{} of the last {} observations failed"),
                         "observations failed")
        self.assertEqual(messages.key_of("late"), "")


class Bridges(unittest.TestCase):
    def test_have_a_row_for_each_reason_with_its_sentence(self):
        told = dict(rows("reason"))
        known = messages.bridge_sentences()
        self.assertGreater(len(known), 10)
        self.assertEqual({f"`{reason}`" for reason in known} - set(told), set())
        missing = [reason for reason, sentence in known.items()
                   if messages.key_of(sentence) not in told[f"`{reason}`"][0]]
        self.assertEqual(missing, [])


class Doctor(unittest.TestCase):
    def test_s_checks_have_a_row_each(self):
        told, checks = codes(rows("check")), messages.doctor_checks()
        self.assertGreater(len(checks), 35)
        self.assertEqual([check for check in sorted(checks)
                          if not any(name == check or check.startswith(".") and
                                     name.endswith(check) for name in told)], [])

    def test_s_checks_on_the_page_exist(self):
        checks = messages.doctor_checks()
        self.assertEqual([name for name in codes(rows("check"))
                          if name not in checks and f".{name.partition('.')[2]}" not in checks], [])


if __name__ == "__main__":
    unittest.main()
