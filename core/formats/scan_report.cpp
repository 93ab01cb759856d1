// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/scan_report.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>

#include "core/formats/number_text.h"
#include "core/formats/plane_cells.h"
#include "core/formats/room_drawings.h"
#include "core/formats/svg_drawing.h"
#include "core/formats/written.h"
#include "core/geometry/axis_strength.h"
#include "core/geometry/plane_angles.h"
#include "core/params/registry.h"
#include "core/types/angle.h"
#include "core/types/angle_text.h"
#include "core/types/plane_words.h"

namespace planewright {

namespace {

constexpr double kDrawingWidth = 520.0;        // [px]
constexpr std::size_t kMostLeftSegments = 20;  // that are listed

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --text: #1b1f23; --paper: #ffffff; --quiet: #57606a; --rule: #d0d7de; --head: #f3f5f7;
  --floor: #8c6d1f; --ceiling: #6f42c1; --wall: #1f6feb; --other: #2f7d4f; --scanner: #c62828; }
@media (prefers-color-scheme: dark) { :root { --text: #e6edf3; --paper: #14181d; --quiet: #9aa5b1; --rule: #3a434d;
  --head: #1e242b; --floor: #d9b657; --ceiling: #b392f0; --wall: #6cb0ff; --other: #6fcf97; --scanner: #ff7b72; } }
@media print { :root { --text: #000000; --paper: #ffffff; --quiet: #444444; --rule: #bbbbbb; --head: #eeeeee; } }
body { font: 15px/1.45 system-ui, "DejaVu Sans", sans-serif; color: var(--text); background: var(--paper);
  max-width: 1200px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.6em; margin: 0; } h2 { font-size: 1.2em; margin: 1.8em 0 .5em; }
.quiet { color: var(--quiet); }
dl.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: .6em; margin: 1.2em 0; }
dl.facts div { border: 1px solid var(--rule); border-radius: 6px; padding: .5em .8em; }
dl.facts dt { color: var(--quiet); font-size: .85em; } dl.facts dd { margin: 0; font-size: 1.25em; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .85em; }
th, td { border-bottom: 1px solid var(--rule); padding: .2em .45em; text-align: right; white-space: nowrap; }
th { background: var(--head); } td.word, th.word { text-align: left; white-space: normal; }
@media print { body { max-width: none; margin: 0; font-size: 11px; } .wide { overflow: visible; } @page { size: A4; margin: 12mm; } }
.wide { overflow-x: auto; }
.figures { display: flex; flex-wrap: wrap; gap: 1em; } figure { margin: 0; break-inside: avoid; }
figure svg, figure img { max-width: 100%; height: auto; border: 1px solid var(--rule); border-radius: 6px; }
figcaption { color: var(--quiet); font-size: .9em; }
svg .area { fill-opacity: .18; stroke-width: 1.2; } svg .edge { fill: none; stroke-width: 1.2; }
svg .cut { fill: none; stroke-width: 3; stroke-linecap: round; }
svg .floor { stroke: var(--floor); fill: var(--floor); } svg .ceiling { stroke: var(--ceiling); fill: var(--ceiling); }
svg .wall { stroke: var(--wall); fill: var(--wall); } svg .other { stroke: var(--other); fill: var(--other); }
svg .edge, svg .cut { fill: none; }
svg .grid { stroke: var(--rule); stroke-width: .6; } svg .bar { stroke: var(--text); stroke-width: 2.5; }
svg text { font: 12px system-ui, "DejaVu Sans", sans-serif; fill: var(--text); }
svg .label { paint-order: stroke; stroke: var(--paper); stroke-width: 3px; }
svg .scanner { fill: var(--scanner); }
.legend span { margin-right: 1.2em; } .legend i { display: inline-block; width: .9em; height: .9em; margin-right: .35em;
  vertical-align: -.1em; border-radius: 2px; }
)";

/// Builds the page.
class Page {
public:
    void open(std::string_view title)
    {
        text_ += "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
        text_ += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
                 markupText(title) + "</title>\n<style>" + std::string{kStyle} + "</style>\n</head>\n<body>\n";
    }
    void heading(std::string_view title) { text_ += "<h2>" + markupText(title) + "</h2>\n"; }
    void paragraph(std::string_view words, std::string_view style = {})
    {
        text_ += style.empty() ? "<p>" : "<p class=\"" + std::string{style} + "\">";
        text_ += markupText(words) + "</p>\n";
    }
    void raw(std::string_view markup) { text_ += markup; }

    struct Column {
        std::string_view title;
        bool isWord = false;
    };
    /// Columns without titles have no heading.
    void table(const std::vector<Column>& columns, const std::vector<std::vector<std::string>>& rows)
    {
        text_ += "<div class=\"wide\"><table>\n";
        if (!columns.front().title.empty()) {
            text_ += "<thead><tr>";
            for (const Column& column : columns)
                text_ +=
                    std::string{column.isWord ? "<th class=\"word\">" : "<th>"} + markupText(column.title) + "</th>";
            text_ += "</tr></thead>\n";
        }
        text_ += "<tbody>\n";
        for (const auto& row : rows) {
            text_ += "<tr>";
            for (std::size_t i = 0; i < row.size(); ++i)
                text_ += std::string{columns[i].isWord ? "<td class=\"word\">" : "<td>"} + markupText(row[i]) + "</td>";
            text_ += "</tr>\n";
        }
        text_ += "</tbody></table></div>\n";
    }
    void figure(std::string_view markup, std::string_view title)
    {
        text_ += "<figure>" + std::string{markup} + "<figcaption>" + markupText(title) + "</figcaption></figure>\n";
    }
    std::string close() &&
    {
        text_ += "</body>\n</html>\n";
        return std::move(text_);
    }

private:
    std::string text_;
};

std::string inDegrees(double angle, int digits)
{
    return fixedText(toDegrees(angle), digits);
}

std::string share(std::int64_t part, std::int64_t whole)
{
    return whole > 0 ? fixedText(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1) + " %" : "–";
}

/// How much of what could be seen was seen.
struct Coverage {
    std::int64_t beams = 0;
    std::int64_t returns = 0;
    std::int64_t onPlanes = 0;  ///< returns whose segment is on a plane
    int missing = 0;            ///< steps between the first and the last that have no slice
    int suspect = 0;            ///< slices of which no planes are made
    double lowest = std::numeric_limits<double>::infinity();    ///< pitch [rad]
    double highest = -std::numeric_limits<double>::infinity();  ///< pitch [rad]
};

Coverage coverageOf(const ReportedScan& scan)
{
    Coverage coverage;
    const ScanDescription& about = scan.recording.description;
    for (const ScanSlice& slice : scan.recording.slices) {
        coverage.beams += static_cast<std::int64_t>(slice.ranges.size());
        coverage.returns += std::count_if(slice.ranges.begin(), slice.ranges.end(), [&](double range) {
            return range > 0.0 && range >= about.rangeMin && range <= about.rangeMax;
        });
        coverage.suspect += slice.angleSuspect ? 1 : 0;
        coverage.lowest = std::min({coverage.lowest, slice.tilt, slice.tiltEnd.value_or(slice.tilt)});
        coverage.highest = std::max({coverage.highest, slice.tilt, slice.tiltEnd.value_or(slice.tilt)});
    }
    for (const PlaneResult& plane : scan.planes)
        coverage.onPlanes += plane.plane->points;
    if (!scan.recording.slices.empty())
        coverage.missing = scan.recording.slices.back().step - scan.recording.slices.front().step + 1 -
                           static_cast<int>(scan.recording.slices.size());
    return coverage;
}

/// Segments on no plane, the longest first.
std::vector<const LineSegment*> leftSegments(const ReportedScan& scan)
{
    std::vector<SegmentId> fitted;
    for (const PlaneResult& plane : scan.planes)
        fitted.insert(fitted.end(), plane.plane->segments.begin(), plane.plane->segments.end());
    std::sort(fitted.begin(), fitted.end());
    std::vector<const LineSegment*> left;
    const SegmentLog& log = scan.snapshot.segments;
    for (std::size_t slice = 0; slice < log.slices(); ++slice) {
        for (const LineSegment& segment : log.slice(slice)) {
            if (!std::binary_search(fitted.begin(), fitted.end(), segment.id))
                left.push_back(&segment);
        }
    }
    std::stable_sort(left.begin(), left.end(),
                     [](const LineSegment* a, const LineSegment* b) { return a->length() > b->length(); });
    return left;
}

void addFacts(Page& page, const ReportedScan& scan, const Coverage& coverage, std::size_t left)
{
    double area = 0.0;
    for (const PlaneResult& plane : scan.planes)
        area += plane.outline.area;
    const auto segments = scan.snapshot.segments.segmentCount();
    const auto fact = [&](std::string_view name, const std::string& value) {
        page.raw("<div><dt>" + markupText(name) + "</dt><dd>" + markupText(value) + "</dd></div>\n");
    };
    page.raw("<dl class=\"facts\">\n");
    fact("Planes", std::to_string(scan.planes.size()));
    fact("Area of planes", fixedText(area, 1) + " m²");
    const std::string steps = std::to_string(scan.recording.slices.size());
    fact("Slices", scan.plannedSteps > 0 ? steps + " of " + std::to_string(scan.plannedSteps) : steps);
    fact("Beams with a return", share(coverage.returns, coverage.beams));
    fact("Returns on planes", share(coverage.onPlanes, coverage.returns));
    fact("Segments on planes", share(static_cast<std::int64_t>(segments - left), static_cast<std::int64_t>(segments)));
    page.raw("</dl>\n");
}

void addCoverage(Page& page, const ReportedScan& scan, const Coverage& coverage)
{
    page.heading("Coverage");
    if (scan.recording.slices.empty()) {
        page.paragraph("The scan has no slices.");
        return;
    }
    const ScanDescription& about = scan.recording.description;
    page.table({{"", true}, {"", true}},
               {{"Scanner", about.scanner.empty() ? "unknown" : about.scanner},
                {"Pitch", inDegrees(coverage.lowest, 2) + "° to " + inDegrees(coverage.highest, 2) + "°"},
                {"Bearing", inDegrees(about.firstBearing, 2) + "° to " +
                                inDegrees(about.firstBearing + (about.beams - 1) * about.bearingStep, 2) + "° in " +
                                std::to_string(about.beams) + " beams of " + inDegrees(about.bearingStep, 3) + "°"},
                {"Range that counts", formatNumber(about.rangeMin) + " m to " + formatNumber(about.rangeMax) + " m"},
                {"Beams", std::to_string(coverage.beams) + ", " + std::to_string(coverage.returns) + " with a return"},
                {"Steps without a slice", std::to_string(coverage.missing)},
                {"Slices of doubtful angle", std::to_string(coverage.suspect)}});
}

void addDrawings(Page& page, const ReportedScan& scan)
{
    page.heading("Plan and elevations");
    if (scan.planes.empty()) {
        page.paragraph("There are no planes to draw.");
        return;
    }
    page.raw(
        "<p class=\"legend\"><span><i style=\"background:var(--floor)\"></i>floor</span>"
        "<span><i style=\"background:var(--ceiling)\"></i>ceiling</span>"
        "<span><i style=\"background:var(--wall)\"></i>wall</span>"
        "<span><i style=\"background:var(--other)\"></i>other</span>"
        "<span><i style=\"background:var(--scanner);border-radius:50%\"></i>scanner</span></p>\n");
    page.raw("<div class=\"figures\">\n");
    for (const RoomDrawing& drawing : roomDrawings(scan.planes, scan.cutHeight, kDrawingWidth)) {
        const bool isPlan = drawing.title == "Plan";
        page.figure(drawing.svg, isPlan ? "Plan, cut at z = " + fixedText(scan.cutHeight, 2) + " m"
                                        : drawing.title + ", as seen from the scanner");
    }
    page.raw("</div>\n");
}

void addPictures(Page& page, const ReportedScan& scan)
{
    if (scan.pictures.empty())
        return;
    page.heading("Pictures");
    page.raw("<div class=\"figures\">\n");
    for (const ReportPicture& picture : scan.pictures)
        page.figure("<img alt=\"" + markupText(picture.title) + "\" src=\"data:image/png;base64," +
                        markupText(picture.pngBase64) + "\">",
                    picture.title);
    page.raw("</div>\n");
}

void addPlanes(Page& page, const ReportedScan& scan)
{
    page.heading("Planes");
    if (scan.planes.empty()) {
        page.paragraph("No plane was found.");
        return;
    }
    std::vector<std::vector<std::string>> rows;
    double errors = 0.0;
    for (const PlaneResult& result : scan.planes) {
        const Plane& plane = *result.plane;
        errors += plane.fittingError;
        const auto heading = planeHeading(plane.normal);
        const bool isHonest = hasCovariance(plane);
        rows.push_back({planeLabel(plane.id), result.name, result.className, fixedText(plane.normal.x(), 4),
                        fixedText(plane.normal.y(), 4), fixedText(plane.normal.z(), 4), fixedText(plane.distance, 3),
                        heading ? inDegrees(*heading, 1) : "", inDegrees(planeTilt(plane.normal), 1),
                        fixedText(result.outline.area, 2),
                        fixedText(result.outline.width, 2) + " × " + fixedText(result.outline.height, 2),
                        std::to_string(plane.segments.size()), std::to_string(plane.points),
                        fixedText(plane.fittingError, 2), fixedText(1000.0 * plane.rms, 1),
                        isHonest ? inDegrees(normalSigma(plane.covariance), 3) : "",
                        isHonest ? fixedText(1000.0 * std::sqrt(plane.covariance(2, 2)), 2) : ""});
    }
    page.table({{"Plane", true},
                {"Name", true},
                {"Class", true},
                {"nx"},
                {"ny"},
                {"nz"},
                {"d [m]"},
                {"heading [°]"},
                {"tilt [°]"},
                {"area [m²]"},
                {"W × H [m]"},
                {"segments"},
                {"points"},
                {"E"},
                {"RMS [mm]"},
                {"σ normal [°]"},
                {"σ d [mm]"}},
               rows);
    page.paragraph(
        "n·p = d in the scanner's frame: x right, y forward, z up. E is the mean squared Mahalanobis "
        "distance of the end points; its mean is " +
            fixedText(errors / static_cast<double>(scan.planes.size()), 2) +
            ". σ normal is the larger of both directions.",
        "quiet");
}

void addStrength(Page& page, const ReportedScan& scan)
{
    page.heading("How well the planes fix the scanner's place");
    std::vector<std::shared_ptr<const Plane>> planes;
    for (const PlaneResult& plane : scan.planes)
        planes.push_back(plane.plane);
    const AxisStrength strength = axisStrength(planes);
    if (strength.information.isZero(0.0)) {
        page.paragraph("The planes have no covariance, as in the preset paper: nothing is known.");
        return;
    }
    std::vector<std::vector<std::string>> rows;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& sigma = strength.sigma[axis];
        const auto at = static_cast<Eigen::Index>(axis);
        rows.push_back({std::string{"xyz"[axis]}, sigma ? fixedText(1000.0 * *sigma, 2) : "not fixed",
                        fixedText(std::sqrt(strength.information(at, at)), 0)});
    }
    page.table({{"Direction", true}, {"σ [mm]"}, {"planes across it alone [1/m]"}}, rows);
    const Eigen::Vector3d& weakest = strength.weakest;
    page.paragraph("Worst along (" + fixedText(weakest.x(), 2) + ", " + fixedText(weakest.y(), 2) + ", " +
                   fixedText(weakest.z(), 2) + "): " +
                   (strength.weakestSigma ? fixedText(1000.0 * *strength.weakestSigma, 2) + " mm."
                                          : "no plane tells, a shift of the scanner along it changes nothing."));
}

void addLeft(Page& page, const std::vector<const LineSegment*>& left)
{
    page.heading("Segments on no plane");
    if (left.empty()) {
        page.paragraph("Every segment is on a plane.");
        return;
    }
    double length = 0.0;
    for (const LineSegment* segment : left)
        length += segment->length();
    page.paragraph(std::to_string(left.size()) + (left.size() == 1 ? " segment, " : " segments, ") +
                   fixedText(length, 1) + " m together" + (left.size() > kMostLeftSegments ? "; the longest:" : ":"));
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < std::min(left.size(), kMostLeftSegments); ++i) {
        const LineSegment& segment = *left[i];
        const Eigen::Vector3d middle = segment.midpoint();
        rows.push_back({segmentLabel(segment.id), fixedText(segment.length(), 2), std::to_string(segment.points),
                        fixedText(middle.x(), 2), fixedText(middle.y(), 2), fixedText(middle.z(), 2)});
    }
    page.table({{"Segment", true}, {"length [m]"}, {"points"}, {"x [m]"}, {"y [m]"}, {"z [m]"}}, rows);
}

void addParameters(Page& page, const ReportedScan& scan)
{
    page.heading("Parameters");
    std::vector<std::vector<std::string>> rows;
    for (const ParameterRow& row : parameterRows())
        rows.push_back({std::string{row.key}, printParameter(scan.parameters, row.key), std::string{row.unitName},
                        std::string{row.meaning}});
    page.raw("<details><summary>All parameters in force at the end</summary>\n");
    page.table({{"key", true}, {"value"}, {"unit", true}, {"meaning", true}}, rows);
    page.raw("</details>\n");
    const SensorNoise& noise = scan.snapshot.noise;
    page.paragraph("Noise that the planes were estimated with" +
                   std::string{noise.estimated ? ", found in the scan: " : ", as told: "} + "range " +
                   fixedText(1000.0 * noise.rangeConstant, 1) + " mm and " +
                   fixedText(1000.0 * noise.rangeProportional, 2) + " mm a metre, pitch " + inDegrees(noise.pitch, 3) +
                   "° a slice.");
}

}  // namespace

Result<void> writeScanReport(std::ostream& out, const ReportedScan& scan)
{
    const Coverage coverage = coverageOf(scan);
    const std::vector<const LineSegment*> left = leftSegments(scan);
    Page page;
    page.open(scan.title);
    page.raw("<h1>" + markupText(scan.title) + "</h1>\n");
    page.paragraph("Scan report by " + scan.program, "quiet");
    addFacts(page, scan, coverage, left.size());
    addDrawings(page, scan);
    addPictures(page, scan);
    addPlanes(page, scan);
    addStrength(page, scan);
    addLeft(page, left);
    addCoverage(page, scan, coverage);
    addParameters(page, scan);
    const std::string text = std::move(page).close();
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    return written(out);
}

}  // namespace planewright
