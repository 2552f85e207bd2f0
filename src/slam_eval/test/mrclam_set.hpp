// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "temp_folder.hpp"

namespace slam::eval {

/// Writes a small data set in the format of UTIAS MRCLAM with robot 2.
inline void writeMrclamSet(const TempFolder& folder) {
  folder.write("Barcodes.dat",
               "# Subject #    Barcode #\n 1 \t 5 \n 2 \t 14 \n 6 \t 63 \n 7 \t 25 \n");
  folder.write("Landmark_Groundtruth.dat",
               "# Subject x y sx sy\n 6 \t 1.5 \t -2.5 \t 0.0001 \t 0.0002 \n"
               " 7 \t 3.0 \t 4.0 \t 0.0001 \t 0.0002 \n");
  folder.write("Robot2_Odometry.dat",
               "# Time v omega\n1248444187.156 \t 0.1 \t -0.4 \n1248444187.186 \t 0.2 \t 0.0 \n"
               "1248444187.171 \t 0.3 \t 0.5 \n1248444187.200 \t 0.4 \t 0.0 \n"
               "1248444187.200 \t 0.5 \t 0.0 \n");
  folder.write("Robot2_Measurement.dat",
               "# Time barcode range bearing\n1248444187.180 \t 63 \t 2.5 \t 0.1 \n"
               "1248444187.180 \t 5 \t 1.5 \t 0.2 \n1248444187.180 \t 25 \t 3.5 \t -0.3 \n"
               "1248444187.190 \t 5 \t 1.6 \t 0.2 \n1248444187.190 \t 99 \t 1.7 \t 0.2 \n"
               "1248444187.195 \t 25 \t 3.4 \t -0.2 \n1248444187.195 \t 25 \t 3.3 \t -0.1 \n");
  folder.write("Robot2_Groundtruth.dat",
               "# Time x y theta\n1248444187.150 \t 1.0 \t 2.0 \t 0.5 \n"
               "1248444187.250 \t 1.1 \t 2.1 \t 0.6 \n");
}

}  // namespace slam::eval
