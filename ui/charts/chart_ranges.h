// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "ui/common/chart.h"

namespace planewright {

/// What a chart's axes run over.
struct ChartRanges {
    double lowX = 0.0;
    double highX = 10.0;
    double highY = 10.0;
};
ChartRanges rangesOf(const Chart& chart);

/// A round number of which no more than so many fit into a span.
double tickStep(double span, double most, double least);

/// A chart whose lines are taken apart where they have gaps: there is nothing in it that is no number.
Chart inPieces(Chart chart);

/// A chart with no more points than can be told apart in so many columns of pixels.
Chart thinned(Chart chart, double columns);

}  // namespace planewright
