// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "core/formats/byte_source.h"

namespace planewright {

/// Lines and bytes of one file in turn, for formats whose header is text and whose data need not be.
class ByteReader {
public:
    explicit ByteReader(std::istream& in) : source_(in) {}

    /// The next line without its end (LF or CRLF), valid until the next call; nothing at the end, and for a line longer
    /// than `longest`.
    std::optional<std::string_view> line(std::size_t longest);
    /// The next `size` bytes, valid until the next call; fewer at the end.
    std::string_view bytes(std::size_t size);

    std::size_t lineNumber() const { return lines_; }  ///< of the line given last, from 1
    std::uint64_t place() const { return place_; }     ///< bytes that have been given
    /// Why there is no more, and what to do; empty at the whole end of a sound file.
    std::string problem() const;

private:
    bool fill();

    ByteSource source_;
    std::string buffer_;
    std::size_t begin_ = 0;
    std::size_t lines_ = 0;
    std::uint64_t place_ = 0;
};

}  // namespace planewright
