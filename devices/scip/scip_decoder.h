// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "devices/scip/scip_event.h"

namespace planewright {

/// Turns the bytes of a laser into replies, scans and damage, whatever pieces they come in.
///
/// A message is its lines up to an empty one. What cannot be read as a whole is thrown away up to the next line at
/// which a message begins, or to the empty line; nothing is ever patched together. So a reply in the middle of a scan
/// comes out, and the scan does not. Empty lines between messages mean nothing.
///
/// It keeps no more than kLongestFrame bytes, whatever comes.
class ScipDecoder {
public:
    static constexpr std::size_t kLongestLine = 128;      ///< without its line feed
    static constexpr std::size_t kLongestFrame = 65'536;  ///< with all line feeds

    /// Takes bytes; gives what they complete, in order.
    std::vector<ScipEvent> push(std::span<const std::uint8_t> bytes);

    /// Forgets the beginning of a message. The counters stay.
    void forget();

    /// Bytes that wait for the end of their message.
    std::size_t waiting() const { return message_.size(); }

    const ScipDamageCounts& damage() const { return damage_; }

private:
    struct Line {
        std::size_t begin;
        std::size_t size;
        bool isTooLong;
    };
    void endLine(std::vector<ScipEvent>& events);
    void endMessage(std::vector<ScipEvent>& events);
    void reject(ScipDamageKind kind, std::string_view bytes, std::vector<ScipEvent>& events);

    std::string message_;      ///< of the message that is not yet complete; lines too long only in part
    std::vector<Line> lines_;  ///< the complete ones of it
    std::size_t lineBegin_ = 0;
    bool lineIsTooLong_ = false;
    ScipDamageCounts damage_;
};

}  // namespace planewright
