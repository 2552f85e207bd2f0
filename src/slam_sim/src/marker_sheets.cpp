// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "marker_sheets.hpp"

#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "slam_core/common/nearest_name.hpp"
#include "slam_sim/marker_family.hpp"
#include "slam_sim/marker_texture.hpp"

// All lengths are in millimetres, from the page's upper left corner.

namespace slam::sim {
namespace {

constexpr double kPoints = 72.0 / 25.4;  // PDF's unit in a millimetre
constexpr double kUnprintable = 5.0;     // at each edge of the paper
constexpr double kCaption = 8.0;         // height below a marker
constexpr double kFoot = 14.0;           // height of the ruler and its text
constexpr double kGap = 4.0;             // between markers
constexpr double kFont = 3.5;
constexpr int kWidestMargin = 2;  // of markerPattern() [cells]

struct Paper {
  const char* name;
  double width, height;
};
constexpr Paper kPapers[] = {
    {"A5", 148, 210},         {"A4", 210, 297},        {"A3", 297, 420},
    {"A2", 420, 594},         {"A1", 594, 841},        {"A0", 841, 1189},
    {"letter", 215.9, 279.4}, {"legal", 215.9, 355.6}, {"tabloid", 279.4, 431.8}};

Paper paperOf(const std::string& name) {
  const auto same = [](char a, char b) { return std::tolower(a) == std::tolower(b); };
  for (const auto& paper : kPapers) {
    const std::string known = paper.name;
    if (std::equal(known.begin(), known.end(), name.begin(), name.end(), same)) return paper;
  }
  throw std::invalid_argument("there is no paper '" + name + "'; there are: " + join(paperNames()));
}

/// How markers of one family stand on a page.
struct Layout {
  double cell = 0.0, edge = 0.0;  ///< of one cell; of a marker with its margin
  int margin = 0;                 ///< [cells]
  int columns = 0, rows = 0;
  int perPage() const { return columns * rows; }
};

int fitting(double room, double piece) {
  return std::max(0, static_cast<int>(std::floor((room + kGap) / (piece + kGap) + 1e-9)));
}

Layout layoutOf(const MarkerPattern& pattern, double size, const Paper& paper, int margin) {
  Layout layout;
  layout.margin = margin;
  layout.cell = size / pattern.border_cells;
  layout.edge = layout.cell * (pattern.cells.cols - 2 * (kWidestMargin - margin));
  layout.columns = fitting(paper.width - 2 * kUnprintable, layout.edge);
  layout.rows = fitting(paper.height - 2 * kUnprintable - kFoot, layout.edge + kCaption);
  return layout;
}

/// The largest black square for which the paper has room, in whole millimetres.
double largestSize(const MarkerPattern& pattern, const Paper& paper) {
  const double room =
      std::min(paper.width - 2 * kUnprintable, paper.height - 2 * kUnprintable - kFoot - kCaption);
  const int cells = pattern.cells.cols - 2 * (kWidestMargin - 1);
  return std::floor(room / cells * pattern.border_cells);
}

Layout layoutOf(const MarkerPattern& pattern, double size, const Paper& paper) {
  for (int margin = kWidestMargin; margin > 0; --margin)
    if (const auto layout = layoutOf(pattern, size, paper, margin); layout.perPage() > 0)
      return layout;
  throw std::invalid_argument(fmt::format(
      "a marker of {:g} m and its white margin do not fit on {}, which has room for {:g} m at most",
      size / 1e3, paper.name, largestSize(pattern, paper) / 1e3));
}

using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void write(cairo_t* page, double x, double y, const std::string& text) {
  cairo_move_to(page, x, y);
  cairo_show_text(page, text.c_str());
}

/// All black cells are one area, so that no viewer shows seams between them.
void drawCells(cairo_t* page, const cv::Mat& cells, double cell, double x, double y) {
  for (int row = 0; row < cells.rows; ++row)
    for (int column = 0; column < cells.cols; ++column)
      if (cells.at<std::uint8_t>(row, column) == 0)
        cairo_rectangle(page, x + column * cell, y + row * cell, cell, cell);
  cairo_fill(page);
}

/// Cut along this line the marker keeps its margin.
void drawCut(cairo_t* page, double x, double y, double edge) {
  cairo_set_source_rgb(page, 0.75, 0.75, 0.75);
  cairo_rectangle(page, x, y, edge, edge + kCaption);
  cairo_stroke(page);
  cairo_set_source_rgb(page, 0.0, 0.0, 0.0);
}

void drawMarker(cairo_t* page, const MarkerSheets& sheets, std::int64_t id, const Layout& layout,
                double x, double y) {
  drawCut(page, x, y, layout.edge);
  const auto cells = markerPattern(sheets.family, id).cells;
  const int cut = kWidestMargin - layout.margin;
  drawCells(page, cells(cv::Range(cut, cells.rows - cut), cv::Range(cut, cells.cols - cut)),
            layout.cell, x, y);
  const auto caption = fmt::format("{}  id {}  {:g} mm", sheets.family, id, 1e3 * sheets.size);
  cairo_text_extents_t extents;
  cairo_set_font_size(page, kFont);
  cairo_text_extents(page, caption.c_str(), &extents);
  const double shrink = std::min(1.0, (layout.edge - 2.0) / extents.width);
  cairo_set_font_size(page, kFont * shrink);
  write(page, x + 1.0, y + layout.edge + 0.6 * kCaption, caption);
}

void drawFoot(cairo_t* page, const MarkerSheets& sheets, const Paper& paper) {
  constexpr double kRuler = 100.0, kTick = 3.0;
  const double y = paper.height - kUnprintable - 5.0;
  for (int i = 0; i <= 10; ++i) {
    const double x = kUnprintable + 0.1 * kRuler * i;
    cairo_move_to(page, x, y);
    cairo_line_to(page, x, y - (i % 5 == 0 ? kTick : 0.5 * kTick));
  }
  cairo_move_to(page, kUnprintable, y);
  cairo_line_to(page, kUnprintable + kRuler, y);
  cairo_stroke(page);
  cairo_set_font_size(page, 0.85 * kFont);
  write(page, kUnprintable, y + 4.0,
        fmt::format("This line is 100 mm long if printed at 100 %.   "
                    "fiducial.marker_size: {:g}",
                    sheets.size));
}

void requireSize(double size) {
  if (!std::isfinite(size) || size < 0.001)
    throw std::invalid_argument(
        fmt::format("the size {:g} m is no edge of a marker: give metres, such as 0.16", size));
  if (size >= 2.0)
    throw std::invalid_argument(fmt::format(
        "the size is the edge of the black square in metres: is {:g} m meant?", size / 1e3));
}

}  // namespace

std::vector<std::string> paperNames() {
  std::vector<std::string> names;
  for (const auto& paper : kPapers) names.emplace_back(paper.name);
  return names;
}

std::vector<std::int64_t> readIds(const std::string& text) {
  constexpr std::size_t kMost = 10000;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto fail = [&](const std::string& why) {
    throw std::invalid_argument("'" + text + "' " + why + ": write ids like 0-11,20");
  };
  const auto number = [&] {
    std::int64_t value = 0;
    const auto result = std::from_chars(at, end, value);
    if (result.ec != std::errc() || value < 0) fail("is no list of ids");
    at = result.ptr;
    return value;
  };
  std::vector<std::int64_t> ids;
  while (true) {
    const auto first = number();
    auto last = first;
    if (at != end && *at == '-') {
      ++at;
      last = number();
    }
    if (last < first) fail("has a range that ends before it begins");
    if (static_cast<std::size_t>(last - first) >= kMost - ids.size())
      fail("are more than 10000 markers");
    for (auto id = first; id <= last; ++id) ids.push_back(id);
    if (at == end) return ids;
    if (*at++ != ',') fail("is no list of ids");
  }
}

PrintedSheets printed(const MarkerSheets& sheets) {
  requireSize(sheets.size);
  if (sheets.ids.empty()) throw std::invalid_argument("there is no id to print");
  const auto paper = paperOf(sheets.paper);
  for (const auto id : sheets.ids)
    markerPattern(sheets.family, id);  // throws before a page is drawn
  const auto layout =
      layoutOf(markerPattern(sheets.family, sheets.ids.front()), 1e3 * sheets.size, paper);
  PrintedSheets result;
  result.markers_on_page = layout.perPage();
  result.has_narrow_margin = layout.margin < kWidestMargin;
  const Surface surface(cairo_pdf_surface_create_for_stream(
                            append, &result.pdf, kPoints * paper.width, kPoints * paper.height),
                        cairo_surface_destroy);
  const Context page(cairo_create(surface.get()), cairo_destroy);
  cairo_scale(page.get(), kPoints, kPoints);
  cairo_set_line_width(page.get(), 0.2);
  cairo_select_font_face(page.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  const double left = 0.5 * (paper.width - layout.columns * (layout.edge + kGap) + kGap);
  for (std::size_t i = 0; i < sheets.ids.size(); ++i) {
    const int place = static_cast<int>(i) % layout.perPage();
    const double x = left + (place % layout.columns) * (layout.edge + kGap);
    const double y = kUnprintable + (place / layout.columns) * (layout.edge + kCaption + kGap);
    drawMarker(page.get(), sheets, sheets.ids[i], layout, x, y);
    if (place + 1 < layout.perPage() && i + 1 < sheets.ids.size()) continue;
    drawFoot(page.get(), sheets, paper);
    cairo_show_page(page.get());
    ++result.pages;
  }
  cairo_surface_finish(surface.get());
  if (const auto status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("the sheets cannot be drawn: ") +
                             cairo_status_to_string(status));
  return result;
}

}  // namespace slam::sim
