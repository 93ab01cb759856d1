// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "devices/transport/dialogue_speech.h"

namespace planewright {

/// Requests to servos of both protocols in a dialogue that is played again: how often a servo is asked where it stands
/// is a matter of the moment. What is written to it is not.
class ServoSpeech : public DialogueSpeech {
public:
    Meaning meaningOf(std::span<const std::uint8_t> message) const override;
    bool answersOnly() const override { return true; }
};

}  // namespace planewright
