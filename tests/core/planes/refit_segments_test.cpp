// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/refit_segments.h"

#include <QTest>

#include "core/params/presets.h"
#include "core/planes/segment_slices.h"
#include "core/types/angle.h"
#include "tests/core/pipeline/simulated_room.h"
#include "tests/test_program.h"

using namespace planewright;

/// By both methods, on the twelve planes with default noise: a plane's own segments tell it again.
class RefitSegmentsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase_data();
    void initTestCase();
    void theSegmentsOfAPlaneGiveItBack();
    void theOrderOfSegmentsDoesNotMatter();
    void twoPlanesTakenForOneAreFoundAgain();
    void onePlaneIsFoundAsOne();
    void oneSegmentIsNoPlane();
    void segmentsThatAreNotThereArePassedOver();
    void thePitchOfASliceComesFromItsSegments();

private:
    struct Found {
        Parameters parameters;
        std::shared_ptr<const Snapshot> snapshot;
        Refit refit() const { return {*snapshot, description, parameters}; }
        ScanDescription description;
    };
    Found found() const { return found_.at(globalPreset()); }
    static std::string globalPreset()
    {
        QFETCH_GLOBAL(QString, preset);
        return preset.toStdString();
    }

    SimulatedRoom room_;
    std::map<std::string, Found> found_;
};

namespace {

double angleBetween(const Plane& a, const Plane& b)
{
    return std::acos(std::min(1.0, std::abs(a.normal.dot(b.normal))));
}

}  // namespace

void RefitSegmentsTest::initTestCase_data()
{
    QTest::addColumn<QString>("preset");
    QTest::newRow("precise") << "precise";
    QTest::newRow("paper") << "paper";
}

void RefitSegmentsTest::initTestCase()
{
    room_ = scanOf("twelve", "default", 5);
    for (const char* preset : {"precise", "paper"}) {
        Found found;
        apply(*findPreset(methodPresets(), preset), found.parameters);
        found.snapshot = extracted(room_.scan.recording, found.parameters);
        found.description = room_.scan.recording.description;
        QVERIFY(found.snapshot->planes.size() >= 10);
        found_.emplace(preset, std::move(found));
    }
}

void RefitSegmentsTest::theSegmentsOfAPlaneGiveItBack()
{
    const Found f = found();
    for (const auto& plane : f.snapshot->planes) {
        const auto again = refitPlane(plane->segments, f.refit());

        QVERIFY(again);
        // Both end where the likelihood is greatest, from different sides: what is between is a hundredth of a sigma.
        QVERIFY2(angleBetween(*again, *plane) < 0.02 * std::sqrt(plane->covariance.topLeftCorner<2, 2>().trace()),
                 qPrintable(QString("plane %1 by %2").arg(plane->id).arg(angleBetween(*again, *plane))));
        QVERIFY(std::abs(again->distance - plane->distance) < 0.02 * std::sqrt(plane->covariance(2, 2)));
        QVERIFY(std::abs(again->rms - plane->rms) < 1e-3 * plane->rms);
        QVERIFY(std::abs(again->fittingError - plane->fittingError) < 0.01 * plane->fittingError);
        QCOMPARE(again->points, plane->points);
        QCOMPARE(again->segments.size(), plane->segments.size());
        QVERIFY(again->segments.front() == plane->segments.front());
        QVERIFY(again->segments.back() == plane->segments.back());
    }
}

void RefitSegmentsTest::theOrderOfSegmentsDoesNotMatter()
{
    const Found f = found();
    const Plane& plane = *f.snapshot->planes.front();
    std::vector<SegmentId> turned(plane.segments.rbegin(), plane.segments.rend());

    const auto whole = refitPlane(plane.segments, f.refit());
    const auto fromBehind = refitPlane(turned, f.refit());

    QVERIFY(whole && fromBehind);
    QVERIFY(fromBehind->normal == whole->normal);
    QVERIFY(fromBehind->segments == whole->segments);
}

void RefitSegmentsTest::twoPlanesTakenForOneAreFoundAgain()
{
    const Found f = found();
    const Plane& first = *f.snapshot->planes[0];
    const auto other = std::find_if(f.snapshot->planes.begin() + 1, f.snapshot->planes.end(), [&](const auto& plane) {
        return std::abs(plane->normal.dot(first.normal)) < 0.1 && plane->segments.size() > 30;
    });
    QVERIFY(other != f.snapshot->planes.end());
    std::vector<SegmentId> both = first.segments;
    both.insert(both.end(), (*other)->segments.begin(), (*other)->segments.end());

    const std::vector<Plane> parts = searchPlanes(both, f.refit());

    QCOMPARE(parts.size(), std::size_t(2));
    QVERIFY(parts[0].points >= parts[1].points);
    for (const Plane* was : {&first, other->get()}) {
        const auto part = std::min_element(parts.begin(), parts.end(), [&](const Plane& a, const Plane& b) {
            return angleBetween(a, *was) < angleBetween(b, *was);
        });
        QVERIFY(angleBetween(*part, *was) < degrees(0.2));
        QVERIFY(std::abs(part->distance - was->distance) < 0.02);
        QVERIFY(10 * part->segments.size() > 9 * was->segments.size());
    }
}

void RefitSegmentsTest::onePlaneIsFoundAsOne()
{
    const Found f = found();

    const std::vector<Plane> parts = searchPlanes(f.snapshot->planes[1]->segments, f.refit());

    QCOMPARE(parts.size(), std::size_t(1));
    QVERIFY(angleBetween(parts[0], *f.snapshot->planes[1]) < degrees(0.1));
}

void RefitSegmentsTest::oneSegmentIsNoPlane()
{
    const Found f = found();
    const std::vector<SegmentId> one{f.snapshot->planes[0]->segments[0]};

    QVERIFY(!refitPlane(one, f.refit()));
    QVERIFY(!refitPlane({}, f.refit()));
    QVERIFY(searchPlanes(one, f.refit()).empty());
    QVERIFY(searchPlanes({}, f.refit()).empty());
}

void RefitSegmentsTest::segmentsThatAreNotThereArePassedOver()
{
    const Found f = found();
    std::vector<SegmentId> ids = f.snapshot->planes[0]->segments;
    const auto expected = refitPlane(ids, f.refit());
    ids.insert(ids.end(), {{-1, 0}, {0, -1}, {0, 100'000}, {100'000, 0}, ids.front()});

    const auto plane = refitPlane(ids, f.refit());

    QVERIFY(plane);
    QVERIFY(plane->segments == expected->segments);
    QVERIFY(plane->normal == expected->normal);
}

void RefitSegmentsTest::thePitchOfASliceComesFromItsSegments()
{
    const Found f = found();
    for (const double offset : {0.05, 0.0, -0.1}) {
        SimulatedRoom room{*makeScene("twelve", 5), {}};
        AcquisitionSettings settings;
        settings.pitchAxisOffset = offset;
        room.scan = simulate(room.scene, settings, *simulationNoise("none"), 5);
        const auto snapshot = extracted(room.scan.recording, f.parameters);
        std::vector<SegmentId> all;
        for (std::size_t place = 0; place < snapshot->segments.slices(); ++place) {
            for (const LineSegment& segment : snapshot->segments.slice(place))
                all.push_back(segment.id);
        }

        const SegmentSlices slices = slicesOf(all, snapshot->segments, room.scan.recording.description);

        QVERIFY(slices.size() > 100);
        for (const SegmentSlice& slice : slices) {
            const double tilt = room.scan.recording.slices[static_cast<std::size_t>(slice.step)].tilt;
            QVERIFY2(std::abs(slice.tilt - tilt) < 1e-9, qPrintable(QString::number(slice.tilt - tilt)));
        }
    }
}

PLANEWRIGHT_TEST(RefitSegmentsTest)
#include "refit_segments_test.moc"
