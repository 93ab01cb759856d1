// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "core/types/error.h"
#include "devices/board/board_replies.h"
#include "devices/tilt_unit.h"

namespace planewright::board {

/// The counts of a board's servo and the pitch that they stand for:
/// φ = zeroPitch + sign · scale · (counts − middle) · span / highest.
class Scale {
public:
    /// The RX-64's: 300° in 1023 counts.
    explicit Scale(const TiltMounting& mounting = {});

    /// The scale of the servo that a board names. Errors (NoDevice): no servo has such counts; Usage: the mounting
    /// leaves nowhere to go, or is no mounting.
    static Result<Scale> of(const HelloReply& board, const TiltMounting& mounting);

    double pitch(double counts) const;     ///< φ [rad]
    double counts(double pitch) const;     ///< not rounded, may be beyond what the servo has
    int nearest(double pitch) const;       ///< the nearest count within the limits
    double step() const { return step_; }  ///< pitch of one count, positive [rad]

    int low() const { return low_; }  ///< limits in counts: the mounting's, rounded inwards, within those of the servo
    int high() const { return high_; }
    int topSpeed() const { return topSpeed_; }  ///< counts a second, 1 to 65535
    double lowest() const;                      ///< limits as φ [rad]
    double highest() const;
    double fastest() const { return topSpeed_ * step_; }  ///< [rad/s]

private:
    Scale(const TiltMounting& mounting, int highest, int middle, double span);

    TiltMounting mounting_;
    double middle_;
    double step_;
    int low_;
    int high_;
    int topSpeed_;
};

}  // namespace planewright::board
