// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace planewright {

/// The manual's page on parameters in Markdown: a table of rows per part with defaults, units and ranges, then the
/// presets. Made from the parameter table alone.
std::string parameterManualPage();

}  // namespace planewright
