// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/output_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/cli/output_target.h"
#include "app/cli/temporary_files.h"

namespace planewright {

namespace {

constexpr std::string_view kExists = "the file exists; give --overwrite to replace it, or another name";

/// What to do about an errno of opening, writing or renaming.
std::string advice(int error)
{
    const std::string what = std::strerror(error);
    switch (error) {
        case ENOENT:
            return "there is no such folder; create it first";
        case EEXIST:
            return std::string{kExists};
        case ENOSPC:
        case EDQUOT:
            return what + "; free some space or write to another disk";
        case EACCES:
        case EPERM:
        case EROFS:
            return what + "; write to a folder of your own";
        default:
            return "cannot be written: " + what;
    }
}

/// Renames without ever replacing, also where the file system knows no such rename.
int renameToNew(const char* from, const char* to)
{
    if (::renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE) == 0)
        return 0;
    if (errno != EINVAL && errno != ENOSYS)
        return -1;
    if (::link(from, to) == 0)
        return ::unlink(from);
    if (errno == EEXIST)
        return -1;
    // Neither is known here, as on some network and user-space file systems: look before leaping.
    struct stat status {};
    if (::lstat(to, &status) == 0) {
        errno = EEXIST;
        return -1;
    }
    return std::rename(from, to);
}

}  // namespace

Result<std::unique_ptr<OutputFile>> OutputFile::open(const std::string& path, bool overwrite)
{
    Result<OutputTarget> target = outputTargetOf(path);
    if (!target)
        return fail(ErrorCode::NotWritten, path + ": " + target.error().message);
    std::unique_ptr<OutputFile> file{new OutputFile{path, overwrite}};
    file->target_ = std::move(target->path);
    Result<void> opened;
    switch (target->kind) {
        case OutputTarget::Kind::Descriptor:
            opened = file->openDirectly(::fcntl(target->descriptor, F_DUPFD_CLOEXEC, 3));
            break;
        case OutputTarget::Kind::Direct:
            opened = file->openDirectly(::open(file->target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
            break;
        case OutputTarget::Kind::Existing:
            if (!overwrite)
                return fail(ErrorCode::NotWritten, path + ": " + std::string{kExists});
            file->replaces_ = true;
            opened = file->openBeside();
            break;
        case OutputTarget::Kind::New:
            opened = file->openBeside();
            break;
    }
    if (!opened)
        return tl::unexpected{opened.error()};
    file->buffer_ = std::make_unique<DescriptorOutputBuffer>(file->descriptor_);
    file->stream_ = std::make_unique<std::ostream>(file->buffer_.get());
    return file;
}

Result<void> OutputFile::openDirectly(int descriptor)
{
    if (descriptor < 0)
        return failure(errno);
    descriptor_ = descriptor;
    return {};
}

Result<void> OutputFile::openBeside()
{
    descriptor_ = createTemporaryFile(folderOf(target_), temporary_);
    if (descriptor_ < 0) {
        const int error = errno;
        temporary_.clear();
        return failure(error);
    }
    struct stat status {};
    if (replaces_ && ::stat(target_.c_str(), &status) == 0) {
        // The new file takes over owner and rights where the system lets it; neither is worth failing for.
        [[maybe_unused]] const int owner = ::fchown(descriptor_, status.st_uid, status.st_gid);
        [[maybe_unused]] const int rights = ::fchmod(descriptor_, status.st_mode & 0777);
    }
    return {};
}

OutputFile::~OutputFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
    if (!temporary_.empty())
        removeTemporaryFile(temporary_);
}

tl::unexpected<Error> OutputFile::failure(int error) const
{
    return fail(ErrorCode::NotWritten, path_ + ": " + advice(error));
}

Result<void> OutputFile::writeWhole(const std::string& path, bool overwrite,
                                    const std::function<Result<void>(std::ostream&)>& writer)
{
    const auto file = open(path, overwrite);
    if (!file)
        return tl::unexpected{file.error()};
    return (*file)->write(writer).and_then([&] { return (*file)->finish(); }).and_then([&] {
        return (*file)->publish();
    });
}

Result<void> OutputFile::write(const std::function<Result<void>(std::ostream&)>& writer)
{
    Result<void> written = writer(*stream_);
    if (buffer_->error() != 0)
        return failure(buffer_->error());
    if (!written)
        return fail(written.error().code, path_ + ": " + written.error().message);
    if (!*stream_)
        return failure(EIO);
    return {};
}

Result<void> OutputFile::finish()
{
    stream_->flush();
    int error = buffer_->error();
    // Only what has a disk below it can be brought there; a pipe answers EINVAL.
    if (error == 0 && !temporary_.empty() && ::fsync(descriptor_) != 0)
        error = errno;
    if (::close(descriptor_) != 0 && error == 0 && errno != EINTR)
        error = errno;
    descriptor_ = -1;
    if (error != 0)
        return failure(error);
    return {};
}

Result<void> OutputFile::publish()
{
    if (temporary_.empty())
        return {};
    const int renamed = overwrite_ ? std::rename(temporary_.c_str(), target_.c_str())
                                   : renameToNew(temporary_.c_str(), target_.c_str());
    if (renamed != 0)
        return failure(errno);
    forgetTemporaryFile(temporary_);
    temporary_.clear();
    published_ = true;
    return {};
}

void OutputFile::retract()
{
    if (published_ && !replaces_)
        ::unlink(target_.c_str());
    published_ = false;
}

std::string OutputFile::identity() const
{
    if (temporary_.empty())
        return {};
    const std::size_t slash = target_.rfind('/');
    const std::string name = slash == std::string::npos ? target_ : target_.substr(slash + 1);
    struct stat folder {};
    if (::stat(folderOf(target_).c_str(), &folder) != 0)
        return {};
    return std::to_string(folder.st_dev) + ":" + std::to_string(folder.st_ino) + ":" + name;
}

}  // namespace planewright
