// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "core/formats/byte_source.h"

namespace planewright {

/// Longest line that is read from any file: a slice of the most beams needs half of it.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 20;

/// The lines of a text, plain or compressed with gzip, one after the other; the memory held is a line's.
///
/// Lines end with LF or CRLF; a byte order mark of UTF-8 at the beginning is passed over.
class TextLines {
public:
    explicit TextLines(std::istream& in, std::size_t longestLine = kLongestLine);

    /// The next line without its end, valid until the next call; nothing at the end or after a failure.
    std::optional<std::string_view> next();

    std::size_t number() const { return number_; }           ///< of the line given last, from 1
    bool terminated() const { return terminated_; }          ///< false for a last line without line end
    bool cutShort() const { return cutShort_; }              ///< the compressed data stopped in the middle
    const std::string& problem() const { return problem_; }  ///< why reading failed and what to do; empty if it did not
    std::size_t problemLine() const { return number_ + 1; }  ///< the line that could not be read

private:
    bool readMore();

    ByteSource source_;
    std::size_t longestLine_;
    std::string buffer_;
    std::size_t begin_ = 0;    ///< first byte of buffer_ that has not been given
    std::size_t scanned_ = 0;  ///< bytes before this one hold no line end
    std::size_t number_ = 0;
    bool terminated_ = true;
    bool cutShort_ = false;
    std::string problem_;
};

}  // namespace planewright
