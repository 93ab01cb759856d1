// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/output_target.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

#include <climits>

namespace planewright {

namespace {

constexpr int kMostLinks = 40;

/// The number of the descriptor that a path stands for.
std::optional<int> descriptorOf(std::string_view path)
{
    if (path == "/dev/stdout")
        return STDOUT_FILENO;
    if (path == "/dev/stderr")
        return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!path.starts_with(folder))
            continue;
        const std::string_view digits = path.substr(folder.size());
        int number = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (error == std::errc{} && end == digits.data() + digits.size() && number >= 0)
            return number;
    }
    return std::nullopt;
}

std::optional<std::string> linkTarget(const std::string& path)
{
    std::array<char, PATH_MAX> text;
    const ssize_t size = ::readlink(path.c_str(), text.data(), text.size());
    if (size <= 0 || static_cast<std::size_t>(size) == text.size())
        return std::nullopt;
    std::string target{text.data(), static_cast<std::size_t>(size)};
    return target.front() == '/' ? target : folderOf(path) + "/" + target;
}

}  // namespace

std::string folderOf(const std::string& path)
{
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos)
        return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

Result<OutputTarget> outputTargetOf(const std::string& path)
{
    std::string target = path;
    for (int links = 0; links < kMostLinks; ++links) {
        if (const auto descriptor = descriptorOf(target))
            return OutputTarget{OutputTarget::Kind::Descriptor, target, *descriptor};
        struct stat status {};
        if (::lstat(target.c_str(), &status) != 0) {
            if (errno == ENOENT && !target.empty() && target.back() != '/')
                return OutputTarget{OutputTarget::Kind::New, target, -1};
            return fail(ErrorCode::NotWritten, std::strerror(errno));
        }
        if (S_ISREG(status.st_mode))
            return OutputTarget{OutputTarget::Kind::Existing, target, -1};
        if (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode))
            return OutputTarget{OutputTarget::Kind::Direct, target, -1};
        if (S_ISDIR(status.st_mode))
            return fail(ErrorCode::NotWritten, "this is a folder; give the name of a file in it");
        if (!S_ISLNK(status.st_mode))
            return fail(ErrorCode::NotWritten, "this is a device or socket; give the name of a file");
        const auto next = linkTarget(target);
        if (!next)
            return fail(ErrorCode::NotWritten, "the symbolic link cannot be followed; give the name of a file");
        target = *next;
    }
    return fail(ErrorCode::NotWritten, "the symbolic links lead in a ring; give the name of a file");
}

}  // namespace planewright
