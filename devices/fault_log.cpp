// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/fault_log.h"

#include <algorithm>
#include <utility>

namespace planewright {

namespace {

std::string inHexadecimal(std::span<const std::uint8_t> bytes)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string text;
    for (const std::uint8_t byte : bytes.first(std::min(bytes.size(), FaultLog::kMostBytes))) {
        text += text.empty() ? "" : " ";
        text += {kDigits[byte >> 4U], kDigits[byte & 0xFU]};
    }
    return bytes.size() > FaultLog::kMostBytes ? text + " …" : text;
}

}  // namespace

std::string recordText(const FaultRecord& record)
{
    return record.text + " (" + record.code + (record.bytes.empty() ? "" : ": " + record.bytes) + ")";
}

void FaultLog::add(std::chrono::nanoseconds at, std::string_view code, std::string text,
                   std::span<const std::uint8_t> bytes)
{
    FaultRecord record{at, std::string{code}, std::move(text), inHexadecimal(bytes)};
    const std::scoped_lock lock(mutex_);
    ++counts_[record.code];
    records_.push_back(std::move(record));
    if (records_.size() > kMostRecords)
        records_.pop_front();
}

std::vector<FaultRecord> FaultLog::take()
{
    const std::scoped_lock lock(mutex_);
    const std::deque<FaultRecord> records = std::exchange(records_, {});
    return {records.begin(), records.end()};
}

FaultCounts FaultLog::counts() const
{
    const std::scoped_lock lock(mutex_);
    return counts_;
}

void FaultLog::restartCounts()
{
    const std::scoped_lock lock(mutex_);
    counts_.clear();
}

}  // namespace planewright
