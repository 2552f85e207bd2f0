// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace slam::eval {

/// A real numeric matrix of a MATLAB file, of whatever type it was stored as.
struct MatlabMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;  // column by column

  double at(std::size_t row, std::size_t column) const { return values[column * rows + row]; }
  bool isVector() const { return rows == 1 || columns == 1; }
};

/// The numeric matrices of a .mat file of level 4 or of level 5 (versions 5 to 7, compressed or
/// not; MAT-File Format, The MathWorks), of either byte order. Text, cells, structures, sparse
/// matrices and imaginary parts are left out.
/// @throw UsageError no such file; ImportError the file is damaged, or of another format
std::map<std::string, MatlabMatrix> readMatlabFile(const std::string& path);

}  // namespace slam::eval
