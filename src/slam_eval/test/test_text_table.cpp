// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "import_error.hpp"
#include "temp_folder.hpp"
#include "text_table.hpp"

namespace slam::eval {
namespace {

TextRow row(const std::string& field) { return TextRow("f.dat:7", {field}); }

TEST(TextRow, ReadsAStampWithoutLosingNanoseconds) {
  EXPECT_EQ(row("1248444187.156").stamp(0), 1248444187156000000);
  EXPECT_EQ(row("1248444187.123456789").stamp(0), 1248444187123456789);
  EXPECT_EQ(row("1248444187").stamp(0), 1248444187000000000);
  EXPECT_EQ(row("0.000000001").stamp(0), 1);
}

TEST(TextRow, RefusesWhatIsNoStamp) {
  for (const std::string text : {"", "0", "-1.5", "1.5s", "1.", ".5x", "1.0123456789", "1e9", "nan",
                                 "4294967296.0", "99999999999999999999"}) {
    EXPECT_THROW(row(text).stamp(0), ImportError) << text;
  }
}

TEST(TextRow, RefusesWhatIsNoFiniteNumber) {
  EXPECT_DOUBLE_EQ(row("-0.398").number(0), -0.398);
  for (const std::string text : {"", "nan", "inf", "1.5m", "--1", "1,5"}) {
    EXPECT_THROW(row(text).number(0), ImportError) << text;
  }
}

TEST(TextRow, NamesPlaceAndColumnOfAWrongField) {
  const std::string message = messageOf<ImportError>([] { row("6.5").integer(0); });
  EXPECT_EQ(message, "f.dat:7: column 1 is '6.5', expected a whole number");
}

TEST(ReadTable, LeavesOutCommentsAndEmptyLinesAndTakesWindowsLineEnds) {
  const TempFolder folder;
  folder.write("t.dat", "# a comment\r\n\r\n 1 \t 2 \r\n3 4");
  const auto rows = readTable(folder.file("t.dat"), 2, '#');
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].integer(1), 2);
  EXPECT_EQ(rows[1].integer(0), 3);
}

TEST(ReadRows, TakesRowsOfAnyNumberOfColumns) {
  const TempFolder folder;
  folder.write("t.dat", "# a comment\n1 2 3\n\n4\n");
  const auto rows = readRows(folder.file("t.dat"), '#');
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].size(), 3u);
  EXPECT_EQ(rows[1].size(), 1u);
  EXPECT_EQ(rows[1].place(), folder.file("t.dat") + ":4");
}

TEST(ReadTable, NamesTheLineOfATruncatedRow) {
  const TempFolder folder;
  folder.write("t.dat", "# a comment\n1 2 3\n4 5\n");
  const auto message =
      messageOf<ImportError>([&folder] { readTable(folder.file("t.dat"), 3, '#'); });
  EXPECT_NE(message.find("t.dat:3: 2 columns, expected 3"), std::string::npos) << message;
}

TEST(ReadTable, RefusesAFileThatIsMissingOrHoldsNoRows) {
  const TempFolder folder;
  folder.write("t.dat", "# only a comment\n");
  EXPECT_THROW(readTable(folder.file("t.dat"), 1, '#'), ImportError);
  EXPECT_THROW(readTable(folder.file("none.dat"), 1, '#'), ImportError);
}

}  // namespace
}  // namespace slam::eval
