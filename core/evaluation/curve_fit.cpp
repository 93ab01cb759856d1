// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/curve_fit.h"

#include <cmath>
#include <cstddef>

namespace planewright {

LineFit lineThrough(const std::vector<double>& x, const std::vector<double>& y)
{
    const auto n = static_cast<double>(x.size());
    double meanX = 0.0;
    double meanY = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        meanX += x[i] / n;
        meanY += y[i] / n;
    }
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - meanX) * (x[i] - meanX);
        xy += (x[i] - meanX) * (y[i] - meanY);
        yy += (y[i] - meanY) * (y[i] - meanY);
    }
    if (xx <= 0.0 || yy <= 0.0)
        return {0.0, meanY, 0.0};
    const double slope = xy / xx;
    return {slope, meanY - slope * meanX, xy * xy / (xx * yy)};
}

PowerFit powerThrough(const std::vector<double>& x, const std::vector<double>& y)
{
    std::vector<double> logX;
    std::vector<double> logY;
    for (std::size_t i = 0; i < x.size(); ++i) {
        logX.push_back(std::log(x[i]));
        logY.push_back(std::log(y[i]));
    }
    const LineFit line = lineThrough(logX, logY);
    return {line.slope, std::exp(line.intercept), line.explained};
}

}  // namespace planewright
