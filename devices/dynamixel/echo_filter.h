// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace planewright {

/// Takes the sender's own bytes out of what comes back: some adapters of half duplex buses return all that they send.
///
/// Only an exact copy of the whole request at the very beginning is an echo; anything else is passed on unchanged.
class EchoFilter {
public:
    /// `sent` is not empty.
    explicit EchoFilter(std::vector<std::uint8_t> sent) : sent_(std::move(sent)) {}

    /// What is left of bytes that have come. Holds back what may be the beginning of an echo.
    std::vector<std::uint8_t> push(std::span<const std::uint8_t> bytes);

    /// True once the whole echo has come.
    bool heardEcho() const { return isOver_ && matched_ == sent_.size(); }

private:
    std::vector<std::uint8_t> sent_;
    std::size_t matched_ = 0;  ///< bytes of the echo so far
    bool isOver_ = false;      ///< the echo was complete, or there is none
};

}  // namespace planewright
