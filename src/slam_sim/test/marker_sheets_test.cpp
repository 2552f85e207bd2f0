// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "marker_sheets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace slam::sim {
namespace {

MarkerSheets sheetsOf(double size, int count, const std::string& paper = "A4") {
  MarkerSheets sheets;
  sheets.family = "36h11";
  sheets.size = size;
  sheets.paper = paper;
  sheets.ids.resize(static_cast<std::size_t>(count));
  std::iota(sheets.ids.begin(), sheets.ids.end(), 0);
  return sheets;
}

template <class Call>
std::string sentenceOf(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(MarkerSheets, FillEachPageAndLeaveNoMarkerOut) {
  const auto one_each = printed(sheetsOf(0.16, 12));
  EXPECT_EQ(one_each.pages, 12);
  EXPECT_TRUE(one_each.has_narrow_margin) << "two cells of 20 mm each do not fit";
  const auto small = printed(sheetsOf(0.04, 12));
  EXPECT_EQ(small.markers_on_page, 9);
  EXPECT_EQ(small.pages, 2);
  EXPECT_FALSE(small.has_narrow_margin);
  EXPECT_EQ(printed(sheetsOf(0.04, 9)).pages, 1);
}

TEST(MarkerSheets, HaveTheSizeOfTheirPaper) {
  EXPECT_NE(printed(sheetsOf(0.1, 1, "a4")).pdf.find("595.27"), std::string::npos);
  EXPECT_NE(printed(sheetsOf(0.1, 1, "letter")).pdf.find("612 792"), std::string::npos);
}

TEST(MarkerSheets, RefuseWhatCannotBePrinted) {
  EXPECT_EQ(sentenceOf([] { printed(sheetsOf(0.17, 1)); }),
            "a marker of 0.17 m and its white margin do not fit on A4, which has room for 0.16 m "
            "at most");
  EXPECT_EQ(sentenceOf([] { printed(sheetsOf(160, 1)); }),
            "the size is the edge of the black square in metres: is 0.16 m meant?");
  EXPECT_NE(sentenceOf([] { printed(sheetsOf(0, 1)); }).find("give metres"), std::string::npos);
  EXPECT_NE(sentenceOf([] { printed(sheetsOf(-0.1, 1)); }).find("give metres"), std::string::npos);
  EXPECT_NE(sentenceOf([] { printed(sheetsOf(std::nan(""), 1)); }).find("give metres"),
            std::string::npos);
  EXPECT_NE(sentenceOf([] { printed(sheetsOf(0.1, 1, "A9")); }).find("there are: A5, A4"),
            std::string::npos);
  EXPECT_EQ(sentenceOf([] { printed(sheetsOf(0.1, 0)); }), "there is no id to print");
  EXPECT_NE(sentenceOf([] { printed(sheetsOf(0.1, 600)); }).find("its ids are 0 to 586"),
            std::string::npos);
}

TEST(MarkerSheets, ReadIdsAndRanges) {
  EXPECT_EQ(readIds("7"), (std::vector<std::int64_t>{7}));
  EXPECT_EQ(readIds("0-2,20,4-4"), (std::vector<std::int64_t>{0, 1, 2, 20, 4}));
  for (const std::string bad : {"", "a", "1,", ",1", "3-1", "1--2", "-1", "1-", "1 2",
                                "99999999999999999999", "0-9223372036854775807"})
    EXPECT_NE(sentenceOf([&] { readIds(bad); }).find("write ids like 0-11,20"), std::string::npos)
        << bad;
}

}  // namespace
}  // namespace slam::sim
