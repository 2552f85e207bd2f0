// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/pose_cell_config.hpp"

#include "slam_core/common/config_error.hpp"

namespace slam::rat {

void PoseCellConfig::describe(Fields& fields) {
  fields.add("edge", &edge, "cells along x and along y, after which they begin again")
      .unit("1")
      .in(Range::closed(8, 200));
  fields.add("headings", &headings, "cells about theta").unit("1").in(Range::closed(8, 360));
  fields.add("cell_size", &cell_size, "edge of a cell").unit("m").in(Range::closed(0.01, 10));
  fields
      .add("excitation_sigma", &excitation_sigma,
           "standard deviation of the weights with which a cell excites those around it")
      .unit("cells")
      .in(Range::closed(0.3, 5));
  fields
      .add("inhibition_sigma", &inhibition_sigma,
           "the same of inhibition, which reaches further than excitation")
      .unit("cells")
      .in(Range::closed(0.3, 10));
  fields
      .add("global_inhibition", &global_inhibition,
           "activity that each cell loses in a step; all of them have 1 together")
      .unit("1")
      .in(Range::closed(0, 0.01));
  fields
      .add("injected", &injected,
           "activity that a known view adds where the robot was when it saw it first")
      .unit("1")
      .in(Range::closed(0, 10));
  fields
      .add("fading", &fading,
           "by how much a view fades each time that it is seen, so that a standing robot does not "
           "convince itself")
      .unit("1")
      .in(Range::closed(0, 10));
  fields.add("recovery", &recovery, "by how much all views recover in a step")
      .unit("1")
      .in(Range::closed(0, 10));
}

void requireUsable(const PoseCellConfig& config) {
  validate(config);
  if (!(config.inhibition_sigma > config.excitation_sigma))
    throw ConfigError(
        "pose_cells: inhibition_sigma must be larger than excitation_sigma, else activity spreads "
        "over all cells");
}

}  // namespace slam::rat
