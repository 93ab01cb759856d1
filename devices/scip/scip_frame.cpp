// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_frame.h"

#include <algorithm>
#include <optional>
#include <string>

#include "devices/scip/scip_encoding.h"

namespace planewright {

namespace {

using Refused = tl::unexpected<ScipDamageKind>;

/// Before the further echoes of a beam.
constexpr char kAnotherEcho = '&';
constexpr int kMostEchoes = 3;

constexpr std::size_t kStampLength = 4;

/// The lines of data without their sums, one behind the other.
tl::expected<std::string, ScipDamageKind> readBlock(std::span<const std::string_view> lines)
{
    std::string payload;
    payload.reserve(lines.size() * kScipLineLength);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view line = lines[i];
        const bool isLast = i + 1 == lines.size();
        if (line.empty())
            return Refused{ScipDamageKind::LineTooLong};
        if (line.size() < 2 || line.size() > kScipLineLength + 1 || (!isLast && line.size() != kScipLineLength + 1))
            return Refused{ScipDamageKind::LineLength};
        if (!endsWithScipSum(line))
            return Refused{ScipDamageKind::Sum};
        payload += line.substr(0, line.size() - 1);
    }
    return payload;
}

/// Numbers one behind the other.
class Numbers {
public:
    explicit Numbers(std::string_view text) : rest_(text) {}

    bool areLeft() const { return !rest_.empty(); }

    /// Passes over the mark of another echo, where it stands next.
    bool takeMark()
    {
        if (rest_.empty() || rest_.front() != kAnotherEcho)
            return false;
        rest_.remove_prefix(1);
        return true;
    }

    tl::expected<std::uint32_t, ScipDamageKind> take(int characters)
    {
        const auto length = static_cast<std::size_t>(characters);
        if (rest_.size() < length)
            return Refused{ScipDamageKind::Count};
        const std::optional<std::uint32_t> value = fromScip(rest_.substr(0, length));
        if (!value)
            return Refused{ScipDamageKind::Character};
        rest_.remove_prefix(length);
        return *value;
    }

private:
    std::string_view rest_;
};

tl::expected<void, ScipDamageKind> readValues(Numbers numbers, ScipFrame& frame)
{
    const ScipMeasurement& asked = frame.measurement;
    const auto wanted = static_cast<std::size_t>(asked.values());
    int echoes = 0;
    while (numbers.areLeft()) {
        const bool isFurther = asked.isMultiEcho() && numbers.takeMark();
        echoes = isFurther ? echoes + 1 : 1;
        if (echoes > kMostEchoes || (isFurther && frame.ranges.empty()) ||
            (!isFurther && frame.ranges.size() == wanted))
            return Refused{ScipDamageKind::Count};
        const auto range = numbers.take(asked.charactersPerRange());
        const auto intensity = range && asked.hasIntensity() ? numbers.take(3) : range;
        if (!intensity)
            return Refused{intensity.error()};
        if (isFurther) {
            frame.furtherEchoes.push_back({frame.ranges.size() - 1, *range, asked.hasIntensity() ? *intensity : 0});
            continue;
        }
        frame.ranges.push_back(*range);
        if (asked.hasIntensity())
            frame.intensities.push_back(*intensity);
    }
    if (frame.ranges.size() != wanted)
        return Refused{ScipDamageKind::Count};
    return {};
}

}  // namespace

tl::expected<ScipFrame, ScipDamageKind> readScipFrame(const ScipMeasurement& measurement,
                                                      std::span<const std::string_view> lines)
{
    if (lines.empty())
        return Refused{ScipDamageKind::Count};
    if (lines[0].size() != kStampLength + 1)
        return Refused{ScipDamageKind::LineLength};
    if (!endsWithScipSum(lines[0]))
        return Refused{ScipDamageKind::Sum};
    const std::optional<std::uint32_t> stamp = fromScip(lines[0].substr(0, kStampLength));
    if (!stamp)
        return Refused{ScipDamageKind::Character};
    const auto payload = readBlock(lines.subspan(1));
    if (!payload)
        return Refused{payload.error()};

    ScipFrame frame;
    frame.measurement = measurement;
    frame.stamp = *stamp;
    frame.ranges.reserve(std::min(payload->size() / 2, static_cast<std::size_t>(measurement.values())));
    const auto read = readValues(Numbers{*payload}, frame);
    if (!read)
        return Refused{read.error()};
    return frame;
}

}  // namespace planewright
