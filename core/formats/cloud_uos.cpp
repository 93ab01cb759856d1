// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/cloud_uos.h"

#include <cmath>
#include <vector>

#include "core/formats/cloud_points.h"
#include "core/formats/message_text.h"
#include "core/formats/number_cells.h"
#include "core/formats/text_lines.h"
#include "core/formats/words.h"
#include "core/types/angle.h"
#include "core/types/recording.h"

namespace planewright {

namespace {

constexpr std::size_t kLongestUosLine = 4096;
constexpr std::size_t kMostUosValues = 7;
constexpr double kCentimetres = 0.01;
constexpr double kFarthestPose = 1e9;  ///< [m]

/// `180 x 256`.
bool isUosHeader(std::string_view line)
{
    const std::vector<std::string_view> words = wordsIn(line, 3);
    return words.size() == 3 && words[1] == "x" && readNumber<int>(words[0]) && readNumber<int>(words[2]);
}

/// From x right, y up, z ahead to x right, y ahead, z up.
Eigen::Vector3d inOurFrame(const Eigen::Vector3d& vector)
{
    return {vector.x(), vector.z(), vector.y()};
}

tl::unexpected<Error> failReading(const TextLines& lines, const std::string& fileName)
{
    return lines.problem().empty()
               ? fail(ErrorCode::Unreadable, fileName + ": the compressed data stop in the middle; get the whole file")
               : fail(ErrorCode::Unreadable, placeInFile(fileName, lines.problemLine()) + lines.problem());
}

}  // namespace

Result<CloudScan> readCloudUos(std::istream& in, const std::string& fileName)
{
    TextLines lines{in, kLongestUosLine};
    std::vector<Eigen::Vector3f> points;
    std::size_t values = 0;
    const auto wrong = [&](const std::string& what) {
        return fail(ErrorCode::Unreadable, placeInFile(fileName, lines.number()) + what);
    };
    while (const auto line = lines.next()) {
        const std::string_view text = trimmed(*line);
        if (text.empty() || text.front() == '#' || (values == 0 && isUosHeader(text)))
            continue;
        const std::vector<std::string_view> words = wordsIn(text, kMostUosValues);
        if (words.size() < 3 || words.size() > kMostUosValues || (values != 0 && words.size() != values))
            return wrong(quotedText(text) + " is no point x y z as the others; correct or remove it");
        values = words.size();
        Eigen::Vector3d point;
        for (std::size_t i = 0; i < values; ++i) {
            const auto value = readNumber<double>(words[i]);
            if (!value)
                return wrong(quotedText(words[i]) + " is no number; write decimal points and no commas");
            if (i < 3)
                point[static_cast<Eigen::Index>(i)] = *value;
        }
        point = inOurFrame(kCentimetres * point);
        if (isTooFar(point))
            return wrong("the point is farther than 1000 m; give coordinates in centimetres");
        if (points.size() == kMaxRanges)
            return wrong("more than " + std::to_string(kMaxRanges) + " points; divide the scan");
        if (!point.cast<float>().isZero(0.0F))
            points.push_back(point.cast<float>());
    }
    if (!lines.problem().empty() || lines.cutShort())
        return failReading(lines, fileName);
    if (points.empty())
        return fail(ErrorCode::Unreadable, fileName + ": there is no point in it; a line has x y z");
    CloudScan scan;
    scan.scanner = "uos scan";
    scan.slices = splitSweeps(points);
    if (scan.slices.size() > static_cast<std::size_t>(kMaxSlices))
        return fail(ErrorCode::Unreadable, fileName + ": the bearing turns back more than " +
                                               std::to_string(kMaxSlices) +
                                               " times; give the points in the order of measurement");
    return scan;
}

Result<Pose> readPoseUos(std::istream& in, const std::string& fileName)
{
    TextLines lines{in, kLongestUosLine};
    std::vector<double> numbers;
    while (const auto line = lines.next()) {
        for (const std::string_view word : wordsIn(*line, 6)) {
            const auto number = readNumber<double>(word);
            if (!number || numbers.size() == 6 || std::abs(*number) > kFarthestPose)
                return fail(ErrorCode::Unreadable,
                            placeInFile(fileName, lines.number()) + quotedText(word) +
                                " does not belong here; a pose has x y z and three angles, six numbers in all");
            numbers.push_back(*number);
        }
    }
    if (!lines.problem().empty() || lines.cutShort())
        return failReading(lines, fileName);
    if (numbers.size() != 6)
        return fail(ErrorCode::Unreadable, fileName + ": has " + std::to_string(numbers.size()) +
                                               " numbers; a pose has x y z and three angles, six in all");
    // Swapping y and z mirrors, and a mirrored rotation turns the other way about the mirrored axis.
    const auto about = [](const Eigen::Vector3d& axis, double angle) {
        return Eigen::Quaterniond(Eigen::AngleAxisd(-degrees(angle), inOurFrame(axis)));
    };
    return Pose{about(Eigen::Vector3d::UnitX(), numbers[3]) * about(Eigen::Vector3d::UnitY(), numbers[4]) *
                    about(Eigen::Vector3d::UnitZ(), numbers[5]),
                kCentimetres * inOurFrame({numbers[0], numbers[1], numbers[2]})};
}

}  // namespace planewright
