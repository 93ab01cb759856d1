// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "devices/emulated/emulated_link.h"
#include "devices/fault_log.h"
#include "devices/scip/scip_laser.h"
#include "tests/devices/emulated/laser_rig.h"
#include "tests/devices/fake_clock.h"

namespace planewright {

/// A device whose answers a test writes: what it says to each request, at once. Empty: nothing.
class AnsweringDevice : public EmulatedDevice {
public:
    explicit AnsweringDevice(std::function<std::string(const std::string&)> answer) : answer_(std::move(answer)) {}

    void receive(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now) override
    {
        for (const std::uint8_t byte : bytes) {
            if (byte != '\n') {
                line_ += static_cast<char>(byte);
                continue;
            }
            say(answer_(std::exchange(line_, {})), now);
        }
    }

    void say(const std::string& text, std::chrono::nanoseconds at)
    {
        const auto later = std::find_if(pending_.begin(), pending_.end(),
                                        [&](const EmulatedOutput& output) { return output.at > at; });
        if (!text.empty())
            pending_.insert(later, {at, {text.begin(), text.end()}});
    }

    std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) override
    {
        std::vector<EmulatedOutput> due;
        while (!pending_.empty() && pending_.front().at <= now) {
            due.push_back(std::move(pending_.front()));
            pending_.erase(pending_.begin());
        }
        return due;
    }

    std::optional<std::chrono::nanoseconds> nextOutput() const override
    {
        return pending_.empty() ? std::nullopt : std::optional{pending_.front().at};
    }

    bool isConnected(std::chrono::nanoseconds /*now*/) override { return true; }

private:
    std::function<std::string(const std::string&)> answer_;
    std::string line_;
    std::vector<EmulatedOutput> pending_;
};

/// A device before which somebody else answers: what `answer` gives for a request goes back in its place, empty for
/// nothing; no value lets the request through.
class FilteredDevice : public EmulatedDevice {
public:
    using Answer = std::function<std::optional<std::string>(const std::string&)>;
    FilteredDevice(std::shared_ptr<EmulatedDevice> device, Answer answer)
        : device_(std::move(device)), answer_(std::move(answer))
    {
    }

    void receive(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now) override
    {
        for (const std::uint8_t byte : bytes) {
            line_ += static_cast<char>(byte);
            if (byte != '\n')
                continue;
            const std::string line = std::exchange(line_, {});
            if (const auto answer = answer_(line.substr(0, line.size() - 1)))
                own_.push_back({now, {answer->begin(), answer->end()}});
            else
                device_->receive(textBytes(line), now);
        }
    }

    std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) override
    {
        std::vector<EmulatedOutput> outputs = std::exchange(own_, {});
        for (EmulatedOutput& output : device_->takeOutput(now))
            outputs.push_back(std::move(output));
        std::stable_sort(outputs.begin(), outputs.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
        return outputs;
    }

    std::optional<std::chrono::nanoseconds> nextOutput() const override
    {
        return own_.empty() ? device_->nextOutput() : own_.front().at;
    }

    bool isConnected(std::chrono::nanoseconds now) override { return device_->isConnected(now); }

private:
    std::shared_ptr<EmulatedDevice> device_;
    Answer answer_;
    std::string line_;
    std::vector<EmulatedOutput> own_;
};

/// A device that hears and says nothing while it is deaf.
class DeafDevice : public EmulatedDevice {
public:
    DeafDevice(std::shared_ptr<EmulatedDevice> device, const bool& isDeaf) : device_(std::move(device)), isDeaf_(isDeaf)
    {
    }

    void receive(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now) override
    {
        if (!isDeaf_)
            device_->receive(bytes, now);
    }

    std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) override
    {
        std::vector<EmulatedOutput> outputs = device_->takeOutput(now);
        return isDeaf_ ? std::vector<EmulatedOutput>{} : outputs;
    }

    std::optional<std::chrono::nanoseconds> nextOutput() const override { return device_->nextOutput(); }
    bool isConnected(std::chrono::nanoseconds now) override { return device_->isConnected(now); }

private:
    std::shared_ptr<EmulatedDevice> device_;
    const bool& isDeaf_;
};

/// A link that notes what is asked.
class NotingLink : public Transport {
public:
    NotingLink(std::unique_ptr<Transport> link, std::vector<std::string>& asked) : link_(std::move(link)), asked_(asked)
    {
    }

    std::string name() const override { return link_->name(); }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override
    {
        return link_->read(into, deadline, stop);
    }
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override
    {
        asked_.emplace_back(bytes.begin(), bytes.end() - 1);
        return link_->write(bytes, deadline);
    }
    void close() override { link_->close(); }

private:
    std::unique_ptr<Transport> link_;
    std::vector<std::string>& asked_;
};

/// A ScipLaser at an emulated device, by a clock that jumps.
class LaserBench {
public:
    using Time = std::chrono::nanoseconds;

    explicit LaserBench(std::shared_ptr<EmulatedDevice> emulated) : device(std::move(emulated)) { plugIn(); }

    explicit LaserBench(const EmulatedLaserOptions& options, std::function<double(Time)> pitch = level)
        : LaserBench(*EmulatedLaser::make(viewOfWall(), std::move(pitch), options))
    {
    }

    /// A driver anew at the same device: as after a program was killed.
    void plugIn()
    {
        auto link = std::make_unique<EmulatedLink>(device, rig, clock, "usb 1-4");
        laser = std::make_unique<ScipLaser>(std::make_unique<NotingLink>(std::move(link), asked), clock,
                                            [this](const std::string& line) { progress.push_back(line); });
    }

    Result<void> connect() { return laser->connect({}); }
    /// Connects and scans steps 500 to 580, the wall in front.
    Result<void> begin()
    {
        if (const Result<void> connected = connect(); !connected)
            return connected;
        return laser->start(500, 580, {});
    }
    Result<std::optional<LaserScan>> next(Time within = std::chrono::seconds{60})
    {
        return laser->next(clock.now() + within, {});
    }

    /// So many scans, or fewer where none comes.
    std::vector<LaserScan> scans(int count)
    {
        std::vector<LaserScan> scans;
        for (int i = 0; i < count; ++i) {
            auto scan = next();
            if (!scan || !*scan)
                break;
            scans.push_back(std::move(**scan));
        }
        return scans;
    }

    std::size_t timesAsked(const std::string& request) const
    {
        return static_cast<std::size_t>(std::count(asked.begin(), asked.end(), request));
    }

    FakeClock clock;
    std::shared_ptr<EmulatedDevice> device;
    std::shared_ptr<std::mutex> rig = std::make_shared<std::mutex>();
    std::vector<std::string> asked;
    std::vector<std::string> progress;
    std::unique_ptr<ScipLaser> laser;
};

/// The request whose answer is the stream that these benches begin.
inline const std::string kStream = "MD0500058000000";

inline LaserBench benchWith(std::vector<FaultAt> faults, const std::string& model = "UTM-30LX")
{
    return LaserBench{laserOptions(model, std::move(faults))};
}

inline double milliseconds(std::chrono::nanoseconds time)
{
    return std::chrono::duration<double, std::milli>(time).count();
}

}  // namespace planewright
