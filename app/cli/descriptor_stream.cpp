// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/descriptor_stream.h"

#include <cerrno>
#include <unistd.h>

namespace planewright {

DescriptorOutputBuffer::DescriptorOutputBuffer(int descriptor) : descriptor_(descriptor)
{
    setp(bytes_.data(), bytes_.data() + bytes_.size());
}

bool DescriptorOutputBuffer::writeOut(const char* bytes, std::size_t size)
{
    while (size > 0 && error_ == 0) {
        const ssize_t written = ::write(descriptor_, bytes, size);
        if (written < 0) {
            error_ = errno == EINTR ? 0 : errno;
            continue;
        }
        bytes += written;
        size -= static_cast<std::size_t>(written);
    }
    return error_ == 0;
}

bool DescriptorOutputBuffer::flushBytes()
{
    const bool done = writeOut(pbase(), static_cast<std::size_t>(pptr() - pbase()));
    setp(bytes_.data(), bytes_.data() + bytes_.size());
    return done;
}

DescriptorOutputBuffer::int_type DescriptorOutputBuffer::overflow(int_type c)
{
    if (!flushBytes())
        return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof()))
        sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
}

int DescriptorOutputBuffer::sync()
{
    return flushBytes() ? 0 : -1;
}

std::streamsize DescriptorOutputBuffer::xsputn(const char* text, std::streamsize size)
{
    if (size < epptr() - pptr())
        return std::streambuf::xsputn(text, size);
    return flushBytes() && writeOut(text, static_cast<std::size_t>(size)) ? size : 0;
}

}  // namespace planewright
