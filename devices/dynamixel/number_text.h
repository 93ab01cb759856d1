// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace planewright {

/// A number for a message, with so many decimals, the same under every locale.
std::string numberText(double value, int decimals);

/// An angle [rad] in degrees: "12.3 deg".
std::string angleText(double radians);

}  // namespace planewright
