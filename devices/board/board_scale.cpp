// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_scale.h"

#include <algorithm>
#include <cmath>

#include "core/types/angle.h"

namespace planewright::board {

namespace {

constexpr int kCounts = 1023;
constexpr int kMiddle = 512;
constexpr double kSpan = degrees(300.0);
/// Beyond every servo there is, and small enough that no arithmetic overflows.
constexpr std::uint32_t kWidestMdeg = 100'000'000;
constexpr int kFastestCounts = 65535;

/// Limits that lie on a count must not lose it to rounding.
constexpr double kSlack = 1e-6;

bool isMounting(const TiltMounting& m)
{
    for (const double value : {m.zeroPitch, m.sign, m.scale, m.lowest, m.highest, m.fastest}) {
        if (!std::isfinite(value) || std::abs(value) > 1e3)
            return false;
    }
    return std::abs(m.sign) == 1.0 && m.scale > 0.1 && m.scale < 10.0 && m.lowest < m.highest && m.fastest > 0.0;
}

}  // namespace

Scale::Scale(const TiltMounting& mounting) : Scale(mounting, kCounts, kMiddle, kSpan) {}

Scale::Scale(const TiltMounting& mounting, int highest, int middle, double span)
    : mounting_(mounting), middle_(middle), step_(mounting.scale * span / highest)
{
    const double atLowest = counts(mounting.sign > 0.0 ? mounting.lowest : mounting.highest);
    const double atHighest = counts(mounting.sign > 0.0 ? mounting.highest : mounting.lowest);
    const auto within = [&](double value) { return static_cast<int>(std::clamp(value, 0.0, 1.0 * highest)); };
    low_ = within(std::ceil(atLowest - kSlack));
    high_ = within(std::floor(atHighest + kSlack));
    topSpeed_ = static_cast<int>(std::clamp(mounting.fastest / step_, 1.0, 1.0 * kFastestCounts));
}

Result<Scale> Scale::of(const HelloReply& board, const TiltMounting& mounting)
{
    if (!isMounting(mounting))
        return fail(ErrorCode::Usage,
                    "the mounting of the tilt unit is none: its sign is 1 or -1, its scale near 1, its "
                    "lowest pitch below the highest, and its speed above 0");
    if (board.highest < 2 || board.middle > board.highest || board.spanMdeg < 1000 || board.spanMdeg > kWidestMdeg)
        return fail(ErrorCode::NoDevice, "the board tells of a servo that cannot be: " + std::to_string(board.highest) +
                                             " counts for " + std::to_string(board.spanMdeg) +
                                             " thousandths of a degree");
    const Scale scale{mounting, board.highest, board.middle, degrees(board.spanMdeg / 1000.0)};
    if (scale.low_ >= scale.high_)
        return fail(ErrorCode::Usage,
                    "the servo cannot reach any pitch between the limits of the mounting; calibrate "
                    "its zero, or set other limits");
    return scale;
}

double Scale::pitch(double counts) const
{
    return mounting_.zeroPitch + mounting_.sign * step_ * (counts - middle_);
}

double Scale::counts(double pitch) const
{
    return middle_ + mounting_.sign * (pitch - mounting_.zeroPitch) / step_;
}

int Scale::nearest(double pitch) const
{
    return static_cast<int>(std::clamp(std::round(counts(pitch)), 1.0 * low_, 1.0 * high_));
}

double Scale::lowest() const
{
    return std::min(pitch(low_), pitch(high_));
}

double Scale::highest() const
{
    return std::max(pitch(low_), pitch(high_));
}

}  // namespace planewright::board
