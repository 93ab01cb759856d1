// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/trajectory_tum.h"

#include <array>
#include <cmath>
#include <istream>
#include <ostream>
#include <string_view>

#include "core/formats/message_text.h"
#include "core/formats/number_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/text_lines.h"
#include "core/formats/written.h"

namespace planewright {

namespace {

constexpr std::array<std::string_view, 8> kValues{"timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"};
constexpr std::string_view kBlanks = " \t";
constexpr double kFarthest = 1e9;  // [m], [s] times ten

/// The numbers of a line; or which of them is wrong, and how.
tl::expected<std::array<double, kValues.size()>, std::string> numbersOf(std::string_view line)
{
    std::array<double, kValues.size()> numbers{};
    std::size_t count = 0;
    for (std::size_t begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;
         begin = line.find_first_not_of(kBlanks)) {
        line.remove_prefix(begin);
        const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
        line.remove_prefix(word.size());
        if (count == numbers.size())
            return tl::unexpected{std::string{"more than the 8 values timestamp tx ty tz qx qy qz qw"}};
        const auto number = readNumber<double>(word);
        const double limit = count == 0 ? 10.0 * kFarthest : kFarthest;
        if (!number || std::abs(*number) > limit)
            return tl::unexpected{std::string{kValues[count]} + " is " + quotedText(word) +
                                  ", which is no number within its limits"};
        numbers[count++] = *number;
    }
    if (count < numbers.size())
        return tl::unexpected{std::string{kValues[count]} + " is missing; a line has timestamp tx ty tz qx qy qz qw"};
    return numbers;
}

}  // namespace

Result<std::vector<StampedPose>> readTrajectoryTum(std::istream& in, const std::string& fileName)
{
    TextLines lines{in};
    std::vector<StampedPose> poses;
    const auto wrong = [&](const std::string& what) {
        return fail(ErrorCode::Unreadable, placeInFile(fileName, lines.number()) + what);
    };
    while (const auto line = lines.next()) {
        const std::string_view text = trimmed(*line);
        if (text.empty() || text.front() == '#')
            continue;
        const auto numbers = numbersOf(text);
        if (!numbers)
            return wrong(numbers.error());
        const auto& [time, x, y, z, qx, qy, qz, qw] = *numbers;
        const Eigen::Quaterniond rotation{qw, qx, qy, qz};
        if (std::abs(rotation.norm() - 1.0) > 1e-3)
            return wrong("the quaternion qx qy qz qw is not of length 1; correct it");
        if (!poses.empty() && time < poses.back().time)
            return wrong("the time runs backwards; put the poses in their order");
        if (poses.size() == kMaxPoses)
            return wrong("more than " + std::to_string(kMaxPoses) + " poses; give a shorter trajectory");
        poses.push_back({time, {rotation.normalized(), {x, y, z}}});
    }
    if (!lines.problem().empty())
        return fail(ErrorCode::Unreadable, placeInFile(fileName, lines.problemLine()) + lines.problem());
    if (lines.cutShort())
        return fail(ErrorCode::Unreadable,
                    placeInFile(fileName, 0) + "the compressed data stop in the middle; get the whole file");
    if (poses.empty())
        return fail(ErrorCode::Unreadable,
                    placeInFile(fileName, 0) + "there is no pose in it; a line has timestamp tx ty tz qx qy qz qw");
    return poses;
}

Result<void> writeTrajectoryTum(std::ostream& out, std::span<const StampedPose> poses)
{
    std::string text = "# timestamp tx ty tz qx qy qz qw\n";
    for (const StampedPose& stamped : poses) {
        Eigen::Quaterniond q = stamped.pose.rotation;
        if (q.w() < 0.0)
            q.coeffs() *= -1.0;
        const Eigen::Vector3d& t = stamped.pose.translation;
        appendNumber(text, stamped.time);
        for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
            text += ' ';
            appendNumber(text, value);
        }
        text += '\n';
    }
    out << text;
    return written(out);
}

}  // namespace planewright
