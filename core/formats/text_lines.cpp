// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/text_lines.h"

namespace planewright {

namespace {

constexpr std::size_t kReadSize = std::size_t{64} * 1024;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

TextLines::TextLines(std::istream& in, std::size_t longestLine) : source_(in), longestLine_(longestLine) {}

bool TextLines::readMore()
{
    buffer_.erase(0, begin_);
    scanned_ -= begin_;
    begin_ = 0;
    const std::size_t filled = buffer_.size();
    buffer_.resize(filled + kReadSize);
    const std::size_t count = source_.read(buffer_.data() + filled, kReadSize);
    buffer_.resize(filled + count);
    if (number_ == 0 && filled < kByteOrderMark.size() && std::string_view{buffer_}.starts_with(kByteOrderMark)) {
        buffer_.erase(0, kByteOrderMark.size());
        scanned_ = 0;
    }
    return count != 0;
}

std::optional<std::string_view> TextLines::next()
{
    if (!problem_.empty())
        return std::nullopt;
    std::size_t length = 0;
    for (;;) {
        const std::size_t found = buffer_.find('\n', scanned_);
        terminated_ = found != std::string::npos;
        const std::size_t lineEnd = terminated_ ? found : buffer_.size();
        length = lineEnd - begin_;
        scanned_ = lineEnd;
        if (length > longestLine_) {
            problem_ = "the line is longer than " + std::to_string(longestLine_) +
                       " bytes; this is not a file of this kind, or its line ends are lost";
            return std::nullopt;
        }
        if (terminated_)
            break;
        if (!readMore()) {
            cutShort_ = source_.end() == ByteSource::End::CutShort;
            if (!cutShort_)
                problem_ = problemText(source_.end());
            if (!problem_.empty() || buffer_.empty())
                return std::nullopt;
            length = buffer_.size();
            break;
        }
    }
    ++number_;
    std::string_view line{buffer_.data() + begin_, length};
    begin_ += length + (terminated_ ? 1 : 0);
    scanned_ = begin_;
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    return line;
}

}  // namespace planewright
