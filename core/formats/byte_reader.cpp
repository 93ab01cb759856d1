// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/byte_reader.h"

#include <algorithm>

namespace planewright {

namespace {
constexpr std::size_t kPieceSize = std::size_t{64} * 1024;
}

bool ByteReader::fill()
{
    buffer_.erase(0, begin_);
    begin_ = 0;
    const std::size_t filled = buffer_.size();
    buffer_.resize(filled + kPieceSize);
    const std::size_t count = source_.read(buffer_.data() + filled, kPieceSize);
    buffer_.resize(filled + count);
    return count != 0;
}

std::optional<std::string_view> ByteReader::line(std::size_t longest)
{
    std::size_t looked = 0;
    for (;;) {
        const std::size_t end = buffer_.find('\n', begin_ + looked);
        const std::size_t length = std::min(end, buffer_.size()) - begin_;
        if (length > longest)
            return std::nullopt;
        const bool isWhole = end != std::string::npos;
        looked = length;
        if (!isWhole && fill())
            continue;
        // What stands before the place where compressed data break off is no whole line.
        if (!isWhole && (length == 0 || !problem().empty()))
            return std::nullopt;
        ++lines_;
        std::string_view text{buffer_.data() + begin_, length};
        begin_ += length + (isWhole ? 1 : 0);
        place_ += length + (isWhole ? 1 : 0);
        if (text.ends_with('\r'))
            text.remove_suffix(1);
        return text;
    }
}

std::string_view ByteReader::bytes(std::size_t size)
{
    while (buffer_.size() - begin_ < size && fill()) {
    }
    const std::size_t count = std::min(size, buffer_.size() - begin_);
    const std::string_view given{buffer_.data() + begin_, count};
    begin_ += count;
    place_ += count;
    return given;
}

std::string ByteReader::problem() const
{
    return problemText(source_.end());
}

}  // namespace planewright
