// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/cloud_ptx.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <Eigen/LU>

#include "core/formats/cloud_points.h"
#include "core/formats/message_text.h"
#include "core/formats/number_cells.h"
#include "core/formats/pwscan_scan.h"
#include "core/formats/text_lines.h"
#include "core/formats/words.h"
#include "core/types/recording.h"

namespace planewright {

namespace {

constexpr std::size_t kLongestPtxLine = 4096;
constexpr double kFarthestPlace = 1e9;  ///< of a scan from its map's origin [m]

/// Scans of a PTX text one after another.
class PtxReader {
public:
    PtxReader(std::istream& in, const std::string& fileName) : lines_(in, kLongestPtxLine), fileName_(fileName) {}

    /// Goes to the next scan and reads its header; false where there is none.
    Result<bool> next();
    Result<CloudScan> readPoints();
    Result<void> passPoints();

private:
    tl::unexpected<Error> failHere(const std::string& what) const
    {
        return fail(ErrorCode::Unreadable, placeInFile(fileName_, lines_.number()) + what);
    }
    tl::unexpected<Error> failAtEnd(const std::string& what) const
    {
        if (!lines_.problem().empty())
            return fail(ErrorCode::Unreadable, placeInFile(fileName_, lines_.problemLine()) + lines_.problem());
        return failHere(what + "; get the whole file");
    }
    Result<int> count(std::string_view line, std::string_view what, int most) const;
    Result<void> readNumbers(std::span<double> numbers, std::string_view form);
    Result<void> readHeader(std::string_view firstLine);
    Result<void> takePose(const std::array<std::array<double, 4>, 4>& matrix);
    Result<std::optional<Eigen::Vector3d>> pointOf(std::string_view line);
    std::size_t points() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }

    TextLines lines_;
    const std::string& fileName_;
    int columns_ = 0;
    int rows_ = 0;
    Pose pose_;
    std::size_t values_ = 0;  ///< of a point of this scan
};

Result<bool> PtxReader::next()
{
    while (const auto line = lines_.next()) {
        if (trimmed(*line).empty())
            continue;
        if (const auto header = readHeader(*line); !header)
            return tl::unexpected{header.error()};
        return true;
    }
    if (!lines_.problem().empty() || lines_.cutShort())
        return failAtEnd("the compressed data stop in the middle");
    return false;
}

Result<int> PtxReader::count(std::string_view line, std::string_view what, int most) const
{
    const auto number = readNumber<int>(trimmed(line));
    if (!number || *number < 1 || *number > most)
        return failHere(quotedText(line) + " is no number of " + std::string{what} + " from 1 to " +
                        std::to_string(most) + ", with which a scan of a PTX file begins; correct it");
    return *number;
}

Result<void> PtxReader::readNumbers(std::span<double> numbers, std::string_view form)
{
    const auto line = lines_.next();
    if (!line)
        return failAtEnd("the file ends in the header of a scan");
    const std::vector<std::string_view> words = wordsIn(*line, numbers.size());
    bool isRight = words.size() == numbers.size();
    for (std::size_t i = 0; isRight && i < numbers.size(); ++i) {
        const auto number = readNumber<double>(words[i]);
        isRight = number && std::abs(*number) <= kFarthestPlace;
        numbers[i] = number.value_or(0.0);
    }
    if (!isRight)
        return failHere(quotedText(*line) + " is not of the form " + std::string{form} + "; correct it");
    return {};
}

/// The matrix multiplies points from the right.
Result<void> PtxReader::takePose(const std::array<std::array<double, 4>, 4>& matrix)
{
    Eigen::Matrix3d rotation;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column)
            rotation(static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(row)) = matrix[row][column];
    }
    const bool isPlain = matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
    const double off = (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!isPlain || !(off < 1e-3) || !(rotation.determinant() > 0.0))
        return failHere(
            "the matrix above is no rotation with a translation in its last line; give the scan as it was measured");
    pose_ = {Eigen::Quaterniond(rotation).normalized(), {matrix[3][0], matrix[3][1], matrix[3][2]}};
    return {};
}

Result<void> PtxReader::readHeader(std::string_view firstLine)
{
    const auto columns = count(firstLine, "columns", kMaxSlices);
    if (!columns)
        return tl::unexpected{columns.error()};
    const auto second = lines_.next();
    if (!second)
        return failAtEnd("the file ends in the header of a scan");
    const auto rows = count(*second, "rows", kMaxBeams);
    if (!rows)
        return tl::unexpected{rows.error()};
    columns_ = *columns;
    rows_ = *rows;
    if (points() > kMaxRanges)
        return failHere("more than " + std::to_string(kMaxRanges) + " points in a scan; divide it");
    std::array<double, 3> registered{};
    for (int line = 0; line < 4; ++line) {
        if (const auto read = readNumbers(registered, "x y z"); !read)
            return read;
    }
    std::array<std::array<double, 4>, 4> matrix{};
    for (auto& line : matrix) {
        if (const auto read = readNumbers(line, "r1 r2 r3 0 of a matrix"); !read)
            return read;
    }
    values_ = 0;
    return takePose(matrix);
}

/// Nothing for no return.
Result<std::optional<Eigen::Vector3d>> PtxReader::pointOf(std::string_view line)
{
    constexpr std::size_t kPlain = 4;
    constexpr std::size_t kColoured = 7;
    const std::vector<std::string_view> words = wordsIn(line, kColoured);
    if ((words.size() != kPlain && words.size() != kColoured) || (values_ != 0 && words.size() != values_))
        return failHere(quotedText(line) +
                        " is no point x y z intensity, or x y z intensity red green blue as all "
                        "others; correct it, or the numbers of columns and rows");
    values_ = words.size();
    Eigen::Vector3d point;
    for (std::size_t axis = 0; axis < words.size(); ++axis) {
        const auto value = readCoordinate(words[axis]);
        if (!value)
            return failHere(quotedText(words[axis]) + " is no number; write decimal points and no commas");
        if (axis < 3)
            point[static_cast<Eigen::Index>(axis)] = *value;
    }
    if (!point.allFinite() || point.cast<float>().isZero(0.0F))
        return std::nullopt;
    if (isTooFar(point))
        return failHere(std::string{kTooFar});
    return point;
}

Result<CloudScan> PtxReader::readPoints()
{
    CloudScan scan;
    scan.beams = rows_;
    scan.pose = pose_;
    scan.scanner = "PTX scan";
    for (int column = 0; column < columns_; ++column) {
        CloudSlice& slice = scan.slices.emplace_back();
        for (int row = 0; row < rows_; ++row) {
            const auto line = lines_.next();
            if (!line)
                return failAtEnd("the scan ends in column " + std::to_string(column) + " of " +
                                 std::to_string(columns_));
            const auto point = pointOf(*line);
            if (!point)
                return tl::unexpected{point.error()};
            if (*point)
                slice.push_back({(*point)->cast<float>(), row});
        }
    }
    if (lines_.cutShort())
        return failAtEnd("the compressed data stop in the middle");
    return scan;
}

Result<void> PtxReader::passPoints()
{
    for (std::size_t i = 0; i < points(); ++i) {
        if (!lines_.next())
            return failAtEnd("the scan ends after " + std::to_string(i) + " of " + std::to_string(points()) +
                             " points");
    }
    return {};
}

}  // namespace

Result<CloudScan> readCloudPtx(std::istream& in, const std::string& fileName, int scan)
{
    PtxReader reader{in, fileName};
    for (int number = 0;; ++number) {
        const auto there = reader.next();
        if (!there)
            return tl::unexpected{there.error()};
        if (!*there && number == 0)
            return fail(ErrorCode::Unreadable, fileName + ": there is no scan in it; get the whole file");
        if (!*there)
            return fail(ErrorCode::Usage, fileName + ": there is no scan " + std::to_string(scan) +
                                              "; choose one of 0 to " + std::to_string(number - 1));
        if (number == scan)
            return reader.readPoints();
        if (const auto passed = reader.passPoints(); !passed)
            return tl::unexpected{passed.error()};
    }
}

Result<int> scansOfPtx(std::istream& in, const std::string& fileName)
{
    PtxReader reader{in, fileName};
    for (int number = 0;; ++number) {
        const auto there = reader.next();
        if (!there)
            return tl::unexpected{there.error()};
        if (!*there && number == 0)
            return fail(ErrorCode::Unreadable, fileName + ": there is no scan in it; get the whole file");
        if (!*there)
            return number;
        if (number == kMaxScans)
            return fail(ErrorCode::Unreadable,
                        fileName + ": more than " + std::to_string(kMaxScans) + " scans; divide the file");
        if (const auto passed = reader.passPoints(); !passed)
            return tl::unexpected{passed.error()};
    }
}

}  // namespace planewright
