// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>

#include "core/params/parameters.h"
#include "core/types/error.h"
#include "core/types/step_report.h"

namespace planewright {

/// Writes the first line of a history (NDJSON): the format and the parameters. Errors: NotWritten.
Result<void> writeHistoryHeader(std::ostream& out, const Parameters& parameters);

/// Writes the line of one step: its counts and decisions; segments are `step.index`, planes P and clusters C with their
/// ids, pieces that became no segment `step:first-last` with their beams. The tests print numbers as they were
/// compared, in SI units: angles are radians there, as nowhere else before the user. The report of the forced last pass
/// (step -1) has `"phase":"finish"`. `times` adds `times_ms`, the milliseconds of each phase. Errors: NotWritten.
Result<void> writeHistoryLine(std::ostream& out, const StepReport& report, bool times);

}  // namespace planewright
