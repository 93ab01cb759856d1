// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/types/scan_slice.h"

namespace planewright {

/// Sines and cosines of a slice's bearings, worked out once for each way in which the scanner's slices are laid.
///
/// An interlaced scanner takes turns between a few first bearings; so many are kept.
template <class Number>
class BearingTables {
public:
    struct Table {
        double firstBearing = 0.0;
        double bearingStep = 0.0;
        std::shared_ptr<const std::vector<double>> bearings;  ///< where they are not evenly spaced
        std::vector<Number> cosine;
        std::vector<Number> sine;
    };

    /// Turns to the table of a slice.
    void select(const ScanSlice& slice)
    {
        for (current_ = 0; current_ < tables_.size(); ++current_) {
            const Table& table = tables_[current_];
            if (table.cosine.size() == slice.ranges.size() && table.firstBearing == slice.firstBearing &&
                table.bearingStep == slice.bearingStep && table.bearings == slice.bearings)
                return;
        }
        if (tables_.size() < kKept)
            tables_.emplace_back();
        current_ = next_;
        next_ = (next_ + 1) % kKept;
        Table& table = tables_[current_];
        table.firstBearing = slice.firstBearing;
        table.bearingStep = slice.bearingStep;
        table.bearings = slice.bearings;
        table.cosine.resize(slice.ranges.size());
        table.sine.resize(slice.ranges.size());
        for (std::size_t i = 0; i < slice.ranges.size(); ++i) {
            table.cosine[i] = static_cast<Number>(std::cos(slice.bearing(i)));
            table.sine[i] = static_cast<Number>(std::sin(slice.bearing(i)));
        }
    }

    /// The table that was selected last; there must be one.
    const Table& current() const { return tables_[current_]; }

private:
    static constexpr std::size_t kKept = 8;
    std::vector<Table> tables_;
    std::size_t current_ = 0;
    std::size_t next_ = 0;
};

}  // namespace planewright
