// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace planewright {

/// A number for a message with so many decimals, the same under every locale and never "-0": "14.80".
std::string fixedText(double value, int decimals);

/// An angle [rad] for a message, in degrees and with at most so many decimals: "12.5°", "90°". "no angle" for what is
/// none.
std::string degreesText(double radians, int decimals);

}  // namespace planewright
