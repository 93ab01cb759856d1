// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/breakpoints.h"

#include <algorithm>
#include <cmath>

namespace planewright {

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

void splitAtBreakpoints(const SlicePoints& points, double bearingStep, const SegmentParameters& parameters,
                        const NoiseParameters& noise, std::vector<PointRun>& runs)
{
    runs.clear();
    const double perRange = gapPerRange(bearingStep, parameters);
    // The noise term is worked out only where the first term does not already keep two neighbours together.
    const auto isBreakpoint = [&](int beam) {
        const double gap = (points[beam] - points[beam - 1]).squaredNorm();
        const double range = points.range(beam - 1);
        double limit = perRange * range;
        if (gap < limit * limit)
            return false;
        limit += parameters.breakpointSigmas * std::sqrt(noise.rangeVariance(range));
        return gap >= limit * limit;
    };
    PointRun run{0, -1};
    const auto close = [&] {
        if (run.points() >= 2)
            runs.push_back(run);
    };
    for (int beam = 0; beam < points.beams(); ++beam) {
        if (!points.hasEcho(beam)) {
            close();
            run = {beam + 1, beam};
            continue;
        }
        if (run.points() > 0 && isBreakpoint(beam)) {
            close();
            run.first = beam;
        }
        run.last = beam;
    }
    close();
}

}  // namespace planewright
