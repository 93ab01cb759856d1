// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace planewright {

/// Appends the shortest decimal form that reads back to nine significant digits: no exponent longer than needed, never
/// "-0", never by the locale. A number that is not finite is unknown and appends nothing.
void appendNumber(std::string& text, double value);

/// The same as a text of its own.
std::string formatNumber(double value);

/// The shortest decimal form that reads back to the same number, never by the locale.
std::string exactNumber(double value);

}  // namespace planewright
