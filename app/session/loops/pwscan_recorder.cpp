// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/pwscan_recorder.h"

#include <array>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>

namespace planewright {

std::string utcNow()
{
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return {text.data(), length};
}

PwscanRecorder::PwscanRecorder(std::string path, Target target, std::string scanName)
    : path_(std::move(path)), target_(target), scanName_(std::move(scanName)), startedUtc_(utcNow())
{
}

Result<void> PwscanRecorder::begin(const ScanDescription& description, std::optional<int> plannedSlices)
{
    if (writer_)
        return {};
    ScanRecord scan;
    scan.name = scanName_;
    scan.startedUtc = startedUtc_;
    scan.description = description;
    scan.plannedSlices = plannedSlices;
    Result<PwscanWriter> writer =
        target_ == Target::NewFile ? PwscanWriter::create(path_, scan) : PwscanWriter::append(path_, scan);
    if (!writer)
        return tl::unexpected{writer.error()};
    writer_ = std::move(*writer);
    return {};
}

Result<void> PwscanRecorder::close(ScanOutcome outcome)
{
    if (writer_->slices() == 0)
        return writer_->discard();
    switch (outcome) {
        case ScanOutcome::Complete:
            return writer_->close(ScanState::Complete);
        case ScanOutcome::Partial:
            return writer_->close(ScanState::Partial);
        case ScanOutcome::Fault:
            break;
    }
    return writer_->close(ScanState::Fault);
}

std::uint64_t PwscanRecorder::bytes() const
{
    std::uint64_t bytes = 0;
    for (const char* const end : {"", "-wal"}) {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(path_ + end, error);
        bytes += error ? 0 : size;
    }
    return bytes;
}

std::optional<std::uint64_t> PwscanRecorder::freeBytes() const
{
    const std::filesystem::path folder = std::filesystem::path{path_}.parent_path();
    std::error_code error;
    const auto space = std::filesystem::space(folder.empty() ? "." : folder, error);
    if (error)
        return std::nullopt;
    return space.available;
}

}  // namespace planewright
