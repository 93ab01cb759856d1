// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "app/cli/parameter_options.h"

namespace planewright {

/// What the command line says of a map of several stops.
struct MapOptions {
    std::vector<std::string> inputs;
    std::string odometry, output, poses, floorPoses;
    std::vector<std::string> planes, floorPlans;
    double cutHeight = 1.0;  ///< above the floor [m]
    double scale = 100.0;    ///< of a plan as SVG
    bool noOdometry = false;
    bool noEdits = false;
    bool overwrite = false;
    ParameterOptions parameters;
};

}  // namespace planewright
