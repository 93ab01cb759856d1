// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>

#include "devices/transport/dialogue_speech.h"

namespace planewright {

/// NTB/1 in a dialogue that is played again: sequence numbers and the host's time in heartbeats are others each time.
/// Replies get the numbers of the requests of now; those to requests that are not said now are left out. Events come
/// as they came, with the board's time; what is damaged comes damaged.
class BoardSpeech : public DialogueSpeech {
public:
    Meaning meaningOf(std::span<const std::uint8_t> message) const override;
    void pair(std::span<const std::uint8_t> then, std::span<const std::uint8_t> now) override;
    Bytes translated(Bytes bytes) override;
    bool answersOnly() const override { return false; }

private:
    Bytes pending_;                               ///< of a frame that has not ended
    std::map<std::uint16_t, std::uint16_t> now_;  ///< numbers of requests, by those of then
};

}  // namespace planewright
