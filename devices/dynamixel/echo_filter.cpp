// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/echo_filter.h"

namespace planewright {

std::vector<std::uint8_t> EchoFilter::push(std::span<const std::uint8_t> bytes)
{
    std::vector<std::uint8_t> passed;
    for (const std::uint8_t byte : bytes) {
        if (!isOver_ && byte == sent_[matched_]) {
            isOver_ = ++matched_ == sent_.size();
            continue;
        }
        if (!isOver_) {
            passed.assign(sent_.begin(), sent_.begin() + static_cast<std::ptrdiff_t>(matched_));
            isOver_ = true;
            matched_ = 0;
        }
        passed.push_back(byte);
    }
    return passed;
}

}  // namespace planewright
