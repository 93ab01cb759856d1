// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/scan_report.h"

#include <sstream>

#include <QtTest>

#include "tests/core/formats/sample_planes.h"
#include "tests/core/formats/sample_scan.h"
#include "tests/test_program.h"

namespace planewright {

class ScanReportTest : public QObject {
    Q_OBJECT

private slots:
    void itTellsWhatTheScanHas();
    void hostileNamesAreOnlyText();
    void anEmptyScanHasAPage();
    void picturesAreInThePage();
};

namespace {

std::string pageOf(const ReportedScan& scan)
{
    std::ostringstream out;
    return writeScanReport(out, scan) ? out.str() : std::string{};
}

bool has(const std::string& page, std::string_view part)
{
    return page.find(part) != std::string::npos;
}

}  // namespace

/// Of ten beams eight have a return that counts; 67 points and three of five segments are on planes.
void ScanReportTest::itTellsWhatTheScanHas()
{
    const Recording recording = sampleScan();
    const Snapshot snapshot = sampleSnapshot();
    std::vector<PlaneResult> planes{sampleCeiling(), sampleWall()};
    auto held = std::make_shared<Plane>(*planes[0].plane);
    held->segments = {{4, 0}, {7, 1}, {8, 0}};
    held->points = 6;
    planes[0].plane = held;
    auto wall = std::make_shared<Plane>(*planes[1].plane);
    wall->segments = {};
    wall->points = 0;
    planes[1].plane = wall;

    const std::string page = pageOf({"desk", "planewright 0", recording, snapshot, planes, {}, 9, 0.5});

    QVERIFY(has(page, "<dt>Planes</dt><dd>2</dd>"));
    QVERIFY(has(page, "<dt>Area of planes</dt><dd>12.0 m²</dd>"));
    QVERIFY(has(page, "<dt>Slices</dt><dd>2 of 9</dd>"));
    QVERIFY(has(page, "<dt>Beams with a return</dt><dd>80.0 %</dd>"));
    QVERIFY(has(page, "<dt>Returns on planes</dt><dd>75.0 %</dd>"));   // 6 of 8
    QVERIFY(has(page, "<dt>Segments on planes</dt><dd>75.0 %</dd>"));  // 3 of 4
    QVERIFY(has(page, ">Steps without a slice</td><td class=\"word\">2<"));
    QVERIFY(has(page, ">P03</td><td class=\"word\">Ceiling, &quot;left&quot;</td><td class=\"word\">ceiling</td>"));
    QVERIFY(has(page, "<td>0.500</td><td>2.00</td>"));  // the ceiling's sigmas: 0.5° and 2 mm
    QVERIFY(has(page, "1 segment, 1.9 m together:"));   // √((11/6)² + 0.25²)
    QVERIFY(has(page, "<td class=\"word\">8.0</td><td>1.85</td><td>2</td>"));
    // Only the ceiling has a covariance: nothing fixes x and y.
    QVERIFY(has(page, "<td class=\"word\">x</td><td>not fixed</td><td>0</td>"));
    QVERIFY(has(page, "<td class=\"word\">z</td><td>2.00</td><td>500</td>"));
}

void ScanReportTest::hostileNamesAreOnlyText()
{
    const Recording recording = sampleScan();
    const Snapshot snapshot = sampleSnapshot();
    std::vector<PlaneResult> planes{sampleWall()};
    planes[0].name = "</svg><script>alert(1)</script>";
    planes[0].className = "\" onload=\"alert(1)";

    const std::string page = pageOf({"<img src=x>", "p", recording, snapshot, planes, {}});

    QVERIFY(!page.empty());
    QVERIFY(!has(page, "<script"));
    QVERIFY(!has(page, "<img"));
    QVERIFY(!has(page, "onload=\""));
}

void ScanReportTest::anEmptyScanHasAPage()
{
    const std::string page = pageOf({"nothing", "p", Recording{}, Snapshot{}, {}, {}});

    QVERIFY(has(page, "No plane was found."));
    QVERIFY(has(page, "The scan has no slices."));
    QVERIFY(has(page, "<dt>Beams with a return</dt><dd>–</dd>"));
}

void ScanReportTest::picturesAreInThePage()
{
    const Recording recording = sampleScan();
    const Snapshot snapshot = sampleSnapshot();

    const std::string page = pageOf({"a", "p", recording, snapshot, {}, {}, 0, 0.0, {{"Iso", "aGVsbG8="}}});

    QVERIFY(has(page, "<img alt=\"Iso\" src=\"data:image/png;base64,aGVsbG8=\">"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScanReportTest)
#include "scan_report_test.moc"
