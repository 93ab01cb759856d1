// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace planewright {

/// How lengths are shown; all are kept in metres.
struct LengthStyle {
    bool millimetres = false;
    int decimals = 2;  ///< of metres, 0 to 4; of millimetres three less

    friend bool operator==(const LengthStyle&, const LengthStyle&) = default;
};
inline constexpr int kMostDecimals = 4;

}  // namespace planewright
