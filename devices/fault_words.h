// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

namespace planewright {

/// What a code of a fault stands for, in a few words: "a line with a wrong sum" for "laser-sum". Empty for a code that
/// is not known.
std::string_view faultWords(std::string_view code);

}  // namespace planewright
