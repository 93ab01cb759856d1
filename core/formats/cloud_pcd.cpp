// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/cloud_pcd.h"

#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/formats/cloud_points.h"
#include "core/formats/little_endian.h"
#include "core/formats/lzf.h"
#include "core/formats/message_text.h"
#include "core/formats/pcd_header.h"
#include "core/formats/words.h"
#include "core/types/recording.h"

namespace planewright {

namespace {

constexpr std::size_t kLongestPointLine = 64 * 1024;

std::string atByte(const std::string& fileName, std::uint64_t place)
{
    return fileName + ": byte " + std::to_string(place) + ": ";
}

/// A coordinate from its bytes in the file, which are little-endian.
double coordinateOf(std::string_view bytes)
{
    return bytes.size() == sizeof(float) ? static_cast<double>(readLittleEndian<float>(bytes))
                                         : readLittleEndian<double>(bytes);
}

class PcdReader {
public:
    PcdReader(std::istream& in, const std::string& fileName) : reader_(in), fileName_(fileName) {}

    Result<CloudScan> read();

private:
    Result<void> readText();
    Result<void> readBinary();
    Result<void> readCompressed();
    /// Takes the next point of the file, row after row. False where it is too far.
    bool take(const Eigen::Vector3d& point);
    Result<void> checkEnd();
    std::string tooShort() const
    {
        const std::string problem = reader_.problem();
        return problem.empty() ? "the data end after point " + std::to_string(taken_) + " of " +
                                     std::to_string(header_.points()) + "; get the whole file"
                               : problem;
    }
    tl::unexpected<Error> failHere(const std::string& what) const
    {
        return fail(ErrorCode::Unreadable, header_.data == PcdHeader::Data::Ascii
                                               ? placeInFile(fileName_, reader_.lineNumber()) + what
                                               : atByte(fileName_, reader_.place()) + what);
    }
    void turnOutOfCameraFrame();

    ByteReader reader_;
    const std::string& fileName_;
    PcdHeader header_;
    CloudScan scan_;
    std::size_t taken_ = 0;
};

bool PcdReader::take(const Eigen::Vector3d& point)
{
    const auto columns = static_cast<std::size_t>(header_.columns);
    const std::size_t beam = taken_ % columns;
    ++taken_;
    if (beam == 0)
        scan_.slices.emplace_back();
    const Eigen::Vector3d place = point - header_.viewpoint;
    if (!place.allFinite() || place.cast<float>().isZero(0.0F))
        return true;
    if (isTooFar(place))
        return false;
    scan_.slices.back().push_back({place.cast<float>(), static_cast<int>(beam)});
    return true;
}

Result<void> PcdReader::readText()
{
    const std::size_t values = header_.valuesOfPoint();
    while (taken_ < header_.points()) {
        const auto line = reader_.line(kLongestPointLine);
        if (!line)
            return failHere(tooShort());
        const std::vector<std::string_view> words = wordsIn(*line, values);
        if (words.size() != values)
            return failHere("the point has " + std::string{words.size() > values ? "more" : "fewer"} + " than the " +
                            std::to_string(values) + " values of the header; correct one of them");
        Eigen::Vector3d point;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string_view word = words[header_.valueBefore(header_.coordinates[axis])];
            const auto value = readCoordinate(word);
            if (!value)
                return failHere(quotedText(word) + " is no coordinate; give a number with a decimal point, or nan");
            point[static_cast<Eigen::Index>(axis)] = *value;
        }
        if (!take(point))
            return failHere(std::string{kTooFar});
    }
    return checkEnd();
}

Result<void> PcdReader::readBinary()
{
    const std::size_t size = header_.bytesOfPoint();
    while (taken_ < header_.points()) {
        const std::string_view bytes = reader_.bytes(size);
        if (bytes.size() < size)
            return failHere(tooShort());
        Eigen::Vector3d point;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t field = header_.coordinates[axis];
            point[static_cast<Eigen::Index>(axis)] =
                coordinateOf(bytes.substr(header_.offsetOf(field), header_.fields[field].size));
        }
        if (!take(point))
            return failHere(std::string{kTooFar});
    }
    return checkEnd();
}

Result<void> PcdReader::readCompressed()
{
    const std::size_t size = header_.points() * header_.bytesOfPoint();
    const std::string_view sizes = reader_.bytes(8);
    if (sizes.size() < 8)
        return failHere(tooShort());
    const std::size_t compressedSize = readLittleEndian<std::uint32_t>(sizes.substr(0, 4));
    const std::size_t plainSize = readLittleEndian<std::uint32_t>(sizes.substr(4, 4));
    if (plainSize != size)
        return failHere("the compressed data are of " + std::to_string(plainSize) + " bytes and the header tells of " +
                        std::to_string(size) + "; get a sound copy");
    std::string plain;
    {
        const std::string_view compressed = reader_.bytes(compressedSize);
        if (compressed.size() < compressedSize)
            return failHere(tooShort());
        if (plainSize / kMostLzfGrowth > compressedSize || !decompressLzf(compressed, plainSize, plain))
            return failHere("the compressed data are damaged; get the file again");
    }
    // Field after field, each with the values of all points.
    for (std::size_t i = 0; i < header_.points(); ++i) {
        Eigen::Vector3d point;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t field = header_.coordinates[axis];
            const std::size_t width = header_.fields[field].size;
            point[static_cast<Eigen::Index>(axis)] = coordinateOf(
                std::string_view{plain}.substr(header_.offsetOf(field) * header_.points() + i * width, width));
        }
        if (!take(point))
            return failHere("point " + std::to_string(i) + ": " + std::string{kTooFar});
    }
    return checkEnd();
}

/// Some writers fill compressed data up with zeros, and texts end with blank lines.
Result<void> PcdReader::checkEnd()
{
    for (;;) {
        const std::string_view more = reader_.bytes(4096);
        if (more.empty())
            break;
        if (more.find_first_not_of(std::string_view{"\0 \t\r\n", 5}) != std::string_view::npos)
            return failHere("something follows the last point; correct WIDTH and HEIGHT, or get a sound copy");
    }
    if (const std::string problem = reader_.problem(); !problem.empty())
        return failHere(problem);
    return {};
}

/// To x right, y forward, z up.
void PcdReader::turnOutOfCameraFrame()
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    bool isBefore = true;
    for (const CloudSlice& slice : scan_.slices) {
        for (const CloudPoint& point : slice) {
            isBefore = isBefore && point.place.z() > 0.0F;
            sum += point.place.cast<double>().normalized();
        }
    }
    if (!isBefore || !(sum.z() > std::numbers::sqrt2 / 2.0 * sum.norm()))
        return;
    for (CloudSlice& slice : scan_.slices) {
        for (CloudPoint& point : slice)
            point.place = {point.place.x(), point.place.z(), -point.place.y()};
    }
    if (scan_.pose)
        scan_.pose->rotation = rotationAbout(Eigen::Vector3d::UnitX() * (0.5 * std::numbers::pi));
    scan_.notes.emplace_back("in a camera's frame (z ahead, y down); turned to y ahead, z up");
}

Result<CloudScan> PcdReader::read()
{
    auto header = readPcdHeader(reader_, fileName_);
    if (!header)
        return tl::unexpected{header.error()};
    header_ = std::move(*header);
    scan_.beams = header_.columns;
    scan_.scanner = "PCD cloud";
    if (!header_.viewpoint.isZero(0.0))
        scan_.pose = Pose{Eigen::Quaterniond::Identity(), header_.viewpoint};
    const auto done = header_.data == PcdHeader::Data::Ascii    ? readText()
                      : header_.data == PcdHeader::Data::Binary ? readBinary()
                                                                : readCompressed();
    if (!done)
        return tl::unexpected{done.error()};
    turnOutOfCameraFrame();
    return std::move(scan_);
}

}  // namespace

Result<CloudScan> readCloudPcd(std::istream& in, const std::string& fileName)
{
    return PcdReader{in, fileName}.read();
}

}  // namespace planewright
