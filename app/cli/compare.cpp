// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/json_text.h"
#include "app/cli/number_option.h"
#include "app/cli/planes_file.h"
#include "app/cli/text.h"
#include "app/files/input_file.h"
#include "core/evaluation/compare_labels.h"
#include "core/evaluation/compare_planes.h"
#include "core/formats/labels.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

struct CompareOptions {
    std::string a, b;
    std::vector<std::string> labels;
    double angle = 5.0;     ///< [deg]
    double distance = 0.1;  ///< [m]
    LabelMatchSettings byLabels;
    bool json = false;
    int failAbove = -1;  ///< no gate
};

/// What a comparison found, for people and programs, and what its gate counts.
struct Outcome {
    Json facts;
    std::size_t unmatched = 0;
};

Json factsOf(const ErrorSummary& errors, double scale)
{
    return {{"mean", rounded(scale * errors.mean)},
            {"median", rounded(scale * errors.median)},
            {"max", rounded(scale * errors.max)}};
}

void addErrors(Json& facts, const PlaneErrors& errors)
{
    facts["angle_error_deg"] = factsOf(errors.angle, toDegrees(1.0));
    facts["distance_error_m"] = factsOf(errors.distance, 1.0);
}

std::vector<ComparedPlane> compared(const std::vector<PlaneRecord>& records)
{
    std::vector<ComparedPlane> planes;
    planes.reserve(records.size());
    for (const PlaneRecord& record : records)
        planes.push_back({record.id, record.normal, record.distance});
    return planes;
}

Result<Outcome> compareByParameters(const CompareOptions& options, const std::vector<PlaneRecord>& a,
                                    std::vector<PlaneRecord> b)
{
    std::erase_if(
        b, [&](const PlaneRecord& plane) { return plane.points && *plane.points < options.byLabels.minReturns; });
    const auto comparison = comparePlanes(compared(a), compared(b), {degrees(options.angle), options.distance});
    if (!comparison)
        return tl::unexpected{comparison.error()};
    Outcome outcome{{{"matched", comparison->matches.size()},
                     {"unmatched_a", comparison->unmatchedA.size()},
                     {"unmatched_b", comparison->unmatchedB.size()}},
                    comparison->unmatchedB.size()};
    addErrors(outcome.facts, comparison->errors);
    Json matches = Json::array();
    for (const PlaneMatch& match : comparison->matches)
        matches.push_back({{"a", match.a},
                           {"b", match.b},
                           {"angle_deg", rounded(toDegrees(match.difference.angle))},
                           {"distance_m", rounded(match.difference.distance)}});
    outcome.facts["matches"] = std::move(matches);
    outcome.facts["unmatched_a_planes"] = comparison->unmatchedA;
    outcome.facts["unmatched_b_planes"] = comparison->unmatchedB;
    return outcome;
}

Result<Labels> labelsFrom(const std::string& path)
{
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    return readLabels(**input, path);
}

Result<Outcome> compareByLabels(const CompareOptions& options, const std::vector<PlaneRecord>& a,
                                const std::vector<PlaneRecord>& b)
{
    const Result<Labels> labelsA = labelsFrom(options.labels[0]);
    if (!labelsA)
        return tl::unexpected{labelsA.error()};
    const Result<Labels> labelsB = labelsFrom(options.labels[1]);
    if (!labelsB)
        return tl::unexpected{labelsB.error()};
    const auto comparison = compareLabels(*labelsA, *labelsB, compared(a), compared(b), options.byLabels);
    if (!comparison)
        return fail(comparison.error().code,
                    options.labels[0] + ", " + options.labels[1] + ": " + comparison.error().message);
    Outcome outcome{{{"regions", comparison->regions},
                     {"groups", comparison->groups},
                     {"correct", comparison->correct.size()},
                     {"over_segmented", comparison->overSegmented.size()},
                     {"under_segmented", comparison->underSegmented.size()},
                     {"missed", comparison->missed.size()},
                     {"noise", comparison->noise.size()},
                     {"ignored", comparison->ignored.size()},
                     {"recall", rounded(comparison->recall)},
                     {"precision", rounded(comparison->precision)},
                     {"f1", rounded(comparison->f1)}},
                    comparison->groups - comparison->correct.size()};
    addErrors(outcome.facts, comparison->errors);
    Json matches = Json::array();
    for (const RegionMatch& match : comparison->correct)
        matches.push_back({{"a", match.a}, {"b", match.b}, {"common", match.common}});
    Json over = Json::array();
    for (const OverSegmentation& instance : comparison->overSegmented)
        over.push_back({{"a", instance.a}, {"b", instance.b}});
    Json under = Json::array();
    for (const UnderSegmentation& instance : comparison->underSegmented)
        under.push_back({{"a", instance.a}, {"b", instance.b}});
    outcome.facts["matches"] = std::move(matches);
    outcome.facts["over_segmented_planes"] = std::move(over);
    outcome.facts["under_segmented_planes"] = std::move(under);
    outcome.facts["missed_planes"] = comparison->missed;
    outcome.facts["noise_planes"] = comparison->noise;
    outcome.facts["ignored_planes"] = comparison->ignored;
    return outcome;
}

/// A line a fact, under the keys of the JSON; of the lists only those that name planes to look at.
std::string asText(const Json& facts)
{
    std::string text;
    for (const auto& [key, value] : facts.items()) {
        if (value.is_array() && (value.empty() || key == "matches"))
            continue;
        text += key + std::string(24 - key.size(), ' ');
        if (value.is_object()) {
            for (const auto& [part, number] : value.items())
                text += part + " " + valueText(number) + "  ";
            text.erase(text.find_last_not_of(' ') + 1);
        } else {
            text += valueText(value);
        }
        text += "\n";
    }
    return text;
}

Result<ExitCode> compare(const CompareOptions& options)
{
    const auto a = readPlanesFile(options.a);
    if (!a)
        return tl::unexpected{a.error()};
    const auto b = readPlanesFile(options.b);
    if (!b)
        return tl::unexpected{b.error()};
    const Result<Outcome> outcome =
        options.labels.empty() ? compareByParameters(options, *a, *b) : compareByLabels(options, *a, *b);
    if (!outcome)
        return tl::unexpected{outcome.error()};
    if (const auto printed = print(options.json ? jsonText(outcome->facts) : asText(outcome->facts)); !printed)
        return tl::unexpected{printed.error()};
    if (options.failAbove >= 0 && outcome->unmatched > static_cast<std::size_t>(options.failAbove))
        return fail(ErrorCode::GateFailed, options.b + ": " + std::to_string(outcome->unmatched) +
                                               " planes have no match in " + options.a + ", --fail-above allows " +
                                               std::to_string(options.failAbove));
    return ExitCode::Done;
}

}  // namespace

void addCompareCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand("compare", "two results; B is the truth or the other run");
    auto options = std::make_shared<CompareOptions>();
    command.add_option("A", options->a, "planes (.csv or .json)")->required();
    command.add_option("B", options->b, "planes (.csv or .json)")->required();
    CLI::Option* labels =
        command.add_option("--labels", options->labels, "compare by labels: the labels of A and of B")
            ->type_name("LA LB")
            ->expected(2);
    CLI::Option* angle = addNumber(command, "--angle", options->angle, 0.0, 90.0,
                                   "largest angle between two planes that match, in degrees (default 5)");
    CLI::Option* distance = addNumber(command, "--distance", options->distance, 0.0, 1e6,
                                      "largest difference of their distances, in metres (default 0.1)");
    CLI::Option* overlap = addNumber(command, "--overlap", options->byLabels.overlap, 0.01, 1.0,
                                     "share of both regions that a match has in common (default 0.5)");
    addWholeNumber(command, "--min-returns", options->byLabels.minReturns, std::int64_t{0},
                   std::numeric_limits<std::int64_t>::max(),
                   "planes of B with fewer returns count neither for nor against A (default 0)");
    command.add_flag("--json", options->json, "as JSON");
    addWholeNumber(command, "--fail-above", options->failAbove, 0, std::numeric_limits<int>::max(),
                   "exit with 8 if more planes of B than this have no match");
    overlap->needs(labels);
    angle->excludes(labels);
    distance->excludes(labels);
    command.callback([options, &chosen] { chosen = [options] { return compare(*options); }; });
}

}  // namespace planewright
