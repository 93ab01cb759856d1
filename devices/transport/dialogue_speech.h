// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace planewright {

/// What a host's messages mean to a device, as far as it takes to answer out of a record: a program that is run again
/// says the same things at other moments, with other numbers, and asks some of them more or less often.
class DialogueSpeech {
public:
    using Bytes = std::vector<std::uint8_t>;

    struct Meaning {
        std::string what;         ///< two messages that have the same are answered the same
        bool isQuestion = false;  ///< changes nothing at the device: it may be left out, or asked once more
    };

    virtual ~DialogueSpeech() = default;

    /// What a message of the host means, which was written at once.
    virtual Meaning meaningOf(std::span<const std::uint8_t> message) const = 0;

    /// The host has said `now` where it had said `then`.
    virtual void pair(std::span<const std::uint8_t> /*then*/, std::span<const std::uint8_t> /*now*/) {}

    /// What the device says to the host of now; bytes of the record go in in order, and may wait for their end.
    virtual Bytes translated(Bytes bytes) { return bytes; }

    /// The device speaks only when it was asked: what it has said to a question that is left out is left out as well,
    /// and a question that is asked once more has the answer of the last time.
    virtual bool answersOnly() const = 0;
};

}  // namespace planewright
