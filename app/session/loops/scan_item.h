// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <variant>

#include "core/formats/parameter_events.h"
#include "core/types/scan_slice.h"

namespace planewright {

/// Slices are made once and then shared by recorder, extractor and window.
using SharedSlice = std::shared_ptr<const ScanSlice>;

/// How a scan ended.
enum class ScanOutcome {
    Complete,  ///< with its last slice
    Partial,   ///< somebody ended it before
    Fault,     ///< it could not go on
};

/// What goes from the source to the recorder, in the order in which it happened. The outcome is the last.
using AcquiredItem = std::variant<SharedSlice, Parameters, ScanEvent, ScanOutcome>;

/// What goes from the recorder to the extractor.
using ExtractionItem = std::variant<SharedSlice, ParametersFrom>;

}  // namespace planewright
