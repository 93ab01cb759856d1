// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/breakpoints.h"

#include <algorithm>
#include <cmath>

namespace planewright {

double breakpointDistance(double range, double bearingStep, const SegmentParameters& parameters,
                          const NoiseParameters& noise)
{
    // A scanner coarser than half the incidence limit would make the denominator vanish.
    const double margin = std::max(parameters.incidenceLimit - bearingStep, 0.5 * parameters.incidenceLimit);
    return range * std::sin(bearingStep) / std::sin(margin) +
           parameters.breakpointSigmas * std::sqrt(noise.rangeVariance(range));
}

void splitAtBreakpoints(const SlicePoints& points, double bearingStep, const SegmentParameters& parameters,
                        const NoiseParameters& noise, std::vector<PointRun>& runs)
{
    runs.clear();
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
        if (run.points() > 0) {
            const double limit = breakpointDistance(points.range(beam - 1), bearingStep, parameters, noise);
            if ((points[beam] - points[beam - 1]).squaredNorm() >= limit * limit) {
                close();
                run.first = beam;
            }
        }
        run.last = beam;
    }
    close();
}

}  // namespace planewright
