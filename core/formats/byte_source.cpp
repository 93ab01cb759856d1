// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/byte_source.h"

#include <algorithm>
#include <cstring>

#include <zlib.h>

namespace planewright {

namespace {
constexpr std::size_t kInputSize = std::size_t{64} * 1024;
constexpr int kGzipOnly = 15 + 16;  // the largest window, and a gzip header as zlib asks for it
}  // namespace

void ByteSource::Inflater::operator()(z_stream_s* stream) const
{
    inflateEnd(stream);
    delete stream;
}

ByteSource::ByteSource(std::istream& in) : in_(in), input_(kInputSize)
{
    if (!in_.good()) {
        end_ = End::Unreadable;
        return;
    }
    in_.read(input_.data(), static_cast<std::streamsize>(input_.size()));
    last_ = static_cast<std::size_t>(in_.gcount());
    if (last_ >= 2 && input_[0] == '\x1f' && input_[1] == '\x8b') {
        auto stream = std::make_unique<z_stream>();
        if (inflateInit2(stream.get(), kGzipOnly) == Z_OK)
            inflater_.reset(stream.release());
        else
            end_ = End::Unreadable;
    }
}

bool ByteSource::fill()
{
    if (next_ < last_)
        return true;
    if (!in_.good()) {
        end_ = in_.bad() ? End::Unreadable : End::Complete;
        return false;
    }
    in_.read(input_.data(), static_cast<std::streamsize>(input_.size()));
    next_ = 0;
    last_ = static_cast<std::size_t>(in_.gcount());
    if (last_ == 0)
        end_ = in_.bad() ? End::Unreadable : End::Complete;
    return last_ != 0;
}

std::size_t ByteSource::read(char* to, std::size_t size)
{
    if (end_ != End::NotYet || size == 0)
        return 0;
    return inflater_ ? readInflated(to, size) : readPlain(to, size);
}

std::size_t ByteSource::readPlain(char* to, std::size_t size)
{
    if (!fill())
        return 0;
    const std::size_t count = std::min(size, last_ - next_);
    std::memcpy(to, input_.data() + next_, count);
    next_ += count;
    return count;
}

std::size_t ByteSource::readInflated(char* to, std::size_t size)
{
    const std::size_t most = std::min(size, kInputSize);
    z_stream& stream = *inflater_;
    for (;;) {
        if (!fill()) {
            if (end_ == End::Complete && !betweenMembers_)
                end_ = End::CutShort;
            return 0;
        }
        if (betweenMembers_) {
            inflateReset(&stream);
            betweenMembers_ = false;
            afterFirstMember_ = true;
        }
        stream.next_in = reinterpret_cast<Bytef*>(input_.data() + next_);
        stream.avail_in = static_cast<uInt>(last_ - next_);
        stream.next_out = reinterpret_cast<Bytef*>(to);
        stream.avail_out = static_cast<uInt>(most);
        const bool atStart = stream.total_out == 0;
        const int state = inflate(&stream, Z_NO_FLUSH);
        next_ = last_ - stream.avail_in;
        const std::size_t count = most - stream.avail_out;
        if (state == Z_STREAM_END)
            betweenMembers_ = true;
        else if (state != Z_OK && state != Z_BUF_ERROR)
            end_ = afterFirstMember_ && atStart ? End::Garbage : End::Corrupt;
        if (count != 0 || end_ != End::NotYet)
            return count;
    }
}

std::string problemText(ByteSource::End end)
{
    switch (end) {
        case ByteSource::End::CutShort:
            return "the compressed data stop in the middle; get the whole file";
        case ByteSource::End::Corrupt:
            return "the compressed data are damaged here; get the file again";
        case ByteSource::End::Garbage:
            return "something that is not gzip follows the compressed data; compress the file anew";
        case ByteSource::End::Unreadable:
            return "the file cannot be read; check that it is a file and that its disk is sound";
        case ByteSource::End::NotYet:
        case ByteSource::End::Complete:
            break;
    }
    return {};
}

}  // namespace planewright
