// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_laser_scan.h"

#include <algorithm>
#include <cmath>

#include "devices/scip/scip_encoding.h"

namespace planewright {

namespace {

constexpr std::uint32_t kMostInTwoCharacters = 4095;
constexpr std::uint32_t kMostInThreeCharacters = (1U << 18U) - 1;

std::string withSum(std::string text)
{
    text += scipSum(text);
    return text;
}

bool isRange(std::uint32_t code, const EmulatedLaserModel& model)
{
    return code >= static_cast<std::uint32_t>(model.nearest) && code <= static_cast<std::uint32_t>(model.farthest);
}

/// The nearest range of beams that share a value; the first code where none of them has one.
std::uint32_t sharedValue(const std::uint32_t* begin, const std::uint32_t* end, const EmulatedLaserModel& model)
{
    std::uint32_t least = *begin;
    for (const std::uint32_t* code = begin; code != end; ++code) {
        if (isRange(*code, model) && (!isRange(least, model) || *code < least))
            least = *code;
    }
    return least;
}

/// Less comes back from afar; a real one depends on colour and angle too.
std::uint32_t intensityOf(std::uint32_t code, const EmulatedLaserModel& model)
{
    if (!isRange(code, model))
        return 0;
    return static_cast<std::uint32_t>(std::lround(16'000.0 / (1.0 + code / 3'000.0)));
}

}  // namespace

std::string laserReply(std::string_view echo, std::string_view status, const std::vector<std::string>& lines)
{
    std::string reply = std::string{echo} + '\n' + withSum(std::string{status}) + '\n';
    for (const std::string& line : lines)
        reply += line + '\n';
    return reply + '\n';
}

std::string laserField(std::string_view key, std::string_view value)
{
    const std::string text = std::string{key} + ':' + std::string{value};
    return text + ';' + scipSum(text);
}

std::uint32_t laserCode(std::uint32_t millimetres, const EmulatedLaserModel& model)
{
    return isRange(millimetres, model) ? millimetres : model.noReturn;
}

std::string laserScan(std::string_view echo, std::string_view status, const ScipMeasurement& measurement,
                      std::uint32_t stamp, const std::vector<std::uint32_t>& beams, const EmulatedLaserModel& model)
{
    const auto cluster = static_cast<std::size_t>(std::max(1, measurement.cluster));
    std::string payload;
    for (std::size_t beam = 0; beam < beams.size(); beam += cluster) {
        const std::size_t end = std::min(beam + cluster, beams.size());
        const std::uint32_t code = sharedValue(beams.data() + beam, beams.data() + end, model);
        const bool isShort = measurement.charactersPerRange() == 2;
        payload += toScip(std::min(code, isShort ? kMostInTwoCharacters : kMostInThreeCharacters), isShort ? 2 : 3);
        if (measurement.hasIntensity())
            payload += toScip(intensityOf(code, model), 3);
    }
    return std::string{echo} + '\n' + withSum(std::string{status}) + '\n' + withSum(toScip(stamp, 4)) + '\n' +
           toScipBlock(payload) + '\n';
}

std::size_t laserScanSize(const ScipMeasurement& measurement, std::size_t echo)
{
    const int characters = measurement.charactersPerRange() + (measurement.hasIntensity() ? 3 : 0);
    const std::size_t payload = static_cast<std::size_t>(measurement.values()) * static_cast<std::size_t>(characters);
    const std::size_t lines = (payload + kScipLineLength - 1) / kScipLineLength;
    return echo + 1 + 4 + 6 + payload + 2 * lines + 1;
}

}  // namespace planewright
