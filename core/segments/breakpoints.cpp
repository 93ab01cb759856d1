// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/breakpoints.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr double kFinestBreakStep = degrees(0.25);

}  // namespace

double gapPerRange(double bearingStep, const SegmentParameters& parameters)
{
    // A scanner coarser than half the incidence limit would make the denominator vanish.
    const double margin = std::max(parameters.incidenceLimit - bearingStep, 0.5 * parameters.incidenceLimit);
    return std::sin(bearingStep) / std::sin(margin);
}

double breakpointDistance(double range, double bearingStep, const SegmentParameters& parameters,
                          const NoiseParameters& noise)
{
    return range * gapPerRange(bearingStep, parameters) +
           parameters.breakpointSigmas * std::sqrt(noise.rangeVariance(range));
}

double breakpointStep(double bearingStep)
{
    return std::max(bearingStep, kFinestBreakStep);
}

void splitAtBreakpoints(const SlicePoints& points, double bearingStep, const SegmentParameters& parameters,
                        std::vector<PointRun>& runs)
{
    runs.clear();
    const int beams = points.beams();
    if (beams == 0)
        return;
    std::vector<std::uint8_t> marks(static_cast<std::size_t>(beams));
    beamKernels().markGapsExactly(points.arrays(), points.ranges(), beams, gapPerRange(bearingStep, parameters),
                                  parameters.breakpointSigmas, marks.data());
    for (auto first = marks.begin(); first != marks.end();) {
        const auto next = std::find(first + 1, marks.end(), std::uint8_t{1});
        if (next - first >= 2)
            runs.push_back({static_cast<int>(first - marks.begin()), static_cast<int>(next - marks.begin()) - 1});
        first = next;
    }
}

}  // namespace planewright
