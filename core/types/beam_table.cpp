// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/beam_table.h"

#include <cmath>

#include "core/types/recording.h"

namespace planewright {

std::shared_ptr<const std::vector<double>> bearingsAt(const std::shared_ptr<const BeamTable>& table, double tilt)
{
    if (!table->imageTilt)
        return {table, &table->bearings};
    const double share = std::cos(tilt - *table->imageTilt);
    auto bearings = std::make_shared<std::vector<double>>(table->bearings);
    for (double& bearing : *bearings)
        bearing = std::atan2(std::sin(bearing), std::cos(bearing) * share);
    return bearings;
}

void layBeams(ScanSlice& slice, const ScanDescription& description)
{
    if (!slice.ownBearing)
        slice.firstBearing = description.firstBearing;
    slice.bearingStep = description.bearingStep;
    if (description.beamTable)
        slice.bearings = bearingsAt(description.beamTable, slice.tilt);
}

}  // namespace planewright
