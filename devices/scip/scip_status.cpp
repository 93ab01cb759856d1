// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_status.h"

#include <algorithm>
#include <array>

#include "devices/scip/scip_request.h"

namespace planewright {

namespace {

enum class Of { Any, Only2_0, Only2_2 };

/// One status, of some commands: their names one behind the other with blanks between, or all where there are none.
struct Row {
    std::string_view commands;
    std::string_view from;
    std::string_view to;  ///< the last of a range of numbers
    Of version;
    ScipVerdict verdict;
    std::string_view text;
};

constexpr std::string_view kStreams = "MD MS ME ND NE";
constexpr std::string_view kLatest = "GD GS GE HD HE";
constexpr std::string_view kMeasuring = "MD MS ME ND NE GD GS GE HD HE";

// The first row that fits is meant. Letters of SCIP 2.0: its specification; of 2.2: what drivers of such lasers expect.
constexpr auto kRows = std::to_array<Row>({
    {"", "00", "00", Of::Any, ScipVerdict::Good, "done"},
    {kStreams, "99", "99", Of::Any, ScipVerdict::Good, "data"},
    {"SCIP2.0", "0", "0", Of::Any, ScipVerdict::Good, "done"},

    {"BM", "01", "01", Of::Any, ScipVerdict::Malfunction, "the laser cannot be switched on: it is faulty"},
    {"BM", "02", "02", Of::Any, ScipVerdict::AlreadySo, "the laser is on already"},
    {"RB", "01", "01", Of::Any, ScipVerdict::Good, "asked once: asked again within a second, it starts anew"},
    {"TM", "01", "01", Of::Any, ScipVerdict::Refused, "wrong number of a time command"},
    {"TM", "02", "02", Of::Any, ScipVerdict::AlreadySo, "time mode is on already"},
    {"TM", "03", "03", Of::Any, ScipVerdict::AlreadySo, "time mode is off already"},
    {"TM", "04", "04", Of::Any, ScipVerdict::Refused, "asked for the time outside time mode"},
    {"SS CR HS", "01", "01", Of::Any, ScipVerdict::Refused, "not a number"},
    {"SS CR", "02", "02", Of::Any, ScipVerdict::Refused, "a value that it cannot have"},
    {"HS", "02", "02", Of::Any, ScipVerdict::AlreadySo, "it has that sensitivity already"},
    {"SS CR", "03", "03", Of::Any, ScipVerdict::AlreadySo, "it has that speed already"},
    {"HS", "03", "03", Of::Any, ScipVerdict::Refused, "this model cannot do that"},
    {"SS CR", "04", "04", Of::Any, ScipVerdict::Refused, "this model cannot do that"},

    {kMeasuring, "01", "01", Of::Any, ScipVerdict::Refused, "the first step is not a number"},
    {kMeasuring, "02", "02", Of::Any, ScipVerdict::Refused, "the last step is not a number"},
    {kMeasuring, "03", "03", Of::Any, ScipVerdict::Refused, "the cluster is not a number"},
    {kMeasuring, "04", "04", Of::Any, ScipVerdict::Refused, "the last step is beyond the laser's"},
    {kMeasuring, "05", "05", Of::Any, ScipVerdict::Refused, "the last step comes before the first"},
    {kStreams, "06", "06", Of::Any, ScipVerdict::Refused, "the interval is not a number"},
    {kStreams, "07", "07", Of::Any, ScipVerdict::Refused, "the count is not a number"},
    {kLatest, "10", "10", Of::Any, ScipVerdict::Refused, "the laser is off"},
    {kStreams, "21", "49", Of::Any, ScipVerdict::Verifying, "scanning pauses while the laser checks an error"},
    {kMeasuring, "50", "97", Of::Any, ScipVerdict::Malfunction, "the laser reports a fault of its hardware"},
    {kMeasuring, "98", "98", Of::Any, ScipVerdict::Resumed, "scanning goes on after the laser has checked itself"},

    {"", "0L", "0L", Of::Any, ScipVerdict::Malfunction, "the laser is in an abnormal state"},
    {"", "0M", "0M", Of::Any, ScipVerdict::NotNow, "the laser is not stable yet"},
    {"", "10", "10", Of::Any, ScipVerdict::NotNow, "not in this state"},
    {"", "0A", "0A", Of::Any, ScipVerdict::NotNow, "the laser cannot build its reply"},
    {"", "0B", "0B", Of::Any, ScipVerdict::NotNow, "no room for the reply, or asked twice"},
    {"", "0C", "0C", Of::Any, ScipVerdict::Refused, "the request is too short"},
    {"", "0D", "0D", Of::Only2_0, ScipVerdict::Refused, "unknown request"},
    {"", "0D", "0D", Of::Only2_2, ScipVerdict::Refused, "the request is too long"},
    {"", "0E", "0E", Of::Any, ScipVerdict::Refused, "unknown request"},
    {"", "0F", "0F", Of::Only2_0, ScipVerdict::Refused, "the request is too short"},
    {"", "0F", "0F", Of::Only2_2, ScipVerdict::Refused, "this model cannot do that"},
    {"", "0G", "0G", Of::Any, ScipVerdict::Refused, "the tag is too long"},
    {"", "0H", "0H", Of::Only2_0, ScipVerdict::Refused, "the tag has a letter that it cannot have"},
    {"", "0H", "0H", Of::Only2_2, ScipVerdict::Refused, "the request is too short"},
    {"", "0I", "0I", Of::Only2_0, ScipVerdict::NotNow, "the laser is being given new firmware"},
    {"", "E", "E", Of::Any, ScipVerdict::Refused, "unknown request (SCIP 1.1)"},
});

bool fits(const Row& row, std::string_view command, std::string_view status, ScipVersion version)
{
    // No name of a command is part of another, or of two with the blank between.
    if (!row.commands.empty() && (command.empty() || row.commands.find(command) == std::string_view::npos))
        return false;
    if (row.version != Of::Any && (row.version == Of::Only2_0) != (version == ScipVersion::V2_0))
        return false;
    if (row.from == row.to)
        return status == row.from;
    const bool isNumber = std::all_of(status.begin(), status.end(), [](char c) { return c >= '0' && c <= '9'; });
    return isNumber && status.size() == row.from.size() && status >= row.from && status <= row.to;
}

}  // namespace

ScipVersion scipVersionOf(std::string_view protocol)
{
    return protocol.find("2.2") != std::string_view::npos ? ScipVersion::V2_2 : ScipVersion::V2_0;
}

ScipMeaning scipMeaning(std::string_view command, std::string_view status, ScipVersion version)
{
    const auto* const row =
        std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) { return fits(r, command, status, version); });
    if (row == kRows.end())
        return {ScipVerdict::Refused, "no meaning is known"};
    return {row->verdict, row->text};
}

std::string describeScipStatus(std::string_view command, std::string_view status, ScipVersion version)
{
    return "status " + std::string{status} + ": " + std::string{scipMeaning(command, status, version).text};
}

}  // namespace planewright
