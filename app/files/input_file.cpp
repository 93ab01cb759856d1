// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/files/input_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <ios>
#include <streambuf>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace planewright {

namespace {

/// Reads from a file descriptor, which it owns.
class DescriptorBuffer : public std::streambuf {
public:
    DescriptorBuffer(int descriptor, std::stop_token stop) : descriptor_(descriptor), stop_(std::move(stop)) {}
    DescriptorBuffer(const DescriptorBuffer&) = delete;
    DescriptorBuffer& operator=(const DescriptorBuffer&) = delete;
    ~DescriptorBuffer() override { ::close(descriptor_); }

protected:
    int_type underflow() override
    {
        if (stop_.stop_requested())
            throw std::ios_base::failure{"stop"};
        ssize_t count = 0;
        do {
            count = ::read(descriptor_, bytes_.data(), bytes_.size());
        } while (count < 0 && errno == EINTR);
        if (count < 0)
            throw std::ios_base::failure{"read"};  // the stream catches it and sets its badbit
        if (count == 0)
            return traits_type::eof();
        setg(bytes_.data(), bytes_.data(), bytes_.data() + count);
        return traits_type::to_int_type(bytes_[0]);
    }

private:
    int descriptor_;
    std::stop_token stop_;
    std::array<char, 1 << 16> bytes_;
};

class DescriptorStream : public std::istream {
public:
    DescriptorStream(int descriptor, const std::stop_token& stop) : std::istream(nullptr), buffer_(descriptor, stop)
    {
        rdbuf(&buffer_);
    }

private:
    DescriptorBuffer buffer_;
};

std::string systemAdvice(int error)
{
    switch (error) {
        case ENOENT:
            return "there is no such file; check its name and folder";
        case EACCES:
        case EPERM:
            return "no permission to read it; ask its owner or copy it to a place of your own";
        case EISDIR:
            return "this is a folder; give a file in it";
        default:
            return std::string{"cannot be read: "} + std::strerror(error);
    }
}

}  // namespace

Result<std::unique_ptr<std::istream>> openInput(const std::string& path, const std::stop_token& stop)
{
    // Without O_NONBLOCK opening a named pipe would wait for a writer.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0)
        return fail(ErrorCode::Unreadable, path + ": " + systemAdvice(errno));
    std::unique_ptr<std::istream> stream = std::make_unique<DescriptorStream>(descriptor, stop);
    struct stat status {};
    if (::fstat(descriptor, &status) != 0)
        return fail(ErrorCode::Unreadable, path + ": " + systemAdvice(errno));
    if (S_ISDIR(status.st_mode))
        return fail(ErrorCode::Unreadable, path + ": " + systemAdvice(EISDIR));
    if (!S_ISREG(status.st_mode))
        return fail(ErrorCode::Unreadable, path + ": this is a device or pipe; give a regular file");
    if (status.st_size > kLargestInput)
        return fail(ErrorCode::Unreadable, path + ": the file is larger than 4 GiB, no recording is; give another");
    return stream;
}

}  // namespace planewright
