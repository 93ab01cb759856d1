// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "devices/transport/transport.h"

namespace planewright {

/// A link that tells a test whenever somebody is about to read from it, and what is written to it.
class WatchedLink : public Transport {
public:
    using OnRead = std::function<void()>;
    using OnWrite = std::function<void(std::span<const std::uint8_t>)>;

    WatchedLink(std::unique_ptr<Transport> link, OnRead onRead, OnWrite onWrite = {})
        : link_(std::move(link)), onRead_(std::move(onRead)), onWrite_(std::move(onWrite))
    {
    }

    std::string name() const override { return link_->name(); }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override
    {
        if (onRead_)
            onRead_();
        return link_->read(into, deadline, stop);
    }
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override
    {
        if (onWrite_)
            onWrite_(bytes);
        return link_->write(bytes, deadline);
    }
    void close() override { link_->close(); }

private:
    std::unique_ptr<Transport> link_;
    OnRead onRead_;
    OnWrite onWrite_;
};

}  // namespace planewright
